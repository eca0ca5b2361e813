"""What cylinders say in the answer: volumes, ratios, ports, opposed pistons, and in which order they fire."""

from collections.abc import Iterator, Sequence

import numpy as np

from cranktrain.language import _
from cranktrain.questions.cylinders.firing import Firing
from cranktrain.questions.cylinders.opposed import VolumetricDeadCentres
from cranktrain.questions.cylinders.ports import EffectiveCompression, PortTiming
from cranktrain.questions.cylinders.volumes import ChamberVolumes, SweptVolumes
from cranktrain.saying.rows import Amount, AnswerLine, Piece, alike, valued, worded
from cranktrain.saying.wording import Names

_SAME = 1e-9
"""Intervals that differ by less are even. [rad]"""


def volume_rows(
    labels: Names,
    design: int,
    swept: SweptVolumes,
    chambers: ChamberVolumes | None,
    effective: EffectiveCompression | None,
) -> Iterator[AnswerLine]:
    """Swept volume, by bank or in all, and the compression ratios or clearances."""
    total = Amount(float(swept.displacement[design]), "m^3")
    each = alike(swept.swept_volume[design], "m^3")
    name = _("swept volume")
    if len(labels["chamber"]) > 1 and each is not None:
        yield valued(name, total.value, "m^3", (), "; {n} × {each}", n=str(len(labels["chamber"])), each=each)
    elif len(labels["bank"]) > 1:
        yield valued(name, swept.bank_swept_volume[design], "m^3", labels["bank"], _(", {total} in all"), total=total)
    else:
        yield valued(name, swept.swept_volume[design], "m^3", labels["chamber"])
    if chambers is not None:
        yield from _room_rows(labels["chamber"], design, chambers, effective)


def _room_rows(
    names: Sequence[str], design: int, chambers: ChamberVolumes, effective: EffectiveCompression | None
) -> Iterator[AnswerLine]:
    """Compression ratios, or clearances where the file speaks of these; and the ratio from the last port on."""
    ratio = np.empty(0) if effective is None else effective.effective_compression_ratio[design]
    last = None if chambers.is_clearance else alike(ratio, "1")
    words, pieces = ("", dict[str, Piece]()) if last is None else (_("; {last} from the last port on"), {"last": last})
    if chambers.is_clearance:
        yield valued(_("clearance"), chambers.clearance[design], "%", names)
    else:
        yield valued(_("compression ratio"), chambers.compression_ratio[design], "1", names, words, **pieces)
    if ratio.size and last is None:
        yield valued(_("ratio from the last port"), ratio, "1", names)


def opposed_rows(labels: Names, design: int, found: VolumetricDeadCentres) -> Iterator[AnswerLine]:
    """Lead of the exhaust crank, where the volume is least, and by how much both pistons part."""
    cylinders = labels["cylinder"]
    lead = found.lead[design]
    name = _("exhaust crank ahead by") if np.nanmax(lead) >= 0 else _("exhaust crank behind by")
    inner = alike(found.inner_volumetric_shift[design], "rad")
    words, pieces = (
        ("", dict[str, Piece]())
        if inner is None
        else (_(", least volume {inner} after its dead centre"), {"inner": inner})
    )
    yield valued(name, np.abs(lead), "rad", cylinders, words, **pieces)
    nominal = alike(found.nominal_stroke[design], "m")
    words, pieces = ("", dict[str, Piece]()) if nominal is None else (_("of {nominal}"), {"nominal": nominal})
    yield valued(_("both pistons part by"), found.combined_stroke[design], "m", cylinders, words, **pieces)


def port_rows(labels: Names, design: int, found: PortTiming) -> Iterator[AnswerLine]:
    """By how much the exhaust ports open and close before the scavenge ports."""
    opens, closes = found.exhaust_opens_before[design], found.exhaust_closes_before[design]
    first, last = alike(opens, "rad"), alike(closes, "rad")
    if first is not None and last is not None:
        said = _("open {first} and close {last} before the scavenge ports")
        yield worded(_("exhaust ports"), said, first=first, last=last)
        return
    yield valued(_("exhaust ports open by"), opens, "rad", labels["cylinder"], _("before the scavenge ports"))
    yield valued(_("exhaust ports close by"), closes, "rad", labels["cylinder"], _("before the scavenge ports"))


def firing_rows(labels: Names, design: int, found: Firing) -> Iterator[AnswerLine]:
    """The firing order, by the maker's numbers where there are any, and its intervals."""
    names = labels["cylinder"]
    if len(names) == 1:
        return
    order = "-".join(found.numbers or [names[i] for i in found.order])
    intervals = found.firing_interval[design]
    if np.ptp(intervals) < _SAME:
        said, pieces = _("{order}, every {interval}"), {"interval": _degrees(float(intervals[0]))}
    else:
        turns = dict.fromkeys(_degrees(float(intervals[i])) for i in found.order)
        said, pieces = _("{order}, by turns after {intervals}"), {"intervals": ", ".join(turns)}
    if found.n_choices[design] > 1:
        said = _("{said}; the most even of {n} choices", said=said, n=found.n_choices[design])
    yield worded(_("firing order"), said, order=order, **pieces)


def _degrees(angle: float) -> str:
    """Write an interval, of which the texts give whole degrees."""
    return f"{round(float(np.degrees(angle)), 2):g}°"
