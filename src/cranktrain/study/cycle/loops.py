"""Loops of a design that are the same for all machines: its panels, whether they show its curves, and its facts."""

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array
from cranktrain.study.cycle.given import ChamberNumbers, EvennessAsked, Found, TurningDesigns, Work
from cranktrain.study.cycle.nodes import PanelNodes
from cranktrain.study.cycle.panels import CutCycle, Panels
from cranktrain.study.cycle.running import exact_flywheel, fluctuation_of, integral_of, mean_of, mertsalov_flywheel
from cranktrain.study.cycle.tops import Tops, highest, largest_size, mean_size, unresolved

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
    design: int, cycle: float, room: ChamberNumbers, is_first: NDArray[np.bool_], edge: Array, pole: Array
) -> tuple[int, int]:
    """List φ of the dead centres of those chambers that others repeat, and of their poles; give how many of each."""
    n_edges, n_poles, n_turns = 0, 0, int(np.floor(cycle / _TURN + 0.5))
    for chamber in range(room.least.shape[1]):
        if is_first[chamber]:
            pole[n_poles] = room.least[design, chamber]
            n_poles += 1
            for turn in range(n_turns):
                edge[n_edges] = room.least[design, chamber] + turn * _TURN
                edge[n_edges + 1] = room.greatest[design, chamber] + turn * _TURN
                n_edges += 2
    return n_edges, n_poles


def directions(cut: CutCycle, cos: Array, sin: Array) -> None:
    """Find cosine and sine of φ at all points of the panels.

    From the middle of each panel, by the series of cosine and sine: panels are no wider than these reach.
    """
    for panel in range(cut.n_panels):
        first, row, half = cut.panels.first[panel], cut.panels.size[panel], 0.5 * cut.panels.width[panel]
        middle = cut.panels.start[panel] + half
        cos_middle, sin_middle = np.cos(middle), np.sin(middle)
        size = cut.nodes.size[row]
        place, own_cos, own_sin = cut.nodes.place[row], cos[first : first + size], sin[first : first + size]
        for node in range(size):
            x = half * place[node]
            of_x, share = _cosine(x * x), x * _sine_share(x * x)
            own_cos[node] = cos_middle * of_x - sin_middle * share
            own_sin[node] = sin_middle * of_x + cos_middle * share


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


def tell_torque(design: int, cut: CutCycle, work: Work, found: Array) -> None:
    """Find the largest and the smallest torque of a design; `found` is that of `Found`, as in all that follow."""
    found[design, 1], found[design, 0] = highest(work.torque[0], 1.0, cut, work.tops)
    found[design, 3], found[design, 2] = highest(work.torque[0], -1.0, cut, work.tops)
    gross = 0.0
    for point in range(cut.n_points):
        gross = max(gross, work.torque[1, point])
    found[design, 4] = gross


def tell_joints(design: int, cut: CutCycle, work: Work, found: Array) -> None:
    """Find the largest force in every joint."""
    for joint in range(work.joint_x.shape[0]):
        own = found[design, joint]
        own[1], own[0] = largest_size(work.joint_x[joint], work.joint_y[joint], cut, work.tops)


def tell_chambers(design: int, cut: CutCycle, work: Work, found: Array) -> None:
    """Find the largest pressure in every chamber."""
    for chamber in range(work.pressure.shape[0]):
        own = found[design, chamber]
        own[1], own[0] = highest(work.pressure[chamber], 1.0, cut, work.tops)


def tell_rods(design: int, cut: CutCycle, work: Work, found: Array) -> None:
    """Find the largest force along every cylinder, of its wall, and along its rod at either pin."""
    for piston in range(work.rod.shape[1]):
        for place in range(3):
            value, angle = _either_way(work.rod[place, piston], cut, work.tops)
            if place == _ALONG_ROD:
                other, where = _either_way(work.rod[3, piston], cut, work.tops)
                if other > value * (1.0 + _ALIKE):
                    value, angle = other, where
            found[design, piston, 2 * place], found[design, piston, 2 * place + 1] = value, angle


def keep_panels(design: int, cut: CutCycle, work: Work, found: Found) -> bool:
    """Keep panels of a design, with the gas's force at their points; give whether there was room for them."""
    if cut.n_points > found.angle.shape[1]:
        return False
    panels = cut.panels
    found.n_panels[design] = cut.n_panels
    for panel in range(cut.n_panels):
        found.panel[design, 0, panel], found.panel[design, 1, panel] = panels.start[panel], panels.width[panel]
        found.row[design, panel] = panels.size[panel]
    for point in range(cut.n_points):
        found.angle[design, point] = panels.angle[point]
    for piston in range(found.push.shape[1]):
        for point in range(cut.n_points):
            found.push[design, piston, point] = work.push[piston, point]
    return True


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
    up, most = highest(curve, 1.0, cut, tops)
    down, least = highest(curve, -1.0, cut, tops)
    alike = _ALIKE * max(most, -least)
    if most > -least + alike:
        return most, up
    if -least > most + alike:
        return -least, down
    return max(most, -least), min(up, down)


def tell_running(
    design: int, cut: CutCycle, turning: TurningDesigns, wanted: EvennessAsked, work: Work, found: Found
) -> bool:
    """Find how evenly a design runs; give whether all that was asked is known."""
    tops, speed = work.tops, turning.speed[design]
    stored, inertia, square = work.running[2], work.running[1], work.running[3]
    integral_of(work.running[0], mean_of(work.running[0], cut), cut, stored)
    excess = highest(stored, 1.0, cut, tops)[1] - highest(stored, -1.0, cut, tops)[1]
    found.work[design] = excess
    for flywheel in range(wanted.inertia.shape[1]):
        added, own = wanted.inertia[design, flywheel], found.running[design]
        if not fluctuation_of(stored, inertia, added, speed, cut, square, tops, own):
            return False
    for coefficient in range(wanted.coefficient.shape[1]):
        delta = wanted.coefficient[design, coefficient]
        sizes = found.flywheel[design]
        sizes[0] = exact_flywheel(stored, inertia, speed, delta, cut, square, tops)
        sizes[1] = mertsalov_flywheel(stored, inertia, speed, delta, cut, square, tops)
        sizes[2] = excess / (delta * speed * speed)
        if sizes[0] != sizes[0]:
            return False
    return True


def tell_given(
    design: int, cut: CutCycle, turning: TurningDesigns, wanted: EvennessAsked, work: Work, found: Found
) -> bool:
    """Find what fluctuation the flywheels of a design give; whether it is known."""
    speed, sizes, given = turning.speed[design], found.flywheel[design], work.speeds
    stored, inertia, square = work.running[2], work.running[1], work.running[3]
    for method in range(3 if wanted.coefficient.shape[1] > 0 else 0):
        if not fluctuation_of(stored, inertia, sizes[method], speed, cut, square, work.tops, given):
            return False
        sizes[3 + method] = (given[0] - given[2]) / speed
    return True


def _cosine(square: float) -> float:
    """Cosine by the square of an angle up to 1.6 rad, to rounding: its series to the 22nd power."""
    found = 1.0 - square * (1 / 462)
    found = 1.0 - square * (1 / 380) * found
    found = 1.0 - square * (1 / 306) * found
    found = 1.0 - square * (1 / 240) * found
    found = 1.0 - square * (1 / 182) * found
    found = 1.0 - square * (1 / 132) * found
    found = 1.0 - square * (1 / 90) * found
    found = 1.0 - square * (1 / 56) * found
    found = 1.0 - square * (1 / 30) * found
    found = 1.0 - square * (1 / 12) * found
    return 1.0 - square * (1 / 2) * found


def _sine_share(square: float) -> float:
    """Sine of an angle, over it, by its square, likewise: to the 23rd power."""
    found = 1.0 - square * (1 / 506)
    found = 1.0 - square * (1 / 420) * found
    found = 1.0 - square * (1 / 342) * found
    found = 1.0 - square * (1 / 272) * found
    found = 1.0 - square * (1 / 210) * found
    found = 1.0 - square * (1 / 156) * found
    found = 1.0 - square * (1 / 110) * found
    found = 1.0 - square * (1 / 72) * found
    found = 1.0 - square * (1 / 42) * found
    found = 1.0 - square * (1 / 20) * found
    return 1.0 - square * (1 / 6) * found
