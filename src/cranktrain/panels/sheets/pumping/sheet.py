"""The sheet of a pumping unit: curves over the crank angle, its card with permissible loads, and a table of facts."""

from collections.abc import Iterator

import numpy as np

from cranktrain.analysis import Result
from cranktrain.language import Message, Words, _
from cranktrain.panels.design import OneDesign
from cranktrain.panels.parts import CurveCard, Notes, Sheet, SheetColumn, Stack, facts_table, sheet_of
from cranktrain.panels.sheets.pumping.panels import card_panel, largest_torque, pumping_panels, rated_torque
from cranktrain.saying.amounts import Amount


def sheet_pumping(result: Result, *, design: int = 0) -> Sheet:
    """Collect what the gearbox of a pumping unit gives.

    Parameters
    ----------
    result : Result
        Of a machine with [pumping].
    design : int
        Which of the result's machines.

    Returns
    -------
    Sheet
    """
    shown = OneDesign(result, design)
    return sheet_of(
        result,
        design,
        _("Pumping unit"),
        SheetColumn(0.52, (Stack(tuple(pumping_panels(shown))),)),
        SheetColumn(
            0.48,
            (
                CurveCard((card_panel(shown),), height=0.48),
                facts_table(_("Gearbox and counterbalance"), list(_facts(shown))),
                Notes(tuple(_notes(shown))),
            ),
        ),
    )


def _facts(shown: OneDesign) -> Iterator[tuple[Message, Words]]:
    """What stands in the table."""
    yield _("stroke of the polished rod"), shown.amount("rod_stroke")
    yield _("peak of the upstroke"), shown.amount("upstroke_peak")
    yield _("peak of the downstroke"), shown.amount("downstroke_peak")
    yield _("least torque"), shown.amount("least_gearbox_torque")
    yield _("mean torque"), shown.amount("mean_gearbox_torque")
    yield _("cyclic load factor"), shown.amount("cyclic_load_factor")
    rated = rated_torque(shown)
    if np.isfinite(rated):
        yield _("rated torque"), Amount(rated, "N*m")
        yield _("largest torque, of the rating"), Amount(largest_torque(shown) / rated, "%")
    yield _("moment of the counterbalance"), shown.amount("counterbalance_moment")
    yield _("for equal peaks"), shown.amount("equal_peaks_moment")
    yield _("peaks with that"), shown.amount("equal_peaks_torque")
    yield _("for the least root mean square"), shown.amount("least_rms_moment")
    yield _("power at the polished rod"), shown.amount("polished_rod_power")


def _notes(shown: OneDesign) -> Iterator[Message]:
    """Say what the curves leave out."""
    yield _("Quasi-static, of loads alone. Permissible loads are infinite at the ends of the stroke.")
    if not np.isfinite(rated_torque(shown)):
        yield _("No permissible loads: [pumping] has no rated_torque.")
