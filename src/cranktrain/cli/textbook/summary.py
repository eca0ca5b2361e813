"""The first screen of `textbook FILE`: how far each form is off, or with `--table` the motion by the usual one."""

from collections.abc import Iterator, Sequence

import numpy as np
from rich.console import Console
from rich.text import Text as Line

from cranktrain.analysis import Result
from cranktrain.cli.screen.text import INDENT, section, table
from cranktrain.cli.textbook.crank_rockers import show_crank_rockers
from cranktrain.cli.textbook.forms import show_form
from cranktrain.cli.textbook.tables import ROUND_ANGLES, show_curves
from cranktrain.cli.to_type import textbook_command
from cranktrain.errors import InputError
from cranktrain.grouping import grouped, places_of_equal
from cranktrain.language import said as _
from cranktrain.layout.places import PlacedMechanism
from cranktrain.machine import Machine
from cranktrain.plans.machine_drive import machine_drive, missing_values
from cranktrain.saying.wording import all_of, ranged
from cranktrain.textbook.alike import AlikePistons, alike
from cranktrain.textbook.motion_statements import form_curves, form_statements
from cranktrain.textbook.opposed_statements import OpposedCylinders, opposed_cylinders, opposed_statements
from cranktrain.textbook.statements import ERRORS, LARGEST
from cranktrain.texts.comparison import FORMS
from cranktrain.texts.contents import Text
from cranktrain.texts.percents import percent
from cranktrain.texts.ranges import RANGES, Range

_USUAL = {"steam-engine": "two_harmonics", "bolotin": "reconstructed"}
"""The method of a text that is shown over the turn; the others with `--full`."""
_Row = tuple[str, str, tuple[float, float, float], str]
"""Equations, whose, errors of displacement, velocity and acceleration, and what is to be said."""


def show_summary(console: Console, machine: Machine, result: Result, text: Text | None, *, with_table: bool) -> bool:
    """Show the first screen of all texts, or of one; whether any speaks of the machine."""
    ranges = _ranges(machine.places, text)
    cylinders = opposed_cylinders(machine.places) if text is None or text.name == "bolotin" else ()
    if with_table:
        _show_usual(console, machine, ranges)
        if not ranges or text is not None:
            _show_travel(console, cylinders, result)
    else:
        rows = [*_of_forms(machine, result, ranges), *_of_opposed(cylinders, result)]
        section(console, _("Largest errors over the turn"), _lines(rows, console.width - INDENT))
    rockers = text is None or text.name == "gandzha"
    has_rockers = rockers and show_crank_rockers(console, machine.places, with_table=with_table)
    return bool(ranges or cylinders) or has_rockers


def go_on(
    machine: Machine, file: str, settings: Sequence[str], text: Text | None, *, with_table: bool
) -> Iterator[str]:
    """Say what shows the rest."""
    if any(place.kind.name == "crank_rocker" for place in machine.places):
        yield from _go_on_to_drive(machine, file, settings)
        return
    source = ["--source", text.name] if text else []
    own = textbook_command(file, *source, settings=settings)
    if with_table:
        whole = textbook_command(file, *source, "--table", "--full", settings=settings)
        yield _("`{command}`: every method, and all else that the texts have over the turn", command=whole)
        yield _("`{command}`: how far the forms are off", command=own)
    else:
        whole = textbook_command(file, *source, "--full", settings=settings)
        yield _("`{command}`: ranges, where the errors are largest, constructions, constants", command=whole)
        table = textbook_command(file, *source, "--table", settings=settings)
        yield _("`{command}`: the motion over the turn", command=table)


def _go_on_to_drive(machine: Machine, file: str, settings: Sequence[str]) -> Iterator[str]:
    """Say what shows the machine's drive, with values for what it lacks; nothing of a linkage that has none so."""
    lacking = missing_values(machine)
    try:
        machine_drive(machine, lacking)
    except InputError:
        return
    own = [f"{symbol}={value}" for symbol, value in lacking.items()]
    command = textbook_command("--drive", file, settings=(*settings, *own))
    if not lacking:
        yield _("`{command}`: (1) to (21), its drive with them", command=command)
        return
    yield _(
        "`{command}`: (1) to (21), its drive with them; the machine does not say {symbols}: put in your own",
        command=command,
        symbols=", ".join(lacking),
    )


def _ranges(places: Sequence[PlacedMechanism], text: Text | None) -> list[Range]:
    """Methods of all texts, or of one, that speak of one of the mechanisms."""
    kinds = {place.kind.name for place in places}
    return [
        one for one in RANGES if (text is None or one.source == text.name) and not kinds.isdisjoint(FORMS[one.method])
    ]


def _of_forms(machine: Machine, result: Result, ranges: Sequence[Range]) -> Iterator[_Row]:
    """The largest errors of each method, of any piston that is inside its range, and of any outside for one reason."""
    for one in ranges:
        found = list(form_statements(machine, result, one))
        own = [place for place in machine.places if place.kind.name in FORMS[one.method]]
        names = [place.name for place in own]
        whose = {each.of: _inside(one, each) for each in alike(machine.places, FORMS[one.method])}
        for words, members in places_of_equal(_inside(one, AlikePistons(place.name, place)) for place in own).items():
            largest = [
                max(each.value for each in found if each.symbol == symbol and whose[each.of] == words)
                for symbol in ERRORS
            ]
            said = f"{_(one.name)}; {words}"
            yield ", ".join(one.equations), ranged(names, members), (largest[0], largest[1], largest[2]), said


def _inside(one: Range, piston: AlikePistons) -> str:
    """Say whether a piston is inside a method's range, and for what not; or that the text gives no range."""
    if one.most_ratio is None:
        return _("the text gives no range")
    outside = list(one.reasons(piston.ratio, piston.offset))
    return _("outside, as {reasons}", reasons=all_of(outside)) if outside else _("inside its range")


def _of_opposed(cylinders: Sequence[OpposedCylinders], result: Result) -> Iterator[_Row]:
    """The largest errors of (I.11), (I.12) and of their sum, of the first cylinders that are alike."""
    for one in cylinders[:1]:
        largest = [found for found in opposed_statements(cylinders[:1], result) if found.at == LARGEST]
        for name, own in grouped((found.name, found) for found in largest).items():
            displacement, velocity, acceleration = (found.error for found in own)
            yield own[0].equation, one.of[2], (displacement, velocity, acceleration), name


def _lines(rows: Sequence[_Row], width: int) -> Iterator[str | Line]:
    """Lay them out, and say what they are errors of."""
    if not rows:
        return
    cells = [(number, *map(percent, errors), f"{of}: {said}") for number, of, errors, said in rows]
    heads = ("", "Δx", "Δv", "Δj", "")
    yield from table(heads, [("", "%", "%", "%", ""), *cells], right=(1, 2, 3), fold=width)
    yield ""
    yield _("Δx in parts of the stroke, Δv and Δj of their exact peaks; of several pistons the largest.")


def _show_usual(console: Console, machine: Machine, ranges: Sequence[Range]) -> None:
    """Show the motion of the first piston of which a text speaks by the usual one of its methods, and exact."""
    for one in (one for one in ranges if _USUAL.get(one.source) == one.method):
        curves = grouped((curve.of, curve) for curve in form_curves(machine, one, np.deg2rad(ROUND_ANGLES)))
        show_form(console, next(iter(curves.values())))
    if ranges:
        console.print()
        console.print(_("Angles count from where a crank points along its cylinder, or an eccentric to its valve."))


def _show_travel(console: Console, cylinders: Sequence[OpposedCylinders], result: Result) -> None:
    """Show the travel of opposed pistons by (I.11), (I.12), and of both together."""
    for one in cylinders[:1]:
        found = opposed_statements(cylinders[:1], result)
        curves = ((curve.equation, curve) for curve in found.curves if curve.symbol == "S")
        heading = _("Travel S of the pistons of {cylinders} by the exhaust crank's angle", cylinders=one.of[2])
        show_curves(console, heading, found.crank_angle, curves, _("exact"))
