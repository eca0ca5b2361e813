"""GD² of the moving parts, as books give the inertia of what turns."""

from cranktrain.language import N_
from cranktrain.motion import Array
from cranktrain.questions.forces.mechanism_torques import MechanismTorques
from cranktrain.record import record
from cranktrain.references import THEORY_OF_EVENNESS as _THEORY
from cranktrain.saying.catalogue import quantity


@record
class FlywheelMoment:
    """GD² of the moving parts."""

    flywheel_moment: Array = quantity(
        "GD²",
        "kg*m^2",
        ("crank_angle",),
        N_("Flywheel moment GD² of all moving parts, four times their reduced inertia"),
        _THEORY,
        "17.14",
    )


def flywheel_moment(torques: MechanismTorques) -> FlywheelMoment:
    """GD² = 4 J."""
    return FlywheelMoment(4 * torques.reduced_inertia)
