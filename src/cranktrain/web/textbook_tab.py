"""The tab of the textbooks: how far their forms are off for a machine, what they draw, their constants and errors."""

from collections.abc import Iterator, Sequence
from itertools import chain

import numpy as np

from cranktrain.analysis import Result
from cranktrain.errors import InputError
from cranktrain.language import N_, Listed, Words, _
from cranktrain.machine import Machine
from cranktrain.panels.construction_drawing import construction_drawing
from cranktrain.panels.parts import Notes, Stack
from cranktrain.panels.shapes import Curve, Panel
from cranktrain.panels.textbook_errors import textbook_error_panels
from cranktrain.plans.placement import first_throw
from cranktrain.saying.amounts import KEPT
from cranktrain.saying.percents import percent
from cranktrain.saying.row_table import WrittenGroup, WrittenRow
from cranktrain.saying.typesetting import in_type
from cranktrain.textbook.crank_rocker_statements import pin_velocities
from cranktrain.textbook.shown.errata import errata_sections
from cranktrain.textbook.shown.machine import LARGEST_ERRORS, OF_WHAT, whole_machine
from cranktrain.textbook.shown.of_machine import MachinePage, texts_for
from cranktrain.textbook.shown.tables import EXACT
from cranktrain.texts.contents import Text
from cranktrain.web.parts import PagePart, page_curves
from cranktrain.web.section_parts import page_sections
from cranktrain.web.tabs import AskedTab, PageSheet, TabContent, lacking_sheet

_NAME = N_("Textbook")
_HEADS = ("Δx", "Δv", "Δj")


def _is_there(result: Result) -> bool:
    """Whether any text speaks of a machine."""
    return bool(texts_for(result.machines[0]))


def _content(result: Result) -> TabContent:
    """Compare every text that speaks of a machine."""
    machine = result.machines[0]
    try:
        rows, sheets = tuple(_rows(machine, result)), tuple(_sheets(machine, result))
    except InputError as error:
        return TabContent("", WrittenGroup(str(_(_NAME)), (), ()), (lacking_sheet(error),))
    return TabContent(_sentence(rows), WrittenGroup(str(_(LARGEST_ERRORS)), _HEADS if rows else (), rows), sheets)


TEXTBOOK = AskedTab(_NAME, _is_there, _content)


def _rows(machine: Machine, result: Result) -> Iterator[WrittenRow]:
    """Largest errors of each form, as the terminal writes them."""
    page = MachinePage(machine, result, with_table=False, is_of_one=False)
    for one in chain.from_iterable(has.errors(page) for has in texts_for(machine).values()):
        words = in_type(str(Listed((one.of, one.words), ": ")))
        yield WrittenRow(one.equations, tuple(in_type(percent(error)) for error in one.errors), "%", words, ())


def _sentence(rows: Sequence[WrittenRow]) -> Words:
    """Say by how much the first form is off; nothing where there is none."""
    if not rows:
        return ""
    form = rows[0]
    errors = ", ".join(f"{head} {cell}{KEPT}{form.label}" for head, cell in zip(_HEADS, form.cells, strict=True))
    return _(
        "{title}: {errors} at most by {equations}, {words}",
        title=_(_NAME),
        errors=errors,
        equations=form.name,
        words=form.words,
    )


def _sheets(machine: Machine, result: Result) -> Iterator[PageSheet]:
    """Errors over the turn beside the drawn construction; what each text has; its errors."""
    panels = (*textbook_error_panels(result), *_rocker_panels(machine))
    drawing = construction_drawing(machine)
    if panels:
        stacks = [page_curves(Stack(each), _("Crank angle φ, °")) for each in panels]
        half = (1 + len(stacks)) // 2 if drawing else len(stacks)
        beside = (Notes((_(OF_WHAT),)), drawing) if drawing else ()
        yield PageSheet("", (tuple(stacks[:half]), (*beside, *stacks[half:])))
    for text in texts_for(machine):
        whole = list(page_sections(whole_machine(machine, result, text, with_table=False)))
        yield PageSheet(_heading(text), _halves(whole))
    for text in texts_for(machine):
        title = _("Errors of [{name}], each with what is right", name=text.name)
        _source, *errors = page_sections(errata_sections(text, full=True))
        yield PageSheet(title, _halves(errors))


def _heading(text: Text) -> Listed:
    """Name a text."""
    return Listed((f"[{text.name}]", _(text.title)), " ")


def _rocker_panels(machine: Machine) -> Iterator[tuple[Panel, ...]]:
    """Velocity of a drawn rocker's pin by that of the crank's: exact, by (10), and by what the text refutes."""
    place = next((one for one in first_throw(machine) if one.kind.name == "crank_rocker"), None)
    if place is not None:
        shown = np.arange(361.0)
        found = pin_velocities(place, np.deg2rad(shown) + float(machine.zero + place.phase))
        curves = (
            Curve(found.exact, "first", "v", name=_(EXACT)),
            Curve(found.by_sines, "formula", "F", name="(10)"),
            Curve(found.refuted, "error", "v", name=_("refuted")),
        )
        title = _("Velocity of the rocker's pin by the crank pin's, {rocker}", rocker=place.name)
        yield (Panel(title, "1", shown, curves, "v_A/v_B"),)


def _halves(parts: Sequence[PagePart]) -> tuple[tuple[PagePart, ...], ...]:
    """Put parts into two columns."""
    half = (len(parts) + 1) // 2
    return tuple(parts[:half]), tuple(parts[half:])
