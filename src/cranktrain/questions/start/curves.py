"""Curves of a start: when they are looked at closely, and speeds, torques, powers and energies at these times."""

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import fields
from functools import cache
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array
from cranktrain.questions.start.case import StartCase, Switching, start_kernels
from cranktrain.questions.start.record import StartCurves
from cranktrain.transient.compiling import kept
from cranktrain.transient.equation import ANGLE, HEAT, LOAD_WORK, LOST_WORK, MOTOR_WORK, SPEED, Kernels, joined
from cranktrain.transient.floats import in_floats
from cranktrain.transient.gearing import overall_ratio, turning_inertia
from cranktrain.transient.reduced import ReducedMachine, filled_at, in_one_row, pressures_at

_QUICKLY = 0.01
"""Of its largest torque, by which a motor's changes in a step that is looked into closely."""
_N_CLOSE = 9


class SampledGas(NamedTuple):
    """Curves at the samples, and the pressure in every chamber that remembers its gas, shape (chamber, time). [Pa]"""

    curves: StartCurves
    pressure: Array


def curves_of(
    case: StartCase,
    time: Array,
    state: Array,
    loaded: Sequence[tuple[float, ReducedMachine]],
    *,
    is_compiled: bool = False,
) -> SampledGas:
    """Speeds, torques, powers, energies and pressures at the samples.

    Parameters
    ----------
    case : StartCase
    time : Array, shape (time,)
    state : Array, shape (time, state)
    loaded : sequence of (float, ReducedMachine)
        From when on it is which machine, as its suction valves are held open or not. [s]
    is_compiled : bool, optional
        With Numba.
    """
    angle, speed = state[:, ANGLE], state[:, SPEED]
    ratio = overall_ratio(case.gearing)
    torque = motor_torque(case, time, speed, is_compiled=is_compiled)
    load, inertia = np.empty(time.shape), np.empty(time.shape)
    pressure = np.empty((len(case.chambers), *time.shape))
    along = _loops_of(start_kernels(case.motor, is_compiled=is_compiled), is_compiled).loads
    for first, last, machine in _parts(time, loaded):
        filled = case.start.gas_pressure if first == 0 else math.nan
        numbers = numbers_from(machine, float(angle[first]), filled, is_compiled=is_compiled)
        room = (inertia[first:last], load[first:last], pressure[:, first:last])
        along(*_ready(angle[first:last], speed[first:last], is_compiled=is_compiled), numbers, *room)
    curves = StartCurves(
        crank_angle_turned=angle - case.zero,
        crank_speed=speed,
        motor_speed=speed * ratio,
        motor_torque=torque,
        load_torque=load,
        motor_power=torque * speed * ratio,
        motor_work=state[:, MOTOR_WORK],
        load_work=state[:, LOAD_WORK],
        lost_work=state[:, LOST_WORK],
        kinetic_energy=0.5 * (inertia + turning_inertia(case.gearing)) * speed**2,
        motor_heat=state[:, HEAT],
    )
    return SampledGas(curves, pressure)


def inertia_of(
    case: StartCase,
    time: Array,
    state: Array,
    loaded: Sequence[tuple[float, ReducedMachine]],
    *,
    is_compiled: bool = False,
) -> Array:
    """Reduced inertia of the machine at the samples, as `curves_of` has it, shape (time,). [kg·m²]"""
    inertia = np.empty(time.shape)
    along = _loops_of(start_kernels(case.motor, is_compiled=is_compiled), is_compiled).inertias
    for first, last, machine in _parts(time, loaded):
        numbers = numbers_from(machine, float(state[first, ANGLE]), is_compiled=is_compiled)
        each = _ready(state[first:last, ANGLE], state[first:last, SPEED], is_compiled=is_compiled)
        along(*each, numbers, inertia[first:last])
    return inertia


def _parts(time: Array, loaded: Sequence[tuple[float, ReducedMachine]]) -> Iterator[tuple[int, int, ReducedMachine]]:
    """From and up to which sample it is which machine."""
    begins = [*np.searchsorted(time, [begin for begin, _machine in loaded]).tolist(), len(time)]
    for (first, last), (_begin, machine) in zip(pairwise(begins), loaded, strict=True):
        if first < last:
            yield first, last, machine


def _ready(*each: Array, is_compiled: bool) -> Iterator[Array | list[float]]:
    """Samples for a loop: one behind the other; in lists for a plain one."""
    return (one.copy() if is_compiled else one.tolist() for one in each)


def motor_torque(case: StartCase, time: Array, speed: Array, *, is_compiled: bool = False) -> Array:
    """Of the motor at times and speeds of the crank, as it is switched. [N·m]"""
    numbers = Switching(
        case.motor_numbers,
        case.start.motor_off,
        case.start.motor_reversed,
        0.0,
    )
    torque = np.empty(time.shape)
    along = _loops_of(start_kernels(case.motor, is_compiled=is_compiled), is_compiled).torques
    along(*_ready(speed * overall_ratio(case.gearing), time, is_compiled=is_compiled), numbers, torque)
    return torque


class _Loops(NamedTuple):
    """Loops along the samples of a run, which fill arrays: of its machine, of that the inertia alone; of its motor."""

    loads: Callable[..., None]
    inertias: Callable[..., None]
    torques: Callable[..., None]


@cache
def _loops_of(kernels: Kernels, is_compiled: bool) -> _Loops:
    """Loops with their kernels in them, compiled or not."""
    _derive, (machine, motor, _heat, _brake, carried) = joined(kernels, is_compiled)
    pressures = pressures_at if is_compiled else in_floats(pressures_at)

    def loads(angles: Any, speeds: Any, numbers: Any, inertia: Any, load: Any, pressure: Any) -> None:
        for at in range(len(angles)):
            angle, speed = angles[at], speeds[at]
            sense = 1.0 if speed > 0 else -1.0 if speed < 0 else 0.0
            inertia[at], _, load[at], _ = machine(angle, speed, sense, numbers)
            pressures(angle, numbers, pressure, at)
            carried(angle, numbers)

    def inertias(angles: Any, speeds: Any, numbers: Any, inertia: Any) -> None:
        for at in range(len(angles)):
            inertia[at] = machine(angles[at], speeds[at], 0.0, numbers)[0]

    def torques(speeds: Any, times: Any, numbers: Any, torque: Any) -> None:
        for at in range(len(speeds)):
            torque[at] = motor(speeds[at], times[at], numbers)

    if is_compiled:
        return _Loops(kept(loads), kept(inertias), kept(torques))
    return _Loops(loads, inertias, torques)


def close_times(case: StartCase, steps: Array, *, is_compiled: bool = False) -> Array:
    """Times at which steps end, and closer ones where the motor's torque changes quickly. [s]

    Parameters
    ----------
    case : StartCase
    steps : Array, shape (n, 2)
        Time and speed of the crank where each ends. [s, rad/s]
    is_compiled : bool, optional
        With Numba.
    """
    time, speed = steps.T
    torque = motor_torque(case, time, speed, is_compiled=is_compiled)
    changes = np.abs(np.diff(torque)) > _QUICKLY * np.max(np.abs(torque))
    # A step over the top of the curve may end as high as it began: those beside a quick change are looked into, too.
    closely = changes.copy()
    closely[1:] |= changes[:-1]
    closely[:-1] |= changes[1:]
    width = np.where(closely, np.diff(time), 0.0)[:, np.newaxis]
    return each_once(np.append(time[:-1, np.newaxis] + width * np.linspace(0, 1, _N_CLOSE)[:-1], time[-1]))


def each_once(times: Array) -> Array:
    """Times in their order, each once. [s]"""
    return times[np.append(True, times[1:] != times[:-1])]


def at_times(curves: StartCurves, chosen: NDArray[np.intp]) -> StartCurves:
    """Curves at some of their times."""
    return StartCurves(**{one.name: getattr(curves, one.name)[chosen] for one in fields(curves)})


def numbers_from(
    machine: ReducedMachine, angle: float, pressure: float = math.nan, *, is_compiled: bool = False
) -> Array | list[float]:
    """Numbers for a run, from an angle where all chambers hold gas at a pressure [rad, Pa]; in a list for a plain one.

    Unless given, at that of their suction.
    """
    row = in_one_row(machine)
    numbers = row if is_compiled else row.tolist()
    if len(machine.chambers):
        fill = kept(filled_at) if is_compiled else in_floats(filled_at)
        fill(angle, numbers, pressure)
    return numbers
