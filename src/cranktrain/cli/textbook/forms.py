"""The sources' forms of motion for a machine: range, who is inside, largest errors, and the curves by each method."""

from collections.abc import Collection, Sequence

import numpy as np
from rich.console import Console

from cranktrain.analysis import Result
from cranktrain.cli.screen.text import INDENT, section
from cranktrain.cli.textbook.tables import ROUND_ANGLES, show_curves, stated_error_columns
from cranktrain.grouping import grouped
from cranktrain.language import said as _
from cranktrain.machine import Machine
from cranktrain.textbook.alike import alike
from cranktrain.textbook.motion_statements import (
    form_curves,
    form_heading,
    form_notes,
    form_statements,
    root_curves,
)
from cranktrain.textbook.statements import StatementCurve
from cranktrain.texts.comparison import FORMS
from cranktrain.texts.plain_cranks import PLAIN
from cranktrain.texts.ranges import EXACT_ROOT, RANGES


def show_forms(console: Console, machine: Machine, result: Result, source: str) -> bool:
    """Show every method of a source that speaks of one of the machine's mechanisms; whether there is one."""
    kinds = {place.kind.name for place in machine.places}
    ranges = [one for one in RANGES if one.source == source and set(FORMS[one.method]) & kinds]
    for one in ranges:
        errors = stated_error_columns(form_statements(machine, result, one), console.width - INDENT)
        section(console, str(form_heading(one)), [*map(str, form_notes(machine, one)), *errors])
    return bool(ranges)


def explain_forms(console: Console) -> None:
    """Say what the errors are errors of, and from where angles count."""
    explained = _(
        "Δx in parts of the stroke, Δv and Δj of their exact peaks, each curve from its own top; φ after the crank "
        "points along the cylinder, or an eccentric to its valve. λ is crank radius by rod, of a slave its master's, "
        "of an eccentric e/l."
    )
    section(console, _("Largest errors over the turn"), [explained])


def show_motion(console: Console, machine: Machine, sources: Collection[str]) -> None:
    """Show the motion of every distinct piston or valve by each form of some sources."""
    angle = np.deg2rad(ROUND_ANGLES)
    ranges = [one for one in RANGES if one.source in sources]
    curves = [curve for one in ranges for curve in form_curves(machine, one, angle)]
    if EXACT_ROOT.source in sources:
        curves += [curve for one in alike(machine.places, PLAIN) for curve in root_curves(one, angle)]
    for each in grouped((curve.of, curve) for curve in curves).values():
        for by_form in grouped((curve.name, curve) for curve in each).values():
            show_form(console, by_form)


def show_form(console: Console, curves: Sequence[StatementCurve]) -> None:
    """Show displacement, velocity and acceleration of a form at round angles from where the own crank points."""
    heading = _(
        "{symbols} of {pistons} by {form}",
        symbols=", ".join(one.symbol for one in curves),
        pistons=curves[0].of,
        form=curves[0].name,
    )
    show_curves(console, heading, ROUND_ANGLES, ((one.equation, one) for one in curves), _("exact"))
