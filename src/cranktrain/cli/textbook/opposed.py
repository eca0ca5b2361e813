"""Opposed pistons by the source: (I.11), (I.12) and both together, volumetric dead centres, and the rule for leads."""

from collections.abc import Iterator, Sequence

from rich.console import Console
from rich.text import Text

from cranktrain.analysis import Result
from cranktrain.cli.screen.columns import Column, column_tables
from cranktrain.cli.screen.text import INDENT, section
from cranktrain.cli.textbook.curve_tables import show_curves
from cranktrain.cli.textbook.error_columns import error_columns
from cranktrain.grouping import grouped
from cranktrain.language import _
from cranktrain.textbook.error_statements import LARGEST
from cranktrain.textbook.opposed_statements import (
    INNER,
    OUTER,
    OpposedCylinders,
    opposed_statements,
    subjects,
)
from cranktrain.textbook.statements import Statement, Statements
from cranktrain.wording import figure


def show_opposed(console: Console, cylinders: Sequence[OpposedCylinders], result: Result, *, with_table: bool) -> None:
    """Show what the source has on opposed pistons, beside what is exact."""
    width = console.width - INDENT
    found = opposed_statements(cylinders, result)
    for one in cylinders:
        form, dead_centres, lead = subjects(one, several=len(cylinders) > 1)
        own = [statement for statement in found if statement.of in one.of]
        errors = error_columns(grouped((each.name, each) for each in own if each.at == LARGEST), width)
        section(console, form, [*found.notes[form], *errors, _scheme(one)])
        if with_table:
            _show_motion(console, one, found)
        section(console, dead_centres, _dead_centres(own, found.notes[dead_centres], width))
        section(console, lead, found.notes[lead])


def _scheme(one: OpposedCylinders) -> str:
    """Say what draws fig. 1.3 of a cylinder."""
    command = f"cranktrain plot FILE --plan scheme --mechanism {one.places[0][0].cylinder} -o scheme.svg"
    return _("fig. 1.3: {command}").format(command=command)


def _show_motion(console: Console, one: OpposedCylinders, found: Statements) -> None:
    """Show travel, velocity and acceleration of each piston and of both together by the source and exact."""
    curves = grouped((curve.symbol, curve) for curve in found.curves if curve.of in one.of)
    headings = (
        _("Travel S of the pistons of {cylinders} by the exhaust crank's angle").format(cylinders=one.of[2]),
        _("Their v/ω"),
        _("Their j/ω²"),
    )
    for heading, parts in zip(headings, curves.values(), strict=True):
        heads = [*(curve.equation for curve in parts[:-1]), _("both")]
        show_curves(console, heading, found.crank_angle, zip(heads, parts, strict=True), _("exact"))


def _dead_centres(own: Sequence[Statement], notes: Sequence[str], width: int) -> Iterator[str | Text]:
    """Volumetric dead centres by the source, to first order and exact; the combined stroke."""
    yield _("after the exhaust crank's inner dead centre; w = R(1 + λ) inside, R(1 − λ) outside")
    sets = grouped((one.symbol, one) for one in own if one.at in (INNER, OUTER))
    columns = [Column(symbol, "deg", tuple(figure(one.value, "deg") for one in each)) for symbol, each in sets.items()]
    exact = next(iter(sets.values()))
    columns.append(Column(_("exact"), "deg", tuple(figure(one.exact, "deg") for one in exact)))
    yield from column_tables(columns, [_(one.at) for one in exact], width)
    yield ""
    yield from notes
