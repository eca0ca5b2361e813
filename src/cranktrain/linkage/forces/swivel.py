"""Reactions of an RPR group: a slider on a pin, in a guide about a pivot, with friction in the guide."""

from typing import NamedTuple

from cranktrain.linkage.forces.conditions import Friction
from cranktrain.linkage.forces.guide import Guided, friction_force
from cranktrain.linkage.forces.wrench import Wrench
from cranktrain.linkage.legs import OnLine
from cranktrain.linkage.swivel import Swivel
from cranktrain.linkage.vectors import Vector, between, direction, dot, rotated
from cranktrain.motion import ZERO, Link, Point


class SwivelLoads(NamedTuple):
    """What slider and guide bear but for their joints: the slider's about its pin, the guide's about the pivot."""

    slider: Wrench
    guide: Wrench


class SwivelReactions(NamedTuple):
    """Wrenches of the driving pin on the slider, of the slider on the guide (about the pin), of the pivot on the guide.

    Only the slider's has a moment: it turns with its guide.
    """

    pin: Wrench
    slider: Wrench
    pivot: Wrench


def swivel_slider_link(pin: Point, guide: Link) -> Link:
    """Slider as a link, from its pin in the guide's direction, with which it turns."""
    return Link(pin, guide.angle, guide.cos, guide.sin)


def swivel_reactions(held: OnLine, geometry: Swivel, loads: SwivelLoads, friction: Friction) -> SwivelReactions:
    """Reactions of a slider and the guide that follows it.

    Parameters
    ----------
    held : OnLine, shape (..., n)
        The guide and the driving pin.
    geometry : Swivel, fields broadcastable to (..., 1)
    loads : SwivelLoads, shape (..., n)
    friction : Friction, fields broadcastable to (..., n)
        Its sense is that of the slider along the guide's direction.

    Returns
    -------
    SwivelReactions, shape (..., n)
        NaN where the guide cannot close, or friction wedges the slider.

    Notes
    -----
    With ρ from the pivot's foot to the slider and e the guide's offset, N₀ = −(M_guide + M_slider)/ρ on the guide, to
    its left, and N = N₀ + f e/ρ, f = μσ max(|N|, 2|C|/b). docs/theory/forces, eqs. (13.15) to (13.17), (13.44).
    """
    guide, pin = held
    reach = dot(direction(guide), between(guide.origin, pin))
    frictionless = -(loads.guide.moment + loads.slider.moment) / reach
    lever = -geometry.offset / reach
    on_slider = friction_force(Guided(frictionless, loads.slider.moment, lever, ZERO), friction)
    normal = frictionless + lever * on_slider
    force = rotated(Vector(-on_slider, normal), guide.cos, guide.sin)
    zero = 0.0 * force.x
    return SwivelReactions(
        Wrench(force.x - loads.slider.x, force.y - loads.slider.y, zero),
        Wrench(force.x, force.y, zero + loads.slider.moment),
        Wrench(-force.x - loads.guide.x, -force.y - loads.guide.y, zero),
    )
