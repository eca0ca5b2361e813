"""A machine with counterweights put on it, and what its file says of them."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from cranktrain.language import Words, _
from cranktrain.machine import Machine
from cranktrain.motion import Array
from cranktrain.numerics.harmonics import ComplexArray
from cranktrain.synthesis.proposal import ProposedTable, found, quantity_text, wanted
from cranktrain.synthesis.weight_places import Kept, WeightPlace


class _Weight(NamedTuple):
    """A weight where one stands: its mass [kg], radius [m], and angle ahead of throw 1, or None opposite. [rad]"""

    place: WeightPlace
    mass: float
    radius: float
    angle: float | None


class AddedWeights(NamedTuple):
    """A machine on which weights may be put.

    Attributes
    ----------
    given : Machine
    kept : Kept
        What stays of its [balance].
    places : sequence of WeightPlace
    radius : Array, shape (place,)
        Of the weights' centroids. [m]
    turns : bool
        Whether they may stand elsewhere than opposite their throws; then the angle of each is said.
    """

    given: Machine
    kept: Kept
    places: Sequence[WeightPlace]
    radius: Array
    turns: bool

    def machine(self, moment: ComplexArray) -> Machine:
        """The machine with weights of a mass times radius, opposite their throws + i ahead of that. [kg·m]"""
        new: list[dict[str, object]] = []
        for weight in self._weights(moment):
            table: dict[str, object] = {
                "mass": quantity_text(weight.mass, "kg"),
                "radius": quantity_text(weight.radius, "mm"),
                "throw": weight.place.throw,
            }
            if weight.place.z is not None:
                table["z"] = quantity_text(weight.place.z, "mm")
            if weight.angle is not None:
                table["angle"] = quantity_text(weight.angle, "deg")
            new.append(table)
        weights = (*self.kept.table.get("weight", ()), *new)
        table = {key: value for key, value in self.kept.table.items() if key != "weight"}
        balance = {**table, "weight": weights} if weights else table
        return self.given.with_({"balance": balance or None})

    def tables(self, moment: ComplexArray, note: Words, *, is_radius_wanted: bool) -> Iterator[ProposedTable]:
        """What a machine file says of them."""
        for weight in self._weights(moment):
            radius = wanted(weight.radius, "mm") if is_radius_wanted else None
            keys = {
                "mass": found(weight.mass, "kg", note),
                "radius": radius or found(weight.radius, "mm", _("as the crank's"), "assumed"),
                "throw": str(weight.place.throw),
            }
            if weight.place.z is not None:
                keys["z"] = found(weight.place.z, "mm", _("in the middle of a web"))
            if weight.angle is not None:
                keys["angle"] = found(weight.angle, "deg", note)
            yield ProposedTable("[balance.weight]", keys)

    def _weights(self, moment: ComplexArray) -> Iterator[_Weight]:
        """Those weights that there are."""
        for place, own, radius in zip(self.places, moment.tolist(), self.radius.tolist(), strict=True):
            if own != 0:
                # The file itself puts a weight opposite its throw.
                angle = float(np.mod(place.opposite + np.angle(own), 2 * np.pi)) if self.turns else None
                yield _Weight(place, abs(own) / radius, radius, angle)
