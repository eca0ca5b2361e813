"""Distinct mechanisms: a V12 has twelve pistons and two of these; what stands for a turn is computed once for each."""

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from cranktrain.layout.mechanisms import Batch, Mechanisms
from cranktrain.mechanisms.kind import rows
from cranktrain.motion import Array
from cranktrain.numerics.nested import leaves
from cranktrain.record import record


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
        seen: dict[bytes, int] = {}
        # Adding 0 makes −0 and 0 the same bytes.
        alike = np.array([seen.setdefault(row.tobytes(), len(seen)) for row in columns + 0.0], dtype=np.intp)
        _numbers, first = np.unique(alike, return_index=True)
        origin[:, batch.index] = len(names) + alike.reshape(lead.shape[:2])
        one_design = first[np.newaxis]
        own = replace(
            members,
            names=tuple(members.names[row % len(members.names)] for row in map(int, first)),
            geometry=rows(members.geometry, one_design),
            phase=lead.reshape(-1, 1)[one_design],
        )
        batches.append(Batch(batch.kind, np.arange(len(names), len(names) + len(first)), own))
        names += own.names
    one = Mechanisms(tuple(names), tuple(names), tuple(batches), np.zeros((1, len(names), 1)))
    return Distinct(one, origin, mechanisms.nominal_top)
