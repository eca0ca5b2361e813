"""Curves of the torque on the shaft, the amplitudes of its orders, and the stars of the cylinders' phases."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.language import said as _
from cranktrain.layout.crank_angle import orders
from cranktrain.motion import Array
from cranktrain.numerics.ties import falling
from cranktrain.questions.torque.stars import PhaseStars, phase_stars
from cranktrain.saying.scales import scale_for
from cranktrain.viz.figures import figure
from cranktrain.viz.panel import Curve, OneDesign, Panel, closed

STARS = 3
"""How many of the largest orders have a star."""

_NOTHING = 1e-9
"""An amplitude below this part of a cylinder's largest torque is none."""


class OrderBars(NamedTuple):
    """Orders of the torque, their amplitudes, 0 where they are rounding alone [N·m], and which all cylinders share."""

    order: Array
    amplitude: Array
    is_major: NDArray[np.bool_]


def torque_panel(shown: OneDesign) -> Panel:
    """Torque of all mechanisms together and its mean over the cycle, and of several mechanisms each one's."""
    torque = shown("machine_torque")
    mean = float(shown("mean_torque"))
    each = [Curve(closed(values), "each", "T") for values in shown("mechanism_torque") if np.any(values)]
    whole = Curve(closed(torque), "whole", "T", r"T_\Sigma")
    average = Curve(np.full_like(whole.values, mean), "mean", "F", "T_m")
    curves = (*(each if len(each) > 1 else ()), whole, average)
    scale = scale_for("N*m", float(np.nanmax([np.max(np.abs(curve.values)) for curve in curves])))
    title = _("Torque on the shaft, mean {mean}", mean=figure(float(scale.of(mean))))
    return Panel(title, "N*m", shown.cycle, curves)


def order_bars(shown: OneDesign) -> OrderBars:
    """Amplitudes of the torque's orders; without a firing order none is shared."""
    order = orders(shown.result.grid.cycle)
    amplitude = np.nan_to_num(shown("torque_order_amplitude"))
    largest = np.max(np.abs(shown("mechanism_torque")))
    has_stars = shown.has("phase_star_sum")
    is_major = phase_stars(order, _firing(shown)).is_major if has_stars else np.zeros(order.shape, dtype=np.bool_)
    return OrderBars(order, np.where(amplitude > _NOTHING * largest, amplitude, 0.0), is_major)


def is_constant(shown: OneDesign) -> bool:
    """Whether the torque of every mechanism is the same all round."""
    torque = shown("mechanism_torque")
    return bool(np.max(np.ptp(torque, axis=-1)) <= _NOTHING * np.max(np.abs(torque)))


def largest_stars(shown: OneDesign) -> PhaseStars | None:
    """Phase stars of the largest orders, by nominal firing; none without a firing order, or of one cylinder."""
    if not shown.has("phase_star_sum") or len(shown("firing_angle")) < 2:
        return None
    bars = order_bars(shown)
    largest = np.array(falling(bars.amplitude)[:STARS], dtype=np.intp)
    order = bars.order[largest[bars.amplitude[largest] > 0.0]]
    return phase_stars(order, _firing(shown)) if order.size else None


def _firing(shown: OneDesign) -> Array:
    return np.deg2rad(shown("firing_angle"))
