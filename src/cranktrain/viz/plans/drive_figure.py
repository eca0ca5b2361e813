"""Figs. 1 and 2 of [gandzha]: a crank-rocker with its instant centre C, and torque and GD² over the crank angle."""

from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from cranktrain.language import said as _
from cranktrain.mechanisms.crank_rocker.kinematics import crank_rocker
from cranktrain.motion import Array
from cranktrain.numerics.ties import largest_of
from cranktrain.panels.figures import figure
from cranktrain.plans.stroke_lines import unit
from cranktrain.references import REFERENCES
from cranktrain.texts.crank_rocker_drive import Directions, centre_distances, crank_pin_force, directions, rod_force
from cranktrain.texts.drive_curves import Thing, Verdict, curve_facts, dead_positions, drive_curves, values_at
from cranktrain.texts.drive_table import CrankRockerDrive
from cranktrain.viz.paper import shapes
from cranktrain.viz.paper.curves import axes_in
from cranktrain.viz.paper.page import MARGIN, Axes, Box, Figure, Page, drawing_settings, fitting_scale, paper
from cranktrain.viz.paper.sketch import Circle, Label, Line, Sketch, Wish, placed_labels
from cranktrain.viz.paper.style import COLOURS, INK, MUTED, TITLE
from cranktrain.viz.paper.tables import LEAST_ROW, write_table
from cranktrain.viz.plans.sheet import centre

_SOURCE = "gandzha"
_WIDE = 0.42
"""Part of a sheet's width for the mechanism; curves have the rest."""
_TABLE = 70.0
"""Height of what stands below the mechanism. [mm]"""
_FAR = 2.2
"""An instant centre farther from O than so many ground lengths is said and not drawn."""
_SECOND = 14.0
"""Room for the numbers of a scale at the right. [mm]"""
_COLUMNS = (1.0,)
_ARC = 8.0
"""Radius of the arcs of angles on paper. [mm]"""


class _Pen(NamedTuple):
    """Width of a curve [pt], its dashes in widths, and its colour."""

    width: float
    dashes: tuple[float, ...]
    colour: str


_PENS: Mapping[str, _Pen] = {
    "active": _Pen(1.9, (), COLOURS["T"]),
    "dry": _Pen(1.3, (6.0, 2.0), COLOURS["T"]),
    "source": _Pen(0.8, (9.0, 2.0, 1.5, 2.0), INK),
    "refuted": _Pen(0.9, (1.2, 1.8), COLOURS["j"]),
    "whole": _Pen(1.1, (6.0, 2.0), COLOURS["T"]),
}


class _Kind(NamedTuple):
    """A curve that is drawn: of which number, thing and verdict, with which pen and words, on which scale.

    What is many times too large has a scale of its own, at the right.
    """

    number: str
    thing: Thing
    verdict: Verdict
    pen: str
    words: str
    is_apart: bool = False


@drawing_settings()
def drive_figure(drive: CrankRockerDrive, name: str = "", angle: float = 60.0, size: str = "A4") -> Figure:
    """Draw a crank-rocker with the source's letters beside its torque and flywheel moment over a turn.

    Parameters
    ----------
    drive : CrankRockerDrive
    name : str
        Of its file.
    angle : float
        Crank angle from the line of the fixed pivots, at which it is drawn. [deg]
    size : "A4" or "A3"

    Returns
    -------
    Figure
    """
    page = Page(*paper(size))
    top = page.height - MARGIN
    page.text(MARGIN, top - 4.5, name or _("Drive"), fontsize=TITLE, fontweight="bold")
    heading = _("Crank-rocker with its instant centre, and torque and flywheel moment at the motor [{source}]")
    page.text(MARGIN, top - 10.0, heading.format(source=_SOURCE))
    page.text(MARGIN, top - 14.5, REFERENCES[_SOURCE].text, color=MUTED)
    page.rule(top - 17.5)
    wide = _WIDE * (page.width - 2 * MARGIN)
    room = Box(MARGIN, MARGIN + _TABLE, wide, top - 24.0 - MARGIN - _TABLE)
    page.heading(MARGIN, top - 23.0, _("At α = {angle}°", angle=f"{angle:g}".replace("-", "−")))
    scale = _draw_mechanism(page, drive, np.deg2rad(angle), room)
    page.scale_bar(MARGIN, MARGIN, scale)
    _write_numbers(page, drive, np.deg2rad(angle), (MARGIN, MARGIN + _TABLE - 1.0, wide))
    left = MARGIN + wide + 18.0
    _draw_curves(page, drive, Box(left, MARGIN, page.width - MARGIN - left, top - 19.0 - MARGIN))
    return page.figure


def _draw_mechanism(page: Page, drive: CrankRockerDrive, angle: float, room: Box) -> float:
    """Draw fig. 1 to a round scale, which is given: millimetres of metal in one of paper."""
    points = _points(drive, angle)
    outline = np.stack(list(points.values()), axis=1)
    wide, high = (float(np.ptp(part)) for part in outline)
    scale = fitting_scale(1e3 * wide, 1e3 * high, (room.width - 24.0, room.height - 20.0))
    centre(page, _sketch(points, angle, scale), room)
    return scale


def _points(drive: CrankRockerDrive, angle: float) -> dict[str, Array]:
    """Pins by the source's letters, C if it is near enough, X toward O₁. [m]"""
    geometry = drive.geometry
    motion = crank_rocker(np.array([angle]), geometry)
    b, a = (np.array([point.x.value[0], point.y.value[0]]) for point in (motion.pin, motion.joint))
    points = {"O": np.zeros(2), "B": b, "A": a, "O_1": np.array([float(geometry.ground_length), 0.0])}
    at = directions(np.array(angle), geometry)
    _ac, bc = centre_distances(geometry.rod_length, at)
    c = b + float(bc) * np.array([np.cos(angle), np.sin(angle)])
    if np.all(np.isfinite(c)) and np.hypot(*c) < _FAR * float(geometry.ground_length):
        points["C"] = c
    return points


def _sketch(points: Mapping[str, Array], angle: float, scale: float) -> Sketch:
    """Links, the lines to C, angles and letters; in mm of metal."""
    sketch = Sketch(scale)
    at = {letter: 1e3 * point for letter, point in points.items()}
    for start, end in (("O", "B"), ("B", "A"), ("O_1", "A")):
        sketch.add([Line(np.stack([at[start], at[end]], axis=1), "LINKS", "load", 5)])
    if "C" in at:
        for link in (("O", "B"), ("O_1", "A")):
            start = largest_of((at[end] for end in link), lambda pin: float(np.hypot(*(pin - at["C"]))))
            sketch.add([Line(np.stack([start, at["C"]], axis=1), "DIMENSIONS", "construction", 2)])
        sketch.add([Circle(at["C"], 0.9 * scale, "DIMENSIONS", "outline", 6, "ink")])
    sketch.add([Line(np.stack([at["O"], at["O_1"]], axis=1), "GUIDES", "axis", 1)])
    for letter in ("O", "O_1"):
        sketch.add(shapes.pivot(at[letter], 3.0 * scale, scale))
    for letter in ("B", "A"):
        sketch.add([Circle(at[letter], 0.8 * scale, "LINKS", "outline", 7, "paper")])
    marks = [("O", angle, "α"), ("B", _way(at, "B", "A"), "β"), ("O_1", _way(at, "O_1", "A"), "α_1")]
    for letter, to, word in marks:
        sketch.add(_angle_mark(at[letter], to % (2 * np.pi), word, scale))
    middle = np.mean(np.stack(list(at.values()), axis=1), axis=1)
    wishes = [Wish(place, letter, float(np.arctan2(*(place - middle)[::-1]))) for letter, place in at.items()]
    sketch.add(placed_labels(wishes, [line.points for line in sketch.lines], scale))
    return sketch


def _way(at: Mapping[str, Array], start: str, end: str) -> float:
    """Direction from one point to another. [rad]"""
    return float(np.arctan2(*(at[end] - at[start])[::-1]))


def _angle_mark(point: Array, to: float, word: str, scale: float) -> Iterator[Line | Label]:
    """An arc from X on to a direction, the letter beside it."""
    out = np.stack([point, point + np.array([1.35 * _ARC * scale, 0.0])], axis=1)
    yield Line(out, "DIMENSIONS", "thin", 3)
    bent = point[:, np.newaxis] + shapes.arc(np.zeros(2), _ARC * scale, 0.0, to)
    yield Line(bent, "DIMENSIONS", "thin", 3)
    yield Label(point + (_ARC + 3.2) * scale * unit(to / 2), word, "symbol")


def _write_numbers(page: Page, drive: CrankRockerDrive, angle: float, place: tuple[float, float, float]) -> None:
    """The sine rule with its numbers, and forces at the angle."""
    at = directions(np.array(angle), drive.geometry)
    ac, bc = centre_distances(drive.geometry.rod_length, at)
    rows = [(_("by the sine rule"), ""), *_angles(at), *_forces(drive, at)]
    rows.append(("AC = AB |sin(α − β) / sin(α₁ − α)|", _signed(abs(1e3 * float(ac)), "mm")))
    rows.append(("BC = AB |sin(α₁ − β) / sin(α₁ − α)|", _signed(abs(1e3 * float(bc)), "mm")))
    rows.append(("AC/BC = sin(α − β) / sin(α₁ − β),  (10)", f"{float(ac / bc):.6f}".replace("-", "−")))
    low = write_table(page, rows, place, _COLUMNS, LEAST_ROW)
    notes = (
        _("In the triangle ABC the angle at A is 180° − (α₁ − β), at B it is"),
        _("α − β: (10) is the sine rule, (11). C is the rod's instant centre."),
    )
    page.notes(place[0], low - 0.5, notes)


def _signed(size: float, unit: str) -> str:
    """A number with a true minus and its unit."""
    return f"{figure(size)} {unit}".replace("-", "−")


def _angles(at: Directions) -> Iterator[tuple[str, str]]:
    """Directions of rod and rocker."""
    for word, value in (("β", at.rod), ("α₁", at.rocker)):
        yield word, f"{np.degrees(float(value)) % 360.0:.3f}°"


def _forces(drive: CrankRockerDrive, at: Directions) -> Iterator[tuple[str, str]]:
    """Q, Q′ and T."""
    yield "Q", _signed(float(drive.load), "N")
    yield "Q′ = Q / sin(α₁ − β),  (2)", _signed(float(rod_force(drive.load, at)), "N")
    yield "T = Q AC/BC,  (9)", _signed(float(crank_pin_force(drive.load, at)), "N")


def _draw_curves(page: Page, drive: CrankRockerDrive, box: Box) -> None:
    """Fig. 2: static torque, flywheel moment and idle torque, one above the other."""
    panels = [
        (
            _("Static torque at the motor (14), N·m"),
            (
                _Kind("(14)", "active", "right", "active", _("active load")),
                _Kind("(14)", "friction", "right", "dry", _("dry friction")),
                _Kind("(14)", "active", "source", "source", _("as printed")),
                _Kind("(14)", "active", "refuted", "refuted", _("refuted")),
            ),
        ),
        (
            _("Flywheel moment at the motor (20), kg·m²"),
            (
                _Kind("(20)", "GD²", "right", "active", _("without the rod")),
                *([_Kind("(20)", "GD² of all", "right", "whole", _("rod and crank, too"))] if drive.has_masses else []),
                _Kind("(20)", "GD²", "source", "source", _("as printed"), is_apart=True),
                _Kind("(20)", "GD²", "refuted", "refuted", _("refuted")),
            ),
        ),
        (
            _("Idle torque at the motor (21), N·m"),
            (
                _Kind("(21)", "idle", "right", "active", _("active Q")),
                _Kind("(21)", "idle friction", "right", "dry", _("dry friction")),
                _Kind("(21)", "idle", "source", "source", _("as printed")),
                _Kind("(21)", "idle", "refuted", "refuted", _("refuted")),
            ),
        ),
    ]
    foot, head, gap = 9.0, 9.0, 3.0
    each = (box.height - foot - (head + gap) * len(panels)) / len(panels)
    low = box.bottom + box.height
    for title, kinds in panels:
        low -= each + head + gap
        axes = axes_in(page, Box(box.left, low, box.width - _SECOND, each))
        _draw_panel(axes, drive, kinds)
        axes.tick_params(labelbottom=low < box.bottom + foot + 1.0)
        page.heading(box.left, low + each + 5.4, title)
        _write_legend(page, kinds, box.left, low + each + 1.4)
    page.text(
        box.left + (box.width - _SECOND) / 2, low - foot, _("Crank angle α from the line of the pivots, °"), ha="center"
    )


def _draw_panel(axes: Axes, drive: CrankRockerDrive, kinds: Sequence[_Kind]) -> None:
    """Curves of a panel with their peaks and the dead positions."""
    dead = dead_positions(drive.geometry)
    degrees = np.unique([*np.arange(361.0), *np.degrees([dead.extended, dead.folded])])
    known = drive_curves(drive)
    level = float(drive.gear_moment) if kinds[0].number == "(20)" else 0.0
    axes.axhline(level, color=MUTED, linewidth=0.6, zorder=1)
    for one in kinds:
        wanted = (one.number, one.thing, one.verdict)
        curve = next(curve for curve in known if (curve.number, curve.thing, curve.verdict) == wanted)
        pen = _PENS[one.pen]
        line = {"color": pen.colour, "linewidth": pen.width, "linestyle": (0, pen.dashes) if pen.dashes else "-"}
        own = _second_scale(axes, _("as printed, kg·m²")) if one.is_apart else axes
        own.plot(degrees, values_at(drive, curve, np.deg2rad(degrees)), **line)
        if one.pen == "active":
            for peak in curve_facts(drive, curve)[:2]:
                axes.plot([np.degrees(peak.angle)], [peak.value], "o", ms=3.4, mfc="white", mec=pen.colour, zorder=6)
    for angle in (dead.extended, dead.folded):
        axes.axvline(np.degrees(angle), color=MUTED, linewidth=0.6, linestyle=(0, (2.0, 2.0)), zorder=1)
    axes.set(xlim=(0.0, 360.0), xticks=np.arange(0.0, 361.0, 30.0))


def _second_scale(axes: Axes, title: str) -> Axes:
    """A scale at the right with its title."""
    from matplotlib.ticker import MaxNLocator

    second = axes.twinx()
    second.yaxis.set_major_locator(MaxNLocator(4))
    second.spines["top"].set_visible(False)
    second.grid(visible=False)
    second.set_ylabel(title)
    return second


def _write_legend(page: Page, kinds: Sequence[_Kind], x: float, y: float) -> None:
    """Samples of the lines with their words, in a row."""
    for one in kinds:
        pen = _PENS[one.pen]
        style = (0, pen.dashes) if pen.dashes else "-"
        page.sample(x, x + 9.0, y + 0.8, color=pen.colour, linewidth=pen.width, linestyle=style)
        _start, end = page.ends(page.text(x + 10.5, y, one.words))
        x = end + 6.0
