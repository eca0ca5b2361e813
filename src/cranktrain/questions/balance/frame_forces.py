"""What the frame bears of the moving masses, at a constant speed and at one that varies over the cycle."""

from collections.abc import Sequence
from dataclasses import replace
from functools import reduce
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.language import _
from cranktrain.layout.crank_angle import HIGHEST_ORDER, CrankAngle
from cranktrain.layout.frames import Frames
from cranktrain.layout.masses import Masses
from cranktrain.layout.mechanisms import Mechanisms
from cranktrain.layout.shafts import Throws
from cranktrain.layout.speed import Speed, SpeedCurve
from cranktrain.linkage.forces import WEIGHTLESS, Drive, Momentum, Wrench, momentum
from cranktrain.mechanisms.dynamics import FRAME
from cranktrain.mechanisms.kind import AnyMotion
from cranktrain.motion import ZERO, Array
from cranktrain.numerics import has_ended, spectral_derivative, turn_grid
from cranktrain.numerics.harmonics import ComplexArray
from cranktrain.numerics.periodic import cycle_grid
from cranktrain.numerics.plane_vectors import PlaneVectors, curve_vectors, delayed_vectors
from cranktrain.questions.forces.carriers import Carriers
from cranktrain.questions.forces.forces_times_arms import largest_in_joints
from cranktrain.questions.forces.loaded_machine import LoadedMachine, SolvedBatch
from cranktrain.record import record
from cranktrain.saying.checks import Check, Checked

_LIMIT = 1e-11
_FEWEST, _MOST = 360, 2880
_ENDED = 1e-13
"""What the highest orders may have of the largest order, for the grid to show all that there is."""


@record
class FrameForces(Checked):
    """What the moving masses do to the frame, for each (rad/s)²; in the common axes of `Frames`, over one turn.

    Attributes
    ----------
    force : complex, shape (design, mechanism, n)
        On the frame, by the bearings, guides and pivots of each mechanism. [kg·m]
    moment : Array, shape (design, mechanism, n)
        By the inertia of each mechanism's own parts about their shaft's centre, as `main` runs. [kg·m²]
    step : int
        How many of these points make a step of the grid of crank angles, on whose first point they begin.
    vectors : PlaneVectors, shape (design, mechanism, order)
        Of `force`, from order 0; phases count from φ = 0.
    own : PlaneVectors, shape (design, mechanism, order)
        The same of each mechanism's own parts, wherever the frame bears them: a slave's are borne by its master.
    """

    force: ComplexArray
    moment: Array
    step: int
    vectors: PlaneVectors
    own: PlaneVectors


class Momenta(NamedTuple):
    """Momentum in the common axes and its moment, for each rad/s, shape (design, mechanism, n)."""

    vector: ComplexArray
    moment: Array


def frame_forces(
    mechanisms: Mechanisms,
    carriers: Carriers,
    masses: Masses,
    frames: Frames,
    throws: Throws,
    crank_angle: CrankAngle,
) -> FrameForces:
    """Solve the machine with its masses alone, at 1 rad/s: no gas, weight or friction.

    The points are doubled until they show all orders of the momentum; the force of each throw is then compared with
    its momentum's derivative, which shares with the reactions but the motion. docs/theory/balance, eq. (16.15).
    """
    # Inertia repeats with the turn, as all shafts turn as fast as `main`.
    n_turn = round(crank_angle.shown.size * 2 * np.pi / crank_angle.cycle)
    step = -(-_FEWEST // n_turn)
    machine = LoadedMachine(mechanisms, carriers, _without_loads(masses), None, None, Speed(np.ones((1, 1, 1))))
    while True:
        angle = turn_grid(n_turn * step) + crank_angle.zero
        motions = machine.motions(angle)
        found = _momenta(machine, motions, frames)
        own = -_derivative(found.vector)
        ended = has_ended(own, _ENDED)
        if n_turn * step >= _MOST or np.all(ended):
            break
        step *= 2
    solved = machine.solved(angle, motions=motions)
    force = _force_on_frame(machine, solved, frames, found.vector.shape)
    zero = crank_angle.zero[:, 0]
    return FrameForces(
        force=force,
        moment=-spectral_derivative(found.moment),
        step=step,
        vectors=delayed_vectors(curve_vectors(force.real, force.imag, HIGHEST_ORDER), zero),
        own=delayed_vectors(curve_vectors(own.real, own.imag, HIGHEST_ORDER), zero),
        checks=(
            _momentum_check(
                "momentum",
                throws.gathered(force),
                throws.gathered(own),
                largest_in_joints(machine, solved),
                ended,
            ),
        ),
    )


def _without_loads(masses: Masses) -> Masses:
    """Masses that nothing weighs on and that nothing rubs."""
    batches = tuple(
        batch._replace(gravity=WEIGHTLESS, friction=tuple(ZERO for _slider in batch.friction))
        for batch in masses.batches
    )
    return replace(masses, batches=batches)


def _momenta(machine: LoadedMachine, motions: Sequence[AnyMotion], frames: Frames) -> Momenta:
    """Add up the links of every mechanism."""
    parts: list[Momenta] = []
    for batch, made, motion in zip(machine.mechanisms.batches, machine.masses.batches, motions, strict=True):
        links = batch.kind.dynamics.links(motion, batch.members.geometry)
        total = reduce(lambda one, other: Momentum(*map(np.add, one, other)), map(momentum, links, tuple(made.bodies)))
        vector = frames.common(batch.index, total.x, total.y)
        parts.append(Momenta(vector, frames.sense[batch.index, np.newaxis] * total.moment))
    return Momenta(*map(machine.in_order, zip(*parts, strict=True)))


def _derivative(vector: ComplexArray) -> ComplexArray:
    """Derivative by the crank angle of a vector x + iy over one turn."""
    return spectral_derivative(vector.real) + 1j * spectral_derivative(vector.imag)


def _force_on_frame(
    machine: LoadedMachine, solved: Sequence[SolvedBatch], frames: Frames, shape: tuple[int, ...]
) -> ComplexArray:
    """Force of every mechanism on what stands still."""
    force = np.zeros(shape, dtype=np.complex128)
    for batch, one in zip(machine.mechanisms.batches, solved, strict=True):
        dynamics = batch.kind.dynamics
        for reaction, joint in zip(dynamics.reactions, one.forces.joints, strict=True):
            # A slave's share of its master's joints is in its master's own.
            if reaction.by == FRAME and reaction.on in dynamics.moving:
                borne: Wrench = joint
                force[:, batch.index] -= frames.common(batch.index, borne.x, borne.y)
    return force


def _momentum_check(
    name: str, force: ComplexArray, momentum_lost: ComplexArray, in_joints: Array, ended: NDArray[np.bool_]
) -> Check:
    """Compare the throws' forces with what their momentum says, by a series that may have ended, for each design."""
    scale = np.max(np.abs(force), axis=(-2, -1)) + np.max(in_joints, axis=-1)
    residual = np.max(np.abs(force - momentum_lost), axis=(-2, -1)) / np.where(scale == 0, 1.0, scale)
    return Check(
        name,
        _("Inertia forces on the frame against the change of momentum of all parts, relative to the joints' largest"),
        np.where((residual > _LIMIT) & ~np.all(ended, axis=(-2, -1)), np.inf, residual),
        _LIMIT,
    )


@record
class RunningFrame(Checked):
    """As `FrameForces`, in newtons and over the whole cycle.

    Attributes
    ----------
    force : complex, shape (design, mechanism, n)
        On the frame, by the bearings, guides and pivots of each mechanism. [N]
    moment : Array, shape (design, mechanism, n)
        By the inertia of each mechanism's own parts about their shaft's centre, as `main` runs. [N·m]
    angle : Array, shape (design, n)
        φ. [rad]
    drive : Drive, arrays of shape (design, n)
        Speed and acceleration there.
    step : int
        How many of these points make a step of the grid of crank angles, on whose first point they begin.
    """

    force: ComplexArray
    moment: Array
    angle: Array
    drive: Drive
    step: int


def running_frame(
    curve: SpeedCurve,
    mechanisms: Mechanisms,
    carriers: Carriers,
    masses: Masses,
    frames: Frames,
    throws: Throws,
    frame: FrameForces,
    crank_angle: CrankAngle,
) -> RunningFrame:
    """Solve the machine with its masses alone, at the speed and acceleration of each crank angle.

    The force of each throw is compared with p′ω² + pε, in which the momentum p for each rad/s knows no reaction.
    docs/theory/balance, eq. (16.15); docs/theory/evenness, eq. (17.20).
    """
    n_points = crank_angle.shown.size * frame.step
    angle = cycle_grid(n_points, crank_angle.cycle) + crank_angle.zero
    bare = LoadedMachine(mechanisms, carriers, _without_loads(masses), None, None, Speed(curve.mean, curve))
    shape = (len(angle), len(mechanisms.names), n_points)
    solved = bare.solved(angle)
    force = _force_on_frame(bare, solved, frames, shape)
    turns = round(crank_angle.cycle / (2 * np.pi))
    turn = turn_grid(n_points // turns) + crank_angle.zero
    per_speed = _momenta(bare, bare.motions(turn), frames)
    slope = Momenta(_derivative(per_speed.vector), spectral_derivative(per_speed.moment))
    ended = has_ended(slope.vector, _ENDED)
    drive = curve.drive(angle)

    square = drive.speed**2
    own = -(square * np.tile(slope.vector, turns) + drive.acceleration * np.tile(per_speed.vector, turns))
    moment = -(square * np.tile(slope.moment, turns) + drive.acceleration * np.tile(per_speed.moment, turns))
    return RunningFrame(
        force=force,
        moment=moment,
        angle=angle[:, 0],
        drive=Drive(*(part[:, 0] for part in drive)),
        step=frame.step,
        checks=(
            _momentum_check(
                "running_momentum",
                throws.gathered(force),
                throws.gathered(own),
                largest_in_joints(bare, solved),
                ended,
            ),
        ),
    )
