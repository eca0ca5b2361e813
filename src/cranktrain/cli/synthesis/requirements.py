"""What was typed for a synthesis: each requirement read as what it must be, and all that is wrong with them at once."""

import re
from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace
from functools import partial
from inspect import Parameter, signature
from typing import TypeAlias

from cranktrain.declared_types import parts_of, quantity_of, words_of
from cranktrain.errors import InputError, Position, Problem, problems_as, refuse
from cranktrain.io.machine_file import MachineFile
from cranktrain.language import Words
from cranktrain.language import said as _
from cranktrain.machine import Machine
from cranktrain.quantities import Dimension, QuantityError, unlisted
from cranktrain.spec import missing
from cranktrain.synthesis.counterbalance import counterbalance
from cranktrain.synthesis.counterweights import counterweights
from cranktrain.synthesis.crank_rocker import crank_rocker_from_swing
from cranktrain.synthesis.drive import drive
from cranktrain.synthesis.knuckle import knuckle_from_requirements
from cranktrain.synthesis.proposal import Proposal
from cranktrain.synthesis.quick_return import quick_return
from cranktrain.synthesis.radial import radial
from cranktrain.synthesis.relief import Progress
from cranktrain.synthesis.slider_crank import slider_crank_from_stroke

Typed: TypeAlias = Mapping[str, str | bool | None]
"""Requirements by the names of a synthesis's parameters, as typed; None where nothing was."""

SYNTHESES: Mapping[str, Callable[..., Proposal]] = {
    "slider-crank": slider_crank_from_stroke,
    "crank-rocker": crank_rocker_from_swing,
    "quick-return": quick_return,
    "knuckle": knuckle_from_requirements,
    "radial": radial,
    "counterweights": counterweights,
    "counterbalance": counterbalance,
    "drive": drive,
}
"""What can be synthesised; the annotations of its parameters say what each is, and what may be typed for it."""

_FREE = "free"
"""What stands for None, a dimension that is to be chosen, where something else stands unless given."""

_MOST_CYLINDERS = 99
_PROGRESS = "progress"
"""Of a synthesis that searches long: what it tells while it does."""


def requirements_of(problem: str) -> Iterable[Parameter]:
    """Parameters of a synthesis that are typed as options, by its key in `SYNTHESES`."""
    every = signature(SYNTHESES[problem]).parameters.values()
    return [one for one in every if one.annotation is not Machine and one.name != _PROGRESS]


def is_of_machine(problem: str) -> bool:
    """Whether a synthesis, by its key in `SYNTHESES`, is for a machine that there is."""
    return any(one.annotation is Machine for one in signature(SYNTHESES[problem]).parameters.values())


def form_of(requirement: Parameter) -> str:
    """Say in short what is typed for a parameter."""
    quantity, words = quantity_of(requirement.annotation), words_of(requirement.annotation)
    if quantity is None:
        return "|".join(map(str, words)) if len(words) == 2 else requirement.name.upper()
    form = "NUMBER" if quantity.dimension is Dimension.RATIO else quantity.dimension.name
    return f"{form}|{_FREE}" if _can_be_free(requirement) else form


def proposed(problem: str, typed: Typed, file: MachineFile | None = None, progress: Progress | None = None) -> Proposal:
    """Read requirements and find dimensions for them.

    Parameters
    ----------
    problem : str
        A key of `SYNTHESES`; what its parameters without a default are called must be typed.
    typed : mapping
    file : MachineFile, optional
        Of the machine that it is for, where it is for one.
    progress : callable, optional
        What such a synthesis tells while it searches.

    Returns
    -------
    Proposal

    Raises
    ------
    InputError
        With every requirement that is missing or no such quantity; else with what the synthesis says, of the options
        as typed.
    """
    problems: list[Problem] = []
    requirements: dict[str, object] = {}
    for requirement in requirements_of(problem):
        given = typed.get(requirement.name)
        try:
            if given is not None:
                requirements[requirement.name] = _value(requirement, given)
            elif requirement.default is Parameter.empty:
                allowed = missing(requirement.annotation, requirement.name)
                problems.append(Problem(option_of(requirement.name), None, allowed))
        except InputError as error:
            problems += [replace(one, path=option_of(requirement.name)) for one in error.problems]
    refuse(problems)
    machine = () if file is None else (file.machine,)
    if file is not None and _PROGRESS in signature(SYNTHESES[problem]).parameters:
        requirements[_PROGRESS] = progress
    with problems_as(partial(_in_options, typed, Position(f"cranktrain synthesise {problem}"), file)):
        return SYNTHESES[problem](*machine, **requirements)


def option_of(name: str) -> str:
    """Option by which a parameter is typed."""
    return f"--{name.removeprefix('n_').replace('_', '-')}"


def _value(requirement: Parameter, given: str | bool) -> object:
    """Read one requirement."""
    quantity, words = quantity_of(requirement.annotation), words_of(requirement.annotation)
    if isinstance(given, bool):
        return given
    if str in parts_of(requirement.annotation) and not words:
        return given.strip()
    if quantity is None:
        chosen = given.strip().casefold().replace("-", "_")
        if chosen not in words:
            raise InputError([unlisted(requirement.name, given, words)])
        return chosen
    if _can_be_free(requirement) and given.strip().casefold() == _FREE:
        return None
    value = quantity.of_field(requirement.name).given(given).si
    if int in parts_of(requirement.annotation):
        if value != round(value) or value > _MOST_CYLINDERS:
            raise QuantityError(given, _("must be a whole number up to {most}", most=_MOST_CYLINDERS))
        return round(value)
    return value


def _can_be_free(requirement: Parameter) -> bool:
    """Tell whether a parameter may be None, and is something else unless given."""
    return requirement.default is not None and type(None) in parts_of(requirement.annotation)


def _in_options(typed: Typed, command: Position, file: MachineFile | None, problem: Problem) -> Problem:
    """Speak of options, and of what was typed, where a synthesis speaks of its parameters; else of the file."""
    repair = problem.repair and _with_options(problem.repair, typed)
    if file is not None and problem.path not in typed:
        here = file.document.located(problem)
        return replace(here, repair=repair)
    given = typed.get(problem.path)
    return Problem(
        option_of(problem.path) if problem.path else "",
        given.strip() if isinstance(given, str) else problem.given,
        _with_options(problem.allowed, typed),
        repair,
        problem.position if problem.path else command,
    )


def _with_options(sentence: Words, typed: Typed) -> str:
    """Write `--rod-length` for `rod_length` in a sentence; a name of one word may be a plain word."""
    names = "|".join(name for name in typed if "_" in name)
    return re.sub(rf"\b({names})\b", lambda found: option_of(found[0]), str(sentence))
