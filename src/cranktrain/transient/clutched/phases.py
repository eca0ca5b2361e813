"""The phase that begins at a moment: what goes on, how long at most, and the end of a run in which nothing does."""

import math
from dataclasses import replace

import numpy as np

from cranktrain.record import record
from cranktrain.transient.clutched.courses import piece_from
from cranktrain.transient.clutched.equation import (
    ANGLE,
    SPEED,
    WHEEL,
    ActingPress,
    Press,
    PressPhase,
)
from cranktrain.transient.clutched.modes import both_ways, locked_or_slipping, sense_from_rest, set_off_at
from cranktrain.transient.clutched.runs import (
    LOCKED,
    LOOSE,
    NOTHING_MOVES,
    OFF,
    RESTS,
    SLIDES,
    SLIPS_ON,
    TIME_IS_OVER,
    Moment,
    PressPlan,
    piece_ends,
)
from cranktrain.transient.clutched.step import Derive
from cranktrain.transient.equation import Kernels

_BESIDE = 1e-11
"""So far from a jump of the load it is asked for, on the side of the phase. [rad]"""


@record
class Ahead:
    """What goes on from a moment.

    Attributes
    ----------
    acting : ActingPress
    sense : float
        Of the crank, 0 if it is held.
    until : float
        [s]
    happened : tuple of int
        What begins with the phase: `LOCKED`, `LOOSE`, `OFF`.
    reason : int or None
        Why the run ends here, if it does.
    """

    acting: ActingPress
    sense: float
    until: float
    happened: tuple[int, ...] = ()
    reason: int | None = None


def ahead_of(derive: Derive, kernels: Kernels, press: Press, now: Moment, plan: PressPlan, *, must_slip: bool) -> Ahead:
    """Phase that begins at a moment. docs/theory/clutched-drive, eqs. (30.4) to (30.7)."""
    acting, sense, until = _drawn(press, now, plan)
    is_gripping = acting.phase.clutch_level > 0 or acting.phase.clutch_slope > 0
    if now.time >= plan.end_time:
        return Ahead(acting, sense, until, (), _reason_of_time(now, is_gripping))
    happened: tuple[int, ...] = ()
    if acting.phase.way == 0 and sense != 0 and is_gripping:
        phase = locked_or_slipping(derive, now.time, now.state, sense, acting, must_slip=must_slip)
        acting = ActingPress(press, phase)
    if acting.phase.is_locked != now.is_locked:
        happened = (LOCKED if acting.phase.is_locked else LOOSE,)
    begun = Ahead(acting, sense, until, happened)
    return _from_rest(kernels, now, plan, begun, is_gripping) if sense == 0 else begun


def _drawn(press: Press, now: Moment, plan: PressPlan) -> tuple[ActingPress, float, float]:
    """Phase with its clutch not locked, the crank's sense, and how long the courses are lines."""
    clutch, brake = piece_from(now.clutch, now.time), piece_from(now.brake, now.time)
    low, high = piece_ends(now.piece, plan.jumps)
    slip = 0.0 if now.is_locked else float(now.state[WHEEL] - press.ratio * now.state[SPEED])
    phase = PressPhase(
        now.time, clutch.level, clutch.slope, brake.level, brake.slope, float(np.sign(slip)), False,
        low + _BESIDE, high - _BESIDE,
    )  # fmt: skip
    return ActingPress(press, phase), float(np.sign(now.state[SPEED])), min(clutch.end, brake.end, plan.end_time)


def _from_rest(kernels: Kernels, now: Moment, plan: PressPlan, begun: Ahead, is_gripping: bool) -> Ahead:
    """Set off, wait, or end."""
    ways = both_ways(kernels, float(now.state[ANGLE]), begun.acting)
    sense = sense_from_rest(now.time, ways, begun.acting)
    if sense != 0:
        if now.is_stopping and not is_gripping and _is_final(now):
            return replace(begun, reason=SLIDES)
        return replace(begun, sense=sense, happened=(*begun.happened, OFF))
    courses_end = min(piece_from(course, now.time).end for course in (now.clutch, now.brake))
    off = set_off_at(now.time, min(begun.until, courses_end), ways, begun.acting)
    if math.isfinite(off):
        return replace(begun, until=off)
    if not plan.ends_at_rest:
        return begun
    if now.is_stopping and not (is_gripping and math.isfinite(courses_end)):
        return replace(begun, reason=RESTS)
    if not math.isfinite(courses_end):
        return replace(begun, reason=SLIPS_ON if is_gripping else NOTHING_MOVES)
    return begun


def _is_final(now: Moment) -> bool:
    """Whether the brake has come on as far as it will."""
    return not math.isfinite(piece_from(now.brake, now.time).end)


def _reason_of_time(now: Moment, is_gripping: bool) -> int:
    """What has not come about when the time is over."""
    if now.is_stopping:
        return SLIDES if now.state[SPEED] != 0 and _is_final(now) else TIME_IS_OVER
    return SLIPS_ON if is_gripping and not now.is_locked else TIME_IS_OVER
