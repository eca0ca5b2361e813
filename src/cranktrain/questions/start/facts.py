"""What became of a start in numbers: how long it took, what the motor gave, where the energy went; of a stroke more."""

import numpy as np

from cranktrain.language import N_
from cranktrain.motion import Array
from cranktrain.questions.start.record import StartRun
from cranktrain.questions.start.starting import EVENTS
from cranktrain.record import record
from cranktrain.references import THEORY_OF_CLUTCHED_DRIVES as _CLUTCHED
from cranktrain.references import THEORY_OF_DRIVES as _DRIVE
from cranktrain.references import THEORY_OF_TRANSIENTS as _THEORY
from cranktrain.saying.catalogue import DEFINITION, quantity
from cranktrain.transient.clutched.equation import ANGLE
from cranktrain.transient.endings import REVERSAL

_ROUNDING = 1e-9
_SAME = 8
"""Times that so many of the least differences of floats part are one."""
_LIKE_ITS_NEIGHBOURS = 10.0
"""A step longer than so many of those beside it, such as a pause, has other slopes than these tell."""


@record
class StartFacts:
    """A whole run, whatever times were asked for; all arrays of shape (1,), of the one design."""

    start_duration: Array = quantity(
        "t_e", "s", (), N_("Time from the beginning to what ends the run"), _THEORY, "26.9"
    )
    crank_turns: Array = quantity(
        "z", "1", (), N_("Turns of the crank from beginning to end, less those back"), _THEORY, DEFINITION
    )
    crank_reversals: Array = quantity("n_r", "1", (), N_("How often the crank turned round"), _THEORY, DEFINITION)
    final_crank_speed: Array = quantity(
        "ω_e", "rad/s", (), N_("Speed of the crank at the end"), _THEORY, "26.9", shown="rpm"
    )
    smallest_motor_torque: Array = quantity(
        "M_m,min", "N*m", (), N_("Smallest torque of the motor at its own shaft"), _THEORY, "26.5"
    )
    largest_motor_torque: Array = quantity(
        "M_m,max", "N*m", (), N_("Largest torque of the motor at its own shaft"), _THEORY, "26.5"
    )
    effective_motor_torque: Array = quantity(
        "M_rms", "N*m", (), N_("Root mean square of the motor's torque over the time"), _DRIVE, "25.29"
    )
    smallest_motor_power: Array = quantity(
        "P_m,min", "W", (), N_("Smallest power of the motor at its shaft"), _THEORY, "26.10"
    )
    largest_motor_power: Array = quantity(
        "P_m,max", "W", (), N_("Largest power of the motor at its shaft"), _THEORY, "26.10"
    )
    final_motor_work: Array = quantity("W_m,e", "J", (), N_("Work of the motor in the whole run"), _THEORY, "26.10")
    final_load_work: Array = quantity(
        "W_Q,e", "J", (), N_("Work that the loads have taken in the whole run"), _THEORY, "26.10"
    )
    final_lost_work: Array = quantity(
        "W_v,e", "J", (), N_("Work that gearing, clutch and brake have lost in the whole run"), _THEORY, "26.10"
    )
    first_kinetic_energy: Array = quantity(
        "T_0", "J", (), N_("Kinetic energy of machine and drive at the beginning"), _THEORY, "26.11"
    )
    final_kinetic_energy: Array = quantity(
        "T_e", "J", (), N_("Kinetic energy of machine and drive at the end"), _THEORY, "26.11"
    )
    final_motor_heat: Array = quantity(
        "Q_m,e", "J", (), N_("Heat in the motor's rotor from the whole run"), _THEORY, "26.10"
    )
    energy_left_over: Array = quantity(
        "r_E", "1", (), N_("Energy that no work accounts for, in parts of what was given"), _THEORY, "26.11"
    )


@record
class StrokeFacts:
    """A stroke of a press; as `StartFacts`."""

    slip_time: Array = quantity(
        "t_K", "s", (), N_("Time in which the clutch slipped while the crank turned"), _CLUTCHED, "30.1, 30.2, 30.6"
    )
    heat_of_clutch: Array = quantity("Q_K", "J", (), N_("Heat in the clutch from the stroke"), _CLUTCHED, "30.8")
    angle_of_braking: Array = quantity(
        "Δφ_B", "rad", (), N_("Crank angle from the command until the crank rested"), _CLUTCHED, "30.10"
    )
    time_of_braking: Array = quantity(
        "t_B", "s", (), N_("Time from the command until the crank rested"), _CLUTCHED, "30.10"
    )
    heat_of_brake: Array = quantity("Q_B", "J", (), N_("Heat in the brake from the stroke"), _CLUTCHED, "30.8")


@record
class StrokeStops:
    """The longest stop that a command on the way of a stroke could lead to; as `StartFacts`."""

    longest_stop_time: Array = quantity(
        "t_max", "s", (), N_("Longest time from a command on the way until the crank rests"), _CLUTCHED, "30.14"
    )
    longest_stop_time_command: Array = quantity(
        "φ_t", "rad", (), N_("Crank angle of that command, from where the stroke began"), _CLUTCHED, "30.14"
    )
    longest_stop_angle: Array = quantity(
        "Δφ_max", "rad", (), N_("Longest way from a command on the way until the crank rests"), _CLUTCHED, "30.14"
    )
    longest_stop_angle_command: Array = quantity(
        "φ_φ", "rad", (), N_("Crank angle of that command, from where the stroke began"), _CLUTCHED, "30.14"
    )


def start_facts(run: StartRun) -> StartFacts:
    """Take from the whole run what people ask of it in single numbers."""
    curves, time = run.whole, run.whole_time
    turned, torque, power = curves.crank_angle_turned, curves.motor_torque, curves.motor_power
    each = (
        time[-1],
        (turned[-1] - turned[0]) / (2 * np.pi),
        sum(event.sort == EVENTS[REVERSAL] for event in run.events),
        _last(curves.crank_speed),
        np.min(torque),
        np.max(torque),
        effective_torque(torque, time),
        np.min(power),
        np.max(power),
        _last(curves.motor_work),
        _last(curves.load_work),
        _last(curves.lost_work),
        curves.kinetic_energy[0],
        _last(curves.kinetic_energy),
        _last(curves.motor_heat),
        abs(run.residual) / run.supplied if run.supplied else 0.0,
    )
    return StartFacts(*np.array(each, dtype=np.float64)[:, np.newaxis])


def stroke_facts(run: StartRun) -> StrokeFacts:
    """Take from a stroke what clutch and brake did."""
    assert run.stroke is not None  # as a stroke gives it
    own = run.stroke.settled.stroke
    each = (own.slip_time, own.clutch_heat, own.brake_angle, own.brake_time, own.brake_heat)
    return StrokeFacts(*np.array(each, dtype=np.float64)[:, np.newaxis])


def stroke_stops(run: StartRun) -> StrokeStops:
    """Look for the longest stop; NaN where there is none. docs/theory/clutched-drive, eq. (30.14)."""
    assert run.stroke is not None  # as a stroke gives it
    worst = run.stroke.longest_stop
    stops = [np.nan] * 4
    if worst is not None:
        began = float(run.stroke.settled.stroke.run.start.state[ANGLE])
        stops = [worst.time, worst.time_command - began, worst.angle, worst.angle_command - began]
    return StrokeStops(*np.array(stops, dtype=np.float64)[:, np.newaxis])


def _last(curve: Array) -> float:
    """Value at the end; 0 where only rounding is left of it."""
    return float(curve[-1]) if abs(curve[-1]) > _ROUNDING * np.max(np.abs(curve)) else 0.0


def effective_torque(torque: Array, time: Array) -> float:
    """Root mean square of a torque over the time; of a run that ends as it begins, its only value.

    Parameters
    ----------
    torque, time : Array, shape (n,)
        Samples, in steps of any length. [N·m, s]

    Returns
    -------
    float
        [N·m]
    """
    if time[-1] <= time[0]:
        return abs(float(torque[-1]))
    last = np.append(
        np.diff(time) > _SAME * np.spacing(time[1:]), True
    )  # of those at one time, where a part of the run follows another
    torque, time = torque[last], time[last]
    squares, steps = torque**2, np.diff(time)
    beside = np.minimum(np.append(np.inf, steps[:-1]), np.append(steps[1:], np.inf))
    left_out = steps**2 * np.diff(np.gradient(squares, time)) / 12  # by chords
    bent = np.sum(left_out[steps <= _LIKE_ITS_NEIGHBOURS * beside])
    return float(np.sqrt(max(0.0, np.trapezoid(squares, time) - bent) / (time[-1] - time[0])))
