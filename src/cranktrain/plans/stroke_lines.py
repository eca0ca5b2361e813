"""Lines on which pins slide: places along and across them, in whatever unit of length their points have."""

from typing import NamedTuple

import numpy as np

from cranktrain.motion import Array


class Along(NamedTuple):
    """A line of stroke: its foot is nearest the shaft, and points are so far along it and across it."""

    foot: Array
    along: Array

    @property
    def across(self) -> Array:
        """Direction across the line, anticlockwise from it."""
        return np.array([-self.along[1], self.along[0]])

    def at(self, along: float, across: float = 0.0) -> Array:
        """Give the point."""
        return self.foot + along * self.along + across * self.across

    def path(self, *places: tuple[float, float]) -> Array:
        """Give points along and across the line one after the other, shape (2, n)."""
        return np.stack([self.at(*place) for place in places], axis=1)

    def block(self, span: tuple[float, float], half: float) -> Array:
        """Give the corners of a rectangle along the line, as far to each side, shape (2, 4)."""
        start, end = span
        return self.path((start, -half), (end, -half), (end, half), (start, half))

    def place(self, points: Array) -> Array:
        """Say how far along the line points are, shape (2,) or (2, n)."""
        return self.along @ points - self.along @ self.foot


def guide_line(direction: Array | float, pin: Array, shaft: Array | float = 0.0) -> Along:
    """Line on which a guide of a direction [rad] leads a pin; its foot is nearest the shaft."""
    along = unit(direction).reshape(2)
    return Along(pin - np.dot(pin - shaft, along) * along, along)


def unit(direction: Array | float) -> Array:
    """Vector of length 1 in a direction from X [rad], shape (2, ...)."""
    return np.array([np.cos(direction), np.sin(direction)])
