"""The sources' forms of motion for a machine: range, who is inside, largest errors, and the curves by each method."""

from collections.abc import Collection, Iterator, Sequence

import numpy as np

from cranktrain.grouping import grouped, places_of_equal
from cranktrain.language import Listed, Words, _
from cranktrain.machine import Machine
from cranktrain.saying.sections import ShownSection
from cranktrain.saying.wording import all_of, ranged
from cranktrain.textbook.alike import AlikePistons, alike
from cranktrain.textbook.motion_statements import form_curves, form_heading, form_notes, form_statements, root_curves
from cranktrain.textbook.shown.of_machine import FormErrors, MachinePage
from cranktrain.textbook.shown.tables import ROUND_ANGLES, curve_section, stated_error_grid
from cranktrain.textbook.statements import ERRORS, StatementCurve
from cranktrain.texts.comparison import FORMS
from cranktrain.texts.plain_cranks import PLAIN
from cranktrain.texts.ranges import EXACT_ROOT, RANGES, Range

_ANGLES = np.deg2rad(ROUND_ANGLES)


def ranges_of(machine: Machine, source: str) -> list[Range]:
    """Methods of a source that speak of one of the machine's mechanisms."""
    kinds = {place.kind.name for place in machine.places}
    return [one for one in RANGES if one.source == source and not kinds.isdisjoint(FORMS[one.method])]


def form_sections(page: MachinePage, source: str) -> Iterator[ShownSection]:
    """Give every method of a source with its range, who is inside, and its largest errors."""
    for one in ranges_of(page.machine, source):
        errors = stated_error_grid(form_statements(page.machine, page.result, one))
        yield ShownSection(form_heading(one), (*form_notes(page.machine, one), errors))


def motion_sections(machine: Machine, sources: Collection[str]) -> Iterator[ShownSection]:
    """Give the motion of every distinct piston or valve by each form of some sources."""
    curves = [curve for one in RANGES if one.source in sources for curve in form_curves(machine, one, _ANGLES)]
    if EXACT_ROOT.source in sources:
        curves += [curve for one in alike(machine.places, PLAIN) for curve in root_curves(one, _ANGLES)]
    for each in grouped((curve.of, curve) for curve in curves).values():
        for by_form in grouped((curve.words, curve) for curve in each).values():
            yield _form_section(by_form)


def usual_sections(machine: Machine, source: str, usual: str) -> Iterator[ShownSection]:
    """Give the motion of the first piston of which a source speaks by the usual one of its methods."""
    for one in ranges_of(machine, source):
        if one.method == usual:
            curves = grouped((curve.of, curve) for curve in form_curves(machine, one, _ANGLES))
            yield _form_section(next(iter(curves.values())))


def _form_section(curves: Sequence[StatementCurve]) -> ShownSection:
    """Displacement, velocity and acceleration of a form at round angles from where the own crank points."""
    heading = _(
        "{symbols} of {pistons} by {form}",
        symbols=", ".join(one.symbol for one in curves),
        pistons=curves[0].of,
        form=curves[0].words,
    )
    return curve_section(heading, ROUND_ANGLES, ((one.equation, one) for one in curves))


def form_errors(page: MachinePage, source: str) -> Iterator[FormErrors]:
    """Give the largest errors of each method, of any piston that is inside its range, and of any outside."""
    for one in ranges_of(page.machine, source):
        found = list(form_statements(page.machine, page.result, one))
        own = [place for place in page.machine.places if place.kind.name in FORMS[one.method]]
        names = [place.name for place in own]
        whose = {each.of: _inside(one, each) for each in alike(page.machine.places, FORMS[one.method])}
        for words, members in places_of_equal(_inside(one, AlikePistons(place.name, place)) for place in own).items():
            largest = [
                max(each.value for each in found if each.symbol == symbol and whose[each.of] == words)
                for symbol in ERRORS
            ]
            said = Listed((_(one.name), words), "; ")
            yield FormErrors(", ".join(one.equations), ranged(names, members), largest, said)


def _inside(one: Range, piston: AlikePistons) -> Words:
    """Say whether a piston is inside a method's range, and for what not; or that the text gives no range."""
    if one.most_ratio is None:
        return _("the text gives no range")
    outside = list(one.reasons(piston.ratio, piston.offset))
    return _("outside, as {reasons}", reasons=all_of(outside)) if outside else _("inside its range")
