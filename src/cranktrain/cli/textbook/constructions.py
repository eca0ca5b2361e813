"""What the steam engine's text constructs and no curve of the turn is: arc, Brix's pole, Brix read backwards."""

from collections.abc import Mapping, Sequence

import numpy as np
from rich.console import Console

from cranktrain.cli.screen.columns import Column, column_tables, section_of_columns
from cranktrain.cli.screen.text import INDENT, section
from cranktrain.language import _
from cranktrain.layout.places import PlacedMechanism
from cranktrain.machine import Machine
from cranktrain.mechanisms.slider_crank import SliderCrank
from cranktrain.numerics.ties import first_largest
from cranktrain.plans.constructions import Construction, construction
from cranktrain.wording import figure, number, ranged

_PARTS, _FINE = 10, 720
"""Of the stroke or turn: where a table of a construction is shown, and where its largest error is sought."""


def show_constructions(
    console: Console,
    machine: Machine,
    cranks: Sequence[PlacedMechanism],
    groups: Mapping[SliderCrank, Sequence[int]],
    *,
    with_table: bool,
) -> None:
    """Show them for slider-cranks; `groups` are places of equal ones."""
    names = [place.name for place in cranks]
    said = [ranged(names, members) for members in groups.values()]
    firsts = [cranks[members[0]] for members in groups.values()]
    arcs = [construction(machine, "arc", _FINE, mechanism=first.name) for first in firsts]
    off = max(float(np.max(np.abs(arc.displacement - arc.exact_displacement) / arc.stroke)) for arc in arcs)
    words = _("exact, for an offset line of stroke too; largest error {off:.0e} of the stroke, from rounding")
    section(console, _("Arcs of the rod's length about the piston's pin"), [words.format(off=off)])
    read = [construction(machine, "brix_backward", _FINE, mechanism=first.name) for first in firsts]
    errors = [np.rad2deg(one.angle - one.exact_angle) for one in read]
    worst = [first_largest(np.abs(error)) for error in errors]
    columns = [
        Column("OP = λR/2", "mm", tuple(figure(-one.pole, "mm") for one in read)),
        Column("Δφ", "deg", tuple(f"{error[at]:.2f}" for error, at in zip(errors, worst, strict=True))),
        Column("S", "mm", tuple(figure(one.displacement[at], "mm") for one, at in zip(read, worst, strict=True))),
    ]
    about = _("crank angle from the displacement: largest error, and where; the pole P lies away from the cylinder")
    lines = [about, *column_tables(columns, said, console.width - INDENT)]
    section(console, _("Brix's construction backwards: fig. 147 [steam-engine]"), lines)
    if with_table:
        _show_backwards(console, construction(machine, "brix_backward", _PARTS, mechanism=firsts[0].name))


def _show_backwards(console: Console, read: Construction) -> None:
    """Show the angles that Brix's construction gives for tenths of the stroke, beside the exact ones."""
    labels = [number(value, "mm") for value in read.displacement]
    angles = (read.angle, read.exact_angle, read.angle - read.exact_angle)
    columns = [
        Column(head, "deg", tuple(f"{np.rad2deg(value):.2f}" for value in values))
        for head, values in zip(("brix", "exact", "Δφ"), angles, strict=True)
    ]
    heading = _("φ of piston {piston} by the displacement S, on the way to the shaft").format(piston=read.mechanism)
    section_of_columns(console, heading, columns, labels)
