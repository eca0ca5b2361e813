"""Units in which numbers are to be seen: a reader's choice, else the file's own; what has neither has its usual one."""

from collections import Counter
from collections.abc import Callable, Generator, Iterable, Mapping, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass, replace
from functools import cache, lru_cache
from typing import NamedTuple

from cranktrain.errors import Problem, refuse
from cranktrain.grouping import grouped
from cranktrain.language import Said, Words, _
from cranktrain.quantities.dimensions import Dimension, plain, spellings, unit_names
from cranktrain.quantities.number import measured
from cranktrain.quantities.refusal import Instead, nearest

UnitChoice = Mapping[Dimension, str]
"""Names of units by what they measure."""

SHOWN = tuple(dimension for dimension in Dimension if dimension is not Dimension.FLYWHEEL_MOMENT)
"""What may be shown in a chosen unit: GD² may not, as its kg·m² are told by nothing from those of an inertia."""

_OF_OTHER_SYSTEMS = frozenset(
    {
        *("in", "ft", "in²", "in³", "ft/s", "ft/s²", "lb", "lbf", "lbf·ft", "lbf·in", "ft·lbf", "psi", "psig", "hp"),
        *("kgf", "tf", "kgf·m", "at", "ati", "atm", "PS"),
    }
)
_BY_SIZE = {Dimension.FORCE, Dimension.TORQUE, Dimension.POWER, Dimension.ENERGY, Dimension.VOLUME}
"""What is shown in N or kN, in W or kW, by its size: of a file's own units those of other systems alone count."""
_NOT_BY_FILE = {Dimension.RATIO, Dimension.ANGLE, Dimension.TIME}
"""What no habit of a file changes: angles stay in degrees beside throws in turns, times in s beside delays in ms."""
_USUAL = {"mm", "cm²", "rpm", "m/s", "m/s²", "rad/s²", "bar", "kg", "kg·m²", "N·m/rad", "K"}
"""Units that are shown anyhow."""
_MOST_TEXTS, _MOST_FILES = 4096, 64
"""Of numbers that are shown again and again; and of files, which stand in the same units while a number changes."""
_COUNTED_FROM = {"ati": "at", "psig": "psi", "barg": "bar"}
"""Gauge units, and those of pressures that count from nothing."""


class FileUnits(NamedTuple):
    """Units in which a machine is shown unless its reader chooses others.

    Attributes
    ----------
    said : UnitChoice
        What its table [units] asks for, also of what is written to files.
    written : UnitChoice
        In which most of its numbers stand, for the screen and pictures.
    """

    said: UnitChoice = {}  # noqa: RUF012 - nobody changes a choice
    written: UnitChoice = {}  # noqa: RUF012 - nobody changes a choice


_chosen: ContextVar[UnitChoice] = ContextVar("chosen units", default={})  # noqa: B039 - nobody changes a choice
_of_file: ContextVar[FileUnits] = ContextVar("units of the file", default=FileUnits())  # noqa: B039 - frozen


@contextmanager
def shown_by(choice: UnitChoice) -> Generator[None]:
    """Show numbers in chosen units for a while, besides those that are chosen already."""
    token = _chosen.set({**_chosen.get(), **choice})
    try:
        yield
    finally:
        _chosen.reset(token)


@contextmanager
def shown_as_in(file: FileUnits) -> Generator[None]:
    """Show numbers for a while in the units of a machine's file, as far as its reader chose no others."""
    token = _of_file.set(file)
    try:
        yield
    finally:
        _of_file.reset(token)


@dataclass(frozen=True, slots=True, repr=False)
class _InUnits(Said):
    """Words in the units of a machine's file, unless they are said where another one's are known."""

    words: Words
    file: FileUnits

    def __hash__(self) -> int:
        """Tell them apart by the words."""
        return hash(self.words)

    def said(self, say: Callable[[object], object]) -> str:
        """Say them."""
        if any(_of_file.get()):
            return str(say(self.words))
        with shown_as_in(self.file):
            return str(say(self.words))

    def each(self) -> Iterable[object]:
        """Give them."""
        return (self.words,)


def problem_in_units(problem: Problem, file: FileUnits) -> Problem:
    """Give what is wrong with a machine's file to be said in its units, where nobody who says it knows of any.

    Examples
    --------
    >>> from cranktrain.saying.wording import number
    >>> short = Problem("rod_length", "3 in", number(0.0254, "mm"))
    >>> str(problem_in_units(short, FileUnits(written=own_units(["4 in"]))))
    'rod_length = 3 in: 1.000 in'
    """
    if not any(file):
        return problem
    repair = problem.repair
    if repair is not None and not isinstance(repair, Instead):
        repair = _InUnits(repair, file)
    return replace(problem, allowed=_InUnits(problem.allowed, file), repair=repair)


def chosen_unit(usual: str) -> str | None:
    """Unit chosen for what is usually shown in one, in any of its spellings; None where none was.

    Examples
    --------
    >>> with shown_by(units_by_dimension(["psi", "in"])):
    ...     chosen_unit("bar"), chosen_unit("mm"), chosen_unit("kW")
    ('psi', 'in', None)
    """
    return _unit_in({**_of_file.get().written, **_of_file.get().said, **_chosen.get()}, usual)


def asked_unit(usual: str) -> str | None:
    """Unit that a reader or a table [units] asks for, as `chosen_unit`: data do not follow a file's habit.

    Examples
    --------
    >>> with shown_as_in(FileUnits(written=own_units(["4 in"]))):
    ...     chosen_unit("mm"), asked_unit("m")
    ('in', None)
    """
    return _unit_in(units_asked(), usual)


def units_asked() -> UnitChoice:
    """Units that were asked for, by what they measure."""
    return {**_of_file.get().said, **_chosen.get()}


def _unit_in(choice: UnitChoice, usual: str) -> str | None:
    if not choice:
        return None
    key = plain(usual)
    return next((unit for dimension, unit in choice.items() if key in spellings(dimension)), None)


def units_by_dimension(names: Sequence[str], path: str = "--units") -> UnitChoice:
    """Give the units of some names, as typed after --units, by what they measure; one of two things stands for both.

    What is wrong stands at a path.

    Raises
    ------
    InputError
        For names of no unit, and two units of one quantity.
    """
    found: dict[Dimension, str] = {}
    problems: list[Problem] = []
    for name in names:
        own = _measured_in(name)
        twice = next((found[dimension] for dimension in own if dimension in found), None)
        if not own:
            close = nearest(name, [unit for dimension in SHOWN for unit in unit_names(dimension)])
            repair = _("did you mean {name}?", name=close) if close else None
            problems.append(Problem(path, name, _("must be units with commas between, such as bar,kW,in"), repair))
        elif counted_from(name) is not None:
            problems.append(gauge_problem(path, name))
        elif twice is not None:
            allowed = _("must not stand beside {other}, of the same", other=twice)
            problems.append(Problem(path, name, allowed))
        found |= own
    refuse(problems)
    return found


def counted_from(unit: str) -> str | None:
    """Unit that counts from nothing where one counts from the atmosphere; None for all others.

    Examples
    --------
    >>> counted_from("psig"), counted_from("psi")
    ('psi', None)
    """
    name = next(iter(_measured_in(unit).values()), "")
    return _COUNTED_FROM.get(name)


def gauge_problem(path: str, unit: str) -> Problem:
    """Refuse to show all pressures in a gauge unit: mean pressures, and rises, count from nothing."""
    allowed = _("counts from the atmosphere, which mean pressures do not")
    return Problem(path, unit, allowed, _("write {unit}", unit=counted_from(unit)))


def own_units(texts: Iterable[str]) -> UnitChoice:
    """Units in which most that is written of a quantity stands: a file in inches is shown in inches, one in kPa in kPa.

    The usual unit wins a tie. Of what is shown by its size, in N or kN, only units of other systems are a file's own.

    Examples
    --------
    >>> list(own_units(["4 in", "7 1/2 in", "20 mm", "60 psig", "2 bar", "0.9 bar", "25 kN"]).values())
    ['in']
    """
    return _own_of(tuple(unit for text in texts if (unit := _unit_written(text))))


@lru_cache(_MOST_FILES)
def _own_of(units: tuple[str, ...]) -> UnitChoice:
    """The same of the units of all that is written."""
    written = grouped(one for unit in units for one in _measured_in(unit).items())
    found = {dimension: _most_frequent(names) for dimension, names in written.items() if dimension not in _NOT_BY_FILE}
    return {
        dimension: unit
        for dimension, unit in found.items()
        if unit not in _USUAL and (dimension not in _BY_SIZE or unit in _OF_OTHER_SYSTEMS)
    }


@lru_cache(_MOST_TEXTS)
def _unit_written(text: str) -> str:
    """The unit in which a number is written; none of what has none, or is no number."""
    try:
        parts = measured(text)
    except (ZeroDivisionError, OverflowError):
        return ""
    return "" if parts is None else parts.unit


def _most_frequent(names: Iterable[str]) -> str:
    """The most frequent of some units, whatever their order; of gauge pressures as of those that count from nothing."""
    counts = Counter(_COUNTED_FROM.get(name, name) for name in names)
    return max(counts, key=lambda unit: (counts[unit], unit in _USUAL, unit))


@cache
def _measured_in(unit: str) -> UnitChoice:
    """What a unit measures, with its name in the list for each."""
    key = plain(unit)
    return {dimension: spellings(dimension)[key][0].name for dimension in SHOWN if key in spellings(dimension)}
