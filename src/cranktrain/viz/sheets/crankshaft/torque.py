"""The sheet of the torque along the shaft: its range in every journal and pin, curves, and a table."""

from collections.abc import Sequence

import numpy as np

from cranktrain.analysis import Result
from cranktrain.errors import InputError, Problem
from cranktrain.language import said as _
from cranktrain.motion import Array
from cranktrain.numerics.ties import falling, first_largest
from cranktrain.questions.crankshaft.methods import title_of
from cranktrain.questions.crankshaft.results.section_torques import SECTIONS
from cranktrain.saying.scales import scale_for
from cranktrain.saying.wording import ABSENT
from cranktrain.viz.figures import column
from cranktrain.viz.panel import OneDesign
from cranktrain.viz.paper.head import result_page
from cranktrain.viz.paper.page import LINE, Box, Figure, Page, drawing_settings
from cranktrain.viz.paper.panels import FORCES, axes_in, draw_panels
from cranktrain.viz.paper.style import COLOURS, INK
from cranktrain.viz.paper.tables import LEAST_ROW, ROW, write_table
from cranktrain.viz.sheets.crankshaft.panels import of_shafts, on_journals, torque_panels

_LEFT = 0.5
"""Share of the curves over the crank angle in the width."""
_BARS = 0.34
"""Share of the bars in the height."""
_MARGIN = 0.06
"""Over and under the bars, in parts of their reach."""


@drawing_settings()
def sheet_shaft_torque(result: Result, *, size: str = "A4", design: int = 0) -> Figure:
    """Draw the torque along the shaft.

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
        If pins have no torque, as of a shaft that floats.
    """
    shown = OneDesign(result, design)
    if not np.all(np.isfinite(shown("section_torque_range")[0])):
        raise InputError([Problem("crankshaft", None, _("gives no torque in pins, so there is no sheet of it"))])
    page, box = result_page(result, design, size, _("Torque along the shaft"))
    curves, right = box.columns(_LEFT, 12.0)
    draw_panels(page, list(torque_panels(shown)), curves, FORCES)
    below = _draw_ranges(page, shown, right)
    _write_table(page, shown, right._replace(height=below - right.bottom))
    return page.figure


def _draw_ranges(page: Page, shown: OneDesign, room: Box) -> float:
    """Draw a bar from the least to the largest torque of every section; give where the picture ends. [mm]"""
    largest, least = (shown(f"{kind}_section_torque")[0] for kind in ("largest", "least"))
    names, journals = shown.result.labels["section"], on_journals(shown)
    unit = scale_for("N*m", float(max(np.max(np.abs(largest)), np.max(np.abs(least)))))
    top, height = room.bottom + room.height, _BARS * room.height
    page.heading(room.left, top - 3.0, _("Least to largest torque along the shaft, {unit}", unit=unit.label))
    axes = axes_in(page, Box(room.left + 9.0, top - 7.0 - height, room.width - 9.0, height))
    places = np.arange(len(names))
    widest = first_largest(np.where(journals, largest - least, -1.0))
    colours = np.where(journals, COLOURS["T"], "white").tolist()
    low, span = unit.of(least), unit.of(largest - least)
    bars = axes.bar(places, span, bottom=low, width=0.62, color=colours, edgecolor=COLOURS["T"], linewidth=0.7)
    bars[widest].set(edgecolor=INK, linewidth=1.8)
    axes.axhline(0.0, color=INK, linewidth=0.6)
    axes.grid(visible=False, axis="x")
    axes.set_xlim(-0.7, len(names) - 0.3)
    reach = float(np.max(low + span) - np.min(low))
    axes.set_ylim(float(np.min(low)) - _MARGIN * reach, float(np.max(low + span)) + _MARGIN * reach)
    own = np.flatnonzero(journals).tolist()
    named = of_shafts([names[i].replace(f"{SECTIONS[0]} ", "") for i in own])
    axes.set_xticks(own, [name for _shaft, name in named])
    foot = top - 7.0 - height - 8.5
    step = (room.width - 9.0) / (len(names) + 0.4)
    for shaft in dict.fromkeys(shaft for shaft, _name in named if shaft):
        middle = np.mean([i for i, (other, _name) in zip(own, named, strict=True) if other == shaft])
        page.text(room.left + 9.0 + step * (float(middle) + 0.7), foot, shaft, ha="center")
    foot -= LINE if named[0][0] else 0.0
    words = (
        _("Filled: journals, by their numbers; hollow: the crank pins between them."),
        _("Framed: the worst journal, of the widest range."),
    )
    page.notes(room.left, foot, words)
    return foot - 2 * LINE - 1.0


def _write_table(page: Page, shown: OneDesign, room: Box) -> None:
    """Write range, largest and least of every section; where there is no room for all, of those with the widest."""
    kinds = ("section_torque_range", "largest_section_torque", "least_section_torque")
    ranges, largest, least = (shown(name)[0] for name in kinds)
    names, method = shown.result.titles["section"], title_of(shown.result.labels["bearing_method"][0])
    n_fit = int((room.height - 16.0) / LEAST_ROW)
    members: Sequence[int] = sorted(falling(ranges)[:n_fit])
    unit = scale_for("N*m", float(np.max(np.abs(largest))))
    head = [_("section"), _("range, {unit}"), _("largest"), _("at φ, °"), _("least"), _("at φ, °")]
    columns = [
        column(ranges[members].tolist(), unit),
        column(largest[members].tolist(), unit),
        _placed(shown("largest_section_torque_at")[0][members]),
        column(least[members].tolist(), unit),
        _placed(shown("least_section_torque_at")[0][members]),
    ]
    rows = [[word.format(unit=unit.label) for word in head]]
    rows += [[names[i], *row] for i, row in zip(members, zip(*columns, strict=True), strict=True)]
    top = room.bottom + room.height
    line = ROW if len(rows) * ROW < room.height - 12.0 else LEAST_ROW
    below = write_table(page, rows, (room.left, top, room.width), (0.36, 0.53, 0.68, 0.85, 1.0), line)
    words = [_("In pins, by: {method}; in journals no method matters.", method=method)]
    if len(members) < len(names):
        words.append(_("{n} more sections, of narrower ranges, are in the result.", n=len(names) - len(members)))
    page.notes(room.left, below - 0.5, words)


def _placed(angles: Array) -> list[str]:
    """Crank angles of a column; what is nothing stands nowhere."""
    return [f"{at:.1f}" if np.isfinite(at) else ABSENT for at in angles.tolist()]
