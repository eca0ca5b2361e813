"""Which size of a range is enough for a torque over time, a start and a duty: every check of every size."""

from typing import NamedTuple

import numpy as np

from cranktrain.motion import Array, single
from cranktrain.motors.cage.catalogue import MotorRange
from cranktrain.motors.cage.law import CageMotor, cage_torque, catalogue_curve
from cranktrain.motors.induction.kloss import slip_of
from cranktrain.questions.sizing.checks import (
    CRITERIA,
    VOLTAGE_RESERVE,
    MotorChoice,
    TorqueDemand,
    choice_of,
    motor_uses,
)
from cranktrain.questions.sizing.duty import DUTY_PERIOD, intermittent_factor, no_load_factor, rms_torque
from cranktrain.questions.sizing.starting import inertia_ratio, loaded_start

ALL_CRITERIA = (*CRITERIA, "start_time")
"""What a size is checked for, in this order along the last axis of its uses."""
_END_SLIP = 2.0
"""Slip at which a start counts as over, in parts of the rated one: what is left is settling."""


class TorqueHistory(NamedTuple):
    """Torque at the motor's shaft over a cycle, on straight lines between its points.

    Attributes
    ----------
    torque : Array, shape (..., n)
        Without that which the rotor itself takes. [N·m]
    time : Array, shape (..., n)
        Rising; twice the same where the torque jumps. [s]
    acceleration : Array, broadcastable to (..., n)
        Of the motor's shaft: what its own inertia takes is added for every size. [rad/s²]
    """

    torque: Array
    time: Array
    acceleration: Array = single(0.0)


class StartDemand(NamedTuple):
    """What a start asks for at the motor's shaft, shape (...).

    Attributes
    ----------
    worst_torque : Array
        The largest static torque over the turn, with which the motor may have to start. [N·m]
    inertia : Array
        Of all that is driven, its mean over the turn, without the rotor. [kg·m²]
    running_torque : Array
        Against which it comes up to speed, a mean over the turn. [N·m]
    longest : Array
        Time that a start may take; infinite where nobody asks. [s]
    """

    worst_torque: Array
    inertia: Array = single(0.0)
    running_torque: Array = single(0.0)
    longest: Array = single(float("inf"))


class SizeChoice(NamedTuple):
    """Checks of every size, and the smallest that passes.

    Attributes
    ----------
    uses : Array, shape (..., motor, criterion)
        What is asked of every size over what it can do, of each of `ALL_CRITERIA`; infinite where it never comes up to
        speed.
    choice : MotorChoice
        The smallest that is enough, what governs it, and by how much the next smaller one misses.
    rms, peak : Array, shape (..., motor)
        Torque of every size with what its own rotor takes. [N·m]
    start_time, rotor_heat : Array, shape (..., motor)
        Of a start at the lowest voltage; NaN where the size gets stuck. [s, J]
    inertia_ratio : Array, shape (..., motor)
        Inertia of what is driven over the rotor's; NaN where that is not known.
    """

    uses: Array
    choice: MotorChoice
    rms: Array
    peak: Array
    start_time: Array
    rotor_heat: Array
    inertia_ratio: Array


def of_pieces(torque: Array, duration: Array) -> TorqueHistory:
    """Torque that is constant for a time, and then another one; both of shape (..., n). [N·m, s]"""
    end = np.cumsum(duration, axis=-1)
    begin = end - duration
    return TorqueHistory(np.repeat(torque, 2, axis=-1), np.stack((begin, end), axis=-1).reshape((*end.shape[:-1], -1)))


def of_period(torque: Array, period: Array, acceleration: Array | float = 0.0) -> TorqueHistory:
    """Torque in equal steps of time over a period [s], its end excluded, shape (..., n)."""

    def closed(samples: Array) -> Array:
        return np.concatenate((samples, samples[..., :1]), axis=-1)

    time = np.linspace(0.0, 1.0, torque.shape[-1] + 1) * np.asarray(period)[..., np.newaxis]
    along = np.broadcast_to(acceleration, torque.shape)
    return TorqueHistory(closed(torque), time, closed(along))


def duty_factor(
    duty: str,
    *,
    share: Array | float = 0.4,
    period: Array | float = DUTY_PERIOD,
    time_constant: Array | float = 1800.0,
    cooling: Array | float = 0.5,
    constant_share: Array | float = 0.0,
) -> Array:
    """By what factor the torque under load may be above the rated one.

    Parameters
    ----------
    duty : {"S1", "S3", "S6"}
        Running on; periods with rest; periods without load in place of rest.
    share : Array
        Of the period, under load.
    period, time_constant : Array
        Of the duty; of the motor's heat. [s]
    cooling, constant_share : Array
        As of `sizing.duty`.

    Notes
    -----
    docs/theory/drive, eq. (25.30).

    Examples
    --------
    >>> float(duty_factor("S1")), round(float(duty_factor("S3")), 8)
    (1.0, 1.2911991)
    """
    on = np.multiply(share, period)
    off = period - on
    constant = np.asarray(time_constant)
    if duty == "S3":
        return intermittent_factor(on, off, constant, cooling=cooling, constant_share=constant_share)
    if duty == "S6":
        return no_load_factor(on, off, constant, constant_share=constant_share)
    return np.ones(np.broadcast_shapes(np.shape(on), np.shape(constant)))


def size_choice(
    history: TorqueHistory,
    start: StartDemand,
    motors: MotorRange,
    duty: Array | float = 1.0,
    reserve: float = VOLTAGE_RESERVE,
) -> SizeChoice:
    """Check every size of a range.

    Parameters
    ----------
    history : TorqueHistory
        Over the time under load.
    start : StartDemand, fields of shape (...)
    motors : MotorRange
        By rising power.
    duty : Array, shape (...)
        Factor of `duty_factor`.
    reserve : float
        What is left of the torques at the lowest voltage.

    Returns
    -------
    SizeChoice

    Notes
    -----
    docs/theory/drive, eqs. (25.26), (25.29), (25.32) and (25.34).

    Examples
    --------
    >>> from cranktrain.motors.cage.catalogue import four_pole_motors
    >>> history = of_pieces(np.array([30.0, 5.0]), np.array([1.0, 3.0]))
    >>> found = size_choice(history, StartDemand(np.array(28.0)), four_pole_motors())
    >>> float(four_pole_motors().power[found.choice.motor]), ALL_CRITERIA[found.choice.governs]
    (3000.0, 'start')
    """
    acceleration = np.broadcast_to(history.acceleration, history.torque.shape)
    own = acceleration[..., np.newaxis, :] * motors.inertia[:, np.newaxis]
    torque = history.torque[..., np.newaxis, :] + own
    rms = rms_torque(torque, history.time[..., np.newaxis, :])
    peak = np.max(np.abs(torque), axis=-1)
    worst = np.asarray(start.worst_torque)[..., np.newaxis]
    demand = TorqueDemand(rms / np.asarray(duty)[..., np.newaxis], peak, np.broadcast_to(worst, rms.shape))
    begun = _starts(start, motors, reserve)
    longest = np.asarray(start.longest)[..., np.newaxis]
    in_time = np.where(np.isnan(begun[0]), np.inf, begun[0] / longest)
    uses = motor_uses(demand, motors, reserve)
    uses = np.concatenate((uses, np.broadcast_to(in_time, uses.shape[:-1])[..., np.newaxis]), axis=-1)
    driven = np.asarray(start.inertia)[..., np.newaxis]
    rotor = np.where(motors.inertia > 0, motors.inertia, np.nan)
    return SizeChoice(uses, choice_of(uses), rms, peak, *begun, inertia_ratio(driven, single(1.0), rotor))


def _starts(start: StartDemand, motors: MotorRange, reserve: float) -> tuple[Array, Array]:
    """Time and rotor heat of a start of every size at the lowest voltage, against a constant torque."""
    curve = catalogue_curve(motors.values)
    slips = (1.0 + 0 * curve.pull_up_slip, curve.pull_up_slip, curve.breakdown_slip)
    end = _END_SLIP * slip_of(motors.values.rated_speed, curve.synchronous_speed)
    placed = np.stack(np.broadcast_arrays(*slips, end), axis=-1)
    load = np.asarray(start.running_torque)[..., np.newaxis]
    inertia = np.asarray(start.inertia)[..., np.newaxis] + motors.inertia
    shape = np.broadcast_shapes(load.shape, inertia.shape)
    speeds = np.broadcast_to((1 - placed) * curve.synchronous_speed[:, np.newaxis], (*shape, placed.shape[-1]))
    along = CageMotor(*(np.broadcast_to(field, motors.power.shape)[:, np.newaxis] for field in curve))
    found = loaded_start(
        lambda speed: reserve * cage_torque(speed, along),
        lambda speed: 0 * speed + load[..., np.newaxis],
        inertia,
        curve.synchronous_speed,
        speeds,
    )
    return found.time, found.rotor_heat
