"""How evenly a machine runs, by its work and its inertia at the points of panels; plain loops, which compile."""

import numpy as np

from cranktrain.motion import Array
from cranktrain.study.cycle.panels import CutCycle
from cranktrain.study.cycle.tops import Tops, extremes, highest

_STEPS = 40
_NEARLY = 1e-7
"""A step, in parts of what is looked for, after which the next one is less than rounding."""
_LEAST = 0.1
"""Of the mean speed: how slowly a shaft may turn for its points to show how it does."""


def mean_of(values: Array, cut: CutCycle) -> float:
    """Mean of a curve over the cycle."""
    total = 0.0
    for panel in range(cut.n_panels):
        first, row = cut.panels.first[panel], cut.panels.size[panel]
        size = cut.nodes.size[row]
        own, weight, part = values[first : first + size], cut.nodes.weight[row], 0.0
        for node in range(size):
            part += weight[node] * own[node]
        total += 0.5 * cut.panels.width[panel] * part
    return total / cut.length


def integral_of(values: Array, mean: float, cut: CutCycle, integral: Array) -> None:
    """Fill `integral` with that of a curve less its mean, from the first panel on."""
    before = 0.0
    for panel in range(cut.n_panels):
        first, row, half = cut.panels.first[panel], cut.panels.size[panel], 0.5 * cut.panels.width[panel]
        size = cut.nodes.size[row]
        own, place = values[first : first + size], cut.nodes.place[row]
        for node in range(size):
            part, weights = 0.0, cut.nodes.integral[row, node]
            for other in range(size):
                part += weights[other] * own[other]
            integral[first + node] = before + half * (part - mean * (place[node] + 1.0))
        before = integral[first + size - 1]


def energy_for(work: Array, inertia: Array, added: float, wanted: float, cut: CutCycle) -> float:
    """Kinetic energy beside the excess work at which the mean speed over time is as wanted; NaN where it stops.

    Parameters
    ----------
    work, inertia : Array, shape (point,)
        A and J of the moving parts. [J, kg·m²]
    added : float
        Inertia of the flywheel. [kg·m²]
    wanted : float
        [rad/s]
    cut : CutCycle

    Notes
    -----
    With ω² = 2(A + E)/J the mean of 1/ω falls with E, and its slope is −⟨1/(ω³J)⟩; docs/theory/evenness, eqs. (17.4)
    and (17.5).
    """
    lowest = np.inf
    for point in range(cut.n_points):
        lowest = min(lowest, work[point])
    energy = 0.5 * wanted * wanted * (mean_of(inertia, cut) + added) - mean_of(work, cut)
    floor = -lowest
    energy = max(energy, floor + 1e-3 * abs(energy))
    for _step in range(_STEPS):
        late, steep = 0.0, 0.0
        for panel in range(cut.n_panels):
            first, row = cut.panels.first[panel], cut.panels.size[panel]
            size, weight = cut.nodes.size[row], cut.nodes.weight[row]
            own_work, own_inertia = work[first : first + size], inertia[first : first + size]
            own_late, own_steep = 0.0, 0.0
            for node in range(size):
                carried = own_inertia[node] + added
                slowness = np.sqrt(carried / (2.0 * (own_work[node] + energy)))
                own_late += weight[node] * slowness
                own_steep += weight[node] * (slowness * slowness * slowness / carried)
            late += 0.5 * cut.panels.width[panel] * own_late
            steep += 0.5 * cut.panels.width[panel] * own_steep
        # by the square of the mean speed, which is nearly a straight line over the energy
        slow = late / cut.length
        move = 0.5 * slow * ((slow * wanted) * (slow * wanted) - 1.0) * (cut.length / steep)
        move = max(move, 0.5 * (floor - energy))
        energy += move
        if not abs(move) > _NEARLY * abs(energy):
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
    work: Array, inertia: Array, added: float, wanted: float, cut: CutCycle, square: Array, tops: Tops, found: Array
) -> bool:
    """Largest and smallest speed with a flywheel, at a mean speed over time.

    Parameters are those of `energy_for`; `square`, shape (point,), and `tops` are to work in.

    Returns
    -------
    bool
        Whether it is known; then `found` holds the largest speed and its angle, the smallest and its angle, and the
        mean over the crank angle. [rad/s, rad]
    """
    energy = energy_for(work, inertia, added, wanted, cut)
    least = speeds_at(work, inertia, added, energy, cut.n_points, square)
    if not least > (_LEAST * wanted) * (_LEAST * wanted):
        return False
    found[1], most, found[3], less = extremes(square, cut, tops)
    found[0], found[2] = np.sqrt(most), np.sqrt(less)
    for point in range(cut.n_points):
        square[point] = np.sqrt(square[point])
    found[4] = mean_of(square, cut)
    return True


def flywheel_between(
    work: Array, inertia: Array, slowest: float, fastest: float, cut: CutCycle, curve: Array, tops: Tops
) -> tuple[float, float]:
    """Flywheel with which the speed runs just between two speeds, and the energy beside the excess work with it.

    docs/theory/evenness, eq. (17.7).
    """
    upper = _top_less_energy(work, inertia, fastest, 1.0, cut, curve, tops)
    lower = _top_less_energy(work, inertia, slowest, -1.0, cut, curve, tops)
    size = (upper - lower) / (0.5 * (fastest - slowest) * (fastest + slowest))
    return size, 0.5 * fastest * fastest * size - upper


def mertsalov_flywheel(
    work: Array, inertia: Array, speed: float, fluctuation: float, cut: CutCycle, curve: Array, tops: Tops
) -> float:
    """Flywheel by the excess work less the moving parts' energy at one speed; docs/theory/evenness, eq. (17.9)."""
    upper = _top_less_energy(work, inertia, speed, 1.0, cut, curve, tops)
    lower = _top_less_energy(work, inertia, speed, -1.0, cut, curve, tops)
    return (upper - lower) / (fluctuation * speed * speed)


def _top_less_energy(
    work: Array, inertia: Array, speed: float, sign: float, cut: CutCycle, curve: Array, tops: Tops
) -> float:
    """Largest or smallest excess work less the energy of the moving parts at a speed."""
    for point in range(cut.n_points):
        curve[point] = work[point] - 0.5 * speed * speed * inertia[point]
    return highest(curve, sign, cut, tops)[1]


def exact_flywheel(
    work: Array, inertia: Array, wanted: float, fluctuation: float, cut: CutCycle, square: Array, tops: Tops
) -> float:
    """Flywheel that gives a fluctuation at a mean speed over time; NaN where none is found. [kg·m²]

    The middle of both speeds is looked for by secants: its mean over time is nearly itself. docs/theory/evenness,
    eqs. (17.7) and (17.8).
    """
    half, middle, before, off_before, size_before = 0.5 * wanted * fluctuation, wanted, 0.0, 0.0, 0.0
    for step in range(_STEPS):
        size, energy = flywheel_between(work, inertia, middle - half, middle + half, cut, square, tops)
        least = speeds_at(work, inertia, size, energy, cut.n_points, square)
        if not least > (_LEAST * wanted) * (_LEAST * wanted):
            return np.nan
        for point in range(cut.n_points):
            square[point] = 1.0 / np.sqrt(square[point])
        off = 1.0 / mean_of(square, cut) - wanted
        move = -off if step == 0 else -off * (middle - before) / (off - off_before)
        if step > 0 and not abs(move) > _NEARLY * wanted:
            return size + move * (size - size_before) / (middle - before)
        if move == 0.0:
            return size
        before, off_before, size_before = middle, off, size
        middle += move
    return np.nan
