"""The sheet of crank pins: polar diagrams in the pin's axes and in the rod's, and their largest and mean loads."""

from collections.abc import Iterator, Sequence

import numpy as np

from cranktrain.analysis import Result
from cranktrain.errors import InputError, Problem
from cranktrain.language import Message, _
from cranktrain.numerics.ties import largest_first
from cranktrain.panels.design import OneDesign
from cranktrain.panels.parts import Notes, Polars, Sheet, SheetColumn, Table, TableColumn, sheet_of
from cranktrain.panels.shapes import peak
from cranktrain.panels.sheets.crankshaft.panels import AlikePins, alike_pins, crank_pin_diagrams
from cranktrain.saying.amounts import UnitLabel, in_cycle

_MOST = 6
"""Pins that have drawings: of more, those that bear most."""
_WIDTH = 0.68
"""Of the table, in parts of the sheet's."""


def sheet_crankpins(result: Result, *, design: int = 0) -> Sheet:
    """Collect the loads of all crank pins that differ.

    Parameters
    ----------
    result : Result
        Of a machine with rods on crank pins.
    design : int
        Which of the result's machines.

    Returns
    -------
    Sheet

    Raises
    ------
    InputError
        If no rod has a load.
    """
    shown = OneDesign(result, design)
    pins = alike_pins(shown)
    if not pins:
        raise InputError([Problem("masses", None, _("give no loads of crank pins, so there is no sheet of them"))])
    largest = shown("largest_crankpin_load")
    drawn = sorted(largest_first(pins, lambda pin: float(largest[pin.first]))[:_MOST])
    diagrams = Polars(tuple(one for pin in drawn for one in crank_pin_diagrams(shown, pin)))
    notes = Notes(tuple(_notes(len(pins) - len(drawn))))
    return sheet_of(
        result, design, _("Loads of the crank pins"), SheetColumn(1.0, (diagrams, _table(shown, drawn), notes))
    )


def _table(shown: OneDesign, pins: Sequence[AlikePins]) -> Table:
    """What each pin bears."""
    members = [pin.first for pin in pins]
    largest, mean, at = (
        shown(name)[members] for name in ("largest_crankpin_load", "mean_crankpin_load", "largest_crankpin_load_at")
    )
    most = peak(largest)
    columns = [
        TableColumn(_("rod of"), [pin.names for pin in pins]),
        TableColumn(_("largest, {unit}", unit=UnitLabel("N", most)), largest, "N", most),
        TableColumn(_("at φ, °"), in_cycle(at, shown.result.cycle, "position"), decimals=1),
        TableColumn(_("mean, {unit}", unit=UnitLabel("N", most)), mean, "N", most),
        TableColumn(_("largest : mean"), largest / mean, decimals=2),
    ]
    if shown.has("largest_crankpin_pressure"):
        highest, its_mean = (shown(f"{kind}_crankpin_pressure")[members] for kind in ("largest", "mean"))
        unit = UnitLabel("Pa", peak(highest))
        columns += [
            TableColumn(_("specific, {unit}", unit=unit), highest, "Pa", peak(highest)),
            TableColumn(_("its mean, {unit}", unit=unit), its_mean, "Pa", peak(highest)),
        ]
    columns.append(TableColumn(_("oil hole, °"), np.rad2deg(shown("crankpin_oil_hole")[members]), decimals=0))
    last = len(columns) - 1
    return Table(tuple(columns), tuple(_WIDTH * (0.1 + 0.9 * (place + 1) / last) for place in range(last)))


def _notes(n_left_out: int) -> Iterator[Message]:
    """Say which way is up, and what is left out."""
    yield _("On the pin up is away from the shaft, right with rotation; on the rod's bearing up is along the rod.")
    yield _("Pins whose loads are alike are drawn once; the oil hole counts from the pin's outermost point.")
    if n_left_out > 0:
        yield _("{n} more pins, which bear less, are in the result.", n=n_left_out)
