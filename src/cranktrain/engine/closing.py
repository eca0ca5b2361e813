"""Closing margin of every mechanism: how little one length may change before the crank cannot turn."""

from dataclasses import dataclass

import numpy as np

from cranktrain.catalogue import quantity
from cranktrain.engine.layout import CrankAngle, Mechanisms
from cranktrain.language import N_, _
from cranktrain.mechanisms.closing import closing_margin
from cranktrain.motion import Array
from cranktrain.wording import Names, shared

_MECHANISM = ("mechanism",)
_THEORY = "docs/theory/closing-margin"


@dataclass(frozen=True)
class Closing:
    """How far each mechanism is from locking.

    Attributes
    ----------
    length_names : tuple of tuple of str
        Which length it is, [design][mechanism].
    """

    closing_margin: Array = quantity(
        "m", "1", _MECHANISM, N_("Smallest relative change of one length after which the crank cannot turn"), _THEORY
    )
    closing_angle: Array = quantity(
        "φ_m", "deg", _MECHANISM, N_("Crank angle at which the links would part"), _THEORY
    )
    length_names: tuple[tuple[str, ...], ...] = ()

    def answer(self, names: Names, design: int) -> str | None:
        """Say the smallest margin of all."""
        margins = self.closing_margin[design]
        if np.all(np.isnan(margins)):
            return None
        least = int(np.nanargmin(margins))
        return _("Closing margin {margin} ({mechanism}: {length}, at {angle}).").format(
            margin=shared(("",), margins[least : least + 1], "%"),
            mechanism=names["mechanism"][least],
            length=self.length_names[design][least],
            angle=shared(("",), self.closing_angle[design, least : least + 1], "deg"),
        )


def closing(mechanisms: Mechanisms, crank_angle: CrankAngle) -> Closing:
    """Closing margin of every mechanism, found once for each geometry."""
    shape = mechanisms.nominal_top.shape[:2]
    margin, angle, length = np.empty(shape), np.empty(shape), np.empty(shape, dtype=object)
    for group in mechanisms.groups:
        numbers = _flat(group.members.geometry)
        _rows, representative, inverse = np.unique(
            np.stack([value.ravel() for value in numbers]), axis=1, return_index=True, return_inverse=True
        )
        distinct = _chosen(group.members.geometry, representative)
        found = closing_margin(group.kind.gap, distinct, group.kind.lengths)
        where = inverse.reshape(numbers[0].shape[:2])
        margin[:, group.index] = found.margin[where, 0]
        phi = found.angle[where] - group.members.phase
        angle[:, group.index] = crank_angle.counted(phi)[..., 0]
        length[:, group.index] = np.array([*group.kind.lengths, ""], dtype=object)[found.length[where, 0]]
    return Closing(margin, angle, tuple(tuple(row) for row in length))


def _flat(geometry: tuple[object, ...]) -> list[Array]:
    """All arrays of a nested geometry, in order."""
    return [
        array for value in geometry for array in (_flat(value) if isinstance(value, tuple) else [np.asarray(value)])
    ]


def _chosen(geometry: tuple[object, ...], rows: Array) -> tuple[object, ...]:
    """The geometry of some of its (design, member) pairs, flat, shape (row, 1)."""
    return type(geometry)(
        *(
            _chosen(value, rows) if isinstance(value, tuple) else np.asarray(value).reshape(-1, 1)[rows]
            for value in geometry
        )
    )
