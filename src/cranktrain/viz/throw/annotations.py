"""What stands beside the links of a throw: names of pistons, the angle between banks, loads, followed points."""

from collections.abc import Iterator, Sequence

import numpy as np

from cranktrain.language import said as _
from cranktrain.motion import Array
from cranktrain.panels.figures import with_unit
from cranktrain.panels.throw_member import DrawnMechanism
from cranktrain.panels.throw_scene import BIG_EYE, Scene
from cranktrain.plans.acting_loads import ActingLoad
from cranktrain.plans.stroke_lines import Along, unit
from cranktrain.plans.vectors import angle_of, spoken_name
from cranktrain.saying.scales import scale_for
from cranktrain.viz.paper import shapes
from cranktrain.viz.paper.load_arrows import ArrowSizes, DrawnBody, LoadMark, load_marks, load_wishes
from cranktrain.viz.paper.sketch import Circle, Label, Line, Sketch, Wish, label_outline, placed_labels
from cranktrain.viz.throw.cylinders import skirt, wall_end

_LEADER = 5.0
"""A name farther from what it names than this has a line to it. [mm of paper]"""

_PAIR = 2

_BESIDE, _TIP, _LINE = 4.0, 2.0, 4.0
"""How far a dimension stands from a ram, length of its arrowheads, height of a line of words. [mm of paper]"""

_LONGEST, _HEAD, _RADIUS = 0.16, 0.028, 0.05
"""Longest arrow, its head, and least radius of an arc, in parts of the throw's size: alike on a sheet and in a film."""

_ROUND = 1.3
"""Radius of an arc about a pin in those of the big eye, at least."""

_IN_LINE = 0.99
"""Part of a force along a slider's line from which on it acts at the slider's face."""

_LOAD_LEADER = 3.5
"""A name farther from its load than this has a line to it. [mm of paper]"""

_POINT = np.full((2, 2), np.nan)
_NOWHERE_HELD = (Line(_POINT, "LOADS", "construction", 3), Line(_POINT, "LOADS", "thin", 3))
_NOWHERE = (Line(_POINT, "LOADS", "load", 9), Line(_POINT, "LOADS", "arrow", 9, is_closed=True, fill="ink"))

_MARKS = np.arange(0.0, 360.0, 30.0)
"""Crank angles at which a curve has its marks. [deg]"""

_MARK, _EYE = 0.45, 0.9
"""Radii of a mark and of the point itself on paper. [mm]"""


def piston_names(scene: Scene, angle: float, sketch: Sketch) -> Iterator[Label | Line]:
    """Names of the pistons: over the heads, of two in one cylinder beside them."""
    if scene.is_alone and len(scene.members) == 1 and scene.members[0].place.name == "1":
        return
    scale = sketch.scale
    places = [
        (member, member.stroke_line.at(wall_end(scene, member) + 2.0 * scale), member.stroke_line.along)
        for member in scene.singles
    ]
    # Names of pistons in one cylinder stand beside its hatched walls, others beyond their end.
    obstacles = [line.points for line in sketch.lines if scene.pairs or line.habit != "hatch"]
    for pair in scene.pairs:
        outward = 0.5 * (_middle(pair[0]) + _middle(pair[1])) - np.mean([one.centre for one in scene.members], axis=0)
        across = pair[0].stroke_line.across
        lies_out = float(np.dot(outward, across))
        # Where the shafts lie in one line, names stand to the right of it.
        outer = across * np.sign(lies_out if abs(lies_out) > 1e-6 * scale else across @ np.array([1.0, -1e-3]))
        beside = 0.5 * pair[0].width * outer
        places += [(member, _middle(member) + beside + 1.5 * scale * outer, outer) for member in pair]
        # Where a piston's pin is farthest from the other piston.
        ends = np.stack([member.stroke_line.at(member.travel[member.place.is_far]) for member in pair], axis=1)
        obstacles += [ends + side * beside[:, np.newaxis] for side in (-1.0, 0.0, 1.0)]
    obstacles += [label_outline(label, scale) for label in sketch.labels]
    obstacles += [shapes.arc(circle.centre, circle.radius, 0.0, 2 * np.pi) for circle in sketch.circles]
    wishes = [Wish(point, member.place.name, angle_of(outward), "name") for member, point, outward in places]
    for (member, point, _outward), label in zip(places, placed_labels(wishes, obstacles, scale), strict=True):
        yield label
        is_valve = member.output is not None and not member.place.kind.output.has_chambers
        named = member.stroke_line.at(scene.reach(member, angle)) if is_valve else point
        box = label_outline(label, scale)
        nearest = np.clip(named, np.min(box, axis=1), np.max(box, axis=1))
        if np.hypot(*(nearest - named)) > _LEADER * scale:
            yield Line(np.stack([named, label.position], axis=1), "DIMENSIONS", "thin", 8)


def _middle(member: DrawnMechanism) -> Array:
    """Middle of a piston pin's travel."""
    return member.stroke_line.at(0.5 * sum(member.travel))


def stroke_ends(scene: Scene, member: DrawnMechanism, angles: Sequence[float], scale: float) -> Iterator[Line | Label]:
    """Ends of a ram's stroke beside it, the upper and the lower as the machine stands, with the stroke between."""
    if member.ram is None or len(angles) != _PAIR:
        return
    line, ram = member.stroke_line, member.ram
    right = 1.0 if line.across[0] > 0 else -1.0
    beside = 0.5 * member.width + _BESIDE * scale
    apart = max(0.5 * (_LINE - (ram.ends[1] - ram.ends[0]) / scale), 0.0)
    words = {True: _("upper {angle}"), False: _("lower {angle}")}
    for angle in angles:
        place = scene.reach(member, angle) + ram.face
        is_upper = bool(place < np.mean(ram.ends))
        yield Line(
            line.path((place, right * 0.5 * member.width), (place, right * (beside + 1.5 * scale))),
            "DIMENSIONS",
            "thin",
            2,
        )
        text = words[is_upper].format(angle=f"{angle:.2f}°")
        at = place - (apart if is_upper else -apart) * scale
        yield Label(_beside(line.at(at, right * (beside + 1.5 * scale)), text, scale), text)
    yield from _dimension(line, (float(ram.ends[0]), float(ram.ends[1])), right * beside, scale)


def _dimension(line: Along, ends: tuple[float, float], across: float, scale: float) -> Iterator[Line | Label]:
    """A dimension between two places along a line, with its length where there is room."""
    start, end = line.path(*((place, across) for place in ends)).T
    yield Line(np.stack([start, end], axis=1), "DIMENSIONS", "thin", 2)
    for tip, other in ((start, end), (end, start)):
        yield shapes.arrowhead(tip, angle_of(tip - other), _TIP * scale)
    length = float(1e-3 * (ends[1] - ends[0]))
    if ends[1] - ends[0] > 3.0 * _LINE * scale:
        text = with_unit(length, scale_for("m", length))
        yield Label(_beside(0.5 * (start + end), text, scale), text)


def _beside(point: Array, text: str, scale: float) -> Array:
    """Middle of a label that begins to the right of a point."""
    width = float(np.ptp(label_outline(Label(point, text), scale)[0]))
    return point + np.array([0.5 * width + scale, 0.0])


def bank_angle(scene: Scene, scale: float) -> Iterator[Line | Label]:
    """Angle between two banks."""
    if len(scene.singles) != _PAIR or scene.pairs:
        return
    first, second = scene.singles
    directions = [angle_of(member.stroke_line.along) for member in (first, second)]
    between = (directions[1] - directions[0] + np.pi) % (2 * np.pi) - np.pi
    radius = 0.86 * min(wall_end(scene, first), wall_end(scene, second))
    covered = np.arcsin(min((0.5 * max(first.width, second.width) + 3.0 * scale) / radius, 1.0))
    if abs(between) / 2 - covered < 0.05:
        return
    start, end = directions[0] + np.sign(between) * covered, directions[1] - np.sign(between) * covered
    yield Line(shapes.arc(np.zeros(2), radius, start, end), "DIMENSIONS", "thin", 2)
    middle = (start + end) / 2
    yield Label((radius + 3.0 * scale) * unit(middle), f"γ = {np.rad2deg(abs(between)):.4g}°")


def throw_loads(scene: Scene, angle: float) -> tuple[LoadMark, ...]:
    """Loads on a throw's mechanisms at a crank angle. [deg]"""
    if scene.loads is None:
        return ()
    size = scene.size
    radius = max(_RADIUS * size, _ROUND * BIG_EYE * scene.crank_radius)
    room = ArrowSizes(_LONGEST * size, _HEAD * size, radius)
    links = [
        np.stack([scene.pins(member, angle)[name] for name in (link.pins[0], end)], axis=1)
        for member in scene.members
        for link in member.turn.links
        for end in link.pins[1:]
    ]
    still, at = np.zeros((2, 1)), np.array([angle])
    acting = [_on_broken(scene, load.moved(still, 1e3)) for load in scene.loads.at(at)]
    bodies = {(load.mechanism, load.name): _body(scene, load) for load in acting if load.link == "slider"}
    acting += [load.moved(still, 1e3) for load in scene.loads.on_shafts_at(at)]
    return tuple(load_marks(acting, scene.loads.largest, room, links, bodies))


def _body(scene: Scene, load: ActingLoad) -> DrawnBody:
    """Slider about the point of a force along its line: a force across it acts at the point itself."""
    member = next(member for member in scene.members if member.place.name == load.mechanism)
    if not member.turn.guides:
        return DrawnBody(0.0, 0.0)
    along = float(member.stroke_line.along @ load.way[:, 0])
    if abs(along) < _IN_LINE:
        return DrawnBody(0.0, 0.0)
    near = skirt(scene, member)
    far = near if member.crosshead is not None else scene.above(member)
    ends = (far, near) if member.toward_chamber > 0 else (near, far)
    return DrawnBody(*(ends if along > 0 else ends[::-1]))


def moving_lines(scene: Scene, marks: Sequence[LoadMark]) -> Iterator[Line]:
    """Lines of loads, four for each at every crank angle, as a film wants: those that are not there are nowhere."""
    drawn = {(mark.load.mechanism, mark.load.name): mark for mark in marks}
    at = np.zeros(1)
    for load in () if scene.loads is None else (*scene.loads.at(at), *scene.loads.on_shafts_at(at)):
        mark = drawn.get((load.mechanism, load.name))
        held, lines = ((), ()) if mark is None else (mark.held, mark.lines if len(mark.lines) > 1 else ())
        yield from (*held, *_NOWHERE_HELD[len(held) :])
        yield from lines or _NOWHERE


def _on_broken(scene: Scene, load: ActingLoad) -> ActingLoad:
    """A load on a slider that is drawn nearer to its shaft, there."""
    member = next(member for member in scene.members if member.place.name == load.mechanism)
    if not member.cut or load.link != "slider":
        return load
    return load.moved(-member.cut * member.stroke_line.along[:, np.newaxis])


def load_names(marks: Sequence[LoadMark], sketch: Sketch) -> Iterator[Label | Line]:
    """Names of loads with their sizes, clear of what is drawn; to one that is far a line leads."""
    if marks:
        lines: list[Array] = [line.points for line in sketch.lines if line.habit != "hatch"]
        lines += [label_outline(label, sketch.scale) for label in sketch.labels]
        lines += [shapes.arc(one.centre, one.radius, 0.0, 2 * np.pi) for one in sketch.circles]
        labels = placed_labels(list(load_wishes(marks)), lines, sketch.scale)
        for mark, label in zip(marks, labels, strict=True):
            yield label
            box = label_outline(label, sketch.scale)
            nearest = np.clip(mark.point, np.min(box, axis=1), np.max(box, axis=1))
            if np.hypot(*(nearest - mark.point)) > _LOAD_LEADER * sketch.scale:
                yield Line(np.stack([mark.point, nearest], axis=1), "LOADS", "thin", 8)


def followed_points(scene: Scene, member: DrawnMechanism, angle: float, scale: float) -> Iterator[Line | Circle]:
    """Each point on the plate that carries it; marks on its curve at every 30° of the crank, filled at 0."""
    pins = scene.pins(member, angle)
    for link in member.turn.links:
        for name in link.pins:
            if name in member.turn.points:
                corners = [pins[one] for one in (*link.pins[:2], name)]
                yield Line(np.stack(corners, axis=1), "LINKS", "rod", 4, is_closed=True)
    if not member.turn.points:
        return
    marks = scene.turned(member, _MARKS)
    for name in member.turn.points:
        for number, place in enumerate(marks[name].T):
            if np.all(np.isfinite(place)):
                yield Circle(place, _MARK * scale, "PATHS", "rod", 2, "ink" if number == 0 else "paper")
        yield Circle(pins[name], _EYE * scale, "LINKS", "outline", 8, "paper")


def point_names(scene: Scene, angle: float, sketch: Sketch) -> Iterator[Label]:
    """Names of the points, clear of the lines, each once."""
    wishes: dict[str, Wish] = {}
    for member in scene.members:
        pins = scene.pins(member, angle)
        middle = np.mean(np.stack([pins[name] for name in member.metal]), axis=0)
        for name in member.turn.points:
            wishes.setdefault(name, Wish(pins[name], spoken_name(name), angle_of(pins[name] - middle)))
    if wishes:
        lines = [line.points for line in sketch.lines if line.habit != "hatch"]
        lines += [label_outline(label, sketch.scale) for label in sketch.labels]
        lines += [shapes.arc(one.centre, one.radius, 0.0, 2 * np.pi) for one in sketch.circles]
        yield from placed_labels(list(wishes.values()), lines, sketch.scale)
