"""Loads of the main bearings by every method at few points between the events of the cycle, for means over it."""

from collections.abc import Mapping, Sequence

import numpy as np

from cranktrain.motion import Array
from cranktrain.questions.crankshaft.bending.loads_in_spans import SpannedLoads
from cranktrain.questions.crankshaft.loads.loaded_shafts import LoadedShafts
from cranktrain.questions.crankshaft.metal.shaft import Supports
from cranktrain.questions.crankshaft.methods import methods_for
from cranktrain.questions.crankshaft.methods.bearing_method import BearingMethod
from cranktrain.questions.crankshaft.parts import DeclaredCrankshafts
from cranktrain.questions.wear.cycle_points import CyclePoints
from cranktrain.record import record


@record
class BearingsBetweenEvents:
    """Loads at the points of `CyclePoints`.

    Attributes
    ----------
    acting : sequence of SpannedLoads
        On each shaft.
    load : Array, shape (design, method, bearing, 2, point)
        Of journals on all main bearings, toward X and Y. [N]
    labels : mapping of str to tuple of str
        Names of the methods.
    """

    acting: Sequence[SpannedLoads]
    load: Array
    labels: Mapping[str, tuple[str, ...]]


def bearings_between_events(
    loaded: LoadedShafts, declared: DeclaredCrankshafts, points: CyclePoints
) -> BearingsBetweenEvents:
    """Loads of all main bearings by all methods that the file has numbers for; docs/theory/crankshaft, eq. (24.10)."""
    acting, methods = loaded.loads(points.angle, points.solved), methods_for(declared)
    names = {"bearing_method": tuple(method.name for method in methods)}
    return BearingsBetweenEvents(acting, bearing_loads_of(loaded.supports, methods, acting), names)


def bearing_loads_of(
    supports: Sequence[Supports], methods: Sequence[BearingMethod], acting: Sequence[SpannedLoads]
) -> Array:
    """Loads of all main bearings by some methods, shape (design, method, bearing, 2, n). [N]"""
    by_method = [
        np.concatenate([method.of(*shaft).load for shaft in zip(supports, acting, strict=True)], axis=1)
        for method in methods
    ]
    return np.stack(by_method, axis=1)
