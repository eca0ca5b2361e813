"""A machine's mechanisms as SI arrays with a leading design axis; and those that differ, each computed once."""

from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import cached_property
from typing import Any, ClassVar, TypeVar

import numpy as np
from numpy.typing import NDArray

from cranktrain.grouping import places_of_equal
from cranktrain.layout.places import PlacedMechanism
from cranktrain.linkage import in_blocks
from cranktrain.mechanisms.kind import AnyGeometry, AnyKind, AnyMotion, Members, rows
from cranktrain.mechanisms.output import OutputPart
from cranktrain.motion import Array
from cranktrain.numerics.designs import by_design
from cranktrain.numerics.nested import leaves, side_by_side
from cranktrain.record import record

Outcome = TypeVar("Outcome", bound=tuple[object, ...])
Found = TypeVar("Found")


@record
class Batch:
    """Mechanisms of one kind among those of a `Mechanisms`: which of its places they take."""

    kind: AnyKind
    index: NDArray[np.intp]
    members: Members[AnyGeometry]


@record
class Mechanisms:
    """All mechanisms of a machine, or of several designs of one machine.

    Attributes
    ----------
    names : tuple of str
        `1L`, `2L`, …
    banks : tuple of str
        Bank of each.
    batches : tuple of Batch
    nominal_top : Array, shape (design, mechanism, 1)
        φ at which the crank points along the mechanism's own x. [rad]
    """

    dimension: ClassVar[str] = "mechanism"
    reads: ClassVar[tuple[str, ...]] = ("[mechanism]", "[bank.NAME]", "[shaft.NAME]")
    names: tuple[str, ...]
    banks: tuple[str, ...]
    batches: tuple[Batch, ...]
    nominal_top: Array

    @property
    def labels(self) -> dict[str, tuple[str, ...]]:
        """Names of the mechanisms, and of those of each kind that has results of its own."""
        own = {batch.kind.name: batch.members.names for batch in self.batches if batch.kind.stages}
        return {self.dimension: self.names} | (own if self.dimension == Mechanisms.dimension else {})

    def marked(self, is_so: Callable[[AnyKind], bool]) -> NDArray[np.bool_]:
        """Whether something is so of each mechanism's kind, shape (mechanism,)."""
        found = np.zeros(len(self.names), dtype=np.bool_)
        for batch in self.batches:
            found[batch.index] = is_so(batch.kind)
        return found

    @property
    def has_rod(self) -> NDArray[np.bool_]:
        """Whether each mechanism's output hangs on a rod, shape (mechanism,)."""
        return self.marked(lambda kind: kind.has_rod)

    @property
    def outputs(self) -> tuple[OutputPart, ...]:
        """What the output of each is."""
        found = {member: batch.kind.output for batch in self.batches for member in batch.index.tolist()}
        return tuple(found[member] for member in range(len(self.names)))

    @cached_property
    def _found(self) -> dict[str, tuple[object, Any]]:
        return {}

    def once(self, name: str, part: object, find: Callable[[], Found]) -> Found:
        """What is found of them and of one other part alone: once, as long as it is the same object."""
        known = self._found.get(name)
        if known is None or known[0] is not part:
            known = self._found[name] = part, find()
        return known[1]

    def motions(self, angle: Array) -> tuple[AnyMotion, ...]:
        """Motion of every mechanism, in the order of `batches`.

        Parameters
        ----------
        angle : Array, shape (n,), (design, 1, n) or (design, mechanism, n)
            φ, the same for all mechanisms or one for each. [rad]
        """
        return tuple(
            batch.kind.motion(own_values(angle, batch.index) + batch.members.phase, batch.members.geometry)
            for batch in self.batches
        )

    def evaluated(self, pick: Callable[[AnyMotion], Outcome], angle: Array) -> Outcome:
        """Evaluate every mechanism's kernel and pick arrays from its motion.

        Parameters
        ----------
        pick : callable (motion) → NamedTuple of arrays, or of such, shape (design, member, n)
        angle : Array, shape (n,), (design, 1, n) or (design, mechanism, n)
            φ, the same for all mechanisms or one for each. [rad]

        Returns
        -------
        NamedTuple of arrays, shape (design, mechanism, n)
        """
        picked: list[tuple[NDArray[np.intp], Outcome]] = []
        for batch in self.batches:
            own = own_values(angle, batch.index) + batch.members.phase
            motion = in_blocks(batch.kind.motion, own, batch.members.geometry)
            picked.append((batch.index, pick(motion)))
        return side_by_side(picked, (len(self.nominal_top), len(self.names), angle.shape[-1]))

    def alone(self, design: int, mechanism: int, angle: Array) -> AnyMotion:
        """Motion of one mechanism of one design at φ [rad], shape (n,): parts of shape (1, n)."""
        for batch in self.batches:
            member = np.flatnonzero(batch.index == mechanism)
            if member.size:
                place = np.array([design * batch.index.size + member[0]])
                return batch.kind.motion(
                    angle + batch.members.phase[design, member], rows(batch.members.geometry, place)
                )
        raise IndexError(mechanism)


def own_values(values: Array, index: NDArray[np.intp]) -> Array:
    """What some mechanisms have of values (n,), (design, 1, n) for all, or (design, mechanism, n) for each."""
    return values[:, index] if values.ndim == 3 and values.shape[1] > 1 else values


@record
class Pistons(Mechanisms):
    """The mechanisms whose output is a slider: a piston, a ram, a valve."""

    dimension: ClassVar[str] = "piston"


@record
class Rockers(Mechanisms):
    """The mechanisms whose output is a rocker."""

    dimension: ClassVar[str] = "rocker"


MechanismsLike = TypeVar("MechanismsLike", bound=Mechanisms)


def mechanisms_of(result: type[MechanismsLike], places: Sequence[PlacedMechanism], n_designs: int) -> MechanismsLike:
    """Stack the places of designs of one machine by kind."""
    batches: list[Batch] = []
    for chosen in dict.fromkeys(place.kind for place in places):
        index = [i for i, place in enumerate(places) if place.kind == chosen]
        members = chosen.members(
            names=tuple(places[i].name for i in index),
            geometry=by_design([places[i].geometry for i in index], n_designs),
            phase=by_design([places[i].phase for i in index], n_designs)[..., np.newaxis],
        )
        batches.append(Batch(chosen, np.array(index, dtype=np.intp), members))
    return result(
        names=tuple(place.name for place in places),
        banks=tuple(place.bank for place in places),
        batches=tuple(batches),
        nominal_top=by_design([place.nominal_top for place in places], n_designs)[..., np.newaxis],
    )


@record
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
    batches: list[Batch] = []
    names: list[str] = []
    for batch in mechanisms.batches:
        members = batch.members
        lead = members.phase + mechanisms.nominal_top[:, batch.index]
        # Rounding leaves the leads of like mechanisms on different throws some 1e-16 apart.
        columns = np.stack([value.ravel() for value in (np.round(lead, 12), *leaves(members.geometry))], axis=1)
        # Adding 0 makes −0 and 0 the same bytes.
        alike = places_of_equal(row.tobytes() for row in columns + 0.0).values()
        number = np.empty(len(columns), dtype=np.intp)
        for one, places in enumerate(alike, start=len(names)):
            number[places] = one
        origin[:, batch.index] = number.reshape(lead.shape[:2])
        first = [places[0] for places in alike]
        one_design = np.array([first])
        own = replace(
            members,
            names=tuple(members.names[row % len(members.names)] for row in first),
            geometry=rows(members.geometry, one_design),
            phase=lead.reshape(-1, 1)[one_design],
        )
        batches.append(Batch(batch.kind, np.arange(len(names), len(names) + len(first)), own))
        names += own.names
    one = Mechanisms(tuple(names), tuple(names), tuple(batches), np.zeros((1, len(names), 1)))
    return Distinct(one, origin, mechanisms.nominal_top)
