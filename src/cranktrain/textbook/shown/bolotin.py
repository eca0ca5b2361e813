"""What Bolotin's text has for a machine: (I.13), opposed pistons by (I.11) and (I.12), dead centres, leads.

Constants of (I.13) are as derived, as reconstructed, and of the exact motion.
"""

from collections.abc import Iterator, Sequence

import numpy as np

from cranktrain.grouping import grouped
from cranktrain.language import N_, Listed, Words, _
from cranktrain.saying.sections import Column, Decimals, Grid, PagePart, Part, ShownSection
from cranktrain.saying.wording import ranged
from cranktrain.textbook.constants_statements import EQUATION, SOURCE, alike_slaves, constants_statements
from cranktrain.textbook.opposed_statements import (
    INNER,
    OUTER,
    OpposedCylinders,
    opposed_cylinders,
    opposed_statements,
    subjects,
)
from cranktrain.textbook.shown.forms import form_errors, form_sections, ranges_of
from cranktrain.textbook.shown.of_machine import FormErrors, MachinePage, TextOfMachine
from cranktrain.textbook.shown.tables import EXACT, curve_section, error_grid
from cranktrain.textbook.statements import LARGEST, Statement, Statements

_DECIMALS = {"E": 6, "Φ": 4, "F": 6, "Θ": 3, "K": 3, "H": 3}
_UNITS = {"1": ("", 1.0), "rad": ("deg", float(np.rad2deg(1.0))), "m": ("mm", 1e3)}
_TRAVEL = N_("Travel S of the pistons of {cylinders} by the exhaust crank's angle")


def _whole(page: MachinePage) -> Iterator[PagePart]:
    """Give all but the motion of slaves over the turn."""
    yield from form_sections(page, SOURCE)
    yield from _constants(page)
    if cylinders := opposed_cylinders(page.machine.places):
        yield from _opposed(page, cylinders)


def _constants(page: MachinePage) -> Iterator[ShownSection]:
    """K, E, F, Φ, Θ and H of every distinct slave on an articulated rod."""
    slaves = alike_slaves(page.machine.places)
    if not slaves:
        return
    found = constants_statements(slaves)
    rows = grouped((one.words if len(slaves) == 1 else Listed((one.of, one.words)), one) for one in found)
    sets = [{one.symbol: one for one in members} for members in rows.values()]
    columns = [_column(symbol, [each.get(symbol) for each in sets]) for symbol in _DECIMALS]
    names = [place.name for place in page.machine.places if place.kind.is_slave]
    heading = _(
        "Constants of {equation} for {pistons} [{source}]",
        equation=EQUATION,
        pistons=ranged(names, range(len(names))),
        source=SOURCE,
    )
    yield ShownSection(heading, (Grid(columns, list(rows)),))
    for subject, sentences in found.sentences.items():
        yield ShownSection(subject, sentences)


def _column(symbol: str, members: Sequence[Statement | None]) -> Column:
    """One constant of every set; blank where a set has none."""
    unit, factor = _UNITS[next(one.unit for one in members if one is not None)]
    values = ["" if one is None else factor * one.value for one in members]
    return Column(symbol, values, unit, Decimals(_DECIMALS[symbol]))


def _opposed(page: MachinePage, cylinders: Sequence[OpposedCylinders]) -> Iterator[ShownSection]:
    """What the source has on opposed pistons, beside what is exact."""
    found = opposed_statements(cylinders, page.result)
    for one in cylinders:
        form, dead_centres, lead = subjects(one, several=len(cylinders) > 1)
        own = [statement for statement in found if statement.of in one.of]
        errors = error_grid(grouped((each.words, each) for each in own if each.at == LARGEST))
        yield ShownSection(form, (*found.sentences[form], errors, _scheme(one)))
        if page.with_table:
            yield from _motion(one, found)
        yield ShownSection(dead_centres, (*_dead_centres(own), "", *found.sentences[dead_centres]))
        yield ShownSection(lead, found.sentences[lead])


def _scheme(one: OpposedCylinders) -> Words:
    """Say what draws fig. 1.3 of a cylinder."""
    command = f"cranktrain plot FILE --plan scheme --mechanism {one.places[0][0].cylinder} -o scheme.svg"
    return _("fig. 1.3: {command}", command=command)


def _motion(one: OpposedCylinders, found: Statements) -> Iterator[ShownSection]:
    """Travel, velocity and acceleration of each piston and of both together by the source and exact."""
    curves = grouped((curve.symbol, curve) for curve in found.over_turn if curve.of in one.of)
    headings = (_(_TRAVEL, cylinders=one.of[2]), _("Their v/ω"), _("Their j/ω²"))
    for heading, parts in zip(headings, curves.values(), strict=True):
        heads = [*(curve.equation for curve in parts[:-1]), _("both")]
        yield curve_section(heading, found.crank_angle, zip(heads, parts, strict=True))


def _dead_centres(own: Sequence[Statement]) -> Iterator[Part]:
    """Volumetric dead centres by the source, to first order and exact; the combined stroke."""
    yield _("after the exhaust crank's inner dead centre; w = R(1 + λ) inside, R(1 − λ) outside")
    sets = grouped((one.symbol, one) for one in own if one.at in (INNER, OUTER))
    exact = next(iter(sets.values()))
    columns = [Column(symbol, [one.value for one in each], "deg") for symbol, each in sets.items()]
    columns.append(Column(_(EXACT), [one.exact for one in exact], "deg"))
    yield Grid(columns, [_(one.at) for one in exact])


def _errors(page: MachinePage) -> Iterator[FormErrors]:
    """Give those of slaves, and of (I.11), (I.12) and their sum for the first cylinders that are alike."""
    yield from form_errors(page, SOURCE)
    for one in opposed_cylinders(page.machine.places)[:1]:
        largest = [found for found in opposed_statements([one], page.result) if found.at == LARGEST]
        for words, own in grouped((found.words, found) for found in largest).items():
            yield FormErrors(own[0].equation, one.of[2], [each.error for each in own], words)


def _beside(page: MachinePage) -> Iterator[ShownSection]:
    """Give the travel of opposed pistons by (I.11), (I.12), and of both together, where no other text is asked for."""
    for one in opposed_cylinders(page.machine.places)[:1] if page.with_table and page.is_of_one else ():
        found = opposed_statements([one], page.result)
        curves = ((curve.equation, curve) for curve in found.over_turn if curve.symbol == "S")
        yield curve_section(_(_TRAVEL, cylinders=one.of[2]), found.crank_angle, curves)


OF_MACHINE = TextOfMachine(
    speaks=lambda machine: bool(ranges_of(machine, SOURCE) or opposed_cylinders(machine.places)),
    whole=_whole,
    beside=_beside,
    errors=_errors,
    usual="reconstructed",
)
