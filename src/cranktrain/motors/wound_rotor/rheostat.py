"""Rheostats of wound rotors: resistance in steps that go out by slip or by time."""

from typing import NamedTuple

import numpy as np

from cranktrain.language import N_
from cranktrain.motion import Array
from cranktrain.motors.declared import curve_limits
from cranktrain.motors.induction.kloss import slip_of
from cranktrain.motors.law import MotorBreaks, MotorLaw
from cranktrain.motors.wound_rotor.law import WoundRotor, wound_rotor_heat, wound_rotor_torque


class Rheostat(NamedTuple):
    """Resistance in steps: by what factor each lowers the rotor circuit's, more than 1, and how many there are."""

    step_ratio: Array
    n_steps: Array


class SteppedRotor(NamedTuple):
    """A motor with slip rings, shorted in `rotor`, and a rheostat whose steps go out as the slip falls."""

    rotor: WoundRotor
    rheostat: Rheostat


class TimedRotor(NamedTuple):
    """The same with steps that go out one after the other, each after an interval [s]."""

    rotor: WoundRotor
    rheostat: Rheostat
    interval: Array


class ResistanceSteps(NamedTuple):
    """Steps between two torques.

    Attributes
    ----------
    ratio : Array, shape (...)
        λ, from torque to torque and from resistance to resistance. [1]
    switching_torque : Array, shape (...)
        At which a step goes out, in parts of the rated torque.
    resistance : Array, shape (..., step)
        All of the rotor's circuit in every step, in parts of the rotor's own.
    slip : Array, shape (..., step)
        At which each goes out.
    """

    ratio: Array
    switching_torque: Array
    resistance: Array
    slip: Array


def stepped_rotor_torque(speed: Array, geometry: SteppedRotor) -> Array:
    """Torque of a rotor whose steps go out where the slip falls to theirs, and come back where it rises. [N·m]

    Parameters
    ----------
    speed : Array, shape (..., n)
        [rad/s]
    geometry : SteppedRotor, fields broadcastable to (..., 1)

    Notes
    -----
    docs/theory/drive, eqs. (25.16) and (25.17): at the slip s as many are out as λ^(−j) ≥ s has j.
    """
    return wound_rotor_torque(speed, stepped_rotor(speed, geometry))


def stepped_rotor(speed: Array, geometry: SteppedRotor) -> WoundRotor:
    """Rotor with the steps that are left at a speed. docs/theory/drive, eq. (25.17)."""
    slip = np.maximum(slip_of(speed, geometry.rotor.synchronous_speed), 1e-300)
    n_out = np.maximum(0, np.floor(-np.log(slip) / np.log(geometry.rheostat.step_ratio)))
    return _with_steps_out(geometry.rotor, geometry.rheostat, n_out)


def timed_rotor_torque(speed: Array, time: Array, geometry: TimedRotor) -> Array:
    """Torque of a rotor whose steps go out by time. [N·m]

    Parameters
    ----------
    speed : Array, shape (..., n)
        [rad/s]
    time : Array, broadcastable
        Since it was switched on. [s]
    geometry : TimedRotor, fields broadcastable to (..., 1)

    Notes
    -----
    docs/theory/drive, eq. (25.16).
    """
    return wound_rotor_torque(speed, timed_rotor(time, geometry))


def timed_rotor(time: Array, geometry: TimedRotor) -> WoundRotor:
    """Rotor with the steps that are left at a time. [s]"""
    n_out = np.maximum(0, np.floor(time / geometry.interval))
    return _with_steps_out(geometry.rotor, geometry.rheostat, n_out)


def _with_steps_out(rotor: WoundRotor, rheostat: Rheostat, n_out: Array) -> WoundRotor:
    """Rotor with what is left of its rheostat."""
    n_left = np.maximum(0, rheostat.n_steps - n_out)
    resistance = rotor.resistance * rheostat.step_ratio**n_left
    return WoundRotor(rotor.synchronous_speed, rotor.breakdown_torque, rotor.breakdown_slip, resistance)


def resistance_steps(n_steps: int, peak_torque: Array, rated_slip: Array) -> ResistanceSteps:
    """Steps with which the torque goes to and fro between a peak and one torque at which every step goes out.

    Parameters
    ----------
    n_steps : int
    peak_torque : Array
        In parts of the rated one.
    rated_slip : Array, broadcastable

    Returns
    -------
    ResistanceSteps

    Notes
    -----
    On the straight part of the curves, M = s R₂/(s_n R). docs/theory/drive, eq. (25.17).

    Examples
    --------
    >>> steps = resistance_steps(3, 2.0, 0.03)
    >>> round(float(steps.ratio), 6), round(float(steps.switching_torque), 5)
    (2.554365, 0.78297)
    """
    ratio = (1 / (rated_slip * np.asarray(peak_torque, dtype=float))) ** (1 / n_steps)
    step = np.arange(1, n_steps + 1)
    across = ratio[..., np.newaxis]
    return ResistanceSteps(ratio, peak_torque / ratio, across ** (n_steps + 1 - step), across ** -step.astype(float))


def fewest_steps(peak_torque: Array, rated_slip: Array, load: Array) -> Array:
    """Fewest steps whose switching torque is not below a load; torques in parts of the rated one.

    NaN where the load is not below the peak. docs/theory/drive, eq. (25.17).
    """
    with np.errstate(divide="ignore", invalid="ignore"):
        n_steps = np.log(1 / (rated_slip * peak_torque)) / np.log(np.divide(peak_torque, load))
        return np.where(np.greater(peak_torque, load), np.ceil(n_steps), np.nan)


def stepped_breaks(geometry: SteppedRotor) -> MotorBreaks:
    """Speeds at which steps go out."""
    most = int(np.max(geometry.rheostat.n_steps))
    speeds = (
        geometry.rotor.synchronous_speed * (1 - geometry.rheostat.step_ratio**-j) for j in np.arange(1.0, most + 1.0)
    )
    kept = (j <= geometry.rheostat.n_steps for j in range(1, most + 1))
    return MotorBreaks(tuple(np.where(is_one, speed, np.nan) for speed, is_one in zip(speeds, kept, strict=True)))


def timed_breaks(geometry: TimedRotor) -> MotorBreaks:
    """Times at which steps go out."""
    most = int(np.max(geometry.rheostat.n_steps))
    return MotorBreaks(
        times=tuple(np.where(j <= geometry.rheostat.n_steps, j * geometry.interval, np.nan) for j in range(1, most + 1))
    )


def stepped_rotor_heat(speed: Array, time: Array, geometry: SteppedRotor) -> Array:
    """The same with steps that go out as the slip falls. [W]"""
    return wound_rotor_heat(speed, time, stepped_rotor(speed, geometry))


def timed_rotor_heat(speed: Array, time: Array, geometry: TimedRotor) -> Array:
    """The same with steps that go out by time. [W]"""
    return wound_rotor_heat(speed, time, timed_rotor(time, geometry))


STEPPED_ROTOR = MotorLaw(
    "stepped_rotor",
    N_("motor with slip rings, steps by slip"),
    stepped_rotor_torque,
    SteppedRotor,
    "docs/theory/drive, eqs. (25.16) and (25.17)",
    N_("steps of one ratio, which switch at once"),
    breaks=stepped_breaks,
    limits=curve_limits,
    heat=stepped_rotor_heat,
    is_on_line=True,
)

TIMED_ROTOR = MotorLaw(
    "timed_rotor",
    N_("motor with slip rings, steps by time"),
    timed_rotor_torque,
    TimedRotor,
    "docs/theory/drive, eq. (25.16)",
    N_("steps of one ratio, which switch at once"),
    is_timed=True,
    breaks=timed_breaks,
    limits=curve_limits,
    heat=timed_rotor_heat,
    is_on_line=True,
)
