"""Which motor is enough: the declared one against every check, and the smallest of the small catalogue that passes."""

from collections.abc import Iterator, Sequence
from dataclasses import field, replace
from functools import cache
from typing import NamedTuple

import numpy as np

from cranktrain.language import N_, Listed, Words, _
from cranktrain.layout.drive.declared import DeclaredClutch, DeclaredDrive, before_clutch
from cranktrain.layout.speed import Speed
from cranktrain.motion import Array
from cranktrain.motors import DeclaredMotor
from cranktrain.motors.cage.catalogue import four_pole_motors, typical_motors
from cranktrain.numerics.ties import first_largest
from cranktrain.questions.drive.steady_drive import SteadyDrive
from cranktrain.questions.reduction.machines import ReducedMachines
from cranktrain.questions.reduction.static_torques import StaticTorques
from cranktrain.questions.reduction.unloaded import starting_torques, with_open_valves, without_loads
from cranktrain.questions.sizing.checks import TorqueDemand, motor_choice
from cranktrain.questions.sizing.motor_checks import (
    CHECK_TITLES,
    UNCHECKED,
    AskedOfMotor,
    CheckedMotor,
    MotorAtMachine,
    check_keys,
    checked_motor,
    is_with_load,
    mean_inertia,
)
from cranktrain.questions.sizing.parts import DeclaredDuty
from cranktrain.record import record
from cranktrain.references import THEORY_OF_DRIVES as _THEORY
from cranktrain.references import THEORY_OF_TRANSIENTS as _TRANSIENTS
from cranktrain.saying.catalogue import quantity
from cranktrain.saying.checks import Flagged, flags_of_designs
from cranktrain.saying.labels import titled
from cranktrain.saying.wording import number
from cranktrain.transient.gearing import Gearing, overall_ratio, turning_inertia

_EACH = ("sized_motor",)
SIZED_MOTORS = {
    "declared": N_("as declared"),
    "smallest": N_("smallest that passes"),
    "next_smaller": N_("next smaller"),
}
_SHOWN = ("rms", "peak", "start_time", "rotor_heat", "inertia_ratio")
"""Of a checked motor, in the order of `MotorSizing`."""
_PACE = 0.1
"""By how much the typical motors may turn the crank at another pace than the file has, and still be compared."""


@record
class MotorSizing(Flagged):
    """Checks of the declared motor, of the smallest typical four-pole motor that passes, and of the next smaller."""

    sizing_share: Array = quantity(
        "u",
        "1",
        ("sized_motor", "sizing_check"),
        N_("What is asked of a motor over what it can do"),
        _THEORY,
        "25.26, 25.32 to 25.34",
    )
    largest_share: Array = quantity(
        "u_max",
        "1",
        _EACH,
        N_("Largest of these: up to 1 the motor is enough"),
        _THEORY,
        "25.26, 25.32 to 25.34",
        worst="largest",
    )
    sized_power: Array = quantity(
        "P_n", "W", _EACH, N_("Rated power of the motor that is checked"), _THEORY, "definition"
    )
    sized_torque: Array = quantity(
        "M_n", "N*m", _EACH, N_("Rated torque of the motor that is checked"), _THEORY, "definition"
    )
    sized_rms_torque: Array = quantity(
        "M_rms",
        "N*m",
        _EACH,
        N_("Root mean square of its torque over time, from its own steady cycle"),
        _TRANSIENTS,
        "26.5",
    )
    sized_peak_torque: Array = quantity(
        "M_max", "N*m", _EACH, N_("Largest torque in that cycle"), _TRANSIENTS, "26.5", worst="largest"
    )
    sized_start_time: Array = quantity(
        "t_st", "s", _EACH, N_("Time of a start at the lowest voltage against the mean static torque"), _THEORY, "25.26"
    )
    sized_rotor_heat: Array = quantity("Q_st", "J", _EACH, N_("Heat of the rotor in such a start"), _THEORY, "25.26")
    sized_inertia_ratio: Array = quantity(
        "λ_J", "1", _EACH, N_("Mean inertia of what is driven over that of the rotor, at the motor"), _THEORY, "25.34"
    )

    unknown: tuple[Words, ...] = field(default=(), kw_only=True)
    """What of the declared motor cannot be checked, as its table does not say it."""

    def governing(self, design: int, which: int) -> str:
        """The check whose share is largest; nothing where none is known."""
        shares = self.sizing_share[design, which]
        return "" if np.all(np.isnan(shares)) else self.labels["sizing_check"][first_largest(shares)]


class SizedDesign(NamedTuple):
    """One design for which motors are checked.

    Attributes
    ----------
    machines : ReducedMachines
        Of this design alone.
    bare : Gearing
        Without the rotor of the declared motor.
    asked : AskedOfMotor
    duty : DeclaredDuty
    design : int
        Its place among all of them.
    """

    machines: ReducedMachines
    bare: Gearing
    asked: AskedOfMotor
    duty: DeclaredDuty
    design: int

    def with_motor(self, motor: DeclaredMotor, place: int) -> MotorAtMachine:
        """Give the machine one motor of a range, by its place in it."""
        rotor = 0.0 if motor.inertia is None else float(motor.inertia[place])
        gearing = self.bare._replace(motor_inertia=self.bare.motor_inertia + rotor)
        return MotorAtMachine(motor, place, gearing, self.machines)


def motor_sizing(
    drive: DeclaredDrive,
    duty: DeclaredDuty,
    machines: ReducedMachines,
    static: StaticTorques,
    motor: DeclaredMotor | None,
    clutch: DeclaredClutch | None,
    speed: Speed | None,
    steady: SteadyDrive | None,
) -> MotorSizing:
    """Check the declared motor, and find the smallest typical one that passes the same checks.

    Notes
    -----
    docs/theory/drive, section Sizing of a declared machine. Of each motor the torque is that of its own steady cycle;
    the start is against static torques, which hang on no motor; a clutch leaves it what turns before it
    alone. Where typical motors would turn the crank at another
    pace, or loads drive the motor, none is chosen.
    """
    rows: list[tuple[CheckedMotor, ...]] = []
    rated: list[list[tuple[float, float]]] = []
    flags: list[list[Words]] = []
    checks = check_keys(duty, has_clutch=clutch is not None)
    held = np.full(len(drive.gearings), np.nan if speed is None else np.ravel(speed.value)).tolist()
    for design, gearing in enumerate(drive.gearings):
        is_asked_torque = float(static.mean_static_torque[design, 0]) > 0
        one = sized_design(design, gearing, machines, static, motor=motor, duty=duty, clutch=clutch)
        cycle = None if steady is None else steady.running[design]
        own = (
            UNCHECKED if motor is None else checked_motor(_declared(one, motor, design), *one[2:], held[design], cycle)
        )
        reason = _other_pace(gearing, motor, design, held[design]) if is_asked_torque else ""
        places = (-1, -1) if reason or not is_asked_torque else None
        found, places = ((UNCHECKED,) * 2, (-1, -1)) if places else _smallest(one, own)
        flags.append([reason] if duty.is_asked and reason else [])
        rows.append((own, *found))
        rated.append([_rated(motor, design), *(_rated(typical_motors(), place) for place in places)])
        if motor is not None:
            flags[-1] += _beyond(own, checks, has_valves=len(machines.each[design].chambers) > 0)
    points = np.array(rated)
    columns = [np.array([[getattr(one, name) for one in row] for row in rows]) for name in _SHOWN]
    return MotorSizing(
        np.array([[one.shares for one in row] for row in rows]),
        np.array([[one.largest for one in row] for row in rows]),
        points[..., 0],
        points[..., 1],
        *columns,
        labels={
            "sized_motor": tuple(SIZED_MOTORS),
            "sizing_check": checks,
        },
        flags=flags_of_designs(flags),
        unknown=rows[0][0].unknown,
    )


def sized_design(
    design: int,
    gearing: Gearing,
    machines: ReducedMachines,
    static: StaticTorques,
    *,
    motor: DeclaredMotor | None,
    duty: DeclaredDuty,
    clutch: DeclaredClutch | None,
) -> SizedDesign:
    """Take one design apart from the others, and the rotor of the declared motor from its gearing.

    Parameters
    ----------
    design : int
    gearing : Gearing
        Of this design.
    machines : ReducedMachines
    static : StaticTorques
        Behind these ratios, whatever turns with the shafts.
    motor : DeclaredMotor or None
    duty : DeclaredDuty
    clutch : DeclaredClutch or None
        It leaves the start without load, as an unloaded start of the duty does.
    """
    rotor = 0.0 if motor is None or motor.inertia is None else float(motor.inertia[design])
    bare = gearing._replace(motor_inertia=gearing.motor_inertia - rotor)
    own = slice(design, design + 1)
    alone = replace(machines, each=machines.each[own], corners=machines.corners[own], misses=machines.misses[own])
    if clutch is not None:
        return SizedDesign(alone, bare, _before_clutch(bare, clutch, design), duty, design)
    of_machine = mean_inertia(alone.each[0], alone.cycle) / overall_ratio(gearing) ** 2
    worst, mean = float(static.largest_static_torque.value[design, 0]), float(static.mean_static_torque[design, 0])
    if duty.starts_unloaded or duty.holds_valves_open:
        freed = without_loads if duty.starts_unloaded else with_open_valves
        worst, mean = starting_torques(freed(alone.each[0]), alone.corners[0], bare, alone.cycle)
    asked = AskedOfMotor(worst, mean, _at_motor(bare) + of_machine)
    return SizedDesign(alone, bare, asked, duty, design)


def _before_clutch(bare: Gearing, clutch: DeclaredClutch, design: int) -> AskedOfMotor:
    """What a motor starts whose clutch is let go: no load, and what turns before it."""
    return AskedOfMotor(0.0, 0.0, _at_motor(before_clutch(bare, clutch, design)))


def _at_motor(gearing: Gearing) -> float:
    """Inertia of what turns with motor and stages, reduced to the motor. [kg·m²]"""
    return float(turning_inertia(gearing) / overall_ratio(gearing) ** 2)


def _declared(one: SizedDesign, motor: DeclaredMotor, design: int) -> MotorAtMachine:
    """The declared motor as one of a range of one, so that its own design is the first."""
    return one.with_motor(motor.of_design(design), 0)


def _rated(motor: DeclaredMotor | None, place: int) -> tuple[float, float]:
    """Rated power and torque; NaN where there is none."""
    if motor is None or place < 0:
        return np.nan, np.nan
    return float(motor.rating.power[place]), float(motor.rating.torque[place])


def _smallest(one: SizedDesign, own: CheckedMotor) -> tuple[tuple[CheckedMotor, CheckedMotor], tuple[int, int]]:
    """Smallest typical motor that passes and the next smaller one; the largest as the latter where none is enough.

    Looked for from the one that would do with the torques of the declared motor on.
    """
    motors = typical_motors()
    n = motors.n_designs

    @cache
    def checked(place: int) -> CheckedMotor:
        alone = one.with_motor(motors.of_design(place), 0)
        return checked_motor(alone, one.asked, one.duty, one.design)

    worst = np.asarray(max(one.asked.worst_torque, 0.0))
    rms = np.fmax(worst / 2, own.rms / one.duty.factor[one.design])
    demand = TorqueDemand(rms, np.fmax(worst, own.peak), worst)
    first = motor_choice(demand, four_pole_motors(), float(one.duty.reserve[one.design]))
    place = int(first.motor) if first.motor >= 0 else n - 1
    while place > 0 and not checked(place).largest > 1:
        place -= 1
    while place < n and checked(place).largest > 1:
        place += 1
    chosen = checked(place) if place < n else UNCHECKED
    smaller = checked(place - 1) if place > 0 else UNCHECKED
    return (chosen, smaller), (place if place < n else -1, place - 1)


def _other_pace(gearing: Gearing, motor: DeclaredMotor | None, design: int, declared: float) -> Words:
    """Say that typical motors turn the crank at another pace than the motor that is there, or the declared speed."""
    ratio = overall_ratio(gearing)
    typical = float(four_pole_motors().values.synchronous_speed[0])
    wanted = declared * ratio
    if motor is not None and not motor.law.is_commanded and np.isfinite(motor.top_speed[design]):
        wanted = float(motor.top_speed[design])
    if np.isnan(wanted) or abs(typical - wanted) <= _PACE * abs(wanted):
        return ""
    said = _("Typical four-pole motors turn at {typical}, the motor here at {wanted}: none is chosen for this gearing.")
    return said.format(typical=number(typical, "rpm"), wanted=number(wanted, "rpm"))


def _beyond(own: CheckedMotor, checks: Sequence[str], *, has_valves: bool) -> Iterator[Words]:
    """Flag what the declared motor cannot do; of a start with its load at the worst angle what helps as well."""
    for share, check in zip(own.shares.tolist(), checks, strict=True):
        if np.isfinite(share) and share > 1:
            said = _("The motor is too small: {check} {share} of what it can.")
            if is_with_load(check):
                said = _(
                    "A start with its load at the worst angle asks {share} of the motor: if it need not, {helps};"
                    " or another [drive.start] angle, from which a flywheel carries it past the worst."
                )
            yield said.format(
                check=titled(CHECK_TITLES, check), share=number(share, "%"), helps=_what_helps(has_valves=has_valves)
            )


def _what_helps(*, has_valves: bool) -> Words:
    """What in the file lets a motor start with less."""
    unloaded = _('[drive.duty] start = "unloaded"')
    valves = _("[drive.start] unloaded_until")
    return Listed((unloaded, valves), "; ") if has_valves else unloaded
