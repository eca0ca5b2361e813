"""What is said of a wanted motion, and of the motor that makes it."""

from collections.abc import Iterator

from cranktrain.language import N_, _
from cranktrain.questions.servo.rocking import RockingCrank, RockingDrive
from cranktrain.questions.servo.stages import ServoDrive, WantedCrank
from cranktrain.saying.rows import AnswerLine, Telling


def wanted_rows(of: Telling, found: WantedCrank) -> Iterator[AnswerLine]:
    """Period, rests and speed, and by how much a constant speed misses."""
    message = N_("takes {wanted_period}, {resting_time} of it at rest; crank up to {largest_wanted_speed}")
    yield of.line(_("wanted motion"), message, found)
    yield of.line(_("at constant speed"), N_("off by up to {constant_speed_miss} of the stroke"), found)


def servo_rows(of: Telling, found: ServoDrive) -> Iterator[AnswerLine]:
    """What the motor of a turning crank needs."""
    message = N_(
        "{servo_peak_torque} at once, {servo_rms_torque} for long; up to {servo_peak_speed} and {servo_peak_power}"
    )
    yield of.line(_("motor needs"), message, found)


def rocking_rows(of: Telling, found: RockingCrank) -> Iterator[AnswerLine]:
    """Between which angles a crank swings, and how fast."""
    ends = of.extent(found, "least_rocking_angle", "greatest_rocking_angle", unit="rad")
    message = N_("{range} in {rocking_period}, at up to {largest_rocking_speed}")
    yield of.line(_("crank swings"), message, found, range=ends)


def rocking_drive_rows(of: Telling, found: RockingDrive) -> Iterator[AnswerLine]:
    """What the motor of a rocking crank needs."""
    message = N_("{rocking_peak_torque} at once, {rocking_rms_torque} for long; up to {rocking_peak_power}")
    yield of.line(_("motor needs"), message, found)
