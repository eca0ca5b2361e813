"""Cage motor started in star and switched over to delta."""

from typing import NamedTuple

from cranktrain.language import N_
from cranktrain.motion import Array, chosen, single
from cranktrain.motors.cage.law import CageCurrent, CageMotor, cage_breaks, cage_current, cage_torque
from cranktrain.motors.declared import star_limits
from cranktrain.motors.induction.current import rotor_heat
from cranktrain.motors.law import MotorBreaks, MotorLaw

STAR = single(1 / 3)
"""Torque and line current in star, in parts of those in delta."""


class StarDelta(NamedTuple):
    """A cage motor, when it is switched over since the start [s], and how long it is without current then [s]."""

    motor: CageMotor
    change_time: Array
    pause: Array


def star_delta_torque(speed: Array, time: Array, geometry: StarDelta) -> Array:
    """Torque in star, none while switching, torque in delta. [N·m]

    Parameters
    ----------
    speed : Array, shape (..., n)
        [rad/s]
    time : Array, broadcastable
        Since it was switched on. [s]
    geometry : StarDelta, fields broadcastable to (..., 1)
        Where a speed decides on the change, its time is what is found, and put in here.

    Notes
    -----
    docs/theory/drive, eq. (25.12).
    """
    return part_of_delta(time, geometry.change_time, geometry.pause) * cage_torque(speed, geometry.motor)


def part_of_delta(time: Array, change_time: Array, pause: Array) -> Array:
    """Torque or line current in parts of those in delta: in star, none while switching, in delta."""
    since = time - change_time
    return chosen(since < 0, STAR, chosen(since < pause, 0.0, 1.0))


def star_delta_breaks(geometry: StarDelta) -> MotorBreaks:
    """Those of the motor's curve, and where it is switched."""
    times = (geometry.change_time, geometry.change_time + geometry.pause)
    return cage_breaks(geometry.motor)._replace(times=times)


def star_delta_heat(speed: Array, time: Array, geometry: StarDelta) -> Array:
    """The same in star and in delta. [W]"""
    return rotor_heat(star_delta_torque(speed, time, geometry), speed, geometry.motor.synchronous_speed)


class StarDeltaCurrent(NamedTuple):
    """The same, when it is switched over [s], and how long it is without current then [s]."""

    motor: CageCurrent
    change_time: Array
    pause: Array


def star_delta_current(speed: Array, time: Array, geometry: StarDeltaCurrent) -> Array:
    """Line current in star, none while switching, and in delta. docs/theory/drive, eqs. (25.11) and (25.12)."""
    part = part_of_delta(time, geometry.change_time, geometry.pause)
    return part * cage_current(speed, time, geometry.motor)


STAR_DELTA = MotorLaw(
    "star_delta",
    N_("cage motor, star–delta"),
    star_delta_torque,
    StarDelta,
    "docs/theory/drive, eq. (25.12)",
    N_("a motor built for delta at the line's voltage; what the fields do while switching is left out"),
    is_timed=True,
    breaks=star_delta_breaks,
    limits=star_limits,
    heat=star_delta_heat,
    current=star_delta_current,
    is_on_line=True,
)
