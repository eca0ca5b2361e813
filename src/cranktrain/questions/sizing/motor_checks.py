"""Every check of one motor for one machine: what is asked of it over what it can do, from its own steady cycle."""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from cranktrain.language import N_, Words, _
from cranktrain.motion import Array
from cranktrain.motors import DeclaredMotor
from cranktrain.questions.drive.settling import settled
from cranktrain.questions.drive.steady_cycle import SpeedOverTurn, largest_over_turn
from cranktrain.questions.drive.steady_turn import DriveInTurn
from cranktrain.questions.reduction.at_angles import reduced_at
from cranktrain.questions.reduction.machines import ReducedMachines
from cranktrain.questions.sizing.motor_limits import MotorLimits, line_start, motor_limits, peak_share, starts_on_line
from cranktrain.questions.sizing.parts import DeclaredDuty
from cranktrain.questions.sizing.starting import inertia_ratio, starts_per_hour
from cranktrain.transient.gearing import Gearing, overall_ratio
from cranktrain.transient.reduced import ReducedMachine

_LOADED, _UNLOADED, _VALVES_OPEN, _BEFORE_CLUTCH = (
    "start_at_worst_angle",
    "unloaded_start",
    "start_with_valves_open",
    "start_behind_clutch",
)
SIZING_CHECKS = (
    "effective_torque",
    "largest_torque",
    _LOADED,
    "start_time",
    "starts_an_hour",
    "inertia_ratio",
    "speed",
)
"""What a motor is checked for, in this order."""
START = SIZING_CHECKS.index(_LOADED)
CHECK_TITLES = {
    "effective_torque": N_("effective torque"),
    "largest_torque": N_("largest torque"),
    _LOADED: N_("start at the worst angle"),
    _UNLOADED: N_("start, unloaded"),
    _VALVES_OPEN: N_("start, suction valves held open"),
    _BEFORE_CLUTCH: N_("start, clutch let go"),
    "start_time": N_("time of a start"),
    "starts_an_hour": N_("starts an hour"),
    "inertia_ratio": N_("ratio of inertias"),
    "speed": N_("speed"),
}
"""What people call the checks."""
_SERVO_RATIO = 10.0
_N_ANGLES = 720


def check_keys(duty: DeclaredDuty, *, has_clutch: bool) -> tuple[str, ...]:
    """What a motor is checked for; of a start without load no angle is the worst."""
    start = _LOADED
    if has_clutch:
        start = _BEFORE_CLUTCH
    elif duty.starts_unloaded:
        start = _UNLOADED
    elif duty.holds_valves_open:
        start = _VALVES_OPEN
    return tuple(start if check == _LOADED else check for check in SIZING_CHECKS)


def is_with_load(check: str) -> bool:
    """Whether a check is of a start with all loads at the worst crank angle."""
    return check == _LOADED


class AskedOfMotor(NamedTuple):
    """What one design asks of its motor, whichever it is, besides the cycle.

    Attributes
    ----------
    worst_torque : float
        The largest static torque over the turn at a start, at the motor. [N·m]
    running_torque : float
        The mean of it, against which the time of a start is reckoned. [N·m]
    inertia : float
        Of all that is driven, its mean over the turn, at the motor without its rotor. [kg·m²]
    """

    worst_torque: float
    running_torque: float
    inertia: float


class CheckedMotor(NamedTuple):
    """Checks of one motor.

    Attributes
    ----------
    shares : Array, shape (check,)
        Up to 1 passes; infinite where it cannot run or start, NaN where a check is not asked for or not known.
    rms, peak : float
        Torque over its steady cycle. [N·m]
    start_time, rotor_heat : float
        Of a start at the lowest voltage. [s, J]
    inertia_ratio : float
    cycle : SpeedOverTurn or None
        Its steady cycle; None where it has none.
    unknown : tuple of Words
        What cannot be checked, as the motor does not say it.
    """

    shares: Array
    rms: float
    peak: float
    start_time: float
    rotor_heat: float
    inertia_ratio: float
    cycle: SpeedOverTurn | None
    unknown: tuple[Words, ...] = ()

    @property
    def largest(self) -> float:
        """Largest share; NaN where nothing is known."""
        return float(np.nanmax(self.shares)) if np.any(~np.isnan(self.shares)) else np.nan


UNCHECKED = CheckedMotor(np.full(len(SIZING_CHECKS), np.nan), *(np.nan,) * 5, cycle=None)


class MotorAtMachine(NamedTuple):
    """A motor of one design at its machine: the machine alone in `machines`, the gearing with this motor's rotor."""

    motor: DeclaredMotor
    design: int
    gearing: Gearing
    machines: ReducedMachines

    @property
    def rotor(self) -> float:
        """Inertia of the rotor; NaN where it is not known. [kg·m²]"""
        return np.nan if self.motor.inertia is None else float(self.motor.inertia[self.design])

    def turning(self) -> DriveInTurn:
        """The drive as it turns forward."""
        machine = self.machines.each[0]
        held = self.motor.is_free(self.design)
        return DriveInTurn(machine, self.motor.of_design(self.design), self.design, self.gearing, is_held=held)


def mean_inertia(machine: ReducedMachine, cycle: float) -> float:
    """Mean of a machine's inertia over the crank angle. [kg·m²]"""
    return float(np.mean(reduced_at(machine, np.arange(_N_ANGLES) * cycle / _N_ANGLES).inertia))


def checked_motor(
    at: MotorAtMachine,
    asked: AskedOfMotor,
    duty: DeclaredDuty,
    machine_design: int,
    held: float | None = None,
    cycle: SpeedOverTurn | None = None,
) -> CheckedMotor:
    """Check one motor.

    Parameters
    ----------
    at : MotorAtMachine
    asked : AskedOfMotor
    duty : DeclaredDuty
    machine_design : int
        Of the duty.
    held : float, optional
        Speed of the crank that a servo motor holds. [rad/s]
    cycle : SpeedOverTurn, optional
        The steady cycle with this motor, where it is known.

    Notes
    -----
    docs/theory/drive, eqs. (25.26), (25.29) and (25.32) to (25.34); the torque is that of the steady cycle with this
    motor, its rotor and its slip among it.
    """
    own = int(machine_design)
    limits = motor_limits(at.motor, at.design, float(duty.reserve[own]))
    if cycle is None:
        turning, found = settled(at.turning(), at.machines, held)
    else:
        turning, found = at.turning().at(cycle.mesh.nodes), cycle
    rms, peak, of_peak, of_speed = _cycle_shares(at, turning, found, limits)
    begun = line_start(at.motor, at.design, limits, _known(at.rotor) + asked.inertia, asked.running_torque)
    time, heat = float(begun.time), float(begun.rotor_heat)
    longest = float(duty.longest_start[own])
    ratio = float(inertia_ratio(np.asarray(asked.inertia), np.asarray(1.0), np.asarray(at.rotor or np.nan)))
    shares = (
        rms / (float(duty.factor[own]) * limits.rated),
        of_peak,
        _part_of(max(asked.worst_torque, 0.0), limits.reserve * limits.start),
        _start_share(at, time, longest),
        float(duty.starts_per_hour[own]) / _allowed_starts(at, asked, duty, own),
        ratio / _largest_ratio(at, float(duty.inertia_ratio[own])),
        of_speed,
    )
    return CheckedMotor(np.array(shares), rms, peak, time, heat, ratio, found, tuple(_unknown(limits, duty)))


def _unknown(limits: MotorLimits, duty: DeclaredDuty) -> Iterator[Words]:
    """What cannot be checked, as the motor does not say it; of a rated torque where a duty asks for it."""
    if duty.is_asked and np.isnan(limits.rated):
        yield _("effective torque: its table says no rated one")
    if limits.unknown:
        yield limits.unknown


def _cycle_shares(
    at: MotorAtMachine, turning: DriveInTurn, found: SpeedOverTurn | None, limits: MotorLimits
) -> tuple[float, float, float, float]:
    """Rms and largest torque over the steady cycle, and the shares of what it can give for a moment, and of speed."""
    if found is None:
        return np.inf, np.nan, np.inf, np.nan
    torque, speed = turning.motor_torque(found.speed), found.speed * overall_ratio(at.gearing)
    rms = float(np.sqrt(found.over_time(torque**2)))
    top = float(at.motor.top_speed[at.design]) if at.motor.law.is_commanded else np.inf
    of_speed = float(np.max(speed)) / top if np.isfinite(top) else np.nan
    peak = max(turning.largest_torque(found), turning.largest_torque(found, -1.0))

    def share(angle: Array, there: Array) -> Array:
        return peak_share(
            at.motor, at.design, limits, turning.torque_at(angle, there), there * overall_ratio(at.gearing)
        )

    return rms, peak, largest_over_turn(found, share), of_speed


def _part_of(asked: float, there: float) -> float:
    """What is asked for in parts of what there is; infinite where there is nothing."""
    return asked / there if there != 0 else np.inf if asked > 0 else 0.0


def _start_share(at: MotorAtMachine, time: float, longest: float) -> float:
    """Share of the time that a start may take; infinite where the motor gets stuck."""
    if np.isnan(longest) or not starts_on_line(at.motor, at.design):
        return np.nan
    return time / longest if not np.isnan(time) else np.inf


def _allowed_starts(at: MotorAtMachine, asked: AskedOfMotor, duty: DeclaredDuty, own: int) -> float:
    """Starts that the motor may make with this machine. [Hz]"""
    alone, left = duty.unloaded_starts[own], duty.start_load_factor[own]
    return float(starts_per_hour(alone, np.asarray(at.rotor), np.asarray(asked.inertia), left))


def _largest_ratio(at: MotorAtMachine, given: float) -> float:
    """Ratio of inertias that is allowed: as given, or what servo motors like."""
    return _SERVO_RATIO if np.isnan(given) and at.motor.law.is_commanded else given


def _known(inertia: float) -> float:
    return 0.0 if np.isnan(inertia) else inertia
