"""The steam engine's exact root, its forms from the crank-side dead centre, with the minus sign, and Z of (335)."""

from collections.abc import Sequence

import numpy as np
from rich.console import Console

from cranktrain.cli.screen.columns import Column, column_tables
from cranktrain.cli.screen.text import INDENT, section
from cranktrain.cli.textbook.curve_tables import ROUND_ANGLES, show_curves
from cranktrain.cli.textbook.error_columns import stated_error_columns
from cranktrain.cli.textbook.piston_words import called
from cranktrain.language import _
from cranktrain.layout.places import PlacedMechanism
from cranktrain.textbook.distinct_pistons import AlikePistons
from cranktrain.textbook.motion_statements import form_heading, root_notes
from cranktrain.textbook.steam_engine_statements import (
    crank_side_curves,
    crank_side_statements,
    difference_statements,
    root_statements,
)
from cranktrain.texts.percents import percent
from cranktrain.texts.ranges import EXACT_ROOT
from cranktrain.wording import figure


def show_exact_root(console: Console, pistons: Sequence[AlikePistons], places: Sequence[PlacedMechanism]) -> None:
    """Show the source's displacement before its root is approximated."""
    found = [statement for one in pistons for statement in root_statements(one)]
    rounding = max((one.value for one in found if one.verdict == "right"), default=None)
    said = [*root_notes(places)]
    if rounding is not None:
        said += [_("exact: off by 0, in numbers by up to {off:.0e} from rounding").format(off=rounding)]
    section(console, form_heading(EXACT_ROOT), [*said, *stated_error_columns(found, console.width - INDENT)])


def show_from_crank_side(console: Console, pistons: Sequence[AlikePistons], *, with_table: bool) -> None:
    """Show (333), (336), (337) with the minus sign, and Z."""
    width = console.width - INDENT
    errors = [statement for one in pistons for statement in crank_side_statements(one)]
    about = _("φ and S from there, S away from the shaft; v and j away from the shaft, too: the minus sign")
    lines = [about, *stated_error_columns(errors, width)]
    section(console, _("(333), (336), (337) from the crank-side dead centre [steam-engine]"), lines)
    if with_table:
        for one in pistons:
            _show_table(console, one)
    found = [statement for one in pistons for statement in difference_statements(one)]
    columns = [
        Column("Z", "mm", tuple(figure(one.value, "mm") for one in found)),
        Column(_("exact"), "mm", tuple(figure(one.exact, "mm") for one in found)),
        Column("ΔZ", "%", tuple(percent(one.error / one.exact) for one in found)),
    ]
    about = _("by how much (333) and (334) differ at most, at 90° and 270°; beside it, exact: L − √(L² − R²)")
    lines = [about, *column_tables(columns, [one.of for one in found], width)]
    section(console, _("Z = λR/2: (335) [steam-engine]"), lines)


def _show_table(console: Console, one: AlikePistons) -> None:
    """Show S, v and j by (333), (336), (337) with the minus sign, beside the exact ones."""
    curves = crank_side_curves(one, np.deg2rad(ROUND_ANGLES))
    heading = _("S, v/ω and j/ω² of {piston} from the crank-side dead centre").format(piston=called(one.first))
    show_curves(console, heading, ROUND_ANGLES, ((curve.equation, curve) for curve in curves), _("exact"))
