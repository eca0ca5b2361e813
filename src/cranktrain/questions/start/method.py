"""How a start is run: by explicit steps, or by an implicit method where its motor is stiff."""

from functools import partial
from typing import Protocol

import numpy as np

from cranktrain.extras import is_there
from cranktrain.questions.start.case import Braking, StartCase, Switching, start_kernels
from cranktrain.questions.start.curves import numbers_from
from cranktrain.transient.corners import few_ahead
from cranktrain.transient.equation import DriveTrain, Kernels
from cranktrain.transient.gearing import overall_ratio
from cranktrain.transient.implicit import is_stiff, run_implicitly, slip_time_constant
from cranktrain.transient.runs import Progress, TransientRun, Wanted, run

_ANGLES = np.linspace(0.0, 2 * np.pi, 61)
"""At which the least inertia is looked for."""
_STEPS_A_TURN = 24
_NO_BRAKE = Braking(0.0, np.inf, 0.0)


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


def method_of(case: StartCase) -> Runs:
    """The method that suits a start: `run`, by explicit steps, unless its motor is stiff.

    Explicit steps, too, where a chamber remembers its gas, as an implicit method tries steps that it does not take, and
    where SciPy is not installed.
    """
    if case.motor is None or len(case.machine.chambers) or not is_there("scipy"):
        return run
    top = case.motor.highest_speed(0)
    if not np.isfinite(top):
        return run
    switching = Switching(case.motor.row(0), np.inf, np.inf, 0.0)
    drive = DriveTrain(numbers_from(case.machine, 0.0), switching, _NO_BRAKE, case.gearing, case.place)
    at_crank = top / overall_ratio(case.gearing)
    if not is_stiff(slip_time_constant(start_kernels(case.motor), drive, top, _ANGLES), at_crank):
        return run
    rows = case.rows.tolist()
    few = (few_ahead(at, 1.0, rows, case.cycle) for at in rows)
    longest = min([2 * np.pi / _STEPS_A_TURN, *few]) / at_crank
    return partial(run_implicitly, longest_step=longest)
