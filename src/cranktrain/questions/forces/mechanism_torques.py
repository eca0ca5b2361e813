"""Torque that each mechanism gives to its shaft, by virtual work and by reactions, and the reduced inertia."""

from collections.abc import Iterator, Sequence

import numpy as np

from cranktrain.language import N_, _
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.shaft_loads import LoadsOnShafts
from cranktrain.linkage.forces import Reduced, torque_by_work
from cranktrain.motion import Array
from cranktrain.questions.forces.forces_times_arms import ForcesTimesArms
from cranktrain.questions.forces.loaded_machine import LoadedMachine, SolvedBatch
from cranktrain.questions.forces.solved_cycle import SolvedCycle
from cranktrain.record import record
from cranktrain.references import THEORY_OF_FORCES as _THEORY
from cranktrain.saying.catalogue import quantity
from cranktrain.saying.checks import Check, Checked

_TORQUES_LIMIT = 1e-12


@record
class MechanismTorques(Checked):
    """What every mechanism does to the shaft, and all together.

    from_mechanisms, shape (design, n), is what must be applied for the mechanisms alone, without loads on the shaft.
    [N·m]
    """

    from_mechanisms: Array
    mechanism_torque: Array = quantity(
        "M_i",
        "N*m",
        ("mechanism", "crank_angle"),
        N_("Torque of the mechanism on its shaft, by virtual work"),
        _THEORY,
        "13.7",
    )
    driving_torque: Array = quantity(
        "M", "N*m", ("crank_angle",), N_("Torque that must be applied to the shaft, by the reactions"), _THEORY, "13.5"
    )
    reduced_inertia: Array = quantity(
        "J", "kg*m^2", ("crank_angle",), N_("Inertia of all moving parts reduced to the crank"), _THEORY, "13.4"
    )
    reduced_inertia_slope: Array = quantity(
        "J′",
        "kg*m^2/rad",
        ("crank_angle",),
        N_("Derivative of the reduced inertia by the crank angle"),
        _THEORY,
        "13.4",
    )


def mechanism_torques(
    loaded: LoadedMachine,
    solved: SolvedCycle,
    times_arms: ForcesTimesArms,
    on_shafts: LoadsOnShafts | None,
    crank_angle: CrankAngle,
) -> MechanismTorques:
    """Torques by virtual work and by reactions, which share little, and the reduced inertia.

    Notes
    -----
    docs/theory/forces, eqs. (13.4) to (13.7).
    """
    by_reactions = solved.driving_torque
    shape = by_reactions.shape
    by_work = np.empty(shape)
    inertia, slope = np.zeros((2, shape[0], shape[-1]))
    equations = reduced_batches(loaded, solved.batches)
    for batch, one, equation in zip(loaded.mechanisms.batches, solved.batches, equations, strict=True):
        by_work[:, batch.index] = torque_by_work(equation, one.conditions.drive) - one.forces.friction_torque
        inertia = inertia + equation.inertia.value.sum(axis=1)
        slope = slope + equation.inertia.first.sum(axis=1)
    own = by_reactions.sum(axis=1)
    speed = loaded.speed.drive(crank_angle.angle).speed
    given = () if on_shafts is None else on_shafts.given
    driving = own - sum(load.value(crank_angle.shown, speed)[:, 0] for load in given)
    # Where forces stand across the way of their pins there is no torque, but rounding of forces times arms.
    scale = np.max(np.sum(np.abs(by_work), axis=1), axis=-1) + times_arms.value.sum(axis=1)
    residual = np.max(np.abs(own - by_work.sum(axis=1)), axis=-1) / np.where(scale > 0, scale, 1.0)
    residual, reasons = loaded.judged(residual)
    return MechanismTorques(
        from_mechanisms=own,
        mechanism_torque=-by_work,
        driving_torque=driving,
        reduced_inertia=inertia,
        reduced_inertia_slope=slope,
        checks=(
            Check(
                "torque",
                _("Torque by the reactions of all joints against that by virtual work, relative to forces times arms"),
                residual,
                _TORQUES_LIMIT,
                reasons,
            ),
        ),
    )


def reduced_batches(loaded: LoadedMachine, solved: Sequence[SolvedBatch]) -> Iterator[Reduced]:
    """Inertia of each batch's mechanisms, and the torque of their loads and weights, reduced to the crank.

    What slaves hand over is their own work, which counts once: the mechanism's own loads.
    """
    for batch, made, one in zip(loaded.mechanisms.batches, loaded.masses.batches, solved, strict=True):
        yield batch.kind.dynamics.reduced(one.motion, batch.members.geometry, made.bodies, one.loads, made.gravity)
