"""Throws on a sheet, as large as a round scale allows, with a detail of a small shaft; the ruler of dead centres."""

from collections.abc import Callable
from functools import cache
from typing import NamedTuple

import numpy as np

from cranktrain.grouping import grouped
from cranktrain.language import said as _
from cranktrain.panels.parts import DrawnThrows, Ruler, RulerMark, ThrowAtAngle
from cranktrain.panels.shapes import Role
from cranktrain.plans.positions import chosen_scale
from cranktrain.plans.vectors import pair
from cranktrain.viz.paper.curves import PENS
from cranktrain.viz.paper.page import MARGIN, Box, Page
from cranktrain.viz.paper.sketch import Sketch, labelled_bounds
from cranktrain.viz.paper.style import INK, MUTED
from cranktrain.viz.throw.beside import Beside, at_scale, fitted
from cranktrain.viz.throw.detail import draw_throw_detail, needs_detail
from cranktrain.viz.throw.mechanism import mechanism_sketch

_NOTE = 4.0
"""Height of a line of notes at the foot. [mm]"""

_ROUGH = 20.0
"""Crank radius on paper to begin with. [mm]"""

_WIDE, _LARGER = 2.0, 1.2
"""How wide throws are for their height that take a sheet's whole width, and by how much larger they come out then."""

_FEW, _SHORT = 2, 3
"""Up to so many mechanisms each have a ruler of their own; letters of a name that has room beside it."""


class FittedThrows(NamedTuple):
    """Throws as they fit a room, what gives their sketches at a scale, and their notes."""

    found: Beside
    drawn: Callable[[float], list[Sketch]]
    room: Box
    notes: tuple[str, ...]


def fitted_throws(throws: DrawnThrows, beside: Box, above: Box) -> tuple[FittedThrows, bool]:
    """Fit throws into one of two rooms, beside curves or above them, whichever lets them be larger; whether above."""
    found = throws.found
    rough = max(scene.crank_radius for scene in found.scenes) / _ROUGH

    @cache
    def drawn(scale: float) -> list[Sketch]:
        return [
            mechanism_sketch(scene, found.at, scale, dead, has_ring=not needs_detail(scene, scale))
            for scene, dead in zip(found.scenes, found.dead, strict=True)
        ]

    notes = tuple(map(str, found.notes))
    foot = 6.0 + _NOTE * len(notes)
    beside = beside._replace(bottom=beside.bottom + foot, height=beside.height - foot)
    narrow, wide = (fitted(drawn, rough, (room.width - 1.0, room.height - 6.0)) for room in (beside, above))
    width, height = pair(np.subtract(*reversed(labelled_bounds(narrow.sketch))))
    if narrow.scale >= _LARGER * wide.scale and width >= _WIDE * height:
        return FittedThrows(wide, drawn, above, ("; ".join(notes),)), True
    return FittedThrows(narrow, drawn, beside, notes), False


def draw_throws(page: Page, throws: DrawnThrows, of: FittedThrows) -> None:
    """Draw throws to the scale that was found, or to the one that is asked for."""
    found, room, drawn = of.found, of.room, throws.found
    if throws.scale is not None:
        scale = 1e3 * chosen_scale(1e-3 * found.scale, throws.scale)
        found = at_scale(of.drawn, scale, (room.width - 1.0, room.height - 6.0))
    sketch = found.sketch
    low, high = (corner / sketch.scale for corner in labelled_bounds(sketch))
    origin = pair(room.middle - (low + high) / 2)
    page.draw(sketch, origin)
    if len(drawn.scenes) == 1 and needs_detail(drawn.scenes[0], sketch.scale):
        draw_throw_detail(page, drawn.scenes[0], (drawn.at, drawn.dead[0]), sketch, origin, room)
    page.scale_bar(room.left, room.bottom - 5.0, sketch.scale)
    below = room.bottom - 6.0 - _NOTE * len(of.notes)
    for number, note in enumerate(reversed(of.notes)):
        page.text(room.left, below - 0.4 + _NOTE * number, note, color=MUTED)


def draw_throw_at_angle(page: Page, one: ThrowAtAngle, room: Box) -> None:
    """Draw a throw under its loads as large as its room allows."""
    found = fitted(
        lambda scale: [mechanism_sketch(one.scene, one.at, scale, has_ring=False)],
        one.scene.size / room.height,
        (room.width - 2.0, room.height - 9.0),
    )
    low, high = (corner / found.scale for corner in labelled_bounds(found.sketch))
    page.heading(room.left, room.bottom + room.height - 4.0, str(one.title))
    below = room._replace(height=room.height - 7.0)
    page.draw(found.sketch, pair(below.middle - (low + high) / 2))


class _Rows(NamedTuple):
    """Where the rows of a ruler are: rows of marks by their names, whether each mechanism has one, a line's samples."""

    rows: dict[str, list[RulerMark]]
    is_few: bool
    has_legend: bool
    has_samples: bool


def _rows_of(ruler: Ruler) -> _Rows:
    """Sort the marks of a ruler into rows."""
    names = dict.fromkeys(mark.name for mark in ruler.marks)
    is_few = len(names) <= _FEW
    rows = grouped((mark.name if is_few else str(mark.word), mark) for mark in ruler.marks)
    # The rows are of something else than the curves, or too small for the names.
    has_legend = ruler.is_of_cylinders or not is_few or any(len(name) > _SHORT for name in ruler.pistons)
    return _Rows(rows, is_few, has_legend, bool(ruler.pistons) and is_few and not ruler.is_of_cylinders)


def draw_ruler(page: Page, ruler: Ruler, left: float, right: float, top: float) -> float:
    """Draw the true dead centres over the curves; give where the ruler ends. [mm]"""
    page.heading(left, top - 3.0, str(ruler.heading))
    if not ruler.marks:
        return top - 5.0
    rows, is_few, has_legend, has_samples = _rows_of(ruler)
    y = top - 9.0
    _legend(page, ruler, right, top - 3.0, has_legend=has_legend)
    if has_legend and is_few and str(ruler.textbook):
        y -= 5.0
    for number, (row, marks) in enumerate(rows.items()):
        page.rule(y, left, right)
        if ruler.pistons and len(row) <= _SHORT + 2:
            start = left - (14.0 if has_samples else 2.0)
            page.text(start, y - 1.0, row, ha="left" if has_samples else "right", fontweight="bold")
        if has_samples:
            _sample(page, "second" if number else "first", left - 8.5, left - 2.0, y)
        for mark in marks:
            x = left + (right - left) * (mark.angle % 360.0) / 360.0
            _mark(page, mark, (x, y), right, is_first=mark.name == ruler.marks[0].name, is_few=is_few)
        y -= 5.5 if is_few else 11.5
    return y


def _sample(page: Page, role: Role, start: float, end: float, y: float) -> None:
    """Draw a sample of a curve's line, of a second one with a ring."""
    page.sample(start, end, y, color=INK, lw=PENS[role].width)
    if role == "second":
        page.paper.plot([(start + end) / 2], [y], "o", ms=3.2, mfc="white", mec=INK, mew=0.8)


def _legend(page: Page, ruler: Ruler, right: float, y: float, *, has_legend: bool) -> None:
    """Say what the habits of lines are that no ruler shows."""
    textbook = str(ruler.textbook)
    if textbook:
        start, _end = page.ends(page.text(right, y, _("textbook: {forms}", forms=textbook), ha="right"))
        pen = PENS["textbook"]
        page.sample(start - 9.0, start - 1.5, y + 0.9, color=INK, lw=pen.width, dashes=pen.dashes)
        right = start - 13.0
    if not has_legend:
        return
    is_many = len(ruler.pistons) > _FEW
    words = [ruler.pistons[0], f"{ruler.pistons[1]}–{ruler.pistons[-1]}"] if is_many else ruler.pistons
    roles: tuple[Role, Role] = ("first", "other" if is_many else "second")
    if textbook and not is_many:  # there is no room beside it
        right, y = page.width - MARGIN, y - 5.0
    for number in reversed(range(len(words))):
        start, _end = page.ends(page.text(right, y, words[number], ha="right"))
        _sample(page, roles[number], start - 8.0, start - 1.5, y + 0.9)
        right = start - 11.0


def _mark(
    page: Page, mark: RulerMark, place: tuple[float, float], right: float, *, is_first: bool, is_few: bool
) -> None:
    """Draw one dead centre: a triangle, filled for the first mechanism, with its angle beside or below it."""
    x, y = place
    fill = INK if is_first else "white"
    page.paper.plot([x], [y], "v" if mark.is_top else "^", ms=4.5, mfc=fill, mec=INK, mew=0.7, zorder=6)
    if is_few:
        is_last = x > right - 26.0
        words = f"{mark.word} {mark.angle:.2f}°"
        page.text(x + (-2.0 if is_last else 2.0), y + 0.8, words, ha="right" if is_last else "left")
    else:
        page.text(x, y - 1.6, f"{mark.name}\n{mark.angle:.1f}", ha="center", va="top", linespacing=1.05)
