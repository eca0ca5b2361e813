"""Cards stretched to the travel of the part: an instrument's stroke is off by a little, and its card is all of it."""

from collections.abc import Callable, Iterator, Mapping
from typing import NamedTuple

import numpy as np

from cranktrain.language import Words, _
from cranktrain.layout.load_laws import ByTravel
from cranktrain.linkage.forces.load import LoadWay
from cranktrain.motion import Array
from cranktrain.numerics import extremes
from cranktrain.numerics.ties import first_largest
from cranktrain.saying.wording import precise

WIDEST = 0.02
"""By how much the travel of a card may differ from that of the part, in parts of that: more is another machine's."""
_TOLD = 1e-6
"""What is less was rounded."""


class Stretch(NamedTuple):
    """How far a card goes and how far the part, shape (design, 1) [m or rad]; the unit in which the card says it."""

    card: Array
    part: Array
    unit: str


def travel_of(way: Callable[[Array], LoadWay]) -> Array:
    """How far a load's point travels over a turn, or its link swings.

    Parameters
    ----------
    way : callable
        Along what it goes, from φ, shape (n,), to arrays of shape (..., n). [rad]

    Returns
    -------
    Array, shape (..., 1)
        NaN where the links do not close. [m or rad]
    """
    least, most = extremes(lambda phi: way(phi).place, lambda phi: way(phi).rate)
    return most.value - least.value


def stretched(law: ByTravel, stretch: Stretch) -> ByTravel:
    """Stretch a card over the travel of the part: its work is its area, stretched alike.

    Parameters
    ----------
    law : ByTravel, shape (design, point)
    stretch : Stretch
        Where the travel of the part is NaN, the card stays as it is.

    Returns
    -------
    ByTravel
    """
    return law._replace(places=law.places * np.where(np.isfinite(stretch.part), stretch.part / stretch.card, 1.0))


def stretch_flags(stretches: Mapping[str, Stretch]) -> Iterator[Words]:
    """Say which cards were stretched, and by how much.

    Parameters
    ----------
    stretches : mapping of str
        By the name of the load.

    Yields
    ------
    Words
        Of several designs, that of the card which was stretched most; one for all loads alike.
    """
    told: dict[tuple[str, str, str], list[str]] = {}
    for name, (card, part, unit) in stretches.items():
        off = np.nan_to_num(part / card - 1)
        design = first_largest(np.abs(off))
        if abs(off[design, 0]) > _TOLD:
            own, whole = (precise(float(travel[design, 0]), unit) for travel in (card, part))
            told.setdefault((own, whole, f"{100 * float(off[design, 0]):+.2g}"), []).append(name)
    for (own, whole, percent), names in told.items():
        said = _("goes over {card} and the part over {whole}: it is stretched by {percent} %")
        of_card = said.format(card=own, whole=whole, percent=percent)
        yield _("The card of {names} {said}.", names=", ".join(names), said=of_card)
