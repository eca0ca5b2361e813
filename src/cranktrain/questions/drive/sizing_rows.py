"""What sizing says in the answer: which check governs the motor, which typical one is enough, and a flywheel."""

from collections.abc import Iterator

import numpy as np

from cranktrain.language import _
from cranktrain.questions.drive.flywheel_sizing import DriveFlywheel
from cranktrain.questions.drive.motor_sizing import MotorSizing
from cranktrain.rows import Amount, AnswerLine, worded
from cranktrain.wording import Names


def sizing_rows(_labels: Names, design: int, found: MotorSizing) -> Iterator[AnswerLine]:
    """What governs the declared motor, and the smallest typical one that passes."""
    declared, chosen, smaller = found.largest_share[design].tolist()
    if np.isfinite(declared):
        yield worded(
            _("motor is used to"),
            _("{share}: {check}"),
            share=Amount(declared, "%"),
            check=found.governing(design, 0),
        )
    if np.isfinite(chosen):
        words = _("{power}, used to {share}: {check}")
        if np.isfinite(smaller):
            words += _("; {less} misses by {by}: {missed}")
        yield worded(
            _("typical motor that is enough"),
            words,
            power=Amount(float(found.sized_power[design, 1]), "W"),
            share=Amount(chosen, "%"),
            check=found.governing(design, 1),
            **_smaller(found, design, smaller),
        )


def _smaller(found: MotorSizing, design: int, share: float) -> dict[str, Amount | str]:
    """Pieces that tell of the next smaller motor, where there is one that runs."""
    if not np.isfinite(share):
        return {}
    power = Amount(float(found.sized_power[design, 2]), "W")
    return {"less": power, "by": Amount(share - 1, "%"), "missed": found.governing(design, 2)}


def flywheel_rows(_labels: Names, design: int, found: DriveFlywheel) -> Iterator[AnswerLine]:
    """Flywheel for the wanted torque or evenness, and the formula beside."""
    yield worded(
        _("flywheel of the drive"),
        _("{inertia}; effective torque {rms} in place of {without}"),
        inertia=Amount(float(found.needed_inertia[design]), "kg*m^2"),
        rms=Amount(float(found.rms_with_flywheel[design]), "N*m"),
        without=Amount(float(found.rms_without_flywheel[design]), "N*m"),
    )
