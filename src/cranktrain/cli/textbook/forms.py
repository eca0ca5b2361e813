"""The sources' forms of motion for a machine: range, who is inside, largest errors, and the curves by each method."""

from collections.abc import Collection, Sequence

from rich.console import Console

from cranktrain.analysis import Result
from cranktrain.cli.screen.columns import Column, section_of_columns
from cranktrain.cli.screen.text import INDENT, section
from cranktrain.cli.textbook.error_columns import stated_error_columns
from cranktrain.cli.textbook.piston_words import called
from cranktrain.grouping import places_of_equal
from cranktrain.language import _
from cranktrain.layout.places import PlacedMechanism
from cranktrain.machine import Machine
from cranktrain.textbook.motion_statements import NEEDED as STATEMENTS_NEEDED
from cranktrain.textbook.motion_statements import form_heading, form_notes, form_statements
from cranktrain.texts.comparison import FORMS
from cranktrain.texts.ranges import RANGES
from cranktrain.wording import figure, ranged

STEP = 30.0
"""Of the crank angle in tables. [deg]"""
_TURN = 360.0

_CURVES = (
    ("displacement_by_method", "mm"),
    ("velocity_coefficient_by_method", "mm/rad"),
    ("acceleration_coefficient_by_method", "mm/rad^2"),
)
NEEDED = (*STATEMENTS_NEEDED, *(name for name, _unit in _CURVES))
"""Results that are shown."""


def show_forms(console: Console, machine: Machine, result: Result, source: str) -> bool:
    """Show every method of a source that speaks of one of the machine's mechanisms; whether there is one."""
    kinds = {place.kind.name for place in machine.places}
    ranges = [one for one in RANGES if one.source == source and set(FORMS[one.method]) & kinds]
    for one in ranges:
        errors = stated_error_columns(form_statements(machine, result, one), console.width - INDENT)
        section(console, form_heading(one), [*form_notes(machine, one), *errors])
    return bool(ranges)


def explain_forms(console: Console) -> None:
    """Say what the errors are errors of, and from where angles count."""
    explained = _(
        "Δx in parts of the stroke, Δv and Δj of their exact peaks, each curve from its own top; φ after the crank "
        "points along the cylinder, or an eccentric to its valve. λ is crank radius by rod, of a slave its master's, "
        "of an eccentric e/l."
    )
    section(console, _("Largest errors over the turn"), [explained])


def show_motion(console: Console, machine: Machine, result: Result, sources: Collection[str]) -> None:
    """Show the motion of every distinct piston by each method of some sources."""
    methods = [one.method for one in RANGES if one.source in sources]
    for places in _alike(machine.places, methods):
        _show_motion(console, result, places, methods)


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
        heading = _("{symbol} of {piston} by the crank angle").format(symbol=entry.symbol, piston=called(first))
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
