"""Results of a wanted motion: how the crank moves, how far a constant speed misses it, what the motor does."""

import math
from typing import NamedTuple

import numpy as np

from cranktrain.language import N_, _
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.drive.declared import DeclaredDrive
from cranktrain.layout.wish.declared import WantedMotions
from cranktrain.layout.wish.following import CrankMotion, Following, crank_by_angle
from cranktrain.layout.wish.wanted import moved
from cranktrain.motion import Array
from cranktrain.numerics.harmonics import TURN
from cranktrain.numerics.ties import first_smallest
from cranktrain.questions.reduction.at_angles import reduced_at
from cranktrain.questions.reduction.machines import ReducedMachines
from cranktrain.questions.servo.demand import ServoDemand, crank_torque, motor_torque, servo_demand
from cranktrain.record import record
from cranktrain.references import THEORY_OF_TRANSIENTS as _TRANSIENTS
from cranktrain.saying.catalogue import quantity
from cranktrain.saying.checks import Check, Checked

THEORY = "docs/theory/servo"
_CURVE = ("crank_angle",)
_FOLLOWS = 1e-9
"""Of the stroke: what the crank may miss of the wanted position."""
_ENERGY_LIMIT = 1e-6

_N_TIMES, _N_PHASES = 720, 180
_GOLDEN = (np.sqrt(5) - 1) / 2
_N_STEPS = 40


@record
class WantedCrank(Checked):
    """How the crank moves so that its output moves as wanted."""

    wanted_time: Array = quantity(
        "t", "s", _CURVE, N_("Time, from the beginning of the wanted motion"), THEORY, "29.10"
    )
    wanted_crank_speed: Array = quantity(
        "ω_w", "rad/s", _CURVE, N_("Speed of the crank that is wanted"), THEORY, "29.3, 29.6", shown="rpm"
    )
    wanted_crank_acceleration: Array = quantity(
        "ε_w", "rad/s^2", _CURVE, N_("Angular acceleration of the crank that is wanted"), THEORY, "29.3, 29.6"
    )
    wanted_period: Array = quantity("T_w", "s", (), N_("Period of the wanted motion"), THEORY, "definition")
    resting_time: Array = quantity("t_0", "s", (), N_("How long the crank rests in a period"), THEORY, "definition")
    largest_wanted_speed: Array = quantity(
        "ω_w,max", "rad/s", (), N_("Largest wanted speed of the crank"), THEORY, "29.3, 29.6", shown="rpm"
    )
    constant_speed_miss: Array = quantity(
        "Δ_s",
        "1",
        (),
        N_("By how much a crank at a constant speed would miss the wanted position, in parts of the stroke"),
        THEORY,
        "29.9",
    )


def wanted_crank(wanted: WantedMotions, crank_angle: CrankAngle) -> WantedCrank:
    """Speed of the crank over its cycle for a wanted motion.

    Notes
    -----
    docs/theory/servo, eqs. (29.3) to (29.6) and (29.9).
    """
    angle = _grid(wanted, crank_angle)
    turns = [crank_by_angle(made, own) for made, own in zip(wanted.each, angle, strict=True)]
    strokes = np.array([made.output.stroke for made in wanted.each])
    places = zip(wanted.each, angle, turns, strict=True)
    missed = [
        np.max(np.abs(made.output.motion(own).value - moved(made.wanted, turn.time).value))
        for made, own, turn in places
    ]
    return WantedCrank(
        wanted_time=np.stack(
            [_shown(made.wanted.period, made.wanted.zero, turn) for made, turn in zip(wanted.each, turns, strict=True)]
        ),
        wanted_crank_speed=np.stack([turn.speed for turn in turns]),
        wanted_crank_acceleration=np.stack([turn.acceleration for turn in turns]),
        wanted_period=np.array([made.wanted.period for made in wanted.each]),
        resting_time=np.array([math.fsum(span for _at, span in made.dwells) for made in wanted.each]),
        largest_wanted_speed=np.array([np.max(turn.speed) for turn in turns]),
        constant_speed_miss=np.array([constant_miss(made).largest for made in wanted.each]) / strokes,
        checks=(
            Check(
                "wanted_motion",
                _("Position of what the crank drives less the wanted one at that time, relative to the stroke"),
                np.array(missed) / strokes,
                _FOLLOWS,
            ),
        ),
    )


def _grid(wanted: WantedMotions, crank_angle: CrankAngle) -> Array:
    """φ of the grid, shape (design, n)."""
    return np.broadcast_to(crank_angle.angle[:, 0], (len(wanted.each), crank_angle.shown.size))


def _shown(period: float, zero: float, turn: CrankMotion) -> Array:
    """Times within the first period of the file's clock."""
    return np.mod(turn.time + zero, period)


@record
class ServoDrive(Checked):
    """What the motor must do so that the crank follows; demands, of each design, over time."""

    demands: tuple[ServoDemand, ...]
    servo_crank_torque: Array = quantity(
        "M_w", "N*m", _CURVE, N_("Torque on the crank that the wanted motion takes"), THEORY, "29.8"
    )
    servo_torque: Array = quantity(
        "M_s", "N*m", _CURVE, N_("Torque of the motor for the wanted motion"), THEORY, "29.8"
    )
    servo_rms_torque: Array = quantity(
        "M_s,rms", "N*m", (), N_("Root mean square of that torque over time, rests counted"), THEORY, "29.8"
    )
    servo_peak_torque: Array = quantity("M_s,max", "N*m", (), N_("Largest size of that torque"), THEORY, "29.8")
    servo_peak_speed: Array = quantity(
        "ω_s,max", "rad/s", (), N_("Largest speed of the motor"), THEORY, "29.3, 29.6", shown="rpm"
    )
    servo_peak_power: Array = quantity(
        "P_s,max", "W", (), N_("Largest power of the motor, driving or braking"), _TRANSIENTS, "26.10"
    )
    servo_mean_power: Array = quantity("P_s", "W", (), N_("Mean power of the motor over time"), _TRANSIENTS, "26.10")
    servo_energy_back: Array = quantity(
        "W_s", "J", (), N_("Energy that the motor takes back in a period"), _TRANSIENTS, "26.10"
    )


def servo_drive(
    wanted: WantedMotions, drive: DeclaredDrive, machines: ReducedMachines, crank_angle: CrankAngle
) -> ServoDrive:
    """Torque, power and heat of a motor that makes the crank follow.

    Notes
    -----
    docs/theory/servo, eq. (29.8). Friction in guides is not in it, as in the reduced machine.
    """
    rows: list[tuple[Array, Array]] = []
    demands: list[ServoDemand] = []
    for n, (made, angle) in enumerate(zip(wanted.each, _grid(wanted, crank_angle), strict=True)):
        turn = crank_by_angle(made, angle)
        torque = crank_torque(turn, reduced_at(machines.each[n], angle))
        rows.append((torque, motor_torque(torque, turn, drive.gearings[n])))
        corners = machines.corners[n]
        demands.append(servo_demand(made, machines.each[n], drive.gearings[n], corners))
    return ServoDrive(
        tuple(demands),
        servo_crank_torque=np.stack([row[0] for row in rows]),
        servo_torque=np.stack([row[1] for row in rows]),
        servo_rms_torque=np.array([one.rms for one in demands]),
        servo_peak_torque=np.array([one.peak_torque for one in demands]),
        servo_peak_speed=np.array([one.top_speed for one in demands]),
        servo_peak_power=np.array([one.peak_power for one in demands]),
        servo_mean_power=np.array([one.mean(one.power) for one in demands]),
        servo_energy_back=np.array([one.returned for one in demands]),
        checks=(_energy_check(demands, machines),),
    )


def _energy_check(demands: list[ServoDemand], machines: ReducedMachines) -> Check:
    """Work of inertia over a period, which must be none: the crank comes back as fast as it was."""
    residuals: list[float] = []
    for one, machine in zip(demands, machines.each, strict=True):
        here = reduced_at(machine, one.crank.angle)
        turning = one.crank.speed * (one.crank_torque - here.by_load(one.crank.speed))
        scale = np.sum(np.abs(turning) * one.weight)
        residuals.append(float(np.abs(np.sum(turning * one.weight)) / scale) if scale > 0 else 0.0)
    return Check(
        "servo_inertia_work",
        _("Work of inertia over a period of the wanted motion, relative to what it takes and gives"),
        np.array(residuals),
        _ENERGY_LIMIT,
    )


def is_wanted(wanted: WantedMotions | None) -> bool:
    """Whether there is a wanted motion: nobody else misses what it would give."""
    return wanted is not None


class ConstantMiss(NamedTuple):
    """Largest difference of position at equal times [m or rad], and where the constant crank is at time 0 [rad]."""

    largest: float
    phase: float


def constant_miss(made: Following) -> ConstantMiss:
    """Find the phase at which the largest difference is least, on 720 times of a period.

    docs/theory/servo, eq. (29.9).
    """
    time: Array = np.arange(_N_TIMES, dtype=np.float64) * (made.wanted.period / _N_TIMES)
    wanted = moved(made.wanted, time).value
    turned = TURN * np.arange(_N_TIMES) / _N_TIMES

    def largest(phase: Array) -> Array:
        """Largest difference at each of some phases, shape (k,)."""
        angle = np.ravel(phase[:, np.newaxis] + turned)
        places = made.output.motion(angle).value.reshape(-1, _N_TIMES)
        return np.max(np.abs(places - wanted), axis=1)

    step = TURN / _N_PHASES
    phases: Array = np.arange(_N_PHASES, dtype=np.float64) * step
    best = float(phases[first_smallest(largest(phases))])
    low, high = best - step, best + step
    for _step in range(_N_STEPS):
        inner = np.array([high - _GOLDEN * (high - low), low + _GOLDEN * (high - low)])
        values = largest(inner)
        low, high = (low, float(inner[1])) if values[0] < values[1] else (float(inner[0]), high)
    found = 0.5 * (low + high)
    return ConstantMiss(float(largest(np.array([found]))[0]), float(np.mod(found, TURN)))
