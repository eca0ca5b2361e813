"""Bodies of cranks: one to a throw, which belongs to whatever works on it; and pins that rods share."""

from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

from cranktrain.errors import Problem
from cranktrain.grouping import without_equal
from cranktrain.language import _
from cranktrain.layout.bodies import BodySpec
from cranktrain.layout.part_tables import nearest_item, table_paths
from cranktrain.layout.places import PlacedMechanism
from cranktrain.mechanisms.kind import AnyKind
from cranktrain.motion import ZERO, Array, plain
from cranktrain.quantities import Given
from cranktrain.saying.wording import as_limit

CRANK = "crank"
_TABLE = "masses"
_RADII = ("crank_radius", "stroke")
_FARTHEST = 2.0
"""How far from the shaft a crank's centroid may be, in radii of the crank."""
_SAME = 1e-9
"""Numbers that differ by less, in parts of the larger one, say the same in other words."""

Bodies = Mapping[str, Mapping[str, BodySpec]]


class _Throw(NamedTuple):
    """A throw or an eccentric beside one: the mechanisms that it drives, and whether the default body is its own."""

    members: tuple[PlacedMechanism, ...]
    is_main: bool


def _throws(places: Sequence[PlacedMechanism]) -> list[_Throw]:
    """Throws of mechanisms that have a crank; eccentrics are throws of their own where there is no other."""
    found: dict[tuple[str, int, str], tuple[PlacedMechanism, ...]] = {}
    for place in places:
        if CRANK in place.kind.dynamics.moving:
            throw = (place.shaft, place.throw, place.name if place.kind.has_own_pin else "")
            found[throw] = (*found.get(throw, ()), place)
    return [
        _Throw(members, not name or (shaft, throw, "") not in found) for (shaft, throw, name), members in found.items()
    ]


def crank_bodies(places: Sequence[PlacedMechanism], given: Bodies) -> dict[str, BodySpec | None]:
    """Body of each throw, by the name of the mechanism with which it counts: the first on it that has a crank.

    That of a bank's own table, whichever bank of the throw has one; else that of all throws. Where the file has none,
    no throw is named.
    """
    if not _has_cranks(given):
        return {}
    found: dict[str, BodySpec | None] = {}
    for members, is_main in _throws(places):
        own = _tables_of(members, given)
        default = nearest_item(members[0], CRANK, _TABLE, given) if is_main else None
        found[members[0].name] = own[0][1] if own else default
    return found


def _has_cranks(given: Bodies) -> bool:
    """Whether any table has a crank."""
    return any(CRANK in bodies for bodies in given.values())


def _tables_of(members: Sequence[PlacedMechanism], given: Bodies) -> list[tuple[str, BodySpec]]:
    """What tables of banks say of the crank of one throw, by path."""
    paths = dict.fromkeys(path for place in members for path in table_paths(place, _TABLE)[:-1])
    return [(path, body) for path in paths if (body := given.get(path, {}).get(CRANK)) is not None]


def at_pin(crank: BodySpec | None) -> Array:
    """Which part of a crank's mass turns at its pin. [kg]"""
    if crank is None or crank.mass is None or crank.pin_share is None:
        return ZERO
    return crank.mass.array * crank.pin_share.array


def crank_problems(places: Sequence[PlacedMechanism], given: Bodies) -> Iterator[Problem]:
    """Find banks that give the crank of one throw two bodies, and one pin two radii."""
    for members, _is_main in _throws(places) if _has_cranks(given) else ():
        own = _tables_of(members, given)
        for path, body in own[1:]:
            if not _is_same(body, own[0][1]):
                allowed = _(
                    "differs from {other} on a throw that both banks share: a throw has one body; give it once,"
                    " in the table of one bank, or in [masses.crank] for all throws"
                )
                yield Problem(f"{path}.{CRANK}", None, allowed.format(other=f"{own[0][0]}.{CRANK}"))
    yield from _share_problems(places, given)


def _share_problems(places: Sequence[PlacedMechanism], given: Bodies) -> Iterator[Problem]:
    """Find shares of what has no pin, and such as leave no crank that could be."""
    for path, bodies in given.items():
        for name, body in bodies.items():
            if body.pin_share is None:
                continue
            where, text = f"{path}.{name}.pin_share", body.pin_share.text
            own = [place for place in places if path in table_paths(place, _TABLE)]
            if name != CRANK or not any(_is_on_pin(place.kind) for place in own):
                yield Problem(where, text, _("is for the crank of rods on a crank pin: [masses.crank]"))
                continue
            radii = (getattr(place.geometry, "crank_radius", None) for place in own if _is_on_pin(place.kind))
            for radius in without_equal(plain(radius) for radius in radii if radius is not None):
                yield from _rest_problems(where, text, body, radius)


def _is_on_pin(kind: AnyKind) -> bool:
    return kind.dynamics.joint("crank_pin") is not None


def _rest_problems(where: str, text: str, body: BodySpec, radius: float) -> Iterator[Problem]:
    """Find a share at a pin that leaves the rest of the crank a centroid far from it."""
    share, along = 0.0 if body.pin_share is None else body.pin_share.si, 0.0 if body.along is None else body.along.si
    # What is left of the mass stands where both together have the centroid of the file.
    aside = max(abs(along - share * radius), abs(body.across.si))
    if body.mass is not None and body.mass.si > 0 and aside > _FARTHEST * radius * (1 - share) + _SAME * radius:
        allowed = _(
            "must leave the rest of the crank, without what is at the pin, a centroid within {farthest} from the shaft;"
            " all at the pin, 1, is for along = {radius}, the crank's radius"
        )
        said = allowed.format(farthest=as_limit(_FARTHEST * radius), radius=as_limit(radius))
        yield Problem(where, text, said)


def pin_problems(places: Sequence[PlacedMechanism]) -> Iterator[Problem]:
    """Find rods of pistons on one pin whose cranks have two radii; far pistons of a cylinder have their own pins.

    What else a throw drives, a rocker or a yoke, may hang on a crank of its own.
    """
    for members, _is_main in _throws(places):
        for is_far in (False, True):
            own = [one for one in members if one.is_far == is_far and _is_rod_of_piston(one.kind)]
            for other in own[1:]:
                yield from _unlike_radii(own[0], other)


def _is_rod_of_piston(kind: AnyKind) -> bool:
    return kind.has_rod and kind.output.is_slider and kind.dynamics.joint("crank_pin") is not None


def _unlike_radii(one: PlacedMechanism, other: PlacedMechanism) -> Iterator[Problem]:
    radius, own = (plain(place.geometry.crank_radius) for place in (one, other))
    if abs(own - radius) > _SAME * max(radius, own):
        path, given = _radius_field(other)
        allowed = _(
            "makes the crank's radius {own}, and {path} makes it {radius} on the same pin: both rods need one radius,"
            " or a throw each (two throws at one place have spacing 0)"
        )
        yield Problem(
            path, given, allowed.format(own=as_limit(own), path=_radius_field(one)[0], radius=as_limit(radius))
        )


def _radius_field(place: PlacedMechanism) -> tuple[str, str | None]:
    """Path of the field that gives a mechanism's crank radius, and what it says."""
    for name in _RADII:
        given = getattr(place.spec, name, None)
        if given is not None:
            return place.path_of(name), given.text if isinstance(given, Given) else None
    return place.path, None


def _is_same(one: BodySpec, other: BodySpec) -> bool:
    """Whether two tables say the same body."""
    pairs = zip(_numbers(one), _numbers(other), strict=True)
    return all(abs(a - b) <= _SAME * max(abs(a), abs(b)) for a, b in pairs)


def _numbers(body: BodySpec) -> tuple[float, ...]:
    """Mass, centroid, share at the pin and inertia; 0 of what is not given."""
    inertia = 0.0 if body.own_inertia is None else plain(body.own_inertia)
    lengths = (0.0 if one is None else one.si for one in (body.mass, body.along, body.across, body.pin_share))
    return (*lengths, inertia)
