"""What is wrong in the steam engine's text: claims of exactness that its own formulas do not keep."""

from cranktrain.language import N_
from cranktrain.texts.largest_errors import errors_by_ratio
from cranktrain.texts.wrong_step import WrongStep

_LARGEST = 0.3
"""λ up to which the source lets its forms be used."""
_OF_PROJECTION = 0.1


def steam_errata() -> tuple[WrongStep, ...]:
    """Name what the source says of its formulas and is not so, each with its largest error.

    Returns
    -------
    tuple of WrongStep
        In its order; numbers in percent of the stroke or of the exact peak.
    """
    harmonics = errors_by_ratio("two_harmonics", _LARGEST)
    return (
        WrongStep(
            N_("range of (333), (336) and (337), λ ≤ 0.3"),
            "погрешность в этом случае будет незначительной",
            100.0 * float(harmonics.acceleration.value),
            None,
            "%",
            N_(
                "so much of the peak is (337) off at λ = 0.3, (336) 0.44 % and (333) 0.18 % of the stroke: one range "
                "stands for errors that differ six times"
            ),
        ),
        WrongStep(
            N_("range of orthogonal projection, λ < 0.1"),
            "пригодно для механизмов с небольшой величиной отношения λ (меньше 0,1)",
            100.0 * float(errors_by_ratio("infinite_rod", _OF_PROJECTION).displacement.value),
            None,
            "%",
            N_("so much of the stroke is (334) off at λ = 0.1; it is within 1 % for λ up to 0.04"),
        ),
        WrongStep(
            N_("Brix's construction, “accurate enough for so-called exact computations”"),
            "обладает точностью, достаточной для так называемых точных вычислений",
            100.0 * float(errors_by_ratio("brix", _LARGEST).displacement.value),
            None,
            "%",
            N_(
                "so much of the stroke is it off at λ = 0.3, (333) only 0.18 %: the construction leaves out a term in "
                "λ², (333) one in λ³. Arcs of the rod's length are exact"
            ),
        ),
    )
