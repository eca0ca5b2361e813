"""What the frame bears of the moving masses at a speed that varies over the cycle."""

import numpy as np

from cranktrain.checks import StageResult
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.frames import Frames
from cranktrain.layout.masses import Masses
from cranktrain.layout.mechanisms import Mechanisms
from cranktrain.layout.shafts import Throws
from cranktrain.layout.speed import Speed, SpeedCurve
from cranktrain.linkage.forces import Drive
from cranktrain.motion import Array
from cranktrain.numerics import has_ended, spectral_derivative, turn_grid
from cranktrain.numerics.harmonics import ComplexArray
from cranktrain.numerics.periodic import cycle_grid
from cranktrain.questions.balance.frame_forces import (
    ENDED,
    FrameForces,
    Momenta,
    derivative,
    force_on_frame,
    momenta,
    momentum_check,
    without_loads,
)
from cranktrain.questions.forces.carriers import Carriers
from cranktrain.questions.forces.forces_times_arms import largest_in_joints
from cranktrain.questions.forces.loaded_machine import LoadedMachine
from cranktrain.record import record


@record
class RunningFrame(StageResult):
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
    bare = LoadedMachine(mechanisms, carriers, without_loads(masses), None, None, Speed(curve.mean, curve))
    shape = (len(angle), len(mechanisms.names), n_points)
    solved = bare.solved(angle)
    force = force_on_frame(bare, solved, frames, shape)
    turns = round(crank_angle.cycle / (2 * np.pi))
    turn = turn_grid(n_points // turns) + crank_angle.zero
    per_speed = momenta(bare, bare.motions(turn), frames)
    slope = Momenta(derivative(per_speed.vector), spectral_derivative(per_speed.moment))
    ended = has_ended(slope.vector, ENDED)
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
            momentum_check(
                "running_momentum",
                throws.gathered(force),
                throws.gathered(own),
                largest_in_joints(bare, solved),
                ended,
            ),
        ),
    )
