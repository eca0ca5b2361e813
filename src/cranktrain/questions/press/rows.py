"""What is said of single strokes: clutch, flywheel and brake."""

from collections.abc import Iterator

import numpy as np

from cranktrain.language import _
from cranktrain.questions.press.strokes import PressStrokes
from cranktrain.saying.rows import Amount, AnswerLine, worded
from cranktrain.saying.wording import Names


def stroke_rows(labels: Names, design: int, found: PressStrokes) -> Iterator[AnswerLine]:
    """How a single stroke goes: clutch, flywheel, brake, and how many are possible."""
    if np.isnan(found.stroke_time[design]):
        return
    yield worded(
        _("stroke"),
        _("{time}, command at {command}; up to {most} a minute"),
        time=Amount(float(found.stroke_time[design]), "s"),
        command=Amount(float(found.command_angle[design]), "rad"),
        most=f"{float(found.most_strokes_per_minute[design]):.4g}",
    )
    yield worded(
        _("clutch"),
        _("slips for {time} to {angle}, takes {heat}"),
        time=Amount(float(found.clutch_slip_time[design]), "s"),
        angle=Amount(float(found.clutch_lock_angle[design]), "rad"),
        heat=Amount(float(found.clutch_heat[design]), "J"),
    )
    yield worded(
        _("flywheel"),
        _("slows by {drop}, {pressing} pressing; back in {time}"),
        drop=Amount(float(found.stroke_speed_drop[design]), "%"),
        pressing=Amount(float(found.pressing_speed_drop[design]), "%"),
        time=Amount(float(found.recovery_time[design]), "s"),
    )
    yield worded(
        _("brake"),
        _("{angle} in {time}, {heat}; rests {off} past its start"),
        angle=Amount(float(found.braking_angle[design]), "rad"),
        time=Amount(float(found.braking_time[design]), "s"),
        heat=Amount(float(found.brake_heat[design]), "J"),
        off=Amount(float(found.stop_angle[design]), "rad"),
    )
