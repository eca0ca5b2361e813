"""Loads of the main bearings by every method at few points between the events of the cycle, for means over it."""

from collections.abc import Mapping, Sequence

from cranktrain.motion import Array
from cranktrain.questions.crankshaft.bending.loads_in_spans import SpannedLoads
from cranktrain.questions.crankshaft.loads.loaded_shafts import LoadedShafts
from cranktrain.questions.crankshaft.results.shaft_events import ShaftPoints
from cranktrain.questions.crankshaft.results.supported_shafts import SupportedShafts
from cranktrain.record import record


@record
class BearingsBetweenEvents:
    """Loads at the points of `ShaftPoints`.

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
    loaded: LoadedShafts, supported: SupportedShafts, between: ShaftPoints
) -> BearingsBetweenEvents:
    """Loads of all main bearings by all methods that the file has numbers for; docs/theory/crankshaft, eq. (24.10)."""
    points = between.points
    acting = loaded.loads(points.angle, points.solved)
    names = {"bearing_method": tuple(method.name for method in supported.methods)}
    return BearingsBetweenEvents(acting, supported.borne(acting), names)
