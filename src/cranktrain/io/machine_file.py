"""From a file, or the name of an example, to a machine; what is wrong stands where it was typed."""

import os
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from functools import cache
from functools import partial as with_arguments
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple, cast

from cranktrain.errors import InputError, Position, Problem, problems_as, refuse
from cranktrain.io.curve_files import CurveReader, beside, with_curves
from cranktrain.io.document import Document
from cranktrain.io.examples import EXAMPLES_FOLDER, example_called, example_document, example_near, plain_name
from cranktrain.language import said as _
from cranktrain.layout.load_tables import in_place_of_lists
from cranktrain.machine import Machine, machine_problems
from cranktrain.mechanisms import KINDS
from cranktrain.mechanisms.spec import LISTS
from cranktrain.paths import PathParts, parts_of, path_text, quantity_path, with_values
from cranktrain.quantities import Given, problem_in_units
from cranktrain.record import record
from cranktrain.spec import Spec
from cranktrain.typed_file import TypedFile

if TYPE_CHECKING:
    from cranktrain.analysis import Result


@record
class MachineFile:
    """A machine and the text that declares it.

    Attributes
    ----------
    document : Document
        With the settings in place.
    machine : Machine
    """

    document: Document
    machine: Machine

    def located(self, problem: Problem) -> Problem:
        """Place a problem that the computation found, if it is one of the file."""
        is_of_file = problem.path.partition(".")[0] in self.document.data
        return self.document.located(problem) if is_of_file else problem


class Input(NamedTuple):
    """A quantity of a machine file: its path there, and what was given."""

    path: str
    given: Given


class Origin(NamedTuple):
    """Where values are from: the text of a file; of those that were set the paths, where that was, and in words."""

    typed: Document
    paths: tuple[PathParts, ...]
    position: Position
    words: str

    def found(self, problem: Problem) -> Problem:
        """Place a problem that the computation found, if it is one of the file."""
        parts = parts_of(problem.path)
        declared = {*self.typed.data, *(path[0] for path in self.paths)}
        return self.placed(problem) if parts and parts[0] in declared else problem

    def placed(self, problem: Problem) -> Problem:
        """Place a problem at the setting that it comes from, or in the file."""
        parts = parts_of(problem.path)
        if any(parts[: len(setting)] == setting for setting in self.paths):
            return replace(problem, position=self.position)
        return self.typed.located(problem)


def read_machine(
    source: "str | os.PathLike[str]", settings: Sequence[str] = (), *, partial: bool = False
) -> MachineFile:
    """Read a machine with some values set anew.

    Parameters
    ----------
    source : str or path-like
        A machine file, or the name of an example; capitals do not matter there, nor `-` for `_`.
    settings : sequence of str
        `PATH=VALUE`, as `Document.with_value` reads them.
    partial : bool
        Accept links that cannot close over the whole turn.

    Returns
    -------
    MachineFile

    Raises
    ------
    InputError
        With everything that is wrong; a value from `settings` stands at `--set`, all else at its line of the file.
    """
    folder = folder_of(source)
    return with_set(document_of(source), settings, beside(folder), folder, partial=partial)


def with_set(
    typed: Document, settings: Sequence[str], curves: CurveReader, folder: Path, *, partial: bool
) -> MachineFile:
    """Make a machine of a document with some values set anew, and of what gives the files that it names."""
    document, paths = with_settings(typed, settings)
    origin = Origin(typed, paths, _SETTING, ", ".join(settings))
    return MachineFile(document, _checked(document.data, curves, folder, origin, partial=partial))


def load_with(
    source: "str | os.PathLike[str]", values: Mapping[str, object], *, partial: bool = False
) -> tuple[MachineFile, Origin]:
    """Read a machine with other values at some paths, as `Machine.with_` takes them.

    Parameters
    ----------
    source : str or path-like
        A machine file, or the name of an example.
    values : mapping of str
    partial : bool
        Accept links that cannot close over the whole turn.

    Returns
    -------
    file : MachineFile
        Its document is as typed, without the values.
    origin : Origin

    Raises
    ------
    InputError
        With everything that is wrong; one of the values stands at `set`, all else at its line of the file.
    """
    typed, folder = document_of(source), folder_of(source)
    with problems_as(lambda problem: replace(problem, position=SET)):
        data, paths = with_values(typed.data, values)
    origin = Origin(typed, paths, SET, ", ".join(values))
    return MachineFile(typed, _checked(data, beside(folder), folder, origin, partial=partial)), origin


def _checked(
    data: Mapping[str, object], curves: CurveReader, folder: Path, origin: Origin, *, partial: bool
) -> Machine:
    """Make a machine of its tables, with all that is wrong at its place."""
    # A curve that cannot be read is one problem among the others.
    read = with_arguments(with_curves, read=curves)
    where = TypedFile(read, folder.absolute(), origin.typed.text, origin.typed.data)
    filled, found = read(in_place_of_lists(data, origin.paths))
    try:
        machine = Machine(**cast("dict[str, Any]", filled)).coming_from(where)
        wrong = machine_problems(machine, partial=partial)
        if not found and not wrong:
            return machine
        is_half, known = bool(machine.arranged[1]), wrong
    except InputError as error:
        is_half, known = True, tuple(error.problems)
    found = (*found, *known)
    if is_half:
        from cranktrain.io.half_read import problems_of_the_rest  # most files are right

        found = (*found, *problems_of_the_rest(filled, known, partial=partial))
    from cranktrain.io.description import units_of_tables  # likewise

    units = units_of_tables(filled)
    problems = tuple(problem_in_units(origin.placed(problem), units) for problem in found)
    if origin.paths and not any(problem.position == origin.position for problem in problems):
        allowed = _("was set for this run; the file alone may be right")
        meant = next((near for path in origin.paths if (near := _deeper(origin.typed.data, path)) is not None), None)
        repair = None if meant is None else _("did you mean {path}?", path=meant)
        problems = (*problems, Problem("", origin.words, allowed, repair, origin.position))
    raise InputError(problems)


def document_of(source: "str | os.PathLike[str]") -> Document:
    """Read a file if it is there, else the example of that name."""
    name = os.fspath(source)
    if "\n" in name and "=" in name:
        allowed = _("is the text of a machine file, not its name")
        raise InputError([Problem("machine", name, allowed, _("write ct.Machine(**tomllib.loads(text))"))])
    if not name.strip():
        allowed = _("must be the name of a machine file, or of an example; `cranktrain list` names all")
        raise InputError([Problem("FILE", '""', allowed)])
    example = _example_meant(name)
    if example is not None:
        return example_document(example)
    try:
        return Document.read(source)
    except InputError as error:
        kind = plain_name(name)
        close = example_near(name)
        if kind in KINDS.names:
            repair = _("a file of that kind is written by: {command}", command=f"cranktrain new {kind} -o mine.toml")
        elif close is None:
            raise
        else:
            repair = _("is it the example {name}? `cranktrain list` names all", name=close)
        raise InputError(replace(problem, repair=problem.repair or repair) for problem in error.problems) from None


def computed(file: MachineFile, **options: Any) -> "Result":
    """Compute what a machine file allows.

    Parameters
    ----------
    file : MachineFile
    **options
        As `cranktrain.analysis.run` takes them.

    Returns
    -------
    Result

    Raises
    ------
    InputError
        With what only the computation shows to be wrong, such as a gas that does not suit its chamber, at its line.
    """
    from cranktrain.analysis import run

    with problems_as(file.located):
        return run(file.machine, **options)


def inputs_of(file: MachineFile) -> tuple[Input, ...]:
    """Give every quantity that the file declares, in its order; a default that it leaves unsaid is none.

    Parameters
    ----------
    file : MachineFile

    Returns
    -------
    tuple of Input
    """
    return tuple(Input(path_text(parts), given) for parts, given in _inputs(file.document.data, file.machine))


def inputs_of_machine(machine: Machine) -> tuple[Input, ...]:
    """Give every quantity that a machine declares; as `inputs_of`, where there is no text of a file."""
    return tuple(Input(path_text(parts), given) for parts, given in _inputs(machine.declared, machine))


def _example_meant(name: str) -> str | None:
    """Find the example that a name means, unless there is a file of that name."""
    is_file = os.path.isfile(name)  # noqa: PTH113 - unlike Path, takes a name with a NUL byte
    return None if is_file else example_called(name)


def folder_of(source: "str | os.PathLike[str]") -> Path:
    """Folder to which a machine's other files are relative."""
    name = os.fspath(source)
    return Path(name).parent if _example_meant(name) is None else EXAMPLES_FOLDER


_SETTING, SET = Position("--set"), Position("set")
"""Where a setting stands that is wrong: in the terminal, and in Python."""

MOST_SETTINGS = 100
"""Of one run: the file is read anew for each."""


def with_settings(document: Document, settings: Sequence[str]) -> tuple[Document, tuple[PathParts, ...]]:
    """Set values one after the other, and give their paths; every setting that cannot be made is told."""
    paths: list[PathParts] = []
    problems: list[Problem] = []
    if len(settings) > MOST_SETTINGS:
        allowed = _("is given {n} times, and may be {limit} times; write a file")
        allowed = allowed.format(n=len(settings), limit=MOST_SETTINGS)
        raise InputError([Problem("", None, allowed, position=_SETTING)])
    for setting in settings:
        path, equals, value = setting.partition("=")
        if not equals:
            allowed = _("must be PATH=VALUE, such as shaft.main.speed=1500rpm")
            problems.append(Problem("", setting, allowed, position=_SETTING))
            continue
        try:
            document = document.with_value(path, value)
            parts = quantity_path(path)
            if parts in paths:
                problems.append(Problem(path, value, _("is set twice; keep one of the two"), position=_SETTING))
            paths.append(parts)
        except InputError as error:
            problems += [
                # One that stands in the file itself keeps its line.
                problem if problem.position and problem.position.line else replace(problem, position=_SETTING)
                for problem in error.problems
            ]
    refuse(problems)
    return document, tuple(paths)


def _deeper(table: Mapping[str, Any], path: PathParts, above: PathParts = ()) -> str | None:
    """Find a path that ends as one does whose first table is not there: bank.L.mechanism.rod_length by its end."""
    if path[0] in table:
        return path_text((*above, *path)) if above else None
    for name, value in table.items():
        if isinstance(value, Mapping):
            deeper = _deeper(cast("Mapping[str, Any]", value), path, (*above, name))
            if deeper is not None:
                return deeper
    return None


def _inputs(data: object, declared: object, above: PathParts = ()) -> Iterator[tuple[PathParts, Given]]:
    """Walk the file's data and what the specs made of it side by side, from a path on."""
    several = _items(declared)
    if isinstance(declared, Given):
        yield above, declared
    elif several and isinstance(several[0], Given) and not isinstance(data, list | tuple):
        yield above, several[0]  # one value where a list may stand
    elif isinstance(data, Mapping):
        for key, inner in cast("Mapping[str, object]", data).items():
            yield from _inputs(inner, _declared_at(declared, key, inner), (*above, key))
    elif isinstance(data, list | tuple) and several:
        for place, (inner, made) in enumerate(zip(cast("Sequence[object]", data), several, strict=True)):
            yield from _inputs(inner, made, (*above, place))


def _declared_at(declared: object, key: str, data: object) -> object:
    """What the specs made of a key: of a bank's mechanism, whose fields may be lists, one spec for each angle."""
    each = _items(declared)
    if each:
        many = isinstance(data, list | tuple) and key not in LISTS
        return tuple(getattr(one, key) for one in each) if many else getattr(each[0], key)
    if isinstance(declared, Mapping):
        return cast("Mapping[str, object]", declared)[key]
    own = getattr(declared, "overrides", {})
    return own[key] if key in own else getattr(declared, _field_of(declared, key))


def _field_of(declared: object, key: str) -> str:
    """Field that a key of the file fills: of another name where the key is a word of Python's, such as `from`."""
    return _named_otherwise(type(declared)).get(key, key)


@cache
def _named_otherwise(kind: type) -> Mapping[str, str]:
    """Fields of a spec that have another name in the file, by this; none of what is no spec."""
    fields = kind.model_fields if issubclass(kind, Spec) else {}
    return {field.alias: name for name, field in fields.items() if field.alias is not None}


def _items(declared: object) -> tuple[object, ...]:
    """What a list of the file became; nothing for what is no list."""
    return cast("tuple[object, ...]", declared) if isinstance(declared, tuple) else ()
