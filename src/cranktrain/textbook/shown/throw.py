"""`textbook --throw`: (44) to (53) for a throw, each constituent and all together, and its two balances."""

from collections.abc import Iterator, Sequence

import numpy as np

from cranktrain.grouping import grouped
from cranktrain.language import N_, Listed, Words, _
from cranktrain.numerics.ties import first_largest, first_smallest
from cranktrain.references import REFERENCES
from cranktrain.saying.sections import Column, Grid, Part, Rows, ShownSection
from cranktrain.saying.wording import number
from cranktrain.textbook.shown.tables import curve_section, listed
from cranktrain.textbook.statements import Statement, Statements
from cranktrain.textbook.throw_statements import REACTIONS, SOURCE, TOGETHER

_ONE_TURN = 360.0
_ON_A_SCREEN, _WHOLE = 60.0, 30.0
"""Between the rows of a cycle of two turns that fits a screen, and of all else. [deg]"""
_NOTHING = 1e-12
"""Of the largest length or force of a figure; what is less is not shown."""
_SAID = 5e-3
"""A smaller difference is written with its power. [N]"""


def throw_sections(found: Statements, *, with_table: bool = False, whole: str | None) -> Iterator[ShownSection]:
    """Give lengths, forces, reactions, balance, and what is to be minded; or a first screen.

    Parameters
    ----------
    found : Statements
    with_table : bool
        Whether to give the reactions over the cycle.
    whole : str or None
        The command for all, which stands below the first screen; None for all.
    """
    (throw, about), (balance, follows), (mind, minded) = found.sentences.items()
    if whole is None or not with_table:
        yield ShownSection(throw, (*about, *_figure(found)))
        yield ShownSection(_("Loads of the journals on the bearings L and P"), tuple(_reactions(found)))
        if found.over_turn:
            yield ShownSection(_("Over the cycle, at whole degrees"), (_cycle(found),))
    if with_table:
        is_on_a_screen = whole is not None and found.crank_angle[-1] > _ONE_TURN
        step = _ON_A_SCREEN if is_on_a_screen else _WHOLE
        curves = ((one.symbol, one) for one in found.over_turn)
        yield curve_section(_("Over the cycle"), found.crank_angle, curves, exact=N_("split"), step=step)
    if whole is not None:
        said = _("`{command}`: all, with both balances of the rotating masses and what is to be minded", command=whole)
        yield ShownSection(_("To go on"), (said,))
        return
    yield ShownSection(balance, (_balance(found), "", *follows))
    yield ShownSection(mind, listed(minded))
    yield ShownSection(_("Source"), (REFERENCES[SOURCE].text,))


def _figure(found: Statements) -> Iterator[Grid]:
    """Lengths and forces of fig. 35, but those that are 0."""
    for unit, shown in (("m", "mm"), ("N", "N")):
        own = [one for one in found.numbered("fig. 35") if one.unit == unit and one.symbol != "l"]
        peak = max((abs(one.value) for one in own), default=0.0)
        if columns := [Column(one.symbol, (one.value,), shown) for one in own if abs(one.value) > _NOTHING * peak]:
            yield Grid(columns, ("",))


def _reactions(found: Statements) -> Iterator[Part]:
    """Each constituent in a row, all together, what has no letter, and the split shaft; the resultants."""
    rows = grouped((one.words, one) for one in found if one.symbol in REACTIONS.values())
    labels = [_label(words, own) for words, own in rows.items()]
    cells = [{one.symbol: one.value for one in own} for own in rows.values()]
    if found.over_turn:
        labels.append(_("split shaft"))
        cells.append({one.symbol: one.exact for one in rows[_(TOGETHER)]})
    yield _("K inward, to the axis; T with the rotation, at the crank pin's angle.")
    yield Grid([Column(one, [own.get(one, 0.0) for own in cells], "N") for one in REACTIONS.values()], labels)
    yield ""
    right, left = (next(one for one in found if one.symbol == symbol) for symbol in ("R_P", "R_L"))
    yield _("Resultants: R_P = {right}, R_L = {left}.", right=number(right.value, "N"), left=number(left.value, "N"))
    if any(one.verdict == "beyond" for own in rows.values() for one in own):
        yield _(
            "Rows without a number are loads for which the text has no letter. With them, as the split shaft has it: "
            "R_P = {right}, R_L = {left}.",
            right=number(right.exact, "N"),
            left=number(left.exact, "N"),
        )


def _label(words: Words, own: Sequence[Statement]) -> Words:
    """A constituent with its formulas; the sum is that of all."""
    equations = " ".join(dict.fromkeys(one.equation for one in own))
    return Listed((words, equations), " ") if equations and words != _(TOGETHER) else words


def _cycle(found: Statements) -> Grid:
    """Least and largest of each reaction by the text, and how far it is from the split shaft."""
    columns: list[Column] = []
    for head, pick in ((_("least"), first_smallest), (_("largest"), first_largest)):
        places = [pick(one.values) for one in found.over_turn]
        columns.append(
            Column(head, [float(one.values[at]) for one, at in zip(found.over_turn, places, strict=True)], "N")
        )
        columns.append(Column("φ", [f"{found.crank_angle[at]:g}" for at in places], "deg"))
    off = [float(np.max(np.abs(one.values - one.exact))) for one in found.over_turn if one.exact is not None]
    columns.append(Column(_("off by"), [f"{value:.1e}" if value < _SAID else value for value in off], "N"))
    return Grid(columns, [one.symbol for one in found.over_turn])


def _balance(found: Statements) -> Rows:
    """Both conditions with what is left over."""
    conditions = grouped((one.words, one) for one in found.numbered("after (53)"))
    cells = [
        (
            words,
            *(number(one.value, one.unit) for one in own),
            _("does not") if any(one.value for one in own) else _("holds"),
        )
        for words, own in conditions.items()
    ]
    heads = (_("balance"), _("outward"), _("against the rotation"), "")
    return Rows(cells, heads, right=(1, 2), is_folded=False)
