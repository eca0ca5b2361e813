"""Sides of a polygon of forces, and the forces between its corners."""

from typing import NamedTuple

import numpy as np

from cranktrain.plans.acting import Cause

INITIAL = "initial"
"""Sort of the link that no group is: the crank, which gets the balancing moment."""


class PolygonForce(NamedTuple):
    """A side of a polygon of forces.

    Symbol, cause, joint of a reaction, link on which it acts, exact X and Y [N]; of a part that moments give, the pin
    about which they are taken.
    """

    symbol: str
    cause: Cause
    joint: str
    link: str
    value: tuple[float, float]
    about: str = ""

    @property
    def size(self) -> float:
        """Size of the force. [N]"""
        return float(np.hypot(*self.value))


class Span(NamedTuple):
    """A force between two corners of a polygon, which are counted from its start.

    A reaction of which the sides between them are the parts; or the reaction in an inner joint: a chord.
    """

    force: PolygonForce
    by: str
    start: int
    end: int


class GroupForces(NamedTuple):
    """What acts on a group, head to tail; its links' names and numbers; a crank's balancing moment [N·m], else NaN."""

    sort: str
    links: tuple[str, ...]
    numbers: tuple[int, ...]
    forces: tuple[PolygonForce, ...]
    wholes: tuple[Span, ...]
    chords: tuple[Span, ...]
    moment: float
