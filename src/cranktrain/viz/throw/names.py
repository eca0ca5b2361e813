"""Names of pistons on a sheet, and the angle between two banks."""

from collections.abc import Iterator

import numpy as np

from cranktrain.motion import Array
from cranktrain.plans.vectors import angle_of
from cranktrain.viz.paper import shapes
from cranktrain.viz.paper.sketch import Label, Line, Sketch, Wish, label_outline, placed_labels
from cranktrain.viz.throw.cylinders import wall_end
from cranktrain.viz.throw.scene import DrawnMechanism, Scene

_LEADER = 5.0
"""A name farther from what it names than this has a line to it. [mm of paper]"""

_PAIR = 2


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
    yield Label((radius + 3.0 * scale) * shapes.unit(middle), f"γ = {np.rad2deg(abs(between)):.4g}°")
