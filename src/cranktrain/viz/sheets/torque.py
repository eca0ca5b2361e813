"""Orders of the torque as bars, and the stars of the cylinders' phases of the largest."""

import numpy as np
from numpy.typing import NDArray

from cranktrain.language import _
from cranktrain.layout.crank_angle import orders
from cranktrain.motion import Array
from cranktrain.questions.torque.stars import PhaseStars, phase_stars
from cranktrain.viz.paper.page import Page
from cranktrain.viz.paper.style import COLOURS, INK, MUTED
from cranktrain.viz.sheets.panels import OneDesign, prepare

_STARS = 3
"""How many of the largest orders have a star."""

_RADIUS, _NAME = 8.0, 12.0
"""Of a star, and of the names round it. [mm]"""

_SHORT = 3
"""Longer names of cylinders in one direction give way to how many they are."""

_ALIKE = 1e-6
"""Directions nearer to each other are one. [rad]"""

_NOTHING = 1e-9
"""An amplitude below this part of a cylinder's largest torque is none."""

_CROWD = 12
"""With more directions only the first cylinder is named."""


def draw_orders(page: Page, shown: OneDesign, place: tuple[float, float, float]) -> float:
    """Draw the amplitudes of the torque's orders, the major ones filled; give where the picture ends. [mm]

    Parameters
    ----------
    page : Page
    shown : OneDesign
    place : (left, right, top)
        [mm]

    Returns
    -------
    float
    """
    left, right, top = place
    order = orders(shown.result.grid.cycle)
    amplitude = _amplitudes(shown)
    if not np.any(amplitude):
        page.heading(left, top - 3.0, _("The orders of the torque up to {most:g} cancel").format(most=order[-1]))
        return top - 7.0
    height = 0.16 * page.height
    axes = page.axes(left, top - 5.0 - height, right - left, height)
    prepare(axes)
    major = _is_major(shown)
    colours = [COLOURS["T"] if is_filled else "white" for is_filled in major]
    width = 0.7 * float(order[1] - order[0])
    axes.bar(order, amplitude, width=width, color=colours, edgecolor=COLOURS["T"], linewidth=0.7)
    axes.set(xlim=(0.0, float(order[-1]) + 0.5), xticks=np.arange(1.0, float(order[-1]) + 0.5), ylim=(0.0, None))
    axes.grid(visible=False, axis="x")
    page.heading(left, top - 3.0, _("Amplitude of the torque's orders, N·m, over the order"))
    return top - 5.0 - height - 7.0


def _amplitudes(shown: OneDesign) -> Array:
    """Amplitudes of the orders, 0 where they are rounding alone. [N·m]"""
    amplitude = np.nan_to_num(shown("torque_order_amplitude"))
    return np.where(amplitude > _NOTHING * np.max(np.abs(shown("mechanism_torque"))), amplitude, 0.0)


def _is_major(shown: OneDesign) -> NDArray[np.bool_]:
    """Which orders all cylinders share; none where no firing order is known."""
    if not shown.has("phase_star_sum"):
        return np.zeros(len(shown("torque_order_amplitude")), dtype=np.bool_)
    return _stars(shown, orders(shown.result.grid.cycle)).is_major


def _stars(shown: OneDesign, order: Array) -> PhaseStars:
    """Phase stars of some orders, by nominal firing."""
    return phase_stars(order, np.deg2rad(shown("firing_angle")))


def draw_stars(page: Page, shown: OneDesign, place: tuple[float, float, float]) -> float:
    """Draw the phase stars of the largest orders; give where they end. [mm]

    Parameters
    ----------
    page : Page
    shown : OneDesign
    place : (left, right, top)
        [mm]

    Returns
    -------
    float
    """
    left, right, top = place
    if not shown.has("phase_star_sum") or len(shown("firing_angle")) < 2:
        return top
    amplitude = _amplitudes(shown)
    largest = np.argsort(-amplitude, kind="stable")[:_STARS]
    largest = largest[amplitude[largest] > 0.0]
    if not len(largest):
        return top
    order = orders(shown.result.grid.cycle)[largest]
    stars = _stars(shown, order)
    page.heading(left, top - 3.0, _("Phase stars of the largest orders, by nominal firing"))
    names = shown.result.labels["cylinder"]
    middle = top - 8.0 - _NAME - 2.0
    for number, (k, star, length) in enumerate(zip(order.tolist(), stars.vectors, stars.length.tolist(), strict=True)):
        centre = (left + (number + 0.5) * (right - left) / _STARS, middle)
        _draw_star(page, star, names, centre)
        words = _("{order:g}: sum {sum:.2f} of {n}").format(order=k, sum=length, n=len(names))
        page.text(centre[0], middle - _NAME - 5.5, words, ha="center")
    return middle - _NAME - 8.0


def _draw_star(page: Page, star: Array, names: tuple[str, ...], centre: tuple[float, float]) -> None:
    """Draw one star: a line for each direction, the cylinders in it, and the sum of all as a thick line."""
    groups: list[tuple[complex, list[str]]] = []
    for vector, name in zip(star.tolist(), names, strict=True):
        together = next((members for other, members in groups if abs(other - vector) < _ALIKE), None)
        if together is None:
            groups.append((vector, [name]))
        else:
            together.append(name)
    turn = np.linspace(0.0, 2 * np.pi, 91)
    page.paper.plot(centre[0] + _RADIUS * np.cos(turn), centre[1] + _RADIUS * np.sin(turn), color=MUTED, lw=0.4)
    for place, (vector, members) in enumerate(groups):
        # Up is the phase of the first to fire; phases that lag turn clockwise.
        x, y = -vector.imag, vector.real
        page.paper.plot((centre[0], centre[0] + _RADIUS * x), (centre[1], centre[1] + _RADIUS * y), color=INK, lw=0.9)
        page.paper.plot([centre[0] + _RADIUS * x], [centre[1] + _RADIUS * y], "o", ms=2.6, color=INK)
        said = ",".join(members)
        words = said if len(said) <= _SHORT else f"×{len(members)}"
        if place and len(groups) > _CROWD:
            continue
        page.text(centre[0] + _NAME * x, centre[1] + _NAME * y, words, ha="center", va="center_baseline")
