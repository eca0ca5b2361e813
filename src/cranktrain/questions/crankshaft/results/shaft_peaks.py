"""Largest values on crankshafts over the cycle: near to where panels show them, all looked at together."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.motion import Array
from cranktrain.numerics import Peak, in_windows
from cranktrain.numerics.panel_tops import tops_in_panels
from cranktrain.numerics.pieces import largest_near
from cranktrain.questions.crankshaft.bending.loads_in_spans import SpannedLoads
from cranktrain.questions.crankshaft.bending.torque_along import TorqueOfLoads
from cranktrain.questions.crankshaft.loads.loaded_shafts import LoadedShafts
from cranktrain.questions.crankshaft.metal.shaft import Supports
from cranktrain.questions.crankshaft.methods import most_trusted
from cranktrain.questions.crankshaft.methods.bearing_method import ELASTIC
from cranktrain.questions.crankshaft.methods.supported_shaft import SupportedShaft, in_bearings
from cranktrain.questions.crankshaft.parts import DeclaredCrankshafts
from cranktrain.questions.crankshaft.results.bearings_between_events import BearingsBetweenEvents
from cranktrain.questions.crankshaft.results.shaft_events import ShaftEvents, ShaftPoints
from cranktrain.questions.crankshaft.results.supported_shafts import SupportedShafts
from cranktrain.questions.crankshaft.results.torque_of_shafts import (
    in_turning_axes,
    torque_in_sections,
    torques_of_loads,
)
from cranktrain.questions.forces.events import ForceEvents, breaks_at_speed
from cranktrain.questions.forces.peaks import counted
from cranktrain.questions.wear.cycle_points import CyclePoints
from cranktrain.record import record

_WIDE = 0.01
"""From window to window in which tops are looked for. [rad]"""
_REACH = 1.2
"""How far a window reaches from its middle, in parts of that."""
_NOTHING = 1e-12
"""Of the largest of all like it, a curve of which is rounding."""
HOUSINGS = (0.5, 2.0)
"""Times the stiffness of the file: a guess may be out by so much."""


@record
class ShaftPeaks:
    """Largest values over the cycle, refined on the machine itself.

    Attributes
    ----------
    load : Peak, shapes (design, method, bearing)
        Of the loads of main bearings. [N]
    pin_torque : Peak, shapes (design, method, 2 · pin)
        Of the torque in crank pins, and of the same against the rotation. [N·m]
    journal_torque : Peak, shapes (design, 2 · journal)
        Likewise in journals, where no method matters.
    housing_load : tuple of Peak, shapes (design, bearing)
        As `load`, by the most trusted method of elastic bearings in each of `HOUSINGS`; none where no bearing gives.
    """

    load: Peak
    pin_torque: Peak
    journal_torque: Peak
    housing_load: tuple[Peak, ...]


class _Curves(NamedTuple):
    """Curves of which all need the same: bearing loads by a method in some bearings, and the torque of sections.

    Without shafts in bearings the torque is that by the loads alone, and there are no loads of bearings.
    """

    shafts: Sequence[SupportedShaft]
    sections: NDArray[np.bool_]

    def borne(self, acting: Sequence[SpannedLoads]) -> list[Array]:
        """Load of the bearings of each shaft in axes that turn with it, shape (design, bearing, 2, n). [N]"""
        return [shaft.turning(loads) for shaft, loads in zip(self.shafts, acting, strict=False)]

    def values(self, loaded: LoadedShafts, by_loads: Sequence[TorqueOfLoads], borne: Sequence[Array]) -> Array:
        """Sizes of the loads, the torques, and these against the rotation, shape (design, curve, n)."""
        sizes = [np.hypot(load[:, :, 0], load[:, :, 1]) for load in borne]
        if np.any(self.sections):
            torque = torque_in_sections(loaded, by_loads, borne)[:, self.sections]
            sizes += [torque, -torque]
        return np.concatenate(sizes, axis=1)

    def kinds(self, n_curves: int) -> Iterator[int]:
        """How many of the curves are of each kind, of which what is rounding beside its largest is nothing."""
        n_torques = 2 * int(np.sum(self.sections))
        if self.shafts:
            yield n_curves - n_torques
        if not self.shafts or n_torques:
            yield n_torques


def shaft_peaks(
    loaded: LoadedShafts,
    declared: DeclaredCrankshafts,
    supported: SupportedShafts,
    within: ShaftPoints,
    between: BearingsBetweenEvents,
    events: ShaftEvents,
    crank_angle: CrankAngle,
) -> ShaftPeaks:
    """Find the tops of all curves in the panels between events, and look at the machine near these once."""
    is_journal = np.concatenate([shaft.layout.is_journal for shaft in loaded.each])
    nowhere = np.zeros_like(is_journal)
    groups = [_Curves(shafts, ~is_journal) for shafts in supported.by_method]
    if declared.is_elastic:
        trusted = most_trusted(ELASTIC)
        housings = (_in_housing(loaded.supports, factor) for factor in HOUSINGS)
        groups += [_Curves(in_bearings(trusted, softer, supported.units), nowhere) for softer in housings]
    groups.append(_Curves((), is_journal))
    n_methods = len(supported.by_method)
    by_loads = torques_of_loads(loaded, between.acting)
    borne = [in_turning_axes(load, between.acting, loaded) for load in np.moveaxis(between.load, 1, 0)]
    borne += [group.borne(between.acting) for group in groups[n_methods:]]
    samples = [group.values(loaded, by_loads, loads) for group, loads in zip(groups, borne, strict=True)]
    kinds = [n for group, values in zip(groups, samples, strict=True) for n in group.kinds(values.shape[1])]
    peaks = iter(_largest(loaded, groups, samples, kinds, within.points, events.of_all, crank_angle))
    loads, torques = zip(*((next(peaks), next(peaks)) for _method in range(n_methods)), strict=True)
    of_housings = tuple(next(peaks) for _group in groups[n_methods:-1])
    return ShaftPeaks(_by_method(loads), _by_method(torques), next(peaks), of_housings)


def _by_method(peaks: Sequence[Peak]) -> Peak:
    """Peaks of every method, shapes (design, method, curve)."""
    return Peak(*(np.stack(parts, axis=1) for parts in zip(*peaks, strict=True)))


def _in_housing(supports: Sequence[Supports], factor: float) -> tuple[Supports, ...]:
    """The same bearings in a housing of another stiffness."""
    return tuple(bearings._replace(compliance=bearings.compliance / factor) for bearings in supports)


def _largest(
    loaded: LoadedShafts,
    groups: Sequence[_Curves],
    samples: Sequence[Array],
    kinds: Sequence[int],
    points: CyclePoints,
    events: ForceEvents,
    crank_angle: CrankAngle,
) -> Iterator[Peak]:
    """Peaks of the curves of each kind, shapes (design, curve)."""
    whole = np.concatenate(samples, axis=1)
    edges = np.cumsum([0, *kinds])
    of_kind = [slice(start, end) for start, end in zip(edges[:-1].tolist(), edges[1:].tolist(), strict=True)]
    scale = np.fmax.reduce(np.abs(whole), axis=-1, initial=0.0)
    nothing = np.empty_like(scale)
    for kind in of_kind:
        nothing[:, kind] = _NOTHING * np.max(scale[:, kind], axis=-1, keepdims=True, initial=0.0)
    tops = [
        tops_in_panels(cut, values[:, : cut.angle.size], least)
        for cut, values, least in zip(points.cuts, whole, nothing, strict=True)
    ]
    centre = np.full((*scale.shape, max(angles.shape[-1] for angles in tops)), np.nan)
    for design, angles in enumerate(tops):
        # On few places, so that curves which are largest near to each other are looked at in one window.
        centre[design, :, : angles.shape[-1]] = _WIDE * np.rint(angles / _WIDE)
    breaks = np.repeat(breaks_at_speed(events, loaded.loaded.speed, crank_angle), scale.shape[1], axis=0)
    first = np.cumsum([0, *(values.shape[1] for values in samples)])

    def curves(which: NDArray[np.intp], shown: Array) -> Array:
        """The machine is solved once for all curves that are looked at in one window; each method has its own."""
        design, row = np.divmod(which, scale.shape[1])
        asked, slot = in_windows(design, shown, len(scale))
        acting = loaded.loads(asked.reshape(len(scale), 1, -1) + crank_angle.zero)
        by_loads = torques_of_loads(loaded, acting)
        of_group = np.searchsorted(first, row, side="right") - 1
        looked_at, n_nodes = np.empty_like(shown), shown.shape[-1]
        for number, group in enumerate(groups):
            mine = np.flatnonzero(of_group == number)
            if mine.size:
                windows = np.unique(slot[mine])
                angles = np.ravel(windows[:, np.newaxis] * n_nodes + np.arange(n_nodes, dtype=np.intp))
                borne = group.borne([shaft.at(angles) for shaft in acting])
                values = group.values(loaded, [shaft.at(angles) for shaft in by_loads], borne)
                values = values.reshape(*values.shape[:2], windows.size, n_nodes)
                looked_at[mine] = values[design[mine], row[mine] - first[number], np.searchsorted(windows, slot[mine])]
        return looked_at

    best = largest_near(
        curves, centre.reshape(-1, centre.shape[-1]), breaks, scale.reshape(-1), _REACH * _WIDE, crank_angle.cycle
    )
    peak = Peak(*(part.reshape(scale.shape) for part in best))
    # What has no tops is level, and largest from the beginning on.
    is_level = np.all(np.isnan(centre), axis=-1)
    peak.value[is_level], peak.angle[is_level], peak.side[is_level] = np.max(whole, axis=-1)[is_level], 0.0, 0.0
    for kind in of_kind:
        yield counted(Peak(*(part[:, kind] for part in peak)), crank_angle)
