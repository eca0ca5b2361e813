"""What the pumping unit says in the answer: gearbox torque with its peaks, ratings, and the best counterbalances."""

from collections.abc import Iterator

import numpy as np

from cranktrain.language import N_, _
from cranktrain.questions.pumping.gearbox_torque import GearboxTorque
from cranktrain.saying.rows import AnswerLine, Telling


def pumping_rows(of: Telling, found: GearboxTorque) -> Iterator[AnswerLine]:
    """Peaks of both strokes, least torque, evenness, ratings, and the counterbalances for equal peaks and least rms."""
    message = N_(
        "{upstroke_peak} going up at {upstroke_peak_at}, {downstroke_peak} going down at {downstroke_peak_at},"
        " least {least_gearbox_torque} at {least_gearbox_torque_at}"
    )
    yield of.line(_("gearbox torque"), message, found)
    message = N_("{mean_gearbox_torque}, cyclic load factor {cyclic_load_factor}; at the rod {polished_rod_power}")
    yield of.line(_("mean torque"), message, found)
    yield of.row(_("of the rated torque"), found, "torque_share", unit="%")
    if np.isfinite(of.values(found, "counterbalance_moment")):
        message = N_(
            "{counterbalance_moment}; {equal_peaks_moment} makes both peaks {equal_peaks_torque}, {least_rms_moment}"
            " the root mean square least"
        )
        yield of.line(_("counterbalance"), message, found)
