"""What a sweep varies: values at paths of the machine file, and which of them are numbers."""

from collections.abc import Iterable, Iterator, Mapping, Sequence, Sized
from contextlib import suppress
from dataclasses import replace
from fractions import Fraction
from functools import cached_property
from itertools import product
from math import prod
from typing import Any, TypeGuard, cast

import numpy as np
from numpy.typing import NDArray

from cranktrain.errors import InputError, Problem, refuse
from cranktrain.grouping import grouped
from cranktrain.language import _
from cranktrain.machine import Machine
from cranktrain.motion import Array
from cranktrain.one_line import one_line, short
from cranktrain.paths import PathParts, parts_of, path_text, quantity_path, value_at
from cranktrain.quantities import Quantity, nearest
from cranktrain.quantities.conversion import in_other_unit
from cranktrain.record import record
from cranktrain.study.sweep.numbers import ReadValues, read_values, unit_written
from cranktrain.study.sweep.typed import n_values_typed, quantity_typed, values_typed

_EVEN, _ROUNDING = 3, 1e-12
"""Values from which on steps can be even, and how far they are then; a value below such a part of a step is 0."""
_NAMED = 6
"""Paths that a sentence names."""


@record
class Varied:
    """Values of one place of the file.

    Attributes
    ----------
    path : str
    name : str
        Of the dimension along which they stand.
    values : tuple of object
        As `Machine.with_` takes them.
    numbers : Array or None, shape (value,)
        Their numbers, in `unit`; None of words, lists and tables.
    unit : str
        As it was typed; empty of what has none.
    """

    path: str
    name: str
    values: tuple[object, ...]
    numbers: Array | None
    unit: str

    @property
    def spoken(self) -> str:
        """Its name, of which its words are made: the item of a list with its place as the path has it, `throws[1]`."""
        place = next(iter(parts_of(self.path)[-1:]), "")
        # The name of an item ends in its place, behind an underline.
        return f"{self.name[: -1 - len(str(place))]}[{place}]" if isinstance(place, int) else self.name

    @cached_property
    def are_numbers(self) -> NDArray[np.bool_]:
        """Whether each of them may be read as a quantity."""
        return np.array([unit is not None for unit in self._units], dtype=bool)

    @cached_property
    def kinds(self) -> NDArray[np.intp]:
        """Which of them differ in their number alone: those of one unit share a number from 0; a word has its own."""
        own: Iterable[object] = (place if unit is None else unit for place, unit in enumerate(self._units))
        kinds: dict[object, int] = {}
        return np.array([kinds.setdefault(kind, len(kinds)) for kind in own], dtype=np.intp)

    @cached_property
    def _units(self) -> tuple[str | None, ...]:
        return tuple(map(unit_written, self.values))

    def read_as(self, quantity: Quantity) -> ReadValues:
        """Read them as a field does, each once however often they are asked for."""
        if quantity not in self._read:
            self._read[quantity] = read_values(quantity, self.values)
        return self._read[quantity]

    @cached_property
    def _read(self) -> dict[Quantity, ReadValues]:
        return {}

    @property
    def texts(self) -> tuple[str, ...]:
        """Its values as they are shown."""
        if self.numbers is not None:
            short_texts = tuple(f"{number:.6g} {self.unit}".strip() for number in self.numbers.tolist())
            if len({*short_texts}) == len(short_texts):
                return short_texts
        return tuple(one_line(_shown(value)) for value in self.values)


@record
class SweptDesigns:
    """Which designs there are.

    Attributes
    ----------
    varied : tuple of Varied
        What differs among them.
    is_listed : bool
        Whether each of `varied` has a value for each design; else there is one for each combination, of which the last
        one's values change first.
    """

    varied: tuple[Varied, ...]
    is_listed: bool = False

    @property
    def dimensions(self) -> tuple[Varied, ...]:
        """Along what facts of them stand."""
        if not self.is_listed:
            return self.varied
        each = zip(*(one.values for one in self.varied), strict=True)
        named = [
            ", ".join(f"{one.spoken} {_shown(value)}" for one, value in zip(self.varied, values, strict=True) if value)
            for values in each
        ]
        return (Varied("", "case", tuple(f"{n}: {words}" for n, words in enumerate(named, start=1)), None, ""),)

    @property
    def shape(self) -> tuple[int, ...]:
        """How many values there are along each of what is varied; of a list how many designs."""
        return (len(self),) if self.is_listed else tuple(len(one.values) for one in self.varied)

    @property
    def rows(self) -> Iterator[dict[str, object]]:
        """Values of each design, by path."""
        each = (one.values for one in self.varied)
        combinations = zip(*each, strict=True) if self.is_listed else product(*each)
        for values in combinations:
            named = zip(self.varied, values, strict=True)
            yield {one.path: value for one, value in named if value is not None}

    def row(self, place: int) -> dict[str, object]:
        """Values of one design, by path."""
        found = ((one.path, one.values[index[0]]) for one, index in self.block(place, place + 1))
        return {path: value for path, value in found if value is not None}

    def block(self, first: int, last: int) -> list[tuple[Varied, NDArray[np.intp]]]:
        """Give what varies among some designs, and which of its values each has, shape (design,)."""
        places = np.arange(first, last)
        if self.is_listed:
            return [_different(replace(one, values=one.values[first:last], numbers=None)) for one in self.varied]
        return list(zip(self.varied, np.unravel_index(places, self.shape), strict=True))

    def __len__(self) -> int:
        return len(self.varied[0].values) if self.is_listed else prod(len(one.values) for one in self.varied)


def _different(listed: Varied) -> tuple[Varied, NDArray[np.intp]]:
    """Take what differs among values of a list, and which of it each is; plain numbers are taken as they stand."""
    if all(type(value) is float for value in listed.values):
        return listed, np.arange(len(listed.values))
    # 1, 1.0 and true are equal.
    places: dict[tuple[type, object], int] = {}
    keys = ((type(value), value if isinstance(value, str | int | float) else repr(value)) for value in listed.values)
    index = np.array([places.setdefault(key, len(places)) for key in keys], dtype=np.intp)
    _places, first = np.unique(index, return_index=True)
    return replace(listed, values=tuple(listed.values[place] for place in first.tolist())), index


def _shown(value: object) -> str:
    """A value in words: of a list its items; of a design that does not name it nothing."""
    if isinstance(value, list | tuple):
        return ", ".join(map(str, cast("Sequence[object]", value)))
    return "" if value is None else str(value)


def listed_designs(machine: Machine, cases: Sequence[Mapping[str, object]]) -> SweptDesigns:
    """Take designs one by one: values by path, as of `varied_by`; what one does not name stays as the file has it."""
    refuse(_no_cases(cases))
    given = list(dict.fromkeys(name for case in cases for name in case))
    problems: list[Problem] = []
    paths: list[str] = []
    for name in given:
        try:
            paths.append(path_meant(machine, name))
        except InputError as error:
            problems += error.problems
    refuse(problems or [Problem(path, None, _("is varied twice")) for path in _repeated(paths)])
    columns = [tuple(_as_given(case.get(name)) for case in cases) for name in given]
    each = zip(paths, names_of(paths), columns, strict=True)
    return SweptDesigns(tuple(varied(path, name, values) for path, name, values in each), is_listed=True)


def _no_cases(cases: object) -> Iterator[Problem]:
    """Find what is no sequence of designs, each a mapping."""
    if isinstance(cases, str) or not isinstance(cases, Sequence):
        allowed = _("must be values by path, or a sequence of such")
        yield Problem("vary", short(str(cases)), allowed, _('write like {"rod_length": "130..160 mm:31"}'))
        return
    each = cast("Sequence[object]", cases)
    if not any(each):
        yield Problem("cases", None, _("has no design"))
    wrong = next(((place, case) for place, case in enumerate(each) if not isinstance(case, Mapping)), None)
    if wrong is not None:
        repair = _('write like {"rod_length": "130 mm"}')
        yield Problem(f"vary[{wrong[0]}]", short(str(wrong[1])), _("must be values by path"), repair)


def _repeated(paths: Sequence[str]) -> list[str]:
    """Paths that stand more than once."""
    return [path for path in dict.fromkeys(paths) if paths.count(path) > 1]


def combined_designs(machine: Machine, vary: Mapping[str, object]) -> SweptDesigns:
    """Take what is to be varied.

    Parameters
    ----------
    machine : Machine
    vary : mapping of str
        By path, or by the last name of a path where one value of the file alone is called so: text as `values_typed`
        reads it, or values one by one.

    Returns
    -------
    SweptDesigns

    Raises
    ------
    InputError
        With everything that is wrong.
    """
    found: list[Varied] = []
    problems: list[Problem] = []
    for given, values in vary.items():
        try:
            path = path_meant(machine, given)
            own = values_typed(path, values) if isinstance(values, str) else _each(path, values)
        except InputError as error:
            problems += error.problems
            continue
        if isinstance(value_at(machine.declared, path), list | tuple) and not all(
            isinstance(value, list | tuple) for value in own
        ):
            allowed = _("is a list in the file, and so each of its values is one")
            repair = _('write like [["0 deg", "90 deg"], ["0 deg", "180 deg"]]')
            problems.append(Problem(path, None, allowed, repair))
            continue
        one = varied(path, "", own)
        problems += [Problem(path, short(repr(value)), _("stands twice among its values")) for value in _twice(one)]
        problems += [Problem(path, None, _("is varied twice"))] if path in [other.path for other in found] else []
        found.append(one)
    refuse(problems or ([] if found else [Problem("vary", None, _("is missing: name what is to be varied"))]))
    names = names_of([one.path for one in found])
    return SweptDesigns(tuple(replace(one, name=name) for one, name in zip(found, names, strict=True)))


def n_values(values: object) -> int:
    """How many values are to be varied, which are not made for it; of what does not say how many there are, 1."""
    if isinstance(values, str):
        return n_values_typed(values)
    return len(values) if _are_several(values) and isinstance(values, Sized) else 1


def varied(path: str, name: str, values: tuple[object, ...]) -> Varied:
    """Say what values are: numbers in the unit of the first, as far as the others can be said in it, or words."""
    each = [_measured(value) for value in values]
    # One that a design does not name is none of them.
    unit = next((unit for _number, unit in filter(None, each)), "")
    numbers = [None if one is None else _in_unit(*one, unit) for one in each]
    known = [number for number in numbers if number is not None]
    if len(known) < len(values):
        return Varied(path, name, values, None, "")
    return Varied(path, name, values, np.array(known), unit)


def _in_unit(number: Fraction | float, unit: str, other: str) -> float | None:
    """A number in another unit than its own; None where it cannot be said in it."""
    if unit == other:
        return float(number)
    found = in_other_unit(Fraction(number), unit, other) if unit and other else None
    return None if found is None else float(found)


def names_of(paths: Sequence[str]) -> list[str]:
    """Short names of paths: their last words, of items of lists with their places, as far as these differ."""
    last = [whole_word(path_text(_from_last_name(quantity_path(path)))) for path in paths]
    return [
        name if last.count(name) == 1 else whole_word(path_text(quantity_path(path)))
        for path, name in zip(paths, last, strict=True)
    ]


def _from_last_name(parts: PathParts) -> PathParts:
    """The end of a path, from its last name on."""
    return parts[max(place for place, part in enumerate(parts) if isinstance(part, str)) :]


def names_apart(designs: SweptDesigns, facts: Sequence[str]) -> SweptDesigns:
    """Call what is varied by its whole path where a fact has its name, as the stroke."""
    each = (replace(one, name=whole_word(one.path)) if one.name in facts else one for one in designs.varied)
    return replace(designs, varied=tuple(each))


def whole_word(path: str) -> str:
    """Give a path as one word, as a dimension is called whose last name alone would not do."""
    return "".join(letter if letter.isalnum() else "_" for letter in path).strip("_").replace("__", "_")


def path_meant(machine: Machine, given: str) -> str:
    """Path that a name means, or an item of a list of that name: itself, or the only one of the file that ends in it.

    Raises
    ------
    InputError
        Where several paths end so, or none does.
    """
    name, *rest = parts = quantity_path(given)
    is_whole = any(isinstance(part, str) for part in rest)
    if is_whole or name in machine.declared or name in type(machine).model_fields:
        return path_text(parts)
    ends = [path for path in paths_in(machine.declared) if quantity_path(path)[-1] == name]
    if len(ends) == 1:
        return f"{ends[0]}{path_text(rest)}"
    if not ends:
        last = {str(quantity_path(path)[-1]) for path in paths_in(machine.declared)}
        meant = nearest(str(name), sorted(last))
        repair = _("did you mean {name}?", name=meant) if meant else _("write its path, as bank.R.mechanism.rod_length")
        raise InputError([Problem(given, None, _("is no key of this machine's file"), repair)])
    named = ", ".join(ends[:_NAMED]) + (", …" if len(ends) > _NAMED else "")
    allowed = _("stands {n} times in this file", n=len(ends))
    raise InputError([Problem(given, None, allowed, _("write one of: {paths}", paths=named))])


def paths_in(data: object, above: tuple[str | int, ...] = ()) -> Iterator[str]:
    """Paths of all values of some tables."""
    if isinstance(data, Mapping) and "value" not in data:
        for key, inner in cast("Mapping[str, object]", data).items():
            yield from paths_in(inner, (*above, key))
    else:
        yield path_text(above)


def _each(path: str, values: object) -> tuple[object, ...]:
    """Values one by one."""
    if not _are_several(values):
        allowed = _("must be values, one by one, or a text such as 130..160 mm:31")
        raise InputError([Problem(path, short(str(values)), allowed)])
    found = tuple(_as_given(value) for value in values)
    refuse([] if found else [Problem(path, None, _("must have at least one value"))])
    refuse(Problem(path, "None", _("is no value")) for value in found if value is None)
    return _without_residue(found)


def _without_residue(values: tuple[object, ...]) -> tuple[object, ...]:
    """Say 0 where even steps come to nothing but rounding, as −0.3, −0.2 … 0.3 of NumPy's do."""
    if len(values) < _EVEN or not all(isinstance(value, float) for value in values):
        return values
    numbers = np.array(values, dtype=float)
    steps = np.diff(numbers)
    step = float(np.abs(steps[0]))
    with np.errstate(invalid="ignore"):
        if not step > 0 or not np.all(np.abs(steps - steps[0]) <= _ROUNDING * np.max(np.abs(numbers))):
            return values
    return tuple(0.0 if abs(number) <= _ROUNDING * step else number for number in numbers.tolist())


def _are_several(values: object) -> TypeGuard[Iterable[object]]:
    """Whether there are values one by one; an array of NumPy's without axes is one."""
    is_one = isinstance(values, Mapping | bytes) or (isinstance(values, np.ndarray) and values.ndim == 0)
    return isinstance(values, Iterable) and not is_one


def _as_given(value: object) -> object:
    """A number of NumPy's as one of Python's."""
    return cast("Any", value).item() if isinstance(value, np.generic) else value


def _twice(one: Varied) -> list[object]:
    """Values that stand twice, of those that are one number the first."""
    keys = map(repr, one.values) if one.numbers is None else one.numbers.tolist()
    return [each[0] for each in grouped(zip(keys, one.values, strict=True)).values() if len(each) > 1]


def _measured(value: object) -> tuple[Fraction | float, str] | None:
    """A number with its unit; None of what is none."""
    if isinstance(value, int | float) and not isinstance(value, bool):
        with suppress(OverflowError):  # of a whole number beyond all doubles
            return float(value), ""
    if not isinstance(value, str):
        return None
    found = quantity_typed(value)
    return None if found is None else (found.number, found.unit)
