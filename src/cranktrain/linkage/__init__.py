"""Kernels: the driver and the groups that hang on it, exact and elementwise, with first and second derivatives.

A kernel takes its driver (an angle, a point, a link) and its geometry, a NamedTuple of numbers or arrays, and gives a
NamedTuple of coefficients. It has no state, no checks, no units; what cannot close is NaN.
"""

from cranktrain.linkage.compile import compiled
from cranktrain.linkage.crank import Crank, crank
from cranktrain.linkage.pin import Ends, Pin, PinMotion, pin, pin_gap
from cranktrain.linkage.point import LinkPoint, fixed, point, turned
from cranktrain.linkage.slide import AHEAD, Slide, SlideMotion, slide, slide_gap

__all__ = [
    "AHEAD",
    "Crank",
    "Ends",
    "LinkPoint",
    "Pin",
    "PinMotion",
    "Slide",
    "SlideMotion",
    "compiled",
    "crank",
    "fixed",
    "pin",
    "pin_gap",
    "point",
    "slide",
    "slide_gap",
    "turned",
]
