"""Where rods and bearings stand along the shaft."""

import numpy as np

from cranktrain.language import N_
from cranktrain.layout.shafts import AxialPlaces
from cranktrain.motion import Array
from cranktrain.questions.crankshaft.parts import DeclaredCrankshafts
from cranktrain.questions.crankshaft.shaft_layout import ShaftLayouts
from cranktrain.record import record
from cranktrain.references import THEORY_OF_CRANKSHAFT as _THEORY
from cranktrain.saying.catalogue import quantity
from cranktrain.saying.checks import StageResult


@record
class ShaftPlaces(StageResult):
    """Places along the shaft of what loads it and of what bears it; a slave's rod loads its master's pin."""

    rod_place: Array = quantity(
        "z_r",
        "m",
        ("mechanism",),
        N_("Place of the rod along its shaft, from throw 1 toward the flywheel"),
        _THEORY,
        "definition",
    )
    bearing_place: Array = quantity(
        "z_b", "m", ("bearing",), N_("Place of the main bearing along its shaft, from throw 1"), _THEORY, "definition"
    )


def shaft_places(_layouts: ShaftLayouts, declared: DeclaredCrankshafts, axial: AxialPlaces) -> ShaftPlaces:
    """Say where rods and bearings stand."""
    bearings = [one.bearings for one in declared.each]
    return ShaftPlaces(axial.value, np.concatenate(bearings, axis=1))
