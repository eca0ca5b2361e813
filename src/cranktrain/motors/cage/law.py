"""Cage motor by its torque over slip: by values of a catalogue, or by Kloss's formula."""

from typing import Any, NamedTuple

import numpy as np

from cranktrain.language import N_
from cranktrain.motion import Array, chosen, single
from cranktrain.motors.declared import peak_limits
from cranktrain.motors.induction.breakdown_slip import slip_from_rated
from cranktrain.motors.induction.current import line_current, rotor_heat
from cranktrain.motors.induction.kloss import kloss_torque, slip_of
from cranktrain.motors.law import BriefLimits, MotorBreaks, MotorLaw

PULL_UP_SLIP = single(0.8)
"""Where the torque between standstill and breakdown is taken to be least, if nothing is known: typical."""


class CageMotor(NamedTuple):
    """A cage motor's torque over slip.

    Attributes
    ----------
    synchronous_speed : Array
        Of the field; negative where it turns the other way, as in plugging. [rad/s]
    breakdown_torque, breakdown_slip : Array
        The largest torque of a motor that drives, and where. [N·m, 1]
    asymmetry : Array
        ε of Kloss's formula, 0 in the simplified one. [1]
    kloss_until : Array
        Up to which slip his formula holds; infinite where it holds for all.
    pull_up_torque, pull_up_slip : Array
        The least torque between standstill and breakdown, and where. [N·m, 1]
    starting_torque : Array
        At standstill, and of a shaft that turns against the field. [N·m]
    """

    synchronous_speed: Array
    breakdown_torque: Array
    breakdown_slip: Array
    asymmetry: Array
    kloss_until: Array
    pull_up_torque: Array
    pull_up_slip: Array
    starting_torque: Array


class CatalogueValues(NamedTuple):
    """What a catalogue prints of a cage motor; torques but the rated one in parts of that.

    Attributes
    ----------
    rated_torque, rated_speed, synchronous_speed : Array
        [N·m, rad/s, rad/s]
    breakdown_ratio, starting_ratio, pull_up_ratio : Array
        [1]
    """

    rated_torque: Array
    rated_speed: Array
    synchronous_speed: Array
    breakdown_ratio: Array
    starting_ratio: Array
    pull_up_ratio: Array


def torque_at_slip(slip: Array, motor: CageMotor) -> Array:
    """Torque in the sense of the field at a slip, at rated voltage and frequency. [N·m]

    Notes
    -----
    docs/theory/drive, eqs. (25.2) and (25.8).
    """
    kloss = kloss_torque(slip, motor.breakdown_torque, motor.breakdown_slip, motor.asymmetry)
    fall = (slip - motor.breakdown_slip) / (motor.pull_up_slip - motor.breakdown_slip)
    falling = motor.breakdown_torque - (motor.breakdown_torque - motor.pull_up_torque) * fall * fall * (3 - 2 * fall)
    rise = (slip - motor.pull_up_slip) / (1 - motor.pull_up_slip)
    rising = motor.pull_up_torque + (motor.starting_torque - motor.pull_up_torque) * rise * rise * (1.5 - 0.5 * rise)
    beyond = chosen(slip < 1, rising, motor.starting_torque)
    return chosen(slip <= motor.kloss_until, kloss, chosen(slip < motor.pull_up_slip, falling, beyond))


def cage_torque(speed: Array, motor: CageMotor) -> Array:
    """Torque of a cage motor switched directly onto its line.

    Parameters
    ----------
    speed : Array, shape (..., n)
        Of its shaft. [rad/s]
    motor : CageMotor, fields broadcastable to (..., 1)

    Returns
    -------
    Array, shape (..., n)
        [N·m]

    Notes
    -----
    docs/theory/drive, eqs. (25.1), (25.2) and (25.8).

    Examples
    --------
    >>> motor = kloss_curve(157.0, 95.0, 0.2)
    >>> round(float(cage_torque(0.8 * 157.0, motor)), 9), round(float(cage_torque(0.0, motor)), 6)
    (95.0, 36.538462)
    """
    return np.sign(motor.synchronous_speed) * torque_at_slip(slip_of(speed, motor.synchronous_speed), motor)


def catalogue_curve(values: CatalogueValues, pull_up_slip: Array = PULL_UP_SLIP) -> CageMotor:
    """Curve through rated point, breakdown, pull-up and start of a catalogue.

    Parameters
    ----------
    values : CatalogueValues, of any shapes that broadcast
    pull_up_slip : Array, optional

    Returns
    -------
    CageMotor
        Its torque is NaN where the breakdown slip is not below that of the pull-up, or no breakdown torque is above
        the rated one.

    Notes
    -----
    docs/theory/drive, eqs. (25.5) and (25.8).
    """
    rated, speed, synchronous, breakdown, start, pull_up = values
    slip = slip_from_rated(slip_of(speed, synchronous), breakdown)
    is_one = (slip < pull_up_slip) & (pull_up_slip < 1)
    torque = chosen(is_one, rated, np.nan)
    return CageMotor(
        synchronous, breakdown * torque, slip, 0 * slip, slip, pull_up * torque, pull_up_slip, start * torque
    )


def kloss_curve(
    synchronous_speed: Array, breakdown_torque: Array, breakdown_slip: Array, asymmetry: Array | float = 0.0
) -> CageMotor:
    """Curve by Kloss's formula at all slips, simplified unless the asymmetry is given; fields as of `CageMotor`."""
    start = kloss_torque(single(1.0), breakdown_torque, breakdown_slip, single(0.0) + asymmetry)
    nowhere = breakdown_slip + 2.0
    return CageMotor(
        synchronous_speed,
        breakdown_torque,
        breakdown_slip,
        single(0.0) + asymmetry,
        single(np.inf) + 0 * breakdown_slip,
        start,
        nowhere,
        start,
    )


def cage_breaks(motor: CageMotor) -> MotorBreaks:
    """Speeds at which one piece of the curve ends and the next begins; none of Kloss's formula alone."""
    slips = (motor.breakdown_slip, motor.pull_up_slip, 1 + 0 * motor.breakdown_slip)
    is_pieced = np.isfinite(motor.kloss_until)
    return MotorBreaks(tuple(np.where(is_pieced, motor.synchronous_speed * (1 - slip), np.nan) for slip in slips))


def cage_heat(speed: Array, _time: Array, motor: CageMotor) -> Array:
    """Power that turns to heat in a cage, direct on line. [W]

    docs/theory/drive, eq. (25.9).
    """
    return rotor_heat(cage_torque(speed, motor), speed, motor.synchronous_speed)


class CageCurrent(NamedTuple):
    """What it hangs on: speed of the field, slip at breakdown, current at standstill over the rated one.

    In [rad/s, 1, 1].
    """

    synchronous_speed: Array
    breakdown_slip: Array
    starting_current: Array


def cage_current(speed: Array, _time: Array, motor: CageCurrent) -> Array:
    """Line current direct on line. docs/theory/drive, eq. (25.11)."""
    return line_current(slip_of(speed, motor.synchronous_speed), motor.breakdown_slip, motor.starting_current)


def _limits(motor: Any, design: int) -> BriefLimits:
    """What it can do for a moment, of which it breaks down at most."""
    return peak_limits(motor, design, float(motor.numbers.breakdown_torque[design]))


CAGE = MotorLaw(
    "cage",
    N_("cage motor, direct on line"),
    cage_torque,
    CageMotor,
    "docs/theory/drive, eqs. (25.1) to (25.8)",
    N_("steady torque at rated voltage and frequency; what turns against the field has the starting torque"),
    breaks=cage_breaks,
    limits=_limits,
    heat=cage_heat,
    current=cage_current,
    is_on_line=True,
)
