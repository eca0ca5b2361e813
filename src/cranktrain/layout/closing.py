"""Over which crank angles the links of a machine cannot close, by how much, and what would help."""

from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from cranktrain.columns import numbers_of
from cranktrain.errors import UNREAD, Problem
from cranktrain.grouping import grouped
from cranktrain.language import Said, Words, _
from cranktrain.layout.design import Design
from cranktrain.layout.places import PlacedMechanism
from cranktrain.mechanisms.closing import OpenRange, open_ranges, opens
from cranktrain.motion import Array
from cranktrain.numerics.harmonics import TURN
from cranktrain.quantities import FileUnits, Given, own_units, problem_in_units
from cranktrain.saying.wording import all_of, around_turn, number

_SEEN = 5e-6
"""A length that is less is written as nothing. [m]"""
_TOLD = 2.54e-5
"""Of which so much is said that it is less: a thousandth of an inch. [m]"""


def open_places(design: Design) -> Mapping[int, tuple[OpenRange, ...]]:
    """Angles of their own cranks over which mechanisms cannot close, by their places; none of one that always does."""
    known = [(i, place) for i, place in enumerate(design.places) if place.geometry is not UNREAD]
    alike = grouped(((place.path, place.geometry), i) for i, place in known)
    with np.errstate(all="ignore"):
        found = {
            tuple(own): open_ranges(design.places[own[0]].kind, design.places[own[0]].geometry)
            for own in alike.values()
        }
    return {i: ranges for own, ranges in found.items() if ranges for i in own}


def closed_ranges(ranges: Sequence[OpenRange]) -> list[tuple[float, float]]:
    """Give the ranges between those in which links cannot close, by their starts in [0, 2π). [rad]"""
    if ranges[0].end - ranges[0].start >= TURN:
        return []
    starts = [one.start for one in ranges[1:]] + [ranges[0].start + TURN]
    between = [(one.end, start) for one, start in zip(ranges, starts, strict=True)]
    turns = [TURN * np.floor(start / TURN) for start, _end in between]
    return sorted((start - turn, end - turn) for (start, end), turn in zip(between, turns, strict=True))


def closing_problems(design: Design) -> tuple[Problem, ...]:
    """Over which crank angles a mechanism cannot close, once for each geometry.

    Parameters
    ----------
    design : Design

    Returns
    -------
    tuple of Problem
    """
    places, ranges = design.places, design.once(open_places)
    first = {(places[i].path, places[i].geometry): i for i in sorted(ranges, reverse=True)}
    stuck = {geometry for _path, geometry in first}
    with np.errstate(all="ignore"):
        return tuple(
            problem
            for i in sorted(first.values())
            # A slave on a master that cannot close says nothing of its own.
            if getattr(places[i].geometry, "master", None) not in stuck
            for problem in _closing_problems(places[i], ranges[i], design.zero)
        )


def _closing_problems(place: PlacedMechanism, ranges: Sequence[OpenRange], zero: Array) -> Iterator[Problem]:
    """Say of each part of a mechanism where it cannot close, or of the whole where it has none."""
    kind, geometry = place.kind, place.geometry
    said = kind.closing_advice(geometry)
    if isinstance(said, Said | str):
        find = kind.closing_field
        field = find if isinstance(find, str) else find(place.spec, geometry)
        yield _closing_problem(place, field, said, ranges, ranges, zero)
        return
    to_blame = [part for part in said if opens(part.gap, kind, geometry)]
    for part in to_blame:
        # What one part alone cannot is what the whole cannot.
        own = ranges if len(to_blame) == 1 else open_ranges(kind, geometry, part.gap)
        if own:
            yield _closing_problem(place, part.field, part.advice, own, ranges, zero)


def _closing_problem(
    place: PlacedMechanism,
    field: str,
    advice: Words,
    own: Sequence[OpenRange],
    whole: Sequence[OpenRange],
    zero: Array,
) -> Problem:
    """Say where a mechanism or a part of it cannot close, by how much, what would help, and where the whole closes."""
    short = max(one.short for one in own)
    lack = number(short, "mm") if short >= _TOLD else _("less than {length}", length=number(_TOLD, "mm"))
    if own[0].end - own[0].start >= TURN:
        allowed = _("the links can close at no crank angle (short by {short}); {advice}")
    elif short < _SEEN:
        allowed = _(
            "the links lie in one line at crank angle {angles}, and nothing says which way they go on; {advice}"
        )
    else:
        allowed = _("the links cannot close at crank angles {angles} (short by {short}); {advice}")
    given: Given | None = getattr(place.spec, field, None)
    repair = None
    if short >= _SEEN and (left := closed_ranges(whole)):
        closes = all_of([_span(start - place.phase - zero, end - place.phase - zero) for start, end in left])
        repair = _("all links close at {closes}: run it there with --partial", closes=closes)
    found = Problem(
        place.path_of(field),
        given.text if given else None,
        allowed.format(
            angles=all_of([_span(one.start - place.phase - zero, one.end - place.phase - zero) for one in own]),
            short=lack,
            advice=advice,
        ),
        repair,
    )
    return problem_in_units(found, FileUnits(written=own_units(one.text for _path, one in numbers_of(place.spec))))


def _span(start: Array, end: Array) -> Words:
    """Say from where to where the crank angle runs; one angle where both are alike."""
    first, last = around_turn(np.array([start, end])).tolist()
    one = number(first, "deg")
    return one if first == last else _("{start} to {end}", start=one, end=number(last, "deg"))
