"""What mechanisms have of one sort, such as joints or guides: each with its place in what was solved."""

from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array
from cranktrain.questions.forces.loaded_machine import SolvedBatch


class Member(NamedTuple):
    """One joint or guide of one mechanism: its name; the mechanism; its batch, member and place in the kind."""

    name: str
    mechanism: int
    batch: int
    member: int
    place: int


def mechanisms_of(members: Sequence[Member]) -> NDArray[np.intp]:
    """Whose each is, shape (one,)."""
    return np.array([one.mechanism for one in members], dtype=np.intp)


def parts_of(
    members: Sequence[Member], solved: Sequence[SolvedBatch], values: Callable[[int, int], Sequence[Array]]
) -> Array:
    """Parts of what each bears, shape (part, design, one, n), from those that a batch has at a place of its kind."""
    found = {
        (batch, place): np.stack(np.broadcast_arrays(solved[batch].forces.driving_torque, *values(batch, place))[1:])
        for batch, place in {(one.batch, one.place) for one in members}
    }
    return np.stack([found[one.batch, one.place][:, :, one.member] for one in members], axis=2)
