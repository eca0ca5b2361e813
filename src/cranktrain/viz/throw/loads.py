"""Loads of the machine file on a throw: arrows and arcs, and their names with sizes."""

from collections.abc import Iterator, Sequence

import numpy as np

from cranktrain.motion import Array
from cranktrain.plans.acting_loads import ActingLoad
from cranktrain.viz.paper import shapes
from cranktrain.viz.paper.load_arrows import ArrowSizes, LoadMark, load_marks, load_wishes
from cranktrain.viz.paper.sketch import Label, Line, Sketch, label_outline, placed_labels
from cranktrain.viz.throw.scene import BIG_EYE, Scene

_LONGEST, _HEAD, _RADIUS = 0.16, 0.028, 0.05
"""Longest arrow, its head, and least radius of an arc, in parts of the throw's size: alike on a sheet and in a film."""

_ROUND = 1.3
"""Radius of an arc about a pin in those of the big eye, at least."""

_LEADER = 3.5
"""A name farther from its load than this has a line to it. [mm of paper]"""

_POINT = np.full((2, 2), np.nan)
_NOWHERE_HELD = (Line(_POINT, "LOADS", "construction", 3), Line(_POINT, "LOADS", "thin", 3))
_NOWHERE = (Line(_POINT, "LOADS", "load", 9), Line(_POINT, "LOADS", "arrow", 9, is_closed=True, fill="ink"))


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
    acting = [_on_broken(scene, load.moved(np.zeros((2, 1)), 1e3)) for load in scene.loads.at(np.array([angle]))]
    return tuple(load_marks(acting, scene.loads.largest, room, links))


def moving_lines(scene: Scene, marks: Sequence[LoadMark]) -> Iterator[Line]:
    """Lines of loads, four for each at every crank angle, as a film wants: those that are not there are nowhere."""
    drawn = {(mark.load.mechanism, mark.load.name): mark for mark in marks}
    for load in () if scene.loads is None else scene.loads.at(np.zeros(1)):
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
            if np.hypot(*(nearest - mark.point)) > _LEADER * sketch.scale:
                yield Line(np.stack([mark.point, nearest], axis=1), "LOADS", "thin", 8)
