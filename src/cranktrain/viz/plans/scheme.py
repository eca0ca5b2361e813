"""Schemes with the letters of the sources' figures: a mechanism at one crank angle, its angles, lengths and forces."""

from collections.abc import Iterator, Sequence
from functools import cache, partial

import numpy as np

from cranktrain.language import said as _
from cranktrain.machine import Machine
from cranktrain.motion import Array
from cranktrain.panels.figures import figure, with_unit
from cranktrain.panels.formulas import mathematics
from cranktrain.plans.drive_scheme import drive_chain
from cranktrain.plans.pin_weights import pin_weights
from cranktrain.plans.positions import plan_angles
from cranktrain.plans.schemes import MarkedAngle, Scheme, scheme
from cranktrain.plans.stroke_lines import guide_line, unit
from cranktrain.plans.vectors import angle_of, spoken_name
from cranktrain.quantities import shown
from cranktrain.saying.scales import scale_for
from cranktrain.viz.paper import shapes
from cranktrain.viz.paper.page import LINE, Box, Figure, drawing_settings
from cranktrain.viz.paper.sketch import Circle, Line, Sketch, Wish, placed_labels
from cranktrain.viz.paper.tables import ROW
from cranktrain.viz.plans.drive_beside import DriveBeside, crank_pin
from cranktrain.viz.plans.drive_symbols import crank_mark
from cranktrain.viz.plans.sheet import (
    centre,
    fitted_scale,
    length_scale,
    plan_page,
    refuse_more,
    write_beside,
    write_scales,
)
from cranktrain.viz.plans.sketches import frame_lines, sides_of

_COLUMNS = (0.76, 1.0)
"""Where the columns of a table of letters end, in parts of its width."""

_LETTER_ROW = 4.2
"""How low a row with a letter and its index may be. [mm]"""

_ARC, _STEP, _FORCE = 9.0, 3.2, 17.0
"""Radius of the innermost angle at a point, from one to the next, and length of a force on paper. [mm]"""

_CYLINDER = 14.0
"""Width of a slider in its guide on paper. [mm]"""


@drawing_settings()
def plan_scheme(
    machine: Machine,
    angles: int | Sequence[float] = (50.0,),
    *,
    mechanism: str | None = None,
    size: str = "A4",
    letters: str | None = None,
) -> Figure:
    """Draw a mechanism with the letters of a source's figure, beside what each means and is.

    Parameters
    ----------
    machine : Machine
    angles : int or sequence of float
        One crank angle. [deg]
    mechanism : str, optional
        Its name; the first slave of throw 1, or the first mechanism, unless given.
    size : "A4" or "A3"
    letters : str, optional
        The source; that which has such a mechanism, unless given.

    Returns
    -------
    Figure
    """
    chosen = plan_angles(angles)
    refuse_more(1, len(chosen), _("must be one for a scheme"))
    found = scheme(machine, float(chosen[0]), mechanism=mechanism, letters=letters)
    title = _("Scheme with the letters of fig. {figure} of [{source}]", figure=found.figure, source=found.source)
    page, box = plan_page(machine, [found.angle], size, title, mechanism, has_key=False)
    wide = 0.60 * box.width
    beside = box.left + wide + 8.0
    right = Box(beside, box.bottom + 8.0, box.left + box.width - beside, box.height - 8.0)
    shaft = crank_pin(machine, mechanism)
    drive = _drive(machine, "" if shaft is None else found.letters[shaft], (wide - 6.0, right.width))
    foot = 8.0 if drive is None else 8.0 + drive.height
    left = Box(box.left, box.bottom + foot, wide, box.height - foot)
    marked = None if drive is None else shaft
    pins = np.concatenate([pin[:, :1] for pin in found.drawing.scaled(1e3).positions.values()], axis=1)
    room = left.width - 6.0, left.height - 10.0
    drawn = cache(partial(scheme_sketch, found, marked=marked))
    scale = fitted_scale(drawn, room, float(np.max(np.ptp(pins, axis=1))))
    centre(page, drawn(scale), left)
    write_scales(page, box, [length_scale(1e-3 * scale)], scale)
    page.heading(box.left, box.bottom + box.height - 4.0, f"φ = {found.angle:g}°")
    notes = [_("Angles count in the sense in which the crank turns.")]
    if found.forces:
        notes.append(_("Forces in parts of Q, by direction alone; lines of OB and O₁A meet in C."))
    rows = [*_rows(found), *_weights(machine, found)]
    line = ROW if drive is None else drive.row_height(len(rows), right.height - LINE * len(notes))
    below = write_beside(page, box, beside, rows, notes, shares=_COLUMNS, line=max(line, _LETTER_ROW))
    if drive is not None:
        drive.draw(page, Box(box.left, box.bottom + 8.0, wide, 0.0))
        drive.write(page, right, below, line)
    return page.figure


def _drive(machine: Machine, shaft_letter: str, widths: tuple[float, float]) -> DriveBeside | None:
    """What stands of a machine's drive beside its scheme."""
    chain, main = drive_chain(machine), machine.shaft.get("main")
    has_motion = main is not None and main.motion is not None
    return DriveBeside(chain, shaft_letter, widths, has_motion=has_motion) if chain else None


def _weights(machine: Machine, found: Scheme) -> Iterator[tuple[str, ...]]:
    """Weights of what turns with the rocker, as masses at the pins."""
    weights = pin_weights(machine, found)
    if weights is not None:
        words = (_("weight of what the rocker turns, at A"), _("the same at B, (17)"))
        for letter, said, weight in zip(("G_A", "G_B"), words, weights, strict=True):
            yield (mathematics(letter), said, with_unit(weight, scale_for("kg", weight)))


def _rows(found: Scheme) -> Iterator[tuple[str, ...]]:
    """Letters, what they stand for, and their values."""
    yield (_("letter"), _("what it is"), "")
    for one in found.angles:
        yield (mathematics(one.letter), _(one.words), f"{figure(shown(one.value, 'deg'))}°")
    for one in found.lengths:
        yield (mathematics(one.letter), _(one.words), with_unit(one.value, scale_for("m", 0.0)))
    for one in found.forces:
        yield (mathematics(one.letter), _(one.words), "" if one.letter == "Q" else f"{figure(one.value)} Q")


def scheme_sketch(found: Scheme, scale: float, marked: str | None = None) -> Sketch:
    """Links as lines, sliders in their guides, arcs of angles, forces; in mm of metal.

    Parameters
    ----------
    found : Scheme
    scale : float
        Millimetres of metal in one of paper.
    marked : str, optional
        Pin of the shaft that a drive turns, which has the mark of its end.
    """
    sketch = Sketch(scale)
    drawing = found.drawing.scaled(1e3)
    pins = drawing.positions
    sketch.add(frame_lines(drawing, pins, scale))
    for guide in drawing.guides:
        line = guide_line(guide.direction, pins[guide.pin][:, 0])
        at = float(line.along @ pins[guide.pin][:, 0])
        half = 0.5 * _CYLINDER * scale
        block = line.block((at - 0.6 * half, at + 0.6 * half), 2.0 * scale)
        sketch.add([Line(block, "LINKS", "outline", 4, is_closed=True, fill="light")])
    for link in drawing.links:
        shaft, pin = (pins[name][:, 0] for name in link.pins[:2])
        if link.name == "crank":
            path = shapes.arc(shaft, float(np.hypot(*(pin - shaft))), 0.0, 2 * np.pi)
            sketch.add([Line(path, "PATHS", "dotted", 1)])
        for ends in sides_of(link, drawing):
            line = np.stack([pins[name][:, 0] for name in ends], axis=1)
            sketch.add([Line(line, "LINKS", "outline", 5)])
    sketch.add(Circle(pin[:, 0], 0.8 * scale, "LINKS", "outline", 6, "paper") for pin in pins.values())
    marks = [] if marked is None else crank_mark(pins[marked][:, 0], scale)
    sketch.add(marks)
    sketch.add(Line(1e3 * line, "DIMENSIONS", "thin", 2) for line in found.thin)
    wishes = [*_arcs(found, sketch, scale), *_forces(found, sketch, pins, scale), *_names(found, pins)]
    lines = [line.points for line in sketch.lines]
    sketch.add(placed_labels(wishes, lines, scale, marks))
    return sketch


def _arcs(found: Scheme, sketch: Sketch, scale: float) -> list[Wish]:
    """Draw the arcs of angles, one outside the other where they are at one point; give their letters' wishes."""
    wishes: list[Wish] = []
    at: dict[tuple[float, ...], int] = {}
    for one in found.angles:
        place = tuple(np.round(one.vertex, 9))
        number = at.get(place, 0)
        at[place] = number + 1
        radius = (_ARC + _STEP * number) * scale
        vertex = 1e3 * one.vertex
        sketch.add([Line(shapes.arc(vertex, radius, one.start, one.end), "DIMENSIONS", "thin", 4)])
        sketch.add(_head(one, vertex, radius, scale))
        middle = 0.5 * (one.start + one.end)
        wishes.append(Wish(vertex + radius * unit(middle), one.letter, middle))
    return wishes


def _head(one: MarkedAngle, vertex: Array, radius: float, scale: float) -> Iterator[Line]:
    """Head of an arc's arrow, where there is room for it."""
    if abs(one.end - one.start) * radius > 3.0 * scale:
        sense = float(np.sign(one.end - one.start))
        lean = sense * (np.pi / 2 - 0.8 * scale / radius)
        yield shapes.arrowhead(vertex + radius * unit(one.end), one.end + lean, 1.8 * scale)


def _forces(found: Scheme, sketch: Sketch, pins: dict[str, Array], scale: float) -> list[Wish]:
    """Draw forces away from their pins; give their letters' wishes."""
    wishes: list[Wish] = []
    for one in found.forces:
        start = pins[one.pin][:, 0]
        end = start + _FORCE * scale * unit(one.direction)
        sketch.add([Line(np.stack([start, end], axis=1), "DIMENSIONS", "vector", 7)])
        sketch.add([shapes.arrowhead(end, one.direction, 2.6 * scale)])
        wishes.append(Wish(end, one.letter, one.direction))
    return wishes


def _names(found: Scheme, pins: dict[str, Array]) -> Iterator[Wish]:
    """Letters of pins, points and lengths."""
    middle = np.mean(np.concatenate(list(pins.values()), axis=1), axis=1)
    for name, letter in found.letters.items():
        point = pins[name][:, 0]
        yield Wish(point, letter, angle_of(point - middle))
    for name in found.drawing.points:
        yield Wish(pins[name][:, 0], spoken_name(name), angle_of(pins[name][:, 0] - middle))
    for letter, point in found.points.items():
        yield Wish(1e3 * point, letter, angle_of(1e3 * point - middle))
    for one in found.lengths:
        start, end = (pins[name][:, 0] for name in one.pins)
        yield Wish(0.5 * (start + end), one.letter, angle_of(end - start) + np.pi / 2)
