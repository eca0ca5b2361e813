"""How evenly a machine runs, by its work and its inertia at the points of panels; plain loops, which compile."""

import numpy as np

from cranktrain.motion import Array
from cranktrain.study.cycle.nodes import PanelNodes
from cranktrain.study.cycle.panels import Panels
from cranktrain.study.cycle.tops import highest

_STEPS = 40
_SETTLED = 1e-13
_LEAST = 0.1
"""Of the mean speed: how slowly a shaft may turn for its points to show how it does."""


def mean_of(values: Array, panels: Panels, count: int, nodes: PanelNodes, cycle: float) -> float:
    """Mean of a curve over the cycle."""
    total = 0.0
    for panel in range(count):
        first, row = panels.first[panel], panels.size[panel]
        own, weight = values[first : first + nodes.size[row]], nodes.weight[row]
        part = 0.0
        for node in range(nodes.size[row]):
            part += weight[node] * own[node]
        total += 0.5 * panels.width[panel] * part
    return total / cycle


def integral_of(values: Array, mean: float, panels: Panels, count: int, nodes: PanelNodes, integral: Array) -> None:
    """Fill `integral` with that of a curve less its mean, from the first panel on."""
    before = 0.0
    for panel in range(count):
        first, row, half = panels.first[panel], panels.size[panel], 0.5 * panels.width[panel]
        size = nodes.size[row]
        own, place = values[first : first + size], nodes.place[row]
        for node in range(size):
            part, weights = 0.0, nodes.integral[row, node]
            for other in range(size):
                part += weights[other] * own[other]
            integral[first + node] = before + half * (part - mean * (place[node] + 1.0))
        before = integral[first + size - 1]


def energy_for(
    work: Array,
    inertia: Array,
    added: float,
    wanted: float,
    panels: Panels,
    count: int,
    nodes: PanelNodes,
    cycle: float,
) -> float:
    """Kinetic energy beside the excess work at which the mean speed over time is as wanted; NaN where it stops.

    Parameters
    ----------
    work, inertia : Array, shape (point,)
        A and J of the moving parts. [J, kg·m²]
    added : float
        Inertia of the flywheel. [kg·m²]
    wanted : float
        [rad/s]

    Notes
    -----
    With ω² = 2(A + E)/J the mean of 1/ω falls with E, and its slope is −⟨1/(ω³J)⟩; docs/theory/evenness, eqs. (17.4)
    and (17.5).
    """
    lowest, n_points = np.inf, panels.first[count - 1] + nodes.size[panels.size[count - 1]]
    for point in range(n_points):
        lowest = min(lowest, work[point])
    energy = 0.5 * wanted * wanted * (mean_of(inertia, panels, count, nodes, cycle) + added)
    energy -= mean_of(work, panels, count, nodes, cycle)
    floor = -lowest
    energy = max(energy, floor + 1e-3 * abs(energy))
    for _step in range(_STEPS):
        late, steep = 0.0, 0.0
        for panel in range(count):
            first, row = panels.first[panel], panels.size[panel]
            size, weight = nodes.size[row], nodes.weight[row]
            own_work, own_inertia = work[first : first + size], inertia[first : first + size]
            own_late, own_steep = 0.0, 0.0
            for node in range(size):
                carried = own_inertia[node] + added
                slowness = np.sqrt(carried / (2.0 * (own_work[node] + energy)))
                own_late += weight[node] * slowness
                own_steep += weight[node] * (slowness * slowness * slowness / carried)
            late += 0.5 * panels.width[panel] * own_late
            steep += 0.5 * panels.width[panel] * own_steep
        # by the square of the mean speed, which is nearly a straight line over the energy
        slow = late / cycle
        move = 0.5 * slow * ((slow * wanted) * (slow * wanted) - 1.0) * (cycle / steep)
        move = max(move, 0.5 * (floor - energy))
        energy += move
        if not abs(move) > _SETTLED * abs(energy):
            return energy
    return np.nan


def speeds_at(work: Array, inertia: Array, added: float, energy: float, n_points: int, square: Array) -> float:
    """Fill `square` with that of the speed at all points, and give its least. [rad²/s²]"""
    least = np.inf
    for point in range(n_points):
        square[point] = 2.0 * (work[point] + energy) / (inertia[point] + added)
        least = min(least, square[point])
    return least


def fluctuation_of(
    work: Array,
    inertia: Array,
    added: float,
    wanted: float,
    panels: Panels,
    count: int,
    nodes: PanelNodes,
    cycle: float,
    square: Array,
    room: Array,
    zero: float,
    found: Array,
) -> bool:
    """Largest and smallest speed with a flywheel, at a mean speed over time.

    Parameters are those of `energy_for`; `square`, shape (point,), and `room` are to work in.

    Returns
    -------
    bool
        Whether it is known; then `found` holds the largest speed and its angle, the smallest and its angle, and the
        mean over the crank angle. [rad/s, rad]
    """
    energy = energy_for(work, inertia, added, wanted, panels, count, nodes, cycle)
    n_points = panels.first[count - 1] + nodes.size[panels.size[count - 1]]
    least = speeds_at(work, inertia, added, energy, n_points, square)
    if not least > (_LEAST * wanted) * (_LEAST * wanted):
        return False
    found[1], most = highest(square, 1.0, panels, count, nodes, zero, cycle, room)
    found[3], less = highest(square, -1.0, panels, count, nodes, zero, cycle, room)
    found[0], found[2] = np.sqrt(most), np.sqrt(less)
    for point in range(n_points):
        square[point] = np.sqrt(square[point])
    found[4] = mean_of(square, panels, count, nodes, cycle)
    return True


def flywheel_between(
    work: Array,
    inertia: Array,
    slowest: float,
    fastest: float,
    panels: Panels,
    count: int,
    nodes: PanelNodes,
    cycle: float,
    curve: Array,
    room: Array,
) -> tuple[float, float]:
    """Flywheel with which the speed runs just between two speeds, and the energy beside the excess work with it.

    docs/theory/evenness, eq. (17.7).
    """
    n_points = panels.first[count - 1] + nodes.size[panels.size[count - 1]]
    for point in range(n_points):
        curve[point] = work[point] - 0.5 * fastest * fastest * inertia[point]
    _angle, upper = highest(curve, 1.0, panels, count, nodes, 0.0, cycle, room)
    for point in range(n_points):
        curve[point] = work[point] - 0.5 * slowest * slowest * inertia[point]
    _angle, lower = highest(curve, -1.0, panels, count, nodes, 0.0, cycle, room)
    size = (upper - lower) / (0.5 * (fastest - slowest) * (fastest + slowest))
    return size, 0.5 * fastest * fastest * size - upper


def exact_flywheel(
    work: Array,
    inertia: Array,
    wanted: float,
    fluctuation: float,
    panels: Panels,
    count: int,
    nodes: PanelNodes,
    cycle: float,
    square: Array,
    room: Array,
) -> float:
    """Flywheel that gives a fluctuation at a mean speed over time; NaN where none is found. [kg·m²]

    The middle of both speeds is looked for by secants: its mean over time is nearly itself. docs/theory/evenness,
    eqs. (17.7) and (17.8).
    """
    half, n_points = 0.5 * wanted * fluctuation, panels.first[count - 1] + nodes.size[panels.size[count - 1]]
    middle, before, off_before = wanted, 0.0, 0.0
    for step in range(_STEPS):
        size, energy = flywheel_between(
            work, inertia, middle - half, middle + half, panels, count, nodes, cycle, square, room
        )
        least = speeds_at(work, inertia, size, energy, n_points, square)
        if not least > (_LEAST * wanted) * (_LEAST * wanted):
            return np.nan
        for point in range(n_points):
            square[point] = 1.0 / np.sqrt(square[point])
        off = 1.0 / mean_of(square, panels, count, nodes, cycle) - wanted
        move = -off if step == 0 else -off * (middle - before) / (off - off_before)
        if not abs(move) > _SETTLED * wanted:
            return size
        before, off_before = middle, off
        middle += move
    return np.nan
