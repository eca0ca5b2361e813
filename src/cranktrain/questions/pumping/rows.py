"""What the pumping unit says in the answer: gearbox torque with its peaks, ratings, and the best counterbalances."""

from collections.abc import Iterator

import numpy as np

from cranktrain.language import _
from cranktrain.questions.pumping.gearbox_torque import GearboxTorque
from cranktrain.saying.rows import Amount, AnswerLine, valued, worded
from cranktrain.saying.wording import Names


def pumping_rows(labels: Names, design: int, found: GearboxTorque) -> Iterator[AnswerLine]:
    """Peaks of both strokes, least torque, evenness, ratings, and the counterbalances for equal peaks and least rms."""
    del labels
    up, down, least = found.upstroke_peak, found.downstroke_peak, found.least_gearbox_torque
    yield worded(
        _("gearbox torque"),
        _("{up} going up at {up_at}, {down} going down at {down_at}, least {least} at {least_at}"),
        up=Amount(float(up.value[design]), "N*m"),
        up_at=Amount(float(up.angle[design]), "position"),
        down=Amount(float(down.value[design]), "N*m"),
        down_at=Amount(float(down.angle[design]), "position"),
        least=Amount(float(least.value[design]), "N*m"),
        least_at=Amount(float(least.angle[design]), "position"),
    )
    yield worded(
        _("mean and evenness"),
        _("mean {mean}, cyclic load factor {factor}; at the rod {power}"),
        mean=Amount(float(found.mean_gearbox_torque[design]), "N*m"),
        factor=Amount(float(found.cyclic_load_factor[design]), "1"),
        power=Amount(float(found.polished_rod_power[design]), "W"),
    )
    if np.isfinite(found.torque_share[design]):
        yield valued(_("of the rated torque"), found.torque_share[design], "%")
    if np.isfinite(found.counterbalance_moment[design]):
        yield from _counterbalance(found, design)


def _counterbalance(found: GearboxTorque, design: int) -> Iterator[AnswerLine]:
    """Moment present, and what would be best."""
    yield worded(
        _("counterbalance"),
        _("{now}; {equal} makes both peaks {peak}, {least} the root mean square least"),
        now=Amount(float(found.counterbalance_moment[design]), "N*m"),
        equal=Amount(float(found.equal_peaks_moment[design]), "N*m"),
        peak=Amount(float(found.equal_peaks_torque[design]), "N*m"),
        least=Amount(float(found.least_rms_moment[design]), "N*m"),
    )
