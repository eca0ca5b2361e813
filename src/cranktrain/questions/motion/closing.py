"""Closing margin of every mechanism: how little one length may change before the crank cannot turn."""

import numpy as np

from cranktrain.language import N_
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.mechanisms import Mechanisms, distinct
from cranktrain.mechanisms.closing import closing_margin
from cranktrain.motion import Array
from cranktrain.record import record
from cranktrain.saying.catalogue import quantity
from cranktrain.saying.checks import Flagged, Limit, flagged

_MECHANISM = ("mechanism",)
_THEORY = "docs/theory/closing-margin"


# Near locking the slopes of all curves are its inverse square root, and their digits are those of the margin.
_CLOSENESS = Limit(
    1e6,
    "",
    N_("The links close by {value} of a length alone: results near there rest on its last digits."),
)


@record
class Closing(Flagged):
    """How far each mechanism is from locking.

    Attributes
    ----------
    length_names : tuple of tuple of str
        Which length it is, [design][mechanism].
    """

    closing_margin: Array = quantity(
        "m",
        "1",
        _MECHANISM,
        N_("Smallest relative change of one length after which the crank cannot turn"),
        _THEORY,
        "5.1",
    )
    closing_angle: Array = quantity(
        "φ_m", "deg", _MECHANISM, N_("Crank angle at which the links would part"), _THEORY, "5.1", is_place=True
    )
    length_names: tuple[tuple[str, ...], ...] = ()


def closing(mechanisms: Mechanisms, crank_angle: CrankAngle) -> Closing:
    """Closing margin of every mechanism."""
    different = distinct(mechanisms)
    shape = different.mechanisms.nominal_top.shape
    margin, angle = np.empty(shape), np.empty(shape)
    length = np.empty(shape, dtype=object)
    for batch in different.mechanisms.batches:
        found = closing_margin(batch.kind, batch.members.geometry)
        margin[:, batch.index] = found.margin
        angle[:, batch.index] = found.angle - batch.members.phase
        length[:, batch.index] = np.array([*batch.kind.length_names, ""], dtype=object)[found.length]
    margins = different.spread(margin)[..., 0]
    return Closing(
        closing_margin=margins,
        closing_angle=crank_angle.counted(different.angle(angle))[..., 0],
        length_names=tuple(tuple(row) for row in different.spread(length)[..., 0]),
        unlikely=tuple(flagged(_CLOSENESS, 1 / margins, margins)),
    )
