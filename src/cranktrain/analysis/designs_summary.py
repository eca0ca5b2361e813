"""Many designs in sentences: of each fact that says most from where to where it goes, and which designs these are."""

from collections.abc import Iterator, Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from cranktrain.analysis.dimensions import rivals
from cranktrain.analysis.figures import shown_in, text_in
from cranktrain.analysis.members import ends, whose_of
from cranktrain.analysis.result import Fact, Result
from cranktrain.language import said as _
from cranktrain.motion import Array
from cranktrain.one_line import one_line
from cranktrain.saying.catalogue import Entry
from cranktrain.saying.scales import Scale
from cranktrain.saying.wording import ranged

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
    machine = one_line(result.machines[0].name)
    n_designs = len(result.machines)
    yield _("{n} designs of {name}", n=n_designs, name=machine) if machine else _("{n} designs", n=n_designs)
    asked = {name: fact for name, fact in result.facts.items() if name in (result.asked or ())}
    for fact in (asked or result.headline).values():
        yield from _lines(fact, result.titles_of(fact.entry), n_designs)


def _lines(fact: Fact, labels: Mapping[str, Sequence[str]], n_designs: int) -> Iterator[str]:
    """Say a fact by the method that is meant; where errors are counted from that, those of each of the others."""
    every = np.asarray(fact.value, dtype=np.float64)
    meant, *others = rivals(labels)
    is_counted_from = others and not np.any(np.nan_to_num(every[(slice(None), *meant[0])]))
    for place, method in others if is_counted_from else [meant]:
        along = [names for names, chosen in zip(labels.values(), place, strict=True) if isinstance(chosen, slice)]
        members = along[0] if len(along) == 1 else ()
        values = every[(slice(None), *place)].reshape(n_designs, -1)
        if (worst := fact.entry.worst) is not None and np.all(np.any(np.isfinite(values), axis=1)):
            values = ends(values, worst, axis=1)
            members = ()
        said = ", ".join(filter(None, (fact.entry.words, "" if method == _EXACT else method)))
        yield f"{said}: {_between(values, fact.entry, members)}"


def _between(values: Array, entry: Entry, members: Sequence[str]) -> str:
    """Say between which values the designs are, shape (design, member), and who has them."""
    finite = np.isfinite(values)
    if not np.any(finite):
        return _("none")
    shown = shown_in(entry.shown, values)
    least, most = float(values[finite].min()), float(values[finite].max())
    without = np.flatnonzero(~np.any(finite, axis=1))
    lacking = _named(without, len(values)) if without.size else ""
    if _number(least, shown) == _number(most, shown):
        return _but_in(_number(most, shown), lacking)
    spread = np.ptp(np.where(finite, values, 0.0), axis=0)
    if not without.size and np.all(spread <= _ALIKE * max(abs(least), abs(most))):
        return _("{least} to {most} in each", least=_number(least, shown), most=_number(most, shown))
    said = _(
        "{least} ({least_of}) to {most} ({most_of})",
        least=_number(least, shown),
        least_of=_who(values, least, members),
        most=_number(most, shown),
        most_of=_who(values, most, members),
    )
    return _but_in(said, lacking)


def _but_in(said: str, lacking: str) -> str:
    """Say which designs have none."""
    return _("{values}; none in {designs}", values=said, designs=lacking) if lacking else said


def _who(values: Array, value: float, members: Sequence[str]) -> str:
    """Name the designs that have a value, and where that is not of all members, whose it is."""
    near = np.abs(np.where(np.isfinite(values), values, np.inf) - value) <= _ALIKE * max(abs(value), 1e-300)
    designs = _named(np.flatnonzero(np.any(near, axis=1)), len(values))
    of = np.flatnonzero(np.any(near, axis=0))
    if not members or len(of) == len(members):
        return designs
    return f"{designs}, {whose_of(members, of.tolist())}"


def _named(places: NDArray[np.intp], n_designs: int) -> str:
    names = [str(i + 1) for i in range(n_designs)]
    words = _("design {designs}") if len(places) == 1 else _("designs {designs}")
    return words.format(designs=ranged(names, places.tolist()))


def _number(value: float, shown: Scale) -> str:
    return f"{text_in(shown, value)} {shown.label}".rstrip()
