"""Stiff motors: the same run by an implicit method of SciPy, chosen by the motor's slip time constant."""

from collections.abc import Callable
from typing import Any, cast

import numpy as np

from cranktrain.motion import Array
from cranktrain.questions.drive.running import transient
from cranktrain.questions.drive.running.equation import N_STATE, OPEN, DriveTrain, Kernels, joined
from cranktrain.questions.drive.running.gearing import overall_ratio, turning_inertia
from cranktrain.questions.drive.running.runs import Event, Run, Wanted, energy_account, run
from cranktrain.questions.drive.running.transient import let_go_at, sense_of_start

_STIFF = 1e-3
"""Slip time constant in parts of a turn, below which explicit steps are far shorter than the motion asks for."""
_N_SPEEDS = 2001
_CLOSER = 1e-3
"""LSODA and Radau err by much more than their tolerance over a run."""


def slip_time_constant(
    kernels: Kernels, drive: DriveTrain, top_speed: float, angles: Array, time: float = 0.0
) -> float:
    """Shortest time in which the motor's steepest fall brings its speed back. [s]

    Parameters
    ----------
    kernels : Kernels
        Not compiled: of the motor plain Python is called.
    drive : DriveTrain
    top_speed : float
        Of the motor: where it drives no more, or a little beyond. [rad/s]
    angles : Array
        Over which the least inertia is looked for. [rad]
    time : float, optional
        [s]

    Returns
    -------
    float
        (J_m + J/i²)/max(−dM/dω); of Kloss's formula (J_m + J/i²) ω_s s_b/(2 M_b). docs/theory/transient, eq. (26.14).
    """
    speeds = np.linspace(0.0, top_speed, _N_SPEEDS)
    torques = np.array([kernels.motor(float(speed), time, drive.motor) for speed in speeds])
    steepest = float(np.max(-np.diff(torques) / np.diff(speeds)))
    least = min(kernels.machine(float(angle), 0.0, 1.0, drive.machine)[0] for angle in angles)
    whole = (turning_inertia(drive.gearing) + least) / overall_ratio(drive.gearing) ** 2
    return whole / steepest if steepest > 0 else np.inf


def is_stiff(time_constant: float, crank_speed: float) -> bool:
    """Whether a motor is too fast for an explicit method at a crank speed. [s, rad/s]"""
    return time_constant < _STIFF * 2 * np.pi / crank_speed


def run_well(kernels: Kernels, drive: DriveTrain, asked: Wanted, top_speed: float) -> Run:
    """Run by the method that suits the motor: explicit, or LSODA where it is stiff."""
    angles = np.linspace(0.0, 2 * np.pi, 61)
    constant = slip_time_constant(kernels, drive, top_speed, angles)
    if is_stiff(constant, top_speed / overall_ratio(drive.gearing)):
        return run_implicitly(kernels, drive, asked)
    return run(kernels, drive, asked)


def run_implicitly(kernels: Kernels, drive: DriveTrain, asked: Wanted, *, method: str = "LSODA") -> Run:
    """Run as `runs.run` does, by `solve_ivp` of SciPy with LSODA or Radau; phases, events and reasons are the same.

    Raises
    ------
    ImportError
        Where SciPy is not installed.
    """
    derive, own = parts = joined(kernels, True)
    limits, state, time = asked.limits, asked.start.copy(), 0.0
    table, events = np.full((len(asked.samples), N_STATE), np.nan), list[Event]()
    sense, n_calls, n_reversals = float(np.sign(state[1])), 0, 0
    reason = transient.TIME_OUT
    while time < limits.end_time:
        if sense == 0.0:
            sense = sense_of_start(time, state[0], own, drive)
        if sense == 0.0:
            events.append(Event(transient.HELD, time, float(state[0]), 0.0))
            at = let_go_at(time, limits.end_time, state[0], own, drive) if limits.is_timed else np.inf
            _fill(
                table,
                asked.samples,
                time,
                min(at, limits.end_time),
                _held(state),
            )
            if at == np.inf:
                reason = transient.STALLED if abs(own.motor(0.0, time, drive.motor)) > 0 else transient.AT_REST
                break
            events.append(Event(transient.SET_OFF, at, float(state[0]), 0.0))
            state[5] += own.heat(0.0, time, drive.motor) * (at - time)
            time = at
            continue
        later = asked.breaks[asked.breaks > time]
        until = min(limits.end_time, float(later[0]) if len(later) else np.inf)
        slopes = np.zeros(N_STATE)
        trouble = derive(time, state, slopes, sense, drive)
        if trouble:
            reason = transient.LINKS_OPEN if trouble == OPEN else transient.GEARING_JAMS
            break
        found = _phase(parts, drive, limits, sense, (time, until), state, method)
        n_calls += found.nfev
        stopped, passed, over, dead = found.t_events
        events += [
            Event(kind, float(when), float(y[0]), float(y[1]))
            for kind, times, states in (
                (transient.REVERSAL, stopped, found.y_events[0]),
                (transient.SPEED_PASSED, passed, found.y_events[1]),
                (transient.DEAD_POSITION, dead, found.y_events[3]),
            )
            for when, y in zip(times, states, strict=True)
        ]
        _fill(table, asked.samples, time, found.t[-1], found.sol)
        time, state = float(found.t[-1]), found.y[:, -1].copy()
        if len(over):
            reason = transient.OVERSPEED
            break
        if len(passed) and limits.stops_at_target:
            reason = transient.SPEED_REACHED
            break
        if len(stopped):
            state[1], sense, n_reversals = 0.0, 0.0, n_reversals + 1
            if n_reversals >= limits.most_reversals:
                reason = transient.SWINGS
                break
        elif time < until:
            reason = transient.TOO_MANY_STEPS
            break
    is_there = ~np.isnan(table[:, 0])
    residual, supplied = energy_account(parts, drive, asked.start, state)
    in_order = tuple(sorted(events, key=lambda one: one.time))
    return Run(
        reason, time, state, asked.samples[is_there], table[is_there], in_order, residual, supplied, n_calls, method
    )


def _phase(
    parts: Any, drive: DriveTrain, limits: Any, sense: float, span: tuple[float, float], state: Array, method: str
) -> Any:
    """Integrate with the sense as it is, to the end of the span or an event that ends the phase."""
    from scipy import integrate

    def slope(time: float, state: Array) -> Array:
        slopes = np.empty(N_STATE)
        parts.derive(time, np.ascontiguousarray(state), slopes, sense, drive)
        return slopes

    def stopped(_time: float, state: Array) -> float:
        return sense * state[1]

    def passed(_time: float, state: Array) -> float:
        return sense * state[1] - min(limits.target_speed, 1e300)

    def over(_time: float, state: Array) -> float:
        return sense * state[1] - min(limits.overspeed, 1e300)

    def dead(_time: float, state: Array) -> float:
        return parts.kernels.machine(state[0], state[1], sense, drive.machine)[3]

    stopped.terminal, stopped.direction = True, -1.0  # pyright: ignore[reportFunctionMemberAccess]
    passed.terminal, passed.direction = limits.stops_at_target, 1.0  # pyright: ignore[reportFunctionMemberAccess]
    over.terminal, over.direction = True, 1.0  # pyright: ignore[reportFunctionMemberAccess]
    solve: Any = cast(Any, integrate).solve_ivp
    return solve(
        slope,
        span,
        state,
        method=method,
        rtol=max(_CLOSER * limits.tolerance, 3e-14),
        atol=_CLOSER * limits.tolerance,
        max_step=0.02 * limits.end_time,
        dense_output=True,
        events=(stopped, passed, over, dead),
    )


def _held(state: Array) -> Callable[[Array], Array]:
    """Give the same state at all times."""
    return lambda times: np.tile(state[:, np.newaxis], times.size)


def _fill(table: Array, samples: Array, start: float, end: float, at: Any) -> None:
    """Fill the rows of the samples of a phase."""
    rows = (samples >= start) & (samples <= end)
    if np.any(rows):
        table[rows] = at(samples[rows]).T
