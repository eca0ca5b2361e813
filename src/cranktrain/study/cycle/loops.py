"""Loops of a design that are the same for all machines: its panels, whether they show its curves, and its facts."""

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array
from cranktrain.study.cycle.given import Found, TurningDesigns
from cranktrain.study.cycle.nodes import PanelNodes
from cranktrain.study.cycle.panels import CutCycle, Panels
from cranktrain.study.cycle.running import exact_flywheel, fluctuation_of, integral_of, mean_of, mertsalov_flywheel
from cranktrain.study.cycle.tops import Tops, extremes, greatest, largest_size, mean_size, unresolved

FINEST = 8.0
"""By what panels are made narrower at most until they show all curves."""
_RESOLVED = 1e-9
"""Last orders of the curves' series, in parts of the curves."""
_BORNE = 1e-9
"""Likewise of what others make of the curves."""
_TURN = 2 * np.pi
_ALONG_ROD = 2
"""Among the forces of a piston."""
_ALIKE = 1e-9
"""Values that differ by less, in parts of the larger, are one."""


def own_edges(
    least: Array, greatest: Array, cycle: float, is_first: NDArray[np.bool_], edge: Array, pole: Array
) -> tuple[int, int]:
    """List φ of the dead centres of those chambers that others repeat, and of their poles; give how many of each."""
    n_edges, n_poles, n_turns = 0, 0, int(np.floor(cycle / _TURN + 0.5))
    for chamber in range(least.size):
        if is_first[chamber]:
            pole[n_poles] = least[chamber]
            n_poles += 1
            for turn in range(n_turns):
                edge[n_edges] = least[chamber] + turn * _TURN
                edge[n_edges + 1] = greatest[chamber] + turn * _TURN
                n_edges += 2
    return n_edges, n_poles


def directions(angle: Array, cos: Array, sin: Array) -> None:
    """Find cosine and sine of φ at all points of the panels, from the nearest half turn, whose sign both then have."""
    for point in range(angle.size):
        half_turns = np.rint(angle[point] * (1 / np.pi))
        sign = 1.0 - 2.0 * abs(half_turns - 2.0 * np.rint(0.5 * half_turns))
        x = angle[point] - half_turns * np.pi
        cos[point] = sign * _cosine(x * x)
        sin[point] = sign * x * _sine_share(x * x)


def push_on(push: Array, area: float, pressure: Array, ambient: float, n_points: int) -> None:
    """Add what the pressure in a chamber does to a piston, whose area there is 0 of a partner that it has not."""
    if area != 0.0:
        for point in range(n_points):
            push[point] += area * (pressure[point] - ambient)


def shows(curves: Array, cut: CutCycle) -> bool:
    """Whether the panels show all of some curves, shape (curve, point)."""
    is_shown = True
    for curve in range(curves.shape[0]):
        if unresolved(curves[curve], cut, _RESOLVED):
            is_shown = False
            break
    return is_shown


def tell_torque(cut: CutCycle, torque: Array, tops: Tops, found: Array) -> None:
    """Find the largest and the smallest torque of a design.

    Curves are those of `Work`, here and in all that follow, and what is found is that of `Found`, of one design.
    """
    found[1], found[0], found[3], found[2] = extremes(torque[0], cut, tops)
    found[4] = greatest(torque[1], cut.n_points)


def tell_joints(cut: CutCycle, joint_x: Array, joint_y: Array, tops: Tops, found: Array) -> None:
    """Find the largest force in every joint."""
    for joint in range(joint_x.shape[0]):
        own = found[joint]
        own[1], own[0] = largest_size(joint_x[joint], joint_y[joint], cut, tops)


def tell_chambers(cut: CutCycle, pressure: Array, tops: Tops, found: Array) -> None:
    """Find the largest pressure in every chamber."""
    for chamber in range(pressure.shape[0]):
        own = found[chamber]
        own[1], own[0], _down, _least = extremes(pressure[chamber], cut, tops)


def tell_rods(cut: CutCycle, rod: Array, tops: Tops, found: Array) -> None:
    """Find the largest force along every cylinder, of its wall, and along its rod at either pin."""
    for piston in range(rod.shape[1]):
        for place in range(3):
            value, angle = _either_way(rod[place, piston], cut, tops)
            if place == _ALONG_ROD:
                other, where = _either_way(rod[3, piston], cut, tops)
                if other > value * (1.0 + _ALIKE):
                    value, angle = other, where
            found[piston, 2 * place], found[piston, 2 * place + 1] = value, angle


def keep_panels(cut: CutCycle, of_gas: Array, panel: Array, row: NDArray[np.intp], angle: Array, push: Array) -> int:
    """Keep panels of a design, with the gas's force at their points; give how many, none where there is no room."""
    if cut.n_points > angle.size:
        return 0
    panels = cut.panels
    for place in range(cut.n_panels):
        panel[0, place], panel[1, place] = panels.start[place], panels.width[place]
        row[place] = panels.size[place]
    for point in range(cut.n_points):
        angle[point] = panels.angle[point]
    for piston in range(push.shape[0]):
        for point in range(cut.n_points):
            push[piston, point] = of_gas[piston, point]
    return cut.n_panels


def tell_vectors(
    first: int,
    last: int,
    nodes: PanelNodes,
    panels: Panels,
    turning: TurningDesigns,
    found: Found,
    loads: Array,
    told: Array,
    tops: Tops,
) -> None:
    """Find the largest and the mean size of vectors at the points of the kept panels of designs.

    Parameters
    ----------
    loads : Array, shape (design, vector, 2, point)
    told : Array, shape (design, vector, 3), which is filled
        Largest size, its angle, mean size; NaN where the panels do not show a vector. [rad]
    """
    for design in range(first, last):
        n_panels, n_points = int(found.n_panels[design]), 0
        for panel in range(n_panels):
            panels.start[panel], panels.width[panel] = found.panel[design, 0, panel], found.panel[design, 1, panel]
            panels.size[panel], panels.first[panel] = found.row[design, panel], n_points
            n_points += int(nodes.size[panels.size[panel]])
        cut = CutCycle(panels, nodes, n_panels, n_points, turning.cycle, turning.zero[design])
        for vector in range(loads.shape[1] if n_panels > 0 else 0):
            x, y = loads[design, vector, 0], loads[design, vector, 1]
            if unresolved(x, cut, _BORNE) or unresolved(y, cut, _BORNE):
                continue
            angle, value = largest_size(x, y, cut, tops)
            told[design, vector, 0], told[design, vector, 1] = value, angle
            told[design, vector, 2] = mean_size(x, y, cut, tops)


def _either_way(curve: Array, cut: CutCycle, tops: Tops) -> tuple[float, float]:
    """Largest size of a curve, and where that is."""
    up, most, down, least = extremes(curve, cut, tops)
    alike = _ALIKE * max(most, -least)
    if most > -least + alike:
        return most, up
    if -least > most + alike:
        return -least, down
    return max(most, -least), min(up, down)


def tell_running(
    cut: CutCycle,
    speed: float,
    wanted_inertia: Array,
    wanted_coefficient: Array,
    running: Array,
    tops: Tops,
    found: Array,
    sizes: Array,
) -> tuple[float, bool]:
    """Find how evenly a design runs; give its largest excess work, and whether all that was asked is known."""
    stored, inertia, square = running[2], running[1], running[3]
    integral_of(running[0], mean_of(running[0], cut), cut, stored)
    _up, most, _down, least = extremes(stored, cut, tops)
    excess = most - least
    for flywheel in range(wanted_inertia.size):
        if not fluctuation_of(stored, inertia, wanted_inertia[flywheel], speed, cut, square, tops, found):
            return excess, False
    for coefficient in range(wanted_coefficient.size):
        delta = wanted_coefficient[coefficient]
        sizes[0] = exact_flywheel(stored, inertia, speed, delta, cut, square, tops)
        sizes[1] = mertsalov_flywheel(stored, inertia, speed, delta, cut, square, tops)
        sizes[2] = excess / (delta * speed * speed)
        if sizes[0] != sizes[0]:
            return excess, False
    return excess, True


def tell_given(
    cut: CutCycle, speed: float, wanted_coefficient: Array, running: Array, tops: Tops, speeds: Array, sizes: Array
) -> bool:
    """Find what fluctuation the flywheels of a design give; whether it is known."""
    stored, inertia, square = running[2], running[1], running[3]
    for method in range(3 if wanted_coefficient.size > 0 else 0):
        if not fluctuation_of(stored, inertia, sizes[method], speed, cut, square, tops, speeds):
            return False
        sizes[3 + method] = (speeds[0] - speeds[2]) / speed
    return True


def _cosine(square: float) -> float:
    """Cosine by the square of an angle up to a quarter turn; coefficients of least error, by `mpmath.chebyfit`."""
    found = -1.146467460833987e-11 + square * 4.627485616610008e-14
    found = 2.0876630388606333e-09 + square * found
    found = -2.7557317759930594e-07 + square * found
    found = 2.4801587292388148e-05 + square * found
    found = -0.0013888888888860494 + square * found
    found = 0.04166666666666633 + square * found
    found = -0.5 + square * found
    return 1.0 + square * found


def _sine_share(square: float) -> float:
    """Sine of an angle, over it, by its square, likewise."""
    found = -7.643962232442654e-13 + square * 2.731344277439919e-15
    found = 1.6058977059718268e-10 + square * found
    found = -2.5052107613095433e-08 + square * found
    found = 2.7557319219132584e-06 + square * found
    found = -0.0001984126984125486 + square * found
    found = 0.008333333333333316 + square * found
    found = -0.16666666666666666 + square * found
    return 1.0 + square * found
