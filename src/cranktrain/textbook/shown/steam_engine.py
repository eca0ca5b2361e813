"""What the steam engine's text has for a machine: its forms of motion, exact root, minus signs, Z, constructions."""

from collections.abc import Iterator, Sequence

import numpy as np

from cranktrain.language import _
from cranktrain.layout.places import PlacedMechanism
from cranktrain.plans.constructions import construction
from cranktrain.plans.placement import name_of_output
from cranktrain.saying.sections import Column, Grid, PagePart, ShownSection
from cranktrain.saying.wording import number
from cranktrain.textbook.alike import AlikePistons, alike
from cranktrain.textbook.construction_statements import arc_statement, backward_statements
from cranktrain.textbook.motion_statements import form_heading, root_notes
from cranktrain.textbook.shown.forms import form_errors, form_sections, ranges_of
from cranktrain.textbook.shown.of_machine import MachinePage, TextOfMachine, nothing
from cranktrain.textbook.shown.tables import EXACT, ROUND_ANGLES, curve_section, stated_error_grid
from cranktrain.textbook.steam_engine_statements import (
    crank_side_curves,
    crank_side_statements,
    difference_statements,
    root_statements,
)
from cranktrain.texts.plain_cranks import PLAIN
from cranktrain.texts.ranges import EXACT_ROOT

_SOURCE = EXACT_ROOT.source
_PARTS = 10
"""Of the stroke, where a table of a construction is shown."""


def _whole(page: MachinePage) -> Iterator[PagePart]:
    """Give all but the motion over the turn."""
    yield from form_sections(page, _SOURCE)
    if pistons := alike(page.machine.places, PLAIN):
        yield _exact_root(page, pistons)
        yield from _from_crank_side(page, pistons)
        yield from _constructions(page, pistons)


def _exact_root(page: MachinePage, pistons: Sequence[AlikePistons]) -> ShownSection:
    """The source's displacement before its root is approximated."""
    found = [statement for one in pistons for statement in root_statements(one)]
    right = [one.value for one in found if one.verdict == "right"]
    rounding = [_("exact: off by 0, in numbers by up to {off:.0e} from rounding", off=max(right))] if right else []
    return ShownSection(
        form_heading(EXACT_ROOT), (*root_notes(page.machine.places), *rounding, stated_error_grid(found))
    )


def _from_crank_side(page: MachinePage, pistons: Sequence[AlikePistons]) -> Iterator[ShownSection]:
    """(333), (336), (337) with the minus sign, beside the exact ones, and Z."""
    about = _("φ and S from there, S away from the shaft; v and j away from the shaft, too: the minus sign")
    errors = stated_error_grid(statement for one in pistons for statement in crank_side_statements(one))
    yield ShownSection(_("(333), (336), (337) from the crank-side dead centre [steam-engine]"), (about, errors))
    for one in pistons if page.with_table else ():
        piston = name_of_output(page.machine, one.first)
        heading = _("S, v/ω and j/ω² of {piston} from the crank-side dead centre", piston=piston)
        curves = crank_side_curves(one, np.deg2rad(ROUND_ANGLES))
        yield curve_section(heading, ROUND_ANGLES, ((curve.equation, curve) for curve in curves))
    found = [statement for one in pistons for statement in difference_statements(one)]
    columns = [
        Column("Z", [one.value for one in found], "mm"),
        Column(_(EXACT), [one.exact for one in found], "mm"),
        Column("ΔZ", [one.error / one.exact for one in found], "%", "percent"),
    ]
    about = _("by how much (333) and (334) differ at most, at 90° and 270°; beside it, exact: L − √(L² − R²)")
    yield ShownSection(_("Z = λR/2: (335) [steam-engine]"), (about, Grid(columns, [one.of for one in found])))


def _constructions(page: MachinePage, pistons: Sequence[AlikePistons]) -> Iterator[ShownSection]:
    """Arcs, and Brix's construction read backwards."""
    off = max(arc_statement(page.machine, one).value for one in pistons)
    words = _("exact, for an offset line of stroke too; largest error {off:.0e} of the stroke, from rounding", off=off)
    yield ShownSection(_("Arcs of the rod's length about the piston's pin"), (words,))
    read = [backward_statements(page.machine, one) for one in pistons]
    columns = [
        Column("OP = λR/2", [pole.value for pole, _error, _way in read], "mm"),
        Column("Δφ", [error.value for _pole, error, _way in read], "deg"),
        Column("S", [way.value for _pole, _error, way in read], "mm"),
    ]
    about = _(
        "crank angle from the displacement: largest error, and where; the pole P lies away from the cylinder or valve"
    )
    heading = _("Brix's construction backwards: fig. 147 [steam-engine]")
    yield ShownSection(heading, (about, Grid(columns, [one.of for one in pistons])))
    if page.with_table:
        yield _backwards(page, pistons[0].first)


def _backwards(page: MachinePage, first: PlacedMechanism) -> ShownSection:
    """The angles that Brix's construction gives for tenths of the stroke, beside the exact ones."""
    read = construction(page.machine, "brix_backward", _PARTS, mechanism=first.name)
    angles = {"brix": read.angle, _(EXACT): read.exact_angle, "Δφ": read.angle - read.exact_angle}
    columns = [Column(head, values.tolist(), "deg") for head, values in angles.items()]
    piston = name_of_output(page.machine, first)
    heading = _("φ of {piston} by the displacement S, on the way to the shaft", piston=piston)
    return ShownSection(heading, (Grid(columns, [number(value, "mm") for value in read.displacement.tolist()]),))


OF_MACHINE = TextOfMachine(
    speaks=lambda machine: bool(ranges_of(machine, _SOURCE)),
    whole=_whole,
    beside=nothing,
    errors=lambda page: form_errors(page, _SOURCE),
    usual="two_harmonics",
)
