"""The sources' errors: each step that is wrong, what it gives, what is right, and how we know."""

from collections.abc import Iterator

from rich.console import Console
from rich.text import Text

from cranktrain.cli.screen.columns import Column, column_tables
from cranktrain.cli.screen.text import INDENT, section, table
from cranktrain.language import _
from cranktrain.quantities import shown
from cranktrain.references import REFERENCES
from cranktrain.synthesis.proposal import quantity_text
from cranktrain.textbook.slider_crank_synthesis import (
    PIN_SPEED,
    REQUIREMENTS,
    ROD_LENGTH,
    velocity_table,
    wrong_steps,
)

SOURCE = "slider-crank-synthesis"

SOURCE_EXAMPLE = {
    "stroke": quantity_text(REQUIREMENTS.stroke, "mm"),
    "pressure_angle": quantity_text(REQUIREMENTS.pressure_angle, "deg"),
    "mean_speed": f"{REQUIREMENTS.mean_speed} m/s",
}
"""What the source of the slider-crank's synthesis wants, as it would be typed."""


def show_source_example(console: Console) -> None:
    """Show the wrong steps of the slider-crank's synthesis, and its table of velocities beside the right one."""
    width = console.width - INDENT
    requirements = _("stroke {stroke}, mean slider speed {speed}, permissible pressure angle {angle}").format(
        stroke=SOURCE_EXAMPLE["stroke"], speed=SOURCE_EXAMPLE["mean_speed"], angle=SOURCE_EXAMPLE["pressure_angle"]
    )
    section(
        console,
        f"[{SOURCE}]",
        [REFERENCES[SOURCE].text, _("Its example: {requirements}.").format(requirements=requirements)],
    )
    for place, step in enumerate(wrong_steps(), start=1):
        words = _(step.step)
        rows = [
            (_("printed"), step.printed),
            (_("gives"), _figure(step.got, step.unit)),
            (_("right"), _figure(step.right, step.unit)),
            (_("because"), _(step.why)),
        ]
        section(console, f"{place}. {words[:1].upper()}{words[1:]}", table(("", ""), rows, fold=width))
    section(console, _("Its table of slider velocities, m/s"), _velocities(width))


def _figure(value: float, unit: str) -> str:
    """Write a number with the four figures that the source has at most; an angle in degrees."""
    if unit == "rad":
        return f"{shown(value, 'deg'):.4g} deg"
    return f"{value:.4g} {unit}".removesuffix(" 1")


def _velocities(width: int) -> Iterator[str | Text]:
    """The source's table, and the same columns as they should be."""
    velocities = velocity_table()
    heads = (_("printed"), _("its formula"), _("exact"))
    columns = [
        Column(head, "", tuple(f"{value + 0.0:.3f}" for value in column))
        for head, column in zip(heads, (velocities.printed, velocities.approximate, velocities.exact), strict=True)
    ]
    yield from column_tables(columns, [f"{angle:.0f}°" for angle in shown(velocities.angle, "deg")], width)
    yield ""
    yield _(
        "Its formula and the exact law have its own numbers, rω = {speed} m/s and l = {rod} m. "
        "Positive is toward the shaft."
    ).format(speed=PIN_SPEED, rod=ROD_LENGTH)
