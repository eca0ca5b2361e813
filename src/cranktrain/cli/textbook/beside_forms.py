"""What single texts have for a machine beside forms of its motion.

The steam engine's: its exact root, its forms from the crank-side dead centre with the minus sign, Z of (335), and what
it constructs: arcs, Brix's pole, Brix read backwards. Bolotin's: the constants of (I.13), as derived, as reconstructed
and of the exact motion; opposed pistons by (I.11), (I.12) and both together, with their dead centres and leads.
"""

from collections.abc import Iterator, Sequence

import numpy as np
from rich.console import Console
from rich.text import Text

from cranktrain.analysis import Result
from cranktrain.cli.screen.columns import Column, column_tables, section_of_columns
from cranktrain.cli.screen.text import INDENT, section
from cranktrain.cli.textbook.tables import ROUND_ANGLES, error_columns, show_curves, stated_error_columns
from cranktrain.grouping import grouped
from cranktrain.language import said as _
from cranktrain.layout.places import PlacedMechanism
from cranktrain.machine import Machine
from cranktrain.plans.constructions import construction
from cranktrain.saying.wording import figure, number, ranged, signless
from cranktrain.textbook.alike import AlikePistons
from cranktrain.textbook.constants_statements import EQUATION, SOURCE, alike_slaves, constants_statements
from cranktrain.textbook.construction_statements import arc_statement, backward_statements
from cranktrain.textbook.motion_statements import form_heading, root_notes
from cranktrain.textbook.opposed_statements import (
    INNER,
    OUTER,
    OpposedCylinders,
    opposed_statements,
    subjects,
)
from cranktrain.textbook.statements import LARGEST, Statement, Statements
from cranktrain.textbook.steam_engine_statements import (
    crank_side_curves,
    crank_side_statements,
    difference_statements,
    root_statements,
)
from cranktrain.texts.percents import percent
from cranktrain.texts.ranges import EXACT_ROOT

_PARTS = 10
"""Of the stroke, where a table of a construction is shown."""

_DECIMALS = {"E": 6, "Φ": 4, "F": 6, "Θ": 3, "K": 3, "H": 3}


def show_exact_root(console: Console, pistons: Sequence[AlikePistons], places: Sequence[PlacedMechanism]) -> None:
    """Show the source's displacement before its root is approximated."""
    found = [statement for one in pistons for statement in root_statements(one)]
    rounding = max((one.value for one in found if one.verdict == "right"), default=None)
    said = [*map(str, root_notes(places))]
    if rounding is not None:
        said += [_("exact: off by 0, in numbers by up to {off:.0e} from rounding", off=rounding)]
    section(console, str(form_heading(EXACT_ROOT)), [*said, *stated_error_columns(found, console.width - INDENT)])


def show_from_crank_side(console: Console, pistons: Sequence[AlikePistons], *, with_table: bool) -> None:
    """Show (333), (336), (337) with the minus sign, and Z."""
    width = console.width - INDENT
    errors = [statement for one in pistons for statement in crank_side_statements(one)]
    about = _("φ and S from there, S away from the shaft; v and j away from the shaft, too: the minus sign")
    lines = [about, *stated_error_columns(errors, width)]
    section(console, _("(333), (336), (337) from the crank-side dead centre [steam-engine]"), lines)
    if with_table:
        for one in pistons:
            _show_crank_side(console, one)
    found = [statement for one in pistons for statement in difference_statements(one)]
    columns = [
        Column("Z", "mm", tuple(figure(one.value, "mm") for one in found)),
        Column(_("exact"), "mm", tuple(figure(one.exact, "mm") for one in found)),
        Column("ΔZ", "%", tuple(percent(one.error / one.exact) for one in found)),
    ]
    about = _("by how much (333) and (334) differ at most, at 90° and 270°; beside it, exact: L − √(L² − R²)")
    lines = [about, *column_tables(columns, [one.of for one in found], width)]
    section(console, _("Z = λR/2: (335) [steam-engine]"), lines)


def _show_crank_side(console: Console, one: AlikePistons) -> None:
    """Show S, v and j by (333), (336), (337) with the minus sign, beside the exact ones."""
    curves = crank_side_curves(one, np.deg2rad(ROUND_ANGLES))
    heading = _("S, v/ω and j/ω² of {piston} from the crank-side dead centre", piston=_called(one.first))
    show_curves(console, heading, ROUND_ANGLES, ((curve.equation, curve) for curve in curves), _("exact"))


def show_constructions(
    console: Console, machine: Machine, pistons: Sequence[AlikePistons], *, with_table: bool
) -> None:
    """Show them for slider-cranks and eccentrics."""
    off = max(arc_statement(machine, one).value for one in pistons)
    words = _("exact, for an offset line of stroke too; largest error {off:.0e} of the stroke, from rounding")
    section(console, _("Arcs of the rod's length about the piston's pin"), [words.format(off=off)])
    read = [backward_statements(machine, one) for one in pistons]
    columns = [
        Column("OP = λR/2", "mm", tuple(figure(pole.value, "mm") for pole, _error, _way in read)),
        Column("Δφ", "deg", tuple(f"{np.rad2deg(error.value):.2f}" for _pole, error, _way in read)),
        Column("S", "mm", tuple(figure(way.value, "mm") for _pole, _error, way in read)),
    ]
    about = _(
        "crank angle from the displacement: largest error, and where; the pole P lies away from the cylinder or valve"
    )
    lines = [about, *column_tables(columns, [one.of for one in pistons], console.width - INDENT)]
    section(console, _("Brix's construction backwards: fig. 147 [steam-engine]"), lines)
    if with_table:
        _show_backwards(console, machine, pistons[0].first)


def _show_backwards(console: Console, machine: Machine, first: PlacedMechanism) -> None:
    """Show the angles that Brix's construction gives for tenths of the stroke, beside the exact ones."""
    read = construction(machine, "brix_backward", _PARTS, mechanism=first.name)
    labels = [str(number(value, "mm")) for value in read.displacement]
    angles = (read.angle, read.exact_angle, read.angle - read.exact_angle)
    columns = [
        Column(head, "deg", tuple(f"{np.rad2deg(value):.2f}" for value in values))
        for head, values in zip(("brix", "exact", "Δφ"), angles, strict=True)
    ]
    heading = _("φ of {piston} by the displacement S, on the way to the shaft", piston=_called(first))
    section_of_columns(console, heading, columns, labels)


def show_constants(console: Console, places: Sequence[PlacedMechanism]) -> None:
    """Show K, E, F, Φ, Θ and H of every distinct slave on an articulated rod."""
    slaves = alike_slaves(places)
    if not slaves:
        return
    found = constants_statements(slaves)
    rows = grouped(((one.name if len(slaves) == 1 else f"{one.of}, {one.name}"), one) for one in found)
    sets = [{one.symbol: one for one in members} for members in rows.values()]
    columns = [_column(symbol, [each.get(symbol) for each in sets]) for symbol in _DECIMALS]
    names = [place.name for place in places if place.kind.is_slave]
    heading = _(
        "Constants of {equation} for {pistons} [{source}]",
        equation=EQUATION,
        pistons=ranged(names, range(len(names))),
        source=SOURCE,
    )
    section(console, heading, column_tables(columns, list(rows), console.width - INDENT))
    for subject, sentences in found.notes.items():
        section(console, subject, sentences)


def _column(symbol: str, members: Sequence[Statement | None]) -> Column:
    """One constant of every set; blank where a set has none."""
    unit = {"1": "", "rad": "deg", "m": "mm"}[next(one.unit for one in members if one is not None)]
    return Column(symbol, unit, tuple("" if one is None else _constant(one) for one in members))


def _constant(one: Statement) -> str:
    value = {"1": one.value, "rad": np.rad2deg(one.value), "m": 1e3 * one.value}[one.unit]
    return signless(f"{value:.{_DECIMALS[one.symbol]}f}")


def show_opposed(console: Console, cylinders: Sequence[OpposedCylinders], result: Result, *, with_table: bool) -> None:
    """Show what the source has on opposed pistons, beside what is exact."""
    width = console.width - INDENT
    found = opposed_statements(cylinders, result)
    notes = found.notes
    for one in cylinders:
        form, dead_centres, lead = map(str, subjects(one, several=len(cylinders) > 1))
        own = [statement for statement in found if statement.of in one.of]
        errors = error_columns(grouped((each.name, each) for each in own if each.at == LARGEST), width)
        section(console, form, [*notes[form], *errors, _scheme(one)])
        if with_table:
            _show_motion(console, one, found)
        section(console, dead_centres, _dead_centres(own, notes[dead_centres], width))
        section(console, lead, notes[lead])


def _scheme(one: OpposedCylinders) -> str:
    """Say what draws fig. 1.3 of a cylinder."""
    command = f"cranktrain plot FILE --plan scheme --mechanism {one.places[0][0].cylinder} -o scheme.svg"
    return _("fig. 1.3: {command}", command=command)


def _show_motion(console: Console, one: OpposedCylinders, found: Statements) -> None:
    """Show travel, velocity and acceleration of each piston and of both together by the source and exact."""
    curves = grouped((curve.symbol, curve) for curve in found.curves if curve.of in one.of)
    headings = (
        _("Travel S of the pistons of {cylinders} by the exhaust crank's angle", cylinders=one.of[2]),
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


def _called(place: PlacedMechanism) -> str:
    """Name a mechanism's slider: a piston, or the valve that an eccentric drives."""
    return _(place.kind.output.called, name=place.name)
