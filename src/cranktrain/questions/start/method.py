"""How a start is run: by explicit steps, or by an implicit method where its motor is stiff."""

from collections.abc import Hashable, Sequence
from functools import partial
from typing import Protocol

import numpy as np

from cranktrain.extras import is_there
from cranktrain.grouping import grouped
from cranktrain.motion import Array
from cranktrain.motors import DeclaredMotor
from cranktrain.motors.declared import motors_together
from cranktrain.numerics.nested import leaves
from cranktrain.questions.reduction.at_angles import reduced_of_each, structure_of
from cranktrain.questions.start.case import StartCase
from cranktrain.transient.corners import few_ahead
from cranktrain.transient.equation import DriveTrain, Kernels
from cranktrain.transient.gearing import overall_ratio, turning_inertia
from cranktrain.transient.implicit import is_stiff, run_implicitly, slip_time_constant
from cranktrain.transient.reduced import ReducedMachine
from cranktrain.transient.runs import Progress, TransientRun, Wanted, run

_ANGLES = np.linspace(0.0, 2 * np.pi, 61)
"""At which the least inertia is looked for."""
_N_SPEEDS = 2001
"""At which the steepest fall of a motor is looked for."""
_STEPS_A_TURN = 24


class Runs(Protocol):
    """Runs what is wanted of a drive."""

    def __call__(
        self,
        kernels: Kernels,
        drive: DriveTrain,
        asked: Wanted,
        *,
        is_compiled: bool,
        progress: Progress | None,
        keeps_steps: bool,
    ) -> TransientRun:
        """See `runs.run`."""
        ...


def methods_of(cases: Sequence[StartCase]) -> list[Runs]:
    """The method that suits each start, with motors of one law: `run`, by explicit steps, unless its motor is stiff.

    Explicit steps, too, where a chamber remembers its gas, as an implicit method tries steps that it does not take, and
    where SciPy is not installed.
    """
    found: list[Runs] = [run] * len(cases)
    if not is_there("scipy"):
        return found
    driven = [
        (place, case, case.motor)
        for place, case in enumerate(cases)
        if case.motor is not None and not len(case.machine.chambers) and np.isfinite(case.motor.highest_speed(0))
    ]
    ratios = np.array([overall_ratio(case.gearing) for _place, case, _motor in driven])
    at_crank = np.array([motor.highest_speed(0) for _place, _case, motor in driven]) / ratios
    turning = np.array([turning_inertia(case.gearing) for _place, case, _motor in driven])
    inertia = (turning + _least_inertias([case.machine for _place, case, _motor in driven])) / ratios**2
    constants = _slip_time_constants([motor for _place, _case, motor in driven], inertia)
    for (place, case, _motor), constant, speed in zip(driven, constants.tolist(), at_crank.tolist(), strict=True):
        if is_stiff(constant, speed):
            rows = case.rows.tolist()
            few = (few_ahead(at, 1.0, rows, case.cycle) for at in rows)
            longest = min([2 * np.pi / _STEPS_A_TURN, *few]) / speed
            found[place] = partial(run_implicitly, longest_step=longest)
    return found


def _least_inertias(machines: Sequence[ReducedMachine]) -> Array:
    """The least inertia of each over a turn. [kg·m²]"""
    found = np.empty(len(machines))
    for places in grouped((structure_of(machine), place) for place, machine in enumerate(machines)).values():
        angles = np.broadcast_to(_ANGLES, (len(places), _ANGLES.size))
        found[places] = np.min(reduced_of_each([machines[place] for place in places], angles).inertia, axis=-1)
    return found


def _slip_time_constants(motors: Sequence[DeclaredMotor], inertia: Array) -> Array:
    """Slip time constants of motors just switched on, with what turns at their shafts; each fall is looked for once."""
    found = np.empty(len(motors))
    each = grouped((_numbers_of(motor), place) for place, motor in enumerate(motors))
    if each:
        of_each = [motors[places[0]] for places in each.values()]
        speed = np.linspace(0.0, [motor.highest_speed(0) for motor in of_each], _N_SPEEDS, axis=-1)
        torque = motors_together(of_each).torque(speed, 0.0)
        for places, own_speed, own_torque in zip(each.values(), speed, torque, strict=True):
            found[places] = slip_time_constant(own_speed, own_torque, inertia[places])
    return found


def _numbers_of(motor: DeclaredMotor) -> Hashable:
    """What its torque hangs on."""
    return motor.highest_speed(0), *(part.tobytes() for part in leaves(motor.numbers))
