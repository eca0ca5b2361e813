"""Loads of several designs together: each may have a file of its own, whose lists then stand over the same places."""

from collections.abc import Iterator, Sequence

import numpy as np

from cranktrain.columns import in_columns
from cranktrain.errors import InputError, Problem, refuse
from cranktrain.fluids.indicator.table import held_text
from cranktrain.language import _
from cranktrain.layout.design import Designs
from cranktrain.layout.load_tables import LoadSpec, LoadTables, with_lists
from cranktrain.motion import Array
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
                of_all = in_columns(_over_the_same(each)) if len(each) > 1 else each[0]
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


def _over_the_same(each: Sequence[LoadSpec]) -> list[LoadSpec]:
    """List sizes over the places of all files: on straight lines more places change nothing."""
    over = each[0].over
    if over is None or len({spec.text for spec in each}) == 1:
        return list(each)
    name, first = over
    period = _period(first) if name == "crank_angles" else None
    places = np.unique([place.si for spec in each for place in _places(spec)])
    if period is not None:
        places = np.unique(np.mod(places, period))
        places = np.append(places, places[0] + period)
    return [_over_places(spec, places, period) for spec in each]


def _places(spec: LoadSpec) -> Sequence[Given]:
    return () if spec.over is None else spec.over[1]


def _over_places(spec: LoadSpec, places: Array, period: float | None) -> LoadSpec:
    """List the sizes of a load over other places, of which its own are some."""
    over = "" if spec.over is None else spec.over[0]
    own = [place.si for place in _places(spec)]
    given = [Given(place, f"{place!r} in SI") for place in places.tolist()]

    def at(sizes: Sequence[Given] | None) -> tuple[Given, ...] | None:
        if sizes is None:
            return None
        found = np.interp(places, own, [size.si for size in sizes], period=period)
        return tuple(Given(size, f"{size!r} in SI") for size in found.tolist())

    sort = "torque" if spec.force is None else "force"
    lists = {over: tuple(given), sort: at(spec.sizes), f"{sort}_back": at(spec.back)}
    return with_lists(spec, lists)
