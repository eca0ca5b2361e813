"""What counterweights do: loads of bearings and what shakes the frame, before and after, in numbers and sentences."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from cranktrain.analysis import run
from cranktrain.language import N_, Words, _
from cranktrain.machine import Machine
from cranktrain.motion import Array
from cranktrain.numerics.harmonics import ComplexArray
from cranktrain.questions.balance.shaking import ShakingCouples, ShakingForces
from cranktrain.questions.crankshaft.methods import title_of
from cranktrain.questions.crankshaft.results.main_bearing_loads import MainBearingLoads
from cranktrain.saying.wording import number
from cranktrain.synthesis.least_loads import Least
from cranktrain.synthesis.proposal import Number
from cranktrain.synthesis.weight_places import Kept, WeightPlace

_AT_LIMIT = 1e-6
"""Of what a weight may be: nearer to it, the limit decides."""
_QUANTITIES = (
    "largest_bearing_load",
    "mean_bearing_load",
    "shaking_force_largest",
    "shaking_couple_largest",
)


class State(NamedTuple):
    """What a machine does: largest and mean load of each bearing [N], force and couple of order 1 [N, N·m]."""

    largest: Array
    mean: Array
    force: float
    couple: float


class Aimed(NamedTuple):
    """What is aimed at: by a method, the largest or the mean load of some bearings of all; is_all, of all."""

    method: str
    names: tuple[str, ...]
    bearings: Sequence[int]
    aim: str

    @property
    def is_all(self) -> bool:
        """Whether it is all bearings."""
        return len(self.bearings) == len(self.names)

    @property
    def title(self) -> Words:
        """Say it in words."""
        if self.is_all:
            words = (
                N_("least largest load of any main bearing")
                if self.aim == "largest"
                else N_("least mean load of all main bearings")
            )
            return _(words)
        words = (
            N_("least largest load of bearing {name}")
            if self.aim == "largest"
            else N_("least mean load of bearing {name}")
        )
        return _(words, name=self.names[self.bearings[0]])

    def state(self, machine: Machine) -> State:
        """Run a machine for what its bearings carry, and what shakes its frame."""
        result = run(machine, quantities=_QUANTITIES)
        loads, labels = result[MainBearingLoads], result.labels
        row = labels["bearing_method"].index(self.method)
        own = [labels["bearing"].index(name) for name in self.names]
        forces, couples = result.get(ShakingForces), result.get(ShakingCouples)
        first = labels["order"].index("1") if "order" in labels else 0
        return State(
            loads.largest_bearing_load.value[0, row, own],
            loads.mean_bearing_load[0, row, own],
            np.nan if forces is None else float(forces.shaking_force_largest[0, -1, first]),
            np.nan if couples is None else float(couples.shaking_couple_largest[0, -1, first]),
        )

    def largest(self, state: State) -> float:
        """Largest load of the bearings aimed at. [N]"""
        return float(np.max(state.largest[self.bearings]))

    def mean(self, state: State) -> float:
        """Mean load of the bearings aimed at. [N]"""
        return float(np.mean(state.mean[self.bearings]))


class FoundWeights(NamedTuple):
    """Weights found: where they stand, mass times radius opposite the throw + i ahead of it, and what it may be.

    moment, most : shape (place,) [kg·m]; radius: shape (place,) [m]; weighs: mass times radius of all, opposite. [kg·m]
    """

    places: Sequence[WeightPlace]
    moment: ComplexArray
    most: Array
    radius: Array

    @property
    def full(self) -> Array:
        """Mass times radius of full counterweights. [kg·m]"""
        return np.array([place.full for place in self.places])

    @property
    def there(self) -> Array:
        """That of the counterweights that stay. [kg·m]"""
        return np.array([place.there for place in self.places])

    def share(self, added: Array) -> float:
        """Of full ones: those that stay, with some added to them. [1]"""
        full = float(np.sum(self.full))
        return float(np.sum(self.there + added)) / full if full > 0 else np.nan


def relief_numbers(aimed: Aimed, weighed: FoundWeights, before: State, after: State) -> tuple[Number, ...]:
    """Numbers of the proposal."""
    return (
        *compared_numbers(aimed, after, weighed.share(weighed.moment.real)),
        *_of_places(weighed),
        *_of_bearings(aimed, before, after),
    )


def compared_numbers(aimed: Aimed, state: State, share: float) -> tuple[Number, ...]:
    """Those that other counterweights have as well."""
    of_any, of_all = _("Largest load of any main bearing"), _("Mean load of all main bearings")
    if not aimed.is_all:
        name = aimed.names[aimed.bearings[0]]
        of_any, of_all = (
            _("Largest load of bearing {name}", name=name),
            _("Mean load of bearing {name}", name=name),
        )
    each = (
        Number("load", "Q_max", aimed.largest(state), "kN", of_any),
        Number("mean_load", "Q_m", aimed.mean(state), "kN", of_all),
        Number("share", "u/u_0", share, "%", _("All weights, of full counterweights")),
        Number("shaking_force", "F_1", state.force, "N", _("Shaking force of order 1")),
        Number("shaking_couple", "C_1", state.couple, "N·m", _("Shaking couple of order 1")),
    )
    return tuple(one for one in each if np.isfinite(one.value))


def _of_places(weighed: FoundWeights) -> Iterator[Number]:
    """Mass, radius and share of the weight at every place, and its angle where one is not opposite."""
    turned = bool(np.any(weighed.moment.imag != 0))
    for i, (place, moment) in enumerate(zip(weighed.places, weighed.moment.tolist(), strict=True)):
        at = str(place.throw if place.z is None else i + 1)
        radius = float(weighed.radius[i])
        yield Number("mass", "m", abs(moment) / radius, "kg", _("Mass of the weight"), at)
        yield Number("radius", "ρ", radius, "mm", _("Radius of its centroid"), at)
        if place.z is not None:
            yield Number("z", "z", place.z, "mm", _("Middle of the web that carries it"), at)
        if turned:
            ahead = float(np.angle(moment))
            yield Number("ahead", "δ", ahead, "deg", _("How far it is ahead of opposite the throw"), at)
        if place.full > 0:
            share = (place.there + moment.real) / place.full
            yield Number("share", "u/u_0", share, "%", _("Of a full counterweight there, with what stays"), at)


def _of_bearings(aimed: Aimed, before: State, after: State) -> Iterator[Number]:
    """Largest and mean load of every bearing, before and after."""
    for i, name in enumerate(aimed.names):
        for key, symbol, state, words in (
            ("largest_before", "Q_0", before.largest, N_("Largest load of bearing as the file has it")),
            ("largest_load", "Q_max", after.largest, N_("Largest load of bearing with the counterweights")),
            ("mean_before", "Q_m0", before.mean, N_("Mean load of bearing as the file has it")),
            ("mean_load", "Q_m", after.mean, N_("Mean load of bearing with the counterweights")),
        ):
            yield Number(key, symbol, float(state[i]), "kN", _(words), name)


def relief_remarks(aimed: Aimed, weighed: FoundWeights, least: Least, kept: Kept) -> Iterator[Words]:
    """What is to be minded."""
    yield _("By {method}: {aim}.", method=title_of(aimed.method), aim=aimed.title)
    at_limit = [
        str(place.throw if place.z is None else i + 1)
        for i, place in enumerate(weighed.places)
        if abs(weighed.moment[i]) > (1 - _AT_LIMIT) * weighed.most[i]
    ]
    yield _("No such weights within the limits leave less than {bound}.", bound=number(least.bound, "kN"))
    if not np.any(weighed.moment):
        yield _("No counterweight there makes it less.")
    if at_limit:
        said = _("As heavy as they may be: {places}.")
        yield said.format(places=", ".join(at_limit))
    if kept.weights:
        yield _("Weights that the file has on throws stay; these come to them.")
    if kept.taken_out:
        yield _("In their place go: {paths}.", paths=", ".join(kept.taken_out))
