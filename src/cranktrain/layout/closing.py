"""Over which crank angles the links of a machine cannot close, by how much, and what would help."""

from collections.abc import Iterator, Sequence

import numpy as np

from cranktrain.errors import Problem
from cranktrain.grouping import grouped
from cranktrain.language import Said, Words, _
from cranktrain.layout.places import PlacedMechanism
from cranktrain.mechanisms.closing import OpenRange, open_ranges
from cranktrain.motion import Array
from cranktrain.quantities import Given
from cranktrain.saying.wording import all_of, around_turn, number

_SEEN = 5e-6
"""A length that is less is written as nothing. [m]"""


def closing_problems(places: Sequence[PlacedMechanism], zero: Array) -> tuple[Problem, ...]:
    """Over which crank angles a mechanism cannot close, once for each geometry.

    Parameters
    ----------
    places : sequence of PlacedMechanism
    zero : Array
        Crank angle that is shown as 0. [rad]

    Returns
    -------
    tuple of Problem
    """
    alike = grouped(((place.path, place.geometry), place) for place in places)
    with np.errstate(all="ignore"):
        open_places = [place for place, *_like in alike.values() if open_ranges(place.kind, place.geometry)]
        stuck = {place.geometry for place in open_places}
        return tuple(
            problem
            for place in open_places
            # A slave on a master that cannot close says nothing of its own.
            if getattr(place.geometry, "master", None) not in stuck
            for problem in _closing_problems(place, zero)
        )


def _closing_problems(place: PlacedMechanism, zero: Array) -> Iterator[Problem]:
    """Say of each part of a mechanism where it cannot close, or of the whole where it has none."""
    kind, geometry = place.kind, place.geometry
    said = kind.closing_advice(geometry)
    if isinstance(said, Said | str):
        find = kind.closing_field
        field = find if isinstance(find, str) else find(place.spec, geometry)
        yield _closing_problem(place, field, said, open_ranges(kind, geometry), zero)
        return
    for part in said:
        ranges = open_ranges(kind, geometry, part.gap)
        if ranges:
            yield _closing_problem(place, part.field, part.advice, ranges, zero)


def _closing_problem(
    place: PlacedMechanism, field: str, advice: Words, ranges: Sequence[OpenRange], zero: Array
) -> Problem:
    """Say where a mechanism or a part of it cannot close, by how much, and what would help."""
    short = max(one.short for one in ranges)
    if ranges[0].end - ranges[0].start >= 2 * np.pi:
        allowed = _("the links can close at no crank angle (short by {short}); {advice}")
    elif short < _SEEN:
        allowed = _("the links lie in one line at crank angle {angles}, and the crank cannot pass; {advice}")
    else:
        allowed = _("the links cannot close at crank angles {angles} (short by {short}); {advice}")
    given: Given | None = getattr(place.spec, field, None)
    return Problem(
        place.path_of(field),
        given.text if given else None,
        allowed.format(
            angles=all_of([_span(one.start - place.phase - zero, one.end - place.phase - zero) for one in ranges]),
            short=number(short, "mm"),
            advice=advice,
        ),
    )


def _span(start: Array, end: Array) -> Words:
    """Say from where to where the crank angle runs; one angle where both are alike."""
    first, last = around_turn(np.array([start, end])).tolist()
    one = number(first, "deg")
    return one if first == last else _("{start} to {end}", start=one, end=number(last, "deg"))
