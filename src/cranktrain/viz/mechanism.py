"""A throw's mechanisms at one crank angle as a sketch: to scale between pins, schematic in outline."""

from collections.abc import Iterator, Sequence
from itertools import pairwise

import numpy as np

from cranktrain.motion import Array
from cranktrain.viz import shapes
from cranktrain.viz.labels import Wish, label_outline, placed_labels
from cranktrain.viz.scene import Member, Scene
from cranktrain.viz.sketch import Circle, Label, Line, Sketch

_FEW = 2
"""Up to so many mechanisms, the links are drawn in the dead positions too."""

_BIG_EYE, _CRANK_PIN, _SMALL_EYE, _SMALL_PIN, _JOURNAL = 0.40, 0.24, 0.22, 0.12, 0.32
"""Radii in parts of the crank radius."""

_BELOW, _BELOW_IN_STAR = 0.34, 0.14
"""Skirt below the piston pin, in parts of the bore; in a star there is no room for long skirts."""

_LEAST_RING = 11.0
"""Radius of a degree ring on paper that has room for all its figures. [mm]"""

_LEADER = 5.0
"""A name farther from what it names than this has a line to it. [mm of paper]"""

_GAP = 0.05
"""Clearance above the piston at its top, in parts of the bore."""


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
    for member in scene.members[: _FEW if scene.is_star else None]:
        sketch.add(_path(scene, member))
    for member in scene.singles:
        sketch.add(_cylinder(scene, member, scale, is_plain=is_plain))
    for pair in scene.pairs:
        sketch.add(_common_cylinder(scene, pair, scale, is_plain=is_plain))
    for member, angles in zip(scene.members, dead, strict=False):
        sketch.add(_dead_positions(scene, member, angles))
    for member in scene.cranks:
        sketch.add(_crank(scene, member, angle))
    for member in scene.members:
        sketch.add(_links(scene, member, angle, scale))
    if not is_plain:
        if has_ring:
            sketch.add(_ring(scene, _lines_of_links(scene, angle, dead), angle, scale))
            sketch.add(_rotation(scene, scale))
            for member in _other_shafts(scene):
                sketch.add(_rotation_of_other(scene, member, scale))
        sketch.add(_names(scene, angle, sketch))
        sketch.add(_bank_angle(scene, scale))
    return sketch


def _path(scene: Scene, member: Member) -> Iterator[Line]:
    """Paths of pins over a turn."""
    for name in member.turn.paths:
        if name != member.crank_pin or member in scene.cranks:
            yield Line(member.turn_pins[name], "PATHS", "dotted", 1)


def _start(scene: Scene, member: Member) -> float:
    """Where a cylinder begins, from the shaft. [mm]"""
    skirt = member.travel[0] - _below(scene, member)
    return min(max(skirt + 0.25 * member.width, scene.clearance * 1.02), member.travel[0] + 0.1 * member.width)


def _below(scene: Scene, member: Member) -> float:
    """How far the skirt reaches below the piston pin. [mm]"""
    return (_BELOW_IN_STAR if scene.is_star else _BELOW) * member.width


def _end(member: Member) -> float:
    """Where a cylinder ends, from the shaft. [mm]"""
    if member.place.is_far:
        return member.travel[1] + _BELOW * member.width
    return member.travel[1] + member.above + _GAP * member.width


def _cylinder(scene: Scene, member: Member, scale: float, *, is_plain: bool) -> Iterator[Line]:
    """Centre line and walls; a crosshead runs between guides that are open at the end."""
    line = member.stroke_line
    end = _end(member)
    axis = np.stack([line.at(0.0, 0.0), line.at(end + 2.0 * scale, 0.0)], axis=1)
    yield Line(axis, "GUIDES", "axis", 2)
    walls = shapes.walls(line, member.width, (_start(scene, member), end), has_head=member.bore is not None)
    for wall, outside in walls:
        yield wall
        if not is_plain:
            yield shapes.hatch(wall.points[:, 0], wall.points[:, 1], outside, scale)


def _common_cylinder(scene: Scene, pair: tuple[Member, Member], scale: float, *, is_plain: bool) -> Iterator[Line]:
    """Centre line, and walls from where one piston's begin to where the other's do, with gaps for the ports."""
    one, other = pair
    line = one.stroke_line
    far = float(line.place(other.centre))

    def along(member: Member, place: float) -> float:
        """Where a place that counts from a member's own shaft is on the line."""
        return place if member.place.shaft == one.place.shaft else far - place

    last = other.travel[1] + _below(scene, other) if other.place.is_far else _start(scene, other)
    span = (_start(scene, one), along(other, last - 0.25 * other.width if other.place.is_far else last))
    yield Line(np.stack([line.at(0.0, 0.0), line.at(max(far, span[1]), 0.0)], axis=1), "GUIDES", "axis", 2)
    gaps: list[tuple[float, float]] = []
    for member in pair:
        height = scene.ports[one.place.cylinder].get(member.place.name.rpartition(".")[2])
        if height is not None:
            outermost = member.travel[1] if member.place.is_far else member.travel[0]
            crown = outermost + member.toward_chamber * member.above
            first, second = sorted(along(member, crown + part) for part in (0.0, member.toward_chamber * height))
            gaps.append((first, second))
    for wall, outside in shapes.walls(line, one.width, span, has_head=False, ports=sorted(gaps)):
        yield wall
        if not is_plain:
            yield shapes.hatch(wall.points[:, 0], wall.points[:, 1], outside, scale)


def _dead_positions(scene: Scene, member: Member, angles: Sequence[float]) -> Iterator[Line | Circle]:
    """Links at the dead positions, thin; where mechanisms are many, only how far the crowns reach."""
    for angle in angles:
        pins = scene.pins(member, angle)
        if len(scene.members) <= _FEW:
            for chain in _chains(member, pins):
                yield Line(chain, "LINKS", "thin", 3)
            for point in np.concatenate([chain.T for chain in _chains(member, pins)]):
                yield Circle(point, 0.05 * scene.crank_radius, "LINKS", "thin", 3, "paper")
        if member.output is not None:
            line = member.stroke_line
            crown = line.place(pins[member.output]) + member.toward_chamber * member.above
            ends = [line.at(float(crown), side * 0.5 * member.width) for side in (-1.0, 1.0)]
            yield Line(np.stack(ends, axis=1), "LINKS", "thin", 3)


def _chains(member: Member, pins: dict[str, Array]) -> list[Array]:
    """Lines from pin to pin: one through all of them, or of a mechanism drawn link by link one for each link."""
    names = [link.pins for link in member.turn.links] if member.is_plain else [_chain(member)]
    return [np.stack([pins[name] for name in line], axis=1) for line in names]


def _chain(member: Member) -> tuple[str, ...]:
    """Pins from the shaft to the output, for a line drawing."""
    return ("O", "A", "C", "D") if member.place.kind.name == "articulated_rod" else tuple(member.turn.pins)


def _crank(scene: Scene, member: Member, angle: float) -> Iterator[Line | Circle]:
    """Crank web of a throw with journal; the pin is drawn with the rods."""
    radius = scene.crank_radius
    pins = scene.pins(member, angle)
    pin = pins[member.crank_pin]
    yield shapes.hull(pins["O"], _JOURNAL * 1.25 * radius, pin, _BIG_EYE * 1.12 * radius, "light", 3)
    yield Circle(pins["O"], _JOURNAL * 0.8 * radius, "LINKS", "rod", 3, "paper")
    yield Circle(pins["O"], 0.035 * radius, "LINKS", "arrow", 8, "ink")


def _links(scene: Scene, member: Member, angle: float, scale: float) -> Iterator[Line | Circle]:
    """Piston, rod and rocker of one member."""
    pins = scene.pins(member, angle)
    if member.output is not None:
        yield from _slider(scene, member, pins)
    if member.place.kind.name == "articulated_rod":
        yield from _slave_rod(scene, pins)
        return
    if member.is_plain:
        yield from _plain_links(scene, member, pins, scale)
        return
    radius = scene.crank_radius
    fill = "dark" if member.is_first else "paper"
    order = 5 if member.is_first else 6
    if scene.is_star:
        slave = next(one for one in scene.members if one.place.kind.name == "articulated_rod")
        reach = float(np.hypot(*(scene.pins(slave, angle)["C"] - pins["A"]))) + 1.25 * _SMALL_EYE * radius
        yield Circle(pins["A"], reach, "LINKS", "rod", order, fill)
    rod = shapes.bar(pins["A"], pins["B"], (0.44 * radius, 0.26 * radius), fill, order)
    yield rod._replace(habit="part", order=3, fill="none") if member.place.is_far else rod
    yield from shapes.eye(pins["A"], _BIG_EYE * radius, _CRANK_PIN * radius, fill, order)
    yield Circle(pins["A"], 0.035 * radius, "LINKS", "arrow", 8, "ink")
    yield from shapes.eye(pins["B"], _SMALL_EYE * radius, _SMALL_PIN * radius, fill, order)
    if member.output is None:
        yield from shapes.pivot(pins["C"], 0.45 * radius, scale)
        yield shapes.bar(pins["C"], pins["B"], (0.40 * radius, 0.30 * radius), "light", 4)
        yield from shapes.eye(pins["C"], 0.30 * radius, 0.16 * radius, "light", 4)


def _plain_links(scene: Scene, member: Member, pins: dict[str, Array], scale: float) -> Iterator[Line | Circle]:
    """Every link but the crank as a bar through its pins, pins as eyes, fixed ones on their bearings."""
    radius = scene.crank_radius
    for link in member.turn.links[1:]:
        for start, end in pairwise(link.pins):
            yield shapes.bar(pins[start], pins[end], (0.24 * radius, 0.22 * radius), "paper", 5)
    if member.cut and member.output is not None:
        yield from _break(pins[member.crank_pin], pins[member.output], radius, scale)
    yield from _other_sliders(scene, member, pins, scale)
    fixed = [name for name in member.turn.fixed if name != "O"]
    moving = [name for link in member.turn.links for name in link.pins[1:]]
    output = [] if member.output is None else [member.output]
    for name in dict.fromkeys(fixed + moving + output):
        yield from shapes.eye(pins[name], _SMALL_EYE * radius, _SMALL_PIN * radius, "paper", 7)
    for name in fixed:
        yield from shapes.pivot(pins[name], 0.45 * radius, scale)


def _break(start: Array, end: Array, radius: float, scale: float) -> Iterator[Line]:
    """Gap in a rod that is drawn too short, between two wavy lines."""
    middle = 0.5 * (start + end)
    along = (end - start) / np.hypot(*(end - start))
    line = shapes.Along(middle - np.dot(middle, along) * along, along)
    place, half = float(line.place(middle)), 0.17 * radius + 0.6 * scale
    across = np.linspace(-half, half, 17)
    edges = [
        np.stack([line.at(place + side * scale + 0.35 * scale * np.sin(2 * np.pi * u / (2 * half)), u) for u in across])
        for side in (-1.0, 1.0)
    ]
    yield Line(np.concatenate([edges[0], edges[1][::-1]]).T, "LINKS", "none", 5, is_closed=True, fill="paper")
    for edge in edges:
        yield Line(edge.T, "LINKS", "thin", 5)


def _other_sliders(scene: Scene, member: Member, pins: dict[str, Array], scale: float) -> Iterator[Line | Circle]:
    """Sliders beside the output: blocks between short guides, joined to the pin that drives them in a slot."""
    size = max(0.4 * scene.crank_radius, 1.5 * scale)
    for guide in member.turn.guides[1:]:
        along = np.array([np.cos(guide.direction), np.sin(guide.direction)]).reshape(2)
        travel = along @ member.turn_pins[guide.pin]
        pin = pins[guide.pin]
        line = shapes.Along(pin - (along @ pin) * along, along)
        low, high = float(np.nanmin(travel)) - 1.4 * size, float(np.nanmax(travel)) + 1.4 * size
        for side in (-1.0, 1.0):
            ends = [line.at(place, side * 0.55 * size) for place in (low, high)]
            yield Line(np.stack(ends, axis=1), "GUIDES", "thin", 7)
        for block in member.turn.blocks:
            if block.link == (guide.pin,):
                yield Line(np.stack([pin, pins[block.pin]], axis=1), "LINKS", "outline", 7)
        middle = float(along @ pin)
        corners = [(-size, -0.55 * size), (size, -0.55 * size), (size, 0.55 * size), (-size, 0.55 * size)]
        points = [line.at(middle + ahead, across) for ahead, across in corners]
        yield Line(np.stack(points, axis=1), "LINKS", "rod", 7, is_closed=True, fill="light")


def _slider(scene: Scene, member: Member, pins: dict[str, Array]) -> Iterator[Line | Circle]:
    """Piston; where no bore is known, a crosshead."""
    assert member.output is not None  # the caller has looked
    line, width = member.stroke_line, member.width
    place = float(line.place(pins[member.output]))
    fill = "light" if member.is_first else "paper"
    above, below = (member.toward_chamber * part for part in (member.above, _below(scene, member)))
    parts = tuple(shapes.piston(line, place, width, above, below, fill))
    yield from parts if member.bore is not None else parts[:1]


def _slave_rod(scene: Scene, pins: dict[str, Array]) -> Iterator[Line | Circle]:
    """Slave rod with its knuckle pin, and the ear of the master rod that holds it."""
    radius = scene.crank_radius
    arm = float(np.hypot(*(pins["C"] - pins["A"])))
    if not scene.is_star and arm > 0.2 * radius:
        yield shapes.hull(pins["A"], _BIG_EYE * radius, pins["C"], 1.2 * _SMALL_EYE * radius, "dark", 5)
        yield Circle(pins["A"], _CRANK_PIN * radius, "LINKS", "rod", 5, "paper")
    yield shapes.bar(pins["C"], pins["D"], (0.24 * radius, 0.22 * radius), "paper", 6)
    for name in "CD":
        yield from shapes.eye(pins[name], _SMALL_EYE * 0.9 * radius, _SMALL_PIN * 0.8 * radius, "paper", 7)


def ring_radius(scene: Scene) -> float:
    """Radius of the degree ring: round the crank, and round the big end of a star. [mm]"""
    if not scene.is_star:
        return 1.62 * scene.crank_radius
    slave = next(one for one in scene.members if one.place.kind.name == "articulated_rod")
    knuckle = np.hypot(*slave.turn_pins["C"])
    return float(np.nanmax(knuckle)) + 1.6 * _SMALL_EYE * scene.crank_radius


def _lines_of_links(scene: Scene, angle: float, dead: Sequence[Sequence[float]]) -> list[tuple[Array, float]]:
    """Lines from pin to pin with half the width of what is drawn there [mm]: links, and if few are drawn dead ones."""
    lines = [
        (line, 0.3 * scene.crank_radius)
        for member in scene.members
        for line in _chains(member, scene.pins(member, angle))
    ]
    if len(scene.members) <= _FEW:
        for member, angles in zip(scene.members, dead, strict=False):
            lines += [(line, 0.0) for one in angles for line in _chains(member, scene.pins(member, one))]
    return lines


def _ring(
    scene: Scene, lines: Sequence[tuple[Array, float]], angle: float, scale: float
) -> Iterator[Line | Circle | Label]:
    """Degree ring, its 0 where the shown crank angle is 0; figures that the links would hide are left out."""
    radius = ring_radius(scene)
    origin = np.zeros(2)
    figures = 30 if radius > _LEAST_RING * scale else 360
    yield Circle(origin, radius, "DIMENSIONS", "thin", 1)
    for degree in range(0, 360, 10):
        direction = scene.crank_direction(float(degree))
        along = np.array([np.cos(direction), np.sin(direction)])
        tick = (1.6 if degree % 30 == 0 else 0.8) * scale
        yield Line(np.stack([(radius - tick) * along, radius * along], axis=1), "DIMENSIONS", "thin", 1)
        place = (radius + (2.6 + 1.4 * abs(along[0])) * scale) * along
        if (
            degree % figures == 0
            and (degree == 0 or not scene.is_star)
            and (degree == 0 or not _is_covered(scene, lines, place, angle, 2.6 * scale))
        ):
            yield Label(place, f"{degree}", is_bold=degree == 0, is_framed=degree == 0)


def _is_covered(scene: Scene, lines: Sequence[tuple[Array, float]], point: Array, angle: float, margin: float) -> bool:
    """Whether links or cylinders lie over a point."""
    for line, half in lines:
        for start, end in pairwise(line.T):
            part = np.clip(np.dot(point - start, end - start) / np.dot(end - start, end - start), 0.0, 1.0)
            if np.hypot(*(start + part * (end - start) - point)) < half + margin:
                return True
    for member in scene.members:
        pins = scene.pins(member, angle)
        if member.output is not None:
            line = member.stroke_line
            across = float(np.dot(point - line.foot, line.across))
            begin = min(_start(scene, member), float(line.place(pins[member.output])) - _below(scene, member))
            if line.place(point) > begin - margin and abs(across) < 0.5 * member.width + margin:
                return True
    return False


def _free_direction(scene: Scene, shaft: str) -> tuple[float, float]:
    """Direction farthest from all cylinders of a shaft, or from the rocker's pivot, and how far it is. [rad]"""
    taken = [
        np.arctan2(*member.stroke_line.along[::-1])
        if member.output is not None
        else np.arctan2(*member.turn_pins[member.turn.fixed[-1]][::-1, 0])
        for member in scene.members
        if member.place.shaft == shaft
    ]
    tried = np.deg2rad(np.arange(0.0, 360.0, 5.0) - 90.0)
    room = [min(abs((angle - one + np.pi) % (2 * np.pi) - np.pi) for one in taken) for angle in tried]
    best = max(room)
    return float(next(angle for angle, free in zip(tried, room, strict=True) if free > best - 1e-9)), float(best)


def _rotation(scene: Scene, scale: float) -> Iterator[Line]:
    """Arrow of the sense in which the machine runs."""
    middle, room = _free_direction(scene, scene.leading.place.shaft)
    # Outside the ring's figures, which reach farther out at its sides than above and below.
    radius = ring_radius(scene) + (6.5 + 2.5 * abs(np.cos(middle))) * scale
    half = min(0.42, 11.0 * scale / radius)
    if scene.is_star:
        radius = max(_end(member) for member in scene.sliders)
        half = (
            room - float(np.arcsin(0.5 * max(member.width for member in scene.sliders) / radius)) - 3.0 * scale / radius
        )
    turns = scene.crank_direction(1.0) - scene.crank_direction(0.0)
    sense = np.sign((turns + np.pi) % (2 * np.pi) - np.pi)
    yield from _arc_arrow(np.zeros(2), radius, (middle, half), sense, scale)


def _other_shafts(scene: Scene) -> list[Member]:
    """One member on each shaft beside the main one."""
    shafts = {member.place.shaft: member for member in scene.cranks}
    return [member for shaft, member in shafts.items() if shaft != scene.leading.place.shaft]


def _rotation_of_other(scene: Scene, member: Member, scale: float) -> Iterator[Line]:
    """Arrow of the sense in which another shaft turns; one that is geared the other way turns against the main one."""
    middle, _room = _free_direction(scene, member.place.shaft)
    radius = scene.crank_radius * (1.0 + 1.12 * _BIG_EYE) + 2.5 * scale
    turns = scene.crank_direction(1.0, member) - scene.crank_direction(0.0, member)
    sense = np.sign((turns + np.pi) % (2 * np.pi) - np.pi)
    yield from _arc_arrow(member.centre, radius, (middle, min(0.6, 9.0 * scale / radius)), sense, scale)


def _arc_arrow(centre: Array, radius: float, span: tuple[float, float], sense: float, scale: float) -> Iterator[Line]:
    """Arc with an arrowhead at its end, so far to each side of a direction. [mm, rad]"""
    middle, half = span
    yield Line(shapes.arc(centre, radius, middle - half, middle + half), "DIMENSIONS", "outline", 5)
    end = middle + sense * half
    tip = centre + radius * np.array([np.cos(end), np.sin(end)])
    yield shapes.arrowhead(tip, float(end + sense * (np.pi / 2 - 1.1 * scale / radius)), 2.6 * scale)


def _names(scene: Scene, angle: float, sketch: Sketch) -> Iterator[Label | Line]:
    """Names of the pistons: over the heads, of two in one cylinder beside them."""
    if len(scene.members) == 1 and scene.members[0].place.name == "1":
        return
    scale = sketch.scale
    wishes: list[Wish] = []
    named: list[Array] = []
    for member in scene.singles:
        line = member.stroke_line
        wishes.append(Wish(line.at(_end(member) + 2.0 * scale, 0.0), member.place.name, _away(line.along), "name"))
        is_piston = member.place.kind.has_chambers or member.output is None
        named.append(wishes[-1].point if is_piston else scene.pins(member, angle)[str(member.output)])
    obstacles = [line.points for line in sketch.lines if line.habit != "hatch"]
    for pair in scene.pairs:
        outward = 0.5 * (_middle(pair[0]) + _middle(pair[1])) - np.mean([one.centre for one in scene.members], axis=0)
        across = pair[0].stroke_line.across
        lies_out = float(np.dot(outward, across))
        # Where the shafts lie in one line, names stand to the right of it.
        outer = across * np.sign(lies_out if abs(lies_out) > 1e-6 * scale else across @ np.array([1.0, -1e-3]))
        beside = 0.5 * pair[0].width * outer
        for member in pair:
            wishes.append(Wish(_middle(member) + beside + 1.5 * scale * outer, member.place.name, _away(outer), "name"))
            named.append(wishes[-1].point)
        ends = np.stack([_end_of_travel(member) for member in pair], axis=1)
        obstacles += [ends + side * beside[:, np.newaxis] for side in (-1.0, 0.0, 1.0)]
    if not wishes:
        return
    obstacles += [label_outline(label, scale) for label in sketch.labels]
    obstacles += [shapes.arc(circle.centre, circle.radius, 0.0, 2 * np.pi) for circle in sketch.circles]
    for point, label in zip(named, placed_labels(wishes, obstacles, scale), strict=True):
        yield label
        box = label_outline(label, scale)
        nearest = np.clip(point, np.min(box, axis=1), np.max(box, axis=1))
        if np.hypot(*(nearest - point)) > _LEADER * scale:
            yield Line(np.stack([point, label.position], axis=1), "DIMENSIONS", "thin", 8)


def _end_of_travel(member: Member) -> Array:
    """Where a piston's pin is farthest from the other piston."""
    return member.stroke_line.at(member.travel[member.place.is_far], 0.0)


def _middle(member: Member) -> Array:
    """Middle of a piston pin's travel."""
    return member.stroke_line.at(0.5 * sum(member.travel), 0.0)


def _away(direction: Array) -> float:
    return float(np.arctan2(direction[1], direction[0]))


def _bank_angle(scene: Scene, scale: float) -> Iterator[Line | Label]:
    """Angle between two banks."""
    if len(scene.singles) != _FEW or scene.pairs:
        return
    first, second = scene.singles
    directions = [float(np.arctan2(*member.stroke_line.along[::-1])) for member in (first, second)]
    between = (directions[1] - directions[0] + np.pi) % (2 * np.pi) - np.pi
    radius = 0.86 * min(_end(first), _end(second))
    covered = np.arcsin(min((0.5 * max(first.width, second.width) + 3.0 * scale) / radius, 1.0))
    if abs(between) / 2 - covered < 0.05:
        return
    start, end = directions[0] + np.sign(between) * covered, directions[1] - np.sign(between) * covered
    yield Line(shapes.arc(np.zeros(2), radius, start, end), "DIMENSIONS", "thin", 2)
    middle = (start + end) / 2
    place = (radius + 3.0 * scale) * np.array([np.cos(middle), np.sin(middle)])
    yield Label(place, f"γ = {np.rad2deg(abs(between)):.4g}°")
