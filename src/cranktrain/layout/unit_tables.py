"""The table [units]: in which units a machine is to be shown, by what they measure."""

from collections.abc import Iterator, Mapping

from cranktrain.errors import Problem
from cranktrain.paths import path_text
from cranktrain.quantities import SHOWN, UnitChoice, counted_from, gauge_problem, is_unit, one_of, unit_names

_SHOWN = {dimension.name.lower(): dimension for dimension in SHOWN}
"""What can be shown in another unit, by its key."""


def unit_problems(units: Mapping[str, str]) -> Iterator[Problem]:
    """Find what is no quantity, and units of another one."""
    for name, unit in units.items():
        measured, path = _SHOWN.get(name), path_text(("units", name))
        if measured is None:
            yield Problem(path, unit, one_of(_SHOWN))
        elif not is_unit(unit, measured):
            yield Problem(path, unit, one_of([one for one in unit_names(measured) if counted_from(one) is None]))
        elif counted_from(unit) is not None:
            yield gauge_problem(path, unit)


def units_of_table(units: Mapping[str, str]) -> UnitChoice:
    """Give the units by what they measure."""
    return {_SHOWN[name]: unit for name, unit in units.items()}
