"""Two ways of one thing: that they give the same, how long each takes, and the line of the table that says so."""

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
from timing import interleaved_ratio

SAME = 1e-12
"""Largest difference of two ways, of the quantity's peak."""


class Comparison(NamedTuple):
    """Two ways of one thing, each called without arguments, and how to get columns that should be the same."""

    what: str
    against: str
    ours: Callable[[], Any]
    theirs: Callable[[], Any]
    our_columns: Callable[[Any], list[Any]]
    their_columns: Callable[[Any], list[Any]]
    limit: float
    most_apart: float = SAME
    note: str = ""


def filled(loop, angles, geometry, n_columns):
    """A loop as a function without arguments, with its table made beforehand; a column of the table a row."""
    table = np.empty((angles.size, n_columns))

    def fill():
        loop(angles, *geometry, table)
        return table.T

    return fill


def difference(comparison):
    """Largest difference of the two ways, of the quantity's peak."""
    ours, theirs = comparison.our_columns(comparison.ours()), comparison.their_columns(comparison.theirs())
    apart = (np.max(np.abs(our - their)) / np.max(np.abs(our)) for our, their in zip(ours, theirs, strict=True))
    return max(apart, default=0.0)


def is_kept(name, n, comparison, n_repetitions):
    """Measure, print the line of the table, say whether the limit is kept."""
    apart = difference(comparison)
    if not apart <= comparison.most_apart:
        raise ArithmeticError(f"{name}, {comparison.against}: {apart:.1e} of the peak apart")
    ratio = interleaved_ratio(comparison.ours, comparison.theirs, n_repetitions=n_repetitions)
    good = ratio.median <= comparison.limit
    print(
        f"{name:<13}{n:>7}  {comparison.what:<9}{comparison.against:<14}"
        f"{1e9 * ratio.ours / n:>8.1f}{1e9 * ratio.theirs / n:>8.1f}"
        f"{ratio.median:>9.4f}{f'{ratio.least:.4f}–{ratio.most:.4f}':>16}{comparison.limit:>8.4f}"
        f"  {'ok' if good else 'MISSED'}  {comparison.note}".rstrip(),
        flush=True,
    )
    return good
