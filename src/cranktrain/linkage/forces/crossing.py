"""A slider between a fixed guide and a slot that crosses it, with friction in both: what yoke and trammel share."""

from typing import NamedTuple

import numpy as np

from cranktrain.linkage.forces.conditions import Friction
from cranktrain.linkage.forces.guide import Guided, friction_force
from cranktrain.linkage.forces.wrench import Wrench
from cranktrain.motion import Array


class CrossingFriction(NamedTuple):
    """Friction of a slider in its guide along x, and of the block in its slot, in the sense of the slot's direction."""

    guide: Friction
    slot: Friction


class CrossingLoads(NamedTuple):
    """What block and slider bear but for their joints: about their pin, a yoke about where its slot meets the guide."""

    block: Wrench
    slider: Wrench


class CrossingReactions(NamedTuple):
    """Wrenches on the block of what drives it, of the block on the slider, of the guide on the slider.

    The first two are about the pin. The guide's: friction along x, normal force along y, and a moment about the pin, of
    a yoke about where its slot meets the guide.
    """

    block: Wrench
    slider: Wrench
    guide: Wrench


class Turning(NamedTuple):
    """Moment of the guide about the slider's pin without the slot's force [N·m]; that force's place along the slot [m].

    Of a slider whose pin is the block's own the place is 0.
    """

    moment: Array
    place: Array


class CrossingForces(NamedTuple):
    """Forces on the slider: of the slot along x and y; of the guide, friction along x and normal force along y. [N]"""

    x: Array
    y: Array
    drag: Array
    normal: Array


def crossing_forces(
    cos: Array, sin: Array, load: Wrench, turning: Turning, friction: CrossingFriction
) -> CrossingForces:
    """Forces that hold a slider where a slot crosses its guide.

    Parameters
    ----------
    cos, sin : Array, broadcastable to (..., n)
        Of the slot's direction from the guide's.
    load : Wrench, shape (..., n)
        Of the slider; its force counts.
    turning : Turning, fields broadcastable to (..., n)
        Counts where the guide has a length.
    friction : CrossingFriction, fields broadcastable to (..., n)
        The slot's sense is that of the block along it, as the slider sees it.

    Returns
    -------
    CrossingForces, shape (..., n)
        NaN where friction wedges the slider: where there are loads for which two forces would hold it, or none.

    Notes
    -----
    The block's force leans from the slot's normal by κ = μσ of the slot, one way or the other by the side on which it
    presses: a slot of slope (cos ± κ sin)/(sin ∓ κ cos) without friction. If what the block does when it presses to the
    left agrees with that it is right, else the other is. docs/theory/forces, eqs. (13.18), (13.19) and (13.46).
    """
    lean = friction.slot.coefficient * friction.slot.sense
    left = sin - lean * cos
    right = sin + lean * cos
    slope_left = (cos + lean * sin) / left
    slope_right = (cos - lean * sin) / right
    drag_left = _guide_drag(slope_left, turning.place / left, load, turning, friction.guide)
    drag_right = _guide_drag(slope_right, turning.place / right, load, turning, friction.guide)
    # +1 where pressing to the left agrees with itself, −1 where not; NaN where the slot wedges its block.
    side = np.sign((load.x + drag_left) * left) + 0.0 * np.sqrt(left * right)
    to_left = 0.5 + 0.5 * side
    to_right = 0.5 - 0.5 * side
    drag = to_left * drag_left + to_right * drag_right
    slope = to_left * slope_left + to_right * slope_right
    x = -(load.x + drag)
    y = -x * slope
    return CrossingForces(x, y, drag, -load.y - y)


def _guide_drag(slope: Array, place: Array, load: Wrench, turning: Turning, friction: Friction) -> Array:
    """Friction of the guide where the slot's force leans one way: N₁ = (X + f)/s, F_y = (X + f)c/s, C = C₀ − tN₁."""
    guided = Guided(-load.y - load.x * slope, turning.moment - load.x * place, -slope, -place)
    return friction_force(guided, friction)
