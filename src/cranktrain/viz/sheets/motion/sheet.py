"""The sheet of a machine: its throw to scale, its curves, and what both rest on."""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from functools import cache

import numpy as np

from cranktrain.analysis import Result, SpeedWanted
from cranktrain.grouping import grouped
from cranktrain.language import said as _
from cranktrain.layout.speed import SpeedCurve
from cranktrain.machine import Machine
from cranktrain.plans.drawn_throws import drawn_throws
from cranktrain.plans.positions import chosen_scale
from cranktrain.plans.vectors import pair
from cranktrain.record import record
from cranktrain.viz.panel import Role
from cranktrain.viz.paper.head import first_that_holds, result_page
from cranktrain.viz.paper.page import MARGIN, Box, Figure, Page, drawing_settings
from cranktrain.viz.paper.panels import MOTION, PENS, draw_panels
from cranktrain.viz.paper.sketch import Sketch, labelled_bounds
from cranktrain.viz.paper.style import INK, MUTED
from cranktrain.viz.sheets.motion.dead_centres import FEW, SHORT, Mark, Ruler, ruler_of
from cranktrain.viz.sheets.motion.panels import panels
from cranktrain.viz.throw.beside import Beside, at_scale, fitted
from cranktrain.viz.throw.detail import draw_throw_detail, needs_detail
from cranktrain.viz.throw.mechanism import mechanism_sketch
from cranktrain.viz.throw.scene import Scene, scene_of

_NOTE = 4.0
"""Height of a line of notes at the foot. [mm]"""

_ROUGH = 20.0
"""Crank radius on paper to begin with. [mm]"""

_BETWEEN, _AXIS = 6.0, 14.0
"""Between two columns of curves, and what each needs left of its axes for their figures and names. [mm]"""

_ANGLE = 50.0
"""Crank angle at which the throw is drawn, unless given. [deg]"""


_WIDE, _LARGER = 2.0, 1.2
"""How wide throws are for their height that take the page's whole width, and by how much larger they come out then."""

_LINE_FOOT = 10.0
"""Below such throws for scale and notes. [mm]"""

_NARROW = MOTION._replace(reach=11.5, sample=(8.5, 3.0))
"""Look of curves in two columns."""

_UPPER = 0.5
"""Height of such throws, in parts of the room."""


@drawing_settings()
def sheet(
    result: Result,
    *,
    size: str = "A4",
    at: float = _ANGLE,
    design: int = 0,
    piston: str | None = None,
    scale: float | None = None,
) -> Figure:
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
    piston : str, optional
        Whose throw alone is drawn, by the mechanism's name or its cylinder's; one of each sort unless given.
    scale : float, optional
        Millimetres of metal in one of paper, 4 for 1:4; the largest round one that fits, unless given.

    Returns
    -------
    Figure
        In millimetres of paper: the throw is to the scale that the sheet says.
    """
    machine = result.machines[design]
    page, box = result_page(result, design, size)
    ruler = ruler_of(result, design, piston)
    throws = _throws(machine, ruler.marks, at, piston, result.get(SpeedCurve) or "constant")
    foot = 6.0 + _NOTE * len(throws.notes)
    middle = 0.48 * box.width
    lower = box.bottom + (1.0 - _UPPER) * box.height
    beside = box._replace(width=middle - 4.0, bottom=box.bottom + foot, height=box.height - foot)
    above = box._replace(bottom=lower + _LINE_FOOT, height=_UPPER * box.height - _LINE_FOOT)
    drawn = cache(throws.drawn)
    narrow, wide = (fitted(drawn, throws.rough, (room.width - 1.0, room.height - 6.0)) for room in (beside, above))
    width, height = pair(np.subtract(*reversed(labelled_bounds(narrow.sketch))))
    is_wide = narrow.scale >= _LARGER * wide.scale and width >= _WIDE * height
    notes = ("; ".join(throws.notes),) if is_wide else throws.notes
    _draw_throws(page, replace(throws, notes=notes), wide if is_wide else narrow, above if is_wide else beside, scale)
    curves = panels(result, design, piston)
    if is_wide:
        half = 0.5 * (box.width - _BETWEEN)
        below = _draw_ruler(page, ruler, box.left + _AXIS, box.left + half, lower - 4.0)
        n = -(-len(curves) // 2)
        for number, some in enumerate((curves[:n], curves[n:])):
            left = box.left + number * (half + _BETWEEN) + _AXIS
            if some:
                draw_panels(page, some, Box(left, box.bottom, half - _AXIS, below - box.bottom), _NARROW)
        return page.figure
    left, right = box.left + middle + 12.0, box.left + box.width
    below = _draw_ruler(page, ruler, left, right, box.bottom + box.height)
    draw_panels(page, curves, Box(left, box.bottom, right - left, below - box.bottom), MOTION)
    return page.figure


@record
class _Throws:
    """The throws that a sheet shows: their scenes, the crank angle [deg], dead positions of each, notes."""

    scenes: tuple[Scene, ...]
    at: float
    dead: tuple[tuple[list[float], ...], ...]
    notes: tuple[str, ...]

    @property
    def rough(self) -> float:
        """Scale to begin with."""
        return max(scene.crank_radius for scene in self.scenes) / _ROUGH

    def drawn(self, scale: float) -> list[Sketch]:
        """A sketch of each throw."""
        return [
            mechanism_sketch(scene, self.at, scale, dead, has_ring=not needs_detail(scene, scale))
            for scene, dead in zip(self.scenes, self.dead, strict=True)
        ]


def _throws(machine: Machine, found: Sequence[Mark], at: float, piston: str | None, speed: SpeedWanted) -> _Throws:
    """Collect the throws that are drawn."""
    throws = drawn_throws(machine, piston)
    scenes = tuple(scene_of(machine, throw, is_alone=len(throws) == 1, speed=speed) for throw in throws)
    for scene in scenes:
        at = scene.closing_angle(at)
    names = [[(member.place.name, member.place.cylinder) for member in scene.members] for scene in scenes]
    dead = tuple(tuple([mark.angle for mark in found if mark.name in own] for own in of_scene) for of_scene in names)
    return _Throws(scenes, at, dead, tuple(_notes(scenes, at)))


def _draw_throws(page: Page, throws: _Throws, found: Beside, room: Box, asked: float | None) -> None:
    """Draw the throws as large as a round scale allows, or to the one that is asked for."""
    if asked is not None:
        scale = 1e3 * chosen_scale(1e-3 * found.scale, asked)
        found = at_scale(throws.drawn, scale, (room.width - 1.0, room.height - 6.0))
    sketch = found.sketch
    low, high = (corner / sketch.scale for corner in labelled_bounds(sketch))
    origin = pair(room.middle - (low + high) / 2)
    page.draw(sketch, origin)
    if len(throws.scenes) == 1 and needs_detail(throws.scenes[0], sketch.scale):
        draw_throw_detail(page, throws.scenes[0], (throws.at, throws.dead[0]), sketch, origin, room)
    page.scale_bar(room.left, room.bottom - 5.0, sketch.scale)
    below = room.bottom - 6.0 - _NOTE * len(throws.notes)
    for number, note in enumerate(reversed(throws.notes)):
        page.text(room.left, below - 0.4 + _NOTE * number, note, color=MUTED)


def _notes(scenes: Sequence[Scene], angle: float) -> Iterator[str]:
    """Say what is drawn, at which crank angle, and what of it is to scale."""
    members = [member for scene in scenes for member in scene.members]
    sliders = [slider for scene in scenes for slider in scene.sliders]
    yield _drawn_words(scenes, angle)
    if any(member.turn.points for member in members):
        yield _("marks on a point's curve at every 30° of the crank, filled at φ = 0")
    if scenes[0].assumed:
        yield _("distance of the shafts assumed for the drawing: the file does not give it")
    if any(member.place.is_far for member in members):
        yield _("dashed: side rods, which pass outside the cylinder")
    broken = [member.place.name for member in members if member.cut]
    if broken:
        yield _("rod of {names} broken, its slider drawn nearer to the shaft", names=", ".join(broken))
    shapes = _("pins to scale, shapes schematic")
    pistons = [member for member in sliders if member.place.kind.output.has_chambers]
    if pistons and all(member.bore is not None for member in pistons):
        shapes = _("pins and bores to scale, other shapes schematic")
    thin = _("thin: volumetric dead centres") if any(scene.pairs for scene in scenes) else _("thin: dead positions")
    yield f"{shapes}; {thin}"


def _drawn_words(scenes: Sequence[Scene], angle: float) -> str:
    """Say which throws are drawn, of which shafts, and at which crank angle."""
    machine = scenes[0].machine
    n = len(machine.main_shaft.throws)
    places = [member.place for scene in scenes for member in scene.cranks]
    shafts = [shaft for shaft in machine.shafts if shaft in {place.shaft for place in places}]
    throws = sorted({place.throw + 1 for place in places})
    said = [f"{place.shaft} {place.throw + 1}" for place in places] if len(shafts) > 1 else map(str, throws)
    drawn = first_that_holds(
        (len(shafts) > 1 and len(throws) > 1, _("Throws {throws}, drawn at φ = {angle:g}°")),
        (len(throws) > 1, _("Throws {throws} of {n}, drawn at φ = {angle:g}°")),
        (n > 1, _("Throw {throw} of {n}, drawn at φ = {angle:g}°")),
        (True, _("Drawn at φ = {angle:g}°")),
    ).format(throws=", ".join(said), throw=throws[0], n=n, angle=angle)
    return first_that_holds(
        (len(machine.shafts) == 1, "{drawn}"),
        (len(shafts) == len(machine.shafts), _("{drawn}; shafts {shafts}")),
        (len(shafts) > 1, _("{drawn}; shafts {shafts}, no other is drawn")),
        (True, _("{drawn}; of shaft {shaft}, no other is drawn")),
    ).format(drawn=drawn, shaft=shafts[0], shafts=", ".join(shafts))


def _draw_ruler(page: Page, ruler: Ruler, left: float, right: float, top: float) -> float:
    """Draw the true dead centres over the curves; give where the ruler ends. [mm]"""
    page.heading(left, top - 3.0, ruler.heading)
    if not ruler.marks:
        return top - 5.0
    y = top - 9.0
    _legend(page, ruler, right, top - 3.0)
    if ruler.has_legend and ruler.is_few and ruler.textbook:
        y -= 5.0
    has_samples = bool(ruler.pistons) and ruler.is_few and not ruler.is_of_cylinders
    rows = grouped((mark.name if ruler.is_few else mark.word, mark) for mark in ruler.marks)
    for number, (row, marks) in enumerate(rows.items()):
        page.rule(y, left, right)
        if ruler.pistons and len(row) <= SHORT + 2:
            start = left - (14.0 if has_samples else 2.0)
            page.text(start, y - 1.0, row, ha="left" if has_samples else "right", fontweight="bold")
        if has_samples:
            _sample(page, "second" if number else "first", left - 8.5, left - 2.0, y)
        for mark in marks:
            x = left + (right - left) * (mark.angle % 360.0) / 360.0
            _mark(page, ruler, mark, (x, y), right)
        y -= 5.5 if ruler.is_few else 11.5
    return y


def _sample(page: Page, role: Role, start: float, end: float, y: float) -> None:
    """Draw a sample of a curve's line, of a second one with a ring."""
    page.sample(start, end, y, color=INK, lw=PENS[role].width)
    if role == "second":
        page.paper.plot([(start + end) / 2], [y], "o", ms=3.2, mfc="white", mec=INK, mew=0.8)


def _legend(page: Page, ruler: Ruler, right: float, y: float) -> None:
    """Say what the habits of lines are that no ruler shows."""
    if ruler.textbook:
        start, _end = page.ends(page.text(right, y, _("textbook: {forms}", forms=ruler.textbook), ha="right"))
        page.sample(
            start - 9.0, start - 1.5, y + 0.9, color=INK, lw=PENS["textbook"].width, dashes=PENS["textbook"].dashes
        )
        right = start - 13.0
    if not ruler.has_legend:
        return
    is_many = len(ruler.pistons) > FEW
    words = [ruler.pistons[0], f"{ruler.pistons[1]}–{ruler.pistons[-1]}"] if is_many else ruler.pistons
    roles: tuple[Role, Role] = ("first", "other" if is_many else "second")
    if ruler.textbook and not is_many:  # there is no room beside it
        right, y = page.width - MARGIN, y - 5.0
    for number in reversed(range(len(words))):
        start, _end = page.ends(page.text(right, y, words[number], ha="right"))
        _sample(page, roles[number], start - 8.0, start - 1.5, y + 0.9)
        right = start - 11.0


def _mark(page: Page, ruler: Ruler, mark: Mark, place: tuple[float, float], right: float) -> None:
    """Draw one dead centre: a triangle, filled for the first piston, with its angle beside or below it."""
    x, y = place
    fill = INK if mark.name == ruler.names[0] else "white"
    page.paper.plot([x], [y], "v" if mark.is_top else "^", ms=4.5, mfc=fill, mec=INK, mew=0.7, zorder=6)
    if ruler.is_few:
        is_last = x > right - 26.0
        words = f"{mark.word} {mark.angle:.2f}°"
        page.text(x + (-2.0 if is_last else 2.0), y + 0.8, words, ha="right" if is_last else "left")
    else:
        page.text(x, y - 1.6, f"{mark.name}\n{mark.angle:.1f}", ha="center", va="top", linespacing=1.05)
