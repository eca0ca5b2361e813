"""A fixed guide as it is clicked, through a place in a direction, and typed, beside the nearest fixed point."""

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np

from cranktrain.language import N_, _
from cranktrain.mechanisms.by_hand import Click, Clicked
from cranktrain.mechanisms.chain.adding.shown import ShownChain, degrees_text, place_of, refused, round_direction
from cranktrain.mechanisms.chain.groups import SHAFT
from cranktrain.motion import Array
from cranktrain.numerics.ties import smallest_of

WAY = Click(N_("In which direction does its guide run?"), {"ground": N_("guide")})
"""Asks for the direction of a guide through the place of the click before."""


class ClickedGuide(NamedTuple):
    """A guide as it is typed.

    Attributes
    ----------
    keys : mapping of str to str
        Of its table.
    along, across : Array, shape (2,)
        Unit vectors: its direction, and to the left of that.
    beside : float
        How far it is from the shaft's centre, to its left. [m]
    """

    keys: Mapping[str, str]
    along: Array
    across: Array
    beside: float

    def foot(self, place: Array) -> Array:
        """Nearest place on the guide, shape (2,). [m]"""
        return self.along * (self.along @ place) + self.across * self.beside


def clicked_guide(shown: ShownChain, at: Array, toward: Clicked) -> ClickedGuide:
    """Give the guide through a place toward another."""
    degrees = round_direction(float(np.degrees(clicked_direction(shown, at, toward))))
    along = np.array([np.cos(np.radians(degrees)), np.sin(np.radians(degrees))])
    across = np.array([-along[1], along[0]])
    offsets = {name: float(across @ (at - place_of(shown.made[name]))) for name in (SHAFT, *shown.spec.fixed)}
    through = smallest_of(offsets, lambda name: abs(offsets[name]))
    offset = shown.typing.beside(offsets[through])
    keys = {"through": through, "direction": degrees_text(degrees), "offset": shown.typing.text(offset)}
    return ClickedGuide(keys, along, across, float(across @ place_of(shown.made[through])) + offset)


def clicked_direction(shown: ShownChain, at: Array, toward: Clicked) -> float:
    """Direction from a place to a click, from x toward y. [rad]"""
    there = shown.place(toward)
    if shown.typing.is_there(at, there):
        raise refused(_("the click says no direction, so near to the pin"))
    return float(np.arctan2(there[1] - at[1], there[0] - at[0]))
