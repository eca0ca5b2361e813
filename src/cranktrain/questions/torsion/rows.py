"""What torsion says in the answer: natural frequencies, critical speeds beside the machine's, the worst orders."""

from collections.abc import Iterator

import numpy as np

from cranktrain.language import _
from cranktrain.questions.torsion.critical import CriticalSpeeds
from cranktrain.questions.torsion.modes import TorsionalModes
from cranktrain.questions.torsion.throw_stiffness import ThrowStiffness, title_of
from cranktrain.saying.rows import Amount, AnswerLine, Extent, worded
from cranktrain.saying.wording import Names

_NAMED = 3


def frequency_rows(labels: Names, design: int, modes: TorsionalModes) -> Iterator[AnswerLine]:
    """The lowest natural frequencies."""
    lowest = modes.natural_frequency[design, :_NAMED]
    more = modes.natural_frequency.shape[1] - lowest.size
    if not np.all(np.isfinite(lowest)):
        return
    words = ", ".join(f"{{mode{i}}}" for i in range(lowest.size))
    yield worded(
        _("natural frequencies"),
        _("{first} and {n} more", first=words, n=more) if more else words,
        **{f"mode{i}": Amount(float(one), "Hz") for i, one in enumerate(lowest)},
    )


def critical_rows(labels: Names, design: int, found: CriticalSpeeds) -> Iterator[AnswerLine]:
    """The critical speeds of the first mode on both sides of the machine's, of orders that excite it much."""
    beside = found.beside(design)
    words = ", ".join(
        _("{speed} (order {order})", speed=f"{{speed{place}}}", order=labels["order"][place]) for place in beside
    )
    speeds = {f"speed{place}": Amount(float(found.critical_speed[design, 0, place]), "rpm") for place in beside}
    yield worded(_("next critical speeds"), words, **speeds)


def stiffness_rows(labels: Names, design: int, found: ThrowStiffness) -> Iterator[AnswerLine]:
    """The softest stiffness from throw to throw, and how far off it other methods are."""
    gap = found.softest(design)
    if gap is None:
        return
    own = float(found.chosen_stiffness[design, gap])
    others = np.delete(found.throw_stiffness[design, :, gap], found.chosen) / own - 1
    yield worded(
        _("stiffness of throws"),
        _("{stiffness}, {method}; others {range}"),
        stiffness=Amount(own, "N*m/rad"),
        method=title_of(labels["throw_method"][found.chosen]),
        range=Extent(float(np.nanmin(others)), float(np.nanmax(others)), "off"),
    )
