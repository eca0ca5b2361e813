"""`textbook`: the sources' own formulas for a machine, with their ranges and errors; the sources' own errors."""

import os
from collections.abc import Iterator, Sequence

import numpy as np
from rich.console import Console
from rich.text import Text

from cranktrain.analysis import Result, run
from cranktrain.cli.screen.columns import Column, column_tables, section_of_columns
from cranktrain.cli.screen.text import INDENT, page, section, table
from cranktrain.cli.screen.title import title
from cranktrain.cli.textbook.errata import show_source_example
from cranktrain.cli.textbook.source import machine_file
from cranktrain.grouping import places_of_equal
from cranktrain.language import _
from cranktrain.layout.places import PlacedMechanism
from cranktrain.machine import Machine
from cranktrain.motion import Array, single
from cranktrain.plans.constructions import Construction, construction
from cranktrain.references import REFERENCES
from cranktrain.textbook.comparison import FORMS
from cranktrain.textbook.ranges import RANGES, Range
from cranktrain.wording import around_turn, figure, number, ranged

_ERRATA = "errata"
_STEP = 30.0
"""Of the crank angle in tables. [deg]"""
_TURN = 360.0
_PARTS, _FINE = 10, 720
"""Of the stroke or turn: where a table of a construction is shown, and where its largest error is sought."""

_ERRORS = {"Δx": "displacement_error", "Δv": "velocity_error", "Δj": "acceleration_error"}
_CURVES = (
    ("displacement_by_method", "mm"),
    ("velocity_coefficient_by_method", "mm/rad"),
    ("acceleration_coefficient_by_method", "mm/rad^2"),
)
_NEEDED = (*_ERRORS.values(), *(name for name, _unit in _CURVES), "top_dead_centre", "top_shift")


def show_textbook(source: str, settings: Sequence[str], *, with_table: bool, with_errata: bool) -> None:
    """Show each source's forms for a machine with their ranges and largest errors.

    Parameters
    ----------
    source : str
        A machine file or an example; `errata`, if no file is called so, for the sources' errors alone.
    settings : sequence of str
        `PATH=VALUE`
    with_table : bool
        Whether to show the motion by each method.
    with_errata : bool
        Whether to show the sources' errors.

    Raises
    ------
    InputError
        With everything that is wrong with the machine.
    """
    is_errata = source.casefold() == _ERRATA and not os.path.isfile(source)  # noqa: PTH113 - takes a NUL byte
    errors = _("Errors of the sources, each with what is right")
    if is_errata or (with_errata and not source):
        with page(errors) as console:
            show_source_example(console)
        return
    machine = machine_file(source, settings, "cranktrain textbook 3d12").machine
    result = run(machine, step_degrees=_STEP, quantities=_NEEDED)
    with page(title(machine)) as console:
        _show_methods(console, machine, result, with_table=with_table)
        if with_errata:
            console.print()
            console.print(Text(errors, style="bold"))
            show_source_example(console)


def _show_methods(console: Console, machine: Machine, result: Result, *, with_table: bool) -> None:
    """Show every method that speaks of one of the machine's mechanisms."""
    kinds = dict.fromkeys(place.kind.name for place in machine.places)
    ranges = [one for one in RANGES if set(FORMS[one.method]) & set(kinds)]
    if not ranges:
        said = _("None of the sources has a form of its own for the motion of: {kinds}.").format(kinds=", ".join(kinds))
        section(console, _("Textbook forms"), [said])
        return
    width = console.width - INDENT
    for one in ranges:
        heading = f"{_(one.name)}: {', '.join(one.equations)} [{one.source}]"
        section(console, heading[:1].upper() + heading[1:], _method(machine, result, one, width))
    explained = _(
        "Δx in parts of the stroke, Δv and Δj of their exact peaks, each curve from its own top; φ after the crank "
        "points along the cylinder. λ is crank radius by rod, of a slave its master's."
    )
    section(console, _("Largest errors over the turn"), [explained])
    _show_constructions(console, machine, with_table=with_table)
    if with_table:
        for places in _alike(machine.places):
            _show_motion(console, result, places)
    rows = [(f"[{key}]", REFERENCES[key].text) for key in dict.fromkeys(one.source for one in ranges)]
    section(console, _("Sources"), table(("", ""), rows, fold=width))


def _show_constructions(console: Console, machine: Machine, *, with_table: bool) -> None:
    """Show what is constructed and no curve of the turn: arc, Brix's pole, Brix read backwards."""
    cranks = [place for place in machine.places if place.kind.name == "slider_crank"]
    if not cranks:
        return
    groups = places_of_equal([place.geometry for place in cranks])
    names = [place.name for place in cranks]
    said = [ranged(names, members) for members in groups.values()]
    firsts = [cranks[members[0]] for members in groups.values()]
    arcs = [construction(machine, "arc", _FINE, mechanism=first.name) for first in firsts]
    off = max(float(np.max(np.abs(arc.displacement - arc.exact_displacement) / arc.stroke)) for arc in arcs)
    words = _("exact, for an offset line of stroke too; largest error {off:.0e} of the stroke, from rounding")
    section(console, _("Arcs of the rod's length about the piston's pin"), [words.format(off=off)])
    read = [construction(machine, "brix_backward", _FINE, mechanism=first.name) for first in firsts]
    errors = [np.rad2deg(one.angle - one.exact_angle) for one in read]
    worst = [int(np.nanargmax(np.abs(error))) for error in errors]
    columns = [
        Column("OP = λR/2", "mm", tuple(figure(-one.pole, "mm") for one in read)),
        Column("Δφ", "deg", tuple(f"{error[at]:.2f}" for error, at in zip(errors, worst, strict=True))),
        Column("S", "mm", tuple(figure(one.displacement[at], "mm") for one, at in zip(read, worst, strict=True))),
    ]
    about = _("crank angle from the displacement: largest error, and where; the pole P lies away from the cylinder")
    lines = [about, *column_tables(columns, said, console.width - INDENT)]
    section(console, _("Brix's construction backwards: fig. 147 [steam-engine]"), lines)
    if with_table:
        _show_backwards(console, construction(machine, "brix_backward", _PARTS, mechanism=firsts[0].name))


def _show_backwards(console: Console, read: Construction) -> None:
    """Show the angles that Brix's construction gives for tenths of the stroke, beside the exact ones."""
    labels = [number(value, "mm") for value in read.displacement]
    angles = (read.angle, read.exact_angle, read.angle - read.exact_angle)
    columns = [
        Column(head, "deg", tuple(f"{np.rad2deg(value):.2f}" for value in values))
        for head, values in zip(("brix", "exact", "Δφ"), angles, strict=True)
    ]
    heading = _("φ of piston {piston} by the displacement S, on the way to the shaft").format(piston=read.mechanism)
    section_of_columns(console, heading, columns, labels)


def _method(machine: Machine, result: Result, one: Range, width: int) -> Iterator[str | Text]:
    """Range of a method, which pistons are inside, and the largest errors."""
    places = [place for place in machine.places if place.kind.name in FORMS[one.method]]
    names = [place.name for place in places]
    yield _("range: {condition}").format(condition=_(one.condition))
    if one.outside(single(np.inf), single(1.0)):  # some sources give no limits
        said = [
            (_("outside, λ = {ratio:.3f}") if one.outside(ratio, offset) else _("inside, λ = {ratio:.3f}")).format(
                ratio=float(ratio)
            )
            for ratio, offset in map(_sizes, places)
        ]
        yield "; ".join(f"{ranged(names, members)}: {words}" for words, members in places_of_equal(said).items())
    groups = places_of_equal([tuple(_errors(result, one.method, name)) for name in names])
    heads = [head for symbol in _ERRORS for head in ((symbol, "%"), ("φ", "deg"))]
    columns = [Column(*head, texts) for head, texts in zip(heads, zip(*groups, strict=True), strict=True)]
    yield from column_tables(columns, [ranged(names, members) for members in groups.values()], width)


def _errors(result: Result, method: str, piston: str) -> Iterator[str]:
    """Largest error of each order and where it is, as text."""
    row, place = result.labels["method"].index(method), result.labels["piston"].index(piston)
    zero = result.top_dead_centre[place] - result.top_shift[place]
    for name in _ERRORS.values():
        angle = around_turn(np.deg2rad(getattr(result, f"{name}_at")[row, place] - zero))
        yield figure(float(getattr(result, name)[row, place]), "%")
        yield figure(float(angle), "deg")


def _show_motion(console: Console, result: Result, places: Sequence[PlacedMechanism]) -> None:
    """Show the motion of the first of several pistons by each method."""
    first = places[0]
    piston = result.labels["piston"].index(first.name)
    methods = ["exact", *(method for method, form in FORMS.items() if first.kind.name in form)]
    turn = result.crank_angle < _TURN
    labels = [f"{angle:g}°" for angle in result.crank_angle[turn]]
    for name, unit in _CURVES:
        entry = result.catalogue[name]
        curves = getattr(result, name)[:, piston][:, turn]
        columns = [
            Column(method, unit, tuple(figure(value, "mm") for value in curves[result.labels["method"].index(method)]))
            for method in methods
        ]
        heading = _("{symbol} of piston {piston} by the crank angle").format(symbol=entry.symbol, piston=first.name)
        section_of_columns(console, heading, columns, labels)
    if len(places) > 1:
        names = [place.name for place in places]
        alike = ranged(names, range(1, len(names)))
        console.print()
        console.print(_("Alike, each from its own top: {pistons}.").format(pistons=alike))


def _alike(places: Sequence[PlacedMechanism]) -> list[list[PlacedMechanism]]:
    """Put pistons together that move alike, as far as any source has a form for them."""
    spoken_of = [place for place in places if any(place.kind.name in form for form in FORMS.values())]
    groups = places_of_equal([(place.kind.name, place.geometry) for place in spoken_of])
    return [[spoken_of[i] for i in members] for members in groups.values()]


def _sizes(place: PlacedMechanism) -> tuple[Array, Array]:
    """Crank radius by rod and offset of the line of stroke [m], of a slave its master's, as ranges have them."""
    geometry = getattr(place.geometry, "master", place.geometry)
    return single(geometry.crank_radius / geometry.rod_length), single(geometry.offset)
