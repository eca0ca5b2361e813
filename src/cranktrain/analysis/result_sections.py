"""All that is shown of a run as sections: its numbers, its checks, what to mind, what is missing."""

import itertools
from collections.abc import Iterable, Iterator, Sequence

import numpy as np

from cranktrain.analysis.dimensions import Place, dimension_named, rivals
from cranktrain.analysis.result import Result
from cranktrain.analysis.stages import Missing
from cranktrain.language import Words, _
from cranktrain.numerics.ties import first_largest, largest_of
from cranktrain.saying.amounts import LoneFigure, in_cycle
from cranktrain.saying.catalogue import Entry
from cranktrain.saying.run import Axis, Run
from cranktrain.saying.sections import Answer, FactTables, Failure, PagePart, Part, Rows, ShownSection, section
from cranktrain.saying.wording import ABSENT, InPrint, all_of, once_each

_NAMED = 4
"""How many of the results that something would give are named."""


def result_sections(
    result: Result, names: Sequence[str] | None = None, rests_on: Iterable[ShownSection] = ()
) -> Iterator[PagePart]:
    """Give all that there is of one machine: answer, numbers, checks, what to mind, what is missing.

    Parameters
    ----------
    result : Result
    names : sequence of str, optional
        Which of its quantities; all unless given.
    rests_on : iterable of ShownSection
        What the numbers rest on, where there is a file.
    """
    yield Answer(tuple(result.answer_rows()))
    yield from number_sections(result, tuple(result.catalogue) if names is None else names, is_all=names is None)
    yield from check_section(result)
    yield from section(_("Mind"), map(InPrint, result.flag_words))
    yield from rests_on
    yield from missing_section(result)


def number_sections(run: Run, names: Sequence[str], *, is_all: bool) -> Iterator[ShownSection]:
    """Give facts, and the peaks of curves.

    Parameters
    ----------
    run : Run
        Of one machine.
    names : sequence of str
        Which of its quantities.
    is_all : bool
        Whether these are all there are: then what is given by several methods is named, and its sentence has to do.
    """
    catalogue = run.catalogue
    deep = [name for name in names if is_all and _is_deep(run, catalogue[name])]
    shown = [name for name in names if name not in deep]
    facts = [name for name in shown if not run.is_curve(catalogue[name])]
    yield from section(_("Results"), [FactTables(run, facts)] if facts else [])
    if (axis := run.axis) is not None and (peaks := list(_peaks(run, axis, shown))):
        unit = "°" if axis.unit == "deg" else axis.unit
        heading = _("Largest values of the curves")
        if axis.unit == "deg":
            heading = _("Largest values of the curves, in steps of {step}", step=f"{axis.values[1]:g}°")
        heads = ("", "", _("peak"), "", _("at {unit}", unit=unit), _("of"))
        yield from section(heading, [Rows(peaks, heads, right=(2, 4))])
    yield from section(_("By each method, with --quantities"), [", ".join(deep)] if deep else [])


def _is_deep(run: Run, entry: Entry) -> bool:
    """Whether a quantity has more members than a page should have, which nobody asked for."""
    labels = run.labels_of(entry)
    return len(labels) > 1 and not any(dimension_named(name).is_asked for name in labels)


def check_section(result: Result) -> Iterator[ShownSection]:
    """Give every check with its residual and limit."""
    yield from section(_("Checks"), _checks(result))


def missing_section(result: Result) -> Iterator[ShownSection]:
    """Give what the file could say, and what that would give."""
    yield from section(_("To learn more"), map(_missing, result.worth_asking))


def _peaks(run: Run, axis: Axis, names: Sequence[str]) -> Iterator[tuple[Words, ...]]:
    """Give the largest size of every curve, by each method: name, symbol, value, unit, where and whose."""
    for entry in map(run.catalogue.__getitem__, names):
        if not run.is_curve(entry):
            continue
        labels = run.titles_of(entry)
        for place, method in rivals(labels):
            value, at, member = _refined(run, entry, place) or _in_steps(run, axis, entry, place)
            number, unit = (LoneFigure(value, entry.shown, is_unit) for is_unit in (False, True))
            along = [names for names, chosen in zip(labels.values(), place, strict=True) if isinstance(chosen, slice)]
            members = [", ".join(names) for names in itertools.product(*along)]
            whose = ", ".join(filter(None, (method, members[member] if len(members) > 1 else "")))
            words = (ABSENT, "", "", method) if np.isnan(value) else (number, unit, at, whose)
            yield entry.name, entry.symbol, *words


def _in_steps(run: Run, axis: Axis, entry: Entry, place: Place) -> tuple[float, str, int]:
    """Largest size of a curve among its steps, at which and whose; NaN where it has none."""
    curves = np.reshape(getattr(run, entry.name)[place], (-1, axis.values.size))
    size = np.nan_to_num(np.abs(curves), nan=-1.0)
    member, step = np.unravel_index(first_largest(size), size.shape)
    return float(curves[member, step]), f"{axis.values[step]:g}", int(member)


def _refined(run: Run, entry: Entry, place: Place) -> tuple[float, str, int] | None:
    """Largest size of a curve, where and whose, if facts are its ends: no step has a part in these."""
    found: list[tuple[float, str, int]] = []
    for extreme in (one for one in run.catalogue.values() if one.of == entry.name):
        values, angles = (np.ravel(getattr(run, name)[place]) for name in (extreme.name, extreme.at))
        angles = in_cycle(angles, run.cycle, "position")
        sizes = np.nan_to_num(np.abs(values), nan=-1.0)
        member = first_largest(sizes)
        if sizes[member] >= 0:
            where = "" if np.isnan(angles[member]) else f"{angles[member]:.1f}"  # of what is level, nowhere
            found.append((float(values[member]), where, member))
    # Of ends that are as far from 0, the lower one.
    return largest_of(sorted(found), lambda one: abs(one[0])) if found else None


def _checks(result: Result) -> Iterator[Part]:
    """Say of every check whether it holds, how well, and what is compared."""
    for check in result.checks:
        residual = float(check.residual[0])
        if not check.judged[0]:
            yield _("– {verdict}: {sentence}", verdict=check.verdict(), sentence=check.sentence)
            continue
        said = _(
            "{mark} {verdict} (residual {residual}, limit {limit:.0e}): {sentence}",
            mark="✓" if check.passed[0] else "✗",
            verdict=check.verdict(),
            residual=f"{residual:.1e}" if residual else "0",
            limit=check.limit,
            sentence=check.sentence,
        )
        yield said if check.passed[0] else Failure(said)


def _missing(missing: Missing) -> Words:
    """Say what the file would have to say, and what it would give."""
    results = ", ".join(missing.results[:_NAMED])
    more = len(missing.results) - _NAMED
    named = _("{results} and {n} more", results=results, n=more) if more > 0 else results
    return _("{needs}: gives {results}", needs=all_of(once_each(missing.needs)), results=named)
