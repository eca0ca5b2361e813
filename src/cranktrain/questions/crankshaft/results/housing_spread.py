"""How much the main bearings' loads hang on the stiffness of their housing, which is mostly a guess."""

from cranktrain.language import N_
from cranktrain.motion import Array
from cranktrain.questions.crankshaft.parts import DeclaredCrankshafts
from cranktrain.questions.crankshaft.results.shaft_peaks import ShaftPeaks
from cranktrain.record import record
from cranktrain.references import THEORY_OF_CRANKSHAFT as _THEORY
from cranktrain.saying.catalogue import quantity


@record
class HousingSpread:
    """Largest bearing loads in softer and in stiffer housings, by the most trusted method of elastic bearings."""

    bearing_load_soft_housing: Array = quantity(
        "Q_½",
        "N",
        ("bearing",),
        N_("Largest load of the main bearing if all housings were half as stiff"),
        _THEORY,
        "24.6, 24.10",
    )
    bearing_load_stiff_housing: Array = quantity(
        "Q_2",
        "N",
        ("bearing",),
        N_("Largest load of the main bearing if all housings were twice as stiff"),
        _THEORY,
        "24.6, 24.10",
    )


def in_elastic_bearings(declared: DeclaredCrankshafts | None) -> bool:
    """Whether the file says of any bearing how it gives."""
    return declared is not None and declared.is_elastic


def housing_spread(peaks: ShaftPeaks) -> HousingSpread:
    """Largest loads where the stiffness of all bearings is half and twice that of the file, refined.

    Notes
    -----
    docs/theory/crankshaft.
    """
    return HousingSpread(*(one.value for one in peaks.housing_load))
