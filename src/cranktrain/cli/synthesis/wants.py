"""What was typed for a synthesis: each want read as what it must be, and all that is wrong with them at once."""

import inspect
import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from typing import Any, TypeAlias

from cranktrain.errors import InputError, Position, Problem
from cranktrain.language import _
from cranktrain.quantities import Dimension, Quantity, QuantityError, expected, one_of, unlisted
from cranktrain.synthesis.crank_rocker import crank_rocker_from_swing
from cranktrain.synthesis.knuckle import knuckle_from_wants
from cranktrain.synthesis.proposal import Proposal
from cranktrain.synthesis.quick_return import quick_return
from cranktrain.synthesis.radial import STRATEGIES, radial
from cranktrain.synthesis.slider_crank import slider_crank_from_stroke

Typed: TypeAlias = Mapping[str, str | bool | None]
"""Wants by the names of a synthesis's parameters, as typed; None where nothing was."""

SYNTHESES: Mapping[str, Callable[..., Proposal]] = {
    "slider-crank": slider_crank_from_stroke,
    "crank-rocker": crank_rocker_from_swing,
    "quick-return": quick_return,
    "knuckle": knuckle_from_wants,
    "radial": radial,
}
"""What can be synthesised."""

FREE = "free"
"""What stands for an offset that is to be chosen."""

_DIMENSIONS = {
    "stroke": Dimension.LENGTH,
    "pressure_angle": Dimension.ANGLE,
    "return_pressure_angle": Dimension.ANGLE,
    "rod_length": Dimension.LENGTH,
    "offset": Dimension.LENGTH,
    "mean_speed": Dimension.VELOCITY,
    "speed": Dimension.SPEED,
    "swing": Dimension.ANGLE,
    "time_ratio": Dimension.RATIO,
    "ratio": Dimension.RATIO,
    "rocker_length": Dimension.LENGTH,
    "transmission_angle": Dimension.ANGLE,
    "crank_radius": Dimension.LENGTH,
    "master_rod_length": Dimension.LENGTH,
    "bank_angle": Dimension.ANGLE,
    "master_offset": Dimension.LENGTH,
    "same_ratio": Dimension.RATIO,
    "knuckle_radius": Dimension.LENGTH,
    "articulation_angle": Dimension.ANGLE,
    "bore": Dimension.LENGTH,
    "n_cylinders": Dimension.RATIO,
    "slave_rod_length": Dimension.LENGTH,
    "compression_ratio": Dimension.RATIO,
}

_CHOICES = {
    "working_stroke": ("toward", "away"),
    "slow_stroke": ("toward", "away"),
    "slow_swing": ("forward", "backward"),
    "unshifted": ("top", "bottom"),
    "strategy": tuple(STRATEGIES),
}

_MOST_CYLINDERS = 99

_POSITIVE = ("bore", "speed")
"""What not every synthesis looks at itself."""

_OPTIONS = {"ratio": "--time-ratio", "n_cylinders": "--cylinders"}
"""Options that are not called as their parameters."""


def proposed(problem: str, typed: Typed) -> Proposal:
    """Read wants and find dimensions for them.

    Parameters
    ----------
    problem : str
        A key of `SYNTHESES`; what its parameters without a default are called must be typed.
    typed : mapping

    Returns
    -------
    Proposal

    Raises
    ------
    InputError
        With every want that is missing or no such quantity; else with what the synthesis says, of the options as typed.
    """
    synthesis = SYNTHESES[problem]
    problems: list[Problem] = []
    wants: dict[str, object] = {}
    for name, parameter in inspect.signature(synthesis).parameters.items():
        given = typed.get(name)
        if given is None:
            if parameter.default is parameter.empty:
                problems.append(Problem(option_of(name), None, _("is missing; {must}").format(must=_must(name))))
            continue
        try:
            wants[name] = _want(name, given)
        except InputError as error:
            problems += [replace(one, path=option_of(name)) for one in error.problems]
    if problems:
        raise InputError(problems)
    try:
        return synthesis(**wants)
    except InputError as error:
        raise InputError(_in_options(error, typed, Position(f"cranktrain synthesise {problem}"))) from None


def option_of(name: str) -> str:
    """Option by which a parameter is typed."""
    return _OPTIONS.get(name, f"--{name.replace('_', '-')}")


def _must(name: str) -> str:
    """Say what a want must be."""
    return one_of(_CHOICES[name]) if name in _CHOICES else expected(_DIMENSIONS[name])


def _want(name: str, given: str | bool) -> object:
    """Read one want."""
    if isinstance(given, bool):
        return given
    if name in _CHOICES:
        chosen = given.strip().casefold().replace("-", "_")
        if chosen not in _CHOICES[name]:
            raise InputError([unlisted(name, given, _CHOICES[name])])
        return chosen
    if name == "offset" and given.strip().casefold() == FREE:
        return None
    value = Quantity(_DIMENSIONS[name], above=0.0 if name in _POSITIVE else None).given(given).si
    if name == "n_cylinders":
        if value != round(value) or value > _MOST_CYLINDERS:
            raise QuantityError(given, _("must be a whole number up to {most}").format(most=_MOST_CYLINDERS))
        return round(value)
    return value


def _in_options(error: InputError, typed: Typed, command: Position) -> Iterator[Problem]:
    """Speak of options, and of what was typed, where a synthesis speaks of its parameters."""
    for problem in error.problems:
        given: Any = typed.get(problem.path)
        yield Problem(
            option_of(problem.path) if problem.path else "",
            given.strip() if isinstance(given, str) else problem.given,
            _with_options(problem.allowed, typed),
            problem.repair and _with_options(problem.repair, typed),
            problem.position if problem.path else command,
        )


def _with_options(sentence: str, typed: Typed) -> str:
    """Write `--rod-length` for `rod_length` in a sentence; a name of one word may be a plain word."""
    names = "|".join(name for name in typed if "_" in name)
    return re.sub(rf"\b({names})\b", lambda found: option_of(found[0]), sentence)
