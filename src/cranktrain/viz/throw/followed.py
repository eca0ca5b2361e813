"""Points on links that the machine file asks to follow: the plate that carries each, its curve's marks, its name."""

from collections.abc import Iterator

import numpy as np

from cranktrain.plans.vectors import angle_of, spoken_name
from cranktrain.viz.paper import shapes
from cranktrain.viz.paper.sketch import Circle, Label, Line, Sketch, Wish, label_outline, placed_labels
from cranktrain.viz.throw.scene import DrawnMechanism, Scene

_MARKS = np.arange(0.0, 360.0, 30.0)
"""Crank angles at which a curve has its marks. [deg]"""

_MARK, _EYE = 0.45, 0.9
"""Radii of a mark and of the point itself on paper. [mm]"""


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
