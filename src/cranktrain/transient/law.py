"""The law of gearing as the equation of motion asks for it again and again: one stage written out, several by lines.

For one pattern of signs all torques in the gearing are lines over acceleration, inertia and load, whose coefficients
are the gearing's alone: they are made once for a run.
"""

from typing import Any, NamedTuple

import numpy as np

from cranktrain.motion import Array
from cranktrain.transient.gearing import Gearing, overall_ratio

_SLOPE, _FACTOR, _DRAG, _IS_ONLY, _DRAG_AT_CRANK, _OF_STAGES = range(6)
"""Columns of lines: M = (slope + factor·J) ε + factor·H + drag; whether what fits is the only one; then the stages'."""
_AT, _BY_INERTIA, _OF_DRAG, _LOST, _COLUMNS = range(5)
"""Columns of a stage: x = (at + by inertia·J) ε + by inertia·H + of drag, of which a part is lost at the crank."""
_SAME = 1e-12
"""Accelerations that differ by less, in parts of them, are one."""


class OneStage(NamedTuple):
    """Gearing of one stage, or of none, whose ratio is 1; of several only their overall ratio says anything.

    Attributes
    ----------
    is_all : bool
    ratio, forward, backward, drag, inertia
        As of `Gearing`; forward is 1 over the efficiency.
    motor : float
        Inertia of the motor, at the crank. [kg·m²]
    """

    is_all: bool
    ratio: float
    forward: float
    backward: float
    drag: float
    inertia: float
    motor: float


def in_one_stage(gearing: Gearing) -> OneStage:
    """Numbers of the one stage, or of none."""
    ratio, own = float(overall_ratio(gearing)), float(gearing.motor_inertia)
    if len(gearing.ratio) != 1:
        is_all = len(gearing.ratio) == 0
        return OneStage(is_all, ratio, 1.0, 1.0, 0.0, 0.0, own * ratio * ratio)
    forward, backward, drag, inertia = (float(each[0]) for each in gearing[2:])
    return OneStage(True, ratio, 1.0 / forward, backward, drag, inertia, own * ratio * ratio)


def lines_of(gearing: Gearing) -> Array:
    """Coefficients of torques in the gearing, a row for each pattern of signs; none where one stage says all.

    docs/theory/transient, eq. (26.5).
    """
    n = len(gearing.ratio)
    is_only = bool(np.all(gearing.backward > 0))
    if n <= 1 and is_only and gearing.motor_inertia > 0:
        return np.empty((0, _OF_STAGES))
    rows = np.zeros((1 << n, _OF_STAGES + _COLUMNS * n))
    for pattern, row in enumerate(rows):
        slope, factor, drag, overall = 0.0, 1.0, 0.0, 1.0
        for stage in range(n - 1, -1, -1):
            slope += gearing.inertia[stage] * overall
            part = gearing.backward[stage] if pattern >> stage & 1 else 1.0 / gearing.forward[stage]
            first = _OF_STAGES + _COLUMNS * stage
            row[first : first + _COLUMNS] = slope, factor, drag, (part - 1.0) * overall
            through = part / gearing.ratio[stage]
            slope, factor, drag = slope * through, factor * through, drag * through + gearing.drag[stage]
            overall *= gearing.ratio[stage]
            row[_DRAG_AT_CRANK] += gearing.drag[stage] * overall
        row[_SLOPE], row[_FACTOR], row[_DRAG] = slope + gearing.motor_inertia * overall, factor, drag
        row[_IS_ONLY] = is_only
    return rows


def accelerated(
    torque: float, sense: float, inertia: float, load: float, one: OneStage, rows: Any
) -> tuple[float, float]:
    """Acceleration of the crank, and what losses take there, NaN where none or several satisfy the law. [rad/s², N·m]

    As `gearing.acceleration`, with `lines_of` the gearing as rows; docs/theory/transient, eq. (26.4) with drag.
    """
    whole = inertia + one.inertia
    if one.is_all and one.motor + one.backward * whole > 0:
        rubbed = one.ratio * one.drag * sense
        driving = one.ratio * torque - rubbed
        passed_on = (whole * driving + one.motor * load) * sense
        factor = one.forward if passed_on > 0 else one.backward
        grown = (driving - factor * load) / (one.motor + factor * whole)
        return grown, (factor - 1.0) * (whole * grown + load) + rubbed
    found, lost, n_found = np.nan, np.nan, 0
    for tried in range(len(rows)):
        # a load that resists is mostly driven through all stages, one that drives drives all of them
        pattern = tried if load * sense > 0 else len(rows) - 1 - tried
        row = rows[pattern]
        whole_at_motor = row[_SLOPE] + row[_FACTOR] * inertia
        if whole_at_motor == 0.0:  # irreversible: no acceleration changes the torque that is left
            continue
        trial = (torque - row[_FACTOR] * load - row[_DRAG] * sense) / whole_at_motor
        fits, taken = True, row[_DRAG_AT_CRANK] * sense
        for stage in range((len(row) - _OF_STAGES) // _COLUMNS):
            at = _OF_STAGES + _COLUMNS * stage
            by_inertia = row[at + _BY_INERTIA]
            output = (row[at + _AT] + by_inertia * inertia) * trial + by_inertia * load + row[at + _OF_DRAG] * sense
            flow = output * sense
            fits = flow <= 0 if pattern >> stage & 1 else flow >= 0
            if not fits:
                break
            taken += row[at + _LOST] * output
        if fits and (n_found == 0 or abs(trial - found) > _SAME * abs(found)):
            found, lost, n_found = trial, taken, n_found + 1
            if row[_IS_ONLY] > 0:
                break
    if n_found != 1:
        return np.nan, np.nan
    return found, lost
