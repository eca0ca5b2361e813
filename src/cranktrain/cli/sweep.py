"""`sweep`: facts of a machine over values of its file, shown, written or drawn; and which design is best."""

import json
import sys
from collections.abc import Iterator, Mapping
from dataclasses import replace
from pathlib import PurePath
from typing import TYPE_CHECKING

from cranktrain.cli.asked import Asked, in_units_of, units_asked_for
from cranktrain.cli.how_far import says_how_far
from cranktrain.cli.options import n_processors
from cranktrain.cli.run_files import form_or_picture, write_run
from cranktrain.cli.screen.sections import show_page
from cranktrain.cli.sweep_cases import cases_of
from cranktrain.errors import Position, Problem, problems_as, refuse
from cranktrain.extras import lacking_for
from cranktrain.io.machine_file import MachineFile, read_machine
from cranktrain.io.output import look_first, refuse_other_suffix, write_machine_file
from cranktrain.io.title import title
from cranktrain.language import said as _
from cranktrain.one_line import one_line
from cranktrain.record import record
from cranktrain.saying.amounts import Amount
from cranktrain.saying.names import said_name
from cranktrain.saying.sections import PagePart, section
from cranktrain.study.sweep import Sweep, swept
from cranktrain.study.sweep.kept import STORE

if TYPE_CHECKING:
    from cranktrain.io.store_of_sweep import SweepStore

_MOST_PROCESSES = 512


@record
class SweepRequest(Asked):
    """What is asked of `sweep`, as typed; `wanted` is None for the headlines."""

    vary: tuple[str, ...] = ()
    cases: str | None = None
    wanted: tuple[str, ...] | None = None
    least: str | None = None
    most: str | None = None
    save: str | None = None
    over_time: bool = False
    processes: str | None = None
    scheduler: str | None = None
    is_resumed: bool = False
    is_meant: bool = False
    decimal: str = "point"


def show_sweep(request: SweepRequest) -> None:
    """Compute, write where asked, and show.

    Raises
    ------
    InputError
        With everything that is wrong with the request, else with the machine.
    """
    _check(request)
    is_stored = _is_stored(request)
    form = None if request.output is None or is_stored else form_or_picture(request.output, request.decimal, (STORE,))
    if request.save is not None:
        refuse_other_suffix(request.save)
    for name in (None if is_stored else request.output, request.save):
        if name is not None:
            look_first(name, force=request.force)
    asked = units_asked_for(request.units)
    file = read_machine(request.file, request.settings)
    with in_units_of(file, asked):
        store = _store(request) if is_stored else None
        found = _computed(request, file, store)
        if store is not None:
            _say_what_is_stored(store, found)
        elif found.n_stopped:
            said = _(
                "{n} of {all} designs were computed; a store keeps them: with -o NAME{suffix} the same command with"
                " --resume goes on after Ctrl-C"
            )
            n_all = len(found.designs)
            print(said.format(n=n_all - found.n_stopped, all=n_all, suffix=STORE), file=sys.stderr)
        best = _best(request, found)
        if request.save is not None and best is not None:
            _save(request, file, found, best)
        if request.output is not None and form is not None:
            write_run(found, form, request.output, {}, force=request.force)
        elif request.output is not None and store is None:
            from cranktrain.cli.quiet_pictures import save_quietly

            save_quietly(found.plot, request.output, force=request.force)
            print(_("written: {name}", name=one_line(request.output)))
        elif store is None:
            show_page(title(file.machine), _shown(found, request, best))


def _check(request: SweepRequest) -> None:
    """Refuse what does not go together."""
    problems: list[Problem] = []
    if request.vary and request.cases is not None:
        problems.append(Problem("--cases", request.cases, _("does not go with --vary"), _("keep one of the two")))
    elif not request.vary and request.cases is None:
        allowed = _("needs either --vary PATH=VALUES or --cases FILE")
        repair = _('write --vary "mechanism.rod_length=130..160 mm:31"')
        problems.append(Problem("sweep", request.file, allowed, repair))
    for typed in request.vary:
        if not typed.partition("=")[1]:
            allowed = _("must be PATH=VALUES, such as rod_length=130..160mm:31")
            problems.append(Problem("", typed, allowed, position=_VARY))
    if request.least is not None and request.most is not None:
        problems.append(Problem("--most", request.most, _("does not go with --least"), _("keep one of the two")))
    if request.save is not None and request.least is None and request.most is None:
        problems.append(Problem("--save", request.save, _("needs --least FACT or --most FACT")))
    if request.processes is not None and not _is_count(request.processes):
        allowed = _("must be a whole number from 1 to {most}", most=_MOST_PROCESSES)
        problems.append(Problem("--processes", request.processes, allowed))
    if request.scheduler is not None and request.processes is not None:
        allowed = _("does not go with --processes: the cluster has its own")
        problems.append(Problem("--scheduler", request.scheduler, allowed, _("keep one of the two")))
    if request.is_resumed and not _is_stored(request):
        problems.append(Problem("--resume", None, _("needs a store"), _("write -o NAME{suffix}", suffix=STORE)))
    if _is_stored(request):
        problems += lacking_for(STORE)
    if _is_stored(request) and request.units is not None:
        problems.append(Problem("--units", request.units, _("is not for a store, whose numbers are in SI and degrees")))
    refuse(problems)


def _is_stored(request: SweepRequest) -> bool:
    return request.output is not None and PurePath(request.output).suffix.lower() == STORE


def _store(request: SweepRequest) -> "SweepStore":
    """The store that is asked for."""
    from cranktrain.io.store_of_sweep import SweepStore  # only for who asks

    assert request.output is not None  # else nobody asks
    return SweepStore(request.output, resume=request.is_resumed, force=request.force)


def _say_what_is_stored(store: "SweepStore", found: Sweep) -> None:
    """Say that all is there; or how to go on, and that it was stopped."""
    if store.is_whole:
        print(_("written: {name}", name=store.name))
        return
    said = _("{n} of {all} designs are in {name}: the same command with --resume goes on with them")
    print(said.format(n=store.n_done, all=len(found.designs), name=store.name), file=sys.stderr)
    raise KeyboardInterrupt


def _is_count(typed: str) -> bool:
    return typed.isascii() and typed.isdecimal() and 1 <= int(typed) <= _MOST_PROCESSES


_VARY = Position("--vary")


def _computed(request: SweepRequest, file: MachineFile, store: "SweepStore | None") -> Sweep:
    """All designs."""
    processes = n_processors() if request.processes is None else int(request.processes)
    wanted = request.wanted
    if wanted is not None:
        wanted = (*wanted, *(name for name in (request.least, request.most) if name is not None))

    def placed(problem: Problem) -> Problem:
        """Put what is wrong with what is asked to its option."""
        if problem.position is not None:
            return problem
        if problem.path == "wanted":
            of = {request.least: "--least", request.most: "--most"}
            return replace(problem, path="", position=Position(of.get(str(problem.given), "--wanted")))
        if problem.path in ("processes", "scheduler"):
            return replace(problem, path="", position=Position(f"--{problem.path}"))
        own = replace(problem, path="") if problem.path in ("vary", "cases") else problem
        return replace(own, position=_VARY) if cases is None else cases.placed(own)

    cases = None if request.cases is None else cases_of(request.cases)
    with problems_as(placed), says_how_far():
        vary = _varied(request) if cases is None else cases.designs
        return swept(
            file.machine,
            vary,
            wanted,
            over_time=request.over_time,
            processes=processes,
            is_meant=request.is_meant,
            settings=[setting.partition("=")[0].strip() for setting in request.settings],
            store=store,
            scheduler=request.scheduler,
        )


def _varied(request: SweepRequest) -> Mapping[str, str]:
    """What is varied, by what was typed before each `=`."""
    given: dict[str, str] = {}
    for typed in request.vary:
        path, _equals, values = typed.partition("=")
        refuse([Problem(path, values, _("is varied twice"), position=_VARY)] if path.strip() in given else [])
        given[path.strip()] = values
    return given


def _best(request: SweepRequest, found: Sweep) -> int | None:
    """Place of the design that is best, where one is asked for."""
    if request.least is None and request.most is None:
        return None
    with problems_as(lambda problem: replace(problem, path="", position=Position(f"--{problem.path}"))):
        return found.place_of_best(least=request.least or "", most=request.most or "")


def _save(request: SweepRequest, file: MachineFile, found: Sweep, best: int) -> None:
    """Write the file of the best design: the machine's own, with its values."""
    document = file.document
    for path, value in found.values_at(best).items():
        document = document.with_value(path, value if isinstance(value, str) else json.dumps(value, ensure_ascii=False))
    assert request.save is not None  # else nobody asks
    write_machine_file(request.save, document.text, force=request.force)
    print(_("written: {name}", name=one_line(request.save)))


def _shown(found: Sweep, request: SweepRequest, best: int | None) -> Iterator[PagePart]:
    """The facts, and which design is best."""
    yield from found.sections()
    if best is not None:
        name = request.least or request.most or ""
        entry = found.catalogue[name]
        value = Amount(float(found.worst_of(name, is_least_wanted=request.least is not None)[best]), entry.shown, name)
        where = ", ".join(f"{path} = {value}" for path, value in found.values_at(best).items())
        head = (
            _("Least {fact}", fact=said_name(name))
            if request.least is not None
            else _("Most {fact}", fact=said_name(name))
        )
        yield from section(head, [_("{value} at {where}", value=value, where=where)])
