"""What cylinders say in the answer: volumes, ratios, ports, opposed pistons, and in which order they fire."""

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from cranktrain.language import _
from cranktrain.questions.cylinders.firing import Firing
from cranktrain.questions.cylinders.opposed import VolumetricDeadCentres
from cranktrain.questions.cylinders.ports import EffectiveCompression, PortTiming
from cranktrain.questions.cylinders.volumes import ChamberVolumes, SweptVolumes
from cranktrain.saying.rows import AnswerLine, Telling, valued, worded

_SAME = 1e-9
"""Intervals that differ by less are even. [rad]"""


def volume_rows(
    of: Telling, swept: SweptVolumes, chambers: ChamberVolumes | None, effective: EffectiveCompression | None
) -> Iterator[AnswerLine]:
    """Swept volume, by bank or in all, and the compression ratios or clearances."""
    total, each, n_chambers = (
        of.amount(swept, "displacement"),
        of.alike(swept, "swept_volume"),
        len(of.labels["chamber"]),
    )
    name = _("swept volume")
    if n_chambers > 1 and each is not None:
        yield of.row(name, swept, "displacement", _("{values}; {n} × {each}", n=n_chambers, each=each))
    elif len(of.labels["bank"]) > 1:
        yield of.row(name, swept, "bank_swept_volume", _("{values}, {total} in all", total=total))
    else:
        yield of.row(name, swept, "swept_volume")
    if chambers is not None:
        yield from _room_rows(of, chambers, effective)


def _room_rows(of: Telling, chambers: ChamberVolumes, effective: EffectiveCompression | None) -> Iterator[AnswerLine]:
    """Compression ratios, or clearances where the file speaks of these; and the ratio from the last port on."""
    ratio = "effective_compression_ratio"
    last = None if chambers.is_clearance or effective is None else of.alike(effective, ratio)
    if chambers.is_clearance:
        part = 1 / (of.values(chambers, "compression_ratio") - 1)
        yield valued(_("clearance"), part, "%", of.labels["chamber"], quantity="compression_ratio")
    else:
        words = None if last is None else _("{values}; {last} from the last port on", last=last)
        yield of.row(_("compression ratio"), chambers, "compression_ratio", words)
    if effective is not None and last is None:
        yield of.row(_("ratio from the last port"), effective, ratio)


def opposed_rows(of: Telling, found: VolumetricDeadCentres) -> Iterator[AnswerLine]:
    """Lead of the exhaust crank, where the volume is least, and by how much both pistons part."""
    name = _("exhaust crank ahead by") if np.nanmax(of.values(found, "lead")) >= 0 else _("exhaust crank behind by")
    inner = of.alike(found, "inner_volumetric_shift", unit="rad")
    words = None if inner is None else _("{values}, least volume {inner} after its dead centre", inner=inner)
    lead = of.row(name, found, "lead", words)
    yield replace(lead, values=np.abs(lead.values))
    nominal = of.alike(found, "nominal_stroke")
    words = None if nominal is None else _("{values} of {nominal}", nominal=nominal)
    yield of.row(_("both pistons part by"), found, "combined_stroke", words)


def port_rows(of: Telling, found: PortTiming) -> Iterator[AnswerLine]:
    """By how much the exhaust ports open and close before the scavenge ports."""
    opens, closes = "exhaust_opens_before", "exhaust_closes_before"
    first, last = of.alike(found, opens, unit="rad"), of.alike(found, closes, unit="rad")
    if first is not None and last is not None:
        words = _("open {first} and close {last} before the scavenge ports", first=first, last=last)
        yield worded(_("exhaust ports"), words)
        return
    yield of.row(_("exhaust ports open by"), found, opens, _("{values} before the scavenge ports"))
    yield of.row(_("exhaust ports close by"), found, closes, _("{values} before the scavenge ports"))


def firing_rows(of: Telling, found: Firing) -> Iterator[AnswerLine]:
    """The firing order, by the maker's numbers where there are any, and its intervals."""
    names = of.labels["cylinder"]
    if len(names) == 1:
        return
    order = "-".join(found.numbers or [names[i] for i in found.order])
    intervals = of.values(found, "firing_interval")
    if np.ptp(intervals) < _SAME:
        said = _("{order}, every {interval}", order=order, interval=_degrees(float(intervals[0])))
    else:
        turns = dict.fromkeys(_degrees(float(intervals[i])) for i in found.order)
        said = _("{order}, by turns after {intervals}", order=order, intervals=", ".join(turns))
    if found.n_choices[of.design] > 1:
        said = _("{said}; the most even of {n} choices", said=said, n=found.n_choices[of.design])
    yield worded(_("firing order"), said, quantity="firing_interval")


def _degrees(angle: float) -> str:
    """Write an interval, of which the texts give whole degrees."""
    return f"{round(float(np.degrees(angle)), 2):g}°"
