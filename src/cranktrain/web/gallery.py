"""Machines to begin with, each with a small drawing: the examples, and a new machine of each kind."""

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from cranktrain.io.examples import example_names
from cranktrain.io.machine_file import read_machine
from cranktrain.io.machine_source import source_of_text
from cranktrain.io.starting import starting_file
from cranktrain.io.title import title
from cranktrain.language import Words, _
from cranktrain.machine import Machine
from cranktrain.mechanisms import KINDS
from cranktrain.one_line import one_line
from cranktrain.panels.drawing import MachineDrawing
from cranktrain.panels.drawing_of_machine import machine_drawing
from cranktrain.plans.placement import first_throw
from cranktrain.record import record

_STEP = 20.0
"""Between positions, by which a drawing finds its room. [deg]"""


@record
class GalleryItem:
    """A machine to begin with.

    Attributes
    ----------
    name : str
        Of the example or the kind.
    title, kind : Words
        What people call the machine, and its first mechanism.
    made_of : Words
        Which machine it is, in one line.
    text : str
        Of the machine file of a new machine; none of an example, which is known by its name.
    drawing : MachineDrawing
        Of a throw, over a turn.
    """

    name: str
    title: Words
    kind: Words
    made_of: Words
    text: str
    drawing: MachineDrawing


@record
class GalleryWords:
    """Words of the choice of a machine."""

    examples: Words
    kinds: Words
    search: Words
    open: Words
    close: Words
    none: Words


@record
class Gallery:
    """All of them: examples by their names, kinds in their order."""

    examples: tuple[GalleryItem, ...]
    kinds: tuple[GalleryItem, ...]
    words: GalleryWords


def gallery() -> Gallery:
    """Read all examples and make a machine of each kind, and draw a throw of each."""
    return Gallery(
        examples=tuple(_examples()),
        kinds=tuple(_kinds()),
        words=GalleryWords(
            examples=_("Real machines"),
            kinds=_("New machines"),
            search=_("Search: a name, a kind, a year"),
            open=_("Open a machine file"),
            close=_("Close"),
            none=_("No machine has these words"),
        ),
    )


def _examples() -> Iterator[GalleryItem]:
    """Give the examples."""
    for name in example_names():
        machine = read_machine(name, partial=True).machine
        called = one_line(machine.name.strip()) or name
        yield GalleryItem(name, called, _(machine.places[0].kind.title), title(machine), "", _small(machine))


def _kinds() -> Iterator[GalleryItem]:
    """Give a new machine of each kind."""
    for name in KINDS.names:
        kind = KINDS.named(name)
        text = starting_file(kind)
        machine = source_of_text(text, {}).with_set().machine
        yield GalleryItem(name, _(kind.title), "", title(machine), text, _small(machine))


def _small(machine: Machine) -> MachineDrawing:
    """Draw its first throw, and nothing that a small picture has no room for."""
    angles = np.arange(0.0, 360.0 + _STEP / 2, _STEP)
    drawing = machine_drawing(machine, angles, mechanism=first_throw(machine)[0].name)
    return replace(drawing, mechanisms=tuple(replace(one, paths={}) for one in drawing.mechanisms), loads=())
