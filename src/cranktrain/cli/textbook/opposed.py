"""Opposed pistons by the source: (I.11), (I.12) and both together, volumetric dead centres, and the rule for leads."""

from collections.abc import Iterator, Mapping, Sequence

import numpy as np
from rich.console import Console
from rich.text import Text

from cranktrain.analysis import Result
from cranktrain.cli.screen.columns import Column, column_tables, section_of_columns
from cranktrain.cli.screen.text import INDENT, section
from cranktrain.cli.textbook.error_columns import error_columns
from cranktrain.grouping import grouped
from cranktrain.language import _
from cranktrain.layout.places import PlacedMechanism
from cranktrain.mechanisms.slider_crank import SliderCrank
from cranktrain.numerics import around_zero
from cranktrain.texts.leads import verdict
from cranktrain.texts.opposed import (
    combined_stroke,
    opposed_pistons,
    volumetric_dead_centres,
    volumetric_dead_centres_to_first_order,
)
from cranktrain.texts.opposed_errors import OpposedPair, exact_pair, opposed_errors
from cranktrain.wording import figure, number, ranged

_STEP = 30
"""Of the crank angle in tables. [deg]"""
_DIGITS = 9
"""Of a lead in rad, in which leads of one machine are alike."""

NEEDED = (
    "combined_stroke",
    "inner_volumetric_shift",
    "outer_volumetric_shift",
    "exhaust_opens_before",
    "exhaust_closes_before",
)
"""Results that are shown beside, where a machine gives them."""

Pairs = Mapping[OpposedPair, Sequence[str]]
"""Distinct pairs, and the cylinders of each."""


def opposed_pairs(places: Sequence[PlacedMechanism]) -> dict[OpposedPair, list[str]]:
    """Find opposed slider-cranks that the source speaks of: both pistons driven from their own side."""
    cylinders = grouped((place.cylinder, place) for place in places)
    both = {
        name: {place.name.rpartition(".")[2]: place for place in pair}
        for name, pair in cylinders.items()
        if len(pair) == 2 and all(isinstance(place.geometry, SliderCrank) and not place.is_far for place in pair)
    }
    return grouped((_pair(ends["exhaust"], ends["scavenge"]), name) for name, ends in both.items())


def _pair(exhaust: PlacedMechanism, scavenge: PlacedMechanism) -> OpposedPair:
    """Two pistons of a cylinder, with the lead of the exhaust's crank."""
    lead = round(float(around_zero(np.array(scavenge.nominal_top - exhaust.nominal_top))), _DIGITS)
    return OpposedPair(exhaust.geometry, scavenge.geometry, lead)


def show_opposed(console: Console, pairs: Pairs, result: Result, *, with_table: bool) -> None:
    """Show what the source has on opposed pistons, beside what is exact."""
    width = console.width - INDENT
    known = [name for cylinders in pairs.values() for name in cylinders]
    for pair, cylinders in pairs.items():
        said = ranged(known, [known.index(name) for name in cylinders])
        labels = [_("exhaust"), _("scavenge"), _("both")]
        heading = _("(I.11), (I.12) for cylinders {cylinders} [bolotin]").format(cylinders=said)
        about = _("each piston from its own inner dead centre, outward; φ after the exhaust crank's")
        section(console, heading, [about, *error_columns(opposed_errors(pair), labels, width)])
        if with_table:
            _show_motion(console, pair, said)
        place = result.labels["cylinder"].index(cylinders[0])
        section(console, _("Volumetric dead centres [bolotin]"), _dead_centres(pair, result, place, width))
        section(console, _("Lead of the exhaust crank [bolotin]"), _lead(pair, result, place))


def _show_motion(console: Console, pair: OpposedPair, cylinders: str) -> None:
    """Show travel, velocity and acceleration of each piston and of both together by the source and exact."""
    angle = np.deg2rad(np.arange(0, 360, _STEP, dtype=float))
    source, exact = opposed_pistons(angle, pair.size), exact_pair(angle, pair)
    for order, (heading, unit) in enumerate(
        (
            (_("Travel S of the pistons of {cylinders} by the exhaust crank's angle"), "mm"),
            (_("Their v/ω"), "mm/rad"),
            (_("Their j/ω²"), "mm/rad^2"),
        )
    ):
        columns = [
            Column(text, unit, tuple(figure(value, "mm") for value in values[order]))
            for head, own, true in zip(("(I.11)", "(I.12)", _("both")), source, exact, strict=True)
            for text, values in ((head, own), (_("exact"), true))
        ]
        labels = [f"{step}°" for step in range(0, 360, _STEP)]
        section_of_columns(console, heading.format(cylinders=cylinders), columns, labels)


def _dead_centres(pair: OpposedPair, result: Result, place: int, width: int) -> Iterator[str | Text]:
    """Volumetric dead centres by the source, to first order and exact; the combined stroke."""
    half, better = volumetric_dead_centres(np.array(pair.lead)), volumetric_dead_centres_to_first_order(pair.size)
    shifts = (result.inner_volumetric_shift[place], result.outer_volumetric_shift[place] + 180.0)
    columns = [
        Column("Δ/2", "deg", tuple(figure(float(value), "deg") for value in half)),
        Column("Δ·w_s/(w_e + w_s)", "deg", tuple(figure(float(value), "deg") for value in better)),
        Column(_("exact"), "deg", tuple(f"{value:.2f}" for value in shifts)),
    ]
    yield _("after the exhaust crank's inner dead centre; w = R(1 + λ) inside, R(1 − λ) outside")
    yield from column_tables(columns, [_("inner"), _("outer")], width)
    yield ""
    stroke = number(float(result.combined_stroke[place]), "mm")
    if pair.is_alike:
        own = number(float(combined_stroke(pair.exhaust.crank_radius, np.array(pair.lead))), "mm")
        nominal = number(4.0 * float(pair.exhaust.crank_radius), "mm")
        yield _(
            "Cranks and rods are equal: half the lead is exact, and so is 4R cos(Δ/2) = {own}, not {nominal}."
        ).format(own=own, nominal=nominal)
    else:
        yield _("Cranks or rods differ: half the lead is no dead centre. Both part by {stroke}.").format(stroke=stroke)


def _lead(pair: OpposedPair, result: Result, place: int) -> Iterator[str]:
    """Say which engines the lead suits, and the reason of the rule on this machine's ports."""
    yield _("{lead}: {verdict}").format(lead=number(pair.lead, "deg"), verdict=verdict(pair.lead))
    astern = number(-pair.lead, "deg")
    ahead, behind = (
        float(getattr(result, name)[place]) if name in result.catalogue else np.nan
        for name in ("exhaust_opens_before", "exhaust_closes_before")
    )
    if not np.isfinite(ahead + behind):
        yield _(
            "The reason: with the same metal turning the other way the lead is {lead}, and the scavenge ports tend to "
            "open first: gas blows back into the receiver. With exhaust_port and scavenge_port this is computed."
        ).format(lead=astern)
        return
    yield _(
        "The reason: as it turns, the exhaust ports open {ahead} the scavenge ports. With the same metal turning the "
        "other way the lead is {lead}, and they open {behind} them{result}."
    ).format(
        ahead=_before(ahead),
        lead=astern,
        behind=_before(-behind),
        result="" if behind < 0 else _(": gas blows back into the receiver"),
    )


def _before(degrees: float) -> str:
    """Say that something is so much before something, or after it."""
    words = _("{angle} before") if degrees >= 0 else _("{angle} after")
    return words.format(angle=f"{abs(degrees):.2f} deg")
