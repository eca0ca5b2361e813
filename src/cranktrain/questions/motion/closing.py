"""Closing margin of every mechanism: how little one length may change before the crank cannot turn."""

from collections.abc import Mapping
from dataclasses import field
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from cranktrain.language import N_
from cranktrain.layout.crank_angle import CrankAngle, within
from cranktrain.layout.mechanisms import Mechanisms, distinct
from cranktrain.mechanisms.closing import closing_margin
from cranktrain.motion import Array
from cranktrain.numerics.harmonics import TURN
from cranktrain.record import record
from cranktrain.saying.catalogue import quantity
from cranktrain.saying.checks import Flagged, Limit, flagged

if TYPE_CHECKING:
    from cranktrain.mechanisms.change_points import Form

_MECHANISM = ("mechanism",)
_THEORY = "docs/theory/closing-margin"


# Near locking the slopes of all curves are its inverse square root, and their digits are those of the margin.
_CLOSENESS = Limit(
    1e6,
    "",
    N_("The links close by {value} of a length alone: results near there rest on its last digits."),
)

_SAME = 1e-9
"""Nearer than so to the end of a turn an angle is 0. [rad]"""


class PassedChangePoints(NamedTuple):
    """Change points that a mechanism passes: crank angles as shown, shape (design, k), NaN for none [rad]; and how.

    By the joint that comes through, the form; without a name where there is one joint alone.
    """

    angle: Array
    forms: "Mapping[str, Form]"


@record
class Closing(Flagged):
    """How far each mechanism is from locking.

    Attributes
    ----------
    length_names : tuple of tuple of str
        Which length it is, [design][mechanism].
    passed : mapping of int to PassedChangePoints
        Of the mechanisms whose links lie in line and come through.
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
    passed: Mapping[int, PassedChangePoints] = field(default_factory=dict[int, PassedChangePoints])


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
    passed: dict[int, PassedChangePoints] = {}
    for batch in mechanisms.batches:
        if batch.kind.change_points is not None:
            angle = batch.kind.change_points.angle(batch.members.geometry) - batch.members.phase
            shown = np.sort(within(crank_angle.counted(angle), TURN, _SAME), axis=-1)
            passed |= {
                one: PassedChangePoints(shown[:, own], batch.kind.change_points.forms)
                for own, one in enumerate(batch.index.tolist())
            }
    return Closing(
        closing_margin=margins,
        closing_angle=crank_angle.counted(different.angle(angle))[..., 0],
        length_names=tuple(tuple(row) for row in different.spread(length)[..., 0]),
        passed=passed,
        unlikely=tuple(flagged(_CLOSENESS, np.where(margins > 0, 1 / margins, np.nan), margins)),
    )
