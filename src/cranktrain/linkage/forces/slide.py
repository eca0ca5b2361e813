"""Reactions of an RRP group: a rod and a slider on a fixed guide along x, with friction in the guide."""

from typing import NamedTuple

from cranktrain.linkage.forces.conditions import Friction
from cranktrain.linkage.forces.guide import Guided, friction_force
from cranktrain.linkage.forces.wrench import Wrench
from cranktrain.linkage.slide import Slide
from cranktrain.motion import ONE, ZERO, Array, Coefficient, Link, Point


class SlideLoads(NamedTuple):
    """What rod and slider bear but for their joints: each about its first pin, the slider's being the rod's second."""

    rod: Wrench
    slider: Wrench


class SlideReactions(NamedTuple):
    """Wrenches of the driving pin on the rod, of the rod on the slider, of the guide on the slider.

    The guide's: friction along x, normal force along y, both through the slider's pin, and a moment.
    """

    pin: Wrench
    joint: Wrench
    guide: Wrench


def slider_link(slider: Coefficient, offset: Array) -> Link:
    """Slider on a guide along x as a link that does not turn, from its pin along the guide."""
    still = Coefficient(ZERO, ZERO, ZERO)
    return Link(Point(slider, Coefficient(offset, ZERO, ZERO)), still, ONE, ZERO)


def slide_reactions(rod: Link, geometry: Slide, loads: SlideLoads, friction: Friction) -> SlideReactions:
    """Reactions of a rod and its slider.

    Parameters
    ----------
    rod : Link, shape (..., n)
        From the driving pin to the slider's.
    geometry : Slide, fields broadcastable to (..., 1)
    loads : SlideLoads, shape (..., n)
    friction : Friction, fields broadcastable to (..., n)

    Returns
    -------
    SlideReactions, shape (..., n)
        NaN where the rod cannot reach, or friction wedges the slider.

    Notes
    -----
    Moments about the driving pin give the rod's force across itself, M/l; with X, Y the slider's load and θ the rod's
    direction, N₀ = X tan θ − M/(l cos θ) − Y, N = N₀ + f tan θ, f = −μσ max(|N|, 2|C|/b) with the guide's moment C
    about its middle. docs/theory/forces, eqs. (13.8) to (13.12) and (13.44).
    """
    load = loads.slider
    slope = rod.sin / rod.cos
    across = loads.rod.moment / (geometry.rod_length * rod.cos)
    frictionless = load.x * slope - across - load.y
    zero = 0.0 * frictionless
    drag = friction_force(Guided(frictionless, -load.moment, slope, ZERO), friction)
    x = -load.x - drag
    y = x * slope + across
    return SlideReactions(
        Wrench(x - loads.rod.x, y - loads.rod.y, zero),
        Wrench(x, y, zero),
        Wrench(drag, frictionless + slope * drag, zero - load.moment),
    )
