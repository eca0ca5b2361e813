"""What the steam engine's text constructs and no curve of the turn is: arcs, Brix's pole, Brix read backwards."""

from collections.abc import Iterator, Sequence

import numpy as np

from cranktrain.language import _
from cranktrain.machine import Machine
from cranktrain.numerics.ties import first_largest
from cranktrain.plans.constructions import construction
from cranktrain.textbook.alike import AlikePistons
from cranktrain.textbook.statements import Statement
from cranktrain.texts.ranges import RANGES

BACKWARDS = "largest, backwards"
"""Where an angle is given: where that read from the displacement is most off."""

_SOURCE = "steam-engine"
_BRIX = next(one for one in RANGES if one.method == "brix")
_FINE = 720
"""Parts of a stroke or turn among which the largest error is sought."""


def construction_statements(machine: Machine, pistons: Sequence[AlikePistons]) -> Iterator[Statement]:
    """Give all of them, of cranks and eccentrics."""
    for one in pistons:
        yield arc_statement(machine, one)
    for one in pistons:
        yield from backward_statements(machine, one)


def arc_statement(machine: Machine, one: AlikePistons) -> Statement:
    """Give what positions by arcs are off: rounding, at no certain angle."""
    arcs = construction(machine, "arc", _FINE, mechanism=one.first.name)
    off = float(np.max(np.abs(arcs.displacement - arcs.exact_displacement) / arcs.stroke))
    name = _("arcs of the rod's length about the piston's pin")
    return Statement(_SOURCE, "fig. 146", "Δx", name, one.of, "largest", off, "1", "right", 0.0)


def backward_statements(machine: Machine, one: AlikePistons) -> tuple[Statement, Statement, Statement]:
    """Give Brix's pole, and by how much the angles are off that are read from displacements, where that is most."""
    read = construction(machine, "brix_backward", _FINE, mechanism=one.first.name)
    error = read.angle - read.exact_angle
    worst = first_largest(np.abs(error))
    angle, verdict = float(np.rad2deg(read.exact_angle[worst])), one.verdict(_BRIX)
    name = _("Brix's construction backwards: crank angle from the displacement")
    way = float(read.displacement[worst])
    pole = _("Brix's pole, from the shaft away from the cylinder")
    there = _("displacement where Brix's construction backwards is most off")
    return (
        Statement(_SOURCE, "fig. 147", "OP", pole, one.of, "pole", -read.pole, "m", verdict),
        Statement(_SOURCE, "fig. 147", "Δφ", name, one.of, BACKWARDS, float(error[worst]), "rad", verdict, 0.0, angle),
        Statement(_SOURCE, "fig. 147", "S", there, one.of, BACKWARDS, way, "m", "right", way, angle),
    )
