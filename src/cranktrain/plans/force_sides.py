"""Sides of a polygon of forces, and the forces between its corners."""

from typing import Literal, NamedTuple

import numpy as np

from cranktrain.record import record

Cause = Literal["gas", "load", "weight", "inertia", "reaction"]

INITIAL = "initial"
"""Sort of the link that no group is: the crank, which gets the balancing moment."""


class PolygonForce(NamedTuple):
    """A force on a link, as a polygon has it for a side.

    Symbol such as `F_34` (of 3 on 4), cause, joint of a reaction, link on which it acts, exact X and Y [N]; of a part
    that moments give, the pin about which they are taken; of a load its name in the file.
    """

    symbol: str
    cause: Cause
    joint: str
    link: str
    value: tuple[float, float]
    about: str = ""
    name: str = ""

    @property
    def size(self) -> float:
        """Size of the force. [N]"""
        return float(np.hypot(*self.value))


class TorqueOnLink(NamedTuple):
    """A torque that the machine file lets act on a link: its symbol such as `M_4`, its name there, the link, its value.

    In the sense in which the mechanism's crank turns. [N·m]
    """

    symbol: str
    name: str
    link: str
    value: float


class Span(NamedTuple):
    """A force between two corners of a polygon, which are counted from its start.

    A reaction of which the sides between them are the parts; or the reaction in an inner joint: a chord.
    """

    force: PolygonForce
    by: str
    start: int
    end: int


@record
class GroupForces:
    """All forces on an Assur group, or on the crank, at one crank angle, head to tail.

    Attributes
    ----------
    sort : str
        Of the group, such as `RRP`; `initial` of the crank.
    links : tuple of str
    numbers : tuple of int
        Of the links: 1 is the frame, 2 the crank; `F_34` is the force of link 3 on link 4.
    forces : tuple of PolygonForce
        Link by link: gas, loads, weight, inertia, what hangs on the group, and its outer reactions. A pin's is in two
        parts where moments about another pin give the one across the link, `F_23^t`; `F_23^n` is along it. A guide's
        with friction is `N_14`, across the guide, and `f_14`.
    wholes : tuple of Span
        Outer reactions of which sides are the parts.
    chords : tuple of Span
        Reactions in inner joints, which split the polygon into those of the links.
    moment : float
        Of the crank: the balancing moment in the sense in which its shaft turns [N·m]; NaN for a group.
    torques : tuple of TorqueOnLink
        That the file lets act on the links: they are in the moments that give the parts across links.
    """

    sort: str
    links: tuple[str, ...]
    numbers: tuple[int, ...]
    forces: tuple[PolygonForce, ...]
    wholes: tuple[Span, ...]
    chords: tuple[Span, ...]
    moment: float
    torques: tuple[TorqueOnLink, ...]
