"""What every kind of mechanism gives: its spec, geometry, kernel, drawing, and the lengths that let it close."""

from collections.abc import Callable, Iterable, Sequence
from functools import cache, reduce
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar, Generic, NamedTuple, TypeAlias, TypeVar, cast, get_type_hints

import numpy as np
from numpy.typing import NDArray

from cranktrain.folders import member_named
from cranktrain.language import Words
from cranktrain.mechanisms.by_hand import Addition, Handle
from cranktrain.mechanisms.drawing import Drawing
from cranktrain.mechanisms.dynamics import Dynamics
from cranktrain.mechanisms.output import OutputPart
from cranktrain.mechanisms.spec import Master, MechanismSpec
from cranktrain.motion import Array, Handed
from cranktrain.numerics import Extreme
from cranktrain.numerics.nested import each_changed
from cranktrain.record import record
from cranktrain.saying.rows import AnswerLine

if TYPE_CHECKING:
    from cranktrain.mechanisms.change_points import ChangePoints

Motion = TypeVar("Motion", bound=tuple[object, ...])

Geometry = TypeVar("Geometry", bound=tuple[object, ...])


@record
class Members(Generic[Geometry]):
    """The mechanisms of one kind in a machine: their names and geometry.

    A kind whose stage asks for its members subclasses this, so that the stage's need is a type of its own.

    Attributes
    ----------
    names : tuple of str
    geometry : NamedTuple of arrays, shape (design, member, 1)
    phase : Array, shape (design, member, 1)
        Angle of the mechanism's crank when the machine's crank angle φ is 0. [rad]
    """

    reads: ClassVar[tuple[str, ...]] = ("[mechanism]", "[bank.NAME]", "[shaft.NAME]")

    names: tuple[str, ...]
    geometry: Geometry
    phase: Array


class Openings(NamedTuple):
    """Changes of one length that open the links of some mechanisms, with the least of each mechanism; one axis.

    row: which mechanism, length: index of the length, change: relative [1], angle: of the mechanism's crank [rad].
    """

    row: NDArray[np.intp]
    length: NDArray[np.intp]
    change: Array
    angle: Array


@record
class Kind(Generic[Motion, Geometry]):
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
        Has the part that is the output, and the links in `links`.
    gap : kernel (angle, geometry) → Array
        By how much the links can close. [m]
    lengths : tuple of str
        Geometry fields that are lengths; of the slave alone, where there is a master.
    output : OutputPart
        What load and gas act on.
    has_rod : bool
        Whether the output hangs on a link `rod`, whose motion is then a result.
    links : tuple of str
        Links that can carry points. Those that are neither output nor rod are followed as results by their names.
    drawing : callable (angle, geometry) → Drawing
    closing_advice : callable (geometry) → Words, or sequence of ClosingPart
        What would let links close that cannot, as a clause: "rod_length must be more than 100 mm"; or for a mechanism
        of several parts, each of which may not close at angles of its own, what is to be said of each.
    members : type of Members
        What the kind's own stages ask for.
    stages : tuple of stages
        The kind's own results; see cranktrain.analysis.
    dynamics : Dynamics
        What forces act.
    example : str
        A commented `[mechanism]` table to start from.
    speed : str
        At which a machine of the example's size turns.
    tables : Path, optional
        File with the tables that suit it, as they follow in a new machine file, most behind comment marks.
    sliders : tuple of str
        What else slides, along a link or guide; followed as results by their names.
    joints : tuple of str
        Points of the motion that are followed as results by their names.
    named : callable (motion, name) → Link, Coefficient or Point
        Finds links, sliders and joints in the motion.
    length_paths : tuple of str
        Where `lengths` stand in the mechanism's table, where they are not the same.
    structure_of : callable (spec) → structure, optional
        For a kind whose file says what the mechanism is made of: that.
    of_structure : callable (structure) → Kind, optional
        The kind of just such mechanisms.
    structure : object
        Of which it is one; None of a kind that no file composes.
    closing_field : str, or callable (spec, geometry) → str
        Path in the mechanism's table of what to change where links cannot close; of the rod, unless there is none.
    least_gap : callable (geometry) → Extreme, optional
        The least gap over a turn in closed form, for a kind of whose gap every length takes as much as it changes.
    openings : callable (geometry) → Openings, optional
        Finds what `closing_margin` looks for; for a kind whose gap has to be walked for.
    change_points : ChangePoints, optional
        Of mechanisms whose links lie in line at some angles and come through: where. Their forces there are limits.
    direct_ratio : callable (geometry) → Array, optional
        For a kind whose rod joins a piston and the crank pin itself: λ of the textbooks, NaN with an offset. What they
        say of λ, of P·f(β) and of two harmonics is said of it, and slaves may hang on its rod.
    is_slave : bool
        Whether its rod hangs on the rod of a mechanism that is direct.
    is_outlined : bool
        Whether throws are drawn with its links in outline, as an engine's, and not as lines.
    has_own_pin : bool
        Whether its crank is one of its own beside the throw, as an eccentric is, and not the throw itself.
    rows : tuple of callable (of, …) → rows
        What its own results say in the answer; see `Question`.
    handles : tuple of Handle
        Pins of the drawing by which its numbers may be changed.
    additions : tuple of Addition
        Parts that may be added to it by clicks on the drawing.
    """

    name: str
    title: str
    spec: type[MechanismSpec]
    geometry: Callable[[Any, Master | None], Geometry]
    motion: Callable[[Array, Geometry], Motion]
    gap: Callable[[Array, Geometry], Array]
    lengths: tuple[str, ...]
    output: OutputPart
    has_rod: bool
    links: tuple[str, ...]
    drawing: Callable[[Array, Geometry], Drawing]
    closing_advice: "Callable[[Geometry], Words | Sequence[ClosingPart]]"
    members: type[Members[Geometry]]
    stages: tuple[Callable[..., object], ...]
    dynamics: Dynamics[Motion, Geometry]
    example: str
    speed: str
    tables: Path | None = None
    sliders: tuple[str, ...] = ()
    joints: tuple[str, ...] = ()
    named: Callable[[Motion, str], Any] = getattr
    length_paths: tuple[str, ...] = ()
    structure_of: Callable[[Any], Any] | None = None
    of_structure: "Callable[[Any], Kind[Any, Any]] | None" = None
    structure: object = None
    closing_field: str | Callable[[Any, Geometry], str] = "rod_length"
    least_gap: Callable[[Geometry], Extreme] | None = None
    openings: Callable[[Geometry], Openings] | None = None
    change_points: "ChangePoints | None" = None
    direct_ratio: Callable[[Geometry], Array] | None = None
    is_slave: bool = False
    is_outlined: bool = False
    has_own_pin: bool = False
    rows: tuple[Callable[..., Iterable[AnswerLine]], ...] = ()
    handles: tuple[Handle, ...] = ()
    additions: tuple[Addition, ...] = ()

    def __reduce__(self) -> tuple[Callable[..., Any], tuple[object, ...]]:
        """Give what finds it again by its name, and of what it is made."""
        return _found_again, (self.name, self.structure)

    @property
    def is_direct(self) -> bool:
        """Whether its rod joins a piston and the crank pin itself."""
        return self.direct_ratio is not None

    @property
    def followed_links(self) -> tuple[str, ...]:
        """Links that are followed by their names: those whose motion no other result gives."""
        return tuple(link for link in self.links if link != self.output.part and not (self.has_rod and link == "rod"))

    @property
    def length_names(self) -> tuple[str, ...]:
        """What `lengths` are called."""
        return self.length_paths or self.lengths


def _found_again(name: str, structure: object) -> "AnyKind":
    """Find a kind by its name; one that a file composed by its structure."""
    kind: Kind[Any, Any] = member_named("cranktrain.mechanisms", "KIND", name)
    return kind if structure is None or kind.of_structure is None else kind.of_structure(structure)


class ClosingPart(NamedTuple):
    """A part that may not close: its path in the mechanism's table, what it makes, what is said, its gap. [m]"""

    field: str
    name: str
    advice: Words
    gap: Callable[[Array], Array]


AnyKind: TypeAlias = Kind[Any, Any]
"""A kind that is known only when it runs."""

AnyMotion: TypeAlias = Any
"""Motion of such a kind: has what the kind's `output`, `has_rod` and `part` say."""

AnyGeometry: TypeAlias = Any
"""Geometry of such a kind."""


def mirrored(geometry: Geometry) -> Geometry:
    """Give geometry seen with y reversed, as a machine that runs astern sees the same metal: `Handed` parts negated."""
    handed = handed_fields(type(geometry))
    names = cast("tuple[str, ...]", getattr(geometry, "_fields", ())) or ("",) * len(geometry)
    make = cast("Callable[[Iterable[object]], Geometry]", getattr(geometry, "_make", tuple))
    return make(
        mirrored(cast("tuple[object, ...]", part))
        if isinstance(part, tuple)
        else -cast(Array, part)
        if name in handed
        else part
        for name, part in zip(names, geometry, strict=True)
    )


@cache
def handed_fields(kind: type[tuple[object, ...]]) -> frozenset[str]:
    """Names of the fields of a geometry that are `Handed`."""
    hints = get_type_hints(kind, include_extras=True)
    return frozenset(name for name, hint in hints.items() if hint == Handed)


def named_part(geometry: tuple[object, ...], name: str) -> Array:
    """Give one part of a nested geometry by its dotted name."""
    return cast(Array, reduce(_part, name.split("."), cast(object, geometry)))


def _part(geometry: object, name: str) -> object:
    """Give one part by its name, or of a plain tuple by its place."""
    return cast("tuple[object, ...]", geometry)[int(name)] if name.isdecimal() else getattr(geometry, name)


def rows(geometry: Geometry, index: NDArray[np.intp]) -> Geometry:
    """Take some of a geometry's mechanisms, counted through all its axes: arrays of shape (*index.shape, 1)."""
    return each_changed(lambda value: value.reshape(-1, 1)[index], geometry)
