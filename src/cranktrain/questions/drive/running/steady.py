"""The steady cycle, in the angle form: the energy with which a turn ends as it began."""

from functools import cache
from typing import Any

import numpy as np

from cranktrain.motion import Array
from cranktrain.numerics.roots import bracketed_roots
from cranktrain.questions.drive.running.compiling import quick
from cranktrain.questions.drive.running.equation import DriveTrain, Kernels, joined
from cranktrain.questions.drive.running.gearing import turning_inertia
from cranktrain.questions.drive.running.step import error_of, take_step
from cranktrain.record import record

_TOLERANCE = 1e-12
_MOST_STEPS = 100_000


@record
class SteadyCycle:
    """A cycle that repeats itself.

    Attributes
    ----------
    angle : Array, shape (n,)
        From the start of the cycle to its end. [rad]
    speed : Array, shape (n,)
        Of the crank. [rad/s]
    period : float
        [s]
    mean_torque, rms_torque : float
        Of the motor, over the time. [N·m]
    residual : float
        Energy at the end less that at the start. [J]
    """

    angle: Array
    speed: Array
    period: float
    mean_torque: float
    rms_torque: float
    residual: float

    @property
    def mean_speed(self) -> float:
        """Over the time. [rad/s]"""
        return float((self.angle[-1] - self.angle[0]) / self.period)

    @property
    def fluctuation(self) -> float:
        """Largest less least speed over the mean. [1]"""
        return float(np.ptp(self.speed) / self.mean_speed)


def steady_cycle(
    kernels: Kernels, drive: DriveTrain, slowest: float, fastest: float, *, cycle: float = 2 * np.pi, n: int = 721,
    is_compiled: bool = True,
) -> SteadyCycle | None:  # fmt: skip
    """Find the steady cycle whose speed at crank angle 0 lies between two.

    Parameters
    ----------
    kernels : Kernels
        Of a motor that does not depend on the time.
    drive : DriveTrain
    slowest, fastest : float
        Above 0. [rad/s]
    cycle : float, optional
        [rad]
    n : int, optional
        Of the angles at which the speed is given.
    is_compiled : bool, optional

    Returns
    -------
    SteadyCycle or None
        None where there is no such cycle: the motor stalls within the turn, or the speeds do not bracket it.

    Notes
    -----
    docs/theory/transient, eq. (26.13).
    """
    walk = _walk(kernels, is_compiled)
    turning = turning_inertia(drive.gearing)
    at_start = kernels_inertia(kernels, drive, is_compiled) + turning
    angles = np.linspace(0.0, cycle, n)

    def gained(energies: Array) -> Array:
        return np.array([walk(drive, turning, float(energy), angles[[0, -1]])[-1, 0] - energy for energy in energies])

    ends = [np.array([0.5 * at_start * speed**2]) for speed in (slowest, fastest)]
    energy = float(bracketed_roots(gained, *ends)[0])
    if np.isnan(energy):
        return None
    table = walk(drive, turning, energy, angles)
    period = float(table[-1, 1])
    return SteadyCycle(
        angles,
        table[:, 4],
        period,
        float(table[-1, 2]) / period,
        float(np.sqrt(table[-1, 3] / period)),
        float(table[-1, 0] - energy),
    )


def kernels_inertia(kernels: Kernels, drive: DriveTrain, is_compiled: bool) -> float:
    """Reduced inertia at crank angle 0, of the machine alone. [kg·m²]"""
    return float(joined(kernels, is_compiled).kernels.machine(0.0, 1.0, 1.0, drive.machine)[0])


@cache
def _walk(kernels: Kernels, is_compiled: bool) -> Any:
    """Walk over given angles: energy, time, ∫M dt, ∫M² dt and speed at each; energy −1 where it stalls."""
    parts = joined(kernels, is_compiled)
    in_time, machine = parts.derive, parts.kernels.machine

    def derive(angle: float, state: Array, slopes: Array, sense: float, parts: Any) -> int:
        drive, turning, by_time, own = parts
        inertia = machine(angle, 0.0, sense, drive.machine)[0]
        speed = np.sqrt(2.0 * state[0] / (inertia + turning))
        own[0], own[1] = angle, speed
        trouble = in_time(0.0, own, by_time, sense, drive)
        torque = by_time[2] / speed
        slopes[0] = (by_time[2] - by_time[3] - by_time[4]) / speed
        slopes[1] = 1.0 / speed
        slopes[2] = _at_motor(torque, drive) / speed
        slopes[3] = _at_motor(torque, drive) ** 2 / speed
        return trouble

    def walk(drive: DriveTrain, turning: float, energy: float, angles: Array) -> Array:
        state, ahead, slopes = np.zeros(4), np.zeros(4), np.zeros((7, 4))
        own = (drive, turning, np.zeros(6), np.zeros(6))
        table = np.zeros((len(angles), 5))
        state[0] = energy
        angle, width, n_steps = angles[0], 1e-3, 0
        derive_here(angle, state, slopes[0], 1.0, own)
        table[0, 0] = energy
        table[0, 4] = slopes[0, 1]
        for at in range(1, len(angles)):
            while angle < angles[at]:
                n_steps += 1
                is_last = angle + width >= angles[at]
                step = angles[at] - angle if is_last else width
                trouble = take(derive_here, angle, step, state, slopes, 1, ahead, 1.0, own)
                error = error_in(slopes, step, 0) / (_TOLERANCE * abs(energy))
                if trouble != 0 or not error <= 1.0:
                    width = step * (max(0.1, 0.9 * error**-0.2) if error > 1.0 else 0.1)
                    if width < 1e-12 or n_steps > _MOST_STEPS:
                        table[-1, 0] = -1.0
                        return table
                    continue
                angle = angles[at] if is_last else angle + step
                state[:] = ahead
                slopes[0] = slopes[6]
                if not is_last or error > 1e-3:
                    width = step * min(5.0, 0.9 * max(error, 1e-10) ** -0.2)
            table[at, :4] = state
            table[at, 4] = 1.0 / slopes[0, 1]
        table[0, 4] = 1.0 / table[0, 4]
        return table

    derive_here, take, error_in = (quick(derive), quick(take_step), quick(error_of)) if is_compiled else (
        derive, take_step, error_of,
    )  # fmt: skip
    return quick(walk) if is_compiled else walk


def _at_motor(torque: float, drive: DriveTrain) -> float:
    """Torque at the motor of one at the crank without loss."""
    overall = 1.0
    for ratio in drive.gearing.ratio:
        overall *= ratio
    return torque / overall
