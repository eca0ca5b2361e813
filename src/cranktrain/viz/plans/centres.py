"""Sheet of instant centres: the mechanism, the lines on which they lie, and where they are."""

from collections.abc import Iterator, Sequence

import numpy as np

from cranktrain.language import said as _
from cranktrain.machine import Machine
from cranktrain.motion import Array
from cranktrain.numerics.ties import largest_of
from cranktrain.panels.figures import figure
from cranktrain.panels.formulas import formula, mathematics
from cranktrain.plans.centres import Centre, InstantCentres, TurningBody, instant_centres
from cranktrain.plans.positions import PositionPlan, fitting
from cranktrain.plans.vectors import angle_of, spoken_name
from cranktrain.saying.names import said_name
from cranktrain.saying.scales import scale_for
from cranktrain.texts.crank_rocker import pin_velocity_ratio
from cranktrain.viz.paper.page import Figure, drawing_settings
from cranktrain.viz.paper.sketch import Circle, Line, Sketch, Wish, placed_labels
from cranktrain.viz.paper.tables import write_table
from cranktrain.viz.plans.sheet import (
    cells_of,
    centre_at_angle,
    few_angles,
    length_scale,
    plan_page,
    refuse_more,
    write_scales,
)
from cranktrain.viz.plans.sketches import line_drawing, pin_wishes

_FEW = 5
"""Of so many bodies all centres are given; of more only those of the frame and of the crank with each."""

_MOST = 6
"""Of so many bodies the tables of two crank angles have room on a sheet."""

_REACH, _REACH_OF_MANY = 1.6, 0.9
"""A centre farther from the mechanism than this part of its size is said and not drawn; and where bodies are many."""

_WIDE = 0.56
"""Part of a sheet's width in which the mechanism is drawn; tables have the rest."""

_COLUMNS = (0.40, 0.70, 1.0)
"""Where the columns of the table of centres end, in parts of its width."""


@drawing_settings()
def plan_centres(
    machine: Machine, angles: int | Sequence[float] = (60.0,), *, mechanism: str | None = None, size: str = "A4"
) -> Figure:
    """Draw the instant centres of a mechanism's bodies, two by two.

    Parameters
    ----------
    machine : Machine
    angles : int or sequence of float
        How many, evenly over a turn, or which crank angles; two at most, of many bodies one. [deg]
    mechanism : str, optional
        Its name; the first slave of throw 1, or the first mechanism, unless given.
    size : "A4" or "A3"

    Returns
    -------
    Figure
    """
    chosen = few_angles(angles, _("instant centres"))
    found = [instant_centres(machine, float(angle), mechanism=mechanism, is_lettered=True) for angle in chosen]
    n_bodies = len(found[0].bodies)
    if n_bodies > _MOST:
        allowed = _("must be one for the instant centres of {n} bodies: their tables fill a sheet", n=n_bodies)
        refuse_more(1, len(found), allowed)
    page, box = plan_page(machine, angles, size, _("Instant centres"), found[0].mechanism)
    cells = cells_of(box, len(found))
    wide = _WIDE * cells[0].width
    room = (wide - 24.0, cells[0].height - 22.0)
    scale = fitting([_outline(one) for one in found], room)
    for one, cell in zip(found, cells, strict=True):
        centre_at_angle(page, one.angle, _sketch(one, scale), cell._replace(width=wide))
        start, width = cell.left + wide + 6.0, (1.0 - _WIDE) * cell.width - 6.0
        top = cell.bottom + cell.height
        ends = (
            write_table(page, list(_bodies_table(one)), (start, top, 0.43 * width)),
            write_table(page, list(_centres_table(one)), (start + 0.49 * width, top, 0.51 * width), _COLUMNS),
        )
        page.notes(start, min(ends) - 1.0, _notes(one))
    write_scales(page, box, [length_scale(scale)], 1e3 * scale)
    return page.figure


def _shown_centres(found: InstantCentres) -> list[Centre]:
    """Centres that are given: all of few bodies, of many those with the frame and with the crank."""
    return [centre for centre in found.centres if len(found.bodies) <= _FEW or centre.first <= 2]


def _is_near(found: InstantCentres, place: Array) -> bool:
    """Whether a centre lies so near to the mechanism that it can be drawn."""
    pins = np.concatenate(list(found.drawing.positions.values()), axis=1)
    low, high = np.min(pins, axis=1), np.max(pins, axis=1)
    reach = (_REACH if len(found.bodies) <= _FEW else _REACH_OF_MANY) * float(np.max(high - low))
    return bool(np.all((place > low - reach) & (place < high + reach)))


def _drawn(found: InstantCentres, *, is_near: bool = True) -> list[Centre]:
    """Centres to be drawn, near or too far: in no pin, which has its name, and of many bodies only the frame's."""
    own = [one for one in _shown_centres(found) if not one.is_joint and np.all(np.isfinite(one.place))]
    wanted = [one for one in own if len(found.bodies) <= _FEW or one.first == 1]
    return [one for one in wanted if _is_near(found, one.place) is is_near]


def _outline(found: InstantCentres) -> Array:
    """Pins and drawn centres, shape (2, n). [m]"""
    pins = np.concatenate(list(found.drawing.positions.values()), axis=1)
    return np.concatenate([pins, *(one.place[:, np.newaxis] for one in _drawn(found))], axis=1)


def _sketch(found: InstantCentres, scale: float) -> Sketch:
    """Mechanism, drawn centres, and the lines through two joints on which each of them lies; in mm of metal."""
    plan = PositionPlan(found.mechanism, np.array([found.angle]), scale, found.drawing.scaled(1.0 / scale))
    sketch, pins = line_drawing(plan)
    wishes = pin_wishes(plan.drawing, pins)
    middle = np.mean(np.concatenate(list(pins.values()), axis=1), axis=1)
    for one in _drawn(found):
        place = 1e3 * one.place
        for start in _lines_through(found, one):
            sketch.add([Line(np.stack([1e3 * start, place], axis=1), "DIMENSIONS", "construction", 2)])
        sketch.add([Circle(place, 0.9 * sketch.scale, "DIMENSIONS", "outline", 6, "ink")])
        wishes.append(Wish(place, one.name, angle_of(place - middle)))
    sketch.add(placed_labels(wishes, [line.points for line in sketch.lines], sketch.scale))
    return sketch


def _lines_through(found: InstantCentres, wanted: Centre) -> Iterator[Array]:
    """Where the lines begin that meet in a centre: each goes on through the joints of both bodies with a third. [m]"""
    for third in sorted({*range(1, len(found.bodies) + 1)} - {wanted.first, wanted.second}):
        joints = [found.centre(number, third) for number in (wanted.first, wanted.second)]
        places = [one.place for one in joints if np.all(np.isfinite(one.place))]
        if all(one.is_joint for one in joints) and places:
            yield largest_of(places, lambda place: float(np.hypot(*(place - wanted.place))))


def _body_words(body: TurningBody) -> str:
    """Name a body."""
    words = {
        "frame": _("frame"),
        "link": said_name(body.name),
        "slider": _("slider {name}", name=body.name),
        "block": _("block {name}", name=body.name),
    }
    return words[body.sort]


def _bodies_table(found: InstantCentres) -> Iterator[tuple[str, ...]]:
    """Bodies by number, and how fast they turn by the crank."""
    yield (_("body"), "ω/ω₂")
    for number, body in enumerate(found.bodies, start=1):
        yield (f"{number} {_body_words(body)}", figure(body.turning))


def _centres_table(found: InstantCentres) -> Iterator[tuple[str, ...]]:
    """Where the centres are; infinitely far ones by their direction."""
    shown = scale_for("m", 0.0)
    yield (_("centre"), _("in"), f"X, {shown.label}", f"Y, {shown.label}")
    positions = found.drawing.positions
    for one in _shown_centres(found):
        pins = [name for name, pin in positions.items() if one.is_joint and np.all(pin[:, 0] == one.place)]
        joint = mathematics(spoken_name(pins[0])) if pins else ""
        where = tuple(map(figure, shown.of(one.place).tolist())) if np.all(np.isfinite(one.place)) else ("–", "–")
        if np.isfinite(one.direction):
            where = ("∞", f"∠ {np.degrees(one.direction) % 180.0:.2f}°")
        yield (mathematics(one.name), joint, *where)


def _notes(found: InstantCentres) -> Iterator[str]:
    """What the numbers do not say by themselves."""
    if any(np.isfinite(one.direction) for one in _shown_centres(found)):
        yield _("∞ ∠: infinitely far, in that direction from X or the other way")
    for number, body in enumerate(found.bodies[1:], start=2):
        absolute = found.centre(1, number)
        if not absolute.is_joint and not np.all(np.isfinite(absolute.place)) and body.sort == "link":
            yield _("The lines through the pins of {body} are parallel: it only", body=_body_words(body))
            yield _("moves along, and all its points are equally fast.")
    if len(found.bodies) > _FEW:
        yield _("Drawn are the centres with the frame.")
    names = ", ".join(mathematics(one.name) for one in _drawn(found, is_near=False))
    if names:
        yield _("too far away to be drawn: {centres}", centres=names)
    yield from _by_directions(found)


def _by_directions(found: InstantCentres) -> Iterator[str]:
    """The source's ratio of a crank-rocker's pins, by the directions of its links."""
    pins = {name: pin[:, 0] for name, pin in found.drawing.positions.items()}
    links = [(link.name, link.pins) for link in found.drawing.links]
    if links != [("crank", ("O", "A")), ("rod", ("A", "B")), ("rocker", ("C", "B"))]:
        return
    crank, rod, rocker = (np.arctan2(*(pins[end] - pins[start])[::-1]) for _name, (start, end) in links)
    ratio = abs(float(pin_velocity_ratio(crank, rod, rocker)))
    lines = formula("P_{13}B : P_{13}A") + " = sin(α − β) : sin(α₁ − β)"
    yield _("{lines} = {ratio}, (7), (10) [gandzha]", lines=lines, ratio=figure(ratio))
