"""What is said of single strokes: clutch, flywheel and brake."""

from collections.abc import Iterator

import numpy as np

from cranktrain.language import N_, _
from cranktrain.questions.press.strokes import PressStrokes
from cranktrain.saying.rows import AnswerLine, Telling


def stroke_rows(of: Telling, found: PressStrokes) -> Iterator[AnswerLine]:
    """How a single stroke goes: clutch, flywheel, brake, and how many are possible."""
    if np.isnan(of.values(found, "stroke_time")):
        return
    yield of.line(
        _("stroke"),
        N_("{stroke_time}, command at {command}; up to {most_strokes_per_minute} a minute"),
        found,
        command=of.amount(found, "command_angle", unit="rad"),
    )
    yield of.line(
        _("clutch"),
        N_("slips for {clutch_slip_time} to {angle}, takes {clutch_heat}"),
        found,
        angle=of.amount(found, "clutch_lock_angle", unit="rad"),
    )
    yield of.line(
        _("flywheel"),
        N_("slows by {drop}, {pressing} pressing; back in {recovery_time}"),
        found,
        drop=of.amount(found, "stroke_speed_drop", unit="%"),
        pressing=of.amount(found, "pressing_speed_drop", unit="%"),
    )
    yield of.line(
        _("brake"),
        N_("{angle} in {braking_time}, {brake_heat}; rests {off} past its start"),
        found,
        angle=of.amount(found, "braking_angle", unit="rad"),
        off=of.amount(found, "stop_angle", unit="rad"),
    )
