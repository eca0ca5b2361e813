"""Loads of several designs together: each may have a file of its own, with lists of its own length."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from cranktrain.columns import in_columns
from cranktrain.errors import InputError, Problem, refuse
from cranktrain.fluids.indicator.table import held_text
from cranktrain.language import _
from cranktrain.layout.design import Designs
from cranktrain.layout.load_tables import LoadSpec, LoadTables, with_lists
from cranktrain.numerics.harmonics import TURN
from cranktrain.quantities import Given


def tables_together(designs: Designs) -> LoadTables:
    """Give the loads of all designs, whose numbers are columns of them.

    Parameters
    ----------
    designs : Designs

    Returns
    -------
    mapping of str to mapping of str to LoadSpec

    Raises
    ------
    InputError
        Where nobody has read a file; where files of designs say other things than sizes over the same; where one goes
        on over two turns, and the cycle is one.
    """
    found: dict[str, dict[str, LoadSpec]] = {}
    for path, named in designs.together.loads.items():
        for name, spec in named.items():
            of_all = spec
            if spec.file is not None:
                each = [design.loads[path][name] for design in designs.each]
                refuse(_problems(each, f"{path}.{name}.file", designs.crank_angle.cycle))
                of_all = in_columns(_as_long(each)) if len(each) > 1 else each[0]
            found.setdefault(path, {})[name] = of_all
    return found


def _problems(each: Sequence[LoadSpec], path: str, cycle: float) -> Iterator[Problem]:
    """Find what only the files of all designs show to be wrong."""
    for spec in each:
        try:
            held_text(spec.file or "", spec.text)
        except InputError as error:
            yield from (Problem(path, one.given, one.allowed) for one in error.problems)
            return
    first = each[0].card
    for spec in each:
        card = spec.card
        if first is None or card is None or (card.sort, card.over) != (first.sort, first.over):
            yield Problem(path, spec.file, _("must hold the same in all designs: forces or torques, over the same"))
        elif card.over == "crank_angles" and _period(card.places) > cycle * 1.5:
            yield Problem(path, spec.file, _("goes on over two turns, and the cycle of this machine is one"))


def _period(angles: Sequence[Given]) -> float:
    """A turn, or two where angles reach farther. [rad]"""
    return 2 * TURN if angles[-1].si - angles[0].si > 1.5 * TURN else TURN


def _as_long(each: Sequence[LoadSpec]) -> Sequence[LoadSpec]:
    """Make the lists of all files as long as the longest: a last place may stand again, which says nothing new."""
    over = each[0].over
    if over is None or len({(spec.text, spec.columns) for spec in each}) == 1:
        return each
    is_round = over[0] == "crank_angles"
    period = max(_period(_places(spec)) for spec in each) if is_round else None
    whole = [_lists(spec, period) for spec in each]
    longest = max(len(lists.places) for lists in whole)
    sort = "torque" if each[0].force is None else "force"
    return [
        with_lists(spec, dict(zip((over[0], sort, f"{sort}_back"), lists.to_length(longest), strict=True)))
        for spec, lists in zip(each, whole, strict=True)
    ]


class _Lists(NamedTuple):
    """Places, sizes there, and sizes on the way back if there are any."""

    places: tuple[Given, ...]
    sizes: tuple[Given, ...]
    back: tuple[Given, ...] | None

    def to_length(self, n_places: int) -> "_Lists":
        """Give the last ones again until there are so many."""
        return _Lists(*(None if one is None else (*one, *one[-1:] * (n_places - len(one))) for one in self))


def _lists(spec: LoadSpec, period: float | None) -> _Lists:
    """Take the lists of a load; round a period of two turns twice, where they go on over one."""
    lists = _Lists(_places(spec), spec.sizes, spec.back)
    if period is None or _period(lists.places) == period:
        return lists
    again = tuple(Given(place.si + TURN, place.text) for place in lists.places[1:])
    return _Lists((*lists.places, *again), (*lists.sizes, *lists.sizes[1:]), None)


def _places(spec: LoadSpec) -> tuple[Given, ...]:
    return () if spec.over is None else spec.over[1]
