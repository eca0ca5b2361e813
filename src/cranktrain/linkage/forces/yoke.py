"""Reactions of an RPP group: a block on a pin in a slider's slot, with friction between slider and guide."""

from typing import NamedTuple

import numpy as np

from cranktrain.linkage.forces.conditions import Friction, dragged, pressed
from cranktrain.linkage.forces.wrench import Wrench
from cranktrain.linkage.yoke import Yoke
from cranktrain.motion import Array, Coefficient, Link, Point


class YokeLoads(NamedTuple):
    """What block and slider bear but for their joints: about the pin, and about where the slot meets the guide."""

    block: Wrench
    slider: Wrench


class YokeReactions(NamedTuple):
    """Wrenches of the pin on the block, of the block on the slider (about the pin), of the guide on the slider.

    The guide's: friction along x, normal force along y, and a moment about where the slot meets the guide.
    """

    pin: Wrench
    slot: Wrench
    guide: Wrench


def block_link(pin: Point, angle: Array) -> Link:
    """Block as a link that does not turn, from its pin in the slot's direction."""
    zero = 0.0 * pin.x.value
    return Link(pin, Coefficient(angle + zero, zero, zero), np.cos(angle) + zero, np.sin(angle) + zero)


def yoke_reactions(block: Array, geometry: Yoke, loads: YokeLoads, friction: Friction) -> YokeReactions:
    """Reactions of a block and its slotted slider; none of friction in the slot.

    Parameters
    ----------
    block : Array, shape (..., n)
        Its position along the slot, from where that meets the guide. [m]
    geometry : Yoke, fields broadcastable to (..., 1)
    loads : YokeLoads, shape (..., n)
    friction : Friction, fields broadcastable to (..., n)

    Returns
    -------
    YokeReactions, shape (..., n)
        NaN where friction wedges the slider.

    Notes
    -----
    With X, Y the slider's load and β the slot's angle: N = N₀ + μσ|N| cot β, N₀ = −Y − X cot β, and the block presses
    with (X + f)/sin β to the left of the slot. docs/theory/forces, eqs. (13.18) and (13.19).
    """
    sin = np.sin(geometry.slot_angle)
    cos = np.cos(geometry.slot_angle)
    slope = cos / sin
    load = loads.slider
    normal = pressed(-load.y - load.x * slope, -slope, friction)
    drag = dragged(normal, friction)
    across = (load.x + drag) / sin
    x = -(load.x + drag)
    y = across * cos
    zero = 0.0 * x
    couple = loads.block.moment
    return YokeReactions(
        Wrench(x - loads.block.x, y - loads.block.y, zero),
        Wrench(x, y, zero + couple),
        Wrench(drag, normal, -(load.moment + couple + block * across)),
    )
