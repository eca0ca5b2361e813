"""Balance: shaking force and couple of the machine by order, without and with its balance weights, and what is left."""

import numpy as np

from cranktrain.language import N_
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.frames import Frames
from cranktrain.layout.shafts import AxialPlaces, ShaftCentres
from cranktrain.layout.speed import Speed
from cranktrain.linkage.forces import Drive, weight
from cranktrain.motion import Array
from cranktrain.numerics.harmonics import ComplexArray, curve, from_vectors
from cranktrain.numerics.plane_vectors import running_axes
from cranktrain.questions.balance.frame_forces import FrameForces, RunningFrame
from cranktrain.questions.balance.rotating_weights import weight_orders, weight_roll
from cranktrain.questions.balance.shaken import BALANCE, Balanced, Shaken, shaken
from cranktrain.questions.balance.weights import BalanceWeights
from cranktrain.questions.forces.loaded_machine import LoadedMachine
from cranktrain.questions.forces.mechanism_torques import MechanismTorques
from cranktrain.questions.forces.solved_cycle import SolvedCycle
from cranktrain.record import record
from cranktrain.references import THEORY_OF_BALANCE as _THEORY
from cranktrain.saying.catalogue import quantity
from cranktrain.saying.checks import StageResult

_CURVE = ("balance", "crank_angle")
_ORDER = ("balance", "order")


@record
class ShakingForces(Shaken):
    """Force of the moving masses on the frame, without and with balance weights."""

    shaking_force_x: Array = quantity(
        "F_X", "N", _CURVE, N_("Shaking force on the frame, to the right"), _THEORY, "16.5, 16.7"
    )
    shaking_force_y: Array = quantity("F_Y", "N", _CURVE, N_("Shaking force on the frame, up"), _THEORY, "16.5, 16.7")
    shaking_force_forward: Array = quantity(
        "F_f", "N", _ORDER, N_("Part of the order's shaking force that turns with the crank"), _THEORY, "16.4"
    )
    shaking_force_backward: Array = quantity(
        "F_b", "N", _ORDER, N_("Part of the order's shaking force that turns against the crank"), _THEORY, "16.4"
    )
    shaking_force_largest: Array = quantity(
        "F_n",
        "N",
        _ORDER,
        N_("Largest shaking force of the order: half the long axis of its ellipse"),
        _THEORY,
        "16.3",
        worst="largest",
        line="{shaking_force_forward} + {shaking_force_backward}",
    )
    shaking_force_smallest: Array = quantity(
        "F_q",
        "N",
        _ORDER,
        N_("Smallest shaking force of the order: half the short axis of its ellipse"),
        _THEORY,
        "16.3",
        worst="smallest",
    )
    shaking_force_direction: Array = quantity(
        "δ_F", "rad", _ORDER, N_("Of the order's largest shaking force, from Y in the normal sense"), _THEORY, "16.3"
    )
    shaking_force_phase: Array = quantity(
        "φ_F",
        "deg",
        _ORDER,
        N_("Crank angle at which the order's shaking force is largest in that direction, in its first period"),
        _THEORY,
        "16.18",
        is_place=True,
    )


@record
class ShakingCouples(Shaken):
    """Couple of the moving masses on the frame about the throws' mid-plane, without and with balance weights."""

    shaking_couple_x: Array = quantity(
        "C_X",
        "N*m",
        _CURVE,
        N_("Shaking couple: first moment of the forces to the right along the shaft"),
        _THEORY,
        "16.5, 16.7",
    )
    shaking_couple_y: Array = quantity(
        "C_Y", "N*m", _CURVE, N_("Shaking couple: first moment of the forces up along the shaft"), _THEORY, "16.5, 16.7"
    )
    shaking_couple_forward: Array = quantity(
        "C_f", "N*m", _ORDER, N_("Part of the order's shaking couple that turns with the crank"), _THEORY, "16.4"
    )
    shaking_couple_backward: Array = quantity(
        "C_b", "N*m", _ORDER, N_("Part of the order's shaking couple that turns against the crank"), _THEORY, "16.4"
    )
    shaking_couple_largest: Array = quantity(
        "C_n",
        "N*m",
        _ORDER,
        N_("Largest shaking couple of the order: half the long axis of its ellipse"),
        _THEORY,
        "16.3",
        worst="largest",
        line="{shaking_couple_forward} + {shaking_couple_backward}",
    )
    shaking_couple_smallest: Array = quantity(
        "C_q",
        "N*m",
        _ORDER,
        N_("Smallest shaking couple of the order: half the short axis of its ellipse"),
        _THEORY,
        "16.3",
        worst="smallest",
    )
    shaking_couple_direction: Array = quantity(
        "δ_C",
        "rad",
        _ORDER,
        N_("Of the forces of the order's largest shaking couple, from Y in the normal sense"),
        _THEORY,
        "16.3",
    )
    shaking_couple_phase: Array = quantity(
        "φ_C",
        "deg",
        _ORDER,
        N_("Crank angle at which the order's shaking couple is largest in that direction, in its first period"),
        _THEORY,
        "16.18",
        is_place=True,
    )


def shaking_forces(
    frame: FrameForces,
    running: RunningFrame | None,
    frames: Frames,
    crank_angle: CrankAngle,
    speed: Speed,
    weights: BalanceWeights | None,
) -> ShakingForces:
    """Sum the forces of all mechanisms, and of the balance weights; docs/theory/balance, eqs. (16.5) and (16.7)."""
    balanced = None if weights is None else Balanced(weights.weights, np.ones_like(weights.weights.moment))
    arm = np.ones(frame.force.shape[:2])
    return shaken(ShakingForces, frame, running, frames, crank_angle, speed, arm=arm, balanced=balanced)


def shaking_couples(
    frame: FrameForces,
    running: RunningFrame | None,
    frames: Frames,
    crank_angle: CrankAngle,
    speed: Speed,
    axial: AxialPlaces,
    weights: BalanceWeights | None,
) -> ShakingCouples:
    """Sum the first moments of the forces of all mechanisms about the mid-plane, and of the balance weights.

    Notes
    -----
    docs/theory/balance, eqs. (16.5) and (16.7).
    """
    middle = axial.mid_plane[:, np.newaxis]
    balanced = None if weights is None else Balanced(weights.weights, weights.weights.position - middle)
    arm = axial.value - middle
    return shaken(ShakingCouples, frame, running, frames, crank_angle, speed, arm=arm, balanced=balanced)


@record
class RollingMoment(StageResult):
    """What rolls the frame about the crankshaft: gas, inertia and weights, without and with balance weights."""

    rolling_moment: Array = quantity(
        "M_roll",
        "N*m",
        _CURVE,
        N_("Moment on the frame about the crankshaft, in the sense of rotation"),
        _THEORY,
        "16.16",
    )


def rolling_moment(
    frame: FrameForces | None,
    running: RunningFrame | None,
    frames: Frames,
    centres: ShaftCentres,
    loaded: LoadedMachine,
    solved: SolvedCycle,
    torques: MechanismTorques,
    crank_angle: CrankAngle,
    weights: BalanceWeights | None,
) -> RollingMoment:
    """Take what drives the shaft less what the moving parts keep of it, and the forces of shafts beside `main`.

    The frame holds the gears between shafts; what drives or is driven is on `main`. docs/theory/balance, eq. (16.16).
    """
    centre = running_axes(centres.value, clockwise=frames.clockwise)[..., np.newaxis]
    drive = Drive(*(part[:, 0] for part in loaded.speed.drive(crank_angle.angle)))
    without = torques.from_mechanisms
    if running is not None:
        without = without + _roll_of_masses(running, centre)
    elif frame is not None:
        turns = round(crank_angle.cycle / (2 * np.pi))
        without = without + drive.speed**2 * np.tile(_roll_of_masses(frame, centre), turns)
    if any(np.any(made.gravity) for made in loaded.masses.batches):
        without = without + _weights_moment(loaded, solved, frames, centres)
    curves = [without]
    if weights is not None:
        roll = weight_roll(weights.weights, weight_orders(weights.weights))
        lagging = from_vectors(roll.order, roll.vectors / (1j * roll.order))
        angle = crank_angle.angle[:, 0]
        turning = curve(roll, angle) * drive.speed**2 + curve(lagging, angle) * drive.acceleration
        curves.append(without + turning)
    return RollingMoment(np.stack(curves, axis=1), labels={"balance": BALANCE[: len(curves)]})


def _roll_of_masses(of: FrameForces | RunningFrame, centre: ComplexArray) -> Array:
    """Moment of the inertia of all parts about the main shaft on the grid, shape (design, n)."""
    return np.sum(of.moment + np.imag(np.conj(centre) * of.force), axis=1)[..., :: of.step]


def _weights_moment(loaded: LoadedMachine, solved: SolvedCycle, frames: Frames, centres: ShaftCentres) -> Array:
    """Moment of the weights of all moving parts about the main shaft, in the sense of rotation. [N·m]"""
    total = np.zeros(())
    for batch, made, one in zip(loaded.mechanisms.batches, loaded.masses.batches, solved.batches, strict=True):
        links = batch.kind.dynamics.links(one.motion, batch.members.geometry)
        for link, body in zip(links, tuple(made.bodies), strict=True):
            own = weight(link, body, made.gravity)
            moment = own.moment + link.origin.x.value * own.y - link.origin.y.value * own.x
            force = frames.common(batch.index, own.x, own.y)
            centre = running_axes(centres.value[:, batch.index], clockwise=frames.clockwise)[..., np.newaxis]
            about_main = frames.sense[batch.index, np.newaxis] * moment + np.imag(np.conj(centre) * force)
            total = total + np.sum(about_main, axis=1)
    return total
