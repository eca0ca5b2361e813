"""Loads of the main bearings by every method at few points between the events of the cycle, for means over it."""

from collections.abc import Sequence

import numpy as np

from cranktrain.motion import Array
from cranktrain.questions.crankshaft.acting import LoadedShafts
from cranktrain.questions.crankshaft.bearing_method import BearingMethod
from cranktrain.questions.crankshaft.cycle_points import CyclePoints
from cranktrain.questions.crankshaft.loads_in_spans import SpannedLoads
from cranktrain.questions.crankshaft.methods import BEARING_METHODS
from cranktrain.questions.crankshaft.parts import DeclaredCrankshafts
from cranktrain.questions.crankshaft.shaft import Supports
from cranktrain.record import record

_ELASTIC, _LOOSE = ("frame_elastic", "five_moment"), "clearance"


@record
class BearingsBetweenEvents:
    """Loads at the points of `CyclePoints`.

    Attributes
    ----------
    acting : sequence of SpannedLoads
        On each shaft.
    load : Array, shape (design, method, bearing, 2, point)
        Of journals on all main bearings, toward X and Y. [N]
    """

    acting: Sequence[SpannedLoads]
    load: Array


def bearings_between_events(
    loaded: LoadedShafts, declared: DeclaredCrankshafts, points: CyclePoints
) -> BearingsBetweenEvents:
    """Loads of all main bearings by all methods that the file has numbers for; docs/theory/crankshaft, eq. (24.10)."""
    acting = loaded.loads(points.angle, points.solved)
    return BearingsBetweenEvents(acting, bearing_loads_of(loaded.supports, methods_for(declared), acting))


def bearing_loads_of(
    supports: Sequence[Supports], methods: Sequence[BearingMethod], acting: Sequence[SpannedLoads]
) -> Array:
    """Loads of all main bearings by some methods, shape (design, method, bearing, 2, n). [N]"""
    each = [
        np.concatenate([method.of(one, own).load for one, own in zip(supports, acting, strict=True)], axis=1)
        for method in methods
    ]
    return np.stack(each, axis=1)


def methods_for(declared: DeclaredCrankshafts) -> tuple[BearingMethod, ...]:
    """Methods that the file has numbers for: elastic bearings need a stiffness, loose ones a clearance."""
    return tuple(
        method
        for method in BEARING_METHODS
        if (declared.is_elastic or method.name not in _ELASTIC) and (declared.has_clearance or method.name != _LOOSE)
    )
