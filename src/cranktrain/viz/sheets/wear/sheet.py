"""The sheet of wear: mean load on the rays of crank pins, journals and their bearings, and where oil holes go."""

from collections.abc import Iterator, Sequence

import numpy as np

from cranktrain.analysis import Result
from cranktrain.errors import InputError, Problem
from cranktrain.language import said as _
from cranktrain.motion import Array
from cranktrain.questions.crankshaft.methods import title_of
from cranktrain.saying.scales import scale_for
from cranktrain.viz.figures import plain
from cranktrain.viz.panel import OneDesign
from cranktrain.viz.paper.head import result_page
from cranktrain.viz.paper.page import LINE, Box, Figure, Page, drawing_settings, rounded_down
from cranktrain.viz.paper.style import FILLS, INK, MUTED
from cranktrain.viz.sheets.crankshaft.polar import cells
from cranktrain.viz.sheets.wear.panels import WearDiagram, journal_wear, pin_wear, turned_by

_DEEPEST = 0.62
"""How far into a circle the largest load of the sheet reaches, in parts of its radius."""
_HEAD = 9.0
"""Over a circle for its words. [mm]"""
_LARGEST = 30.0
"""Radius of a circle, at most. [mm]"""
_ROUND = np.linspace(0.0, 2 * np.pi, 181)
_ROW = 8
"""Circles in a row, at most."""
_LOWEST, _FOOT = 28.0, 20.0
"""Height of a row, at least, and about what the words below need. [mm]"""
_WIDEST = 56.0
"""Room of a circle. [mm]"""


@drawing_settings()
def sheet_wear(result: Result, *, size: str = "A4", design: int = 0) -> Figure:
    """Draw the wear of crank pins, journals and bearings, by the rule of ±60°.

    Parameters
    ----------
    result : Result
        Of a machine with rods on crank pins; with [crankshaft] journals and bearings, too.
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
        If nothing has a load.
    """
    shown = OneDesign(result, design)
    groups = [[one for one in group if np.all(np.isfinite(one.wear))] for group in _groups(shown)]
    rows = [group[start : start + _ROW] for group in groups for start in range(0, len(group), _ROW)]
    if not any(np.any(one.wear > 0.0) for group in groups for one in group):
        raise InputError([Problem("masses", None, _("give no loads of crank pins, so there is no sheet of wear"))])
    page, box = result_page(result, design, size, _("Wear, and places for oil holes"))
    fitting = rows[: int((box.height - _FOOT) / _LOWEST)]
    drawn = [one for row in fitting for one in row]
    notes = list(_notes(shown, sum(map(len, groups)) - len(drawn)))
    foot = LINE * (len(notes) + 1) + 4.0
    above = box._replace(bottom=box.bottom + foot, height=box.height - foot)
    rooms = cells(above, len(drawn)) if len(drawn) <= _ROW else list(_rooms(above, [*map(len, fitting)]))
    radius = min(_LARGEST, rooms[0].width / 2 - 3.0, (rooms[0].height - _HEAD) / 2 - 1.0)
    most = max(float(np.max(one.wear)) for one in drawn)
    unit = scale_for("N", most)
    force = most / (_DEEPEST * radius)
    bar = rounded_down(float(unit.of(most)))
    for one, room in zip(drawn, rooms, strict=True):
        _draw(page, one, room, radius, force)
    y = box.bottom + LINE * len(notes)
    page.sample(box.left, box.left + bar * unit.one / force, y + 0.9, color=INK, lw=2.0, solid_capstyle="butt")
    words = _("{force} {unit}, mean over the cycle, inward from the circle", force=plain(bar), unit=unit.label)
    page.text(box.left + bar * unit.one / force + 2.0, y, words)
    page.notes(box.left, y - LINE, notes)
    return page.figure


def _groups(shown: OneDesign) -> Iterator[Sequence[WearDiagram]]:
    """All that wears: pins with their rods, journals, bearings."""
    yield list(pin_wear(shown))
    if shown.has("journal_wear"):
        yield from zip(*journal_wear(shown), strict=True)


def _rooms(box: Box, lengths: Sequence[int]) -> Iterator[Box]:
    """Rooms in rows of some lengths, all as wide as those of the longest."""
    width, height = min(box.width / max(lengths), _WIDEST), box.height / len(lengths)
    for row, length in enumerate(lengths):
        for place in range(length):
            yield Box(box.left + place * width, box.bottom + box.height - (row + 1) * height, width, height)


def _draw(page: Page, one: WearDiagram, room: Box, radius: float, force: float) -> None:
    """Draw the circle, what the loads take off it, and the oil hole."""
    pole = np.array([room.left + room.width / 2, room.bottom + (room.height - _HEAD) / 2])
    directions = turned_by(one)
    closed = np.append(directions, directions[0] - one.turn * 2 * np.pi)
    inner = radius - np.append(one.wear, one.wear[0]) / force
    edge = pole[:, np.newaxis] + radius * _unit(_ROUND)
    worn = pole[:, np.newaxis] + inner * _unit(closed)
    outside = pole[:, np.newaxis] + radius * _unit(closed)
    ring = np.concatenate([outside, worn[:, ::-1]], axis=1)
    page.paper.fill(*ring, facecolor=FILLS["light"], edgecolor="none", zorder=2)
    page.paper.plot(*edge, color=INK, linewidth=0.9, zorder=4)
    page.paper.plot(*worn, color=INK, linewidth=0.8, zorder=4)
    for axis in (0, 1):
        ends = np.tile(pole[:, np.newaxis], 2)
        ends[axis] += np.array([-1.0, 1.0]) * (radius + 1.5)
        page.paper.plot(*ends, color=MUTED, linewidth=0.4, zorder=1)
    page.text(float(pole[0]), float(pole[1]) + radius + 2.5, one.title, ha="center", fontweight="bold")
    if np.isfinite(one.hole):
        _draw_hole(page, one, pole, radius)


def _draw_hole(page: Page, one: WearDiagram, pole: Array, radius: float) -> None:
    """Draw the oil hole from the middle through the surface, and write its place."""
    towards = _unit(np.array([np.pi / 2 - one.turn * one.hole]))[:, 0]
    across = 0.9 * np.array([-towards[1], towards[0]])
    for side in (-1.0, 1.0):
        ends = np.stack([pole + side * across, pole + side * across + radius * towards], axis=1)
        page.paper.plot(*ends, color=INK, linewidth=0.7, zorder=5)
    page.paper.plot(*np.stack([pole, pole + (radius + 1.5) * towards], axis=1), color=INK, linewidth=0.4, zorder=5)
    at = pole + np.array([0.0, -0.45 * radius if towards[1] > 0 else 0.3 * radius])
    page.text(
        float(at[0]),
        float(at[1]),
        f"{np.rad2deg(one.hole):.0f}°",
        ha="center",
        va="center",
        zorder=6,
        bbox={"facecolor": "white", "edgecolor": "none", "pad": 0.6},
    )


def _unit(angle: Array) -> Array:
    return np.stack([np.cos(angle), np.sin(angle)])


def _notes(shown: OneDesign, n_left_out: int) -> Sequence[str]:
    """Say what counts from where, by which method, and what is left out."""
    words = [
        _("Each load counts with its full size on all rays within 60° of its line; the hole goes where least acts."),
        _("Up is away from the shaft on a pin, along the rod on its bearing, and rotation is to the right."),
    ]
    if shown.has("journal_wear"):
        method = title_of(shown.result.labels["bearing_method"][0])
        words += [
            _(
                "Journals likewise, up is toward throw 1; main bearings as seen from the free end, by: {method}.",
                method=method,
            )
        ]
    words.append(_("Degrees count from up in the sense of rotation."))
    if n_left_out > 0:
        words.append(_("{n} more diagrams are in the result.", n=n_left_out))
    return words
