"""Where each source says that its formula may be used, as data: outside, a flag is shown with its source."""

from collections.abc import Iterator
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from cranktrain.language import N_, Words, _
from cranktrain.motion import Array, single
from cranktrain.record import record
from cranktrain.saying.wording import number

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
    most_ratio : float or None
        Largest λ = R/L of a mechanism, which has to be central, too; of an articulated rod λ is the master's. None
        where the source gives no range.
    is_below : bool
        Whether λ must be less than that.
    """

    name: str
    method: str
    equations: tuple[str, ...]
    source: str
    condition: str
    most_ratio: float | None = None
    is_below: bool = False

    def outside(self, ratio: Array, offset: Array) -> Flags:
        """Tell what is outside, from λ of a rod and the offset of its line of stroke [m], arrays that broadcast."""
        return self._is_beyond(ratio) | self._is_offset(offset)

    def reasons(self, ratio: float, offset: float) -> Iterator[Words]:
        """Say what a mechanism is outside for: its λ, the offset of its line of stroke [m], or both.

        Examples
        --------
        >>> list(RANGES[0].reasons(0.2, 0.01)), list(RANGES[0].reasons(0.31, 0.0))
        (['the line of stroke is offset by 10.00 mm'], ['λ = 0.31'])
        """
        if self._is_beyond(single(ratio)):
            yield f"λ = {ratio:.4g}"
        if self._is_offset(single(offset)):
            yield _("the line of stroke is offset by {offset}", offset=number(abs(offset), "mm"))

    def _is_beyond(self, ratio: Array) -> Flags:
        """Whether λ is too large."""
        if self.most_ratio is None:
            return np.zeros(np.shape(ratio), dtype=np.bool_)
        rounding = -_ROUNDING if self.is_below else _ROUNDING
        return np.asarray(ratio) > self.most_ratio * (1 + rounding)

    def _is_offset(self, offset: Array) -> Flags:
        """Whether a line of stroke is offset, which the forms do not know."""
        return (np.asarray(offset) != 0) & (self.most_ratio is not None)


RANGES: tuple[Range, ...] = (
    Range(
        N_("two harmonics"),
        "two_harmonics",
        ("(333)", "(336)", "(337)"),
        "steam-engine",
        N_("central mechanism, λ ≤ 0.3"),
        most_ratio=0.3,
    ),
    Range(
        N_("infinitely long rod (orthogonal projection of the crank pin)"),
        "infinite_rod",
        ("(334)",),
        "steam-engine",
        N_("central mechanism, λ < 0.1"),
        most_ratio=0.1,
        is_below=True,
    ),
    Range(
        N_("Brix's construction"),
        "brix",
        ("fig. 147",),
        "steam-engine",
        N_("central mechanism, λ ≤ 0.3"),
        most_ratio=0.3,
    ),
    Range(
        N_("two harmonics of an articulated rod, derived anew"),
        "derived",
        ("(I.13)",),
        "bolotin",
        N_("the source gives no range; constants exact in the offset angle, to second order in the crank radius"),
    ),
    Range(
        N_("two harmonics of an articulated rod, reconstructed"),
        "reconstructed",
        ("(I.13)",),
        "bolotin",
        N_("the source gives no range; its constants are illegible and reconstructed here"),
    ),
)
"""The ranges of all textbook methods."""

EXACT_ROOT = Range(
    N_("exact root"), "exact_root", ("fig. 146",), "steam-engine", N_("central mechanism"), most_ratio=1.0
)
"""The displacement before its root is taken to first order: no approximation, and no method of a run's."""
