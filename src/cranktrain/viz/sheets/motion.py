"""The sheet of a machine: its throw to scale, its curves, and what both rest on."""

from collections.abc import Iterator, Sequence
from textwrap import wrap
from typing import NamedTuple

import numpy as np

from cranktrain.analysis import Result
from cranktrain.io.description import layout_words
from cranktrain.language import _
from cranktrain.layout.speed_curve import SpeedCurve
from cranktrain.machine import Machine
from cranktrain.one_line import short
from cranktrain.viz.paper.labels import label_outline
from cranktrain.viz.paper.page import MARGIN, Figure, Page, drawing_settings, fitting_scale, muted, paper
from cranktrain.viz.paper.sketch import Sketch
from cranktrain.viz.paper.style import INK, TITLE
from cranktrain.viz.paper.words import provenance_words, running_words, speed_words, unused_words, zero_words
from cranktrain.viz.sheets.curves import (
    TEXTBOOK_DASHES,
    Mark,
    draw_panels,
    marks,
    opposed_names,
    panels,
    textbook_words,
)
from cranktrain.viz.throw.detail import draw_detail, wants_detail
from cranktrain.viz.throw.mechanism import mechanism_sketch
from cranktrain.viz.throw.scene import Scene, scene_of

_FEW = 2
"""Up to so many mechanisms, each has a ruler of its own."""

_SHORT = 3
"""Letters of a name that has room beside the ruler, with a sample of its line."""

_NOTE = 4.0
"""Height of a line of notes at the foot. [mm]"""

_LONGEST_NAME = 100
"""Characters of a title."""
_LETTERS = 60
"""Letters in a line of the head, for each 100 mm."""

_ROUGH, _PASSES = 20.0, 3
"""Crank radius on paper to begin with, and how often the scale is corrected: hatches keep their size on paper."""

_ANGLE = 50.0
"""Crank angle at which the throw is drawn, unless given. [deg]"""


def sheet(result: Result, *, size: str = "A4", at: float = _ANGLE, design: int = 0) -> Figure:
    """Draw the sheet of a machine.

    Parameters
    ----------
    result : Result
    size : "A4" or "A3"
        Lying.
    at : float
        Crank angle at which the throw is drawn. [deg]
    design : int
        Which of the result's machines.

    Returns
    -------
    Figure
        In millimetres of paper: the throw is to the scale that the sheet says.
    """
    with drawing_settings():
        width, height = paper(size)
        page = Page(width, height)
        machine = result.machines[design]
        at_speed = speed_words(result.get(SpeedCurve), design)
        top = title_block(
            page, machine, [running_words(machine)], [zero_words(machine)], at_speed, unused_words(result)
        )
        middle = MARGIN + 0.48 * (width - 2 * MARGIN)
        found = marks(result, design)
        _draw_mechanism(page, machine, found, at, (MARGIN, MARGIN, middle - 4.0 - MARGIN, top - 4.0 - MARGIN))
        left, right = middle + 12.0, width - MARGIN
        ruler = _ruler_of(result, found, design)
        below = _draw_ruler(page, ruler, (left, right, top - 4.0))
        draw_panels(page, panels(result, design), (left, MARGIN, right - left, below - MARGIN))
        return page.figure


def title_block(
    page: Page,
    machine: Machine,
    about: Sequence[str],
    below: Sequence[str],
    at_speed: str = "",
    unused: Sequence[str] = (),
) -> float:
    """Head a sheet, and say where not at a constant speed at which one, and what is not used; give where it ends. [mm]

    Each sentence of unused has lines of its own.
    """
    top = page.height - MARGIN
    page.text(
        MARGIN,
        top - 4.5,
        short(machine.name, _LONGEST_NAME) or _("Machine without a name"),
        fontsize=TITLE,
        fontweight="bold",
    )
    layout = layout_words(machine)
    page.text(MARGIN, top - 10.0, ". ".join([layout[:1].upper() + layout[1:], *about]))
    page.text(MARGIN, top - 14.5, ". ".join(below), **muted())
    page.text(page.width - MARGIN, top - 10.0, provenance_words(machine), ha="right")
    letters = int((page.width - 2 * MARGIN) * _LETTERS / 100.0)
    for line in [*([at_speed] if at_speed else []), *(line for sentence in unused for line in wrap(sentence, letters))]:
        page.text(MARGIN, top - 19.0, line)
        top -= 4.5
    page.rule(top - 17.5)
    return top - 17.5


def _draw_mechanism(
    page: Page, machine: Machine, found: Sequence[Mark], at: float, box: tuple[float, float, float, float]
) -> None:
    """Draw the throw as large as a round scale allows."""
    left, bottom, width, height = box
    scene = scene_of(machine)
    at = scene.closing_angle(at)
    notes = list(_notes(scene, at))
    foot = 6.0 + _NOTE * len(notes)
    room = (width, height - foot)
    names = [(member.place.name, member.place.cylinder) for member in scene.members]
    dead = [[mark.angle for mark in found if mark.name in own] for own in names]
    sketch = mechanism_sketch(scene, at, scene.crank_radius / _ROUGH, dead)
    for _pass in range(_PASSES):
        low_x, high_x, low_y, high_y = _extent(sketch)
        scale = fitting_scale(high_x - low_x, high_y - low_y, (room[0] - 1.0, room[1] - 6.0))
        sketch = mechanism_sketch(scene, at, scale, dead, has_ring=not wants_detail(scene, scale))
    low_x, high_x, low_y, high_y = (value / sketch.scale for value in _extent(sketch))
    origin = (left + room[0] / 2 - (low_x + high_x) / 2, bottom + foot + room[1] / 2 - (low_y + high_y) / 2)
    page.draw(sketch, origin)
    if wants_detail(scene, sketch.scale):
        draw_detail(page, scene, (at, dead), sketch, origin, (left, bottom + foot, *room))
    page.scale_bar(left, bottom + foot - 5.0, sketch.scale)
    for number, note in enumerate(reversed(notes)):
        page.text(left, bottom - 0.4 + _NOTE * number, note, **muted())


def _extent(sketch: Sketch) -> tuple[float, float, float, float]:
    """Least and largest X and Y of a sketch with its words. [mm of the sketch]"""
    points = np.concatenate(
        [*sketch.outline(), *(label_outline(label, sketch.scale) for label in sketch.labels)], axis=1
    )
    low, high = np.nanmin(points, axis=1), np.nanmax(points, axis=1)
    return float(low[0]), float(high[0]), float(low[1]), float(high[1])


def _notes(scene: Scene, angle: float) -> Iterator[str]:
    """Say what is drawn, at which crank angle, and what of it is to scale."""
    yield _drawn_words(scene, angle)
    if scene.assumed:
        yield _("distance of the shafts assumed for the drawing: the file does not give it")
    if any(member.place.is_far for member in scene.members):
        yield _("dashed: side rods, which pass outside the cylinder")
    broken = [member.place.name for member in scene.members if member.cut]
    if broken:
        yield _("rod of {names} broken, its slider drawn nearer to the shaft").format(names=", ".join(broken))
    shapes = _("pins to scale, shapes schematic")
    pistons = [member for member in scene.sliders if member.place.kind.has_chambers]
    if pistons and all(member.bore is not None for member in pistons):
        shapes = _("pins and bores to scale, other shapes schematic")
    thin = _("thin: volumetric dead centres") if scene.pairs else _("thin: dead positions")
    yield f"{shapes}; {thin}"


def _drawn_words(scene: Scene, angle: float) -> str:
    """Say which throws are drawn, of which shafts, and at which crank angle."""
    machine = scene.machine
    n = len(machine.main_shaft.throws)
    places = [member.place for member in scene.cranks]
    shafts = [shaft for shaft in machine.shafts if shaft in {place.shaft for place in places}]
    throws = sorted({place.throw + 1 for place in places})
    if len(shafts) > 1 and len(throws) > 1:
        each = ", ".join(f"{place.shaft} {place.throw + 1}" for place in places)
        drawn = _("Throws {throws}, drawn at φ = {angle:g}°").format(throws=each, angle=angle)
    elif len(throws) > 1:
        words = _("Throws {throws} of {n}, drawn at φ = {angle:g}°")
        drawn = words.format(throws=", ".join(map(str, throws)), n=n, angle=angle)
    elif n > 1:
        drawn = _("Throw {throw} of {n}, drawn at φ = {angle:g}°").format(throw=throws[0], n=n, angle=angle)
    else:
        drawn = _("Drawn at φ = {angle:g}°").format(angle=angle)
    if len(shafts) == len(machine.shafts):
        if len(shafts) > 1:
            drawn = _("{drawn}; shafts {shafts}").format(drawn=drawn, shafts=", ".join(shafts))
        return drawn
    if len(shafts) == 1:
        return _("{drawn}; of shaft {shaft}, no other is drawn").format(drawn=drawn, shaft=shafts[0])
    return _("{drawn}; shafts {shafts}, no other is drawn").format(drawn=drawn, shafts=", ".join(shafts))


class _Ruler(NamedTuple):
    """What is written over the curves.

    words: of a mark at the top and at the bottom, or largest and smallest; pistons: names of the curves; textbook:
    forms beside the curves, if any; is_of_cylinders: whether the marks are of cylinders and not of these pistons;
    valves: which of the names are valves, that have no top.
    """

    heading: str
    words: tuple[str, str]
    marks: Sequence[Mark]
    pistons: Sequence[str]
    textbook: str
    is_of_cylinders: bool = False
    valves: Sequence[str] = ()

    def word(self, mark: Mark) -> str:
        """Word of a mark."""
        words = (_("farthest"), _("nearest")) if mark.name in self.valves else self.words
        return words[0] if mark.is_top else words[1]

    @property
    def names(self) -> list[str]:
        """Whose marks these are."""
        return list(dict.fromkeys(mark.name for mark in self.marks))

    @property
    def is_few(self) -> bool:
        """Whether each of them has a row of its own."""
        return len(self.names) <= _FEW

    @property
    def has_legend(self) -> bool:
        """Whether habits of lines are said over the rows: these are of something else, or too small for the names."""
        return self.is_of_cylinders or not self.is_few or any(len(name) > _SHORT for name in self.pistons)


def _ruler_of(result: Result, found: Sequence[Mark], design: int) -> _Ruler:
    """Collect what the ruler shows: dead centres of pistons, volumetric ones of cylinders, or those of a rocker."""
    if "piston" not in result.labels:
        heading = _("Dead positions of the rocker") if found else _("The rocker turns with the crank")
        return _Ruler(heading, (_("largest at"), _("smallest at")), found, (), "")
    pair = opposed_names(result.machines[design])
    if pair:
        return _Ruler(_("Volumetric dead centres"), (_("inner"), _("outer")), found, pair, "", is_of_cylinders=True)
    names = list(dict.fromkeys(mark.name for mark in found))
    valves = [place.name for place in result.machines[design].places if not place.kind.has_chambers]
    heading = _("True dead centres") if found else _("No dead centres")
    if found and set(names) <= set(valves):
        heading = _("Ends of valve travel")
    elif set(names) & set(valves):
        heading = _("Dead centres; ends of valve travel")
    textbook = textbook_words(result, design)
    return _Ruler(heading, (_("TDC"), _("BDC")), found, names, textbook, valves=valves)


def _draw_ruler(page: Page, ruler: _Ruler, place: tuple[float, float, float]) -> float:
    """Draw the true dead centres over the curves; give where the ruler ends. [mm]"""
    left, right, top = place
    page.heading(left, top - 3.0, ruler.heading)
    if not ruler.marks:
        return top - 5.0
    y = top - 9.0
    if ruler.textbook or ruler.has_legend:
        _legend(page, ruler, right, top - 3.0)
    if ruler.has_legend and ruler.is_few and ruler.textbook:
        y -= 5.0
    rows: dict[str, list[tuple[Mark, str]]] = {}
    for mark in ruler.marks:
        word = ruler.word(mark)
        row, label = (
            (mark.name, f"{word} {mark.angle:.2f}°") if ruler.is_few else (word, f"{mark.name}\n{mark.angle:.1f}")
        )
        rows.setdefault(row, []).append((mark, label))
    for number, (row, labelled) in enumerate(rows.items()):
        page.rule(y, left, right)
        if ruler.pistons and len(row) <= _SHORT + 2:
            if ruler.is_of_cylinders or not ruler.is_few:
                page.text(left - 2.0, y - 1.0, row, ha="right", fontweight="bold")
            else:
                page.text(left - 14.0, y - 1.0, row, fontweight="bold")
        if ruler.pistons and ruler.is_few and not ruler.is_of_cylinders:
            _sample(page, (left - 8.5, left - 2.0, y), number)
        for mark, label in labelled:
            is_first = mark.name == ruler.names[0]
            _mark(page, mark, label, (left, right, y), is_first=is_first, is_beside=ruler.is_few)
        y -= 5.5 if ruler.is_few else 11.5
    return y


def _sample(page: Page, place: tuple[float, float, float], number: int, *, is_one_of_many: bool = False) -> None:
    """Draw a sample of a curve's line: the first thick, a second thin with a ring, of many all others thin."""
    start, end, y = place
    page.sample(start, end, y, color=INK, lw=1.9 if not number else 0.6 if is_one_of_many else 0.9)
    if number and not is_one_of_many:
        page.paper.plot([(start + end) / 2], [y], "o", ms=3.2, mfc="white", mec=INK, mew=0.8)


def _legend(page: Page, ruler: _Ruler, right: float, y: float) -> None:
    """Say what the habits of lines are that no ruler shows."""
    if ruler.textbook:
        start = page.start(page.text(right, y, _("textbook: {forms}").format(forms=ruler.textbook), ha="right"))
        page.sample(start - 9.0, start - 1.5, y + 0.9, color=INK, lw=0.6, dashes=TEXTBOOK_DASHES)
        right = start - 13.0
    if not ruler.has_legend:
        return
    is_many = len(ruler.pistons) > _FEW
    words = [ruler.pistons[0], f"{ruler.pistons[1]}–{ruler.pistons[-1]}"] if is_many else ruler.pistons
    if ruler.textbook and not is_many:  # there is no room beside it
        right, y = page.width - MARGIN, y - 5.0
    for number in reversed(range(len(words))):
        start = page.start(page.text(right, y, words[number], ha="right"))
        _sample(page, (start - 8.0, start - 1.5, y + 0.9), number, is_one_of_many=is_many)
        right = start - 11.0


def _mark(
    page: Page, mark: Mark, label: str, place: tuple[float, float, float], *, is_first: bool, is_beside: bool
) -> None:
    """Draw one dead centre: a triangle, filled for the first piston, with its angle beside or below it."""
    left, right, y = place
    x = left + (right - left) * (mark.angle % 360.0) / 360.0
    page.paper.plot(
        [x], [y], "v" if mark.is_top else "^", ms=4.5, mfc=INK if is_first else "white", mec=INK, mew=0.7, zorder=6
    )
    if is_beside:
        is_last = x > right - 26.0
        page.text(x + (-2.0 if is_last else 2.0), y + 0.8, label, ha="right" if is_last else "left")
    else:
        page.text(x, y - 1.6, label, ha="center", va="top", linespacing=1.05)
