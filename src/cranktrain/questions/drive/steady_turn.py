"""A machine, its motor and its gearing as they turn forward: the cycle that repeats itself."""

from typing import NamedTuple

import numpy as np

from cranktrain.motion import ONE, Array
from cranktrain.questions.drive.at_angles import ReducedAt, reduced_at
from cranktrain.questions.drive.gear_train import Passed, through_stages, torque_through
from cranktrain.questions.drive.motor_tables import DeclaredMotor
from cranktrain.questions.drive.motors.servo import SERVO
from cranktrain.questions.drive.reduction import ReducedMachines
from cranktrain.questions.drive.running.gearing import Gearing, overall_ratio, turning_inertia
from cranktrain.questions.drive.running.reduced import ReducedMachine
from cranktrain.questions.drive.steady_cycle import (
    CyclePieces,
    SpeedOverTurn,
    largest_over_turn,
    mesh_of,
    speed_over_turn,
)
from cranktrain.questions.evenness.speed_law import Power

_MOST_MESHES = 4
_N_SPEEDS = 400
_N_ANGLES = 96
"""At which the first guess of the speed looks: the cycle itself does not hang on them."""
_SLOWEST = 0.02
"""Of the motor's top speed: slower it counts as stalled."""
_FASTEST = 1e5
"""Of a motor without a top speed: no crank turns so fast. [rad/s]"""
_NONE = np.empty(0)
NOWHERE = ReducedAt(_NONE, _NONE, _NONE, (), _NONE)


class DriveInTurn(NamedTuple):
    """One design's machine, motor and gearing, as it turns forward; `here` is the machine at some crank angles.

    `is_held`: a servo motor holds the speed that is declared, and gives what torque that takes.
    """

    machine: ReducedMachine
    motor: DeclaredMotor
    design: int
    gearing: Gearing
    here: ReducedAt = NOWHERE
    is_held: bool = False

    def motor_torque(self, speed: Array) -> Array:
        """At the motor, by speeds of the crank, shape (n,). [N·m]"""
        if self.is_held:
            return torque_through(self.here.taken(speed), ONE, self.gearing)[0]
        at_motor = speed * overall_ratio(self.gearing)
        return self.motor.torque(np.broadcast_to(at_motor, (self.motor.n_designs, *speed.shape)))[self.design]

    def largest_torque(self, found: SpeedOverTurn, sign: float = 1.0) -> float:
        """Largest torque of the motor over a cycle; of the other sign the smallest, by amount below 0. [N·m]"""
        return largest_over_turn(found, lambda angle, speed: sign * self.torque_at(angle, speed))

    def torque_at(self, angle: Array, speed: Array) -> Array:
        """At the motor, by crank angles and speeds of the crank, shape (n,); angles count where it is held. [N·m]"""
        return (self.at(angle) if self.is_held else self).motor_torque(speed)

    def heat(self, speed: Array) -> Array:
        """Power that heats the motor, by speeds of the crank, shape (n,). [W]"""
        at_motor = speed * overall_ratio(self.gearing)
        return self.motor.heating(np.broadcast_to(at_motor, (self.motor.n_designs, *speed.shape)))[self.design]

    def passed(self, speed: Array) -> Passed:
        """Acceleration of the crank, and torque at the output of every stage."""
        taken = self.here.taken(speed)
        return through_stages(self.motor_torque(speed), self.here.inertia, taken, self.gearing)

    def at(self, angle: Array) -> "DriveInTurn":
        """The same at other crank angles, shape (n,). [rad]"""
        return self._replace(here=reduced_at(self.machine, angle))


def holds_speed(motor: DeclaredMotor, design: int) -> bool:
    """Whether a motor gives what torque its speed takes: a servo of which no torque is asked for."""
    return motor.motor is SERVO and bool(motor.numbers.command[design] >= motor.numbers.peak_torque[design])


def settled(
    turning: DriveInTurn, machines: ReducedMachines, held: float | None = None
) -> tuple[DriveInTurn, SpeedOverTurn | None]:
    """Steady cycle on pieces that end where loads have corners, and losses too; with the drive there.

    Parameters
    ----------
    turning : DriveInTurn
    machines : ReducedMachines
    held : float, optional
        Speed of the crank that a servo motor holds. [rad/s]
    """
    corners = machines.corners[min(turning.design, len(machines.corners) - 1)]
    mesh = mesh_of(machines.cycle, corners)
    turning = turning.at(mesh.nodes)
    if turning.is_held:
        return turning, None if held is None else _constant(mesh, held)
    first = balanced_speed(turning, machines.cycle)
    found = None if first is None else _cycle(turning, mesh, first)
    for _again in range(_MOST_MESHES - 1):
        if found is None:
            break
        kinks = _kinks(turning, found)
        if kinks.size == 0:
            break
        mesh = mesh_of(machines.cycle, np.concatenate([corners, kinks]))
        turning = turning.at(mesh.nodes)
        found = _cycle(turning, mesh, found.at(mesh.nodes))
    return turning, found


def _constant(mesh: CyclePieces, speed: float) -> SpeedOverTurn:
    """A cycle at one speed."""
    at_nodes = np.full(mesh.nodes.shape, 0.5 * speed * speed)
    return SpeedOverTurn(mesh, at_nodes, np.full(mesh.start.shape, 0.5 * speed * speed), 0.0 * at_nodes, 0.0)


def _cycle(turning: DriveInTurn, mesh: CyclePieces, first: float | Array) -> SpeedOverTurn | None:
    """Steady cycle near a constant speed, or speeds at the nodes."""
    return speed_over_turn(lambda speed: turning.passed(speed).acceleration, mesh, first)


def balanced_speed(turning: DriveInTurn, cycle: float) -> float | None:
    """Highest constant speed of the crank at which the mean acceleration falls through 0; None without one.

    Parameters
    ----------
    turning : DriveInTurn
    cycle : float
        [rad]

    Returns
    -------
    float or None
        [rad/s] Where the motor has neither a top speed nor a rated point, speeds are looked at upward until its torque
        falls below the load.
    """
    there = turning.at((np.arange(_N_ANGLES) + 0.5) * cycle / _N_ANGLES)
    speeds = np.linspace(_SLOWEST, 1.3, _N_SPEEDS) * _top(there)
    means = _mean_work(there, speeds)
    falls = np.flatnonzero((means[:-1] > 0) & (means[1:] <= 0))
    if falls.size == 0:
        return None
    low = falls[-1]
    return float(speeds[low] + (speeds[low + 1] - speeds[low]) * means[low] / (means[low] - means[low + 1]))


def _top(turning: DriveInTurn) -> float:
    """Speed of the crank above which the motor drives no more, or not against this load. [rad/s]"""
    highest = turning.motor.highest_speed(turning.design)
    if np.isfinite(highest):
        return highest / overall_ratio(turning.gearing)
    speeds: Array = np.geomspace(1.0, _FASTEST, 18)
    drives = np.flatnonzero(_mean_work(turning, speeds) > 0)
    return float(speeds[min(drives[-1] + 1, speeds.size - 1)]) if drives.size else 1.0


def _mean_work(turning: DriveInTurn, speeds: Array) -> Array:
    """Mean over the cycle of what drives the crank at constant speeds, less what holds it, shape (n,). [N·m]"""
    here, n = turning.here, speeds.size
    powers = tuple(Power(np.tile(one.coefficient, n), one.exponent) for one in here.powers)
    inertia, slope, load, output = (np.tile(each, n) for each in (here.inertia, here.slope, here.load, here.output))
    along = ReducedAt(inertia, slope, load, powers, output)
    work = _work(turning._replace(here=along), np.repeat(speeds, here.load.size))
    return np.mean(work.reshape(n, -1), axis=1)


def _work(turning: DriveInTurn, speed: Array) -> Array:
    """What drives the crank at a constant speed, less what holds it: what inertia would take. [N·m]"""
    whole = turning.here.inertia + turning_inertia(turning.gearing)
    return whole * turning.passed(speed).acceleration + 0.5 * turning.here.slope * speed**2


def _kinks(turning: DriveInTurn, found: SpeedOverTurn) -> Array:
    """Crank angles at which a stage's torque changes its sign: there the losses have a kink. [rad]"""
    outputs, nodes = turning.passed(found.speed).outputs, found.mesh.nodes
    row, place = np.nonzero(np.sign(outputs[:, :-1]) * np.sign(outputs[:, 1:]) < 0)
    low, high = outputs[row, place], outputs[row, place + 1]
    return nodes[place] + (nodes[place + 1] - nodes[place]) * low / (low - high)
