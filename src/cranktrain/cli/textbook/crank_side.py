"""The steam engine's forms from the crank-side dead centre, with the minus sign, and Z of (335)."""

from collections.abc import Mapping, Sequence

import numpy as np
from rich.console import Console

from cranktrain.cli.screen.columns import Column, column_tables, section_of_columns
from cranktrain.cli.screen.text import INDENT, section
from cranktrain.cli.textbook.error_columns import error_columns
from cranktrain.language import _
from cranktrain.layout.places import PlacedMechanism
from cranktrain.mechanisms.slider_crank import SliderCrank
from cranktrain.motion import Array, Coefficient
from cranktrain.texts.largest_errors import from_bottom, largest_errors
from cranktrain.texts.percents import percent
from cranktrain.texts.steam_engine import largest_difference, two_harmonics_from_crank_side
from cranktrain.wording import figure, ranged

_STEP = 30
"""Of the crank angle in tables. [deg]"""
_UNITS = ("mm", "mm/rad", "mm/rad^2")


def show_from_crank_side(
    console: Console,
    places: Sequence[PlacedMechanism],
    groups: Mapping[SliderCrank, Sequence[int]],
    *,
    with_table: bool,
) -> None:
    """Show (333), (336), (337) with the minus sign for slider-cranks, and Z; `groups` are places of equal ones."""
    width = console.width - INDENT
    names = [place.name for place in places]
    said = [ranged(names, members) for members in groups.values()]
    errors = [largest_errors(lambda angle, one=one: _minus(angle, one), from_bottom(one)) for one in groups]
    about = _("φ and S from there, S away from the shaft; v and j away from the shaft, too: the minus sign")
    lines = [about, *error_columns(errors, said, width)]
    section(console, _("(333), (336), (337) from the crank-side dead centre [steam-engine]"), lines)
    if with_table:
        for one, members in groups.items():
            _show_table(console, names[members[0]], one)
    about = _("by how much (333) and (334) differ at most, at 90° and 270°; beside it, exact: L − √(L² − R²)")
    section(console, _("Z = λR/2: (335) [steam-engine]"), [about, *column_tables(_differences(groups), said, width)])


def _minus(angle: Array, one: SliderCrank) -> Coefficient:
    """The forms from the crank-side dead centre."""
    return two_harmonics_from_crank_side(angle, one.crank_radius, one.crank_radius / one.rod_length)


def _differences(groups: Mapping[SliderCrank, Sequence[int]]) -> list[Column]:
    """Z by the source, as it is, and its error; of an offset mechanism by the source alone."""
    source = [float(largest_difference(one.crank_radius, one.crank_radius / one.rod_length)) for one in groups]
    exact = [
        # L − √(L² − R²), which loses no figures of a long rod
        float(one.crank_radius**2 / (one.rod_length + np.sqrt(one.rod_length**2 - one.crank_radius**2)))
        if one.offset == 0.0
        else np.nan
        for one in groups
    ]
    errors = [own / true - 1.0 for own, true in zip(source, exact, strict=True)]
    return [
        Column("Z", "mm", tuple(figure(value, "mm") for value in source)),
        Column(_("exact"), "mm", tuple(figure(value, "mm") for value in exact)),
        Column("ΔZ", "%", tuple(map(percent, errors))),
    ]


def _show_table(console: Console, piston: str, one: SliderCrank) -> None:
    """Show S, v and j of a piston by (333), (336), (337) with the minus sign, beside the exact ones."""
    angle = np.deg2rad(np.arange(0, 360, _STEP, dtype=float))
    own, exact = _minus(angle, one), from_bottom(one)(angle)
    columns = [
        Column(head, unit, tuple(figure(value, "mm") for value in values))
        for form, true, number, unit in zip(own, exact, ("(333)", "(336)", "(337)"), _UNITS, strict=True)
        for head, values in ((number, form), (_("exact"), true))
    ]
    heading = _("S, v/ω and j/ω² of piston {piston} from the crank-side dead centre").format(piston=piston)
    section_of_columns(console, heading, columns, [f"{step}°" for step in range(0, 360, _STEP)])
