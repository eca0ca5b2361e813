"""Curves of a start: when they are looked at closely, and speeds, torques, powers and energies at these times."""

import math
from collections.abc import Sequence
from dataclasses import fields
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array
from cranktrain.questions.start.case import StartCase, Switching, start_kernels
from cranktrain.questions.start.record import StartCurves
from cranktrain.transient.equation import ANGLE, HEAT, LOAD_WORK, LOST_WORK, MOTOR_WORK, SPEED
from cranktrain.transient.floats import in_floats
from cranktrain.transient.gearing import overall_ratio, turning_inertia
from cranktrain.transient.reduced import ReducedMachine, filled_at, in_one_row, pressures_at, settle

_QUICKLY = 0.01
"""Of its largest torque, by which a motor's changes in a step that is looked into closely."""
_N_CLOSE = 9


class SampledGas(NamedTuple):
    """Curves at the samples, and the pressure in every chamber that remembers its gas, shape (chamber, time). [Pa]"""

    curves: StartCurves
    pressure: Array


def curves_of(case: StartCase, time: Array, state: Array, loaded: Sequence[tuple[float, ReducedMachine]]) -> SampledGas:
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
    kernels = start_kernels(case.motor)
    torque = motor_torque(case, time, speed)
    load, inertia = np.empty(time.shape), np.empty(time.shape)
    pressure = np.empty((len(case.chambers), *time.shape))
    machines, machine = list(loaded), list[float]()
    for at, (now, phi, omega) in enumerate(zip(time.tolist(), angle.tolist(), speed.tolist(), strict=True)):
        while machines and now >= machines[0][0]:
            machine = in_list(machines.pop(0)[1], phi, math.nan if machine else case.start.gas_pressure)
        inertia[at], _, load[at], _ = kernels.machine(phi, omega, np.sign(omega), machine)
        pressure[:, at] = in_floats(pressures_at)(phi, machine)
        in_floats(settle)(phi, machine)
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


def motor_torque(case: StartCase, time: Array, speed: Array) -> Array:
    """Of the motor at times and speeds of the crank, as it is switched. [N·m]"""
    motor, ratio = start_kernels(case.motor).motor, overall_ratio(case.gearing)
    numbers = Switching(
        () if case.motor is None else case.motor.row(case.design),
        case.start.motor_off,
        case.start.motor_reversed,
        0.0,
    )
    return np.array([motor(w * ratio, t, numbers) for w, t in zip(speed.tolist(), time.tolist(), strict=True)])


def close_times(case: StartCase, steps: list[tuple[float, float]]) -> Array:
    """Times at which steps end, and closer ones where the motor's torque changes quickly. [s]"""
    time, speed = np.array(steps).T
    torque = motor_torque(case, time, speed)
    changes = np.abs(np.diff(torque)) > _QUICKLY * np.max(np.abs(torque))
    # A step over the top of the curve may end as high as it began: those beside a quick change are looked into, too.
    closely = changes.copy()
    closely[1:] |= changes[:-1]
    closely[:-1] |= changes[1:]
    width = np.where(closely, np.diff(time), 0.0)[:, np.newaxis]
    return np.unique(np.append(time[:-1, np.newaxis] + width * np.linspace(0, 1, _N_CLOSE)[:-1], time[-1]))


def at_times(curves: StartCurves, chosen: NDArray[np.intp]) -> StartCurves:
    """Curves at some of their times."""
    return StartCurves(**{one.name: getattr(curves, one.name)[chosen] for one in fields(curves)})


def in_list(machine: ReducedMachine, angle: float, pressure: float = math.nan) -> list[float]:
    """Numbers for a run that is not compiled, from an angle where all chambers hold gas at a pressure [rad, Pa].

    Unless given, at that of their suction.
    """
    numbers = in_one_row(machine).tolist()
    filled_at(angle, numbers, pressure)
    return numbers
