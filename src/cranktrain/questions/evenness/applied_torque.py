"""The torque of gas, weight and friction on the shaft: what is left of a machine's torque without its inertia."""

from collections.abc import Callable
from typing import NamedTuple

from cranktrain.catalogue import quantity
from cranktrain.language import N_
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.speed import Speed
from cranktrain.linkage.forces import Drive, Reduced, ReducedInertia, torque_by_work
from cranktrain.motion import Array
from cranktrain.numerics.periodic import (
    Interpolation,
    PeriodicCurve,
    fourier_curve,
    fourier_integral,
    hermite_curve,
    spline_curve,
    spline_integral,
)
from cranktrain.questions.evenness.spec import Balancing
from cranktrain.questions.forces.loaded_machine import LoadedMachine
from cranktrain.questions.forces.mechanism_torques import MechanismTorques
from cranktrain.record import record
from cranktrain.references import THEORY_OF_EVENNESS as _THEORY


class Interpolations(NamedTuple):
    """How curves run between the points of the grid: a curve, the integral of a torque, a work whose slope is known."""

    curve: Interpolation
    integral: Interpolation
    work: Callable[[Array, Array, float], PeriodicCurve]


@record
class AppliedTorque:
    """Torque without inertia.

    Attributes
    ----------
    by : Interpolations
        Fourier series where nothing but masses acts; splines where gas or friction gives the torque kinks.
    """

    by: Interpolations
    applied_torque: Array = quantity(
        "M_d",
        "N*m",
        ("crank_angle",),
        N_("Torque of gas, weight and friction on the shaft, without inertia"),
        _THEORY,
    )


def _smooth_work(work: Array, _slope: Array, cycle: float) -> PeriodicCurve:
    """Curve of a work that is smooth, for which its values are enough."""
    return fourier_curve(work, cycle)


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
    by = (
        Interpolations(fourier_curve, fourier_integral, _smooth_work)
        if loaded.gas is None and not loaded.jumps
        else Interpolations(spline_curve, spline_integral, hermite_curve)
    )
    return AppliedTorque(by, applied)
