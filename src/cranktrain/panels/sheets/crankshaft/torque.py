"""The sheet of the torque along the shaft: its range in every journal and pin, curves, and a table."""

import numpy as np

from cranktrain.analysis import Result
from cranktrain.errors import InputError, Problem
from cranktrain.language import _
from cranktrain.numerics.ties import first_largest
from cranktrain.panels.design import OneDesign
from cranktrain.panels.parts import BarChart, Sheet, SheetColumn, Stack, Table, TableColumn, sheet_of
from cranktrain.panels.shapes import Bars, peak
from cranktrain.panels.sheets.crankshaft.panels import on_journals, torque_panels
from cranktrain.questions.crankshaft.methods import title_of
from cranktrain.questions.crankshaft.results.section_torques import SECTIONS
from cranktrain.saying.amounts import UnitLabel


def sheet_shaft_torque(result: Result, *, design: int = 0) -> Sheet:
    """Collect the torque along the shaft.

    Parameters
    ----------
    result : Result
        Of a machine with [crankshaft].
    design : int
        Which of the result's machines.

    Returns
    -------
    Sheet

    Raises
    ------
    InputError
        If pins have no torque, as of a shaft that floats.
    """
    shown = OneDesign(result, design)
    if not np.all(np.isfinite(shown("section_torque_range")[0])):
        raise InputError([Problem("crankshaft", None, _("gives no torque in pins, so there is no sheet of it"))])
    left, right = Stack(tuple(torque_panels(shown))), (BarChart(_ranges(shown), height=0.45), _table(shown))
    return sheet_of(result, design, _("Torque along the shaft"), SheetColumn(0.5, (left,)), SheetColumn(0.5, right))


def _ranges(shown: OneDesign) -> Bars:
    """A bar from the least to the largest torque of every section."""
    largest, least = (shown(f"{kind}_section_torque")[0] for kind in ("largest", "least"))
    names, journals = shown.result.labels["section"], on_journals(shown)
    return Bars(
        _("Least to largest torque along the shaft, {unit}", unit=UnitLabel("N*m", max(peak(largest), peak(least)))),
        "N*m",
        least,
        largest,
        journals,
        np.arange(len(names), dtype=np.float64),
        tuple(
            name.replace(f"{SECTIONS[0]} ", "") if is_own else ""
            for name, is_own in zip(names, journals.tolist(), strict=True)
        ),
        first_largest(np.where(journals, largest - least, -1.0)),
        (
            _("Filled: journals, by their numbers; hollow: the crank pins between them."),
            _("Framed: the worst journal, of the widest range."),
        ),
    )


def _table(shown: OneDesign) -> Table:
    """Range, largest and least of every section; where there is no room for all, of those with the widest."""
    kinds = ("section_torque_range", "largest_section_torque", "least_section_torque")
    ranges, largest, least = (shown(name)[0] for name in kinds)
    most = peak(largest)
    return Table(
        (
            TableColumn(_("section"), shown.result.titles["section"]),
            TableColumn(_("range, {unit}", unit=UnitLabel("N*m", most)), ranges, "N*m", most),
            TableColumn(_("largest"), largest, "N*m", most),
            TableColumn(_("at φ, °"), shown("largest_section_torque_at")[0], decimals=1),
            TableColumn(_("least"), least, "N*m", most),
            TableColumn(_("at φ, °"), shown("least_section_torque_at")[0], decimals=1),
        ),
        (0.36, 0.53, 0.68, 0.85, 1.0),
        ranks=ranges,
        left_out=_("{n} more sections, of narrower ranges, are in the result."),
        notes=(
            _(
                "In pins, by: {method}; in journals no method matters.",
                method=title_of(shown.result.labels["bearing_method"][0]),
            ),
        ),
    )
