"""`start`: run a machine with its motor over time, write it where asked, and show what became of it."""

from collections.abc import Iterator
from dataclasses import replace
from functools import partial as with_arguments
from pathlib import PurePath

import numpy as np
from rich.text import Text

from cranktrain.cli.asked import Asked, in_units_of, units_asked_for
from cranktrain.cli.how_far import says_how_far
from cranktrain.cli.number_lists import numbers_listed
from cranktrain.cli.screen.columns import Column, section_of_columns
from cranktrain.cli.screen.groups import RowGroup, group_lines
from cranktrain.cli.screen.text import page, show_lines
from cranktrain.cli.screen.title import title
from cranktrain.errors import InputError, Position, Problem, problems_as, refuse
from cranktrain.how_far import say_how_far
from cranktrain.io.machine_file import MachineFile, read_machine
from cranktrain.io.output import write_whole
from cranktrain.io.start_tables import SUFFIXES, start_csv, start_json
from cranktrain.language import said as _
from cranktrain.one_line import one_line
from cranktrain.quantities import unlisted
from cranktrain.record import record
from cranktrain.saying.amounts import figures
from cranktrain.saying.wording import number
from cranktrain.study.start import Start, start

_SHOWN_EVENTS = 12
_PICTURES = (".png", ".svg", ".pdf")
_DECIMALS = ("point", "comma")


@record
class StartRequest(Asked):
    """What is asked of `start`, as typed."""

    decimal: str = "point"
    full: bool = False
    at: str | None = None


def show_start(request: StartRequest) -> None:
    """Run, write and show."""
    suffix = _suffix(request)
    asked = units_asked_for(request.units)
    file = read_machine(request.file, request.settings)
    times = None if request.at is None else _times(request.at)
    with in_units_of(file, asked):
        with problems_as(_at_option), problems_as(file.document.located), says_how_far():
            found = start(file.machine, at=times, progress=_progress)
        if request.output is not None:
            _write(found, file, request, suffix)
            print(_("written: {name}", name=one_line(request.output)))
            return
        with page(title(file.machine)) as console:
            if times is not None:
                section_of_columns(console, _("Start"), *_at_times(found))
                return
            show_lines(console, group_lines([RowGroup(_("Start"), found.rows())], console.width))
            show_lines(console, map(Text, _event_lines(found, request)))


def _times(text: str) -> list[float]:
    """Read times that are asked for; refuse what is none. [s]"""
    allowed = _("must be times in seconds from 0 on, such as 0.5 or 0,0.1..2")
    times = [float(time) for time in numbers_listed("--at", text, allowed, "0,0.1..2")]
    refuse([] if min(times) >= 0 else [Problem("--at", text, allowed)])
    return times


def _at_option(problem: Problem) -> Problem:
    """Put what is wrong with the times to the option that asks for them."""
    return replace(problem, path="", position=Position("--at")) if problem.path == "at" else problem


def _at_times(found: Start) -> tuple[list[Column], list[str]]:
    """Curves at the times that were asked for, and these as labels."""
    columns: list[Column] = []
    for name, entry in found.catalogue.items():
        shown = figures(getattr(found, name), entry.shown)
        columns.append(Column(entry.symbol or name, shown.unit, shown.texts, name))
    return columns, [f"{time:g} s" for time in found.time.tolist()]


def _suffix(request: StartRequest) -> str:
    """How the output is to be written; refuse what is no way."""
    if request.decimal not in _DECIMALS:
        raise InputError([unlisted("--decimal", request.decimal, _DECIMALS)])
    if request.output is None:
        return ""
    suffix = PurePath(request.output).suffix.lower()
    if suffix not in (*SUFFIXES, *_PICTURES):
        allowed = _("must end in one of: {suffixes}", suffixes=", ".join((*SUFFIXES, *_PICTURES)))
        raise InputError([Problem("-o", request.output, allowed)])
    return suffix


def _write(found: Start, file: MachineFile, request: StartRequest, suffix: str) -> None:
    """Write curves or a picture."""
    assert request.output is not None
    if suffix in _PICTURES:
        from cranktrain.viz import save, start_picture

        save(start_picture(found), request.output, force=request.force)
        return
    chunks = (
        start_json(found, file.document.data)
        if suffix == ".json"
        else start_csv(found, comma=request.decimal == "comma")
    )
    write_whole(request.output, chunks, force=request.force)


def _event_lines(found: Start, request: StartRequest) -> Iterator[str]:
    """What happened on the way, line by line."""
    events = found.events
    shown = events if request.full or len(events) <= _SHOWN_EVENTS else events[: _SHOWN_EVENTS - 1]
    if shown:
        yield ""
        yield _("Events")
    for event in shown:
        yield _(
            "  {time}  {name}, at {angle}, {speed}",
            time=f"{event.time:10.6f} s",
            name=event.name,
            angle=number(float(np.mod(event.angle, 2 * np.pi)), "deg"),
            speed=number(event.speed, "rpm"),
        )
    if len(shown) < len(events):
        yield _("  and {n} more: --full shows all", n=len(events) - len(shown))


def _progress(now: float, angle: float, speed: float) -> None:
    """Say how far a run has come, which Ctrl-C then ends."""
    say_how_far(with_arguments(_how_far, now, angle, speed))


def _how_far(now: float, angle: float, speed: float) -> str:
    words = _("{time:.3f} s, {turns:.2f} turns, {speed}   (Ctrl-C ends it)")
    return words.format(time=now, turns=angle / (2 * np.pi), speed=number(speed, "rpm"))
