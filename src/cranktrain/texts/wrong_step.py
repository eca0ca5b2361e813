"""A step of a source that is wrong."""

from collections.abc import Iterator
from typing import NamedTuple

from cranktrain.language import _
from cranktrain.quantities import shown

_FIGURES = {"mm": 5}
"""Where a source has more than four."""


class WrongStep(NamedTuple):
    """A step of a source that is wrong: what it prints, the number that it got, the right one, and why.

    step, why: in words, translated where they are shown; printed: as the source writes it; got, right: in `unit`, None
    where there is no such number.
    """

    step: str
    printed: str
    got: float | None
    right: float | None
    unit: str
    why: str

    def said(self) -> Iterator[tuple[str, str]]:
        """Give what is said of it in words, each with its head, as far as it has numbers."""
        yield _("printed"), self.printed
        if self.got is not None:
            yield _("gives"), _figure(self.got, self.unit)
        if self.right is not None:
            yield _("right"), _figure(self.right, self.unit)
        yield _("because"), _(self.why)


def _figure(value: float, unit: str) -> str:
    """Write a number with the figures that the sources have at most; an angle in degrees."""
    if unit == "rad":
        return f"{shown(value, 'deg'):.4g} deg"
    return f"{value:.{_FIGURES.get(unit, 4)}g} {unit}".removesuffix(" 1")
