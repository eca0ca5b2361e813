"""Which facts a sweep is asked for."""

from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

from cranktrain.analysis import Result, run
from cranktrain.analysis.fact_values import headline_names
from cranktrain.errors import InputError, Problem, refuse
from cranktrain.language import Listed, _
from cranktrain.machine import Machine
from cranktrain.quantities import nearest
from cranktrain.saying.catalogue import Entry
from cranktrain.study.facts_of_starts import FACTS_SHOWN
from cranktrain.study.start import is_over_time, quantities_of_start

_SUGGESTED = 4


def facts_wanted(machine: Machine, wanted: Sequence[str] | None, *, over_time: bool = False) -> tuple[str, ...]:
    """Names of facts that a sweep gives: those asked for, or the headlines of the machine's questions, or of a start.

    Raises
    ------
    InputError
        With every name that is no fact of this machine.
    """
    if over_time:
        known = quantities_of_start(machine)
        return _judged(
            wanted, FACTS_SHOWN, _Known(known, frozenset(name for name in known if is_over_time(known[name])))
        )
    result = run(machine)
    curves = frozenset(name for name, entry in result.catalogue.items() if result.is_curve(entry))
    return _judged(wanted, headline_names([result]), _Known(result.catalogue, curves, result))


class _Known(NamedTuple):
    """Quantities of a machine, and which of it are curves; the result, where what is missing has needs."""

    entries: Mapping[str, Entry]
    curves: frozenset[str]
    result: Result | None = None


def _judged(wanted: Sequence[str] | None, usual: Sequence[str], known: _Known) -> tuple[str, ...]:
    """Names that are asked for, or the usual ones; refuses what is no fact."""
    if wanted is None:
        return tuple(name for name in usual if name not in known.curves)
    refuse(problem for name in dict.fromkeys(wanted) for problem in _problems(name, known))
    if not wanted:
        raise InputError([Problem("wanted", None, _("must be names of facts, with commas between"))])
    return tuple(dict.fromkeys(wanted))


def _problems(name: str, known: _Known) -> Iterator[Problem]:
    """What is wrong with a name, if anything."""
    if name in known.curves:
        facts = [fact for fact, held in known.entries.items() if held.of == name][:_SUGGESTED]
        repair = _("write {facts}", facts=", ".join(facts)) if facts else None
        yield Problem("wanted", name, _("is a curve, and a sweep takes facts"), repair)
    elif name not in known.entries and known.result is not None and (needs := known.result.needs_of(name)):
        yield Problem("wanted", name, _("needs {needs}", needs=Listed(needs)))
    elif name not in known.entries:
        absent = _("is no result of its start") if known.result is None else _("is no result of this machine")
        meant = nearest(name, [fact for fact in known.entries if fact not in known.curves])
        repair = _("did you mean {name}?", name=meant) if meant else _("`cranktrain list results` names all")
        if "," in name:
            repair = _("write them one by one: {names}", names=[part.strip() for part in name.split(",")])
        yield Problem("wanted", name, absent, repair)
