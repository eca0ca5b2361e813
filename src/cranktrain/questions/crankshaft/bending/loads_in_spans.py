"""Loads on a shaft between its bearings: what the methods share of them, found once for all."""

from collections.abc import Sequence
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array
from cranktrain.numerics.designs import of_designs
from cranktrain.questions.crankshaft.bending.blocks import turned_by
from cranktrain.questions.crankshaft.bending.cut_shaft import CutShaft, cut_shaft
from cranktrain.questions.crankshaft.bending.designs_alike import Alike, designs_alike
from cranktrain.questions.crankshaft.bending.frame_spans import BentSpans, bent_spans, frame_spans
from cranktrain.questions.crankshaft.bending.shaft_loads import ActingPlaces, AxisLoads, ShaftLoads, on_axis
from cranktrain.questions.crankshaft.bending.straight_spans import straight_spans
from cranktrain.questions.crankshaft.bending.support_moments import SpanFlexibility
from cranktrain.questions.crankshaft.metal.shaft import Crankshaft


class AlikeShafts:
    """Designs of a shaft that are alike, and the places of its loads: what no load changes.

    Attributes
    ----------
    designs : array of int
    alike : Alike
    shaft : Crankshaft
        Of these designs.
    places : ActingPlaces
    """

    def __init__(self, designs: NDArray[np.intp], alike: Alike, shaft: Crankshaft, places: ActingPlaces) -> None:
        self.designs, self.alike, self.shaft, self.places = designs, alike, shaft, places

    @cached_property
    def bent(self) -> BentSpans:
        """The spans of the crank frame under unit moments."""
        return bent_spans(self.shaft, self.places, self.alike)


def alike_shafts(shaft: Crankshaft, places: ActingPlaces) -> tuple[AlikeShafts, ...]:
    """Put designs together whose loads and webs lie between the same bearings."""
    return tuple(
        AlikeShafts(designs, alike, of_designs(shaft, designs), of_designs(places, designs))
        for designs, alike in designs_alike(shaft, places.z)
    )


class LoadsInSpans:
    """Loads on designs that are alike.

    What several methods need of them is found when the first one asks for it.

    Attributes
    ----------
    of : AlikeShafts
    loads : ShaftLoads
    """

    def __init__(self, of: AlikeShafts, loads: ShaftLoads, taken: "_Taken | None" = None) -> None:
        self.of, self.loads, self._taken = of, loads, taken

    def at(self, angles: NDArray[np.intp]) -> "LoadsInSpans":
        """The same at some of the crank angles, which hand on what is found at all."""
        return LoadsInSpans(self.of, loads_at(self.loads, angles), _Taken(self, angles))

    @cached_property
    def cut(self) -> CutShaft:
        """The shaft cut at its bearings."""
        if self._taken is not None:
            return CutShaft(*(part[..., self._taken.angles] for part in self._taken.whole.cut))
        return cut_shaft(self.of.shaft.supports.place, self.of.alike.loads, self._along)

    @cached_property
    def turning_cut(self) -> CutShaft:
        """The same in axes that turn with the shaft."""
        if self._taken is not None:
            return CutShaft(*(part[..., self._taken.angles] for part in self._taken.whole.turning_cut))
        return CutShaft(*(turned_by(values, self.loads.turned) for values in self.cut))

    @cached_property
    def frame(self) -> SpanFlexibility:
        """Spans as crank frames, in axes that turn with the shaft."""
        if self._taken is not None:
            return _slopes_at(self._taken.whole.frame, self._taken.angles)
        return frame_spans(self.of.bent, self.of.shaft.supports.thrust, self.loads, self.of.alike.loads)

    @cached_property
    def straight(self) -> SpanFlexibility:
        """Spans as straight beams."""
        if self._taken is not None:
            return _slopes_at(self._taken.whole.straight, self._taken.angles)
        shaft = self.of.shaft
        return straight_spans(shaft.supports.place, shaft.straight, self.of.alike.loads, self._along)

    @cached_property
    def turning(self) -> Array:
        """All that acts, in axes that turn with the shaft, as `unit_loads` has it, shape (design, unit load, angle)."""
        if self._taken is not None:
            return self._taken.whole.turning[..., self._taken.angles]
        return _in_turning_axes(self.loads)

    @cached_property
    def _along(self) -> AxisLoads:
        """The loads, carried over to the axis."""
        return on_axis(self.loads)


def _in_turning_axes(loads: ShaftLoads) -> Array:
    """Forces, couples, torques and thrusts one below another, shape (design, one, angle)."""
    across = (part for part in (loads.force, loads.couple) if part is not None)
    about = (part for part in (loads.torque, loads.thrust) if part is not None)
    n_designs, n_angles = loads.turned.shape
    turned = (turned_by(part, loads.turned).reshape(n_designs, -1, n_angles) for part in across)
    return np.concatenate([*turned, *about], axis=1)


def unit_loads(of: AlikeShafts, *, is_geared: bool) -> LoadsInSpans:
    """Unit loads at all places, one at each of so many angles, of axes that do not turn.

    Forces toward the first and the second axis at each place, then torques; with gears, couples behind the forces, and
    at last thrusts.
    """
    n_designs, n_places = of.places.z.shape
    n_kinds = (2, 2, 1, 1) if is_geared else (2, 0, 1, 0)
    n_units = n_places * sum(n_kinds)
    rows = np.broadcast_to(np.eye(n_units), (n_designs, n_units, n_units))
    force, couple, torque, thrust = np.split(rows, np.cumsum(n_kinds)[:-1] * n_places, axis=1)
    across = (n_designs, n_places, 2, n_units)
    loads = ShaftLoads(
        *of.places,
        turned=np.zeros((n_designs, n_units)),
        force=force.reshape(across),
        couple=couple.reshape(across) if is_geared else None,
        torque=torque,
        thrust=thrust if is_geared else None,
    )
    return LoadsInSpans(of, loads)


class _Taken(NamedTuple):
    """Loads, and at which of their crank angles others are taken from them."""

    whole: LoadsInSpans
    angles: NDArray[np.intp]


def loads_at(loads: ShaftLoads, angles: NDArray[np.intp]) -> ShaftLoads:
    """Loads at some of their crank angles."""
    over_angles = ("turned", "force", "couple", "torque", "thrust")
    curves = {name: getattr(loads, name) for name in over_angles}
    return loads._replace(**{name: part[..., angles] for name, part in curves.items() if part is not None})


def _slopes_at(spans: SpanFlexibility, angles: NDArray[np.intp]) -> SpanFlexibility:
    """What moments do is the same at all angles, in these axes."""
    return spans._replace(first_slope=spans.first_slope[..., angles], last_slope=spans.last_slope[..., angles])


class SpannedLoads(NamedTuple):
    """Loads on all designs of a shaft, and apart for those that are alike."""

    loads: ShaftLoads
    groups: tuple[LoadsInSpans, ...]

    @property
    def turning_force(self) -> Array:
        """Forces in axes that turn with the shaft, shape (design, load, 2, angle). [N]"""
        shape = self.loads.force.shape
        forces = [group.turning[:, : 2 * shape[1]].reshape(-1, *shape[1:]) for group in self.groups]
        return in_order(self.groups, forces)

    def at(self, angles: NDArray[np.intp]) -> "SpannedLoads":
        """The same at some of the crank angles."""
        return SpannedLoads(loads_at(self.loads, angles), tuple(group.at(angles) for group in self.groups))


def in_order(groups: Sequence[LoadsInSpans], values: Sequence[Array]) -> Array:
    """Values of designs that are alike, for each group of these, in the order of all designs."""
    if len(groups) == 1:
        return values[0]
    whole = np.empty((sum(group.of.designs.size for group in groups), *values[0].shape[1:]))
    for group, own in zip(groups, values, strict=True):
        whole[group.of.designs] = own
    return whole


def spanned_loads(shafts: Sequence[AlikeShafts], loads: ShaftLoads) -> SpannedLoads:
    """Put loads to the designs that are alike."""
    return SpannedLoads(loads, tuple(LoadsInSpans(alike, of_designs(loads, alike.designs)) for alike in shafts))
