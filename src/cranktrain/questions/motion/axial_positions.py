"""Where each mechanism stands along the shaft."""

from cranktrain.language import N_
from cranktrain.layout.shafts import AxialPlaces
from cranktrain.motion import Array
from cranktrain.record import record
from cranktrain.references import CONVENTIONS
from cranktrain.saying.catalogue import quantity


@record
class AxialPositions:
    """Where each mechanism stands along the shaft."""

    axial_position: Array = quantity(
        "z",
        "m",
        ("mechanism",),
        N_("Along the shaft, from throw 1 toward the flywheel"),
        CONVENTIONS,
        "definition",
    )


def axial_positions(places: AxialPlaces) -> AxialPositions:
    """Give the declared places as a result."""
    return AxialPositions(places.value)
