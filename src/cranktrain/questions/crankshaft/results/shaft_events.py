"""Events of what acts on crankshafts: those of the forces, and kinks of pulls; and the machine between them."""

from collections.abc import Iterator

from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.load_laws import Law
from cranktrain.questions.crankshaft.loads.loaded_shafts import LoadedShafts
from cranktrain.questions.forces.events import ForceEvents, with_rows
from cranktrain.questions.wear.cycle_points import CyclePoints, cycle_points
from cranktrain.record import record


@record
class ShaftEvents:
    """Where what acts on crankshafts may jump or have kinks."""

    of_all: ForceEvents


@record
class ShaftPoints:
    """Points of the cycle between these."""

    points: CyclePoints


def shaft_events(loaded: LoadedShafts, events: ForceEvents, crank_angle: CrankAngle) -> ShaftEvents:
    """Add rows of pulls, and of torques on shafts that gears hand on; docs/theory/harmonics-and-orders, eq. (15.17)."""
    return ShaftEvents(with_rows(events, list(_laws(loaded)), crank_angle))


def shaft_points(
    loaded: LoadedShafts, within: ShaftEvents, events: ForceEvents, points: CyclePoints, crank_angle: CrankAngle
) -> ShaftPoints:
    """Solve the machine between these events, where they are more; docs/theory/harmonics-and-orders, eq. (15.17)."""
    is_more = within.of_all.whole.shape != events.whole.shape
    return ShaftPoints(cycle_points(loaded.loaded, within.of_all, crank_angle) if is_more else points)


def _laws(loaded: LoadedShafts) -> Iterator[Law]:
    """Of what acts on shafts beside the mechanisms."""
    for shaft in loaded.each:
        yield from shaft.layout.declared.pulls.over_angle
    if loaded.gears is not None and loaded.given is not None:
        yield from (load.law for load in loaded.given.given)
