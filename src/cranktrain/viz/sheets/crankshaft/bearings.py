"""The sheet of main bearings: a polar diagram of each with all methods overlaid, and the methods' table."""

import numpy as np

from cranktrain.analysis import Result
from cranktrain.errors import InputError, Problem
from cranktrain.language import said as _
from cranktrain.one_line import short
from cranktrain.questions.crankshaft.methods import title_of
from cranktrain.saying.scales import scale_for
from cranktrain.saying.wording import ABSENT
from cranktrain.viz.figures import column
from cranktrain.viz.panel import OneDesign
from cranktrain.viz.paper.head import result_page
from cranktrain.viz.paper.page import Box, Figure, Page, drawing_settings
from cranktrain.viz.paper.tables import LEAST_ROW, write_row
from cranktrain.viz.sheets.crankshaft.panels import bearing_diagrams, of_shafts
from cranktrain.viz.sheets.crankshaft.polar import draw_diagrams, line_of_method

_NAMES = 44.0
"""Width of the table's names. [mm]"""
_WIDEST = 22.0
"""Of a column. [mm]"""
_LETTER = 1.8
"""Width of a letter of a bearing's name. [mm]"""


@drawing_settings()
def sheet_crankshaft(result: Result, *, size: str = "A4", design: int = 0) -> Figure:
    """Draw the polar diagrams of all main bearings.

    Parameters
    ----------
    result : Result
        Of a machine with [crankshaft].
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
        If the bearings have no loads, as of a shaft that floats.
    """
    shown = OneDesign(result, design)
    largest = shown("largest_bearing_load")
    if not np.all(np.isfinite(largest)) or not np.any(largest > 0.0):
        raise InputError([Problem("crankshaft", None, _("gives no loads of bearings, so there is no sheet of them"))])
    page, box = result_page(result, design, size, _("Loads of the main bearings"))
    methods = result.labels["bearing_method"]
    height = 12.0 + LEAST_ROW * (len(methods) + 4)
    diagrams = bearing_diagrams(shown)
    unit = scale_for("N", float(np.max(largest)))
    above = Box(box.left, box.bottom + height, box.width, box.height - height)
    words = draw_diagrams(page, diagrams, above, unit)
    _write_table(page, shown, box._replace(height=height))
    page.notes(box.left, box.bottom, [f"{_('Loads of journals on bearings, as seen from the free end')}; {words}."])
    return page.figure


def _write_table(page: Page, shown: OneDesign, room: Box) -> None:
    """Write the largest loads by every method, beside its line; their spread; and the mean by the first."""
    largest, mean = shown("largest_bearing_load"), shown("mean_bearing_load")
    bearings, methods = (shown.result.labels[name] for name in ("bearing", "bearing_method"))
    unit = scale_for("N", float(np.nanmax(largest)))
    width = min((room.width - _NAMES) / len(bearings), _WIDEST)
    places = [
        (room.left + 12.0, "left"),
        *((room.left + _NAMES + width * (place + 1), "right") for place in range(len(bearings))),
    ]
    y = room.bottom + room.height - 9.0
    page.heading(room.left, y, _("Largest load, {unit}", unit=unit.label))
    named = of_shafts(bearings)
    letters = int(width / _LETTER)
    for place, (shaft, name) in enumerate(named):
        write_row(page, (short(name, letters),), [places[1 + place]], y, is_bold=True)
        if shaft and shaft not in (before for before, _name in named[:place]):
            page.text(room.left + _NAMES + width * (place + 0.4), y + LEAST_ROW, shaft, fontweight="bold")
    page.rule(y - 1.4, room.left, room.left + _NAMES + width * len(bearings))
    y -= 1.0
    for place, method in enumerate(methods):
        y -= LEAST_ROW
        page.sample(room.left, room.left + 10.0, y + 0.9, **line_of_method(method, is_first=place == 0))
        write_row(page, (str(title_of(method)), *column(largest[place].tolist(), unit)), places, y, is_bold=place == 0)
    least = np.min(largest, axis=0)
    spread = (np.max(largest, axis=0) - least) / np.where(least > 0.0, least, np.nan)
    rows = (
        (_("methods differ by, %"), [ABSENT if np.isnan(part) else f"{100 * part:.0f}" for part in spread.tolist()]),
    )
    means = (_("mean load by the first"), column(mean[0].tolist(), unit))
    for name, values in (*rows, means):
        y -= LEAST_ROW
        write_row(page, (name, *values), [(room.left, "left"), *places[1:]], y, is_bold=False)
