"""Curves of the torque on the shaft, the amplitudes of its orders, and the stars of the cylinders' phases."""

import numpy as np

from cranktrain.language import _
from cranktrain.layout.crank_angle import orders
from cranktrain.numerics.harmonics import TURN
from cranktrain.numerics.ties import falling
from cranktrain.panels.design import OneDesign, closed
from cranktrain.panels.parts import Stars
from cranktrain.panels.shapes import Bars, Curve, Panel, Rays, peak
from cranktrain.questions.torque.orders import PhaseStarSums
from cranktrain.saying.amounts import BareAmount, UnitLabel

STARS = 3
"""How many of the largest orders have a star."""

_NOTHING = 1e-9
"""An amplitude below this part of a cylinder's largest torque is none."""


def torque_panel(shown: OneDesign) -> Panel:
    """Torque of all mechanisms together and its mean over the cycle, and of several mechanisms each one's."""
    torque = shown("machine_torque")
    mean = float(shown("mean_torque"))
    each = [Curve(closed(values), "each", "T") for values in shown("mechanism_torque") if np.any(values)]
    whole = Curve(closed(torque), "whole", "T", r"T_\Sigma")
    average = Curve(np.full_like(whole.values, mean), "mean", "F", "T_m")
    curves = (*(each if len(each) > 1 else ()), whole, average)
    most = max(peak(curve.values) for curve in curves)
    title = _("Torque on the shaft, mean {mean}", mean=BareAmount(mean, "N*m", most))
    return Panel(title, "N*m", shown.cycle, curves)


def order_bars(shown: OneDesign) -> Bars:
    """Amplitudes of the torque's orders, filled where all cylinders share one; without a firing order none is shared.

    What is rounding alone is 0; where all are, its title says why, and there are no bars.
    """
    order = orders(shown.result.grid.cycle)
    amplitude = np.nan_to_num(shown("torque_order_amplitude"))
    largest = np.max(np.abs(shown("mechanism_torque")))
    sums = shown.result.get(PhaseStarSums)
    is_major = np.zeros(order.shape, dtype=np.bool_) if sums is None else sums.stars.is_major[shown.design]
    amplitude = np.where(amplitude > _NOTHING * largest, amplitude, 0.0)
    title = _(
        "Amplitude of the torque's orders, {unit}, over the order", unit=UnitLabel("N*m", float(np.max(amplitude)))
    )
    if not np.any(amplitude):
        same = _("The torque is the same at every angle: it has no orders")
        title = same if _is_constant(shown) else _("The orders of the torque up to {most:g} cancel", most=order[-1])
    return Bars(title, "N*m", np.zeros(order.shape), amplitude, is_major, order)


def _is_constant(shown: OneDesign) -> bool:
    """Whether the torque of every mechanism is the same all round."""
    torque = shown("mechanism_torque")
    return bool(np.max(np.ptp(torque, axis=-1)) <= _NOTHING * np.max(np.abs(torque)))


def largest_stars(shown: OneDesign, bars: Bars) -> Stars | None:
    """Phase stars of the largest orders among bars, by nominal firing; none without a firing order, or of one cylinder.

    Up is the phase of the first to fire; phases that lag turn clockwise.
    """
    sums = shown.result.get(PhaseStarSums)
    if sums is None or len(shown("firing_angle")) < 2:
        return None
    stars, names = sums.stars, shown.result.labels["cylinder"]
    vectors, length = stars.vectors[shown.design], stars.length[shown.design]
    largest = [i for i in falling(bars.high)[:STARS] if bars.high[i] > 0.0 and np.any(vectors[i])]
    if not largest:
        return None
    rays = (
        Rays(
            _("{order:g}: sum {sum:.2f} of {n}", order=float(stars.order[i]), sum=float(length[i]), n=len(names)),
            TURN / 4 + np.angle(vectors[i]),
            np.abs(vectors[i]),
            names,
        )
        for i in largest
    )
    return Stars(_("Phase stars of the largest orders, by nominal firing"), tuple(rays))
