"""A step of a source that is wrong."""

from typing import NamedTuple


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
