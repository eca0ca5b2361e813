"""What is said of steady running: speed, torque and power of the motor, or of one that would hold the speed."""

from collections.abc import Iterator

from cranktrain.language import N_, _
from cranktrain.questions.drive.steady_drive import SteadyDrive
from cranktrain.questions.reduction.constant_speed import ConstantSpeedDrive
from cranktrain.saying.rows import AnswerLine, Telling, worded


def running_rows(of: Telling, found: SteadyDrive) -> Iterator[AnswerLine]:
    """How the motor runs in the steady state."""
    message = N_("{mean_motor_speed}, fluctuation {drive_fluctuation}; cycle {cycle_time}")
    yield of.line(_("motor runs at"), message, found)
    ends = of.extent(found, "smallest_motor_torque", "largest_motor_torque")
    yield of.line(_("torque of the motor"), N_("{range}; effective {rms_motor_torque}"), found, range=ends)
    # What is rounding beside what swings to and fro is nothing, as of loads that give back in a turn what they took.
    swung = of.amount(found, "rms_motor_torque").value * of.amount(found, "mean_motor_speed").value
    power = of.amount(found, "motor_power", beside=swung)
    yield worded(
        _("power of the motor"),
        _(
            "{power}; to loads {taken}, lost {lost}",
            power=power,
            taken=of.amount(found, "driven_power", beside=max(swung, power.size)),
            lost=of.amount(found, "lost_power", beside=swung),
        ),
    )


def constant_speed_rows(of: Telling, found: ConstantSpeedDrive, steady: SteadyDrive | None) -> Iterator[AnswerLine]:
    """Torque of a motor that would hold the declared speed; of a declared one, its own running says more."""
    if steady is None:
        least, most = "smallest_constant_speed_torque", "largest_constant_speed_torque"
        yield worded(
            _("motor at constant speed"),
            _(
                "{range}; effective {rms}; {power}",
                range=of.extent(found, least, most, 0),
                rms=of.amount(found, "rms_constant_speed_torque", 0),
                power=of.amount(found, "constant_speed_power"),
            ),
        )
