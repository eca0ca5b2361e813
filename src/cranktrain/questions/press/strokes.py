"""Single strokes of a press: what clutch and brake do in them, how far the flywheel slows, how many are possible."""

import math
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from cranktrain.language import N_, Words, _
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.drive.declared import MINUTE, DeclaredBrake, DeclaredClutch, DeclaredDrive, DeclaredStroke
from cranktrain.motion import Array
from cranktrain.motors import DeclaredMotor
from cranktrain.numerics.harmonics import TURN
from cranktrain.questions.press.case import PressCase, PressParts, hindrance, press_case
from cranktrain.questions.reduction.machines import ReducedMachines
from cranktrain.questions.start.parts import DeclaredStart
from cranktrain.record import record
from cranktrain.references import THEORY_OF_CLUTCHED_DRIVES as _THEORY
from cranktrain.references import THEORY_OF_TRANSIENTS as _TRANSIENTS
from cranktrain.saying.catalogue import quantity
from cranktrain.saying.checks import Check, Checked, Flagged, flags_of_designs
from cranktrain.saying.wording import number
from cranktrain.transient.clutched.equation import ANGLE
from cranktrain.transient.clutched.runs import PRESS_REASONS, RESTS, TIME_IS_OVER
from cranktrain.transient.clutched.settled import SettledStroke, settled_stroke
from cranktrain.transient.clutched.stroke import heat_rate_limit, time_limit

_ENERGY_LIMIT = 1e-6
_SEEN = 1e-6
"""An angle that is more than rounding of a stroke which was to end there. [rad]"""
_N_FACTS = 18


@record
class PressStrokes(Checked, Flagged):
    """A single stroke as it repeats at the required pace, or by itself; NaN where there is none."""

    cases: tuple[PressCase | None, ...]
    settled: tuple[SettledStroke | None, ...]
    why_none: tuple[Words, ...]
    command_angle: Array = quantity(
        "φ_c",
        "rad",
        (),
        N_("Crank angle of the command that ends the stroke, counted on from its start"),
        _THEORY,
        "30.13",
    )
    clutch_slip_time: Array = quantity(
        "t_K", "s", (), N_("Time in which the clutch slips while the crank turns"), _THEORY, "30.1, 30.2, 30.6"
    )
    clutch_lock_angle: Array = quantity(
        "φ_K", "rad", (), N_("Crank angle from the start until the clutch locks"), _THEORY, "30.1, 30.2, 30.6"
    )
    clutch_heat: Array = quantity("Q_K", "J", (), N_("Heat in the clutch from a stroke"), _THEORY, "30.8")
    brake_heat: Array = quantity("Q_B", "J", (), N_("Heat in the brake from a stroke"), _THEORY, "30.8")
    stroke_speed_drop: Array = quantity(
        "δ_Ω", "1", (), N_("By how much the flywheel slows in a stroke, of its speed at the start"), _THEORY, "30.11"
    )
    pressing_speed_drop: Array = quantity(
        "δ_Ω,p", "1", (), N_("By how much it slows after the clutch has locked, in the same parts"), _THEORY, "30.11"
    )
    braking_angle: Array = quantity(
        "Δφ_B", "rad", (), N_("Crank angle from the command until it rests"), _THEORY, "30.10"
    )
    braking_time: Array = quantity("t_B", "s", (), N_("Time from the command until the crank rests"), _THEORY, "30.10")
    stop_angle: Array = quantity(
        "Δφ_e", "rad", (), N_("Where the crank rests, from where it started: below 0 before it"), _THEORY, "30.10"
    )
    stroke_time: Array = quantity(
        "t_s", "s", (), N_("Time of a stroke, from its command until it rests"), _THEORY, "30.17"
    )
    recovery_time: Array = quantity(
        "t_r",
        "s",
        (),
        N_("Time from then until the flywheel has 99 % of its speed at the start"),
        _THEORY,
        "30.17",
    )
    flywheel_start_speed: Array = quantity(
        "Ω_0", "rad/s", (), N_("Speed of the flywheel at the start of a stroke"), _THEORY, "30.15", shown="rpm"
    )
    stroke_motor_power: Array = quantity(
        "P_m,s", "W", (), N_("Mean power of the motor at the required pace of strokes"), _THEORY, "30.8"
    )
    stroke_motor_heat: Array = quantity(
        "P_w,s", "W", (), N_("Mean power that heats the motor's rotor at that pace"), _TRANSIENTS, "26.10"
    )
    clutch_heating: Array = quantity(
        "P_K", "W", (), N_("Mean power that heats the clutch at that pace"), _THEORY, "30.8"
    )
    brake_heating: Array = quantity("P_B", "W", (), N_("Mean power that heats the brake at that pace"), _THEORY, "30.8")
    most_strokes_per_minute: Array = quantity(
        "n_max",
        "1",
        (),
        N_("Strokes a minute that the flywheel's recovery and the given mean powers allow"),
        _THEORY,
        "30.12",
    )


def press_strokes(
    drive: DeclaredDrive,
    start: DeclaredStart,
    motor: DeclaredMotor,
    machines: ReducedMachines,
    clutch: DeclaredClutch,
    brake: DeclaredBrake,
    stroke: DeclaredStroke,
    crank_angle: CrankAngle,
) -> PressStrokes:
    """Run the stroke of every design.

    Notes
    -----
    docs/theory/clutched-drive, eqs. (30.10) to (30.15).
    """
    zero = np.ravel(crank_angle.zero[:, 0, 0])
    parts = PressParts(drive.gearings, motor, machines, clutch, brake, stroke, zero, start.of(0).tolerance)
    found = [_of_design(parts, design) for design in range(len(drive.gearings))]
    facts = np.stack([_facts(one, parts, design) for design, one in enumerate(found)], axis=1)
    return PressStrokes(
        tuple(one.case for one in found),
        tuple(one.settled for one in found),
        tuple(one.why_not for one in found),
        *facts,
        checks=(
            Check(
                "stroke_energy",
                _("Kinetic energy at the end of a stroke less what was given and taken, relative to that"),
                np.array([_residual(one) for one in found]),
                _ENERGY_LIMIT,
                tuple(_("needs a stroke") for _one in found),
            ),
        ),
        flags=flags_of_designs(_flags(one, parts, design) for design, one in enumerate(found)),
    )


class _Found(NamedTuple):
    """The stroke of a design, or why there is none."""

    case: PressCase | None
    settled: SettledStroke | None
    why_not: Words


def _of_design(parts: PressParts, design: int) -> _Found:
    """Find the stroke of a design."""
    why_not = hindrance(parts, design)
    if why_not:
        return _Found(None, None, why_not)
    case = press_case(parts, design)
    if case is None:
        return _Found(None, None, _("No strokes: the motor has no speed that it keeps without load."))
    settled = settled_stroke(
        case.kernels,
        case.press,
        case.plan,
        idle_speed=case.idle_speed,
        start_angle=case.start_angle,
        period=case.period,
    )
    return _Found(case, settled, "" if settled.is_found else _why_none(case, settled))


def _why_none(case: PressCase, settled: SettledStroke) -> Words:
    """Why a stroke is not as it is asked for."""
    reason = settled.stroke.run.reason
    if reason == TIME_IS_OVER and math.isfinite(case.period):
        pace = f"{MINUTE / case.period:.6g}"
        return _("No strokes at {pace} a minute: one is not over when the next begins.", pace=pace)
    if reason == RESTS:
        return _overrun(case, settled)
    return _("No stroke: {reason}.", reason=_(PRESS_REASONS[reason]))


def _overrun(case: PressCase, settled: SettledStroke) -> Words:
    """Say how far the last command that was tried is from ending a stroke where it began."""
    stroke = settled.stroke
    rest = float(stroke.run.end.state[ANGLE])
    shown = [math.fmod(angle - case.zero, TURN) for angle in (rest - stroke.brake_angle, rest)]
    said = _(
        "No stroke: the brake is too weak to end it where it began. Commanded at {command} the crank runs on by"
        " {angle}, against brake, load and weight together, and rests at {rest}."
    )
    command, at_rest = (number(angle, "deg") for angle in shown)
    return said.format(command=command, angle=number(stroke.brake_angle, "deg"), rest=at_rest)


def _facts(found: _Found, parts: PressParts, design: int) -> Array:
    """Facts of one design, in the order of `PressStrokes`."""
    case, settled = found.case, found.settled
    if case is None or settled is None or not settled.is_found:
        return np.full(_N_FACTS, np.nan)
    own, pace = settled.stroke, settled.pace
    end = float(own.run.end.state[ANGLE])
    limit = min(
        time_limit(own) if math.isfinite(own.recovery_time) else math.nan,
        heat_rate_limit(own, float(parts.clutch.mean_power[design]), float(parts.brake.mean_power[design])),
    )
    means = (math.nan,) * 4
    if pace is not None:
        means = (pace.motor_power, pace.motor_heat, pace.clutch_power, pace.brake_power)
    return np.array(
        [
            settled.command_angle - case.zero,
            own.slip_time,
            own.locked_at - case.start_angle,
            own.clutch_heat,
            own.brake_heat,
            own.speed_drop,
            own.pressing_drop,
            own.brake_angle,
            own.brake_time,
            _stop(end - case.start_angle),
            own.stroke_time,
            own.recovery_time,
            settled.wheel_speed,
            *means,
            MINUTE * limit,
        ]
    )


def _stop(turned: float) -> float:
    """Where the crank rests, from where it started. [rad]"""
    off = math.remainder(turned, TURN)
    return off if abs(off) > _SEEN else 0.0


def _residual(found: _Found) -> float:
    """Energy left over, relative to what was given; infinite without a stroke."""
    settled = found.settled
    if settled is None:
        return np.inf
    return abs(settled.stroke.run.residual) / settled.stroke.run.supplied


def _flags(found: _Found, parts: PressParts, design: int) -> Iterator[Words]:
    """Why there is no stroke, or what does not go at the required pace."""
    if found.why_not:
        yield found.why_not
        return
    assert found.settled is not None
    pace = found.settled.pace
    if pace is None:
        return
    each = (
        (N_("clutch"), pace.clutch_power, parts.clutch.mean_power),
        (N_("brake"), pace.brake_power, parts.brake.mean_power),
    )
    for name, power, allowed in each:
        if power > allowed[design]:
            yield _(
                "The {part} takes up {power} in the mean, more than its mean_power {allowed}.",
                part=_(name),
                power=number(power, "W"),
                allowed=number(float(allowed[design]), "W"),
            )
