"""How much the main bearings' loads hang on the stiffness of their housing, which is mostly a guess."""

from dataclasses import replace
from functools import partial

import numpy as np

from cranktrain.catalogue import quantity
from cranktrain.language import N_
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.motion import Array
from cranktrain.questions.crankshaft.acting import LoadedShaft, LoadedShafts
from cranktrain.questions.crankshaft.bearings_between_events import bearing_loads_of
from cranktrain.questions.crankshaft.loads_over_cycle import LoadsOverCycle
from cranktrain.questions.crankshaft.methods import BEARING_METHODS
from cranktrain.questions.crankshaft.parts import DeclaredCrankshafts
from cranktrain.questions.crankshaft.stages import bearing_load_sizes
from cranktrain.questions.forces.events import ForceEvents
from cranktrain.questions.forces.peaks import largest_of_machine
from cranktrain.record import record
from cranktrain.references import THEORY_OF_CRANKSHAFT as _THEORY

_FRAME = next(method for method in BEARING_METHODS if method.name == "frame_elastic")
_SOFT, _STIFF = 0.5, 2.0
"""Times the stiffness of the file: a guess may be out by so much."""


@record
class HousingSpread:
    """Largest bearing loads in softer and in stiffer housings, by the crank frame on elastic bearings."""

    bearing_load_soft_housing: Array = quantity(
        "Q_½", "N", ("bearing",), N_("Largest load of the main bearing if all housings were half as stiff"), _THEORY
    )
    bearing_load_stiff_housing: Array = quantity(
        "Q_2", "N", ("bearing",), N_("Largest load of the main bearing if all housings were twice as stiff"), _THEORY
    )


def in_elastic_bearings(declared: DeclaredCrankshafts | None) -> bool:
    """Whether the file says of any bearing how it gives."""
    return declared is not None and declared.is_elastic


def housing_spread(
    loaded: LoadedShafts, over_cycle: LoadsOverCycle, events: ForceEvents, crank_angle: CrankAngle
) -> HousingSpread:
    """Largest loads where the stiffness of all bearings is half and twice that of the file, refined.

    Notes
    -----
    docs/theory/crankshaft.
    """
    largest: list[Array] = []
    for factor in (_SOFT, _STIFF):
        other = replace(loaded, each=tuple(_in_housing(one, factor) for one in loaded.each))
        load = bearing_loads_of(other, [_FRAME], over_cycle.each)[:, 0]
        sizes = partial(bearing_load_sizes, other, [_FRAME])
        most = largest_of_machine(sizes, np.hypot(load[:, :, 0], load[:, :, 1]), events, crank_angle)
        largest.append(most.value)
    return HousingSpread(*largest)


def _in_housing(loaded: LoadedShaft, factor: float) -> LoadedShaft:
    """The same shaft in bearings of another stiffness."""
    supports = loaded.shaft.supports
    shaft = loaded.shaft._replace(supports=supports._replace(compliance=supports.compliance / factor))
    return replace(loaded, laid=replace(loaded.laid, shaft=shaft))
