"""Which texts speak of a machine, as commands that show what they say of it."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace

import numpy as np

from cranktrain.errors import InputError, Problem
from cranktrain.language import Words, _
from cranktrain.machine import Machine
from cranktrain.plans.machine_throw import ThrownMachine
from cranktrain.textbook.commands import textbook_command
from cranktrain.textbook.shown.of_machine import texts_for


def speaking(machine: Machine, file: str, settings: Sequence[str] = ()) -> Iterator[str]:
    """Commands by which texts have something for a machine."""
    for text in texts_for(machine):
        yield textbook_command(file, "--source", text.name, settings=settings)
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
    return lambda one: replace(one, repair=_instead(machine, file, settings)) if one.path in paths else one


def _instead(machine: Machine, file: str, settings: Sequence[str]) -> Words:
    """Say which texts speak of a machine, or that none does."""
    commands = [f"`{command}`" for command in speaking(machine, file, settings)]
    if not commands:
        return _("none of the texts speaks of this machine")
    return _("the texts speak of this machine in {commands}", commands=", ".join(commands))
