"""Orders of the torque as bars, and the stars of the cylinders' phases of the largest, on paper."""

import numpy as np

from cranktrain.language import said as _
from cranktrain.numerics.harmonics import ComplexArray
from cranktrain.saying.scales import scale_for
from cranktrain.viz.panel import OneDesign
from cranktrain.viz.paper.page import Box, Page
from cranktrain.viz.paper.panels import axes_in
from cranktrain.viz.paper.sketch import together
from cranktrain.viz.paper.style import COLOURS, INK, MUTED
from cranktrain.viz.sheets.torque.panels import STARS, is_constant, largest_stars, order_bars

ORDERS = 0.16
"""Share of the torque's orders in the height."""

_RADIUS, _NAME = 8.0, 12.0
"""Of a star, and of the names round it. [mm]"""

_SHORT = 3
"""Longer names of cylinders in one direction give way to how many they are."""

_ALIKE = 1e-6
"""Directions nearer to each other are one. [rad]"""

_CROWD = 12
"""With more directions only the first cylinder is named."""


def draw_orders(page: Page, shown: OneDesign, left: float, right: float, top: float) -> float:
    """Draw the amplitudes of the torque's orders, the major ones filled; give where the picture ends. [mm]

    Parameters
    ----------
    page : Page
    shown : OneDesign
    left, right, top : float
        [mm]

    Returns
    -------
    float
    """
    order, amplitude, is_major = order_bars(shown)
    last = float(order[-1])
    if not np.any(amplitude):
        page.heading(left, top - 3.0, _without_orders(shown).format(most=last))
        return top - 7.0
    height = ORDERS * page.height
    axes = axes_in(page, Box(left, top - 5.0 - height, right - left, height))
    colours = np.where(is_major, COLOURS["T"], "white").tolist()
    width = 0.7 * float(order[1] - order[0])
    scale = scale_for("N*m", float(np.max(amplitude)))
    axes.bar(order, scale.of(amplitude), width=width, color=colours, edgecolor=COLOURS["T"], linewidth=0.7)
    axes.set(xlim=(0.0, last + 0.5), xticks=np.arange(1.0, last + 0.5), ylim=(0.0, None))
    axes.grid(visible=False, axis="x")
    heading = _("Amplitude of the torque's orders, {unit}, over the order", unit=scale.label)
    page.heading(left, top - 3.0, heading)
    return top - 5.0 - height - 7.0


def _without_orders(shown: OneDesign) -> str:
    """Say why the torque has no orders: those of the mechanisms cancel, or none of them has any."""
    if is_constant(shown):
        return _("The torque is the same at every angle: it has no orders")
    return _("The orders of the torque up to {most:g} cancel")


def draw_stars(page: Page, shown: OneDesign, left: float, right: float, top: float) -> float:
    """Draw the phase stars of the largest orders; parameters as of `draw_orders`, gives where they end. [mm]"""
    stars = largest_stars(shown)
    if stars is None:
        return top
    page.heading(left, top - 3.0, _("Phase stars of the largest orders, by nominal firing"))
    names = shown.result.labels["cylinder"]
    middle = top - 8.0 - _NAME - 2.0
    for number, (order, length) in enumerate(zip(stars.order.tolist(), stars.length.tolist(), strict=True)):
        centre = (left + (number + 0.5) * (right - left) / STARS, middle)
        _draw_star(page, stars.vectors[number], names, centre)
        words = _("{order:g}: sum {sum:.2f} of {n}", order=order, sum=length, n=len(names))
        page.text(centre[0], middle - _NAME - 5.5, words, ha="center")
    return middle - _NAME - 8.0


def _draw_star(page: Page, star: ComplexArray, names: tuple[str, ...], centre: tuple[float, float]) -> None:
    """Draw one star: a line for each direction, the cylinders in it, and the sum of all as a thick line."""
    turn = np.linspace(0.0, 2 * np.pi, 91)
    page.paper.plot(centre[0] + _RADIUS * np.cos(turn), centre[1] + _RADIUS * np.sin(turn), color=MUTED, lw=0.4)
    # Up is the phase of the first to fire; phases that lag turn clockwise.
    rays = np.stack([-star.imag, star.real])
    groups = together(rays, _ALIKE)
    for place, of in enumerate(groups):
        x, y = rays[:, of[0]].tolist()
        page.paper.plot((centre[0], centre[0] + _RADIUS * x), (centre[1], centre[1] + _RADIUS * y), color=INK, lw=0.9)
        page.paper.plot([centre[0] + _RADIUS * x], [centre[1] + _RADIUS * y], "o", ms=2.6, color=INK)
        said = ",".join(names[i] for i in of)
        words = said if len(said) <= _SHORT else f"×{len(of)}"
        if not place or len(groups) <= _CROWD:
            page.text(centre[0] + _NAME * x, centre[1] + _NAME * y, words, ha="center", va="center_baseline")
