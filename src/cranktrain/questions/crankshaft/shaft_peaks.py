"""Largest values on crankshafts over the cycle: near to where panels show them, all looked at together."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.motion import Array
from cranktrain.numerics import Peak, in_slots
from cranktrain.numerics.panel_tops import tops_in_panels
from cranktrain.numerics.pieces import largest_near
from cranktrain.questions.crankshaft.acting import LoadedShafts
from cranktrain.questions.crankshaft.bearing_method import BearingMethod
from cranktrain.questions.crankshaft.bearings_between_events import (
    BearingsBetweenEvents,
    bearing_loads_of,
    methods_for,
)
from cranktrain.questions.crankshaft.cycle_points import CyclePoints
from cranktrain.questions.crankshaft.loads_in_spans import SpannedLoads
from cranktrain.questions.crankshaft.methods import ELASTIC_FRAME
from cranktrain.questions.crankshaft.parts import DeclaredCrankshafts
from cranktrain.questions.crankshaft.shaft import Supports
from cranktrain.questions.crankshaft.torque_of_shafts import torque_in_sections, torques_of_loads
from cranktrain.questions.forces.events import ForceEvents
from cranktrain.questions.forces.peaks import counted
from cranktrain.record import record

_WIDE = 0.01
"""How far from where panels show a top it is looked for at first. [rad]"""
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
        As `load`, by the crank frame in each of `HOUSINGS`; none where no bearing gives.
    """

    load: Peak
    pin_torque: Peak
    journal_torque: Peak
    housing_load: tuple[Peak, ...]


class _Curves(NamedTuple):
    """Curves of which all need the same: bearing loads by a method in some bearings, and the torque of sections.

    Without a method the torque is that by the loads alone, and there are no loads of bearings.
    """

    method: BearingMethod | None
    supports: Sequence[Supports]
    sections: NDArray[np.bool_]

    def values(self, loaded: LoadedShafts, acting: Sequence[SpannedLoads], borne: Array | None = None) -> Array:
        """Sizes of the loads, the torques, and these against the rotation, shape (design, curve, n)."""
        found: list[Array] = []
        if self.method is not None:
            if borne is None:
                borne = bearing_loads_of(self.supports, [self.method], acting)[:, 0]
            found.append(np.hypot(borne[:, :, 0], borne[:, :, 1]))
        if np.any(self.sections):
            torque = torque_in_sections(loaded, torques_of_loads(loaded, acting), borne)[:, self.sections]
            found += [torque, -torque]
        return np.concatenate(found, axis=1)

    def kinds(self, n_curves: int) -> Iterator[int]:
        """How many of the curves are of each kind, of which what is rounding beside its largest is nothing."""
        n_torques = 2 * int(np.sum(self.sections))
        if self.method is not None:
            yield n_curves - n_torques
        if self.method is None or n_torques:
            yield n_torques


def shaft_peaks(
    loaded: LoadedShafts,
    declared: DeclaredCrankshafts,
    points: CyclePoints,
    between: BearingsBetweenEvents,
    events: ForceEvents,
    crank_angle: CrankAngle,
) -> ShaftPeaks:
    """Find the tops of all curves in the panels between events, and look at the machine near these once."""
    methods, supports = methods_for(declared), loaded.supports
    is_journal = np.concatenate([one.laid.is_journal for one in loaded.each])
    nowhere = np.zeros_like(is_journal)
    each = [
        *(_Curves(method, supports, ~is_journal) for method in methods),
        *(_Curves(ELASTIC_FRAME, _in_housing(supports, one), nowhere) for one in HOUSINGS if declared.is_elastic),
        _Curves(None, supports, is_journal),
    ]
    n_methods = len(methods)
    given = [*(between.load[:, place] for place in range(n_methods)), *[None] * (len(each) - n_methods)]
    samples = [one.values(loaded, between.acting, own) for one, own in zip(each, given, strict=True)]
    kinds = [part for one, own in zip(each, samples, strict=True) for part in one.kinds(own.shape[1])]
    found = iter(_largest(loaded, each, samples, kinds, points, events, crank_angle))
    loads, torques = zip(*((next(found), next(found)) for _method in methods), strict=True)
    housings = tuple(next(found) for _one in each[n_methods:-1])
    return ShaftPeaks(_by_method(loads), _by_method(torques), next(found), housings)


def _by_method(each: Sequence[Peak]) -> Peak:
    """Peaks of every method, shapes (design, method, curve)."""
    return Peak(*(np.stack(parts, axis=1) for parts in zip(*each, strict=True)))


def _in_housing(supports: Sequence[Supports], factor: float) -> tuple[Supports, ...]:
    """The same bearings in a housing of another stiffness."""
    return tuple(one._replace(compliance=one.compliance / factor) for one in supports)


def _largest(
    loaded: LoadedShafts,
    each: Sequence[_Curves],
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
    for own in of_kind:
        nothing[:, own] = _NOTHING * np.max(scale[:, own], axis=-1, keepdims=True, initial=0.0)
    tops = [
        tops_in_panels(cut, values[:, : cut.angle.size], least)
        for cut, values, least in zip(points.cuts, whole, nothing, strict=True)
    ]
    centre = np.full((*scale.shape, max(own.shape[-1] for own in tops)), np.nan)
    for design, own in enumerate(tops):
        centre[design, :, : own.shape[-1]] = own
    breaks = np.repeat(events.whole - crank_angle.zero[:, 0], scale.shape[1], axis=0)
    first = np.cumsum([0, *(own.shape[1] for own in samples)])

    def curves(which: NDArray[np.intp], shown: Array) -> Array:
        """The machine is solved at all angles together; each method has its own among them."""
        design, row = np.divmod(which, scale.shape[1])
        number = np.searchsorted(first, row, side="right") - 1
        own_rows = [np.flatnonzero(number == one) for one in range(len(each))]
        laid = [in_slots(design[own], shown[own], len(scale)) for own in own_rows]
        asked = [angle.reshape(len(scale), 1, -1) for angle, _slot in laid]
        ends = np.cumsum([0, *(angle.shape[-1] for angle in asked)]).tolist()
        acting = loaded.loads(np.concatenate(asked, axis=-1) + crank_angle.zero)
        found = np.empty_like(shown)
        for place, (one, own, (angle, slot)) in enumerate(zip(each, own_rows, laid, strict=True)):
            if own.size:
                here = slice(ends[place], ends[place + 1])
                values = one.values(loaded, [shaft.at(here) for shaft in acting])
                values = values.reshape(*values.shape[:2], *angle.shape[1:])
                found[own] = values[design[own], row[own] - first[place], slot]
        return found

    best = largest_near(
        curves, centre.reshape(-1, centre.shape[-1]), breaks, scale.reshape(-1), _WIDE, crank_angle.cycle
    )
    peak = Peak(*(part.reshape(scale.shape) for part in best))
    for own in of_kind:
        yield counted(Peak(*(part[:, own] for part in peak)), crank_angle)
