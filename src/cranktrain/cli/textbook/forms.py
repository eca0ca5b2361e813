"""The sources' forms of motion for a machine: range, who is inside, largest errors, and the curves by each method."""

from collections.abc import Collection, Iterator, Sequence

import numpy as np
from rich.console import Console
from rich.text import Text

from cranktrain.analysis import Result
from cranktrain.cli.screen.columns import Column, column_tables, section_of_columns
from cranktrain.cli.screen.text import INDENT, section
from cranktrain.grouping import places_of_equal
from cranktrain.language import _
from cranktrain.layout.places import PlacedMechanism
from cranktrain.machine import Machine
from cranktrain.texts.comparison import FORMS
from cranktrain.texts.percents import percent
from cranktrain.texts.ranges import RANGES, Range
from cranktrain.wording import around_turn, figure, ranged

STEP = 30.0
"""Of the crank angle in tables. [deg]"""
_TURN = 360.0

_ERRORS = {"Δx": "displacement_error", "Δv": "velocity_error", "Δj": "acceleration_error"}
_CURVES = (
    ("displacement_by_method", "mm"),
    ("velocity_coefficient_by_method", "mm/rad"),
    ("acceleration_coefficient_by_method", "mm/rad^2"),
)
NEEDED = (*_ERRORS.values(), *(name for name, _unit in _CURVES), "top_dead_centre", "top_shift")
"""Results that are shown."""


def show_forms(console: Console, machine: Machine, result: Result, source: str) -> bool:
    """Show every method of a source that speaks of one of the machine's mechanisms; whether there is one."""
    kinds = {place.kind.name for place in machine.places}
    ranges = [one for one in RANGES if one.source == source and set(FORMS[one.method]) & kinds]
    for one in ranges:
        heading = f"{_(one.name)}: {', '.join(one.equations)} [{one.source}]"
        lines = _method(machine, result, one, console.width - INDENT)
        section(console, heading[:1].upper() + heading[1:], lines)
    return bool(ranges)


def explain_forms(console: Console) -> None:
    """Say what the errors are errors of, and from where angles count."""
    explained = _(
        "Δx in parts of the stroke, Δv and Δj of their exact peaks, each curve from its own top; φ after the crank "
        "points along the cylinder. λ is crank radius by rod, of a slave its master's."
    )
    section(console, _("Largest errors over the turn"), [explained])


def show_motion(console: Console, machine: Machine, result: Result, sources: Collection[str]) -> None:
    """Show the motion of every distinct piston by each method of some sources."""
    methods = [one.method for one in RANGES if one.source in sources]
    for places in _alike(machine.places, methods):
        _show_motion(console, result, places, methods)


def _method(machine: Machine, result: Result, one: Range, width: int) -> Iterator[str | Text]:
    """Range of a method, which pistons are inside, and the largest errors."""
    places = [place for place in machine.places if place.kind.name in FORMS[one.method]]
    names = [place.name for place in places]
    yield _("range: {condition}").format(condition=_(one.condition))
    if one.most_ratio is not None:
        said = [_inside(one, place) for place in places]
        yield "; ".join(f"{ranged(names, members)}: {words}" for words, members in places_of_equal(said).items())
    groups = places_of_equal([tuple(_errors(result, one.method, name)) for name in names])
    heads = [head for symbol in _ERRORS for head in ((symbol, "%"), ("φ", "deg"))]
    columns = [Column(*head, texts) for head, texts in zip(heads, zip(*groups, strict=True), strict=True)]
    yield from column_tables(columns, [ranged(names, members) for members in groups.values()], width)


def _inside(one: Range, place: PlacedMechanism) -> str:
    """Say whether a mechanism is inside a method's range; outside, for what."""
    ratio, offset = sizes(place)
    if reasons := list(one.reasons(ratio, offset)):
        return _("outside, as {reasons}").format(reasons=_(" and ").join(reasons))
    return _("inside, λ = {ratio:.4g}").format(ratio=ratio)


def _errors(result: Result, method: str, piston: str) -> Iterator[str]:
    """Largest error of each order and where it is, as text."""
    row, place = result.labels["motion_method"].index(method), result.labels["piston"].index(piston)
    zero = result.top_dead_centre[place] - result.top_shift[place]
    for name in _ERRORS.values():
        angle = around_turn(np.deg2rad(getattr(result, f"{name}_at")[row, place] - zero))
        yield percent(float(getattr(result, name)[row, place]))
        yield figure(float(angle), "deg")


def _show_motion(console: Console, result: Result, places: Sequence[PlacedMechanism], chosen: Collection[str]) -> None:
    """Show the motion of the first of several pistons by each method."""
    first = places[0]
    piston = result.labels["piston"].index(first.name)
    methods = ["exact", *(method for method, form in FORMS.items() if method in chosen and first.kind.name in form)]
    turn = result.crank_angle < _TURN
    labels = [f"{angle:g}°" for angle in result.crank_angle[turn]]
    for name, unit in _CURVES:
        entry = result.catalogue[name]
        curves = getattr(result, name)[:, piston][:, turn]
        columns = [
            Column(
                method,
                unit,
                tuple(figure(value, "mm") for value in curves[result.labels["motion_method"].index(method)]),
            )
            for method in methods
        ]
        heading = _("{symbol} of piston {piston} by the crank angle").format(symbol=entry.symbol, piston=first.name)
        section_of_columns(console, heading, columns, labels)
    if len(places) > 1:
        names = [place.name for place in places]
        alike = ranged(names, range(1, len(names)))
        console.print()
        console.print(_("Alike, each from its own top: {pistons}.").format(pistons=alike))


def _alike(places: Sequence[PlacedMechanism], chosen: Collection[str]) -> list[list[PlacedMechanism]]:
    """Put pistons together that move alike, as far as there is a form for them."""
    spoken_of = [place for place in places if any(place.kind.name in FORMS[method] for method in chosen)]
    groups = places_of_equal([(place.kind.name, place.geometry) for place in spoken_of])
    return [[spoken_of[i] for i in members] for members in groups.values()]


def sizes(place: PlacedMechanism) -> tuple[float, float]:
    """Crank radius by rod and offset of the line of stroke [m], of a slave its master's, as ranges have them."""
    geometry = getattr(place.geometry, "master", place.geometry)
    return float(geometry.crank_radius / geometry.rod_length), float(geometry.offset)
