"""The sheet of a machine: its throw to scale, its curves, and what both rest on."""

from collections.abc import Sequence

from cranktrain.analysis import Result
from cranktrain.io.description import layout_words
from cranktrain.language import _
from cranktrain.machine import Machine
from cranktrain.viz.curves import TEXTBOOK_DASHES, Mark, draw_panels, marks, panels, textbook_words
from cranktrain.viz.detail import draw_detail, wants_detail
from cranktrain.viz.mechanism import mechanism_sketch
from cranktrain.viz.page import MARGIN, Figure, Page, drawing_settings, fitting_scale, muted, paper
from cranktrain.viz.scene import scene_of
from cranktrain.viz.style import INK, TITLE
from cranktrain.viz.words import provenance_words, running_words, zero_words

_FEW = 2
"""Up to so many mechanisms, each has a ruler of its own."""

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
        top = title_block(page, machine, [running_words(machine)], [zero_words(machine)])
        middle = MARGIN + 0.48 * (width - 2 * MARGIN)
        found = marks(result, design)
        _draw_mechanism(page, machine, found, at, (MARGIN, MARGIN, middle - 4.0 - MARGIN, top - 4.0 - MARGIN))
        left, right = middle + 12.0, width - MARGIN
        is_rocker = "piston" not in result.labels
        textbook = "" if is_rocker else textbook_words(result, design)
        below = _ruler(page, found, textbook, (left, right, top - 4.0), is_rocker=is_rocker)
        draw_panels(page, panels(result, design), (left, MARGIN, right - left, below - MARGIN))
        return page.figure


def title_block(page: Page, machine: Machine, about: Sequence[str], below: Sequence[str]) -> float:
    """Head a sheet; give where it ends. [mm]"""
    top = page.height - MARGIN
    page.text(MARGIN, top - 4.5, machine.name or _("Machine without a name"), fontsize=TITLE, fontweight="bold")
    layout = layout_words(machine)
    page.text(MARGIN, top - 10.0, ". ".join([layout[:1].upper() + layout[1:], *about]))
    page.text(MARGIN, top - 14.5, ". ".join(below), **muted())
    page.text(page.width - MARGIN, top - 10.0, provenance_words(machine), ha="right")
    page.rule(top - 17.5)
    return top - 17.5


def _draw_mechanism(
    page: Page, machine: Machine, found: Sequence[Mark], at: float, box: tuple[float, float, float, float]
) -> None:
    """Draw the throw as large as a round scale allows."""
    left, bottom, width, height = box
    foot = 14.0
    room = (width, height - foot)
    scene = scene_of(machine)
    at = scene.closing_angle(at)
    dead = [[mark.angle for mark in found if mark.name == member.place.name] for member in scene.members]
    sketch = mechanism_sketch(scene, at, scene.crank_radius / _ROUGH, dead)
    for _pass in range(_PASSES):
        low_x, high_x, low_y, high_y = sketch.bounds()
        scale = fitting_scale(high_x - low_x, high_y - low_y, (room[0] - 3.0, room[1] - 10.0))
        sketch = mechanism_sketch(scene, at, scale, dead, has_ring=not wants_detail(scene, scale))
    low_x, high_x, low_y, high_y = (value / sketch.scale for value in sketch.bounds())
    origin = (left + room[0] / 2 - (low_x + high_x) / 2, bottom + foot + room[1] / 2 - (low_y + high_y) / 2)
    page.draw(sketch, origin)
    if wants_detail(scene, sketch.scale):
        draw_detail(page, scene, (at, dead), sketch, origin, (left, bottom + foot, *room))
    page.scale_bar(left, bottom + 9.0, sketch.scale)
    throws = len(machine.main_shaft.throws)
    drawn = (
        _("Throw {throw} of {n}, drawn at φ = {angle:g}°").format(
            throw=scene.members[0].place.throw + 1, n=throws, angle=at
        )
        if throws > 1
        else _("Drawn at φ = {angle:g}°").format(angle=at)
    )
    if len(machine.shafts) > 1:
        drawn = _("{drawn}; of shaft main, no other is drawn").format(drawn=drawn)
    bored = all(member.bore is not None for member in scene.sliders)
    shapes = (
        _("pins and bores to scale, other shapes schematic; thin: dead positions")
        if scene.sliders and bored
        else _("pins to scale, shapes schematic; thin: dead positions")
    )
    page.text(left, bottom + 3.6, drawn, **muted())
    page.text(left, bottom - 0.4, shapes, **muted())


def _ruler(
    page: Page, found: Sequence[Mark], textbook: str, place: tuple[float, float, float], *, is_rocker: bool
) -> float:
    """Draw the true dead centres over the curves; give where the ruler ends. [mm]"""
    left, right, top = place
    names = list(dict.fromkeys(mark.name for mark in found))
    if not found:
        page.heading(left, top - 3.0, _("The rocker turns with the crank") if is_rocker else _("No dead centres"))
        return top - 5.0
    page.heading(left, top - 3.0, _("Dead positions of the rocker") if is_rocker else _("True dead centres"))
    _legend(page, names, textbook, right, top - 3.0)
    words = (_("largest at"), _("smallest at")) if is_rocker else (_("TDC"), _("BDC"))
    rows: dict[str, list[tuple[Mark, str]]] = {}
    for mark in found:
        word = words[0] if mark.is_top else words[1]
        row, label = (
            (mark.name, f"{word} {mark.angle:.2f}°") if len(names) <= _FEW else (word, f"{mark.name}\n{mark.angle:.1f}")
        )
        rows.setdefault(row, []).append((mark, label))
    y = top - 9.0
    for number, (row, labelled) in enumerate(rows.items()):
        page.rule(y, left, right)
        page.text(left - 14.0, y - 1.0, "" if is_rocker else row, fontweight="bold")
        if len(names) <= _FEW and not is_rocker:
            page.paper.plot((left - 8.5, left - 2.0), (y, y), color=INK, lw=0.9 if number else 1.9)
            if number:
                page.paper.plot([left - 5.25], [y], "o", ms=3.2, mfc="white", mec=INK, mew=0.8)
        for mark, label in labelled:
            _mark(page, mark, label, (left, right, y), is_first=mark.name == names[0], is_beside=len(names) <= _FEW)
        y -= 5.5 if len(names) <= _FEW else 11.5
    return y


def _legend(page: Page, names: Sequence[str], textbook: str, right: float, y: float) -> None:
    """Say what the habits of lines are that no ruler shows."""
    if textbook:
        start = page.start(page.text(right, y, _("textbook: {forms}").format(forms=textbook), ha="right"))
        page.sample(start - 9.0, start - 1.5, y + 0.9, color=INK, lw=0.6, dashes=TEXTBOOK_DASHES)
        right = start - 13.0
    if len(names) > _FEW:
        for words, width in ((f"{names[1]}–{names[-1]}", 0.6), (names[0], 1.9)):
            start = page.start(page.text(right, y, words, ha="right"))
            page.sample(start - 8.0, start - 1.5, y + 0.9, color=INK, lw=width)
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
