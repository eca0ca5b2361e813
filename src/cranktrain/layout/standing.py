"""Where shafts stand: their places in machine axes, and whether opposed pistons on them lie in one line."""

from collections.abc import Mapping, Sequence

import numpy as np

from cranktrain.errors import Problem
from cranktrain.grouping import grouped
from cranktrain.language import Words, _
from cranktrain.layout.frames import Orientation, frame_of, in_machine_axes
from cranktrain.layout.places import PlacedMechanism
from cranktrain.layout.specs import MAIN, ShaftSpec
from cranktrain.motion import Array, single
from cranktrain.numerics import turn_grid
from cranktrain.numerics.harmonics import TURN
from cranktrain.saying.wording import as_limit

_IN_LINE = 1e-3
"""Places are written to fewer digits than √3 has: two axes of one cylinder may differ by so much of their distance."""

_CLEAR = 1e-3
"""Two pistons with so much room, in parts of the distance of their shafts, have it on every throw with the same lead,
though there they are looked at from degree to degree at other angles."""

_DIGITS = 9
"""Leads that are alike in so many are one. [rad]"""


def shaft_centres(shafts: Mapping[str, ShaftSpec]) -> dict[str, Array]:
    """Give the centre X, Y of every shaft whose place is known, from that of `main`: to the right, and up. [m]"""
    known = {name: np.array([part.array for part in shaft.place]) for name, shaft in shafts.items() if shaft.place}
    return {MAIN: np.zeros(2), **known}


def standing_problems(
    shafts: Mapping[str, ShaftSpec], places: Sequence[PlacedMechanism], orientation: Orientation
) -> tuple[Problem, ...]:
    """Find shafts that stand so that opposed pistons would not share a cylinder, or would meet in it.

    Parameters
    ----------
    shafts : mapping of name to ShaftSpec
    places : sequence of PlacedMechanism
    orientation : Orientation

    Returns
    -------
    tuple of Problem
        One at most for each shaft.
    """
    centres = shaft_centres(shafts)
    if len(centres) == 1:
        return ()
    found: dict[str, Problem] = {}
    clear = set[object]()
    for pair in grouped((place.cylinder, place) for place in places).values():
        if len(pair) != 2 or pair[0].shaft == pair[1].shaft or not {pair[0].shaft, pair[1].shaft} <= centres.keys():
            continue
        alike = (*((place.path, place.geometry) for place in pair), round(_lead(pair), _DIGITS))
        if alike in clear:
            continue
        named = next(place.shaft for place in reversed(pair) if place.shaft != MAIN)
        allowed, is_clear = _wrong(pair, centres, orientation)
        given = shafts[named].place
        if allowed is not None and given is not None:
            found.setdefault(named, Problem(f"shaft.{named}.place", ", ".join(part.text for part in given), allowed))
        elif is_clear:
            clear.add(alike)
    return tuple(found.values())


def _lead(pair: Sequence[PlacedMechanism]) -> float:
    """By how much the crank of one of two pistons is ahead of the other's. [rad]"""
    return float(np.mod(pair[0].phase - pair[1].phase, TURN))


def _wrong(
    pair: Sequence[PlacedMechanism], centres: Mapping[str, Array], orientation: Orientation
) -> tuple[Words | None, bool]:
    """Say what is wrong with the places of two pistons' shafts, if anything; and whether there is room to spare."""
    frames = [frame_of(place, orientation) for place in pair]
    along = np.array(in_machine_axes(single(1.0), single(0.0), frames[0]))
    lines = [
        centres[place.shaft]
        + np.array(in_machine_axes(single(0.0), single(getattr(place.geometry, "offset", 0.0)), frame))
        for place, frame in zip(pair, frames, strict=True)
    ]
    apart = lines[1] - lines[0]
    distance = float(np.dot(apart, along))
    beside = float(np.hypot(*(apart - distance * along)))
    if beside > _IN_LINE * abs(distance):
        allowed = _("must be such that both pistons of {cylinder} lie in one line, of which this is {beside} beside")
        return allowed.format(cylinder=pair[0].cylinder, beside=as_limit(beside)), False
    phi = turn_grid()
    with np.errstate(all="ignore"):
        motions = [place.kind.motion(phi + place.phase, place.geometry) for place in pair]
    reach = float(np.nanmax(sum(motion.slider.value for motion in motions)))
    if distance < reach:
        allowed = _("must be more than {reach} from the other shaft of {cylinder}, or its pistons meet")
        return allowed.format(cylinder=pair[0].cylinder, reach=as_limit(reach)), False
    return None, distance - reach > _CLEAR * distance
