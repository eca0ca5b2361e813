"""Loads of a machine file, put to the links of its mechanisms as SI arrays; and what is wrong with them."""

from collections.abc import Callable, Collection, Container, Iterator, Sequence
from dataclasses import replace
from functools import lru_cache, partial
from typing import ClassVar, NamedTuple, TypeAlias

import numpy as np

from cranktrain.errors import Problem, judged
from cranktrain.language import N_, Listed, _
from cranktrain.layout.design import Design, Designs
from cranktrain.layout.load_laws import ByAngle, BySpeed, ByTravel, Law, LoadState
from cranktrain.layout.load_stretch import WIDEST, Stretch, stretched, travel_of
from cranktrain.layout.load_tables import AT_POINT, LoadSpec, LoadTables, with_lists
from cranktrain.layout.part_tables import SLIDER, part_name, table_paths
from cranktrain.layout.places import PlacedMechanism
from cranktrain.linkage.forces.load import LoadWay, across_link, along_link, off_arc, pushing, turning, with_motion
from cranktrain.linkage.vectors import Vector, rotated
from cranktrain.mechanisms.kind import AnyGeometry
from cranktrain.motion import ONE, ZERO, Array, Link
from cranktrain.numerics.designs import by_design
from cranktrain.numerics.nested import each_changed
from cranktrain.quantities import Dimension, Given, nearest, unit_of
from cranktrain.record import record
from cranktrain.saying.wording import precise

LOAD = "load"
"""Name of the tables of loads, and path of the machine's own."""
_COVERED = 1e-6
"""Travels are written to some digits: what is missing of so small a part is covered."""

Laid: TypeAlias = Callable[[Sequence[Array]], Array]
"""Puts numbers of all designs into an array of shape (design, number)."""


class LinkLoad(NamedTuple):
    """One load on one link of one mechanism.

    Attributes
    ----------
    name : str
        Of the load; with several mechanisms `1L.cut`.
    mechanism, link : int
        Whose it is, and which of what moves there.
    is_slider, is_torque, resists : bool
    law : Law
        Of its size. [N or N·m]
    stretch : Stretch or None
        Of a card over a travel, which the law has on already.
    counts : float
        −1 where its travel counts against its way.
    arm : Vector of arrays of shape (design, 1, 1)
        Of its point from the link's first pin. [m]
    radius, direction : Array of that shape, or None
        Arm about the link's first pin [m]; in the mechanism's axes [rad].
    """

    name: str
    mechanism: int
    link: int
    is_slider: bool
    is_torque: bool
    resists: bool
    law: Law
    stretch: Stretch | None
    counts: float
    arm: Vector
    radius: Array | None
    direction: Array | None

    @property
    def distance(self) -> Array:
        """Of its point, or of its rope, from the link's first pin, shape (design, 1, 1). [m]"""
        return np.hypot(self.arm.x, self.arm.y) if self.radius is None else self.radius

    def way(self, link: Link) -> LoadWay:
        """What it goes along."""
        if self.is_torque:
            return turning(link)
        if self.radius is not None and self.direction is not None:
            return off_arc(link, self.radius, self.direction)
        if self.radius is not None:
            return across_link(link, self.radius)
        if self.direction is not None:
            return pushing(link, self.arm, self.direction)
        return along_link(link) if self.is_slider else with_motion(link, self.arm)

    def arm_of(self, link: Link) -> Vector:
        """From the link's first pin to where it acts, off an arc to where the rope leaves that. [m]"""
        if self.radius is not None and self.direction is not None:
            still = 0.0 * link.cos
            return Vector(self.radius * np.sin(self.direction) + still, -self.radius * np.cos(self.direction) + still)
        arm = self.arm if self.radius is None else Vector(self.radius, ZERO)
        return rotated(arm, link.cos, link.sin)

    def turns_back(self, link: Link, way: LoadWay) -> Array:
        """What changes its sign where the load turns round, if it resists."""
        goes_anywhere = not (self.is_torque or self.is_slider) and self.radius is None and self.direction is None
        return link.angle.first if goes_anywhere else way.rate

    def value(self, state: LoadState) -> Array:
        """Its size along its way, against the motion if it resists, shape (design, 1, n). [N or N·m]"""
        size = self.law.value(state)
        return -self.counts * np.sign(state.speed) * size if self.resists else size


@record
class Loads:
    """Loads of a machine, on whatever they act; zero, shape (design, 1, 1), is φ where the shown angle is 0. [rad]"""

    needs: ClassVar[str] = N_("[load.NAME]")
    reads: ClassVar[tuple[str, ...]] = ("crank_zero", "angle")

    each: tuple[LinkLoad, ...]
    zero: Array

    @property
    def names(self) -> tuple[str, ...]:
        """What they are called."""
        return tuple(load.name for load in self.each)

    def of(self, mechanism: int) -> list[LinkLoad]:
        """Those on one mechanism."""
        return [load for load in self.each if load.mechanism == mechanism]


def loads_of(designs: Designs, together: LoadTables) -> Loads | None:
    """Put the loads of all designs, as `tables_together` gives them, to the mechanisms; None where there is none."""
    shafts = designs.together.shafts
    tables = {
        path: {name: spec for name, spec in named.items() if not is_on_shaft(path, spec, shafts)}
        for path, named in together.items()
    }
    found = [
        _stretched(
            _link_load(designs.by_design, name if len(designs.places) == 1 else f"{place.name}.{name}", spec, i, place),
            spec,
            place,
        )
        for i, place in enumerate(designs.places)
        for name, spec in _named_loads(place, tables).items()
        if _link_of(place, spec.on) is not None
    ]
    return Loads(tuple(found), designs.crank_angle.zero) if found else None


def _stretched(load: LinkLoad, spec: LoadSpec, place: PlacedMechanism) -> LinkLoad:
    """A load whose card, if it has one over a travel, is stretched over that of its part."""
    if spec.file is None or spec.over is None or not isinstance(load.law, ByTravel):
        return load
    over, places = spec.over
    geometry = each_changed(lambda part: np.reshape(part, (-1, 1, 1)), place.geometry)
    phase = np.reshape(place.phase, (-1, 1, 1))
    whole = travel_of(lambda phi: _way(load, place, phi + phase, geometry))[:, 0]
    unit = unit_of(places[-1], Dimension.LENGTH if over == "travel" else Dimension.ANGLE)
    stretch = Stretch(load.law.places[:, -1:], whole, unit)
    return load._replace(law=stretched(load.law, stretch), stretch=stretch)


def _way(load: LinkLoad, place: PlacedMechanism, angle: Array, geometry: AnyGeometry) -> LoadWay:
    """Along what a load goes, at angles of its mechanism's crank."""
    motion = place.kind.motion(angle, geometry)
    return load.way(place.kind.dynamics.links(motion, geometry)[load.link])


def is_on_shaft(path: str, spec: LoadSpec, shafts: Container[str]) -> bool:
    """Whether a load is a torque on one of these shafts, which the machine's own table may give."""
    return path == LOAD and spec.force is None and spec.on in shafts


def _named_loads(place: PlacedMechanism, tables: LoadTables) -> dict[str, LoadSpec]:
    """Loads that speak of a mechanism: of two of one name the nearer table's."""
    found: dict[str, LoadSpec] = {}
    for path in reversed(table_paths(place, LOAD)):
        found |= tables.get(path, {})
    return {name: _at_point(place, spec) for name, spec in found.items()}


def _at_point(place: PlacedMechanism, spec: LoadSpec) -> LoadSpec:
    """A load on a point that the mechanism follows, as one on its link there; any other as it is."""
    point = place.spec.points.get(spec.on)
    if point is None or _link_of(place, spec.on) is not None:
        return spec
    return with_lists(spec, {"on": part_name(point.link), "along": point.along, "across": point.across})


def _link_of(place: PlacedMechanism, on: str) -> int | None:
    """Which of what moves in a mechanism is called so; None where nothing is."""
    names = [part_name(name) for name in place.kind.dynamics.moving]
    return names.index(on) if on in names else None


def _link_load(laid: Laid, name: str, spec: LoadSpec, mechanism: int, place: PlacedMechanism) -> LinkLoad:
    """One load on one mechanism."""

    def each(number: Array) -> Array:
        return laid([number])[..., np.newaxis]

    def given(number: Given | None, sign: float = 1.0) -> Array | None:
        return None if number is None else sign * each(number.array)

    link = _link_of(place, spec.on)
    assert link is not None  # only mechanisms that have it are asked
    along, across = given(spec.along), given(spec.across, place.sense)
    # What counts in the sense of rotation changes its sign in the axes of a crank that runs against it.
    turned = place.sense if spec.torque is not None else 1.0
    return LinkLoad(
        name=name,
        mechanism=mechanism,
        link=link,
        is_slider=_slides(place, place.kind.dynamics.moving[link]),
        is_torque=spec.torque is not None,
        resists=spec.sense == "resisting",
        law=law_of(laid, spec, 1.0 if spec.sense == "resisting" else turned),
        stretch=None,
        arm=Vector(each(ZERO) if along is None else along, each(ZERO) if across is None else across),
        counts=1.0 if spec.counts == "with" else -1.0,
        radius=given(spec.radius, place.sense),
        direction=given(spec.direction, place.sense),
    )


def law_of(laid: Laid, spec: LoadSpec, sign: float = 1.0) -> Law:
    """How large a load is, its sizes with a sign; of one whose size is found at 1 rad/s the size 1."""

    def each(numbers: Sequence[Given]) -> Array:
        return laid([number.array for number in numbers])

    scale = sign if spec.factor is None else sign * laid([spec.factor.array])
    size = scale * (each(spec.sizes) if spec.sizes else laid([ONE]))
    if spec.crank_angles is not None:
        return ByAngle(each(spec.crank_angles), size)
    if (travel := spec.travel or spec.swing) is not None:
        return ByTravel(each(travel), size, size if spec.back is None else scale * each(spec.back))
    at = spec.at_speed or spec.at_turning
    power = ZERO if at is None else ONE
    if spec.exponent is not None:
        power = spec.exponent.array
    speed = laid([ONE if at is None else at.array])
    return BySpeed(*(part[..., np.newaxis] for part in (size, speed, laid([power]))))


def _slides(place: PlacedMechanism, name: str) -> bool:
    """Whether what moves is a slider in a guide."""
    return name in (SLIDER, *place.kind.sliders, *_output_slider(place))


def _output_slider(place: PlacedMechanism) -> tuple[str, ...]:
    """The output, where it is a slider of a name of its own."""
    output = getattr(place.spec, "output", SLIDER)
    return (output,) if place.kind.output.is_slider else ()


def load_problems(design: Design) -> Iterator[Problem]:
    """Find loads on what is not there, torques on what does not turn, and forces of no direction."""
    for path, named in design.loads.items():
        own = [place for place in design.places if path in table_paths(place, LOAD)]
        for name, spec in named.items():
            if not is_on_shaft(path, spec, design.shafts):
                shafts = design.shafts if path == LOAD else ()
                yield from judged(_problems_of(f"{path}.{name}", spec, own, shafts))


def _problems_of(
    where: str, spec: LoadSpec, own: Sequence[PlacedMechanism], shafts: Collection[str]
) -> Iterator[Problem]:
    """Find what is wrong with one load on mechanisms."""
    parts = dict.fromkeys(part_name(name) for place in own for name in place.kind.dynamics.moving)
    followed = next((place for place in own if spec.on in place.spec.points), None)
    if spec.on not in parts and followed is None:
        yield _no_part(where, spec, parts, own, shafts)
        return
    if spec.on not in parts:
        beside = _("is for a link; on a point a force acts, and the point says where")
        given = [key for key in ("torque", "radius", *AT_POINT) if getattr(spec, key) is not None]
        yield from (Problem(f"{where}.{key}", None, beside) for key in given)
        if given:
            return
    if spec.is_balanced:
        yield Problem(f"{where}.scale", spec.scale, _("is for a torque on a shaft, such as main"))
        return
    yield from (replace(one, path=f"{where}.{one.path}".rstrip(".")) for one in spec.resisting_problems())
    yield from (spec.in_file(problem, where) for problem in _way_problems(where, spec, own))


def _no_part(
    where: str, spec: LoadSpec, parts: Collection[str], own: Sequence[PlacedMechanism], shafts: Collection[str]
) -> Problem:
    """Say on what a load may be."""
    if spec.on in shafts:
        allowed = _("is a shaft, on which a torque acts; a force acts on a part that moves: {parts}")
        return Problem(f"{where}.on", spec.on, allowed.format(parts=", ".join(parts)))
    points = dict.fromkeys(name for place in own for name in place.spec.points)
    close = nearest(spec.on, (*parts, *points, *shafts))
    said = [_("must be a part that moves: {parts}", parts=", ".join(parts))]
    if points:
        said.append(_("or a point on one: {points}", points=", ".join(points)))
    if shafts:
        said.append(_("or of a torque a shaft: {shafts}", shafts=", ".join(shafts)))
    repair = None if close is None else _("did you mean {name}?", name=close)
    return Problem(f"{where}.on", spec.on, Listed(said, "; "), repair)


def _way_problems(where: str, spec: LoadSpec, places: Sequence[PlacedMechanism]) -> Iterator[Problem]:
    """Find what does not suit a slider, or what turns, and a travel that is not covered."""
    place = next(place for place in places if _link_of(place, _at_point(place, spec).on) is not None)
    spec = _at_point(place, spec)
    index = _link_of(place, spec.on) or 0
    if _slides(place, place.kind.dynamics.moving[index]):
        slides = _("is for what turns, and this slides")
        foreign = [name for name in ("torque", "radius", "swing") if getattr(spec, name) is not None]
        yield from (Problem(f"{where}.{name}", None, slides) for name in foreign)
        if foreign:
            return
        if spec.direction is None:
            at_pin = _("is for a link; without a direction a force on a slider goes through its pin")
            given = ((name, getattr(spec, name)) for name in AT_POINT)
            yield from (Problem(f"{where}.{name}", one.text, at_pin) for name, one in given if one is not None)
    elif _is_force(spec) and spec.radius is None:
        if spec.along is None:
            yield _no_place(where, spec, place)
        if spec.direction is None:
            if spec.sense == "active":
                yield Problem(f"{where}.direction", None, _("is missing; a force on a link needs it, or a radius"))
            if spec.travel is not None:
                yield Problem(f"{where}.travel", None, _("needs a direction or a radius, along which it is counted"))
                return
    if (spec.travel or spec.swing) is not None:
        for own in places:
            if _link_of(own, spec.on) is not None:
                yield from _travel_problems(where, spec, own)


def _is_force(spec: LoadSpec) -> bool:
    """Whether its sizes, or those of its file, are forces."""
    return spec.force is not None or (spec.card is not None and spec.card.sort == "force")


def _no_place(where: str, spec: LoadSpec, place: PlacedMechanism) -> Problem:
    """Say how to tell where on a link a force acts: by the link's line of pins, or by a point that is followed."""
    allowed = _(
        'is missing: where on the {link} the force acts. Write along = "200 mm", from its first pin toward its second'
        ' ("0 mm" is that pin), or put the force on a point: on = "{point}"'
    )
    own = [name for name, point in place.spec.points.items() if part_name(point.link) == spec.on]
    repair = None
    if not own:
        repair = _('declare that by [mechanism.points.{point}] with link = "{link}", along = "200 mm", across = "0 mm"')
        repair = repair.format(point=_POINT, link=spec.on)
    return Problem(f"{where}.along", None, allowed.format(link=spec.on, point=own[0] if own else _POINT), repair)


_POINT = "seat"
"""Name of a point in an example of what to write."""
_AROUND = 73
"""Places around a turn at which links are asked whether they close."""


def _travel_problems(where: str, spec: LoadSpec, place: PlacedMechanism) -> Iterator[Problem]:
    """Find sizes that are not for the whole travel."""
    name, given, dimension = (
        ("travel", spec.travel, Dimension.LENGTH) if spec.swing is None else ("swing", spec.swing, Dimension.ANGLE)
    )
    if (whole := _whole_travel(spec, place)) is None:
        allowed = _("is for what goes to and fro, and this turns all round; list the sizes over crank_angles")
        yield Problem(f"{where}.{name}", None, allowed)
        return
    if not (given and np.isfinite(whole)):  # links that do not close are told as such
        return
    if given[0].si != 0.0:
        yield Problem(f"{where}.{name}[0]", given[0].text, _("must be 0, where the travel begins"))
    is_card, off = spec.file is not None, given[-1].si - whole
    if abs(off) > WIDEST * whole if is_card else off < -_COVERED * whole:
        allowed = _("must go as far as the part goes, {whole}")
        if is_card:
            allowed = _("must go as far as the part goes, {whole}, or within 2 % of that, to be stretched")
        allowed = allowed.format(whole=precise(whole, unit_of(given[-1], dimension)))
        yield Problem(f"{where}.{name}" if is_card else f"{where}.{name}[{len(given) - 1}]", given[-1].text, allowed)


@lru_cache(16)  # of a machine of which another number is set anew the same places are asked again
def _whole_travel(spec: LoadSpec, place: PlacedMechanism) -> float | None:
    """How far a load's point travels over a turn; NaN where links do not close, None of what turns all round."""
    load = _link_load(partial(by_design, n_designs=1), "", spec, 0, place)

    def way(phi: Array) -> LoadWay:
        return _way(load, place, phi + place.phase, place.geometry)

    with np.errstate(invalid="ignore"):
        around = np.ravel(way(np.linspace(0.0, 2 * np.pi, _AROUND)).place)
    if not abs(around[-1] - around[0]) < 1.0:
        return None
    return float(np.ravel(travel_of(way))[0]) if np.all(np.isfinite(around)) else np.nan


def of_member(link: Link, member: int) -> Link:
    """One member's link among those of its kind, shape (design, member, n)."""
    return each_changed(lambda part: part[:, member : member + 1] if np.ndim(part) == 3 else part, link)
