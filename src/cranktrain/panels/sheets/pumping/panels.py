"""Curves of a pumping unit: position and torque factor, torques over the crank angle; the card over the position."""

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from cranktrain.language import _
from cranktrain.motion import Array
from cranktrain.panels.design import OneDesign, closed
from cranktrain.panels.shapes import Curve, Panel
from cranktrain.saying.amounts import UnitLabel

_BEYOND = 0.35
"""How far beyond the card permissible loads are drawn, in parts of the card's height and of its largest load."""


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


def card_panel(shown: OneDesign) -> Panel:
    """Card over the position of the rod, once round the turn, and where there is a rating the permissible loads.

    Those of a stroke rise from the lowest position, and are NaN beyond what is drawn.
    """
    position, load, is_up = shown("rod_position"), shown("polished_rod_load"), shown("torque_factor") > 0
    beyond = _BEYOND * max(float(np.ptp(load)), float(np.max(np.abs(load))) / 2)
    low, high = float(np.min(load)) - beyond, float(np.max(load)) + beyond
    curves = [Curve(closed(load), "card", "F", name=_("card"))]
    if np.isfinite(rated_torque(shown)):
        allowed = shown("permissible_load")
        inside = np.where((allowed > low) & (allowed < high), allowed, np.nan)
        up, down = _rising(position, is_up), _rising(position, ~is_up)
        curves += [
            Curve(inside[up], "side", "T", name=_("most going up"), across=position[up]),
            Curve(inside[down], "resultant", "s", name=_("least going down"), across=position[down]),
        ]
    title = _("Load at the polished rod over its position, {unit}", unit=UnitLabel("N", high))
    return Panel(title, "N", closed(position), tuple(curves), across_unit="1", limits=(low, high), reach=(-0.02, 1.02))


def _rising(position: Array, is_own: NDArray[np.bool_]) -> NDArray[np.intp]:
    """Places of one stroke by rising position."""
    own = np.flatnonzero(is_own)
    return own[np.argsort(position[own])]
