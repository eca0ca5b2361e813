"""What became of a start in numbers: how long it took, what the motor gave, where the energy went; of a stroke more."""

from collections.abc import Mapping
from dataclasses import fields
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

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
    """A whole run, whatever times were asked for; all arrays of shape (design,)."""

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


class RunsInRow(NamedTuple):
    """Whole runs of designs, one behind the other.

    Attributes
    ----------
    time : Array, shape (sample,)
        [s]
    curves : mapping of str to Array, shape (sample,)
        Of `StartCurves`, by name; of these `kinetic_energy` where it is asked for.
    begins : array of int, shape (design,)
        At which sample each begins.
    reversals : Array, shape (design,)
        How often the crank turned round.
    residual, supplied : Array, shape (design,)
        Kinetic energy at the end less what was given and taken, and the work by which to judge it. [J]
    """

    time: Array
    curves: Mapping[str, Array]
    begins: NDArray[np.intp]
    reversals: Array
    residual: Array
    supplied: Array


def start_facts(run: StartRun) -> StartFacts:
    """Take from the whole run what people ask of it in single numbers."""
    return facts_in_row(
        RunsInRow(
            run.whole_time,
            {one.name: getattr(run.whole, one.name) for one in fields(run.whole)},
            np.zeros(1, dtype=np.intp),
            np.array([sum(event.sort == EVENTS[REVERSAL] for event in run.events)], dtype=np.float64),
            np.array([run.residual]),
            np.array([run.supplied]),
        )
    )


def facts_in_row(runs: RunsInRow) -> StartFacts:
    """Facts of runs, each to the last bit as alone; NaN of those of an energy that is not there."""
    time, curves, first = runs.time, runs.curves, runs.begins
    last = np.append(first[1:], len(time)) - 1
    turned, torque, power = (curves[name] for name in ("crank_angle_turned", "motor_torque", "motor_power"))
    kinetic = curves.get("kinetic_energy", np.full(len(time), np.nan))

    def final(curve: Array) -> Array:
        """Values at the end; 0 where only rounding is left of one."""
        is_any = np.abs(curve[last]) > _ROUNDING * np.maximum.reduceat(np.abs(curve), first)
        return np.where(is_any, curve[last], 0.0)

    is_given = runs.supplied != 0.0
    each = (
        time[last],
        (turned[last] - turned[first]) / (2 * np.pi),
        runs.reversals,
        final(curves["crank_speed"]),
        np.minimum.reduceat(torque, first),
        np.maximum.reduceat(torque, first),
        effective_torques(torque, time, first),
        np.minimum.reduceat(power, first),
        np.maximum.reduceat(power, first),
        final(curves["motor_work"]),
        final(curves["load_work"]),
        final(curves["lost_work"]),
        kinetic[first],
        final(kinetic),
        final(curves["motor_heat"]),
        np.divide(np.abs(runs.residual), runs.supplied, out=np.zeros(len(first)), where=is_given),
    )
    return StartFacts(*each)


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
    return float(effective_torques(torque, time, np.zeros(1, dtype=np.intp))[0])


def effective_torques(torque: Array, time: Array, begins: NDArray[np.intp]) -> Array:
    """The same of runs one behind the other, each to the last bit as alone; `begins` says at which sample each does."""
    ends = np.append(begins[1:], len(time)) - 1
    duration, value = time[ends] - time[begins], np.abs(torque[ends])
    is_last = np.append(
        np.diff(time) > _SAME * np.spacing(time[1:]), True
    )  # of those at one time, where a part of the run follows another
    is_last[ends] = True
    torque, time = torque[is_last], time[is_last]
    after = np.cumsum(np.add.reduceat(is_last, begins, dtype=np.intp))
    squares, steps = torque**2, np.diff(time)
    with np.errstate(all="ignore"):  # from one run to the next
        slopes = _slopes(squares, steps, after)
        left_out = steps**2 * np.diff(slopes) / 12  # by chords
    chords = steps * (squares[1:] + squares[:-1]) / 2.0
    apart = steps.copy()
    apart[after[:-1] - 1] = np.inf
    beside = np.minimum(np.append(np.inf, apart[:-1]), np.append(apart[1:], np.inf))
    is_bent = steps <= _LIKE_ITS_NEIGHBOURS * beside
    own = [slice(first, end - 1) for first, end in pairwise([0, *after.tolist()])]
    # sums of each alone, as a sum over all would round otherwise
    bent = np.array([np.sum(left_out[one][is_bent[one]]) for one in own])
    whole = np.array([np.sum(chords[one]) for one in own])
    is_run = duration > 0
    mean = np.divide(np.maximum(0.0, whole - bent), duration, out=value**2, where=is_run)
    return np.where(is_run, np.sqrt(mean), value)


def _slopes(values: Array, steps: Array, after: NDArray[np.intp]) -> Array:
    """Slopes of curves one behind the other, as `numpy.gradient` gives them of each; `after` says where each ends."""
    before, behind = steps[:-1], steps[1:]
    slopes = np.empty(len(values))
    slopes[1:-1] = (
        -behind / (before * (before + behind)) * values[:-2]
        + (behind - before) / (before * behind) * values[1:-1]
        + before / (behind * (before + behind)) * values[2:]
    )
    chords = np.diff(values) / steps
    first, last = np.append(0, after[:-1]), after - 1
    is_any = last > first
    slopes[first[is_any]], slopes[last[is_any]] = chords[first[is_any]], chords[last[is_any] - 1]
    return slopes
