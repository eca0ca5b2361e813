"""The sheet of crank pins: polar diagrams in the pin's axes and in the rod's, and their largest and mean loads."""

from collections.abc import Iterator, Sequence

import numpy as np

from cranktrain.analysis import Result
from cranktrain.errors import InputError, Problem
from cranktrain.language import said as _
from cranktrain.numerics.ties import largest_first
from cranktrain.saying.scales import scale_for
from cranktrain.saying.wording import ABSENT
from cranktrain.viz.figures import column
from cranktrain.viz.panel import OneDesign
from cranktrain.viz.paper.head import result_page
from cranktrain.viz.paper.page import LINE, Box, Figure, drawing_settings
from cranktrain.viz.paper.tables import LEAST_ROW, write_table
from cranktrain.viz.sheets.crankshaft.panels import AlikePins, alike_pins, crank_pin_diagrams
from cranktrain.viz.sheets.crankshaft.polar import draw_diagrams

_MOST = 6
"""Pins that have drawings: of more, those that bear most."""


@drawing_settings()
def sheet_crankpins(result: Result, *, size: str = "A4", design: int = 0) -> Figure:
    """Draw the polar diagrams of all crank pins that differ.

    Parameters
    ----------
    result : Result
        Of a machine with rods on crank pins.
    size : "A4" or "A3"
        Lying.
    design : int
        Which of the result's machines.

    Returns
    -------
    Figure

    Raises
    ------
    InputError
        If no rod has a load.
    """
    shown = OneDesign(result, design)
    pins = alike_pins(shown)
    if not pins:
        raise InputError([Problem("masses", None, _("give no loads of crank pins, so there is no sheet of them"))])
    page, box = result_page(result, design, size, _("Loads of the crank pins"))
    largest = shown("largest_crankpin_load")
    drawn = sorted(largest_first(pins, lambda pin: float(largest[pin.first]))[:_MOST])
    unit = scale_for("N", float(np.nanmax(largest)))
    notes = list(_notes(len(pins) - len(drawn)))
    foot = 10.0 + LEAST_ROW * (len(drawn) + 1) + LINE * len(notes)
    above = Box(box.left, box.bottom + foot, box.width, box.height - foot)
    diagrams = [one for pin in drawn for one in crank_pin_diagrams(shown, pin)]
    words = draw_diagrams(page, diagrams, above, unit)
    rows = list(_rows(shown, drawn))
    write_table(page, rows, (box.left, box.bottom + foot, min(box.width, 190.0)), line=LEAST_ROW)
    page.notes(box.left, box.bottom + LINE * len(notes), [f"{words}.", *notes])
    return page.figure


def _rows(shown: OneDesign, pins: Sequence[AlikePins]) -> Iterator[Sequence[str]]:
    """Write what each pin bears."""
    members = [pin.first for pin in pins]
    largest, mean, at = (
        shown(name)[members] for name in ("largest_crankpin_load", "mean_crankpin_load", "largest_crankpin_load_at")
    )
    unit = scale_for("N", float(np.max(largest)))
    heads = [_("rod of"), _("largest, {unit}"), _("at φ, °"), _("mean, {unit}"), _("largest : mean")]
    columns = [column(largest.tolist(), unit), [f"{one:.1f}" for one in at.tolist()], column(mean.tolist(), unit)]
    columns.append([f"{ratio:.2f}" for ratio in (largest / mean).tolist()])
    heads = [head.format(unit=unit.label) for head in heads]
    if shown.has("largest_crankpin_pressure"):
        pressures = [shown(f"{kind}_crankpin_pressure")[members] for kind in ("largest", "mean")]
        bars = scale_for("Pa", float(np.nanmax(pressures[0])))
        heads += [_("specific, {unit}", unit=bars.label), _("its mean, {unit}", unit=bars.label)]
        columns += [column(one.tolist(), bars) for one in pressures]
    heads.append(_("oil hole, °"))
    columns.append(
        [
            f"{np.rad2deg(one):.0f}" if np.isfinite(one) else ABSENT
            for one in shown("crankpin_oil_hole")[members].tolist()
        ]
    )
    yield heads
    for pin, row in zip(pins, zip(*columns, strict=True), strict=True):
        yield pin.names, *row


def _notes(n_left_out: int) -> Iterator[str]:
    """Say which way is up, and what is left out."""
    yield _("On the pin up is away from the shaft, right with rotation; on the rod's bearing up is along the rod.")
    yield _("Pins whose loads are alike are drawn once; the oil hole counts from the pin's outermost point.")
    if n_left_out > 0:
        yield _("{n} more pins, which bear less, are in the result.", n=n_left_out)
