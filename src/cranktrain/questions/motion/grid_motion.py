"""Motion of every mechanism on the grid of crank angles, found once for all that go on from it."""

from collections.abc import Callable
from typing import TypeVar

import numpy as np

from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.mechanisms import Mechanisms
from cranktrain.mechanisms.kind import AnyMotion
from cranktrain.motion import Array
from cranktrain.numerics.nested import each_changed, side_by_side
from cranktrain.record import record

Outcome = TypeVar("Outcome", bound=tuple[object, ...])


@record
class GridMotion:
    """Motion of every mechanism on the grid of crank angles; nothing that people read as it is.

    Attributes
    ----------
    mechanisms : Mechanisms
    batches : tuple of NamedTuple
        In the order of `mechanisms.batches`, parts of shape (design, member, n).
    n_angles : int
    """

    mechanisms: Mechanisms
    batches: tuple[AnyMotion, ...]
    n_angles: int

    def of(self, some: Mechanisms, pick: Callable[[AnyMotion], Outcome]) -> Outcome:
        """Pick arrays from the motion of those mechanisms that drive one sort of output, shape (design, some, n)."""
        by_kind = {batch.kind: own for batch, own in zip(self.mechanisms.batches, self.batches, strict=True)}
        picked = [(batch.index, pick(by_kind[batch.kind])) for batch in some.batches]
        return side_by_side(picked, (len(some.nominal_top), len(some.names), self.n_angles))


def grid_motion(mechanisms: Mechanisms, crank_angle: CrankAngle) -> GridMotion:
    """Evaluate every mechanism's kernel over one turn, which all turns of the cycle repeat."""
    found = mechanisms.motions(crank_angle.first_turn)
    return GridMotion(mechanisms, tuple(_over_cycle(motion, crank_angle) for motion in found), crank_angle.shown.size)


def _over_cycle(motion: AnyMotion, crank_angle: CrankAngle) -> AnyMotion:
    """Motion of a turn at all angles; what stands still is as it is."""
    n_turn = crank_angle.first_turn.shape[-1]
    # One array may stand in several places of a motion, as the crank pin does.
    known: dict[int, Array] = {}

    def repeated(values: Array) -> Array:
        if np.shape(values)[-1:] != (n_turn,):
            return values
        if id(values) not in known:
            known[id(values)] = crank_angle.over_cycle(values)
        return known[id(values)]

    return each_changed(repeated, motion)
