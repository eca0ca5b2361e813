"""Layout: a machine's mechanisms as SI arrays with a leading design axis. Behind it, nothing knows specs or units."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any, ClassVar, TypeVar, cast

import numpy as np
from numpy.typing import NDArray

from cranktrain.engine.places import Place
from cranktrain.language import N_
from cranktrain.mechanisms.kind import Kind, Members, stacked
from cranktrain.motion import Array

Outcome = TypeVar("Outcome", bound=tuple[Any, ...])


@dataclass(frozen=True)
class CrankAngle:
    """The grid of crank angles.

    Attributes
    ----------
    shown : Array, shape (n,)
        As tables and plots count it, from the machine's `crank_zero`. [rad]
    zero : Array, shape (design, 1, 1)
        φ where the shown angle is 0. [rad]
    cycle : float
        2π, or 4π for a four-stroke. [rad]
    """

    shown: Array
    zero: Array
    cycle: float

    @property
    def angle(self) -> Array:
        """φ of every grid point, shape (design, 1, n). [rad]"""
        return self.shown + self.zero

    def counted(self, angle: Array, period: float = 2 * np.pi) -> Array:
        """Count angles φ, shape (design, ..., 1), as they are shown: from `crank_zero`, in [0, period). [rad]"""
        return np.mod(angle - self.zero, period)


@dataclass(frozen=True)
class Group:
    """Mechanisms of one kind among those of a `Mechanisms`: which of its places they take."""

    kind: Kind
    index: NDArray[np.intp]
    members: Members


@dataclass(frozen=True)
class Mechanisms:
    """All mechanisms of a machine, or of several designs of one machine.

    Attributes
    ----------
    names : tuple of str
        `1L`, `2L`, …
    banks : tuple of str
        Bank of each.
    groups : tuple of Group
    nominal_top : Array, shape (design, mechanism, 1)
        φ at which the crank points along the mechanism's own x. [rad]
    """

    dimension: ClassVar[str] = "mechanism"
    needs: ClassVar[str] = ""

    names: tuple[str, ...]
    banks: tuple[str, ...]
    groups: tuple[Group, ...]
    nominal_top: Array

    def evaluated(self, pick: Callable[[Any], Outcome], angle: Array) -> Outcome:
        """Evaluate every mechanism's kernel and pick arrays from its motion.

        Parameters
        ----------
        pick : callable (motion) → NamedTuple of arrays, shape (design, member, n)
        angle : Array, shape (n,), (design, 1, n) or (design, mechanism, n)
            φ, the same for all mechanisms or one for each. [rad]

        Returns
        -------
        NamedTuple of arrays, shape (design, mechanism, n)
        """
        picked: list[tuple[Group, Any]] = []
        for group in self.groups:
            own = angle[:, group.index, :] if angle.ndim == 3 and angle.shape[1] > 1 else angle
            picked.append((group, pick(group.kind.motion(own + group.members.phase, group.members.geometry))))
        first = picked[0][1]
        shape = (first[0].shape[0], len(self.names), first[0].shape[-1])
        columns: list[Array] = []
        for part in range(len(first)):
            column = np.empty(shape)
            for group, values in picked:
                column[:, group.index, :] = values[part]
            columns.append(column)
        return cast(Outcome, type(first)(*columns))


@dataclass(frozen=True)
class Pistons(Mechanisms):
    """The mechanisms whose output is a slider."""

    dimension: ClassVar[str] = "piston"


@dataclass(frozen=True)
class Rockers(Mechanisms):
    """The mechanisms whose output is a rocker."""

    dimension: ClassVar[str] = "rocker"


@dataclass(frozen=True)
class Speed:
    """Speed of the main shaft, constant over the cycle, shape (design, 1, 1). [rad/s]"""

    needs: ClassVar[str] = N_("[shaft.main] speed")

    value: Array


@dataclass(frozen=True)
class Distinct:
    """Those mechanisms of a machine that differ in more than their phase, each at its own crank angle.

    What stands for a whole turn is computed once for each of these and then given to all that are like it.

    Attributes
    ----------
    mechanisms : Mechanisms
        One design; its crank angle counts from each mechanism's own x, so that `nominal_top` is 0.
    origin : array of int, shape (design, mechanism)
        Which of the distinct mechanisms each mechanism is.
    nominal_top : Array, shape (design, mechanism, 1)
        φ at which the crank points along the mechanism's own x. [rad]
    """

    mechanisms: Mechanisms
    origin: NDArray[np.intp]
    nominal_top: Array

    def spread(self, values: Array) -> Array:
        """Give values of the distinct mechanisms, shape (1, distinct, ...), to all, shape (design, mechanism, ...)."""
        return values[0][self.origin]

    def angle(self, own: Array) -> Array:
        """Give own crank angles, shape (1, distinct, 1), as φ of every mechanism, shape (design, mechanism, 1)."""
        return self.spread(own) + self.nominal_top


def distinct(mechanisms: Mechanisms) -> Distinct:
    """Find the mechanisms that differ in more than their phase."""
    origin = np.empty(mechanisms.nominal_top.shape[:2], dtype=np.intp)
    groups: list[Group] = []
    names: list[str] = []
    for group in mechanisms.groups:
        members = group.members
        lead = members.phase + mechanisms.nominal_top[:, group.index]
        columns = [value.ravel() for value in (lead, *_flat(members.geometry))]
        _rows, first, inverse = np.unique(np.stack(columns), axis=1, return_index=True, return_inverse=True)
        origin[:, group.index] = len(names) + inverse.reshape(lead.shape[:2])
        own = replace(
            members,
            names=tuple(members.names[int(row) % len(members.names)] for row in first),
            geometry=_rows_of(members.geometry, first),
            phase=lead.reshape(1, -1, 1)[:, first],
        )
        groups.append(Group(group.kind, np.arange(len(names), len(names) + len(first)), own))
        names += own.names
    one = Mechanisms(tuple(names), tuple(names), tuple(groups), np.zeros((1, len(names), 1)))
    return Distinct(one, origin, mechanisms.nominal_top)


def _flat(geometry: Any) -> list[Array]:
    """List all arrays of a nested geometry, in order."""
    return [array for value in geometry for array in (_flat(value) if isinstance(value, tuple) else [value])]


def _rows_of(geometry: Any, rows: NDArray[np.intp]) -> Any:
    """Take the geometry of some of its (design, member) pairs, shape (1, row, 1)."""
    return geometry._replace(
        **{
            name: _rows_of(value, rows) if isinstance(value, tuple) else value.reshape(1, -1, 1)[:, rows]
            for name, value in geometry._asdict().items()
        }
    )


MechanismsLike = TypeVar("MechanismsLike", bound=Mechanisms)


def mechanisms_of(result: type[MechanismsLike], designs: Sequence[Sequence[Place]]) -> MechanismsLike:
    """Stack the places of several designs of one machine, [design][place], by kind."""
    first = designs[0]
    groups: list[Group] = []
    for kind in dict.fromkeys(place.kind.name for place in first):
        index = [i for i, place in enumerate(first) if place.kind.name == kind]
        chosen = first[index[0]].kind
        members = chosen.members(
            names=tuple(first[i].name for i in index),
            geometry=stacked([[design[i].geometry for i in index] for design in designs]),
            phase=np.array([[[design[i].phase] for i in index] for design in designs]),
        )
        groups.append(Group(chosen, np.array(index, dtype=np.intp), members))
    return result(
        names=tuple(place.name for place in first),
        banks=tuple(place.bank for place in first),
        groups=tuple(groups),
        nominal_top=np.array([[[place.nominal_top] for place in design] for design in designs]),
    )
