"""What became of a start: its curves over time, its events, why it ended."""

from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import cache, cached_property
from typing import Any, NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from cranktrain.language import N_, Words, _
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.motion import Array
from cranktrain.questions.gas.chambers import GasInChambers
from cranktrain.questions.start.asked import StartAsked
from cranktrain.questions.start.case import StartCase
from cranktrain.record import record
from cranktrain.references import THEORY_OF_TRANSIENTS as _THEORY
from cranktrain.saying.catalogue import quantity
from cranktrain.saying.checks import StageResult
from cranktrain.transient.clutched.settled import SettledStroke
from cranktrain.transient.clutched.stopping import WorstStop
from cranktrain.transient.equation import Kernels
from cranktrain.transient.reduced import ReducedMachine
from cranktrain.transient.runs import TransientRun

_TIME = ("time",)
_REDUCED = "docs/theory/reduced-machine"


@record
class StartCurves:
    """A run over time; all arrays of shape (time,)."""

    crank_angle_turned: Array = quantity(
        "φ", "rad", _TIME, N_("Crank angle as shown, counted on through all turns"), _THEORY, "26.9"
    )
    crank_speed: Array = quantity("ω", "rad/s", _TIME, N_("Speed of the crank"), _THEORY, "26.9", shown="rpm")
    motor_speed: Array = quantity("ω_m", "rad/s", _TIME, N_("Speed of the motor"), _THEORY, "26.9", shown="rpm")
    motor_torque: Array = quantity("M_m", "N*m", _TIME, N_("Torque of the motor at its own shaft"), _THEORY, "26.5")
    load_torque: Array = quantity("M_Q", "N*m", _TIME, N_("Torque that the loads take at the crank"), _THEORY, "26.9")
    motor_power: Array = quantity("P_m", "W", _TIME, N_("Power of the motor at its shaft"), _THEORY, "26.10")
    motor_work: Array = quantity("W_m", "J", _TIME, N_("Work of the motor since the beginning"), _THEORY, "26.10")
    load_work: Array = quantity("W_Q", "J", _TIME, N_("Work that the loads have taken"), _THEORY, "26.10")
    lost_work: Array = quantity(
        "W_v", "J", _TIME, N_("Work that gearing, clutch and brake have lost"), _THEORY, "26.10"
    )
    kinetic_energy: Array = quantity("T", "J", _TIME, N_("Kinetic energy of machine and drive"), _THEORY, "26.11")
    motor_heat: Array = quantity("Q_m", "J", _TIME, N_("Heat in the motor's rotor"), _THEORY, "26.10")


class GasOverTime(NamedTuple):
    """Pressures in chambers that remember their gas.

    Attributes
    ----------
    names : tuple of str
        Of the chambers.
    whole : Array, shape (chamber, time)
        At all times of the run. [Pa]
    asked : array of int
        Which of these times were asked for.
    """

    names: tuple[str, ...]
    whole: Array
    asked: NDArray[np.intp]


@record
class StartPressures(StageResult):
    """Pressures over time."""

    gas_pressure: Array = quantity(
        "p", "Pa", ("chamber", "time"), N_("Absolute pressure in each chamber"), _REDUCED, "31.5"
    )


@record
class StartEvents:
    """What happened on the way; all arrays of shape (event,), and events by their names, numbered where one repeats."""

    labels: Mapping[str, tuple[str, ...]]
    event_time: Array = quantity("t", "s", ("event",), N_("Time of an event"), _THEORY, "26.9")
    event_angle: Array = quantity(
        "φ", "rad", ("event",), N_("Crank angle of an event, counted on through all turns"), _THEORY, "26.9"
    )
    event_speed: Array = quantity(
        "ω", "rad/s", ("event",), N_("Speed of the crank at an event"), _THEORY, "26.9", shown="rpm"
    )


@record
class StartEvent:
    """Something on the way: what it is, not yet translated; time, angle as shown, counted on, speed of the crank.

    [s, rad, rad/s]
    """

    sort: str
    time: float
    angle: float
    speed: float

    @property
    def name(self) -> Words:
        """What people call it."""
        return _(self.sort)


@record
class StrokeRun:
    """What a stroke tells besides its curves: the stroke, and what looks for the longest stop when asked."""

    settled: SettledStroke
    look_for_stop: Callable[[], WorstStop | None]

    @cached_property
    def longest_stop(self) -> WorstStop | None:
        """The longest stop that a command on the way could lead to; None where there is none."""
        return self.look_for_stop()


@record
class StartRun:
    """What became of a start.

    Attributes
    ----------
    reason : Words
        Why it ended, a sentence.
    time : Array, shape (time,)
        [s]
    curves : StartCurves
    whole_time, whole : Array, StartCurves
        The same from beginning to end, whatever times were asked for. [s]
    events : tuple of StartEvent
    residual, supplied : float
        Kinetic energy at the end less what was given and taken, and the work by which to judge it. [J]
    tolerance : float
    n_steps : int
    method : str
    gas : GasOverTime or None
        Of a compressor.
    stroke : StrokeRun or None
        Of a start that is a single stroke.
    notes : tuple of str
        What of the machine file it does not use, or does not come to: sentences.
    """

    reason: Words
    time: Array
    curves: StartCurves
    whole_time: Array
    whole: StartCurves
    events: tuple[StartEvent, ...]
    residual: float
    supplied: float
    tolerance: float
    n_steps: int
    method: str
    gas: GasOverTime | None = None
    stroke: StrokeRun | None = None
    notes: tuple[str, ...] = ()


class PartOfRun(NamedTuple):
    """Part of a run: when it begins and ends at most, the speed that ends it, and the machine in it. [s, rad/s]

    `to_rest`: it ends where the crank comes to rest, to turn the other way.
    """

    start: float
    end: float
    target: float
    machine: ReducedMachine
    to_rest: bool = False


class RanStart(NamedTuple):
    """A start that has run, before anything is made of its states.

    Attributes
    ----------
    case : StartCase
    runs : list of (PartOfRun, TransientRun)
        One after the other, with the states at all times of the run; those of each span from its beginning on.
    reason : int
        Why it ended.
    asked : Array
        Times at which curves are wanted. [s]
    """

    case: StartCase
    runs: list[tuple[PartOfRun, TransientRun]]
    reason: int
    asked: Array


class RanRows(NamedTuple):
    """Starts that have run, one behind the other, before anything is made of their states.

    Attributes
    ----------
    cases : tuple of StartCase
    time : Array, shape (sample,)
        [s]
    state : Array, shape (sample, state)
    torque, inertia : Array, shape (sample,)
        Of the motor, and the machine's reduced to the crank. [N·m, kg·m²]
    sizes : array of int, shape (design,)
        How many samples each has.
    marks : Array, shape (event, 4)
        Kind, time counted on, angle and speed of events. [1, s, rad, rad/s]
    n_marks : array of int, shape (design,)
        How many events each has.
    told : Array, shape (`RanFacts`, design)
    """

    cases: tuple[StartCase, ...]
    time: Array
    state: Array
    torque: Array
    inertia: Array
    sizes: NDArray[np.intp]
    marks: Array
    n_marks: NDArray[np.intp]
    told: "RanFacts"


class RanFacts(NamedTuple):
    """What is told of a start besides its samples; of each design, shape (design,).

    Attributes
    ----------
    reason : Array
        Why it ended.
    n_steps : Array
        Of its last part.
    left_over, supplied : Array
        Of all parts together, as of `TransientRun`. [J]
    end_time, end_speed : Array
        [s, rad/s]
    """

    reason: Any
    n_steps: Any
    left_over: Any
    supplied: Any
    end_time: Any
    end_speed: Any


class RunsDesign(Protocol):
    """Runs the start of a design, by its place, as it is asked for."""

    def __call__(self, design: int, asked: StartAsked) -> StartRun:
        """Run it, or refuse it by an `InputError`."""
        ...


@record
class StartsInShort:
    """Starts that are run without making curves of their states.

    Attributes
    ----------
    kernels : Kernels
        Of compiled runs.
    alone : callable
        Runs a design by its place in plain Python, or refuses it by an `InputError`.
    groups : callable
        Which of some designs can be run together, compiled: their places, group by group.
    together : callable
        Runs those of a group so, or some of it in their order; None of one that is to be run alone.
    """

    kernels: Kernels
    alone: Callable[[int], RanRows]
    groups: Callable[[Sequence[int]], list[list[int]]]
    together: Callable[[Sequence[int]], Iterator[RanRows | None]]


@record
class ReadyStarts:
    """Starts of all designs, each run when it is asked for.

    Attributes
    ----------
    run : callable
        See `RunsDesign`.
    in_short : StartsInShort or None
        None where curves cannot be left out.
    """

    run: RunsDesign
    in_short: StartsInShort | None


def start_curves(run: StartRun) -> StartCurves:
    """Give the curves at the times that were asked for."""
    return run.curves


def start_pressures(run: StartRun, gas: GasInChambers, crank_angle: CrankAngle) -> StartPressures:
    """Pressures at times that were asked for: a compressor's as chambers remember, of other gas by the crank angle."""
    names = gas.chambers.names
    angle = run.curves.crank_angle_turned + crank_angle.zero
    pressure = gas.pressure(angle, gas.volume(angle))[0]
    if run.gas is not None:
        pressure[[names.index(name) for name in run.gas.names]] = run.gas.whole[:, run.gas.asked]
    return StartPressures(labels={"chamber": names}, gas_pressure=pressure)


def start_events(run: StartRun) -> StartEvents:
    """Times, crank angles and speeds of what happened on the way."""
    return events_in_time(run.events)


def events_in_time(events: Iterable[StartEvent]) -> StartEvents:
    """Put events in the order of time into arrays."""
    each = list(events)
    rows = np.array([(event.time, event.angle, event.speed) for event in each]).reshape(-1, 3)
    return numbered_events(tuple(event.sort for event in each), rows)


def numbered_events(sorts: tuple[str, ...], rows: Array) -> StartEvents:
    """Events by their sorts, with times, angles and speeds, shape (event, 3); those of one sort numbered."""
    return StartEvents({"event": _numbered(sorts)}, *rows.T)


@cache
def _numbered(sorts: tuple[str, ...]) -> tuple[str, ...]:
    """Names of events, which most starts of one machine have in common."""
    counts: Counter[str] = Counter()
    labels: list[str] = []
    for sort in sorts:
        counts[sort] += 1
        labels.append(f"{sort} {counts[sort]}" if counts[sort] > 1 else sort)
    return tuple(labels)
