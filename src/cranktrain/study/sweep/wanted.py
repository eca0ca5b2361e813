"""Which facts a sweep is asked for."""

from collections.abc import Sequence

from cranktrain.analysis import run
from cranktrain.analysis.fact_values import headline_names
from cranktrain.errors import InputError, Problem, refuse
from cranktrain.language import Listed, _
from cranktrain.machine import Machine
from cranktrain.quantities import nearest

_SUGGESTED = 4


def facts_wanted(machine: Machine, wanted: Sequence[str] | None) -> tuple[str, ...]:
    """Names of facts that a sweep gives: those asked for, or the headlines of the machine's questions.

    Raises
    ------
    InputError
        With every name that is no fact of this machine.
    """
    result = run(machine)
    if wanted is None:
        return tuple(name for name in headline_names([result]) if result.catalogue[name].is_fact)
    problems: list[Problem] = []
    for name in dict.fromkeys(wanted):
        entry = result.catalogue.get(name)
        if entry is None and (needs := result.needs_of(name)):
            problems.append(Problem("wanted", name, _("needs {needs}", needs=Listed(needs))))
        elif entry is None:
            meant = nearest(name, list(result.catalogue))
            repair = _("did you mean {name}?", name=meant) if meant else _("`cranktrain list results` names all")
            problems.append(Problem("wanted", name, _("is no result of this machine"), repair))
        elif not entry.is_fact:
            facts = [fact for fact, held in result.catalogue.items() if held.of == name][:_SUGGESTED]
            repair = _("write {facts}", facts=", ".join(facts)) if facts else None
            problems.append(Problem("wanted", name, _("is a curve, and a sweep takes facts"), repair))
    refuse(problems)
    if not wanted:
        raise InputError([Problem("wanted", None, _("must be names of facts, with commas between"))])
    return tuple(dict.fromkeys(wanted))
