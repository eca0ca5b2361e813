"""What the steam engine's text constructs and no curve of the turn is: arc, Brix's pole, Brix read backwards."""

from collections.abc import Sequence

import numpy as np
from rich.console import Console

from cranktrain.cli.screen.columns import Column, column_tables, section_of_columns
from cranktrain.cli.screen.text import INDENT, section
from cranktrain.cli.textbook.piston_words import called
from cranktrain.language import _
from cranktrain.layout.places import PlacedMechanism
from cranktrain.machine import Machine
from cranktrain.plans.constructions import construction
from cranktrain.textbook.construction_statements import arc_statement, backward_statements
from cranktrain.textbook.distinct_pistons import AlikePistons
from cranktrain.wording import figure, number

_PARTS = 10
"""Of the stroke, where a table of a construction is shown."""


def show_constructions(
    console: Console, machine: Machine, pistons: Sequence[AlikePistons], *, with_table: bool
) -> None:
    """Show them for slider-cranks and eccentrics."""
    off = max(arc_statement(machine, one).value for one in pistons)
    words = _("exact, for an offset line of stroke too; largest error {off:.0e} of the stroke, from rounding")
    section(console, _("Arcs of the rod's length about the piston's pin"), [words.format(off=off)])
    read = [backward_statements(machine, one) for one in pistons]
    columns = [
        Column("OP = λR/2", "mm", tuple(figure(pole.value, "mm") for pole, _error, _way in read)),
        Column("Δφ", "deg", tuple(f"{np.rad2deg(error.value):.2f}" for _pole, error, _way in read)),
        Column("S", "mm", tuple(figure(way.value, "mm") for _pole, _error, way in read)),
    ]
    about = _(
        "crank angle from the displacement: largest error, and where; the pole P lies away from the cylinder or valve"
    )
    lines = [about, *column_tables(columns, [one.of for one in pistons], console.width - INDENT)]
    section(console, _("Brix's construction backwards: fig. 147 [steam-engine]"), lines)
    if with_table:
        _show_backwards(console, machine, pistons[0].first)


def _show_backwards(console: Console, machine: Machine, first: PlacedMechanism) -> None:
    """Show the angles that Brix's construction gives for tenths of the stroke, beside the exact ones."""
    read = construction(machine, "brix_backward", _PARTS, mechanism=first.name)
    labels = [number(value, "mm") for value in read.displacement]
    angles = (read.angle, read.exact_angle, read.angle - read.exact_angle)
    columns = [
        Column(head, "deg", tuple(f"{np.rad2deg(value):.2f}" for value in values))
        for head, values in zip(("brix", "exact", "Δφ"), angles, strict=True)
    ]
    heading = _("φ of {piston} by the displacement S, on the way to the shaft").format(piston=called(first))
    section_of_columns(console, heading, columns, labels)
