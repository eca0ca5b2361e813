"""Curves of a pumping unit: position and torque factor, torques over the crank angle; the card over the position."""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.language import said as _
from cranktrain.motion import Array
from cranktrain.viz.panel import Curve, OneDesign, Panel, closed

_BEYOND = 0.35
"""How far beyond the card permissible loads are drawn, in parts of the card's height and of its largest load."""


class CardCurves(NamedTuple):
    """Card and permissible loads over the position of the rod; loads beyond the drawing are NaN. [1, N]

    Attributes
    ----------
    position, load : Array, shape (n,)
        Once round the turn.
    up, down : tuple of Array
        Position and permissible load of each stroke, rising from the lowest position.
    low, high : float
        Between which loads are drawn.
    """

    position: Array
    load: Array
    up: tuple[Array, Array]
    down: tuple[Array, Array]
    low: float
    high: float


def pumping_panels(shown: OneDesign) -> Iterator[Panel]:
    """Collect the curves over the crank angle: position, torque factor, torques with the rating."""
    angle = shown.cycle
    position = Curve(closed(shown("rod_position")), "first", "s", "PR")
    yield Panel(_("Position of the polished rod, 0 lowest, 1 highest"), "1", angle, (position,), "PR")
    factor = Curve(closed(shown("torque_factor")), "first", "v", "TF")
    yield Panel(_("Torque factor"), "m", angle, (factor,), "TF")
    yield Panel(_("Torque at the crank"), "N*m", angle, tuple(_torques(shown)))


def _torques(shown: OneDesign) -> Iterator[Curve]:
    """Net torque, its parts, and the rating where there is one."""
    net = closed(shown("gearbox_torque"))
    yield Curve(net, "whole", "T", "T")
    yield Curve(closed(shown("rod_torque")), "side", "s", "T_W")
    yield Curve(closed(shown("counterbalance_torque")), "resultant", "j", "T_M")
    rated = rated_torque(shown)
    if np.isfinite(rated):
        yield Curve(np.full(net.size, rated), "formula", "F", "T_r")


def rated_torque(shown: OneDesign) -> float:
    """Rating of the gearbox; NaN where none is given. [N·m]"""
    return largest_torque(shown) / float(shown("torque_share"))


def largest_torque(shown: OneDesign) -> float:
    """Largest torque of either sign. [N·m]"""
    peaks = (shown("upstroke_peak"), shown("downstroke_peak"), -shown("least_gearbox_torque"))
    return max(map(float, peaks))


def card_curves(shown: OneDesign) -> CardCurves:
    """Card and permissible loads of one design."""
    position, load = shown("rod_position"), shown("polished_rod_load")
    allowed, is_up = shown("permissible_load"), shown("torque_factor") > 0
    beyond = _BEYOND * max(float(np.ptp(load)), float(np.max(np.abs(load))) / 2)
    low, high = float(np.min(load)) - beyond, float(np.max(load)) + beyond
    inside = np.where((allowed > low) & (allowed < high), allowed, np.nan)
    return CardCurves(
        closed(position), closed(load), _stroke(position, inside, is_up), _stroke(position, inside, ~is_up), low, high
    )


def _stroke(position: Array, allowed: Array, is_own: NDArray[np.bool_]) -> tuple[Array, Array]:
    """Permissible loads of one stroke by rising position."""
    own = np.flatnonzero(is_own)
    order = own[np.argsort(position[own])]
    return position[order], allowed[order]
