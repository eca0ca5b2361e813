"""Units that a reader chose to see numbers in; what was not chosen has its usual one."""

from collections import Counter
from collections.abc import Generator, Iterable, Mapping, Sequence
from contextlib import contextmanager
from contextvars import ContextVar

from cranktrain.errors import Problem, refuse
from cranktrain.grouping import grouped
from cranktrain.language import _
from cranktrain.quantities.dimensions import Dimension, plain, spellings, unit_names
from cranktrain.quantities.number import measured
from cranktrain.quantities.refusal import nearest

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
_COUNTED_FROM = {"ati": "at", "psig": "psi"}
"""Gauge units, and those of pressures that count from nothing."""

_chosen: ContextVar[UnitChoice] = ContextVar("chosen units", default={})  # noqa: B039 - nobody changes a choice


@contextmanager
def shown_by(choice: UnitChoice) -> Generator[None]:
    """Show numbers in chosen units for a while, besides those that are chosen already."""
    token = _chosen.set({**_chosen.get(), **choice})
    try:
        yield
    finally:
        _chosen.reset(token)


def chosen_unit(usual: str) -> str | None:
    """Unit chosen for what is usually shown in one, in any of its spellings; None where none was.

    Examples
    --------
    >>> with shown_by(units_by_dimension(["psi", "in"])):
    ...     chosen_unit("bar"), chosen_unit("mm"), chosen_unit("kW")
    ('psi', 'in', None)
    """
    choice = _chosen.get()
    if not choice:
        return None
    key = plain(usual)
    return next((unit for dimension, unit in choice.items() if key in spellings(dimension)), None)


def units_by_dimension(names: Sequence[str]) -> UnitChoice:
    """Give the units of some names, as typed after --units, by what they measure; one of two things stands for both.

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
            repair = _("did you mean {name}?").format(name=close) if close else None
            problems.append(Problem("--units", name, _("must be units with commas between, such as bar,kW,in"), repair))
        elif twice is not None:
            allowed = _("must not stand beside {other}, of the same").format(other=twice)
            problems.append(Problem("--units", name, allowed))
        found |= own
    refuse(problems)
    return found


def own_units(texts: Iterable[str]) -> UnitChoice:
    """Units of other systems in which most that is written of a quantity stands: a file in inches is shown in inches.

    Examples
    --------
    >>> list(own_units(["4 in", "7 1/2 in", "20 mm", "60 psig", "2 bar", "0.9 bar"]).values())
    ['in']
    """
    units = [parts.unit for text in texts if (parts := measured(text)) is not None and parts.unit]
    written = grouped(one for unit in units for one in _measured_in(unit).items())
    most = {dimension: Counter(names).most_common(1)[0][0] for dimension, names in written.items()}
    return {dimension: _COUNTED_FROM.get(unit, unit) for dimension, unit in most.items() if unit in _OF_OTHER_SYSTEMS}


def _measured_in(unit: str) -> UnitChoice:
    """What a unit measures, with its name in the list for each."""
    key = plain(unit)
    return {dimension: spellings(dimension)[key][0].name for dimension in SHOWN if key in spellings(dimension)}
