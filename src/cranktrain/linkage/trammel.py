"""PRP group: a block jointed to a slider, the block on a line of a moving link, the slider on a fixed guide along x."""

from typing import NamedTuple

import numpy as np

from cranktrain.linkage.point import turned
from cranktrain.linkage.vectors import direction, rotated
from cranktrain.motion import Array, Coefficient, Link


class Trammel(NamedTuple):
    """Offset of the guide from the axis x; shift of the slot's line from the link's first pin, to its left. [m]"""

    offset: Array
    shift: Array


class TrammelMotion(NamedTuple):
    """Slider: position along x [m]; block: its position along the slot, from beside the link's first pin [m]."""

    slider: Coefficient
    block: Coefficient


def trammel(link: Link, geometry: Trammel) -> TrammelMotion:
    """Slider on a guide along x, held where a moving link's slot crosses it, and its derivatives by the crank angle.

    Parameters
    ----------
    link : Link, coefficients of shape (..., n)
        Slotted crank, lever or rod. In other axes than the guide's: `turned_link`.
    geometry : Trammel, fields broadcastable to (..., 1)

    Returns
    -------
    TrammelMotion, shape (..., n)
        There is one crossing and no side. Infinite or NaN where the slot is parallel to the guide: it closes all the
        way round where the sine of the angle between both, in the guide's axes the link's, keeps its sign.

    Notes
    -----
    w = e − y_o: t = (w − h cos θ)/sin θ, X = s − x_o = (w cos θ − h)/sin θ; t′ = −(y_o′ + θ′X)/sin θ,
    s′ = x_o′ + t′cos θ − θ′w, t″ = −(y_o″ + θ″X + 2t′θ′cos θ − θ′²w)/sin θ,
    s″ = x_o″ + t″cos θ − 2t′θ′sin θ − θ″w − θ′²X. Exact; docs/theory/groups-2, eqs. (7.7) to (7.9).

    Examples
    --------
    >>> from cranktrain.linkage import Crank, Slide, AHEAD, crank, slide
    >>> rod = slide(crank(np.pi / 2, Crank(0.3)), Slide(0.5, 0.0, AHEAD)).rod
    >>> round(float(trammel(rod, Trammel(0.15, 0.0)).slider.value), 12)
    0.2
    """
    turn = link.angle.first
    rate = link.angle.second
    square = turn * turn
    height = geometry.offset - link.origin.y.value
    block = (height - geometry.shift * link.cos) / link.sin
    ahead = (height * link.cos - geometry.shift) / link.sin
    block1 = -(link.origin.y.first + turn * ahead) / link.sin
    coriolis = 2.0 * block1 * turn
    block2 = -(link.origin.y.second + rate * ahead + coriolis * link.cos - square * height) / link.sin
    slider = Coefficient(
        link.origin.x.value + ahead,
        link.origin.x.first + (block1 * link.cos - turn * height),
        link.origin.x.second + (block2 * link.cos - coriolis * link.sin - rate * height - square * ahead),
    )
    return TrammelMotion(slider, Coefficient(block, block1, block2))


def turned_link(link: Link, angle: Array) -> Link:
    """Give the same link in axes turned by `angle` in the sense of rotation, as a guide elsewhere needs it.

    Parameters
    ----------
    link : Link, coefficients of shape (..., n)
    angle : Array, broadcastable to (..., 1). [rad]

    Returns
    -------
    Link, shape (..., n)
        Its angle is a principal value in (−π, π].
    """
    along = rotated(direction(link), np.cos(angle), -np.sin(angle))
    turning = Coefficient(np.arctan2(along.y, along.x), link.angle.first, link.angle.second)
    return Link(turned(link.origin, angle), turning, along.x, along.y)
