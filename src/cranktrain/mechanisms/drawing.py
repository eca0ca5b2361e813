"""A mechanism to be drawn: how its pins move, and what joins them."""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from cranktrain.motion import Array, Point
from cranktrain.numerics.nested import each_changed
from cranktrain.record import record


class DrawnLink(NamedTuple):
    """A link to draw: its name and the names of its pins, in order."""

    name: str
    pins: tuple[str, ...]


class Guide(NamedTuple):
    """A straight guide to draw: the pin that slides in it, and the guide's direction from x. [rad]"""

    pin: str
    direction: Array


class Block(NamedTuple):
    """A sliding contact: a pin that slides along a link, and that link's pins; one pin of a link that never turns."""

    pin: str
    link: tuple[str, ...]


@record
class Drawing:
    """A mechanism to draw: how its pins move, in its own axes, and what joins them.

    Attributes
    ----------
    pins : mapping of name to Point
        Coefficients of shape (..., n); a point that stands still may have (..., 1) or none. [m, m/rad, m/rad²]
    links : sequence of DrawnLink
        The crank first; every link after those that hold its first pin.
    guides : sequence of Guide
        The output's first.
    fixed : sequence of str
        Pins that stand still.
    paths : sequence of str
        Pins whose path is worth drawing.
    blocks : sequence of Block
    ends : sequence of str
        Pins that only show how far a link reaches, where no length of the geometry says it: no plan speaks of them.
    points : sequence of str
        Pins that are no joints: points on links that the machine file asks to follow.
    """

    pins: Mapping[str, Point]
    links: Sequence[DrawnLink]
    guides: Sequence[Guide]
    fixed: Sequence[str]
    paths: Sequence[str]
    blocks: Sequence[Block] = ()
    ends: Sequence[str] = ()
    points: Sequence[str] = ()

    def slotted(self, block: Block) -> tuple[str, ...]:
        """Pins of the link along which a block slides; none of a slider that nothing draws as a link."""
        return next((link.pins for link in self.links if {*block.link} <= {*link.pins}), ())

    @property
    def positions(self) -> dict[str, Array]:
        """Where the pins are, by name: x and y, shape (2, ..., n), of all pins alike."""
        shape = np.broadcast_shapes(*(np.shape(part.value) for pin in self.pins.values() for part in pin))
        return {name: np.stack([np.broadcast_to(part.value, shape) for part in pin]) for name, pin in self.pins.items()}

    def scaled(self, factor: float) -> "Drawing":
        """Give the same drawing in another unit of length."""
        pins = {name: each_changed(lambda value: factor * value, pin) for name, pin in self.pins.items()}
        return replace(self, pins=pins)
