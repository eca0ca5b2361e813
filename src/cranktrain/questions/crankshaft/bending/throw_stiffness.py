"""Stiffness of a crankshaft in torsion from throw to throw, by the crank frame and by textbooks' rules side by side."""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.language import N_
from cranktrain.motion import Array
from cranktrain.questions.crankshaft.bending.frame_twist import twist_when_clamped, twist_when_free
from cranktrain.questions.crankshaft.metal.shaft import Crankshaft
from cranktrain.questions.crankshaft.metal.throw_gaps import Gaps, carter, ker_wilson, zimanenko
from cranktrain.record import record


class ShaftInTorsion(NamedTuple):
    """A shaft of throws with a journal between any two.

    Attributes
    ----------
    shaft : Crankshaft
    pins : array of int, shape (throw,)
        Which pieces the pins are.
    gaps : Gaps
        The same sizes as a rule reads them.
    shear : Array, shape (design,)
        Shear modulus. [Pa]
    """

    shaft: Crankshaft
    pins: NDArray[np.intp]
    gaps: Gaps
    shear: Array


@record
class ThrowMethod:
    """A way to find how far a shaft twists between two throws.

    Attributes
    ----------
    name : str
        How users call it.
    title : str
        How answers call it, not yet translated.
    twist : callable (ShaftInTorsion) → Array of shape (design, gap)
        By a unit torque. [rad/(N·m)]
    source : str
        Where its equations stand.
    range : str
        What it takes the shaft for: a sentence, not yet translated.
    """

    name: str
    title: str
    twist: Callable[[ShaftInTorsion], Array]
    source: str
    range: str

    def stiffness(self, shaft: ShaftInTorsion) -> Array:
        """Torque by twist from the middle of each pin to that of the next, shape (design, gap). [N·m/rad]

        NaN where the shaft has no such stiffness.
        """
        with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
            found = 1 / self.twist(shaft)
        return np.where(np.isfinite(found) & (found > 0), found, np.nan)


def _frame(shaft: ShaftInTorsion) -> Array:
    return twist_when_free(shaft.shaft, shaft.pins)


def _clamped_frame(shaft: ShaftInTorsion) -> Array:
    return twist_when_clamped(shaft.shaft, shaft.pins)


def _by_length(rule: Callable[[Gaps], Array]) -> Callable[[ShaftInTorsion], Array]:
    """Twist of the plain shaft that a rule gives; docs/theory/torsion, eq. (23.21)."""

    def twist(shaft: ShaftInTorsion) -> Array:
        return rule(shaft.gaps) / (np.pi / 32 * shaft.shear[:, np.newaxis])

    return twist


THROW_METHODS = (
    ThrowMethod(
        "frame",
        N_("crank frame"),
        _frame,
        "docs/theory/torsion, eq. (23.13)",
        N_("centre lines of journals, webs and pins; journals turn aside in their bearings as they like"),
    ),
    ThrowMethod(
        "frame_clamped",
        N_("clamped crank frame"),
        _clamped_frame,
        "docs/theory/torsion, eq. (23.16)",
        N_("centre lines; journals cannot turn aside in their bearings"),
    ),
    ThrowMethod(
        "carter",
        "Carter",
        _by_length(carter),
        "docs/theory/torsion, eq. (23.18); [carter-1928]",
        N_("solid throws by experience; its source states no range that is known here"),
    ),
    ThrowMethod(
        "ker_wilson",
        "Ker Wilson",
        _by_length(ker_wilson),
        "docs/theory/torsion, eq. (23.19); [ker-wilson]",
        N_("solid throws by experience; a crank radius of more than a fifth of both diameters"),
    ),
    ThrowMethod(
        "zimanenko",
        N_("Zimanenko"),
        _by_length(zimanenko),
        "docs/theory/torsion, eq. (23.20); [zimanenko]",
        N_("solid throws by experience; its source states no range that is known here"),
    ),
)
"""Methods for the stiffness from throw to throw, that of the program's own frame first."""
