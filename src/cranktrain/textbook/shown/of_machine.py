"""What a text has for a machine, told by the text: whether it speaks of it, and what it shows."""

from collections.abc import Callable, Iterator, Sequence
from importlib import import_module
from typing import NamedTuple, Never

from cranktrain.analysis import Result
from cranktrain.language import Words
from cranktrain.machine import Machine
from cranktrain.record import record
from cranktrain.saying.sections import PagePart
from cranktrain.texts.contents import TEXTS, Text


class FormErrors(NamedTuple):
    """The largest errors of a form: its numbers, whose they are, of displacement, velocity and acceleration, a word."""

    equations: str
    of: str
    errors: Sequence[float]
    words: Words


class MachinePage(NamedTuple):
    """A machine with its run, whether its motion over the turn is shown, and whether one text alone is asked for."""

    machine: Machine
    result: Result
    with_table: bool
    is_of_one: bool


@record
class TextOfMachine:
    """What a text has for a machine.

    Attributes
    ----------
    speaks : callable
        Whether it has anything for a machine.
    whole : callable
        All that it has but forms of motion over the turn.
    beside : callable
        What it has on the first screen beside errors or the motion by its usual form.
    errors : callable
        The largest errors of its forms.
    usual : str
        The form of motion that is shown first over the turn; none of a text without such forms.
    """

    speaks: Callable[[Machine], bool]
    whole: Callable[[MachinePage], Iterator[PagePart]]
    beside: Callable[[MachinePage], Iterator[PagePart]]
    errors: Callable[[MachinePage], Iterator[FormErrors]]
    usual: str = ""


def nothing(_page: MachinePage) -> Iterator[Never]:
    """What a text has that has nothing there."""
    return iter(())


def texts_for(machine: Machine, text: Text | None = None) -> dict[Text, TextOfMachine]:
    """Give the texts, or one of them if it does, that speak of a machine, with what they have for it."""
    found = {
        one: import_module(f"{__package__}.{one.of_machine}").OF_MACHINE
        for one in (TEXTS if text is None else (text,))
        if one.of_machine
    }
    return {one: has for one, has in found.items() if has.speaks(machine)}
