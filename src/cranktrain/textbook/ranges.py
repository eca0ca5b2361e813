"""Where each source says that its formula may be used, as data: outside, a flag is shown with its source."""

from collections.abc import Callable
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from cranktrain.language import N_
from cranktrain.motion import Array
from cranktrain.record import record

Flags: TypeAlias = NDArray[np.bool_]

_ROUNDING = 1e-12
"""A ratio is a quotient of lengths: one that rounding moved off a limit still stands on it."""


@record
class Range:
    """The range of one method, as its source gives it.

    Attributes
    ----------
    name : str
        The method in words; translated where it is shown, like `condition`.
    method : str
        Key of the method.
    equations : tuple of str
        The source's own labels.
    source : str
        Citation key, see `cranktrain.references`.
    condition : str
        The range in words, or what to know of a method for which the source gives none.
    outside : callable
        From λ = R/L of a rod and the offset of its line of stroke [m], arrays that broadcast, to flags of the broadcast
        shape: true outside the range. For an articulated rod λ is the master's.
    """

    name: str
    method: str
    equations: tuple[str, ...]
    source: str
    condition: str
    outside: Callable[[Array, Array], Flags]


def _outside_central(most: float) -> Callable[[Array, Array], Flags]:
    """Outside λ up to the most, or not central."""
    return lambda ratio, offset: (ratio > most) | (offset != 0)


def _never_outside(ratio: Array, offset: Array) -> Flags:
    """No range is given."""
    return np.zeros(np.broadcast_shapes(np.shape(ratio), np.shape(offset)), dtype=np.bool_)


RANGES: tuple[Range, ...] = (
    Range(
        N_("two harmonics"),
        "two_harmonics",
        ("(333)", "(336)", "(337)"),
        "steam-engine",
        N_("central mechanism, λ ≤ 0.3"),
        _outside_central(0.3 * (1 + _ROUNDING)),
    ),
    Range(
        N_("infinitely long rod (orthogonal projection of the crank pin)"),
        "infinite_rod",
        ("(334)",),
        "steam-engine",
        N_("central mechanism, λ < 0.1"),
        _outside_central(0.1 * (1 - _ROUNDING)),
    ),
    Range(
        N_("Brix's construction"),
        "brix",
        ("fig. 147",),
        "steam-engine",
        N_("central mechanism, λ ≤ 0.3"),
        _outside_central(0.3 * (1 + _ROUNDING)),
    ),
    Range(
        N_("two harmonics of an articulated rod, derived anew"),
        "derived",
        ("(I.13)",),
        "bolotin",
        N_("the source gives no range; constants exact in the offset angle, to second order in the crank radius"),
        _never_outside,
    ),
    Range(
        N_("two harmonics of an articulated rod, reconstructed"),
        "reconstructed",
        ("(I.13)",),
        "bolotin",
        N_("the source gives no range; its constants are illegible and reconstructed here"),
        _never_outside,
    ),
)
"""The ranges of all textbook methods."""
