"""Compression ratios of slaves and firing intervals that are hardly meant: computed with all the same, and flagged."""

from collections.abc import Iterator, Sequence

import numpy as np

from cranktrain.language import N_, Words, _
from cranktrain.layout.frames import Frames
from cranktrain.layout.mechanisms import Pistons
from cranktrain.motion import Array
from cranktrain.numerics import around_zero
from cranktrain.numerics.ties import first_largest, smallest_of
from cranktrain.questions.cylinders.firing import Cycle, Firing, FiringOrder, within_turn
from cranktrain.questions.cylinders.possible_orders import has_even_order, likest_orders
from cranktrain.questions.cylinders.travel import CylinderPistons
from cranktrain.questions.cylinders.volumes import Chambers, ChamberVolumes, CompressionRatios
from cranktrain.record import record
from cranktrain.saying.checks import Flagged, Limit, flagged
from cranktrain.saying.wording import number

# Smallest of models that run; the low-pressure cylinder of the pumping engine at Cruquius, 1849, 144 in.
_BORE = Limit(
    4.0,
    "mm",
    N_("A bore of {value} is none that was ever built, from 3 mm of models to 3.66 m at Cruquius: is its unit right?"),
    0.002,
)
_OFF = 0.2
"""Of a master's compression ratio, by which a slave's is flagged: those of built radials differ by a few hundredths."""
_UNEVEN = 0.01
"""Of the mean interval: angles may be written to a tenth of a degree."""
_WRITTEN = np.radians(0.5)
"""Banks that are nearer to 0° or 180° are in line, or flat."""
_DIGITS = 9
"""Of an angle in rad; of those that differ by less one is told."""


@record
class UnlikelyCylinders(Flagged):
    """Compression ratios and firing that hardly any machine has."""


def unlikely_cylinders(
    volumes: ChamberVolumes | None,
    chambers: Chambers | None,
    ratios: CompressionRatios | None,
    firing: Firing | None,
    order: FiringOrder | None,
    cycle: Cycle | None,
    cylinders: CylinderPistons | None,
    pistons: Pistons | None,
    frames: Frames | None,
) -> UnlikelyCylinders:
    """Flag what is unlikely, as far as it is known."""
    found: list[Words] = []
    if chambers is not None:
        found += flagged(_BORE, np.sqrt(4 / np.pi * chambers.area))
    if volumes is not None and chambers is not None and ratios is not None:
        found += _ratios_of_slaves(volumes.compression_ratio, ratios, chambers.names)
    known = (order, cycle, cylinders, pistons, frames)
    # Who gives the angles has seen how even they are.
    if firing is not None and order is not None and order.angles is None and None not in known:
        found += _uneven(firing, *known)  # pyright: ignore[reportArgumentType]
    return UnlikelyCylinders(unlikely=tuple(found))


def _ratios_of_slaves(ratio: Array, ratios: CompressionRatios, names: Sequence[str]) -> Iterator[Words]:
    """Flag the slave whose ratio is farthest off its master's."""
    off = np.abs(ratio / ratio[:, ratios.master] - 1)
    if np.any(off > _OFF):
        design, slave = divmod(first_largest(off), off.shape[1])
        master = int(ratios.master[slave])
        said = _(
            "The compression ratio of {slave} is {ratio}, that of {master}, on whose rod it hangs, {other}: are its"
            " rod, knuckle and bore right?"
        )
        yield said.format(
            slave=names[slave],
            ratio=f"{ratio[design, slave]:.4g}",
            master=names[master],
            other=f"{ratio[design, master]:.4g}",
        )


def _uneven(
    firing: Firing, order: FiringOrder, cycle: Cycle, cylinders: CylinderPistons, pistons: Pistons, frames: Frames
) -> Iterator[Words]:
    """Flag firing that is uneven, where another order on the same throws is even, or this one at another bank angle."""
    for tops, interval in zip(pistons.nominal_top[:, cylinders.leading, 0], firing.firing_interval, strict=True):
        step = cycle.length / tops.size
        if not np.ptp(interval) > _UNEVEN * step:
            continue
        said = _("Cylinders fire {least} to {most} apart, and {even}: is that right? If so, write firing_angles.")
        better = _even_order(within_turn(tops), order, cycle, cylinders, frames)
        better = better or _even_angle(tops, cycle, cylinders, pistons, frames)
        if better:
            least, most = (number(float(find(interval)), "deg") for find in (np.min, np.max))
            yield said.format(least=least, most=most, even=better)
            return


def _even_order(
    tops: Array, order: FiringOrder, cycle: Cycle, cylinders: CylinderPistons, frames: Frames
) -> Words | None:
    """Say which even order the throws allow; None where they allow none."""
    if not has_even_order(tops, cycle.length, _UNEVEN):
        return None
    orders = likest_orders(tops, cycle.length, order.order.tolist())
    if not orders:
        return _("the same throws have an even order")
    first, *others = orders[0]
    running = [first, *others] if frames.running > 0 else [first, *reversed(others)]
    called = dict(zip(order.order.tolist(), order.numbers, strict=True)) if order.numbers else {}
    written = "-".join(called.get(i, cylinders.names[i]) for i in running)
    return _("the same throws fire evenly in the order {order}", order=written)


def _even_angle(
    tops: Array, cycle: Cycle, cylinders: CylinderPistons, pistons: Pistons, frames: Frames
) -> Words | None:
    """Say how far apart two banks would fire evenly, the nearest to what is given; None where no V does."""
    leading: list[int] = cylinders.leading.tolist()
    banks = [pistons.banks[piston] for piston in leading]
    names = tuple(dict.fromkeys(banks))
    if len(names) != 2:
        return None
    is_second = np.array([bank == names[1] for bank in banks])
    first, second = leading[int(np.argmin(is_second))], leading[int(np.argmax(is_second))]
    apart = float(frames.direction[0, second] - frames.direction[0, first])
    # What brings the second bank's first piston to its top at a step of the cycle.
    steps = cycle.length / tops.size * np.arange(tops.size)
    turns = steps - (tops[np.argmax(is_second)] - tops[np.argmin(is_second)])
    even = [apart + turn for turn in turns if has_even_order(tops + turn * is_second, cycle.length, _UNEVEN)]
    angles = sorted({round(abs(float(around_zero(np.array(one)))), _DIGITS) for one in even})
    # Banks in line or flat are another engine, and no V.
    angles = [one for one in angles if _WRITTEN < one < np.pi - _WRITTEN]
    if not angles:
        return None
    given = abs(float(around_zero(np.array(apart))))
    nearest = smallest_of(angles, lambda one: abs(one - given))
    said = _("with banks {even} apart in place of {given} they would fire evenly")
    return said.format(even=number(nearest, "deg"), given=number(given, "deg"))
