"""The sources' errors: each step that is wrong, what it gives, what is right, and how we know."""

from collections.abc import Iterator, Sequence
from textwrap import shorten

from rich.cells import cell_len
from rich.console import Console
from rich.text import Text as Line

from cranktrain.cli.screen.columns import Column, column_tables
from cranktrain.cli.screen.text import GAP, INDENT, section, table
from cranktrain.grouping import grouped
from cranktrain.language import said as _
from cranktrain.references import REFERENCES
from cranktrain.synthesis.proposal import quantity_text
from cranktrain.textbook.errata_statements import amounts, errata
from cranktrain.textbook.statements import Statement, Statements
from cranktrain.textbook.synthesis_statements import SOURCE as SYNTHESIS
from cranktrain.textbook.synthesis_statements import synthesis
from cranktrain.texts.contents import TEXTS, Text, text_called
from cranktrain.texts.slider_crank_synthesis import REQUIREMENTS

SOURCE_EXAMPLE = {
    "stroke": quantity_text(REQUIREMENTS.stroke, "mm"),
    "pressure_angle": quantity_text(REQUIREMENTS.pressure_angle, "deg"),
    "mean_speed": f"{REQUIREMENTS.mean_speed} m/s",
}
"""What the source of the slider-crank's synthesis wants, as it would be typed."""

_OF_EACH = 4
"""Of a text's errors, where those of all are listed."""


def show_errata(console: Console, text: Text | None = None, *, full: bool = True) -> None:
    """Show the errors of every text, or of one: all that is said of them, or one in a line."""
    texts = TEXTS if text is None else (text,)
    for one in texts:
        if full:
            show_errors_of(console, one.name)
        else:
            _list_errors_of(console, one, _OF_EACH if text is None else None)
    if not full:
        asked = f" --source {text.letter}" if text else ""
        section(console, _("To go on"), _go_on(asked))


def show_first_errors(console: Console, name: str) -> None:
    """Show a text's first errors one in a line, and the command for all."""
    text = text_called(name)
    _list_errors_of(console, text, _OF_EACH)
    section(console, _("To go on"), _go_on(f" --source {text.letter}"))


def show_errors_of(console: Console, name: str) -> None:
    """Show all that is said of a text's errors."""
    width = console.width - INDENT
    about = [REFERENCES[name].text]
    if name == SYNTHESIS:
        about.append(_("Its example: {requirements}.", requirements=_requirements()))
    section(console, f"[{name}]", about)
    found = errata(name)
    notes = found.notes
    for place, one in enumerate(found, start=1):
        gives = [(_(head), text) for head, text in amounts(one)]
        rows = [(_("printed"), one.symbol), *gives, (_("because"), *notes[one.name])]
        section(console, f"{place}. {one.name}", table(("", ""), rows, fold=width))
    _show_velocities(console, name)


def _list_errors_of(console: Console, text: Text, most: int | None) -> None:
    """Show a text's errors one in a line, or so many of them; of the synthesis all with its table of velocities."""
    each = list(errata(text.name))
    heading = _("[{name}] {n} wrong steps", name=text.name, n=len(each))
    lines = list(_listed(each[:most], console.width - INDENT))
    if most is not None and len(each) > most:
        lines.append(Line(f"… `cranktrain textbook errata --source {text.letter}`"))
    section(console, heading, lines)
    if most is None:
        _show_velocities(console, text.name)


def _listed(each: Sequence[Statement], width: int) -> list[Line]:
    """Errors one in a line: what it is, cut where there is no room, what it gives, and what is right."""
    cells = [dict(amounts(one)) for one in each]
    numbers = [[own.get(head, "") for own in cells] for head in ("gives", "right")]
    heads = (_("gives"), _("right"))
    taken = sum(max(map(cell_len, [head, *column])) + GAP for head, column in zip(heads, numbers, strict=True))
    keys = [f"{place}." for place in range(1, len(each) + 1)]
    room = width - taken - max(map(len, keys), default=0) - GAP
    names = [shorten(one.name, room, placeholder=" …") for one in each]
    return table(("", "", *heads), list(zip(keys, names, *numbers, strict=True)), right=(0, 2, 3))


def _go_on(asked: str) -> Iterator[str]:
    yield _("`{command}`: each as printed, and why it is wrong", command=f"cranktrain textbook errata{asked} --full")


def _requirements() -> str:
    """What the synthesis's example wants."""
    return _(
        "stroke {stroke}, mean slider speed {speed}, permissible pressure angle {angle}",
        stroke=SOURCE_EXAMPLE["stroke"],
        speed=SOURCE_EXAMPLE["mean_speed"],
        angle=SOURCE_EXAMPLE["pressure_angle"],
    )


def _show_velocities(console: Console, name: str) -> None:
    """Show the synthesis's table of velocities beside the right one."""
    if name == SYNTHESIS:
        found = synthesis()
        section(console, _("Its table of slider velocities, m/s"), _velocities(found, console.width - INDENT))


def _velocities(found: Statements, width: int) -> Iterator[str | Line]:
    """The source's table, and the same columns as they should be."""
    by_name = grouped((one.name, one) for one in found if one.symbol == "v" and one.at == "at")
    columns = [Column(name, "", tuple(f"{one.value + 0.0:.3f}" for one in each)) for name, each in by_name.items()]
    first = next(iter(by_name.values()))
    columns.append(Column(_("exact"), "", tuple(f"{one.exact + 0.0:.3f}" for one in first)))
    yield from column_tables(columns, [f"{one.crank_angle:.0f}°" for one in first], width)
    yield ""
    yield from found.notes[_("Its velocities")]
