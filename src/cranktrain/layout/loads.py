"""Loads of a machine file, put to the links of its mechanisms as SI arrays; and what is wrong with them."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.errors import Problem
from cranktrain.language import _
from cranktrain.layout.design import Designs
from cranktrain.layout.load_tables import LoadSpec, LoadTables
from cranktrain.layout.part_tables import SLIDER, part_name, table_paths
from cranktrain.layout.places import PlacedMechanism
from cranktrain.linkage.forces.load import Way, across_link, along_link, pushing, turning, with_motion
from cranktrain.linkage.vectors import Vector, Wrench
from cranktrain.motion import ONE, ZERO, Array, Link
from cranktrain.numerics.nested import mapped
from cranktrain.quantities import Given, nearest
from cranktrain.record import record

_TABLE = "load"


class LinkLoad(NamedTuple):
    """One load on one link of one mechanism.

    Attributes
    ----------
    name : str
        Of the load; with several mechanisms `1L.cut`.
    mechanism, link : int
        Whose it is, and which of what moves there.
    is_slider, is_torque, resists : bool
    size : Array, shape (design, 1, 1)
        At the speed `at`. [N or N·m]
    at, exponent : Array, shape (design, 1, 1)
        Speed at which it has its size [m/s or rad/s]; the power of the speed with which it goes: 0 of a constant one.
    place : Vector of arrays of that shape, or None
        On the link. [m]
    radius, direction : Array of that shape, or None
        Arm about the link's first pin [m]; in the mechanism's axes [rad].
    """

    name: str
    mechanism: int
    link: int
    is_slider: bool
    is_torque: bool
    resists: bool
    size: Array
    at: Array
    exponent: Array
    place: Vector
    radius: Array | None
    direction: Array | None

    def way(self, link: Link) -> Way:
        """What it goes along."""
        if self.is_torque:
            return turning(link)
        if self.radius is not None:
            return across_link(link, self.radius)
        if self.direction is not None:
            return pushing(link, self.place, self.direction)
        return along_link(link) if self.is_slider else with_motion(link, self.place)

    def value(self, way: Way, speed: Array) -> Array:
        """Its size along its way at a crank's speed; against the motion of what it resists. [N or N·m]"""
        goes = way.rate * speed
        size = self.size * (np.abs(goes) / self.at) ** self.exponent
        return -np.sign(goes) * size if self.resists else size


@record
class Loads:
    """Loads of a machine, on whatever they act."""

    each: tuple[LinkLoad, ...]

    @property
    def names(self) -> tuple[str, ...]:
        """What they are called."""
        return tuple(load.name for load in self.each)

    def of(self, mechanism: int) -> list[LinkLoad]:
        """Those on one mechanism."""
        return [load for load in self.each if load.mechanism == mechanism]


def loads_of(designs: Designs) -> Loads | None:
    """Put the loads of the file to the mechanisms; None where it has none."""
    tables = designs.together.loads
    if not tables:
        return None
    found = [
        _link_load(designs, name, spec, i, place)
        for path, named in tables.items()
        for name, spec in named.items()
        for i, place in enumerate(designs.places)
        if path in table_paths(place, _TABLE) and _link_of(place, spec.on) is not None
    ]
    return Loads(tuple(found))


def _link_of(place: PlacedMechanism, on: str) -> int | None:
    """Which of what moves in a mechanism is called so; None where nothing is."""
    names = [part_name(name) for name in place.kind.dynamics.moving]
    return names.index(on) if on in names else None


def _link_load(designs: Designs, name: str, spec: LoadSpec, mechanism: int, place: PlacedMechanism) -> LinkLoad:
    """One load on one mechanism."""

    def each(number: Array) -> Array:
        return designs.by_design([number])[..., np.newaxis]

    def given(number: Given | None, sign: float = 1.0) -> Array | None:
        return None if number is None else sign * each(number.array)

    link = _link_of(place, spec.on)
    assert link is not None  # only mechanisms that have it are asked
    size, at = spec.force or spec.torque, spec.at_speed or spec.at_turning
    assert size is not None  # the spec asks for one of the two
    # What counts in the sense of rotation changes its sign in the axes of a crank that runs against it.
    turned = place.sense if spec.torque is not None or spec.radius is not None else 1.0
    exponent = ONE if spec.exponent is None else spec.exponent.array
    along, across = given(spec.along), given(spec.across, place.sense)
    return LinkLoad(
        name=name if len(designs.places) == 1 else f"{place.name}.{name}",
        mechanism=mechanism,
        link=link,
        is_slider=place.kind.dynamics.moving[link] in (SLIDER, *place.kind.sliders, *_output_slider(place)),
        is_torque=spec.torque is not None,
        resists=spec.sense == "resisting",
        size=each((1.0 if spec.sense == "resisting" else turned) * size.array),
        at=each(ONE if at is None else at.array),
        exponent=each(ZERO if at is None else exponent),
        place=Vector(each(ZERO) if along is None else along, each(ZERO) if across is None else across),
        radius=given(spec.radius),
        direction=given(spec.direction, place.sense),
    )


def _output_slider(place: PlacedMechanism) -> tuple[str, ...]:
    """The output, where it is a slider of a name of its own."""
    output = getattr(place.spec, "output", SLIDER)
    return (output,) if place.kind.output == "slider" else ()


def load_problems(places: Sequence[PlacedMechanism], tables: LoadTables) -> Iterator[Problem]:
    """Find loads on what is not there, torques on what does not turn, and forces of no direction."""
    for path, named in tables.items():
        own = [place for place in places if path in table_paths(place, _TABLE)]
        parts = dict.fromkeys(part_name(name) for place in own for name in place.kind.dynamics.moving)
        for name, spec in named.items():
            where = f"{path}.{name}"
            if spec.on not in parts:
                close = nearest(spec.on, parts)
                allowed = _("must be a part that moves: {parts}").format(parts=", ".join(parts))
                repair = None if close is None else _("did you mean {name}?").format(name=close)
                yield Problem(f"{where}.on", spec.on, allowed, repair)
                continue
            sliders = {
                part_name(slider) for place in own for slider in (SLIDER, *place.kind.sliders, *_output_slider(place))
            }
            if spec.on in sliders and spec.torque is not None:
                yield Problem(
                    f"{where}.torque", spec.torque.text, _("is for what turns, and this slides: give a force")
                )
            if spec.on in sliders and spec.radius is not None:
                yield Problem(f"{where}.radius", spec.radius.text, _("is for what turns, and this slides"))
            lacks_way = spec.force is not None and spec.direction is None and spec.radius is None
            if spec.on not in sliders and spec.sense == "active" and lacks_way:
                yield Problem(f"{where}.direction", None, _("is missing; a force on a link needs it, or a radius"))


def loaded(loads: Loads, index: NDArray[np.intp], links: Sequence[Link], speed: Array) -> dict[int, Wrench]:
    """What loads do to the links of some mechanisms.

    Parameters
    ----------
    loads : Loads
    index : array of int, shape (member,)
        Which mechanisms.
    links : sequence of Link, coefficients of shape (design, member, n)
    speed : Array, shape (design, 1, 1) or (design, member, n)
        Of their cranks. [rad/s]

    Returns
    -------
    dict
        By the place of the link: Wrench of shape (design, member, n), about the link's first pin.
    """
    found: dict[int, Wrench] = {}
    for member, mechanism in enumerate(index.tolist()):
        for load in loads.of(mechanism):
            way = load.way(_of_member(links[load.link], member))
            value = load.value(way, speed[:, member : member + 1] if speed.shape[1] > 1 else speed)
            parts = np.broadcast_arrays(*(value * part for part in way.unit))
            n_designs, _one, n_angles = parts[0].shape
            nothing = Wrench(*np.zeros((3, n_designs, len(index), n_angles)))
            for whole, part in zip(found.setdefault(load.link, nothing), parts, strict=True):
                whole[:, member : member + 1] += part
    return found


def _of_member(link: Link, member: int) -> Link:
    """One member's link."""
    return mapped(lambda _name, part: part[:, member : member + 1] if np.ndim(part) == 3 else part, link)
