"""`start`: run a machine with its motor over time, write it where asked, and show what became of it."""

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from cranktrain.cli.asked import Asked, in_units_of, units_asked_for
from cranktrain.cli.how_far import says_how_far
from cranktrain.cli.number_lists import numbers_listed
from cranktrain.cli.run_files import form_or_picture, write_run
from cranktrain.cli.screen.sections import show_page
from cranktrain.cli.why import refuse_beside, show_why
from cranktrain.errors import Position, Problem, problems_as, refuse
from cranktrain.io.machine_file import read_machine
from cranktrain.io.title import title
from cranktrain.language import said as _
from cranktrain.motion import Array
from cranktrain.one_line import one_line
from cranktrain.record import record
from cranktrain.saying.catalogue import Entry
from cranktrain.saying.sections import Column, Grid, PagePart, ShownSection, Unfolded
from cranktrain.study.start import Start, say_run_so_far, start

_SHOWN_EVENTS = 12


@record
class StartRequest(Asked):
    """What is asked of `start`, as typed."""

    decimal: str = "point"
    full: bool = False
    at: str | None = None
    why: str | None = None
    vary: tuple[str, ...] = ()
    wanted: tuple[str, ...] | None = None
    is_meant: bool = False


def show_start(request: StartRequest) -> None:
    """Run, write and show; of several designs their facts."""
    if request.vary:
        _show_sweep(request)
        return
    given = {"--wanted": request.wanted is not None, "--yes": request.is_meant}
    needed = _("needs --vary PATH=VALUES: it is for starts of several designs")
    refuse(Problem(option, None, needed) for option, is_given in given.items() if is_given)
    refuse_beside(request.why, (request.output is not None, request.full, request.at))
    form = None if request.output is None else form_or_picture(request.output, request.decimal)
    asked = units_asked_for(request.units)
    file = read_machine(request.file, request.settings)
    times = None if request.at is None else _times(request.at)
    with in_units_of(file, asked):
        with problems_as(_at_option), problems_as(file.document.located), says_how_far():
            found = start(file.machine, at=times, progress=say_run_so_far)
        if request.output is not None and form is not None:
            write_run(found, form, request.output, file.document.data, force=request.force)
            return
        if request.output is not None:
            from cranktrain.cli.quiet_pictures import save_quietly
            from cranktrain.viz import start_picture

            save_quietly(lambda: start_picture(found), request.output, force=request.force)
            print(_("written: {name}", name=one_line(request.output)))
            return
        if request.why is not None:
            show_why(title(file.machine), found, request.why, file)
        elif times is not None:
            show_page(title(file.machine), [ShownSection(_("Start"), (_at_times(found),))])
        else:
            show_page(title(file.machine), _shown(found, is_full=request.full))


def _show_sweep(request: StartRequest) -> None:
    """Show facts of starts over what is varied, as `sweep --start` does."""
    from cranktrain.cli.sweep import SweepRequest, show_sweep  # only where something is varied

    given = {"--at": request.at is not None, "--why": request.why is not None, "--full": request.full}
    alone = _("is of one start, and does not go with --vary")
    refuse(Problem(option, None, alone) for option, is_given in given.items() if is_given)
    show_sweep(
        SweepRequest(
            file=request.file,
            settings=request.settings,
            output=request.output,
            force=request.force,
            units=request.units,
            vary=request.vary,
            wanted=request.wanted,
            over_time=True,
            is_meant=request.is_meant,
            decimal=request.decimal,
        )
    )


def _times(text: str) -> list[float]:
    """Read times that are asked for; refuse what is none. [s]"""
    allowed = _("must be times in seconds from 0 on, such as 0.5 or 0,0.1..2")
    times = [float(time) for time in numbers_listed("--at", text, allowed, "0,0.1..2")]
    refuse([] if min(times) >= 0 else [Problem("--at", text, allowed)])
    return times


def _at_option(problem: Problem) -> Problem:
    """Put what is wrong with the times to the option that asks for them."""
    return replace(problem, path="", position=Position("--at")) if problem.path == "at" else problem


def _at_times(found: Start) -> Grid:
    """Curves at the times that were asked for."""
    columns = [
        Column(
            " ".join((entry.symbol or name, *whose)),
            values.tolist(),
            entry.shown,
            "amounts",
            name,
        )
        for name, entry in found.catalogue.items()
        if found.is_curve(entry)
        for whose, values in _members(found, entry)
    ]
    return Grid(columns, [f"{time:g} s" for time in found.time.tolist()])


def _members(found: Start, entry: Entry) -> Iterator[tuple[tuple[str, ...], Array]]:
    """Curves of a quantity, each with whose it is."""
    values = np.asarray(getattr(found, entry.name))
    names = [name for members in found.titles_of(entry).values() for name in members]
    if not names:
        yield (), values
    else:
        yield from (((name,), own) for name, own in zip(names, values, strict=True))


def _shown(found: Start, *, is_full: bool) -> Iterator[PagePart]:
    """What became of it; of many events the first, unless all are asked for."""
    n_more = len(found.events) - _SHOWN_EVENTS + 1
    for part in found.sections():
        if isinstance(part, ShownSection) and not is_full and n_more > 1:
            more = Unfolded(_("and {n} more: --full shows all", n=n_more))
            yield ShownSection(part.heading, (*part.parts[: _SHOWN_EVENTS - 1], more))
        else:
            yield part
