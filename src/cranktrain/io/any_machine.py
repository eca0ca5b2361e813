"""A machine from whatever one has of it: a file, the name of an example, its tables, or itself."""

import os
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any, TypeAlias, cast

from cranktrain.analysis import Result
from cranktrain.errors import InputError, Problem, problems_as, refuse
from cranktrain.io.curve_files import beside, with_curves
from cranktrain.io.machine_file import SET, load_with
from cranktrain.language import Words
from cranktrain.language import said as _
from cranktrain.layout.load_tables import in_place_of_lists
from cranktrain.machine import Machine
from cranktrain.paths import parts_of, values_by_path, with_values
from cranktrain.record import record
from cranktrain.typed_file import TypedFile

MachineLike: TypeAlias = "Machine | str | os.PathLike[str] | Mapping[str, object]"
"""A machine; a machine file or the name of an example; or the tables of a file."""


@record
class GivenMachine:
    """A machine, and where what is wrong with it would be said."""

    machine: Machine
    placed: Callable[[Problem], Problem]


def load(
    source: "MachineLike",
    *,
    set: "Mapping[str, object] | None" = None,  # noqa: A002 - as the terminal's --set
    partial: bool = False,
) -> Machine:
    """Load a machine.

    Parameters
    ----------
    source : str or path-like
        A machine file, or the name of an example; capitals do not matter there, nor `-` for `_`. The tables of a file
        as a dict are taken too.
    set : mapping of str, optional
        Other values by path, as `Machine.with_` takes them.
    partial : bool
        Accept links that cannot close over the whole turn.

    Returns
    -------
    Machine

    Raises
    ------
    InputError
        With everything that is wrong, each with file, line and column.

    Examples
    --------
    >>> load("3d12").name
    '3D12 marine diesel, 60° V12 with articulated rods'
    >>> load("3d12", set={"shaft.main.speed": "1800 rpm"}).main_shaft.speed.text
    '1800 rpm'
    """
    return source_of(source, set, partial=partial).machine


def source_of(
    machine: MachineLike, values: Mapping[str, object] | None = None, *, partial: bool = False
) -> GivenMachine:
    """Read a machine.

    Parameters
    ----------
    machine : Machine, str, path-like or mapping
        A machine; a machine file or the name of an example; or the tables of a file, whose own files are relative to
        the working folder.
    values : mapping of str, optional
        Other values by path, as `Machine.with_` takes them.
    partial : bool
        Accept links that cannot close over the whole turn.

    Returns
    -------
    GivenMachine

    Raises
    ------
    InputError
        With everything that is wrong.
    """
    changed = values_of(values)
    if isinstance(machine, Machine):
        return GivenMachine(_with_files(machine, changed), _as_it_is)
    if isinstance(machine, str | os.PathLike):
        file, origin = load_with(machine, changed, partial=partial)
        return GivenMachine(file.machine, origin.found)
    if isinstance(cast("object", machine), Mapping):
        return GivenMachine(_of_tables(machine, changed), _as_it_is)
    kind = type(cast("object", machine)).__name__
    allowed = _("must be a machine, a machine file, the name of an example, or the tables of a file as a dict")
    raise InputError([Problem("machine", kind, allowed)])


def values_of(values: Mapping[str, object] | None) -> Mapping[str, object]:
    """Take what is to be set; refuse what is no mapping."""
    return {} if values is None else values_by_path("set", values, "set={}")


def sources_of(
    machines: "MachineLike | Iterable[MachineLike]",
    values: Mapping[str, object] | None = None,
    *,
    partial: bool = False,
) -> tuple[Sequence[GivenMachine], bool]:
    """Read a machine, or several, and say whether they are several."""
    if isinstance(machines, Machine | str | os.PathLike | Mapping) or not isinstance(
        cast("object", machines), Iterable
    ):
        return (source_of(cast("MachineLike", machines), values, partial=partial),), False
    return tuple(source_of(one, values, partial=partial) for one in machines), True


def _as_it_is(problem: Problem) -> Problem:
    """Leave a problem of a machine that stands in no file."""
    return problem


def _with_files(machine: Machine, values: Mapping[str, object]) -> Machine:
    """Give a machine with other values; files that nobody has read yet are relative to the working folder."""
    with problems_as(_of_set(values)):
        changed = machine.with_(values) if values else machine
    if changed.typed_in.reads:
        return changed
    filled, found = with_curves(changed.declared, beside(Path()))
    refuse(found)
    return changed if filled == changed.declared else Machine(**filled).coming_from(_HERE)


def _of_tables(tables: Mapping[str, object], values: Mapping[str, object]) -> Machine:
    """Make a machine of its tables."""
    wrong = [key for key in tables if not isinstance(cast("object", key), str)]
    if wrong:
        raise InputError([Problem("machine", str(wrong[0]), _("is no name of a table"))])
    with problems_as(_of_set(values)):
        data, paths = with_values(dict(tables), values)
        filled, found = _here(in_place_of_lists(data, paths))
        refuse(found)
        return Machine(**filled).coming_from(_HERE)


def _here(data: Mapping[str, object]) -> tuple[dict[str, Any], tuple[Problem, ...]]:
    """Read the files that tables name, relative to the working folder."""
    return with_curves(data, beside(Path()))


_HERE = TypedFile(_here)


def _of_set(values: Mapping[str, object]) -> Any:
    """What places those problems at `set` that come from there."""
    paths = [parts_of(path) for path in values]

    def placed(problem: Problem) -> Problem:
        parts = parts_of(problem.path)
        is_set = problem.position is None and any(parts[: len(path)] == path for path in paths if path)
        return replace(problem, position=SET) if is_set else problem

    return placed


def name_of(given: "MachineLike | Result") -> str:
    """Name a machine as it was named, or by its own name."""
    if isinstance(given, Result):
        return given.machines[0].name
    if isinstance(given, Mapping):
        return str(given.get("name", "")) or _("a dict")
    return getattr(given, "name", "") or str(given)


def names_in(given: object, path: str = "quantities") -> tuple[str, ...] | None:
    """Names of results that are asked for at a parameter; None for all."""
    if given is None:
        return None
    is_one = isinstance(given, str) or not hasattr(given, "__iter__")
    each = (given,) if is_one else tuple(cast("Iterable[object]", given))
    allowed = _("must be names of results; result.catalogue has them")
    refuse([] if each else [Problem(path, "[]", allowed)])
    return texts_in(path, each, allowed)


def texts_in(path: str, given: Sequence[object], allowed: Words) -> tuple[str, ...]:
    """Refuse what is no text."""
    refuse(Problem(path, repr(one), allowed) for one in given if not isinstance(one, str))
    return tuple(one for one in given if isinstance(one, str))
