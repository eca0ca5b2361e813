"""Stiff motors: the same run by an implicit method of SciPy, chosen by the motor's slip time constant."""

import warnings
from collections.abc import Callable
from typing import Any, NamedTuple, cast

import numpy as np

from cranktrain.motion import Array
from cranktrain.transient import endings
from cranktrain.transient.corners import corner_ahead, on_the_way
from cranktrain.transient.endings import GOING
from cranktrain.transient.equation import (
    HEAT,
    DriveTrain,
    Joined,
    Kernels,
    TrainNumbers,
    is_open,
    joined,
    train_of,
)
from cranktrain.transient.gearing import turning_inertia
from cranktrain.transient.rest import (
    HEAT_PANELS,
    heated,
    kind_of_rest,
    let_go_at,
    sense_of_start,
)
from cranktrain.transient.runs import Event, Progress, TransientRun, Wanted, energy_account
from cranktrain.transient.settling import may_settle, settles
from cranktrain.transient.step import N_STATE, ROW

_STIFF = 1e-3
"""Slip time constant in parts of a turn, below which explicit steps are far shorter than the motion asks for."""
_AT_ONCE = 24
"""So many of the longest steps are a phase at most: between two the user is told, and steps are counted."""
_CLOSER = 1e-3
"""LSODA and Radau err by much more than their tolerance over a run."""
_CLOSER_OVER_ROWS = 1e-2
"""Steps that err by less would follow every row of a load curve that they are to pass."""


def slip_time_constant(speed: Array, torque: Array, inertia: Array) -> Array:
    """Shortest time in which the steepest fall of motors brings their speed back. [s]

    Parameters
    ----------
    speed, torque : Array, shape (design, n)
        Of the motors, so close that falls between are straight. [rad/s, N·m]
    inertia : Array, shape (design,)
        The least of all that turns, at the motor's shaft. [kg·m²]

    Returns
    -------
    Array, shape (design,)
        (J_m + J/i²)/max(−dM/dω); of Kloss's formula (J_m + J/i²) ω_s s_b/(2 M_b). docs/theory/transient, eq. (26.17).
    """
    steepest = np.max(-np.diff(torque) / np.diff(speed), axis=-1)
    return np.where(steepest > 0, inertia / np.where(steepest > 0, steepest, 1.0), np.inf)


def is_stiff(time_constant: float, crank_speed: float) -> bool:
    """Whether a motor is too fast for an explicit method at a crank speed. [s, rad/s]"""
    return time_constant < _STIFF * 2 * np.pi / crank_speed


class _StuckError(Exception):
    """No slope, or one asked for too often: SciPy stops for nothing else. The reason is that of the run's end."""

    def __init__(self, reason: int) -> None:
        super().__init__()
        self.reason = reason


_CALLS_OF_A_STEP = 3
"""More of them, on the mean, are steps that fail."""

_WHERE_IT_BEGINS = 1e-9
"""So near to a run's start a dead position is where the crank stood: x′ there is rounding of either sign. [rad]"""
_MOST_IN_VAIN, _SHORTEST = 10_000, 1e-9
"""Slopes in which a run must come on by a part of the longest step."""


class _Going(NamedTuple):
    """What an implicit run is made of; `calls` counts the slopes that were asked for, `got` how far they came."""

    parts: Joined
    train: TrainNumbers
    asked: Wanted
    method: str
    longest_step: float
    table: Array
    events: list[Event]
    ends: list[Array]
    is_compiled: bool
    calls: list[int]
    got: list[tuple[int, float]]


def run_implicitly(
    kernels: Kernels,
    drive: DriveTrain,
    asked: Wanted,
    *,
    method: str = "LSODA",
    longest_step: float = np.inf,
    is_compiled: bool = True,
    progress: Progress | None = None,
    keeps_steps: bool = False,
) -> TransientRun:
    """Run as `runs.run` does, by `solve_ivp` of SciPy with LSODA or Radau; phases, events and reasons are the same.

    Parameters
    ----------
    kernels, drive, asked, is_compiled, progress, keeps_steps
        See `runs.run`; progress is told at the ends of phases. A machine that remembers would remember the steps that
        are tried and not taken: it is no machine for this.
    method : str, optional
    longest_step : float, optional
        Short enough that no event comes and goes within one, and that it passes few of the rows. [s]

    Raises
    ------
    ImportError
        Where SciPy is not installed.
    """
    parts, train = joined(kernels, is_compiled), train_of(drive, kernels, is_compiled)
    table = np.full((len(asked.samples), N_STATE), np.nan)
    longest = min(longest_step, 0.02 * asked.limits.end_time)
    going = _Going(parts, train, asked, method, longest, table, [], [], is_compiled, [0], [(0, 0.0)])
    state, time, n_steps, n_reversals = asked.start.copy(), 0.0, 0, 0
    machine, settle = parts.kernels.machine, parts.kernels.settle
    settle(state[0], train.machine)
    sense, fastest, reason = float(np.sign(state[1])), abs(float(state[1])), GOING
    before = machine(state[0], state[1], sense, train.machine)[0]
    try:
        while reason == GOING and time < asked.limits.end_time:
            if progress is not None:
                progress(time, float(state[0]), float(state[1]))
            if sense == 0.0:
                sense, time, reason = _set_off(going, time, state)
                continue
            state[0] = on_the_way(state[0], sense, asked.corners, asked.period)
            reason = _trouble(going, time, state, sense)
            if reason != GOING:
                break
            time, state, ending, n_more = _phase(going, time, state, sense)
            n_steps += n_more
            if n_steps > asked.limits.most_steps:
                ending = endings.TOO_MANY_STEPS
            settle(state[0], train.machine)
            if ending == endings.SWINGS:
                state[1], sense, n_reversals = 0.0, 0.0, n_reversals + 1
                ending = endings.SWINGS if n_reversals >= asked.limits.most_reversals else GOING
            fastest = max(fastest, abs(float(state[1])))
            reason = _at_rest(going, time, state, sense, fastest) if ending == GOING else ending
    except _StuckError as stuck:
        reason = stuck.reason
    except KeyboardInterrupt:
        if progress is None:
            raise
        reason = endings.STOPPED
    going.ends.append(np.array([[time, state[1]]]))
    after = machine(state[0], state[1], sense, train.machine)[0]
    residual, supplied = energy_account(turning_inertia(drive.gearing), (before, after), asked.start, state)
    ended_at_once = np.isnan(table[:, 0]) & (asked.samples == time)
    table[ended_at_once] = state
    is_there = ~np.isnan(going.table[:, 0])
    marks = np.array(sorted(going.events, key=lambda one: one.time), dtype=float).reshape(-1, 4)
    reason = endings.TIME_OUT if reason == GOING else reason
    table = going.table[is_there]
    return TransientRun(
        reason,
        asked.start,
        time,
        state,
        asked.samples[is_there],
        table,
        marks,
        residual,
        supplied,
        n_steps,
        method,
        train.machine,
        np.concatenate(going.ends) if keeps_steps else np.empty((0, 2)),
    )


def _set_off(going: _Going, time: float, state: Array) -> tuple[float, float, int]:
    """Sense in which a crank at rest sets off, when, and `GOING`; or 0 and the reason why it never does."""
    (_, own), train, asked, table, events = going.parts, going.train, going.asked, going.table, going.events
    corners = (asked.corners, asked.period)
    sense = sense_of_start(time, state[0], own, train, *corners)
    if sense != 0.0:
        return sense, time, GOING
    events.append(Event(endings.HELD, time, float(state[0]), 0.0))
    until = asked.limits.end_time
    at = let_go_at(time, state[0], own, train, asked) if asked.limits.is_timed else np.inf
    warmer = _warming(state, time, own, going)
    _fill(table, asked.samples, time, min(at, until), warmer)
    if at == np.inf:
        return 0.0, time, kind_of_rest(time, own, train, until)
    events.append(Event(endings.SET_OFF, at, float(state[0]), 0.0))
    state[HEAT] = warmer(np.array([at]))[HEAT, 0]
    return sense_of_start(at, state[0], own, train, *corners), at, GOING


def _at_rest(going: _Going, time: float, state: Array, sense: float, fastest: float) -> int:
    """What kind of rest a crank has settled to; `GOING` where it has not."""
    (derive, own), train, asked = going[:3]
    if sense == 0.0 or time >= asked.limits.end_time or not may_settle(state[1], fastest):
        return GOING
    if not settles(derive, time, state, sense, sense * np.inf, np.zeros(ROW), train, asked):
        return GOING
    state[1] = 0.0
    going.table[asked.samples == time, 1] = 0.0
    going.events.append(Event(endings.HELD, time, float(state[0]), 0.0))
    return kind_of_rest(time, own, train, asked.limits.end_time)


def _trouble(going: _Going, time: float, state: Array, sense: float) -> int:
    """Why a phase cannot begin; `GOING` where it can."""
    slopes = np.zeros(ROW)
    _, grown = going.parts.derive(time, state[0], state[1], sense, sense * np.inf, slopes, 0, going.train)
    if grown == grown:
        return GOING
    return _why_not(slopes)


def _why_not(slopes: Any) -> int:
    """Why there is no acceleration."""
    return endings.LINKS_OPEN if is_open(slopes, 0) else endings.GEARING_JAMS


def _phase(going: _Going, time: float, state: Array, sense: float) -> tuple[float, Array, int, int]:
    """Integrate to the next break, corner or event that ends a phase: time, state, how it ended, how many steps."""
    asked, table, events = going.asked, going.table, going.events
    later = asked.breaks[asked.breaks > time]
    until = min(asked.limits.end_time, float(later[0]) if len(later) else np.inf, time + _AT_ONCE * going.longest_step)
    found = _solved(going, sense, (time, until), state)
    if found.t.size < 2:
        return time, state, endings.NO_STEP_SHORT_ENOUGH, 0
    stopped, passed, over, _, corner = found.t_events[:5]
    for kind, which in ((endings.REVERSAL, 0), (endings.SPEED_PASSED, 1), (endings.DEAD_POSITION, 3)):
        for when, y in zip(found.t_events[which], found.y_events[which], strict=True):
            if kind != endings.DEAD_POSITION or time > 0 or abs(y[0] - state[0]) > _WHERE_IT_BEGINS:
                events.append(Event(kind, float(when), float(y[0]), float(y[1])))
    _fill(table, asked.samples, time, found.t[-1], found.sol)
    going.ends.append(np.column_stack([found.t, found.y[1]]))
    end = float(found.t[-1])
    ending = endings.NO_STEP_SHORT_ENOUGH
    if len(over):
        ending = endings.OVERSPEED
    elif len(passed) and asked.limits.stops_at_target:
        ending = endings.SPEED_REACHED
    elif len(stopped):
        ending = endings.SWINGS
    elif len(corner) or end >= until:
        ending = GOING
    return end, found.y[:, -1].copy(), ending, found.t.size - 1


def _solved(going: _Going, sense: float, span: tuple[float, float], state: Array) -> Any:
    """What `solve_ivp` finds with the sense as it is."""
    from scipy import integrate

    (derive, own), train, asked, method = going[:4]
    limits, slopes = asked.limits, np.empty(ROW) if going.is_compiled else [0.0] * ROW
    bound = corner_ahead(state[0], sense, asked.corners, asked.period)

    most_calls = _CALLS_OF_A_STEP * limits.most_steps

    def slope(time: float, state: Array) -> Array:
        going.calls[0] += 1
        if going.calls[0] > most_calls:
            raise _StuckError(endings.TOO_MANY_STEPS)
        if _treads(going, time):
            raise _StuckError(endings.NO_STEP_SHORT_ENOUGH)
        _, grown = derive(time, float(state[0]), float(state[1]), sense, bound, slopes, 0, train)
        if grown != grown:
            raise _StuckError(_why_not(slopes))
        return np.array(slopes[:N_STATE])

    def stopped(_time: float, state: Array) -> float:
        return sense * state[1]

    def passed(_time: float, state: Array) -> float:
        return sense * state[1] - min(limits.target_speed, 1e300)

    def over(_time: float, state: Array) -> float:
        return sense * state[1] - min(limits.overspeed, 1e300)

    def dead(_time: float, state: Array) -> float:
        return own.machine(state[0], state[1], sense, train.machine)[3]

    def corner(_time: float, state: Array) -> float:
        return max(sense * (state[0] - bound), -1e300)

    stopped.terminal, stopped.direction = True, -1.0  # pyright: ignore[reportFunctionMemberAccess]
    passed.terminal, passed.direction = limits.stops_at_target, 1.0  # pyright: ignore[reportFunctionMemberAccess]
    over.terminal, over.direction = True, 1.0  # pyright: ignore[reportFunctionMemberAccess]
    corner.terminal, corner.direction = True, 1.0  # pyright: ignore[reportFunctionMemberAccess]
    closeness = (_CLOSER_OVER_ROWS if len(asked.rows) else _CLOSER) * limits.tolerance
    solve: Any = cast(Any, integrate).solve_ivp
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", UserWarning)  # LSODA says there that it fails, which its end shows as well
        return solve(
            slope, span, state, method=method, rtol=max(closeness, 3e-14), atol=closeness,
            max_step=going.longest_step, dense_output=True, events=(stopped, passed, over, dead, corner),
        )  # fmt: skip


def _treads(going: _Going, time: float) -> bool:
    """Whether many slopes in a row brought a run no further: no step is short enough there."""
    since, far = going.got[0]
    if time > far + _SHORTEST * going.longest_step:
        going.got[0] = (going.calls[0], time)
        return False
    return going.calls[0] - since > _MOST_IN_VAIN


def _warming(state: Array, time: float, own: Kernels, going: _Going) -> Callable[[Array], Array]:
    """Give the same state at all later times, but for the heat of a motor that stands."""
    widest = (going.asked.limits.end_time - time) / HEAT_PANELS

    def at(times: Array) -> Array:
        found = np.tile(state[:, np.newaxis], times.size)
        found[HEAT] += [heated(time, end, widest, own, going.train, going.asked.breaks) for end in times.tolist()]
        return found

    return at


def _fill(table: Array, samples: Array, start: float, end: float, at: Any) -> None:
    """Fill the rows of the samples of a phase."""
    rows = (samples >= start) & (samples <= end)
    if np.any(rows):
        table[rows] = at(samples[rows]).T
