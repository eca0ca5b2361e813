"""The steady cycle, in the angle form: the energy with which a turn ends as it began."""

from functools import cache
from typing import Any

import numpy as np

from cranktrain.motion import Array
from cranktrain.numerics.roots import bracketed_roots
from cranktrain.record import record
from cranktrain.transient.compiling import kept, quick
from cranktrain.transient.equation import DriveTrain, Kernels, TrainNumbers, joined, train_of
from cranktrain.transient.gearing import turning_inertia
from cranktrain.transient.step import N_STATE, ROW, Derive, error_of, integrate_along, take_step

_TOLERANCE = 1e-12
_MOST_STEPS = 100_000
_LEAST_WIDTH = 1e-12


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
    docs/theory/transient, eq. (26.16).
    """
    walk = _walk(kernels, is_compiled)
    turning = turning_inertia(drive.gearing)
    train = train_of(drive, kernels, is_compiled=True)
    at_start = kernels_inertia(kernels, drive, is_compiled) + turning
    angles = np.linspace(0.0, cycle, n)

    def walked(energy: float, angles: Array) -> Array:
        table = np.zeros((len(angles), 5))
        walk(train, turning, energy, angles, table, *np.zeros((2, N_STATE)), np.zeros(7 * ROW), np.zeros(ROW))
        return table

    def gained(energies: Array) -> Array:
        return np.array([walked(float(energy), angles[[0, -1]])[-1, 0] - energy for energy in energies])

    ends = [np.array([0.5 * at_start * speed**2]) for speed in (slowest, fastest)]
    energy = float(bracketed_roots(gained, *ends)[0])
    if np.isnan(energy):
        return None
    table = walked(energy, angles)
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
    """Walk over given angles: fills a table of energy, −1 where it stalls, time, ∫M dt, ∫M² dt and speed at each."""
    own = joined(kernels, is_compiled)
    in_time, machine = own.derive, own.kernels.machine

    def derive(
        angle: float, energy: float, _time: float, sense: float, bound: float, slopes: Any, place: int, parts: Any
    ) -> tuple[float, float]:
        train, turning, by_time = parts
        inertia = machine(angle, 0.0, sense, train.machine)[0]
        speed = np.sqrt(2.0 * energy / (inertia + turning))
        in_time(0.0, angle, speed, sense, bound, by_time, 0 * ROW, train)
        at_motor = by_time[2] / speed / train.one.ratio
        slopes[place] = (by_time[2] - by_time[3] - by_time[4]) / speed
        slopes[place + 1] = 1.0 / speed
        slopes[place + 2] = at_motor / speed
        slopes[place + 3] = at_motor * at_motor / speed
        return slopes[place], slopes[place + 1]

    def walk(
        train: TrainNumbers, turning: float, energy: float, angles: Array,
        table: Array, state: Array, ahead: Array, slopes: Array, by_time: Array,
    ) -> None:  # fmt: skip
        parts = (train, turning, by_time)
        state[0] = energy
        width = 1e-3
        derive_here(angles[0], energy, 0.0, 1.0, np.inf, slopes, 0 * ROW, parts)
        for at in range(len(angles)):
            if at > 0:
                width = walk_to(derive_here, angles[at - 1], angles[at], width, state, ahead, slopes, parts)
            if width <= 0:
                table[-1, 0] = -1.0
                return
            for part in range(4):
                table[at, part] = state[part]
            table[at, 4] = 1.0 / slopes[1]

    derive_here, walk_to = (
        (quick(derive, within=True), quick(_walk_to, within=True)) if is_compiled else (derive, _walk_to)
    )
    return kept(walk) if is_compiled else walk


def _walk_to(
    derive: Derive, angle: float, end: float, width: float, state: Any, ahead: Any, slopes: Any, parts: Any
) -> float:
    """Go from one angle to another; gives the width of the next step, 0 where it stalls."""
    tolerance = _TOLERANCE * abs(state[0])
    for _ in range(_MOST_STEPS):
        is_last = angle + width >= end
        step = end - angle if is_last else width
        take_step(derive, angle, step, state, slopes, ahead, 1.0, np.inf, parts)
        error = error_of(slopes, step, 0) / tolerance
        # the last stage alone would not be seen in the error of all
        if not (error <= 1.0 and slopes[6 * ROW] == slopes[6 * ROW]):
            width = step * (max(0.1, 0.9 * error**-0.2) if error > 1.0 else 0.1)
            if width < _LEAST_WIDTH:
                return 0.0
            continue
        integrate_along(step, state, slopes, ahead)
        for part in range(N_STATE):
            state[part] = ahead[part]
            slopes[part] = slopes[6 * ROW + part]
        if not is_last or error > 1e-3:
            width = step * min(5.0, 0.9 * max(error, 1e-10) ** -0.2)
        if is_last:
            return width
        angle += step
    return 0.0
