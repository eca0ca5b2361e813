"""The torque of gas, weight and friction on the shaft: what is left of a machine's torque without its inertia."""

from cranktrain.catalogue import quantity
from cranktrain.language import N_
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.speed import Speed
from cranktrain.linkage.forces import Drive, Reduced, ReducedInertia, torque_by_work
from cranktrain.motion import Array
from cranktrain.questions.evenness.spec import Balancing
from cranktrain.questions.forces.loaded_machine import LoadedMachine
from cranktrain.questions.forces.mechanism_torques import MechanismTorques
from cranktrain.record import record
from cranktrain.references import THEORY_OF_EVENNESS as _THEORY


@record
class AppliedTorque:
    """Torque without inertia.

    Attributes
    ----------
    is_smooth : bool
        Whether nothing but masses and weight acts; gas, friction and loads give the torque kinks.
    """

    is_smooth: bool
    applied_torque: Array = quantity(
        "M_d",
        "N*m",
        ("crank_angle",),
        N_("Torque of gas, weight and friction on the shaft, without inertia"),
        _THEORY,
    )


def of_steady_running(balancing: Balancing | None, speed: Speed | None) -> bool | str:
    """Whether the machine has a load and runs on as it does; what is asked for at one moment has no load."""
    if speed is not None and speed.curve is not None and speed.curve.moment is not None:
        return N_("steady running, without [shaft.main] acceleration,")
    return Balancing.needs if balancing is None else True


def applied_torque(torques: MechanismTorques, loaded: LoadedMachine, crank_angle: CrankAngle) -> AppliedTorque:
    """Torque that is left without inertia; a file that says nothing of a load has none, nor has one moment.

    Notes
    -----
    The shaft takes M = Jε + ½J′ω² − M_d. Friction that inertia causes stays in M_d as it is at the speed of the run.
    docs/theory/evenness, eq. (17.16).
    """
    drive = loaded.speed.drive(crank_angle.angle)
    equation = Reduced(ReducedInertia(torques.reduced_inertia, torques.reduced_inertia_slope), torques.from_mechanisms)
    applied = torque_by_work(equation, Drive(drive.speed[:, 0], drive.acceleration[:, 0]))
    return AppliedTorque(loaded.gas is None and not loaded.jumps, applied)
