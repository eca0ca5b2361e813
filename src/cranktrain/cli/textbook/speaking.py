"""Which texts speak of a machine, as commands that show what they say of it."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace

import numpy as np

from cranktrain.cli.to_type import textbook_command
from cranktrain.errors import InputError, Problem
from cranktrain.language import said as _
from cranktrain.machine import Machine
from cranktrain.plans.machine_throw import ThrownMachine
from cranktrain.textbook.opposed_statements import opposed_cylinders
from cranktrain.texts.comparison import FORMS
from cranktrain.texts.ranges import RANGES


def speaking(machine: Machine, file: str, settings: Sequence[str] = ()) -> Iterator[str]:
    """Commands by which texts have something for a machine."""
    kinds = {place.kind.name for place in machine.places}
    sources = dict.fromkeys(one.source for one in RANGES if not kinds.isdisjoint(FORMS[one.method]))
    if "bolotin" not in sources and opposed_cylinders(machine.places):
        sources["bolotin"] = None
    if "crank_rocker" in kinds:
        sources["gandzha"] = None
    for source in sources:
        yield textbook_command(file, "--source", source, settings=settings)
    if machine.crankshaft is not None and _has_throw(machine):
        yield textbook_command("--throw", file, settings=settings)


def _has_throw(machine: Machine) -> bool:
    """Whether the text on throws speaks of the first of a machine's."""
    try:
        of = ThrownMachine(machine)
        of.throw(next(iter(of.throws)), np.zeros(1))
    except InputError:
        return False
    return True


def with_speaking(
    machine: Machine, file: str, settings: Sequence[str], paths: Sequence[str]
) -> Callable[[Problem], Problem]:
    """Add which texts do speak of the machine to a problem of those paths: a text speaks of no such machine."""

    def said(problem: Problem) -> Problem:
        return replace(problem, repair=instead(machine, file, settings)) if problem.path in paths else problem

    return said


def instead(machine: Machine, file: str, settings: Sequence[str]) -> str:
    """Say which texts speak of a machine, or that none does."""
    commands = [f"`{command}`" for command in speaking(machine, file, settings)]
    if not commands:
        return _("none of the texts speaks of this machine")
    return _("the texts speak of this machine in {commands}", commands=", ".join(commands))
