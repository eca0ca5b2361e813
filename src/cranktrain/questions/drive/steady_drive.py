"""Steady running with the motor: speed, torques and losses over the cycle that repeats itself."""

from collections.abc import Iterator
from functools import cached_property
from typing import ClassVar, NamedTuple

import numpy as np

from cranktrain.language import N_, Words, _
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.drive.declared import DeclaredDrive
from cranktrain.layout.speed import Speed
from cranktrain.motion import Array
from cranktrain.motors import DeclaredMotor
from cranktrain.motors.declared import beyond_measured
from cranktrain.questions.drive.balanced_speed import balances
from cranktrain.questions.drive.settling import all_settled, missed_motion
from cranktrain.questions.drive.steady_cycle import SpeedOverTurn, speed_range
from cranktrain.questions.drive.steady_turn import DriveInTurn
from cranktrain.questions.reduction.gear_train import lost_torque
from cranktrain.questions.reduction.machines import ReducedMachines
from cranktrain.record import record
from cranktrain.references import THEORY_OF_EVENNESS as _EVENNESS
from cranktrain.references import THEORY_OF_TRANSIENTS as _TRANSIENTS
from cranktrain.saying.catalogue import quantity
from cranktrain.saying.checks import Check, Checked, Flagged, flags_of_designs
from cranktrain.saying.wording import number
from cranktrain.transient.gearing import overall_ratio

_THEORY = "docs/theory/reduced-machine"
_CURVE = ("crank_angle",)
_SLIP = 0.01
"""What a motor gives for such a part of its speed is what its work is made of, where nothing takes any."""
_ENERGY_LIMIT = 1e-9
_MOTION_LIMIT = 1e-9
_OTHER_PACE = 0.1
"""Of the declared speed: with more, a ratio may be meant for another motor."""
_N_CURVES, _N_FACTS = 5, 11


@record
class SteadyDrive(Checked, Flagged):
    """Steady running with the motor."""

    running: tuple[SpeedOverTurn | None, ...]
    drive_speed: Array = quantity(
        "ω_s",
        "rad/s",
        _CURVE,
        N_("Speed of the crank over the cycle, with its motor"),
        _THEORY,
        "31.6 to 31.8",
        shown="rpm",
    )
    drive_acceleration: Array = quantity(
        "ε_s", "rad/s^2", _CURVE, N_("Angular acceleration of the crank, with its motor"), _THEORY, "31.6"
    )
    motor_speed: Array = quantity(
        "ω_m", "rad/s", _CURVE, N_("Speed of the motor"), _THEORY, "31.6 to 31.8", shown="rpm"
    )
    motor_torque: Array = quantity(
        "M_m", "N*m", _CURVE, N_("Torque of the motor at its own shaft"), _TRANSIENTS, "26.5"
    )
    transmitted_torque: Array = quantity(
        "x",
        "N*m",
        _CURVE,
        N_("Torque that the drive passes on to the crank, load and inertia together"),
        _TRANSIENTS,
        "26.5",
    )
    cycle_time: Array = quantity("T", "s", (), N_("Time of a cycle in steady running"), _EVENNESS, "17.5")
    mean_motor_speed: Array = quantity(
        "ω_m,mean", "rad/s", (), N_("Mean speed of the motor over time"), _EVENNESS, "17.5", shown="rpm"
    )
    drive_fluctuation: Array = quantity(
        "δ_s", "1", (), N_("Coefficient of fluctuation of the crank's speed, with its motor"), _EVENNESS, "17.5"
    )
    mean_motor_torque: Array = quantity(
        "M_m,mean", "N*m", (), N_("Mean torque of the motor over time"), _TRANSIENTS, "26.5"
    )
    rms_motor_torque: Array = quantity(
        "M_m,rms", "N*m", (), N_("Root mean square of the motor's torque over time"), _TRANSIENTS, "26.5"
    )
    largest_motor_torque: Array = quantity("M_m,max", "N*m", (), N_("Largest torque of the motor"), _TRANSIENTS, "26.5")
    smallest_motor_torque: Array = quantity(
        "M_m,min", "N*m", (), N_("Smallest torque of the motor"), _TRANSIENTS, "26.5"
    )
    motor_power: Array = quantity("P_m", "W", (), N_("Mean power of the motor at its shaft"), _TRANSIENTS, "26.10")
    driven_power: Array = quantity("P_Q", "W", (), N_("Mean power that the loads take"), _TRANSIENTS, "26.10")
    lost_power: Array = quantity("P_v", "W", (), N_("Mean power that the drive's stages lose"), _TRANSIENTS, "26.10")
    motor_heat: Array = quantity("P_w", "W", (), N_("Mean power that heats the motor's rotor"), _TRANSIENTS, "26.10")

    needs_motor: ClassVar[str] = DeclaredMotor.needs


@record
class SteadyCycles:
    """The steady cycle of every design: sought when it is first asked for, as many starts end before it.

    Attributes
    ----------
    drives : tuple of DriveInTurn
    machines : ReducedMachines
    held : Array, shape (design,)
        Speed of the crank that is declared; NaN without. [rad/s]
    """

    drives: tuple[DriveInTurn, ...]
    machines: ReducedMachines
    held: Array

    @property
    def turning(self) -> tuple[DriveInTurn, ...]:
        """The drive as it turns in the steady cycle."""
        return tuple(turning for turning, _found in self._each)

    @property
    def found(self) -> tuple[SpeedOverTurn | None, ...]:
        """The steady cycles; None where there is none."""
        return tuple(found for _turning, found in self._each)

    @cached_property
    def _each(self) -> list[tuple[DriveInTurn, SpeedOverTurn | None]]:
        held = [speed if speed > 0 else None for speed in self.held.tolist()]
        return all_settled(self.drives, self.machines, held)


def steady_cycles(
    drive: DeclaredDrive, motor: DeclaredMotor, machines: ReducedMachines, speed: Speed | None
) -> SteadyCycles:
    """Make ready to find the steady cycle of every design.

    Notes
    -----
    A servo motor holds the declared speed of the crank, if it is not given a torque.
    docs/theory/reduced-machine, eqs. (31.6) to (31.8).
    """
    held = np.full(len(drive.gearings), np.nan if speed is None else np.ravel(speed.value))
    drives = tuple(
        DriveInTurn(machines.each[design], own, design, gearing, is_held=own.is_free(0))
        for design, (own, gearing) in enumerate(zip(motor.of_each(), drive.gearings, strict=True))
    )
    return SteadyCycles(drives, machines, held)


def steady_drive(
    cycles: SteadyCycles, motor: DeclaredMotor, machines: ReducedMachines, crank_angle: CrankAngle
) -> SteadyDrive:
    """What the motor and its drive do in the steady cycle of every design; docs/theory/reduced-machine, eq. (31.6)."""
    grid = np.broadcast_to(crank_angle.angle[:, 0], (len(cycles.found), crank_angle.shown.size))
    each = [
        _of_design(turning, found, machines.cycle, angle, held)
        for turning, found, angle, held in zip(cycles.turning, cycles.found, grid, cycles.held.tolist(), strict=True)
    ]
    needs = tuple(_("needs steady running") for _one in each)
    return SteadyDrive(
        tuple(one.cycle for one in each),
        *np.stack([one.curves for one in each], axis=1),
        *np.stack([one.facts for one in each], axis=1),
        checks=(
            Check(
                "drive_energy",
                _("Work of the motor over a cycle less that of loads and losses, relative to the largest of these"),
                np.array([one.residual for one in each]),
                _ENERGY_LIMIT,
                needs,
            ),
            Check(
                "drive_motion",
                _("Torque left over in the equation of motion between Gauss's points, relative to the largest torque"),
                np.array([one.missed for one in each]),
                _MOTION_LIMIT,
                needs,
            ),
        ),
        flags=(*flags_of_designs(one.flags for one in each), *motor.flags, *motor.notes),
    )


class _Found(NamedTuple):
    """Steady running of one design: curves and facts in the order of `SteadyDrive`; NaN where it has none."""

    cycle: SpeedOverTurn | None
    curves: Array
    facts: Array
    residual: float
    missed: float
    flags: tuple[Words, ...]


def _of_design(turning: DriveInTurn, found: SpeedOverTurn | None, cycle: float, angle: Array, held: float) -> _Found:
    """Steady running of one design, with its curves at some crank angles, shape (n,). [rad]"""
    if found is None:
        return _Found(
            None,
            np.full((_N_CURVES, angle.size), np.nan),
            np.full(_N_FACTS, np.nan),
            np.inf,
            np.inf,
            (_no_cycle(turning, cycle),),
        )
    curves = np.stack(_curves(turning.at(angle), found.at(angle)))
    missed = float(np.max(missed_motion([turning], [found])))
    energy, flags = _residual(turning, found), tuple(_flags(turning, found, held))
    return _Found(found, curves, _facts(turning, found), energy, missed, flags)


def _curves(turning: DriveInTurn, speed: Array) -> tuple[Array, ...]:
    """Speeds and torques over the crank angle."""
    torque, passed = turning.motor_torque(speed), turning.passed(speed)
    ratio = overall_ratio(turning.gearing)
    onward = passed.outputs[-1] if len(passed.outputs) else torque - turning.gearing.motor_inertia * passed.acceleration
    return speed, passed.acceleration, speed * ratio, torque, onward


def _facts(turning: DriveInTurn, found: SpeedOverTurn) -> Array:
    """Facts of one design, in the order of `SteadyDrive`, shape (fact,)."""
    speed, ratio = found.speed, overall_ratio(turning.gearing)
    torque = turning.motor_torque(speed)
    driven = turning.here.by_load(speed) * speed
    power, taken = found.over_time(torque * speed * ratio), found.over_time(driven)
    mean = ratio * np.sum(found.mesh.width) / found.period
    return np.array(
        [
            found.period,
            mean,
            speed_range(found) * ratio / mean,
            found.over_time(torque),
            np.sqrt(found.over_time(torque**2)),
            turning.largest_torque(found),
            -turning.largest_torque(found, -1.0),
            power,
            taken,
            power - taken,
            found.over_time(turning.heat(speed)),
        ],
        dtype=np.float64,
    )


def _residual(turning: DriveInTurn, found: SpeedOverTurn) -> float:
    """What a cycle's works leave, relative to the largest of them: losses by what each stage passes on."""
    speed = found.speed
    torque = turning.motor_torque(speed) * overall_ratio(turning.gearing)
    parts = np.stack([torque, turning.here.by_load(speed), lost_torque(turning.passed(speed).outputs, turning.gearing)])
    motor, load, lost = found.mesh.mean(parts).tolist()
    largest = max(float(np.max(found.mesh.mean(np.abs(parts)))), float(turning.least_torque(speed, _SLIP)))
    return abs(motor - load - lost) / largest if largest > 0 else 0.0  # nothing acts and nothing has inertia


def _no_cycle(turning: DriveInTurn, cycle: float) -> Words:
    """Say why there is no steady running, or that none was found."""
    if turning.is_held:
        return _("No steady running: a servo motor holds the declared speed, and [shaft.main] speed is missing.")
    if np.any(np.isnan(turning.here.inertia)):
        return _("No steady running: the links do not close all round.")
    if np.any(np.isnan(turning.passed(np.full(turning.here.load.shape, 1.0)).acceleration)):
        return _(
            "No steady running: the gearing jams. It cannot be driven back (as below an efficiency of 50 %), and no one"
            " acceleration fits its losses; a better efficiency, or more inertia at the motor, helps."
        )
    (found,) = balances([turning], cycle)
    if np.all(found.excess < 0):
        return _(
            "No steady running: the motor cannot carry the machine through the cycle; at every constant speed it gives"
            " less than the machine takes."
        )
    if found.speed is not None:
        return _(
            "No steady running was found, though at a constant {speed} the motor gives on the mean what the machine"
            " takes: more inertia, or a motor with more torque to spare, may carry it over the peaks.",
            speed=number(found.speed, "rpm"),
        )
    if found.excess[-1] > 0:
        return _(
            "No steady running was found: at {speed} of the crank motor and loads still drive the machine, and nothing"
            " holds it.",
            speed=number(float(found.speeds[-1]), "rpm"),
        )
    return _("No steady running was found: where motor and machine balance, the running is not stable.")


def _flags(turning: DriveInTurn, found: SpeedOverTurn, declared: float) -> Iterator[Words]:
    """Flag unstable running, another pace than the declared one, and a motor beyond its table."""
    if found.multiplier > 1:
        yield _("The running with this motor is not stable: a small departure from it grows.")
    own = float(np.sum(found.mesh.width)) / found.period
    if abs(own - declared) > _OTHER_PACE * declared:
        said = _("With this motor and its ratio the crank turns at {own}, not at the declared {declared}.")
        yield said.format(own=number(own, "rpm"), declared=number(declared, "rpm"))
    yield from beyond_measured(turning.motor, 0, found.speed * overall_ratio(turning.gearing))
