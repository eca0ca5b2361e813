"""Polar diagram of a crank pin's load: in the pin's axes and in the rod's, with the rod's rotating mass and without."""

from collections.abc import Iterator, Sequence

import numpy as np

from cranktrain.analysis import SpeedWanted, speed_over_cycle
from cranktrain.language import said as _
from cranktrain.machine import Machine
from cranktrain.motion import Array
from cranktrain.numerics.ties import first_largest
from cranktrain.panels.figures import aligned, figure, with_unit
from cranktrain.panels.formulas import mathematics
from cranktrain.plans.pin_loads import CrankpinLoad, pin_loads
from cranktrain.plans.positions import fitting, plan_angles
from cranktrain.plans.vectors import angle_of
from cranktrain.saying.scales import Scale, scale_for
from cranktrain.saying.wording import plain
from cranktrain.viz.paper.page import Box, Figure, drawing_settings
from cranktrain.viz.paper.rings import RING_SCALES, PolarRings, ring_numbers, ring_step
from cranktrain.viz.paper.sketch import Circle, Line, Sketch, Wish, dots, placed_labels
from cranktrain.viz.paper.style import INK
from cranktrain.viz.plans.sheet import centre, plan_page, scale_of, write_beside, write_scales

_MARKS = 30
"""Between marks of the crank angle. [deg]"""

_TABLE = 62.0
"""Width of the table. [mm]"""

_COLUMNS = (0.42, 0.71, 1.0)

_BEYOND = 5.0
"""How far axes go beyond the curves. [mm]"""

_NEXT = 1e-6


@drawing_settings()
def plan_polar(
    machine: Machine,
    angles: int | Sequence[float] | None = None,
    *,
    mechanism: str | None = None,
    size: str = "A4",
    speed: SpeedWanted = "constant",
) -> Figure:
    """Draw the polar diagrams of a crank pin's load.

    Parameters
    ----------
    machine : Machine
        With masses or gas, and a speed.
    angles : int or sequence of float, optional
        How many crank angles, evenly over a turn, or which, at which the table gives the load; each 30° of the cycle
        unless given. [deg]
    mechanism : str, optional
        Whose rod; the first with a rod on a crank pin unless given.
    size : "A4" or "A3"
    speed : SpeedWanted
        As `cranktrain.run` takes it.

    Returns
    -------
    Figure
    """
    curve = speed_over_cycle(machine, speed)
    loads = pin_loads(machine, mechanism=mechanism, speed=curve or "constant")
    chosen = np.arange(0.0, loads.cycle, _MARKS) if angles is None else plan_angles(angles)
    page, box = plan_page(
        machine,
        chosen.tolist(),
        size,
        _("Polar diagram of the crank pin's load"),
        loads.mechanism,
        curve=curve,
    )
    width = (box.width - _TABLE) / 2
    unit = scale_for("N", loads.largest)
    diagrams = (
        (
            (loads.on_pin, loads.on_pin_without),
            _("On the pin, in the crank's axes"),
            (_("up: away from the shaft"), _("right: in the sense of rotation")),
        ),
        (
            (loads.in_rod, loads.in_rod_without),
            _("On the rod's bearing, in the rod's axes"),
            (_("up: toward the piston"), _("right: 90° from it in the sense of rotation")),
        ),
    )
    for number, (pair, head, axes) in enumerate(diagrams):
        cell = Box(box.left + number * width, box.bottom + 8.0, width - 4.0, box.height - 8.0)
        top = cell.bottom + cell.height
        page.heading(cell.left, top - 4.0, head)
        page.notes(cell.left, top - 8.5, axes)
        outline = np.concatenate([*pair, np.zeros((2, 1))], axis=1)
        scale = fitting([outline], (width - 26.0, box.height - 42.0), RING_SCALES, unit.one)
        rings = PolarRings(ring_step(float(np.nanmax(np.hypot(*pair[0]))), unit), unit, scale)
        said = _("rings each {step} {unit}", step=plain(rings.step), unit=unit.label)
        page.text(cell.left, top - 17.2, f"{scale_of('F', scale, unit)}, {said}")
        centre(page, polar_sketch(loads, pair, rings), cell._replace(height=cell.height - 19.0))
    start = box.left + 2 * width + 4.0
    write_beside(page, box, start, _table(loads, chosen, unit), _notes(loads, unit), shares=_COLUMNS)
    page.sample(box.left, box.left + 8.0, box.bottom + 0.5, color=INK, lw=1.0)
    page.text(box.left + 10.0, box.bottom - 0.4, _("with the rod's rotating mass"))
    if np.any(np.isfinite(loads.on_pin_without)):
        page.sample(box.left + 62.0, box.left + 70.0, box.bottom + 0.5, color=INK, lw=0.6, dashes=(5.0, 2.5))
        page.text(box.left + 72.0, box.bottom - 0.4, _("without it"))
    write_scales(page, box, [], None)
    return page.figure


def polar_sketch(loads: CrankpinLoad, pair: tuple[Array, Array], rings: PolarRings) -> Sketch:
    """One diagram in drawing millimetres: axes, rings, both loads, marks of the angle, the largest load."""
    full, without = (np.append(part, part[:, :1], axis=1) / rings.scale for part in pair)
    every = np.concatenate([full, without, np.zeros((2, 1))], axis=1)
    low, high = np.nanmin(every, axis=1) - _BEYOND, np.nanmax(every, axis=1) + _BEYOND
    sketch = Sketch(1.0)
    axes = [np.array([[low[0], high[0]], [0.0, 0.0]]), np.array([[0.0, 0.0], [low[1], high[1]]])]
    sketch.add(Line(axis, "LINKS", "thin", 1) for axis in axes)
    sketch.add([Line(without, "LINKS", "part", 3), Line(full, "LINKS", "vector", 4)])
    sketch.add(Line(ring, "LINKS", "dotted", 1) for ring in rings.drawn((low, high)))
    marked = np.nonzero(loads.angle % _MARKS == 0)[0]
    sketch.add(Circle(full[:, i], 0.6, "LINKS", "outline", 6, "paper") for i in marked)
    # Beside a jump the curve's points are on either side of it.
    closed = np.append(loads.angle, loads.cycle)
    beside = np.abs(closed - loads.largest_at) <= closed[1] * (1 + _NEXT)
    largest = full[:, first_largest(np.where(beside, np.hypot(*full), -1.0))]
    sketch.add([Circle(largest, 1.8, "LINKS", "outline", 7)])
    numbers = ring_numbers(np.concatenate([dots(full), dots(without)], axis=1), (low, high), rings)
    sketch.add(numbers)
    middle = np.nanmean(full, axis=1)
    named = marked[loads.angle[marked] % (_MARKS * round(loads.cycle / 360.0)) == 0]
    wishes = [Wish(full[:, i], f"{loads.angle[i]:g}°", angle_of(full[:, i] - middle), "number") for i in named]
    sketch.add(placed_labels(wishes, axes, 1.0, sketch.circles, numbers, (full, without)))
    return sketch


def _table(loads: CrankpinLoad, angles: Array, unit: Scale) -> Iterator[tuple[str, ...]]:
    """Load at some crank angles: toward the shaft, in the sense of rotation, its size."""
    yield ("φ, °", *(f"{mathematics(symbol)}, {unit.label}" for symbol in ("K_R", "T_R", "R")))
    closed = np.append(loads.angle, loads.cycle)
    tangential, outward = (np.interp(angles % loads.cycle, closed, np.append(part, part[:1])) for part in loads.on_pin)
    size = np.sqrt(tangential**2 + outward**2)
    every = np.concatenate([unit.of(one) for one in (-outward, tangential, size)])
    cells = np.reshape(np.array(aligned(every)), (3, -1)).tolist()
    yield from ((f"{angle:g}", *row) for angle, *row in zip(angles.tolist(), *cells, strict=True))


def _notes(loads: CrankpinLoad, unit: Scale) -> Iterator[str]:
    """Say mean and largest load, and what the signs are."""
    yield _("Mean load R: {mean}", mean=with_unit(loads.mean, unit))
    yield _(
        "Largest: {largest} at {angle:g}°, ringed",
        largest=with_unit(loads.largest, unit),
        angle=round(loads.largest_at, 2),
    )
    yield _("Largest over mean: {ratio}", ratio=figure(loads.largest / loads.mean))
    yield _("K toward the shaft, T with rotation")
    yield _("Marks: crank angle, each 30°")
