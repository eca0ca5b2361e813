"""What the text on the synthesis makes of other requirements than its own, on the screen."""

from collections.abc import Iterator, Mapping

from rich.console import Console
from rich.text import Text as Line

from cranktrain.cli.screen.columns import Column, column_tables
from cranktrain.cli.screen.text import INDENT, section, table
from cranktrain.cli.synthesis.requirements import option_of
from cranktrain.grouping import grouped
from cranktrain.language import said as _
from cranktrain.saying.wording import figure
from cranktrain.textbook.statements import Statements
from cranktrain.textbook.synthesis_statements import PLACE, SOURCE, synthesis

NEEDED = ("stroke", "mean_speed", "pressure_angle")
_NOT_ITS_OWN = ("offset", "return_pressure_angle")
_SHOWN = {"m": "mm", "rad": "deg"}


def show_steps(console: Console, typed: Mapping[str, str | bool | None]) -> None:
    """Show the text's steps with the requirements that are typed, or say why they are not its own."""
    heading = _("Its steps with these requirements [{source}]", source=SOURCE)
    given = {name: value for name in (*NEEDED, "rod_length") if isinstance(value := typed.get(name), str)}
    if unlike := [*_unlike(typed, given)]:
        section(console, heading, unlike)
        return
    found = synthesis(**given)
    section(console, heading, _sizes(found))
    section(console, _("Place and velocity of the slider"), _over_the_turn(found, console.width - INDENT))


def _unlike(typed: Mapping[str, str | bool | None], given: Mapping[str, str]) -> Iterator[str]:
    """Say of what the text does not speak, and what it needs besides."""
    if lacking := [option_of(name) for name in NEEDED if name not in given]:
        yield _(
            "It starts from a stroke, a mean speed and a pressure angle; {options}: not given.",
            options=", ".join(lacking),
        )
    if others := [option_of(name) for name in _NOT_ITS_OWN if typed.get(name)]:
        yield _(
            "It has a central slider-crank with one pressure angle both ways, and nothing of {options}.",
            options=", ".join(others),
        )


def _sizes(found: Statements) -> list[Line]:
    """Each number by the text, and what is right where that differs."""
    rows: list[tuple[str, ...]] = []
    for one in found:
        if one.equation and one.at != "at":
            unit = _SHOWN.get(one.unit, one.unit)
            right = "" if one.verdict == "right" else figure(one.exact, unit)
            rows.append((one.equation, one.name, one.symbol, figure(one.value, unit), right, unit))
    return table(("", "", "", _("gives"), _("right"), ""), rows, right=(3, 4))


def _over_the_turn(found: Statements, width: int) -> Iterator[str | Line]:
    """Places and velocities by the text, each beside the exact one."""
    by_symbol = grouped((one.symbol, one) for one in found if one.equation and one.at == "at")
    columns: list[Column] = []
    for symbol, name in (("x", _("x as printed")), ("v", _("v by its formula"))):
        unit, right = by_symbol[symbol][0].unit, _("{symbol} exact", symbol=symbol)
        for head, values in (
            (name, [one.value for one in by_symbol[symbol]]),
            (right, [one.exact for one in by_symbol[symbol]]),
        ):
            columns.append(Column(head, unit, tuple(f"{value + 0.0:.4f}" for value in values)))
    yield from column_tables(columns, [f"{one.crank_angle:.0f}°" for one in by_symbol["x"]], width)
    yield ""
    yield _("{equation} prints no root: an area in numbers of m² is added to a length.", equation=PLACE)
    yield from found.notes[_("Its velocities")]
