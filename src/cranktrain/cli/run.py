"""`run`: compute what a machine file allows, write it where asked, and show it."""

from collections.abc import Iterator
from pathlib import PurePath

from rich.text import Text

from cranktrain.analysis import Result
from cranktrain.cli.asked import Asked, at_running_speed
from cranktrain.cli.screen.text import page, show_lines
from cranktrain.errors import InputError, Problem, problems_as, refuse
from cranktrain.io.machine_file import MachineFile
from cranktrain.io.output import write_whole
from cranktrain.language import _
from cranktrain.one_line import one_line
from cranktrain.record import record


@record
class RunRequest(Asked):
    """What is asked of `run`, as typed; `quantities` is None for all."""

    quantities: tuple[str, ...] | None = None
    step_degrees: float = 1.0


@record
class Shown:
    """What is shown instead of the answer."""

    full: bool = False
    checks: bool = False
    inputs: bool = False
    missing: bool = False

    def __bool__(self) -> bool:
        """Whether any of them is."""
        return self.full or self.checks or self.inputs or self.missing


def show_run(request: RunRequest, shown: Shown | None = None) -> None:
    """Compute, write and show."""
    suffix = None if request.output is None else _suffix(request.output)
    if request.quantities == ():
        allowed = _("must be names of results, with commas between; `cranktrain list results` names them")
        raise InputError([Problem("--quantities", '""', allowed)])
    file = request.read()
    if request.output is None or suffix is None:
        result = _computed(file, request)
    else:
        result = _written(file, request, request.output, suffix)
    if shown:
        _show_parts(file, result, request, shown)
    elif request.output is not None:
        _show_minded(result)
    elif request.quantities is not None:
        _show_numbers(result, request)
    else:
        _show_answer(file, result, request)
    if request.output is not None:
        print(_("written: {name}").format(name=one_line(request.output)))


def _show_parts(file: MachineFile, result: Result, request: RunRequest, shown: Shown) -> None:
    """Show what was asked for by options."""
    from cranktrain.cli.screen.report import show_checks, show_full, show_inputs, show_missing
    from cranktrain.cli.screen.title import title

    with page(title(file.machine)) as console:
        if shown.full:
            show_full(console, file, result, _chosen(result, request), is_all=request.quantities is None)
        if shown.checks and not shown.full:
            show_checks(console, result)
        if shown.inputs:
            show_inputs(console, file)
        if shown.missing and not shown.full:
            show_missing(console, result)


def _show_numbers(result: Result, request: RunRequest) -> None:
    """Show the quantities that were asked for, and what is to be minded before them."""
    from cranktrain.cli.screen.report import show_numbers

    _show_minded(result)
    with page() as console:
        show_numbers(console, result, _chosen(result, request), is_all=False)


def _show_minded(result: Result) -> None:
    """Show what is to be minded."""
    from cranktrain.cli.screen.minded import minded_lines

    with page() as console:
        show_lines(console, (Text(line) for line in minded_lines(result, console.width)))


def _show_answer(file: MachineFile, result: Result, request: RunRequest) -> None:
    """Show the answer on one screen."""
    from cranktrain.cli.screen.answer import answer_lines

    with page() as console:
        show_lines(console, answer_lines(file, result, request.file, console.width))


def _suffix(output: str) -> str:
    """Suffix of the output's name, by which its form is known."""
    from cranktrain.io.tables import WRITERS

    suffix = PurePath(output).suffix.lower()
    if suffix not in WRITERS:
        allowed = _("must end in one of: {suffixes}").format(suffixes=", ".join(WRITERS))
        raise InputError([Problem("-o", output, allowed)])
    return suffix


def _computed(file: MachineFile, request: RunRequest) -> Result:
    """Compute; refuse a quantity that was asked for and that this machine does not give."""
    with problems_as(at_running_speed):
        result = request.result(file, step_degrees=request.step_degrees, quantities=request.quantities)
    names = request.quantities or ()
    refuse(_absence(name, result, request.file) for name in names if name not in result.catalogue)
    return result


def _absence(name: str, result: Result, file: str) -> Problem:
    """Say what a quantity needs that the file does not give."""
    allowed = _("is no result of this machine; `cranktrain check {file}` names what is").format(file=file)
    if needs := result.needs_of(name):
        allowed = _("needs {needs} in the file").format(needs=", ".join(needs))
    return Problem("quantities", name, allowed)


def _written(file: MachineFile, request: RunRequest, output: str, suffix: str) -> Result:
    """Compute once the output is known to be possible, and write it; a table without what is given by each method."""
    from cranktrain.io.tables import WRITERS

    made: list[Result] = []

    def text() -> Iterator[str]:
        result = _computed(file, request)
        names = _chosen(result, request)
        if suffix == ".csv" and request.quantities is None:
            names = tuple(name for name in names if len(result.labels_of(result.catalogue[name])) <= 1)
        facts = [name for name in request.quantities or () if result.catalogue[name].is_fact]
        if suffix == ".csv" and facts:
            allowed = _("has one value for the whole cycle, and a .csv holds curves")
            raise InputError(Problem("quantities", name, allowed, _("write a .json")) for name in facts)
        made.append(result)
        yield from WRITERS[suffix](result, file.document.data, names)

    write_whole(output, text(), force=request.force)
    return made[0]


def _chosen(result: Result, request: RunRequest) -> tuple[str, ...]:
    """Names of the quantities to show and write, in the order of the catalogue."""
    return tuple(name for name in result.catalogue if request.quantities is None or name in request.quantities)
