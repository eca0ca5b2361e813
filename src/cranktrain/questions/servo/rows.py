"""What is said of a wanted motion, and of the motor that makes it."""

from collections.abc import Iterator

from cranktrain.language import _
from cranktrain.questions.servo.rocking import RockingCrank, RockingDrive
from cranktrain.questions.servo.stages import ServoDrive, WantedCrank
from cranktrain.saying.rows import Amount, AnswerLine, Extent, worded
from cranktrain.saying.wording import Names


def wanted_rows(labels: Names, design: int, found: WantedCrank) -> Iterator[AnswerLine]:
    """Period, rests and speed, and by how much a constant speed misses."""
    yield worded(
        _("wanted motion"),
        _("takes {period}, {rest} of it at rest; crank up to {speed}"),
        period=Amount(float(found.wanted_period[design]), "s"),
        rest=Amount(float(found.resting_time[design]), "s"),
        speed=Amount(float(found.largest_wanted_speed[design]), "rpm"),
    )
    yield worded(
        _("at constant speed"),
        _("off by up to {miss} of the stroke"),
        miss=Amount(float(found.constant_speed_miss[design]), "1"),
    )


def servo_rows(labels: Names, design: int, found: ServoDrive) -> Iterator[AnswerLine]:
    """What the motor of a turning crank needs."""
    yield worded(
        _("motor needs"),
        _("{peak} at once, {rms} for long; up to {speed} and {power}"),
        peak=Amount(float(found.servo_peak_torque[design]), "N*m"),
        rms=Amount(float(found.servo_rms_torque[design]), "N*m"),
        speed=Amount(float(found.servo_peak_speed[design]), "rpm"),
        power=Amount(float(found.servo_peak_power[design]), "W"),
    )


def rocking_rows(labels: Names, design: int, found: RockingCrank) -> Iterator[AnswerLine]:
    """Between which angles a crank swings, and how fast."""
    ends = (float(found.least_rocking_angle[design]), float(found.greatest_rocking_angle[design]))
    yield worded(
        _("crank swings"),
        _("{range} in {period}, at up to {speed}"),
        range=Extent(*ends, "rad"),
        period=Amount(float(found.rocking_period[design]), "s"),
        speed=Amount(float(found.largest_rocking_speed[design]), "rpm"),
    )


def rocking_drive_rows(labels: Names, design: int, found: RockingDrive) -> Iterator[AnswerLine]:
    """What the motor of a rocking crank needs."""
    yield worded(
        _("motor needs"),
        _("{peak} at once, {rms} for long; up to {power}"),
        peak=Amount(float(found.rocking_peak_torque[design]), "N*m"),
        rms=Amount(float(found.rocking_rms_torque[design]), "N*m"),
        power=Amount(float(found.rocking_peak_power[design]), "W"),
    )
