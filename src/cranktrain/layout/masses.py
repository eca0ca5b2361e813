"""Masses: the rigid bodies of a machine file, put to the links of every mechanism."""

from collections.abc import Iterator, Mapping, Sequence
from typing import ClassVar, NamedTuple

import numpy as np

from cranktrain.errors import Problem
from cranktrain.grouping import grouped, without_equal
from cranktrain.language import N_, Words, _
from cranktrain.layout.bodies import BodySpec, GravitySpec, GuideSpec
from cranktrain.layout.crank_bodies import CRANK, at_pin, crank_bodies, crank_problems
from cranktrain.layout.frames import Orientation, frame_of
from cranktrain.layout.part_tables import (
    PISTON,
    SLIDER,
    Edges,
    bearing_moments,
    edges_of,
    nearest_item,
    part_name,
    table_paths,
    unknown_parts,
)
from cranktrain.layout.places import PlacedMechanism
from cranktrain.linkage.forces import Body, Gravity
from cranktrain.motion import ZERO, Array, plain
from cranktrain.numerics.designs import by_design
from cranktrain.quantities import Given
from cranktrain.record import record
from cranktrain.saying.wording import as_limit

_TABLE = "masses"
_LEAST_GYRATION, _MOST_GYRATION = 0.1, 1.0
"""Radius of gyration, in lengths of the link, beyond which its inertia is flagged: a bar has 0.29, two masses 0.5."""


class MechanismMasses(NamedTuple):
    """What one mechanism is made of, in floats; or several, in arrays of shape (design, member, 1).

    bodies: a `Body` for each moving part; gravity: in the mechanism's axes [m/s²]; of its sliders, friction [1] and the
    edges of their guides; at_pin: which part of its crank's mass turns at the pin [kg].
    """

    bodies: tuple[Body, ...]
    gravity: Gravity
    friction: tuple[Array, ...]
    edges: tuple[Edges, ...]
    at_pin: Array


@record
class Masses:
    """Bodies of all mechanisms, and what weighs on them.

    Attributes
    ----------
    batches : tuple of MechanismMasses
        One for each of `Mechanisms.batches`.
    are_given : bool
        Whether anything has a mass: without it nothing shakes, and nothing is balanced.
    weightless : tuple of str
        Rods and sliders for which no mass is given.
    assumed : tuple of str
        Rods whose inertia is that of two masses at their ends, as none is given.
    doubtful : tuple of str
        Links whose inertia hardly any body of their mass and length has.
    unused : tuple of str
        Paths of bodies that no part has, as others stand in their place.
    """

    needs: ClassVar[str] = N_("[masses]")
    reads: ClassVar[tuple[str, ...]] = ("[mechanism]", "[friction]", "[guide]", "[gravity]", "angle", "[bank.NAME]")

    batches: tuple[MechanismMasses, ...]
    are_given: bool
    weightless: tuple[str, ...]
    assumed: tuple[str, ...]
    doubtful: tuple[str, ...]
    unused: tuple[str, ...]

    @property
    def has_friction(self) -> bool:
        """Whether any slider of any design rubs."""
        return any((coefficient != 0.0).any() for batch in self.batches for coefficient in batch.friction)

    def without_mass(self, *, has_gas: bool = True, has_loads: bool = False) -> Words | None:
        """Say what has no mass, and what alone acts then; None where all has."""
        if all(not np.any(body.mass) for batch in self.batches for body in batch.bodies):
            if not has_gas and not has_loads:
                return _("No masses are given, and neither gas nor a load acts on a part: forces and torque are 0.")
            if not has_loads:
                return _("No masses are given: forces and torque are of the gas alone.")
            if not has_gas:
                return _("No masses are given: forces and torque are of the loads alone.")
            return _("No masses are given: forces and torque are of gas and loads alone.")
        return _("Without mass: {parts}.", parts=", ".join(self.weightless)) if self.weightless else None


def bodies_given(masses: Masses | None) -> bool | str:
    """Whether anything has a mass, or that it must have one."""
    return N_("[masses]") if masses is None or not masses.are_given else True


class Weighed(NamedTuple):
    """What a machine file says of masses: bodies by path of their table, friction by slider, and what weighs on them.

    guides has the guides of what slides, by path of their table; gravity is None where weights do not count.
    """

    bodies: Mapping[str, Mapping[str, BodySpec]]
    friction: Mapping[str, Given]
    guides: Mapping[str, Mapping[str, GuideSpec]]
    gravity: GravitySpec | None
    orientation: Orientation


def _length(place: PlacedMechanism, part: str) -> Array | None:
    """Length of a link between its pins, where the mechanism's geometry names it. [m]"""
    return getattr(place.geometry, f"{part}_length", None)


def mass_problems(places: Sequence[PlacedMechanism], given: Weighed) -> Iterator[Problem]:
    """Find masses, friction and guides of parts that no mechanism has, and bodies that cannot be the link's."""
    moves = _("must be a part that moves: {parts}")
    # Alike mechanisms share their geometry.
    alike = grouped(((place.path, id(place.geometry)), place) for place in places)
    different = [first for first, *_others in alike.values()]
    yield from unknown_parts(different, _TABLE, given.bodies, lambda dynamics: dynamics.moving, moves)
    for path, bodies in given.bodies.items():
        for name, body in bodies.items():
            own = [
                place
                for place in different
                if path in table_paths(place, _TABLE) and name in map(part_name, place.kind.dynamics.moving)
            ]
            if own:
                yield from _body_problems(f"{path}.{name}", name, body, own)
    yield from crank_problems(places, given.bodies)
    slides = _("must be what slides in a guide or a slot: {parts}")
    yield from unknown_parts(
        different, "friction", {"friction": given.friction}, lambda dynamics: dynamics.sliding, slides
    )
    is_guided = _("must be what slides in a guide, which can bear a moment: {parts}")
    yield from unknown_parts(different, "guide", given.guides, bearing_moments, is_guided)


def _body_problems(where: str, name: str, body: BodySpec, places: Sequence[PlacedMechanism]) -> Iterator[Problem]:
    """Find what a body lacks, and a centroid that lies far outside its link."""
    lengths = without_equal(plain(length) for place in places if (length := _length(place, name)) is not None)
    turns = any(name not in map(part_name, place.kind.dynamics.straight) for place in places)
    if turns and name != PISTON and body.big_end is None and not body.weighs_nothing:
        yield from (
            Problem(
                f"{where}.{field}",
                None,
                _("is missing; give it, or big_end and small_end") if lengths else _("is missing"),
            )
            for field, given in (("along", body.along), ("inertia", body.own_inertia))
            if given is None and not (field == "inertia" and lengths)
        )
    if body.big_end is not None and not lengths:
        yield Problem(f"{where}.big_end", body.big_end.text, _("is for a rod, whose length is known"))
    for length in lengths:
        if body.along is not None and not -length <= body.along.si <= 2 * length:
            allowed = _(
                "must lie on the link or not far from it: {least} to {most} from its first pin",
                least=as_limit(-length),
                most=as_limit(2 * length),
            )
            yield Problem(f"{where}.along", body.along.text, allowed)
        if abs(body.across.si) > length:
            allowed = _(
                "must lie on the link or not far from it: {least} to {most} beside the line of its pins",
                least=as_limit(-length),
                most=as_limit(length),
            )
            yield Problem(f"{where}.across", body.across.text, allowed)


def masses_of(places: Sequence[PlacedMechanism], given: Weighed, n_designs: int) -> Masses:
    """Stack the bodies of designs of one machine by kind, as `mechanisms_of` does."""
    cranks = crank_bodies(places, given.bodies)
    said = [_said_of(place, given, cranks) for place in places]
    # Of all of which the file says the same, masses are found once: mostly that is all of a bank.
    different = dict(zip(said, places, strict=True))
    found = {key: _found_of(place, given, cranks.get(place.name)) for key, place in different.items()}
    each = [found[key] for key in said]
    used = [body for own in found.values() for body in own.used] + [*cranks.values()]
    # Of banks that say the same of a throw they share each is right.
    used += [bodies[CRANK] for path, bodies in given.bodies.items() if path != _TABLE and CRANK in bodies]
    of_kinds = grouped((place.kind, own.masses) for place, own in zip(places, each, strict=True))
    return Masses(
        tuple(by_design(masses, n_designs) for masses in of_kinds.values()),
        are_given=bool(given.bodies),
        weightless=_named(places, [own.weightless for own in each]),
        assumed=_named(places, [own.assumed for own in each]),
        doubtful=_named(places, [own.doubtful for own in each]),
        unused=tuple(
            f"{path}.{name}"
            for path, bodies in given.bodies.items()
            for name, body in bodies.items()
            if all(body is not one for one in used)
        ),
    )


def _named(places: Sequence[PlacedMechanism], parts: Sequence[Sequence[str]]) -> tuple[str, ...]:
    """Name parts of mechanisms."""
    return tuple(f"{place.name}.{part}" for place, own in zip(places, parts, strict=True) for part in own)


class _Found(NamedTuple):
    """Masses of a mechanism, bodies of the file that it uses, and the parts of which `Masses` speaks."""

    masses: MechanismMasses
    used: Sequence[BodySpec]
    weightless: Sequence[str]
    assumed: Sequence[str]
    doubtful: Sequence[str]


def _found_of(place: PlacedMechanism, given: Weighed, crank: BodySpec | None) -> _Found:
    """Find the masses of a mechanism, with the body of its throw if that counts with it."""
    dynamics = place.kind.dynamics
    specs = {
        part: crank if part == CRANK else nearest_item(place, part, _TABLE, given.bodies) for part in dynamics.moving
    }
    masses = _place_masses(place, given, specs)
    bodies = dynamics.by_link(masses.bodies)
    used = {part: spec for part, spec in specs.items() if part != CRANK and spec is not None}
    unturned = (SLIDER, *dynamics.straight)
    return _Found(
        masses,
        used=list(used.values()),
        weightless=[part_name(part) for part, spec in specs.items() if part != CRANK and spec is None],
        assumed=[
            part
            for part, spec in used.items()
            if spec.own_inertia is None and part not in unturned and not spec.weighs_nothing
        ],
        doubtful=[
            part
            for part, spec in used.items()
            if spec.own_inertia is not None and not _is_likely(bodies[part], _length(place, part))
        ],
    )


def _is_likely(body: Body, length: Array | None) -> bool:
    """Whether an inertia that is not 0 is one that a link of its mass and length can have, in all designs."""
    if length is None:
        return True
    with np.errstate(divide="ignore", invalid="ignore"):
        gyration = np.sqrt(np.divide(body.inertia, body.mass))
    is_likely = (gyration >= _LEAST_GYRATION * length) & (gyration <= _MOST_GYRATION * length)
    return bool(np.all((body.inertia == 0) | is_likely))


def _said_of(place: PlacedMechanism, given: Weighed, cranks: Mapping[str, BodySpec | None]) -> object:
    """All that the masses of a mechanism hang on: what is equal is the same. Alike mechanisms share their geometry."""
    direction = None if given.gravity is None else np.asarray(frame_of(place, given.orientation)[0]).tobytes()
    return place.path, id(place.geometry), id(cranks.get(place.name)), place.sense, direction


def _place_masses(place: PlacedMechanism, given: Weighed, specs: Mapping[str, BodySpec | None]) -> MechanismMasses:
    """Bodies, gravity, friction and guides of one mechanism, whose moving parts have these tables."""
    sliding, nothing = place.kind.dynamics.sliding, Body(ZERO, ZERO, ZERO, ZERO)
    return MechanismMasses(
        tuple(nothing if spec is None else _body(place, part, spec) for part, spec in specs.items()),
        _gravity(place, given),
        tuple(given.friction[part_name(name)].array if part_name(name) in given.friction else ZERO for name in sliding),
        tuple(edges_of(place, name, given.guides) for name in sliding),
        at_pin(specs.get(CRANK)),
    )


def _gravity(place: PlacedMechanism, given: Weighed) -> Gravity:
    """Gravity in the mechanism's axes. [m/s²]"""
    if given.gravity is None:
        return Gravity(ZERO, ZERO)
    direction, sense = frame_of(place, given.orientation)
    tilt, pull = given.gravity.direction.array, given.gravity.acceleration.array
    up = direction - tilt if given.orientation.is_clockwise else direction + tilt
    return Gravity(-pull * np.cos(up), pull * sense * np.sin(up))


def _body(place: PlacedMechanism, part: str, spec: BodySpec) -> Body:
    """One body in SI; what is across counts to the left in the mechanism's own axes."""
    length = _length(place, part)
    along = ZERO if spec.along is None else spec.along.array
    mass = ZERO if spec.mass is None else spec.mass.array
    if spec.big_end is not None and spec.small_end is not None and length is not None:
        mass = spec.big_end.array + spec.small_end.array
        along = length * spec.small_end.array / mass
    inertia = ZERO if length is None else mass * along * (length - along)
    inertia = inertia if spec.own_inertia is None else spec.own_inertia
    return Body(mass, along, place.sense * spec.across.array, inertia)
