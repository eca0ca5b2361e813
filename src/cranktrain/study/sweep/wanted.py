"""Which facts a sweep is asked for."""

from collections.abc import Sequence

from cranktrain.analysis import Result, run
from cranktrain.analysis.fact_values import headline_names
from cranktrain.errors import InputError, Problem, refuse
from cranktrain.language import Listed, _
from cranktrain.machine import Machine
from cranktrain.quantities import nearest
from cranktrain.saying.run import Run
from cranktrain.study.start import start
from cranktrain.study.starts import FACTS_SHOWN

_SUGGESTED = 4


def facts_wanted(machine: Machine, wanted: Sequence[str] | None, *, over_time: bool = False) -> tuple[str, ...]:
    """Names of facts that a sweep gives: those asked for, or the headlines of the machine's questions, or of a start.

    Raises
    ------
    InputError
        With every name that is no fact of this machine.
    """
    result: Run = start(machine) if over_time else run(machine)
    if wanted is None:
        named = headline_names([result]) if isinstance(result, Result) else FACTS_SHOWN
        return tuple(name for name in named if not result.is_curve(result.catalogue[name]))
    absent = _("is no result of its start") if over_time else _("is no result of this machine")
    problems: list[Problem] = []
    for name in dict.fromkeys(wanted):
        entry = result.catalogue.get(name)
        if entry is None and (needs := result.needs_of(name)):
            problems.append(Problem("wanted", name, _("needs {needs}", needs=Listed(needs))))
        elif entry is None:
            meant = nearest(name, [fact for fact, held in result.catalogue.items() if not result.is_curve(held)])
            repair = _("did you mean {name}?", name=meant) if meant else _("`cranktrain list results` names all")
            if "," in name:
                repair = _("write them one by one: {names}", names=[part.strip() for part in name.split(",")])
            problems.append(
                Problem(
                    "wanted",
                    name,
                    absent,
                    repair,
                )
            )
        elif result.is_curve(entry):
            facts = [fact for fact, held in result.catalogue.items() if held.of == name][:_SUGGESTED]
            repair = _("write {facts}", facts=", ".join(facts)) if facts else None
            problems.append(Problem("wanted", name, _("is a curve, and a sweep takes facts"), repair))
    refuse(problems)
    if not wanted:
        raise InputError([Problem("wanted", None, _("must be names of facts, with commas between"))])
    return tuple(dict.fromkeys(wanted))
