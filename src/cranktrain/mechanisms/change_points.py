"""Linkages that pass change points: which lengths let them come through, in which form, and where they lie in line."""

from collections.abc import Callable, Mapping
from typing import Literal, NamedTuple, TypeAlias

import numpy as np

from cranktrain.language import N_
from cranktrain.linkage import Pin, PinMotion
from cranktrain.linkage.change_point import Hinged, crossed_parallelogram, kite, parallelogram
from cranktrain.motion import Array

Form: TypeAlias = Literal["", "parallelogram", "crossed", "kite"]
"""How four links that pass change points lie between them; nothing of links that pass none."""

FORMS: Mapping[Form, Callable[[Hinged, Pin], PinMotion]] = {
    "parallelogram": parallelogram,
    "crossed": crossed_parallelogram,
    "kite": kite,
}
"""Kernels of rod and rocker by form."""

NOT_CROSSED = N_(
    "must be a parallelogram's to be crossed, rod as long as ground and rocker as long as crank; else side says how it"
    " lies"
)
_ROUNDING = 8 * np.finfo(float).eps


class ChangePoints(NamedTuple):
    """Where a mechanism's links lie in line and come through, by the angle of its crank, shape (..., k) [rad].

    length: of `Kind.lengths`, which may not change at all; forms: of each group that comes through, by the joint.
    """

    angle: Callable[..., Array]
    length: str
    forms: Mapping[str, Form]


class FourBar(NamedTuple):
    """Lengths from hinge to driver, driver to joint, joint to pivot, hinge to pivot. [m]"""

    crank_radius: Array
    rod_length: Array
    rocker_length: Array
    ground_length: Array


def form_of(lengths: FourBar, crossed: bool) -> Form:
    """Say in which form four links come through both change points; nothing where they do not.

    Only where rod and rocker are as long as ground and crank, in either order, do the links lie in line twice a turn,
    and each time the joint comes out on the other side. Where other sums of lengths are equal they lie in line once a
    turn, and come back after two. docs/theory/groups, eqs. (1.21) and (1.22).
    """
    crank, rod, rocker, ground = lengths
    if _are_alike(rocker, crank) and _are_alike(rod, ground):
        return "crossed" if crossed else "parallelogram"
    return "kite" if not crossed and _are_alike(rod, crank) and _are_alike(rocker, ground) else ""


def _are_alike(one: Array, other: Array) -> bool:
    return bool(np.all(np.abs(one - other) <= _ROUNDING * np.maximum(one, other)))
