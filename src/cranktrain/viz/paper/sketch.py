"""A sketch: lines, circles and labels in millimetres of metal, on layers, that any drawing program can take.

What has a size on paper (ticks of a hatch, gaps beside a label) is given in paper millimetres times the scale.
"""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from typing import Any, Literal, NamedTuple

import numpy as np

from cranktrain.motion import Array

Layer = Literal["LINKS", "GUIDES", "PATHS", "PLAN_V", "PLAN_A", "LOADS", "TEXT", "DIMENSIONS", "DRIVE"]
Habit = Literal[
    "outline",
    "rod",
    "thin",
    "hatch",
    "dotted",
    "curve",
    "axis",
    "arrow",
    "vector",
    "load",
    "part",
    "chord",
    "construction",
    "none",
]
Fill = Literal["none", "paper", "light", "dark", "ink"]
Manner = Literal["symbol", "number", "name", "words"]

LAYERS: tuple[Layer, ...] = ("LINKS", "GUIDES", "PATHS", "PLAN_V", "PLAN_A", "LOADS", "TEXT", "DIMENSIONS")
"""Of every drawing; DRIVE is there where a machine has one."""


class Line(NamedTuple):
    """A polyline, or several of them with NaN between; shape (2, n). [mm]"""

    points: Array
    layer: Layer
    habit: Habit
    order: int = 0
    is_closed: bool = False
    fill: Fill = "none"


class Circle(NamedTuple):
    """A circle: centre, radius. [mm]"""

    centre: Array
    radius: float
    layer: Layer
    habit: Habit
    order: int = 0
    fill: Fill = "none"


class Label(NamedTuple):
    """A word, its middle at a point [mm].

    A symbol is set as mathematics: a_BA^n; a number and a name stand on white, and a name is bold.
    """

    position: Array
    text: str
    manner: Manner = "words"


@dataclass
class Sketch:
    """What is drawn, in the order in which it came; `scale` is millimetres of metal in one of paper."""

    scale: float
    lines: list[Line] = field(default_factory=list)
    circles: list[Circle] = field(default_factory=list)
    labels: list[Label] = field(default_factory=list)

    def add(self, parts: "Iterable[Line | Circle | Label]") -> None:
        """Take parts in."""
        lists: dict[type, list[Any]] = {Line: self.lines, Circle: self.circles, Label: self.labels}
        for part in parts:
            lists[type(part)].append(part)

    def outline(self) -> Iterator[Array]:
        """Give the points between which everything drawn lies, shape (2, n)."""
        for line in self.lines:
            yield line.points
        for circle in self.circles:
            yield circle.centre[:, np.newaxis] + circle.radius * np.array([[-1.0, 1.0], [-1.0, 1.0]])


def bounds_of(outlines: Iterable[Array]) -> tuple[Array, Array]:
    """Lower left and upper right corner of what points fill, each array of shape (2, n). [mm]"""
    points = np.concatenate(list(outlines), axis=1)
    return np.nanmin(points, axis=1), np.nanmax(points, axis=1)
