"""The table [units]: in which units a machine is to be shown, by what they measure."""

from collections.abc import Iterator, Mapping

from cranktrain.errors import Problem
from cranktrain.language import _
from cranktrain.paths import path_text
from cranktrain.quantities import Dimension, UnitChoice, is_unit, one_of, unit_names


def unit_problems(units: Mapping[str, str]) -> Iterator[Problem]:
    """Find what is no quantity, and units of another one."""
    for name, unit in units.items():
        path = path_text(("units", name))
        if name.upper() not in Dimension.__members__:
            allowed = _("must be one of: {names}").format(names=", ".join(one.name.lower() for one in Dimension))
            yield Problem(path, unit, allowed)
        elif not is_unit(unit, Dimension[name.upper()]):
            yield Problem(path, unit, one_of(unit_names(Dimension[name.upper()])))


def units_of_table(units: Mapping[str, str]) -> UnitChoice:
    """Give the units by what they measure."""
    return {Dimension[name.upper()]: unit for name, unit in units.items()}
