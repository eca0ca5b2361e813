"""A throw's mechanisms at one crank angle as a sketch: to scale between pins, schematic in outline."""

from collections.abc import Iterator, Sequence
from itertools import pairwise

import numpy as np

from cranktrain.mechanisms.drawing import DrawnLink
from cranktrain.motion import Array
from cranktrain.panels.throw_member import DrawnMechanism
from cranktrain.panels.throw_scene import BIG_EYE, FEW_MEMBERS, SMALL_EYE, Scene
from cranktrain.plans.stroke_lines import Along, guide_line
from cranktrain.viz.paper import shapes
from cranktrain.viz.paper.sketch import Circle, Fill, Line, Sketch
from cranktrain.viz.throw.angle_marks import degree_ring, rotations
from cranktrain.viz.throw.annotations import (
    bank_angle,
    followed_points,
    load_names,
    moving_lines,
    piston_names,
    point_names,
    stroke_ends,
    throw_loads,
)
from cranktrain.viz.throw.cylinders import common_cylinder, crosshead_parts, cylinder, skirt

_COARSE = 5
"""Of a point's curve so manyth a point says where there is no room for a figure of the ring. [deg]"""

_CRANK_PIN, _SMALL_PIN, _JOURNAL = 0.24, 0.12, 0.32
"""Radii in parts of the crank radius."""


def mechanism_sketch(
    scene: Scene,
    angle: float,
    scale: float,
    dead: Sequence[Sequence[float]] = (),
    *,
    is_plain: bool = False,
    has_ring: bool = True,
) -> Sketch:
    """Draw a throw.

    Parameters
    ----------
    scene : Scene
    angle : float
        Crank angle as the machine shows it. [deg]
    scale : float
        Millimetres of metal in one of paper.
    dead : sequence of sequences of float
        Shown crank angles of the dead positions of each member, drawn thin. [deg]
    is_plain : bool
        Leave out ring, labels and hatches, as a moving picture wants.
    has_ring : bool
        Draw the degree ring and the arrow of rotation; where they are too small a detail has them.

    Returns
    -------
    Sketch
    """
    sketch = Sketch(scale)
    for member in scene.members[: FEW_MEMBERS if scene.is_star else None]:
        sketch.add(_path(scene, member))
    cylinders = [cylinder(scene, member, scale) for member in scene.singles]
    cylinders += [common_cylinder(scene, pair, scale) for pair in scene.pairs]
    sketch.add(line for lines in cylinders for line in lines if not (is_plain and line.habit == "hatch"))
    for member, angles in zip(scene.members, dead, strict=False):
        sketch.add(_dead_positions(scene, member, angles))
    for member in scene.cranks:
        sketch.add(_crank(scene, member, angle))
    for member in scene.members:
        sketch.add(followed_points(scene, member, angle, scale))
        sketch.add(_links(scene, member, angle, scale))
    marks = throw_loads(scene, angle)
    if is_plain:
        sketch.add(moving_lines(scene, marks))
    else:
        sketch.add(line for mark in marks for line in (*mark.held, *mark.lines))
        if has_ring:
            sketch.add(degree_ring(scene, _lines_of_links(scene, angle, dead), angle, scale))
            sketch.add(rotations(scene, scale))
        for member, angles in zip(scene.members, dead, strict=False):
            sketch.add(stroke_ends(scene, member, angles, scale))
        sketch.add(piston_names(scene, angle, sketch))
        sketch.add(point_names(scene, angle, sketch))
        sketch.add(bank_angle(scene, scale))
        sketch.add(load_names(marks, sketch))
    return sketch


def _path(scene: Scene, member: DrawnMechanism) -> Iterator[Line]:
    """Paths of pins over a turn."""
    for name in member.turn.paths:
        if name in member.turn.points:
            yield Line(member.turn_pins[name], "PATHS", "curve", 2)
        elif name != member.crank_pin or member in scene.cranks:
            yield Line(member.turn_pins[name], "PATHS", "dotted", 1)


def _dead_positions(scene: Scene, member: DrawnMechanism, angles: Sequence[float]) -> Iterator[Line | Circle]:
    """Links at the dead positions, thin; where mechanisms are many, only how far the crowns reach."""
    for angle in angles:
        pins = scene.pins(member, angle)
        if scene.is_of_few:
            chains = _chains(member, pins)
            yield from (Line(chain, "LINKS", "thin", 3) for chain in chains)
            for point in np.concatenate(chains, axis=1).T:
                yield Circle(point, 0.05 * scene.crank_radius, "LINKS", "thin", 3, "paper")
        if member.output is not None:
            crown = scene.reach(member, angle) + member.toward_chamber * scene.above(member)
            half = 0.5 * member.width
            yield Line(member.stroke_line.path((crown, -half), (crown, half)), "LINKS", "thin", 3)


def _chains(member: DrawnMechanism, pins: dict[str, Array]) -> list[Array]:
    """Lines from pin to pin: one through all of them, or of a mechanism drawn link by link one for each link."""
    through = ("O", "A", "C", "D") if member.place.kind.is_slave else member.metal
    names = [_metal(member, link) for link in member.turn.links] if member.is_plain else [through]
    return [np.stack([pins[name] for name in line], axis=1) for line in names]


def _metal(member: DrawnMechanism, link: DrawnLink) -> tuple[str, ...]:
    """Pins of a link without the points that are only followed."""
    return tuple(name for name in link.pins if name not in member.turn.points)


def _crank(scene: Scene, member: DrawnMechanism, angle: float) -> Iterator[Line | Circle]:
    """Crank web of a throw with journal; the pin is drawn with the rods."""
    radius = scene.crank_radius
    pins = scene.pins(member, angle)
    pin = pins[member.crank_pin]
    yield shapes.hull(pins["O"], _JOURNAL * 1.25 * radius, pin, BIG_EYE * 1.12 * radius, "light", 3)
    yield Circle(pins["O"], _JOURNAL * 0.8 * radius, "LINKS", "rod", 3, "paper")
    yield Circle(pins["O"], 0.035 * radius, "LINKS", "arrow", 8, "ink")


def _links(scene: Scene, member: DrawnMechanism, angle: float, scale: float) -> Iterator[Line | Circle]:
    """Piston, rod and rocker of one member."""
    pins = scene.pins(member, angle)
    if member.output is not None:
        yield from _slider(scene, member, angle)
    if member in scene.slaves:
        yield from _slave_rod(scene, pins)
        return
    if member.is_plain:
        yield from _plain_links(scene, member, pins, scale)
        return
    radius = scene.crank_radius
    fill = "dark" if member.is_first else "paper"
    order = 5 if member.is_first else 6
    if scene.is_star:
        reach = float(np.hypot(*(scene.pins(scene.slaves[0], angle)["C"] - pins["A"]))) + 1.25 * SMALL_EYE * radius
        yield Circle(pins["A"], reach, "LINKS", "rod", order, fill)
    rod = shapes.bar(pins["A"], pins["B"], (0.44 * radius, 0.26 * radius), fill, order)
    yield rod._replace(habit="part", order=3, fill="none") if member.place.is_far else rod
    yield from shapes.eye(pins["A"], BIG_EYE * radius, _CRANK_PIN * radius, fill, order)
    yield Circle(pins["A"], 0.035 * radius, "LINKS", "arrow", 8, "ink")
    yield from shapes.eye(pins["B"], SMALL_EYE * radius, _SMALL_PIN * radius, fill, order)
    if member.output is None:
        yield from shapes.pivot(pins["C"], 0.45 * radius, scale)
        yield shapes.bar(pins["C"], pins["B"], (0.40 * radius, 0.30 * radius), "light", 4)
        yield from shapes.eye(pins["C"], 0.30 * radius, 0.16 * radius, "light", 4)


def _plain_links(scene: Scene, member: DrawnMechanism, pins: dict[str, Array], scale: float) -> Iterator[Line | Circle]:
    """Every link but the crank as a bar through its pins, pins as eyes, fixed ones on their bearings."""
    radius, shared = scene.crank_radius, scene.shared_pins[member.place.name]
    for link in member.turn.links[1:]:
        for start, end in pairwise(_metal(member, link)):
            if start in shared and end in shared:
                continue  # such as the connecting rod whose crosshead moves a valve gear
            yield shapes.bar(pins[start], pins[end], (0.24 * radius, 0.22 * radius), "paper", 5)
    if member.cut and member.output is not None:
        yield from _break(pins[member.crank_pin], pins[member.output], radius, scale)
    yield from _other_sliders(scene, member, pins, scale)
    fixed = [name for name in member.turn.fixed if name != "O"]
    moving = [name for link in member.turn.links for name in _metal(member, link)[1:]]
    output = [] if member.output is None else [member.output]
    for name in dict.fromkeys(name for name in fixed + moving + output if name not in shared):
        yield from shapes.eye(pins[name], SMALL_EYE * radius, _SMALL_PIN * radius, "paper", 7)
    for name in fixed:
        yield from shapes.pivot(pins[name], 0.45 * radius, scale)


def _break(start: Array, end: Array, radius: float, scale: float) -> Iterator[Line]:
    """Gap in a rod that is drawn too short, between two wavy lines."""
    middle = 0.5 * (start + end)
    along = (end - start) / np.hypot(*(end - start))
    line = Along(middle - np.dot(middle, along) * along, along)
    place, half = float(line.place(middle)), 0.17 * radius + 0.6 * scale
    across = np.linspace(-half, half, 17)
    edges = [
        np.stack([line.at(place + side * scale + 0.35 * scale * np.sin(2 * np.pi * u / (2 * half)), u) for u in across])
        for side in (-1.0, 1.0)
    ]
    yield Line(np.concatenate([edges[0], edges[1][::-1]]).T, "LINKS", "none", 5, is_closed=True, fill="paper")
    for edge in edges:
        yield Line(edge.T, "LINKS", "thin", 5)


def _other_sliders(
    scene: Scene, member: DrawnMechanism, pins: dict[str, Array], scale: float
) -> Iterator[Line | Circle]:
    """Sliders beside the output: blocks between short guides, joined to the pin that drives them in a slot."""
    size = max(0.4 * scene.crank_radius, 1.5 * scale)
    for guide in member.turn.guides[1:]:
        if guide.pin in scene.shared_pins[member.place.name]:
            continue
        pin = pins[guide.pin]
        line = guide_line(guide.direction, pin)
        travel = line.along @ member.turn_pins[guide.pin]
        low, high = float(np.nanmin(travel)) - 1.4 * size, float(np.nanmax(travel)) + 1.4 * size
        for side in (-1.0, 1.0):
            yield Line(line.path((low, side * 0.55 * size), (high, side * 0.55 * size)), "GUIDES", "thin", 7)
        for block in member.turn.blocks:
            if block.link == (guide.pin,):
                yield Line(np.stack([pin, pins[block.pin]], axis=1), "LINKS", "outline", 7)
        middle = float(line.along @ pin)
        block = line.block((middle - size, middle + size), 0.55 * size)
        yield Line(block, "LINKS", "rod", 7, is_closed=True, fill="light")


def _slider(scene: Scene, member: DrawnMechanism, angle: float) -> Iterator[Line]:
    """Piston, behind a crosshead where it works at its crank end; where no bore is known, a crosshead alone."""
    fill: Fill = "light" if member.is_first else "paper"
    if member.crosshead is not None:
        pin = scene.reach(member, angle)
        yield from crosshead_parts(member.stroke_line, pin, member.width, member.crosshead, fill)
        return
    above, below = (member.toward_chamber * part for part in (scene.above(member), skirt(scene, member)))
    parts = tuple(shapes.piston(member.stroke_line, scene.reach(member, angle), member.width, above, below, fill))
    yield from parts if member.bore is not None else parts[:1]


def _slave_rod(scene: Scene, pins: dict[str, Array]) -> Iterator[Line | Circle]:
    """Slave rod with its knuckle pin, and the ear of the master rod that holds it."""
    radius = scene.crank_radius
    arm = float(np.hypot(*(pins["C"] - pins["A"])))
    if not scene.is_star and arm > 0.2 * radius:
        yield shapes.hull(pins["A"], BIG_EYE * radius, pins["C"], 1.2 * SMALL_EYE * radius, "dark", 5)
        yield Circle(pins["A"], _CRANK_PIN * radius, "LINKS", "rod", 5, "paper")
    yield shapes.bar(pins["C"], pins["D"], (0.24 * radius, 0.22 * radius), "paper", 6)
    for name in "CD":
        yield from shapes.eye(pins[name], SMALL_EYE * 0.9 * radius, _SMALL_PIN * 0.8 * radius, "paper", 7)


def _lines_of_links(scene: Scene, angle: float, dead: Sequence[Sequence[float]]) -> list[tuple[Array, float]]:
    """Lines from pin to pin with half the width of what is drawn there [mm]: links, and if few are drawn dead ones."""
    drawn = [(member, angle, 0.3 * scene.crank_radius) for member in scene.members]
    if scene.is_of_few:
        drawn += [(member, one, 0.0) for member, angles in zip(scene.members, dead, strict=False) for one in angles]
    lines = [(line, half) for member, at, half in drawn for line in _chains(member, scene.pins(member, at))]
    curves = [member.turn_pins[name][:, ::_COARSE] for member in scene.members for name in member.turn.points]
    return lines + [(curve[:, np.isfinite(curve[0])], 0.0) for curve in curves]
