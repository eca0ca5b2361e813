"""The sources' errors: each step that is wrong, what it gives, what is right, and how we know."""

from collections.abc import Iterator

from rich.console import Console
from rich.text import Text as Line

from cranktrain.cli.screen.columns import Column, column_tables
from cranktrain.cli.screen.text import INDENT, section, table
from cranktrain.language import _
from cranktrain.quantities import shown
from cranktrain.references import REFERENCES
from cranktrain.synthesis.proposal import quantity_text
from cranktrain.texts.contents import TEXTS, Text
from cranktrain.texts.errata import ERRATA, SYNTHESIS
from cranktrain.texts.slider_crank_synthesis import PIN_SPEED, REQUIREMENTS, ROD_LENGTH, velocity_table

SOURCE_EXAMPLE = {
    "stroke": quantity_text(REQUIREMENTS.stroke, "mm"),
    "pressure_angle": quantity_text(REQUIREMENTS.pressure_angle, "deg"),
    "mean_speed": f"{REQUIREMENTS.mean_speed} m/s",
}
"""What the source of the slider-crank's synthesis wants, as it would be typed."""


def show_errata(console: Console, text: Text | None = None) -> None:
    """Show the errors of every text, or of one."""
    for one in TEXTS if text is None else (text,):
        if one.name in ERRATA:
            show_errors_of(console, one.name)
        else:
            section(console, f"[{one.name}]", [REFERENCES[one.name].text, _without_numbers(one)])


def show_errors_of(console: Console, name: str) -> None:
    """Show the errors of one text; of the slider-crank's synthesis its table of velocities beside the right one."""
    width = console.width - INDENT
    about = [REFERENCES[name].text]
    if name == SYNTHESIS:
        about.append(_("Its example: {requirements}.").format(requirements=_requirements()))
    section(console, f"[{name}]", about)
    for place, step in enumerate(ERRATA[name](), start=1):
        words = _(step.step)
        section(console, f"{place}. {words[:1].upper()}{words[1:]}", table(("", ""), list(step.said()), fold=width))
    if name == SYNTHESIS:
        section(console, _("Its table of slider velocities, m/s"), _velocities(width))


def _without_numbers(text: Text) -> str:
    """Say of a text that no numbers stand beside its errors, or that it has none."""
    words = (
        _("No numbers stand beside its errors; `{command}` says of each wrong formula what is right.")
        if any(one.verdict == "wrong" for one in text.formulas)
        else _("No error of its formulas is known; `{command}` lists them.")
    )
    return words.format(command=f"cranktrain textbook --source {text.name}")


def _requirements() -> str:
    """What the synthesis's example wants."""
    return _("stroke {stroke}, mean slider speed {speed}, permissible pressure angle {angle}").format(
        stroke=SOURCE_EXAMPLE["stroke"], speed=SOURCE_EXAMPLE["mean_speed"], angle=SOURCE_EXAMPLE["pressure_angle"]
    )


def _velocities(width: int) -> Iterator[str | Line]:
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
