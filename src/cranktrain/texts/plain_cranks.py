"""Mechanisms of which the steam engine's text speaks: crank and rod of a piston or, as an eccentric, of a valve."""

from typing import TYPE_CHECKING

from cranktrain.mechanisms.slider_crank import SliderCrank
from cranktrain.motion import Array

if TYPE_CHECKING:
    from cranktrain.mechanisms.eccentric import Eccentric

PLAIN = ("slider_crank", "eccentric")
"""Their kinds."""


def plain_crank(geometry: "SliderCrank | Eccentric") -> SliderCrank:
    """Give the slider-crank that it is, its angle counted from where its own crank points along the line of stroke.

    Of an eccentric R is the eccentricity e, and λ = e/l.
    """
    return SliderCrank(geometry.crank_radius, geometry.rod_length, geometry.offset)


def own_angle(angle: Array, geometry: "SliderCrank | Eccentric") -> Array:
    """Angle of its own crank from the line of stroke, from the kernel's; both in rad."""
    return angle + getattr(geometry, "ahead", 0.0)
