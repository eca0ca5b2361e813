"""The sheet of rod loads: their curves with limits and reversals, indicator diagrams of all stages, a table."""

from collections.abc import Iterator

import numpy as np

from cranktrain.analysis import Result
from cranktrain.errors import InputError, Problem
from cranktrain.language import Message, _
from cranktrain.panels.design import OneDesign
from cranktrain.panels.formulas import mathematics
from cranktrain.panels.parts import CurveCard, Notes, Part, Sheet, SheetColumn, Stack, Table, TableColumn, sheet_of
from cranktrain.panels.shapes import peak
from cranktrain.panels.sheets.rod_load.panels import rod_load_panel, stages_panel
from cranktrain.questions.rod_load.loads import PISTON_ROD
from cranktrain.saying.amounts import Amount, UnitLabel

_MOST = 4
"""Pistons whose curves stand one below the other."""


def sheet_rod_load(result: Result, *, piston: str | None = None, design: int = 0) -> Sheet:
    """Collect rod loads of a machine.

    Parameters
    ----------
    result : Result
        Of a machine with double-acting pistons and gas, or with [rod_load].
    piston : str, optional
        Whose curves; those of the first ones unless given.
    design : int
        Which of the result's machines.

    Returns
    -------
    Sheet

    Raises
    ------
    InputError
        If there is no such piston, or none has rod loads.
    """
    shown = OneDesign(result, design)
    names = result.labels["piston"]
    loaded = [name for place, name in enumerate(names) if np.any(np.isfinite(shown("rod_load")[:, place]))]
    if piston is not None and piston not in loaded:
        allowed = _("must be one of the pistons with rod loads: {names}", names=", ".join(loaded) or _("none"))
        raise InputError([Problem("--mechanism", piston, allowed)])
    own = [piston] if piston is not None else loaded[:_MOST]
    left = Stack(tuple(rod_load_panel(shown, name) for name in own), is_tall=len(own) == 1)
    return sheet_of(
        result,
        design,
        _("Rod loads"),
        SheetColumn(0.55, (left,)),
        SheetColumn(0.45, tuple(_beside(shown, loaded))),
    )


def _beside(shown: OneDesign, loaded: list[str]) -> Iterator[Part]:
    """Indicator diagrams of all chambers, what all rods bear, and what counts."""
    if shown.has("gas_pressure") and shown.has("chamber_volume"):
        yield CurveCard((stages_panel(shown),), height=0.4)
    yield _table(shown, loaded)
    yield Notes(tuple(_notes(shown, len(loaded))), can_go_on=True)


def _table(shown: OneDesign, loaded: list[str]) -> Table:
    """Largest loads of both senses, degrees in tension and the smaller peak's share, by piston and place."""
    places = shown.result.titles["rod_load_place"]
    rows = [
        (shown.member("piston", name), where)
        for name in loaded
        for where in range(len(places))
        if np.isfinite(shown("largest_rod_compression")[where, shown.member("piston", name)])
    ]
    piston, where = np.array(rows).T
    compression, tension = (shown(f"largest_rod_{sense}")[where, piston] for sense in ("compression", "tension"))
    size = max(peak(compression), peak(tension))
    names = [
        _("{piston}, {place}", piston=shown.result.labels["piston"][i], place=places[j])
        if len(loaded) > 1
        else places[j]
        for i, j in rows
    ]
    return Table(
        (
            TableColumn(_("at"), names),
            TableColumn(_("compression, {unit}", unit=UnitLabel("N", size)), compression, "N", size),
            TableColumn(_("tension, {unit}", unit=UnitLabel("N", size)), tension, "N", size),
            TableColumn(_("in tension, °"), shown("tension_arc")[where, piston], decimals=1),
            TableColumn(_("smaller/larger, %"), 100 * shown("reversal_share")[where, piston], decimals=1),
        )
    )


def _notes(shown: OneDesign, n_pistons: int) -> Iterator[Message]:
    """Say what the curves are, what counts as a reversal, and whose curves are left out."""
    yield _(
        "Positive in compression. {gas}: gas alone; {whole}: gas and inertia at the crosshead pin, along the cylinder; "
        "{rod}: at the crank pin, along the rod.",
        gas=mathematics("F_g"),
        whole=mathematics("F"),
        rod=mathematics("S"),
    )
    if np.any(np.isfinite(shown("rod_load")[PISTON_ROD])):
        yield _("{rod}: in the piston rod, without the crosshead.", rod=mathematics("F_r"))
    yield _(
        "A reversal counts from {arc} of either sense and {share} of the larger peak on.",
        arc=shown.amount("wanted_reversal_arc"),
        share=Amount(float(shown("wanted_reversal_share")), "%"),
    )
    if n_pistons > _MOST:
        yield _("{n} more pistons are in the result.", n=n_pistons - _MOST)
