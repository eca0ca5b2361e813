"""What the main bearings carry over the cycle, by every method that the file has numbers for."""

from collections.abc import Sequence

import numpy as np

from cranktrain.language import N_, _
from cranktrain.motion import Array
from cranktrain.numerics import Peak
from cranktrain.questions.crankshaft.bending.bearing_loads import resultant, unbalanced
from cranktrain.questions.crankshaft.bending.loads_in_spans import SpannedLoads
from cranktrain.questions.crankshaft.bending.shaft_loads import on_axis
from cranktrain.questions.crankshaft.loads.loaded_shafts import LoadedShafts, LoadsOverCycle
from cranktrain.questions.crankshaft.parts import DeclaredCrankshafts
from cranktrain.questions.crankshaft.results.bearings_between_events import BearingsBetweenEvents
from cranktrain.questions.crankshaft.results.shaft_events import ShaftPoints
from cranktrain.questions.crankshaft.results.shaft_peaks import ShaftPeaks
from cranktrain.questions.crankshaft.results.supported_shafts import SupportedShafts
from cranktrain.questions.forces.peaks import one_sided
from cranktrain.record import record
from cranktrain.references import THEORY_OF_CRANKSHAFT as _THEORY
from cranktrain.saying.catalogue import extreme, quantity
from cranktrain.saying.checks import Check, Checked, Flagged

_CURVE, _FACT = ("bearing_method", "bearing", "crank_angle"), ("bearing_method", "bearing")
_LIMIT = 1e-11
"""Of the largest load: what bearings and loads may leave over by rounding."""


@record
class MainBearingLoads(Checked, Flagged):
    """Load of the journals on the main bearings, by each method."""

    main_bearing_load_x: Array = quantity(
        "Q_X",
        "N",
        _CURVE,
        N_("Load of the journal on the main bearing, to the right"),
        _THEORY,
        "24.6, 24.10, 24.39 to 24.43",
    )
    main_bearing_load_y: Array = quantity(
        "Q_Y",
        "N",
        _CURVE,
        N_("Load of the journal on the main bearing, upward"),
        _THEORY,
        "24.6, 24.10, 24.39 to 24.43",
    )
    largest_bearing_load: Peak = extreme(
        "Q_max",
        "N",
        _FACT,
        N_("Largest load of the main bearing"),
        N_("Crank angle of that load"),
        _THEORY,
        "24.6, 24.10, 24.39 to 24.43",
        worst="largest",
    )
    mean_bearing_load: Array = quantity(
        "Q_m", "N", _FACT, N_("Mean size of the main bearing's load"), _THEORY, "24.6, 24.10, 24.39 to 24.43"
    )


def main_bearing_loads(
    loaded: LoadedShafts,
    declared: DeclaredCrankshafts,
    supported: SupportedShafts,
    over_cycle: LoadsOverCycle,
    between: BearingsBetweenEvents,
    within: ShaftPoints,
    peaks: ShaftPeaks,
) -> MainBearingLoads:
    """Bearing loads over the cycle, largest ones refined on the machine itself, means by quadrature between events.

    Notes
    -----
    docs/theory/crankshaft, eqs. (24.6) and (24.10).
    """
    acting = over_cycle.each
    by_method = [
        [shaft.borne(loads) for shaft, loads in zip(shafts, acting, strict=True)] for shafts in supported.by_method
    ]
    curves = np.stack([np.concatenate(shafts, axis=1) for shafts in by_method], axis=1)
    named = [f"{method.name} {bearing}" for method in supported.methods for bearing in declared.bearings]
    return MainBearingLoads(
        main_bearing_load_x=curves[:, :, :, 0],
        main_bearing_load_y=curves[:, :, :, 1],
        largest_bearing_load=peaks.load,
        mean_bearing_load=within.points.mean_size(between.load[:, :, :, 0], between.load[:, :, :, 1]),
        checks=(_check(loaded, acting, by_method),),
        flags=tuple(one_sided([(_("largest load of a main bearing"), peaks.load)], named)),
    )


def _check(loaded: LoadedShafts, acting: Sequence[SpannedLoads], by_method: Sequence[Sequence[Array]]) -> Check:
    """Whether the bearings balance all that acts, in force and in moment, by every method."""
    worst = np.zeros(len(acting[0].loads.z))
    for place, (supports, spanned) in enumerate(zip(loaded.supports, acting, strict=True)):
        of_loads = resultant(supports, on_axis(spanned.loads))
        scales = (of_loads.largest_force, of_loads.largest_moment)
        for shafts in by_method:
            for left, scale in zip(unbalanced(supports, of_loads, shafts[place]), scales, strict=True):
                worst = np.maximum(worst, np.max(left / np.where(scale > 0, scale, 1.0), axis=-1))
    sentence = _("Sum of all bearing loads and their moments against all that acts on the shaft, by every method")
    return Check("bearing_loads", sentence, worst, _LIMIT)
