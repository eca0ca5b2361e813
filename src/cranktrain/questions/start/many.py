"""Facts of many starts that have run, from arrays of all of them; what no fact is taken from is not computed."""

from collections.abc import Iterator

import numpy as np

from cranktrain.motion import Array
from cranktrain.questions.start.curves import inertia_of, motor_torque
from cranktrain.questions.start.facts import RunsInRow, StartFacts, facts_in_row
from cranktrain.questions.start.record import RanFacts, RanRows, RanStart
from cranktrain.questions.start.starting import Happened, counted_on, happened, how_it_ran, marks_of
from cranktrain.transient.equation import ANGLE, HEAT, LOAD_WORK, LOST_WORK, MOTOR_WORK, SPEED
from cranktrain.transient.gearing import overall_ratio, turning_inertia


def rows_of_one(ran: RanStart) -> RanRows:
    """A start that has run, as rows of one."""
    (time, state), marks = counted_on(ran.runs), marks_of(ran)
    torque, inertia = motor_torque(ran.case, time, state[:, SPEED]), inertia_of(ran.case, state[:, ANGLE])
    told = RanFacts(*(np.array([one]) for one in how_it_ran(ran)))
    return RanRows(
        (ran.case,), time, state, torque, inertia, np.array([len(time)]), marks, np.array([len(marks)]), told
    )


def happened_in(ran: RanRows) -> Iterator[Happened]:
    """What happened on the way of each start."""
    each = np.split(ran.marks, np.cumsum(ran.n_marks)[:-1])
    return (happened(case, marks) for case, marks in zip(ran.cases, each, strict=True))


def facts_of_rows(ran: RanRows, n_reversals: Array) -> StartFacts:
    """Facts of starts, each to the last bit as `start_facts` gives them of one alone.

    Parameters
    ----------
    ran : RanRows
    n_reversals : Array, shape (design,)
        How often each crank turned round.
    """
    begins = np.cumsum(ran.sizes) - ran.sizes

    def along(each: list[float]) -> Array:
        """A number of each start, at all its times."""
        return np.repeat(np.array(each, dtype=np.float64), ran.sizes)

    speed, gearings = ran.state[:, SPEED], [case.gearing for case in ran.cases]
    turning = along([turning_inertia(gearing) for gearing in gearings])
    curves = {
        "crank_angle_turned": ran.state[:, ANGLE] - along([case.zero for case in ran.cases]),
        "crank_speed": speed,
        "motor_torque": ran.torque,
        "motor_power": ran.torque * speed * along([overall_ratio(gearing) for gearing in gearings]),
        "motor_work": ran.state[:, MOTOR_WORK],
        "load_work": ran.state[:, LOAD_WORK],
        "lost_work": ran.state[:, LOST_WORK],
        "motor_heat": ran.state[:, HEAT],
        "kinetic_energy": 0.5 * (ran.inertia + turning) * speed**2,
    }
    kinetic = np.maximum.reduceat(curves["kinetic_energy"], begins)
    supplied = np.where(kinetic > ran.told.supplied, kinetic, ran.told.supplied)
    return facts_in_row(RunsInRow(ran.time, curves, begins, n_reversals, ran.told.left_over, supplied))
