"""Many designs in sentences: of each fact that says most from where to where it goes, and which designs these are."""

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from cranktrain.analysis.figures import Shown, shown_in, significant
from cranktrain.analysis.result import Result
from cranktrain.catalogue import Entry
from cranktrain.language import _
from cranktrain.motion import Array
from cranktrain.wording import ranged

_ALIKE = 1e-9
"""Values that differ by less are one."""

_EXACT = "exact"


def summary_of_designs(result: Result) -> Iterator[str]:
    """Say what designs have in common, and between which values they are.

    Parameters
    ----------
    result : Result
        Of several designs.

    Yields
    ------
    str
        A line of each fact: one value of all, or the smallest and the largest with who has them.
    """
    n_designs = len(result.machines)
    yield _("{n} designs").format(n=n_designs)
    for name, fact in result.headline.items():
        values = np.asarray(fact.value, dtype=np.float64)
        labels = result.labels_of(fact.entry)
        methods = next(iter(labels.values()), ())
        if methods and methods[0] == _EXACT:
            values, labels = values[:, 0], dict(list(labels.items())[1:])
        yield f"{name.replace('_', ' ')}: {_between(values.reshape(n_designs, -1), fact.entry)}"


def _between(values: Array, entry: Entry) -> str:
    """Say between which values the designs are, by the member that goes farthest, shape (design, member)."""
    finite = np.isfinite(values)
    if not np.any(finite):
        return _("none")
    shown = shown_in(entry.unit, values)
    least, most = float(values[finite].min()), float(values[finite].max())
    without = np.flatnonzero(~np.any(finite, axis=1))
    but = _("; none in {designs}").format(designs=_named(without, len(values))) if without.size else ""
    if most - least <= _ALIKE * max(abs(least), abs(most)):
        return _number(most, shown) + but
    said = _("{least} ({least_of}) to {most} ({most_of})").format(
        least=_number(least, shown), least_of=_who(values, least), most=_number(most, shown), most_of=_who(values, most)
    )
    return said + but


def _who(values: Array, value: float) -> str:
    """Name the designs that have a value."""
    near = np.abs(np.where(np.isfinite(values), values, np.inf) - value) <= _ALIKE * max(abs(value), 1e-300)
    return _named(np.flatnonzero(np.any(near, axis=1)), len(values))


def _named(places: NDArray[np.intp], n_designs: int) -> str:
    names = [str(i + 1) for i in range(n_designs)]
    words = _("design {designs}") if len(places) == 1 else _("designs {designs}")
    return words.format(designs=ranged(names, places.tolist()))


def _number(value: float, shown: Shown) -> str:
    text = significant(float(shown.converted(np.array(value))))
    return f"{text} {shown.unit}".rstrip()
