"""A start over time: what was asked of a machine with its motor, and what became of it."""

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from cranktrain.analysis.grids import FACTS_STEP
from cranktrain.analysis.outcomes import run_stages
from cranktrain.analysis.parts import parts_of, refuse_wrong
from cranktrain.analysis.stages import lacking, leading_to, stages_for
from cranktrain.errors import InputError, Problem
from cranktrain.language import Listed, Words, _
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.drive.declared import DeclaredBrake, DeclaredDrive, DeclaredStroke
from cranktrain.machine import Machine
from cranktrain.motion import Array
from cranktrain.motors import DeclaredMotor
from cranktrain.one_line import short
from cranktrain.questions.drive.steady_drive import SteadyDrive
from cranktrain.questions.press.stroke_start import run_stroke
from cranktrain.questions.press.strokes import PressStrokes
from cranktrain.questions.reduction.at_angles import has_inertia, reduced_at
from cranktrain.questions.reduction.machines import ReducedMachines
from cranktrain.questions.start.case import Braking, StartCase
from cranktrain.questions.start.gentle_rows import corners_and_rows
from cranktrain.questions.start.notes import start_notes
from cranktrain.questions.start.parts import DeclaredStart
from cranktrain.questions.start.record import StartCurves, StartEvent, StartEvents, StartRun
from cranktrain.questions.start.rows import start_rows
from cranktrain.questions.start.starting import asked_times, run_start, until
from cranktrain.record import record
from cranktrain.saying.catalogue import Entry, entries
from cranktrain.saying.rows import AnswerLine
from cranktrain.saying.run import Axis, Run
from cranktrain.transient.equation import AT_MOTOR, BrakePlace
from cranktrain.transient.gearing import overall_ratio, turning_inertia
from cranktrain.transient.reduced import ReducedMachine
from cranktrain.transient.runs import Progress

_OF_EVENTS = {"event_time": "time", "event_angle": "angle", "event_speed": "speed"}
"""What is known of an event, by the names of its quantities."""


@record
class Start(Run):
    """A run over time of one machine with its motor.

    Attributes
    ----------
    machine : Machine
    run : StartRun
    motor : DeclaredMotor or None
    gear_ratio : float
        Turns of the motor for one of the crank.
    """

    machine: Machine
    run: StartRun
    motor: DeclaredMotor | None
    gear_ratio: float

    def __getattr__(self, name: str) -> Array:
        """Give a curve over time, or what is known of each event, by its name."""
        if name in _OF_EVENTS:
            return np.array([getattr(event, _OF_EVENTS[name]) for event in self.events])
        if not name.startswith("_") and name in self.catalogue:
            return getattr(self.run.curves, name)
        raise AttributeError(name)

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
        """Curves over time, and what is known of events, by name."""
        return {entry.name: entry for entry in (*entries(StartCurves), *entries(StartEvents))}

    @property
    def labels(self) -> Mapping[str, tuple[str, ...]]:
        """Events by their names, and numbers where a name comes again."""
        counts: Counter[str] = Counter()
        labels: list[str] = []
        for event in self.events:
            counts[event.sort] += 1
            labels.append(f"{event.sort} {counts[event.sort]}" if counts[event.sort] > 1 else event.sort)
        return {"event": tuple(labels)}

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

    @property
    def events(self) -> tuple[StartEvent, ...]:
        """What happened on the way, in the order of time."""
        return self.run.events

    def rows(self) -> list[AnswerLine]:
        """Rows of the answer."""
        return list(start_rows(self.run))


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
    parts, found = parts_and_stages(machine)
    times = None if at is None else np.unique(np.asarray(at, dtype=np.float64))
    if DeclaredStroke in parts:
        return _stroke(machine, parts, found, times)
    case = replace(start_case(parts, found), times=times)
    run = run_start(case, progress)
    run = replace(run, notes=tuple(start_notes(parts, run)))
    return Start(machine, run, case.motor, overall_ratio(case.gearing))


def parts_and_stages(machine: Machine) -> tuple[Mapping[type, Any], Mapping[type, Any]]:
    """What a machine declares, and the stages that a start needs: reduced machine, steady running, strokes."""
    refuse_wrong((machine,))
    parts = parts_of((machine,), step=FACTS_STEP)
    if DeclaredDrive not in parts:
        raise InputError([Problem("drive", None, _("is missing; a start needs what drives the crank"))])
    stages = stages_for(machine)
    absent = lacking(stages, parts)
    if ReducedMachines.__name__ in absent:
        lacks = Listed(tuple(dict.fromkeys(absent[ReducedMachines.__name__])))
        raise InputError([Problem("drive", None, _("needs what the machine moves: {lacks}", lacks=lacks))])
    wanted = [kind for kind in (ReducedMachines, SteadyDrive, PressStrokes) if kind.__name__ not in absent]
    return parts, run_stages(leading_to(stages, wanted), parts, absent)


def _stroke(machine: Machine, parts: Mapping[type, Any], found: Mapping[type, Any], times: Array | None) -> Start:
    """The start of a press, which is a stroke."""
    strokes: PressStrokes = found[PressStrokes]
    case, settled = strokes.cases[0], strokes.settled[0]
    if case is None or settled is None:
        raise InputError([Problem("drive.stroke", None, flag) for flag in strokes.flags])
    end = settled.stroke.run.end.time if settled.pace is None else settled.pace.waiting.end.time
    start: DeclaredStart = parts[DeclaredStart]
    interval = start.of(0).interval
    if times is not None:
        times = until(times, end)
    elif not np.isinf(interval):
        times = asked_times(interval, start.texts["interval"], end)
    run = run_stroke(case, settled, times)
    if not settled.is_found:
        run = replace(run, reason=strokes.flags[0])
    run = replace(run, notes=tuple(start_notes(parts, run)))
    return Start(machine, run, parts.get(DeclaredMotor), overall_ratio(parts[DeclaredDrive].gearings[0]))


def _brake(found: DeclaredBrake | None) -> tuple[Braking, BrakePlace]:
    """The brake of the file, whose torque begins its delay after the command, and where it sits."""
    if found is None:
        return Braking(0.0, 0.0, 0.0), AT_MOTOR
    grip = found.of(0)
    place = BrakePlace(float(found.on == "crank"), grip.static_torque / grip.torque)
    return Braking(grip.torque, grip.delay, grip.rise_time), place


def _refuse_unknown_load(machine: ReducedMachine, grid: CrankAngle) -> None:
    """Refuse loads that are no number although the links close: gas can be beyond computing."""
    there = reduced_at(machine, grid.angle[0, 0])
    if np.any(np.isfinite(there.inertia) & ~np.isfinite(there.load)):
        allowed = _("needs the load on the crank, which is no number here: see what `run` says of gas and loads")
        raise InputError([Problem("drive", None, allowed)])


def start_case(parts: Mapping[type, Any], found: Mapping[type, Any]) -> StartCase:
    """The start of the only design."""
    drive, grid = parts[DeclaredDrive], parts[CrankAngle]
    machines, steady = found[ReducedMachines], found.get(SteadyDrive)
    if not has_inertia(machines.each[0], turning_inertia(drive.gearings[0])):
        allowed = _(
            "moves nothing that has inertia, and a start needs some: of the motor, [drive.part.NAME] or [masses]"
        )
        raise InputError([Problem("drive", None, allowed)])
    _refuse_unknown_load(machines.each[0], grid)
    brake, place = _brake(parts.get(DeclaredBrake))
    start: DeclaredStart = parts[DeclaredStart]
    corners, rows = corners_and_rows(machines.corners[0], machines.misses[0], machines.cycle, start.of(0).tolerance)
    cycle_time = np.nan if steady is None else float(steady.cycle_time[0])
    return StartCase(
        machine=machines.each[0],
        corners=corners,
        rows=rows,
        cycle=machines.cycle,
        gearing=drive.gearings[0],
        motor=parts.get(DeclaredMotor),
        design=0,
        start=start.of(0),
        interval_text=start.texts.get("interval", ""),
        brake=brake,
        place=place,
        zero=float(grid.zero[0, 0, 0]),
        steady_speed=machines.cycle / cycle_time,
        cycle_time=cycle_time,
    )
