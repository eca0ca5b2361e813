"""A start over time: what was asked of a machine with its motor, and what became of it."""

from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np

from cranktrain.analysis.behind import pipeline
from cranktrain.analysis.grids import FACTS_STEP
from cranktrain.analysis.kept_outcomes import KeptOutcomes
from cranktrain.analysis.outcomes import run_stages
from cranktrain.analysis.parts import designs_of, parts_of, parts_together, refuse_wrong
from cranktrain.analysis.stages import lacking, leading_to, stages_over_time
from cranktrain.errors import InputError, Problem
from cranktrain.how_far import say_how_far
from cranktrain.language import Listed, Words, _
from cranktrain.layout.drive.declared import DeclaredDrive
from cranktrain.layout.question import Stage
from cranktrain.machine import Machine
from cranktrain.motion import Array
from cranktrain.motors import DeclaredMotor
from cranktrain.one_line import short
from cranktrain.questions.start.asked import MovingParts, StartAsked
from cranktrain.questions.start.facts import StartFacts, StrokeFacts, StrokeStops
from cranktrain.questions.start.load_forces import StartForces
from cranktrain.questions.start.record import StartEvent, StartEvents, StartPressures, StartRun
from cranktrain.questions.start.rows import start_rows
from cranktrain.record import record
from cranktrain.saying.catalogue import Entry, entries
from cranktrain.saying.rows import AnswerLine, Telling
from cranktrain.saying.run import Axis, BehindQuantity, Run
from cranktrain.saying.sections import Answer, PagePart, Unfolded, section
from cranktrain.saying.wording import number
from cranktrain.transient.endings import STOPPED
from cranktrain.transient.gearing import overall_ratio
from cranktrain.transient.runs import REASONS, Progress


@record
class Start(Run):
    """A run over time of one machine with its motor.

    Attributes
    ----------
    machine : Machine
    run : StartRun
    given : mapping of type to object
        What the stages over time give that has quantities: curves, events, facts, by type.
    motor : DeclaredMotor or None
    gear_ratio : float
        Turns of the motor for one of the crank.
    """

    machine: Machine
    run: StartRun
    given: Mapping[type, Any]
    motor: DeclaredMotor | None
    gear_ratio: float

    def __getattr__(self, name: str) -> Array:
        """Give a curve over time, what is known of each event, or a fact, by its name."""
        if name.startswith("_") or name not in self._homes:
            raise AttributeError(name)
        entry, home = self._homes[name]
        return getattr(home, name) if entry.dimensions else getattr(home, name)[0]

    def __repr__(self) -> str:
        """Show whose it is, how long it took and why it ended, in one line."""
        about = _(
            "<Start of {name}: {time:.4g} s, {reason}>",
            name=short(self.machine.name),
            time=self.run.whole_time[-1],
            reason=self.run.reason,
        )
        return str(about)

    @property
    def time(self) -> Array:
        """Times at which curves stand, shape (time,). [s]"""
        return self.run.time

    @property
    def subject(self) -> Words:
        """Whose it is."""
        return self.machine.name

    @property
    def axis(self) -> Axis:
        """The time, which its curves are over."""
        return Axis("time", "s", "t", self.time)

    @property
    def catalogue(self) -> Mapping[str, Entry]:
        """Curves over time, what is known of events, and facts of the whole run, by name."""
        return {name: entry for name, (entry, _home) in self._homes.items()}

    @cached_property
    def _homes(self) -> dict[str, tuple[Entry, Any]]:
        """Entry of every quantity, and what holds it."""
        return {entry.name: (entry, home) for kind, home in self.given.items() for entry in entries(kind)}

    @property
    def labels(self) -> Mapping[str, tuple[str, ...]]:
        """Events by their names, and numbers where a name comes again; chambers and loads by theirs."""
        each = (self.given.get(kind) for kind in (StartEvents, StartPressures, StartForces))
        return {name: members for held in each if held is not None for name, members in held.labels.items()}

    def attributes(self) -> Mapping[str, object]:
        """What a dataset says of it as a whole: the machine, and why it ended."""
        return {"name": self.machine.name, "reason": str(self.run.reason)}

    def about(self) -> Iterator[tuple[str, Words]]:
        """What heads a file of it: the machine, why it ended, energy that is left over, and what happened."""
        yield "machine", self.machine.name
        yield "ended", self.run.reason
        left_over = _("{residual:.3g} J of {supplied:.6g} J", residual=self.run.residual, supplied=self.run.supplied)
        yield "energy left over", left_over
        said = _("{name} at {time!r} s, crank angle {angle!r} deg")
        for event in self.events:
            yield "event", said.format(name=event.name, time=event.time, angle=float(np.degrees(event.angle)))

    def before(self) -> Mapping[str, object]:
        """What a .json has before its numbers: why it ended, energy that is left over, and what happened."""
        return {
            "reason": str(self.run.reason),
            "energy_residual": {"unit": "J", "value": self.run.residual, "supplied": self.run.supplied},
            "tolerance": self.run.tolerance,
            "events": [
                {
                    "name": str(event.name),
                    "time": event.time,
                    "crank_angle": np.degrees(event.angle),
                    "speed": event.speed,
                }
                for event in self.events
            ],
        }

    def behind(self, name: str) -> BehindQuantity:
        """What leads to a quantity in the machine."""
        parts = _parts((self.machine,), StartAsked())
        return pipeline(name, stages_over_time(self.machine, parts), parts, self.machine.declared).in_short

    @property
    def events(self) -> tuple[StartEvent, ...]:
        """What happened on the way, in the order of time."""
        return self.run.events

    def answer_rows(self) -> Iterator[tuple[Words, list[AnswerLine]]]:
        """Lines of the answer."""
        facts, stroke, stops = self.given[StartFacts], self.given.get(StrokeFacts), self.given.get(StrokeStops)
        yield _("Start"), list(start_rows(Telling(self.labels, self.titles, 0), self.run, facts, stroke, stops))

    def sections(self) -> Iterator[PagePart]:
        """The answer, and what happened on the way, line by line."""
        yield Answer(tuple(self.answer_rows()))
        yield from section(_("Events"), map(_event_line, self.events))


class EventTexts(NamedTuple):
    """An event as it is written: when, what, at which crank angle, and the crank's speed."""

    time: str
    name: Words
    angle: Words
    speed: Words


def event_texts(event: StartEvent) -> EventTexts:
    """Write when and where something happened."""
    angle = number(float(np.mod(event.angle, 2 * np.pi)), "deg")
    return EventTexts(f"{event.time:10.6f} s", event.name, angle, number(event.speed, "rpm"))


def _event_line(event: StartEvent) -> Unfolded:
    """Say when and where something happened."""
    return Unfolded(_("{time}  {name}, at {angle}, {speed}", **event_texts(event)._asdict()))


def start(machine: Machine, *, at: Sequence[float] | None = None, progress: Progress | None = None) -> Start:
    """Run a machine with its motor over time, as [drive.start] says.

    Parameters
    ----------
    machine : Machine
        With [drive].
    at : sequence of float, optional
        Times at which curves stand, rising; those that the file's interval gives, or evenly, unless given. [s]
    progress : callable, optional
        Told the time, the crank angle and the speed that the run has come to; with it Ctrl-C ends the run, and what was
        computed so far is kept. [s, rad, rad/s]

    Returns
    -------
    Start

    Raises
    ------
    InputError
        With everything that is wrong with the machine, or what it lacks.
    """
    times = None if at is None else np.unique(np.asarray(at, dtype=np.float64))
    results = [stage.gives for question in machine.questions for stage in question.over_time() if stage.results]
    found = over_time(machine, (StartRun, *results, MovingParts), StartAsked(times, progress))
    given = {kind: found[kind] for kind in results if kind in found}
    ratio = overall_ratio(found[DeclaredDrive].gearings[0])
    return Start(machine, found[StartRun], given, found[MovingParts].motor, ratio)


def whole_start(machine: Machine) -> Start:
    """Run a machine with its motor over time, and say how far it is: whoever interrupts that wants no part of it."""
    found = start(machine, progress=say_run_so_far)
    if found.run.reason == _(REASONS[STOPPED]):
        raise KeyboardInterrupt
    return found


def say_run_so_far(now: float, angle: float, speed: float) -> None:
    """Say how far a run has come, which Ctrl-C then ends. [s, rad, rad/s]"""
    words = _("{time:.3f} s, {turns:.2f} turns, {speed}   (Ctrl-C ends it)")
    say_how_far(lambda: words.format(time=now, turns=angle / (2 * np.pi), speed=number(speed, "rpm")))


def over_time(machine: Machine, outcomes: Sequence[type], asked: StartAsked | None = None) -> Mapping[type, Any]:
    """Run the stages over time that lead to some outcomes.

    Parameters
    ----------
    machine : Machine
        With [drive].
    outcomes : sequence of type
        `StartRun`, and whatever stands on the way to it.
    asked : StartAsked, optional
        What is asked of the run besides what the file says.

    Returns
    -------
    mapping of type to object
        What the machine declares, and what the stages give, by type.
    """
    refuse_wrong((machine,))
    return over_time_of_designs((machine,), outcomes, asked)


def over_time_of_designs(
    machines: Sequence[Machine],
    outcomes: Sequence[type],
    asked: StartAsked | None = None,
    kept: KeptOutcomes | None = None,
) -> Mapping[type, Any]:
    """As `over_time`, of designs of one machine with which nothing is wrong, and which differ in numbers alone.

    `kept`: what stages gave of other designs of it; what is the same of these is given again.
    """
    return _over_time(machines[0], _parts(machines, asked or StartAsked()), outcomes, kept)


def over_time_of_columns(
    together: Machine, n_designs: int, outcomes: Sequence[type], kept: KeptOutcomes | None = None
) -> Mapping[type, Any]:
    """The same of designs that stand together in the columns of one machine."""
    laid = parts_together(together, designs_of(together, n_designs), step=FACTS_STEP)
    return _over_time(together, {**laid, StartAsked: StartAsked()}, outcomes, kept)


def is_over_time(entry: Entry) -> bool:
    """Whether a quantity of a start is a curve."""
    return "time" in entry.dimensions


def quantities_of_start(machine: Machine) -> dict[str, Entry]:
    """What a start of a machine tells, by name; none is run.

    Raises
    ------
    InputError
        With everything that is wrong with the machine, or what it lacks.
    """
    refuse_wrong((machine,))
    stages, absent = _stages(machine, _parts((machine,), StartAsked()))
    own = {stage.gives for question in machine.questions for stage in question.over_time() if stage.results}
    kinds = (stage.gives for stage in stages if stage.gives in own and stage.gives.__name__ not in absent)
    return {entry.name: entry for kind in kinds for entry in entries(kind)}


def _over_time(
    machine: Machine, parts: dict[type, Any], outcomes: Sequence[type], kept: KeptOutcomes | None = None
) -> Mapping[type, Any]:
    stages, absent = _stages(machine, parts)
    return {**parts, **run_stages(leading_to(stages, outcomes), parts, absent, kept)}


def _stages(machine: Machine, parts: dict[type, Any]) -> tuple[Sequence[Stage], Mapping[str, Sequence[Words]]]:
    """Stages that lead to a start, and which outcomes cannot be made for which lack; refuses what has no start."""
    if DeclaredDrive not in parts:
        raise InputError([Problem("drive", None, _("is missing; a start needs what drives the crank"))])
    stages = stages_over_time(machine, parts)
    absent = lacking(stages, parts)
    if StartRun.__name__ in absent:
        lacks = Listed(tuple(dict.fromkeys(absent[StartRun.__name__])))
        raise InputError([Problem("drive", None, _("needs what the machine moves: {lacks}", lacks=lacks))])
    return stages, absent


def _parts(machines: Sequence[Machine], asked: StartAsked) -> dict[type, Any]:
    """What designs declare, and what is asked of their starts."""
    return {**parts_of(machines, step=FACTS_STEP), StartAsked: asked}
