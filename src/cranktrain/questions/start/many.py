"""Facts of many starts that have run, from arrays of all of them; what no fact is taken from is not computed."""

from collections.abc import Callable, Sequence

import numpy as np

from cranktrain.motion import Array
from cranktrain.questions.start.curves import inertia_of, motor_torque
from cranktrain.questions.start.facts import RunsInRow, StartFacts, facts_in_row
from cranktrain.questions.start.record import RanStart
from cranktrain.questions.start.starting import counted_on, happened, loaded, residual_of, supplied_of
from cranktrain.transient.equation import ANGLE, HEAT, LOAD_WORK, LOST_WORK, MOTOR_WORK, SPEED
from cranktrain.transient.gearing import overall_ratio, turning_inertia

FACTS_OF_ENERGY = frozenset({"first_kinetic_energy", "final_kinetic_energy", "energy_left_over"})
"""Those for which the machine's inertia is asked at all times of a run."""


def facts_of_ran(starts: Sequence[RanStart], *, with_energy: bool = True) -> StartFacts:
    """Facts of starts, each to the last bit as `start_facts` gives them of one alone.

    Parameters
    ----------
    starts : sequence of RanStart
    with_energy : bool
        Whether `FACTS_OF_ENERGY` are wanted; NaN unless they are.
    """
    states = [counted_on(one.runs) for one in starts]
    sizes = np.array([len(time) for time, _state in states])
    begins = np.cumsum(sizes) - sizes
    time, state = np.concatenate([own for own, _state in states]), np.concatenate([own for _time, own in states])

    def along(number: Callable[[RanStart], float]) -> Array:
        """A number of each start, at all its times."""
        return np.repeat(np.array([number(one) for one in starts]), sizes)

    speed = state[:, SPEED]
    each = zip(starts, np.split(time, begins[1:]), np.split(speed, begins[1:]), strict=True)
    torque = np.concatenate([motor_torque(one.case, *own, is_compiled=one.is_compiled) for one, *own in each])
    curves = {
        "crank_angle_turned": state[:, ANGLE] - along(lambda one: one.case.zero),
        "crank_speed": speed,
        "motor_torque": torque,
        "motor_power": torque * speed * along(lambda one: overall_ratio(one.case.gearing)),
        "motor_work": state[:, MOTOR_WORK],
        "load_work": state[:, LOAD_WORK],
        "lost_work": state[:, LOST_WORK],
        "motor_heat": state[:, HEAT],
    }
    kinetic = np.full(len(starts), np.nan)
    if with_energy:
        each = zip(starts, states, strict=True)
        inertia = np.concatenate(
            [inertia_of(one.case, *own, loaded(one.runs), is_compiled=one.is_compiled) for one, own in each]
        )
        curves["kinetic_energy"] = 0.5 * (inertia + along(lambda one: turning_inertia(one.case.gearing))) * speed**2
        kinetic = np.maximum.reduceat(curves["kinetic_energy"], begins)
    supplied = [supplied_of(one, largest) for one, largest in zip(starts, kinetic.tolist(), strict=True)]
    found = RunsInRow(
        time,
        curves,
        begins,
        np.array([happened(one).n_reversals for one in starts], dtype=np.float64),
        np.array([residual_of(one) for one in starts]) + (0.0 if with_energy else np.nan),
        np.array(supplied),
    )
    return facts_in_row(found)
