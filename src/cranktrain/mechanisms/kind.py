"""What every kind of mechanism gives: its spec, geometry, kernel, drawing, and the lengths that let it close."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from functools import reduce
from typing import Any, ClassVar, Literal, NamedTuple, TypeVar, cast

import numpy as np
from numpy.typing import NDArray
from pydantic import Field

from cranktrain.language import N_
from cranktrain.motion import Array, Coefficient, Link, Point
from cranktrain.numerics import Extreme
from cranktrain.quantities import Length
from cranktrain.record import record
from cranktrain.spec import Spec

LISTS = frozenset({"part"})
"""Fields of a mechanism that are lists by themselves, and not one value for each angle of a bank."""

Geometry = TypeVar("Geometry", bound=tuple[Any, ...])

_MIRRORED = frozenset(
    {
        *("offset", "shift", "y", "articulation_angle", "bank_angle", "slot_angle", "direction", "ahead", "side"),
        *("across", "moment"),
    }
)
"""What changes sign when the mechanism's y is mirrored: what counts toward +y or in the sense of rotation."""


class LinkPointSpec(Spec, frozen=True):
    """A point fixed on a link, to be followed: `link`, how far `along` it from its first pin, how far `across`."""

    link: str = Field(description=N_("The link that carries the point."))
    along: Length = Field(description=N_("Distance from the link's first pin toward its second."))
    across: Length = Field(
        description=N_("Distance from the line of pins, to the side turned 90° from it in the sense of rotation.")
    )


class MechanismSpec(Spec, frozen=True):
    """What every mechanism of a machine file may declare."""

    kind: str = Field(description=N_("Kind of mechanism."))
    points: Mapping[str, LinkPointSpec] = Field(default={}, description=N_("Points on links to follow, by name."))

    master_field: ClassVar[str | None] = None
    """Field that names the bank whose slider-crank, on the same throw, this mechanism hangs on."""

    @property
    def rod_field(self) -> str:
        """Name of the field that says how long the rod is: what to change where links cannot close."""
        return "rod_length"


class Master(NamedTuple):
    """What a slave mechanism hangs on: the master's geometry, and the slave's axis ahead of the master's. [rad]"""

    geometry: Any
    bank_angle: float


class DrawnLink(NamedTuple):
    """A link to draw: its name and the names of its pins, in order."""

    name: str
    pins: tuple[str, ...]


class Guide(NamedTuple):
    """A straight guide to draw: the pin that slides in it, and the guide's direction from x. [rad]"""

    pin: str
    direction: Array


class Block(NamedTuple):
    """A sliding contact: a pin that slides along a link, and that link's pins; one pin of a link that never turns."""

    pin: str
    link: tuple[str, ...]


@record
class Drawing:
    """A mechanism to draw: how its pins move, in its own axes, and what joins them.

    Attributes
    ----------
    pins : mapping of name to Point
        Coefficients of shape (..., n); a point that stands still may have (..., 1) or none. [m, m/rad, m/rad²]
    links : sequence of DrawnLink
        The crank first; every link after those that hold its first pin.
    guides : sequence of Guide
        The output's first.
    fixed : sequence of str
        Pins that stand still.
    paths : sequence of str
        Pins whose path is worth drawing.
    blocks : sequence of Block
    ends : sequence of str
        Pins that only show how far a link reaches, where no length of the geometry says it: no plan speaks of them.
    """

    pins: Mapping[str, Point]
    links: Sequence[DrawnLink]
    guides: Sequence[Guide]
    fixed: Sequence[str]
    paths: Sequence[str]
    blocks: Sequence[Block] = ()
    ends: Sequence[str] = ()

    @property
    def positions(self) -> dict[str, Array]:
        """Where the pins are, by name: x and y, shape (2, ..., n), of all pins alike."""
        shape = np.broadcast_shapes(*(np.shape(part.value) for pin in self.pins.values() for part in pin))
        return {name: np.stack([np.broadcast_to(part.value, shape) for part in pin]) for name, pin in self.pins.items()}

    def scaled(self, factor: float) -> "Drawing":
        """Give the same drawing in another unit of length."""
        pins = {name: Point(*(_times(part, factor) for part in pin)) for name, pin in self.pins.items()}
        return replace(self, pins=pins)


def _times(part: Coefficient, factor: float) -> Coefficient:
    return Coefficient(*(factor * value for value in part))


Role = Literal["main_bearing", "crank_pin", "knuckle_pin", "piston_pin", "guide", "slot", "pivot", "pin"]
"""What a joint is to its mechanism, whatever it is called.

The bearing of the crank; what has its bearing on the crank pin; a slave's rod on its master's; the rod in the piston,
crosshead or slider; a slider in its guide; a block in a slot; a link's bearing in the frame; any other pin. A chain has
neither crank pin nor piston pin: of its several each is as good.
"""


class Reaction(NamedTuple):
    """A joint's reaction: its name, the two bodies, of which the wrench is `by` one `on` the other, and its role."""

    name: str
    on: str
    by: str
    role: Role


class Contact(NamedTuple):
    """Where something slides: the joint that bears its friction, and the drawing's pin at which that acts.

    bears_moment: whether it is a guide, and not a slot about a block; way: −1 where what slides counts its position
    against its link's direction.
    """

    joint: str
    pin: str
    bears_moment: bool = True
    way: float = 1.0


class Across(NamedTuple):
    """An outer joint of a group whose force has a part that moments give: its part across a link.

    joint; link, along and across whose direction the force is split; the pin about which the moments are taken.
    """

    joint: str
    link: str
    about: str


class Group(NamedTuple):
    """An Assur group: its sort by its joints, such as `RRP`; its links; what of its outer reactions moments give."""

    sort: str
    links: tuple[str, ...]
    across: tuple[Across, ...] = ()


FRAME = "frame"
"""What stands still, as one of a joint's two bodies."""


@record
class Dynamics:
    """What forces a kind of mechanism gives; every function is a kernel.

    Attributes
    ----------
    bodies : callable (*Body) → what `forces` takes as bodies
    moving : tuple of str
        What has mass and bears loads, in the order in which `forces` takes bodies and loads.
    reactions : tuple of Reaction
        In the order in which `forces` gives them.
    sliding : tuple of str
        What may have friction, in the order in which `Conditions` has it. The sense of each is the sign of its
        coordinate's velocity.
    contacts : tuple of Contact
        Where it slides, in that order.
    groups : tuple of Group
        What hangs on the crank, each after those that carry it.
    links : kernel (motion, geometry) → tuple of Link
        In the order of `moving`, in the mechanism's axes.
    load : kernel (motion, geometry, value) → wrenches
        Load on each of `moving` for a force along the output slider's coordinate, or a torque on the output link, or
        of whichever else has to bear its counterpart. [N or N·m]
    forces : kernel (motion, geometry, bodies, loads, conditions) → Forces
        bodies and loads as `moving` has them; `Forces` has the joints' wrenches, as `reactions` has them, the driving
        torque by them, and that of friction.
    reduced : kernel (motion, geometry, bodies, loads, gravity) → Reduced
        What an equation of motion needs: reduced inertia, its derivative, and the loads' torque on the crank.
    on_master : kernel (motion, geometry, wrench) → Wrench, optional
        Of a mechanism that hangs on another's rod: what it does to that rod, from the reaction in its knuckle pin.
    """

    bodies: Callable[..., Any]
    moving: tuple[str, ...]
    reactions: tuple[Reaction, ...]
    sliding: tuple[str, ...]
    contacts: tuple[Contact, ...]
    groups: tuple[Group, ...]
    links: Callable[[Any, Any], tuple[Link, ...]]
    load: Callable[[Any, Any, Array], Any]
    forces: Callable[[Any, Any, Any, Any, Any], Any]
    reduced: Callable[[Any, Any, Any, Any, Any], Any]
    on_master: Callable[[Any, Any, Any], Any] | None = None

    def joint(self, role: Role) -> int | None:
        """Place among `reactions` of the first of the mechanism's own joints that has a role; None without one."""
        return self._place(role, is_own=True)

    def share_of_masters(self, role: Role) -> int | None:
        """Place among `reactions` of a slave's share of that joint of its master's; None without one."""
        return self._place(role, is_own=False)

    def _place(self, role: Role, *, is_own: bool) -> int | None:
        places = (
            place
            for place, reaction in enumerate(self.reactions)
            if reaction.role == role and (reaction.on in self.moving) is is_own
        )
        return next(places, None)


@record
class Members:
    """The mechanisms of one kind in a machine: their names and geometry.

    A kind whose stage asks for its members subclasses this, so that the stage's need is a type of its own.

    Attributes
    ----------
    names : tuple of str
    geometry : NamedTuple of arrays, shape (design, member, 1)
    phase : Array, shape (design, member, 1)
        Angle of the mechanism's crank when the machine's crank angle φ is 0. [rad]
    """

    names: tuple[str, ...]
    geometry: Any
    phase: Array


@record
class Kind:
    """A kind of mechanism, as data.

    Attributes
    ----------
    name, title : str
        Name in the machine file; title for people.
    spec : type of MechanismSpec
        Its table of the machine file.
    geometry : callable (spec, master or None) → NamedTuple of floats
        SI geometry of the kernel.
    motion : kernel (angle, geometry) → NamedTuple
        Has `slider` or `rocker`, as `output` says, and the links in `links`.
    gap : kernel (angle, geometry) → Array
        By how much the links can close. [m]
    lengths : tuple of str
        Geometry fields that are lengths; of the slave alone, where there is a master.
    output : "slider" or "rocker"
        What load and gas act on.
    has_rod : bool
        Whether the output hangs on a link `rod`, whose motion is then a result.
    links : tuple of str
        Links that can carry points. Those that are neither output nor rod are followed as results by their names.
    drawing : callable (angle, geometry) → Drawing
    closing_advice : callable (geometry) → str
        What would let links close that cannot, as a clause: "rod_length must be more than 100 mm".
    members : type of Members
        What the kind's own stages ask for.
    stages : tuple of stages
        The kind's own results; see cranktrain.analysis.
    dynamics : Dynamics
        What forces act.
    example : str
        A commented `[mechanism]` table to start from.
    sliders : tuple of str
        What else slides, along a link or guide; followed as results by their names.
    joints : tuple of str
        Points of the motion that are followed as results by their names.
    part : callable (motion, name) → Link, Coefficient or Point
        Finds links, sliders and joints in the motion.
    length_paths : tuple of str
        Where `lengths` stand in the mechanism's table, where they are not the same.
    composed : callable (spec) → Kind, optional
        For a kind whose file says what the mechanism is made of: the kind of just this one.
    closing_field : callable (geometry) → str, optional
        Path in the mechanism's table of what cannot close; unless given, the spec's `rod_field`.
    least_gap : callable (geometry) → Extreme, optional
        The least gap over a turn in closed form, for a kind of whose gap every length takes as much as it changes.
    openings : callable (geometry) → Openings, optional
        Finds what `closing_margin` looks for; for a kind whose gap has to be walked for.
    has_chambers : bool
        Whether its slider is a piston, which can have a cylinder, and not a valve.
    """

    name: str
    title: str
    spec: type[MechanismSpec]
    geometry: Callable[[Any, Master | None], Any]
    motion: Callable[[Array, Any], Any]
    gap: Callable[[Array, Any], Array]
    lengths: tuple[str, ...]
    output: Literal["slider", "rocker"]
    has_rod: bool
    links: tuple[str, ...]
    drawing: Callable[[Array, Any], Drawing]
    closing_advice: Callable[[Any], str]
    members: type[Members]
    stages: tuple[Callable[..., object], ...]
    dynamics: Dynamics
    example: str
    sliders: tuple[str, ...] = ()
    joints: tuple[str, ...] = ()
    part: Callable[[Any, str], Any] = getattr
    length_paths: tuple[str, ...] = ()
    composed: "Callable[[Any], Kind] | None" = None
    closing_field: Callable[[Any], str] | None = None
    least_gap: Callable[[Any], Extreme] | None = None
    openings: Callable[[Any], Any] | None = None
    has_chambers: bool = True

    @property
    def followed_links(self) -> tuple[str, ...]:
        """Links that are followed by their names: those whose motion no other result gives."""
        return tuple(link for link in self.links if link != self.output and not (self.has_rod and link == "rod"))

    @property
    def length_names(self) -> tuple[str, ...]:
        """What `lengths` are called."""
        return self.length_paths or self.lengths


def mirrored(geometry: Geometry) -> Geometry:
    """Give geometry, bodies or loads seen with y reversed, as a machine that runs astern sees the same metal."""

    def change(name: str, value: Any) -> Any:
        if isinstance(value, tuple):
            return mirrored(cast(tuple[Any, ...], value))
        return -value if name in _MIRRORED else value

    return _rebuilt(geometry, change)


def _rebuilt(geometry: Geometry, change: Callable[[str, Any], Any]) -> Geometry:
    """Change each part of a geometry by its name, or of a plain tuple by its place."""
    named = cast(Any, geometry)
    if hasattr(named, "_fields"):
        return named._make(map(change, named._fields, named))
    return cast(Geometry, tuple(map(change, map(str, range(len(named))), named)))


def _part(geometry: Any, name: str) -> Any:
    """Give one part by its name, or of a plain tuple by its place."""
    return getattr(geometry, name) if hasattr(geometry, "_fields") else geometry[int(name)]


def stacked(geometries: Sequence[Sequence[Geometry]]) -> Geometry:
    """Stack geometries [design][member] of floats into one of arrays, shape (design, member, 1)."""
    numbers = np.array([[leaves(member) for member in design] for design in geometries], dtype=float)
    columns = iter(np.ascontiguousarray(np.moveaxis(numbers, -1, 0))[..., np.newaxis])

    def column(_name: str, value: Any) -> Any:
        return _rebuilt(cast(tuple[Any, ...], value), column) if isinstance(value, tuple) else next(columns)

    return _rebuilt(geometries[0][0], column)


def named_part(geometry: Any, name: str) -> Array:
    """Give one part of a nested geometry by its dotted name."""
    return reduce(_part, name.split("."), geometry)


def scaled(geometry: Geometry, length: str, factor: Array) -> Geometry:
    """Give the geometry with one length, named by its dotted path, multiplied by a factor."""
    path, _, rest = length.partition(".")

    def change(name: str, value: Any) -> Any:
        if name != path:
            return value
        return scaled(value, rest, factor) if rest else value * factor

    return _rebuilt(geometry, change)


def leaves(geometry: tuple[Any, ...]) -> list[Array]:
    """List all arrays of a nested geometry, in order."""
    return [
        array
        for value in geometry
        for array in (leaves(cast(tuple[Any, ...], value)) if isinstance(value, tuple) else [cast(Array, value)])
    ]


def rows(geometry: Geometry, index: NDArray[np.intp]) -> Geometry:
    """Take some of a geometry's mechanisms, counted through all its axes: arrays of shape (*index.shape, 1)."""

    def chosen(_name: str, value: Any) -> Any:
        if isinstance(value, tuple):
            return rows(cast(tuple[Any, ...], value), index)
        return value.reshape(-1, 1)[index]

    return _rebuilt(geometry, chosen)
