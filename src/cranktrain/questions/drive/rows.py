"""What is said of steady running: speed, torque and power of the motor."""

from collections.abc import Iterator

from cranktrain.language import _
from cranktrain.questions.drive.steady_drive import SteadyDrive
from cranktrain.saying.rows import Amount, AnswerLine, Extent, worded
from cranktrain.saying.wording import Names

_NOTHING = 1e-9
"""Of what it is beside: less is rounding, as of loads that give back in a turn what they took."""


def running_rows(labels: Names, design: int, found: SteadyDrive) -> Iterator[AnswerLine]:
    """How the motor runs in the steady state."""
    yield worded(
        _("motor runs at"),
        _("{speed}, fluctuation {delta}; cycle {time}"),
        speed=Amount(float(found.mean_motor_speed[design]), "rpm"),
        delta=Amount(float(found.drive_fluctuation[design]), "1"),
        time=Amount(float(found.cycle_time[design]), "s"),
    )
    yield worded(
        _("torque of the motor"),
        _("{range}; effective {rms}"),
        range=Extent(float(found.smallest_motor_torque[design]), float(found.largest_motor_torque[design]), "N*m"),
        rms=Amount(float(found.rms_motor_torque[design]), "N*m"),
    )
    power, taken, lost = (float(each[design]) for each in (found.motor_power, found.driven_power, found.lost_power))
    swung = float(found.rms_motor_torque[design] * found.mean_motor_speed[design])
    yield worded(
        _("power of the motor"),
        _("{power}; to loads {taken}, lost {lost}"),
        power=Amount(_unless_rounding(power, swung), "W"),
        taken=Amount(_unless_rounding(taken, max(swung, abs(power))), "W"),
        lost=Amount(_unless_rounding(lost, swung), "W"),
    )


def _unless_rounding(power: float, swung: float) -> float:
    """A mean power, or nothing beside what swings to and fro. [W]"""
    return power if abs(power) > _NOTHING * swung else 0.0
