"""The law of gearing as the equation of motion asks for it again and again: one stage or none written out."""

from typing import Any, NamedTuple

import numpy as np

from cranktrain.questions.drive.running.gearing import UNIQUE, Gearing, acceleration, overall_ratio


class OneStage(NamedTuple):
    """Gearing of one stage, or of none, whose ratio is 1; of several only their overall ratio says anything.

    Attributes
    ----------
    is_all : bool
    ratio, forward, backward, drag, inertia
        As of `Gearing`; forward is 1 over the efficiency.
    motor_inertia, motor : float
        Inertia of the motor, its own and at the crank. [kg·m²]
    """

    is_all: bool
    ratio: float
    forward: float
    backward: float
    drag: float
    inertia: float
    motor_inertia: float
    motor: float


def in_one_stage(gearing: Gearing) -> OneStage:
    """Numbers of the one stage, or of none."""
    ratio, own = float(overall_ratio(gearing)), float(gearing.motor_inertia)
    if len(gearing.ratio) != 1:
        is_all = len(gearing.ratio) == 0
        return OneStage(is_all, ratio, 1.0, 1.0, 0.0, 0.0, own, own * ratio * ratio)
    _, _, forward, backward, drag, inertia = (float(np.ravel(each)[0]) for each in gearing)
    return OneStage(True, ratio, 1.0 / forward, backward, drag, inertia, own, own * ratio * ratio)


def accelerated(
    torque: float, sense: float, inertia: float, load: float, one: OneStage, rows: Any
) -> tuple[float, float]:
    """Acceleration of the crank, and what losses take there, NaN where none or several satisfy the law. [rad/s², N·m]

    As `gearing.acceleration`, with the stages' numbers in rows; docs/theory/transient, eq. (26.4) with drag.
    """
    whole = inertia + one.inertia
    if one.is_all and one.motor + one.backward * whole > 0:
        rubbed = one.ratio * one.drag * sense
        driving = one.ratio * torque - rubbed
        passed_on = (whole * driving + one.motor * load) * sense
        factor = one.forward if passed_on > 0 else one.backward
        grown = (driving - factor * load) / (one.motor + factor * whole)
        return grown, (factor - 1.0) * (whole * grown + load) + rubbed
    gearing = Gearing(one.motor_inertia, rows[0], rows[1], rows[2], rows[3], rows[4])
    grown, lost, count = acceleration(torque, sense, inertia, load, gearing)
    if count != UNIQUE:
        return np.nan, np.nan
    return grown, lost
