"""Curves of a start: when they are looked at closely, and speeds, torques, powers and energies at these times."""

import math
from collections.abc import Iterator, Sequence
from dataclasses import fields
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array
from cranktrain.questions.start.case import StartCase, Switching, start_kernels
from cranktrain.questions.start.record import StartCurves
from cranktrain.transient.equation import ANGLE, HEAT, LOAD_WORK, LOST_WORK, MOTOR_WORK, SPEED
from cranktrain.transient.floats import in_floats
from cranktrain.transient.gearing import overall_ratio, turning_inertia
from cranktrain.transient.reduced import ReducedMachine, filled_at, in_one_row, inertia_at, pressures_at

QUICKLY = 0.01
"""Of its largest torque, by which a motor's changes in a step that is looked into closely."""
N_CLOSE = 9


class SampledGas(NamedTuple):
    """Curves at the samples, and the pressure in every chamber that remembers its gas, shape (chamber, time). [Pa]"""

    curves: StartCurves
    pressure: Array


def curves_of(
    case: StartCase,
    time: Array,
    state: Array,
    loaded: Sequence[tuple[float, ReducedMachine]],
) -> SampledGas:
    """Speeds, torques, powers, energies and pressures at the samples.

    Parameters
    ----------
    case : StartCase
    time : Array, shape (time,)
    state : Array, shape (time, state)
    loaded : sequence of (float, ReducedMachine)
        From when on it is which machine, as its suction valves are held open or not. [s]
    """
    angle, speed = state[:, ANGLE], state[:, SPEED]
    ratio = overall_ratio(case.gearing)
    torque = motor_torque(case, time, speed)
    load, inertia = np.empty(time.shape), np.empty(time.shape)
    pressure = np.empty((len(case.chambers), *time.shape))
    kernels, pressures = start_kernels(case.motor), in_floats(pressures_at)
    for first, last, machine in _parts(time, loaded):
        filled = case.start.gas_pressure if first == 0 else math.nan
        numbers = numbers_from(machine, float(angle[first]), filled)
        each = zip(angle[first:last].tolist(), speed[first:last].tolist(), strict=True)
        for at, (own, turning) in enumerate(each, start=first):
            sense = 1.0 if turning > 0 else -1.0 if turning < 0 else 0.0
            inertia[at], _, load[at], _ = kernels.machine(own, turning, sense, numbers)
            pressures(own, numbers, pressure, at)
            kernels.settle(own, numbers)
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


def inertia_of(case: StartCase, angle: Array) -> Array:
    """Reduced inertia of the machine at crank angles, as `curves_of` has it, shape (n,). [kg·m²]"""
    inertia, numbers = in_floats(inertia_at), numbers_from(case.machine, 0.0)
    return np.array([inertia(at, numbers) for at in angle.tolist()], dtype=np.float64)


def _parts(time: Array, loaded: Sequence[tuple[float, ReducedMachine]]) -> Iterator[tuple[int, int, ReducedMachine]]:
    """From and up to which sample it is which machine."""
    begins = [*np.searchsorted(time, [begin for begin, _machine in loaded]).tolist(), len(time)]
    for (first, last), (_begin, machine) in zip(pairwise(begins), loaded, strict=True):
        if first < last:
            yield first, last, machine


def motor_torque(case: StartCase, time: Array, speed: Array) -> Array:
    """Of the motor at times and speeds of the crank, as it is switched. [N·m]"""
    numbers = Switching(
        case.motor_numbers,
        case.start.motor_off,
        case.start.motor_reversed,
        0.0,
    )
    motor, at_motor = start_kernels(case.motor).motor, speed * overall_ratio(case.gearing)
    each = zip(at_motor.tolist(), time.tolist(), strict=True)
    return np.array([motor(own, at, numbers) for own, at in each], dtype=np.float64)


def close_times(case: StartCase, steps: Array) -> Array:
    """Times at which steps end, and closer ones where the motor's torque changes quickly. [s]

    Parameters
    ----------
    case : StartCase
    steps : Array, shape (n, 2)
        Time and speed of the crank where each ends. [s, rad/s]
    """
    time, speed = steps.T
    torque = motor_torque(case, time, speed)
    changes = np.abs(np.diff(torque)) > QUICKLY * np.max(np.abs(torque))
    # A step over the top of the curve may end as high as it began: those beside a quick change are looked into, too.
    closely = changes.copy()
    closely[1:] |= changes[:-1]
    closely[:-1] |= changes[1:]
    width = np.where(closely, np.diff(time), 0.0)[:, np.newaxis]
    return each_once(np.append(time[:-1, np.newaxis] + width * np.linspace(0, 1, N_CLOSE)[:-1], time[-1]))


def each_once(times: Array) -> Array:
    """Times in their order, each once. [s]"""
    return times[np.append(True, times[1:] != times[:-1])]


def at_times(curves: StartCurves, chosen: NDArray[np.intp]) -> StartCurves:
    """Curves at some of their times."""
    return StartCurves(**{one.name: getattr(curves, one.name)[chosen] for one in fields(curves)})


def numbers_from(machine: ReducedMachine, angle: float, pressure: float = math.nan) -> list[float]:
    """Numbers for a plain run, from an angle where all chambers hold gas at a pressure. [rad, Pa]

    Unless given, at that of their suction.
    """
    numbers = in_one_row(machine).tolist()
    if len(machine.chambers):
        in_floats(filled_at)(angle, numbers, pressure)
    return numbers
