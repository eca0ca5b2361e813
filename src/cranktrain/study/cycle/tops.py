"""Largest values of curves that are known at Chebyshev's points of panels; plain loops, which compile."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array
from cranktrain.study.cycle.nodes import PanelNodes
from cranktrain.study.cycle.panels import MOST_PANELS, CutCycle

MOST_TOPS = 64
"""Tops of one curve that are looked at."""
_STEPS = 12
_SETTLED = 1e-6
"""A step of Newton's method, in half widths of a panel, after which the next one is less than rounding."""
_LOOKED_AT = 0.02
"""By which part of its range a curve's points may be lower than its top that lies between them."""
_ALIKE = 1e-9
"""Values that differ by less, in parts of the largest size, are one: the first of them is the largest."""
_SHOWN, _NARROWEST = 1e-9, 1e-4
"""Last orders of a size in a piece that its points show, and the narrowest one in which that is asked."""
_NOTHING = 1e-14
_LEVEL = 10.0
"""Slopes and bends of a level curve over a panel, in parts of what is alike."""


class Tops(NamedTuple):
    """Room to look for the tops of one curve.

    Attributes
    ----------
    height : Array, shape (point,)
    most : Array, shape (panel,)
        The largest of the heights in each.
    panel, node : array of int, shape (top,)
        Where tops are looked for.
    begins : array of bool, shape (top,)
        Whether it is the first point of what is level so far.
    angle, value : Array, shape (top,)
    series : Array, shape (2, order)
    """

    height: Array
    most: Array
    panel: NDArray[np.intp]
    node: NDArray[np.intp]
    begins: NDArray[np.bool_]
    angle: Array
    value: Array
    series: Array


def room_for_tops(n_points: int, n_orders: int) -> Tops:
    """Room for a curve of so many points, in panels of so many orders."""
    panel, node = np.zeros((2, MOST_TOPS), dtype=np.intp)
    angle, value = np.zeros((2, MOST_TOPS))
    begins = np.zeros(MOST_TOPS, dtype=np.bool_)
    return Tops(np.zeros(n_points), np.zeros(MOST_PANELS), panel, node, begins, angle, value, np.zeros((2, n_orders)))


def highest(values: Array, sign: float, cut: CutCycle, tops: Tops) -> tuple[float, float]:
    """Largest value of a curve, or its smallest.

    Parameters
    ----------
    values : Array, shape (point,)
        At the points of the panels.
    sign : float
        +1 for the largest value, −1 for the smallest.
    cut : CutCycle
    tops : Tops
        To work in.

    Returns
    -------
    angle, value : float
        The angle from where angles count, of alike tops the first. [rad]
    """
    own, heights = values[: cut.n_points], tops.height[: cut.n_points]
    for point in range(cut.n_points):
        heights[point] = sign * own[point]
    most, least = _spread(cut, tops)
    alike = _ALIKE * max(abs(most), abs(least))
    best, before, series = most, -1, tops.series[0]
    n_tops = _tops_at_points(cut, most, least, alike, tops)
    for top in range(n_tops):
        panel, node = int(tops.panel[top]), int(tops.node[top])
        row = cut.panels.size[panel]
        if panel != before:
            _series(values, cut.panels.first[panel], row, cut.nodes, series)
            before = panel
        way, value = _polished(series, sign, heights[cut.panels.first[panel] :], alike, node, row, cut.nodes)
        best = max(best, value)
        _note(top, way, value, cut, tops)
    return _first_of_alike(n_tops, best - alike, cut, tops), sign * best


def largest_size(x: Array, y: Array, cut: CutCycle, tops: Tops) -> tuple[float, float]:
    """Largest size of a vector whose components are x and y; parameters and returns as of `highest`."""
    own_x, own_y, squares = x[: cut.n_points], y[: cut.n_points], tops.height[: cut.n_points]
    for point in range(cut.n_points):
        squares[point] = own_x[point] * own_x[point] + own_y[point] * own_y[point]
    most, least = _spread(cut, tops)
    alike = 2.0 * _ALIKE * most
    best, before, of_x, of_y = most, -1, tops.series[0], tops.series[1]
    n_tops = _tops_at_points(cut, most, least, alike, tops)
    for top in range(n_tops):
        panel, node = int(tops.panel[top]), int(tops.node[top])
        first, row = cut.panels.first[panel], cut.panels.size[panel]
        if panel != before:
            _series(x, first, row, cut.nodes, of_x)
            _series(y, first, row, cut.nodes, of_y)
            before = panel
        way, value = _polished_size(of_x, of_y, squares[first:], alike, node, row, cut.nodes)
        best = max(best, value)
        _note(top, way, value, cut, tops)
    return _first_of_alike(n_tops, best - alike, cut, tops), np.sqrt(best)


def _spread(cut: CutCycle, tops: Tops) -> tuple[float, float]:
    """Largest and smallest of the heights; the largest of each panel is noted."""
    most, least = -np.inf, np.inf
    for panel in range(cut.n_panels):
        first, size = cut.panels.first[panel], cut.nodes.size[cut.panels.size[panel]]
        heights, own_most, own_least = tops.height[first : first + size], -np.inf, np.inf
        for node in range(size):
            own_most, own_least = max(own_most, heights[node]), min(own_least, heights[node])
        tops.most[panel] = own_most
        most, least = max(most, own_most), min(least, own_least)
    return most, least


def _tops_at_points(cut: CutCycle, most: float, least: float, alike: float, tops: Tops) -> int:
    """Find points beside which a top of the heights may be the highest; give how many there are."""
    enough, n_tops = most - _LOOKED_AT * (most - least), 0
    for panel in range(cut.n_panels):
        first, size = cut.panels.first[panel], cut.nodes.size[cut.panels.size[panel]]
        heights = tops.height[first : first + size]
        for node in range(size if tops.most[panel] >= enough else 0):
            height = heights[node]
            if height < enough or n_tops >= MOST_TOPS:
                continue
            # before a panel stands the one before it; of what is level the first. Where the curve jumps down as a panel
            # begins, it may rise again before the next point.
            before = heights[node - 1] if node > 0 else tops.height[(first if first > 0 else cut.n_points) - 1]
            after = heights[node + 1] if node < size - 1 else -np.inf
            begins = abs(height - before) > alike if node == 0 else height > before + alike
            if (node > 0 and not begins) or height < after - alike:
                continue
            tops.panel[n_tops], tops.node[n_tops], tops.begins[n_tops] = panel, node, begins
            n_tops += 1
    return n_tops


def _note(top: int, way: float, value: float, cut: CutCycle, tops: Tops) -> None:
    """Note a top that was found in its panel; none where a level goes on from the panel before."""
    panel = tops.panel[top]
    goes_on = not tops.begins[top] and way == cut.nodes.place[cut.panels.size[panel], 0]
    tops.angle[top] = cut.panels.start[panel] + cut.panels.width[panel] * (0.5 + 0.5 * way)
    tops.value[top] = -np.inf if goes_on else value


def _first_of_alike(n_tops: int, enough: float, cut: CutCycle, tops: Tops) -> float:
    """Angle of the first of all tops that are high enough, from where angles count."""
    angle = np.inf
    for top in range(n_tops):
        counted = _counted(tops.angle[top] - cut.zero, cut.length)
        if tops.value[top] >= enough and counted < angle:
            angle = counted
    return angle


def mean_size(x: Array, y: Array, cut: CutCycle, tops: Tops) -> float:
    """Mean over the cycle of the size of a vector, whose square is smooth and which may come near to 0."""
    total, of_x, of_y = 0.0, tops.series[0], tops.series[1]
    for panel in range(cut.n_panels):
        first, row = cut.panels.first[panel], cut.panels.size[panel]
        _series(x, first, row, cut.nodes, of_x)
        _series(y, first, row, cut.nodes, of_y)
        # pieces of the panel, each halved until it shows the size
        start, width, whole = -1.0, 2.0, 0.0
        while start < 1.0 - _NOTHING:
            part, is_shown = _integral_of_size(of_x, of_y, start, width, row, cut.nodes)
            if is_shown:
                whole += part
                start += width
                width = min(2.0 * width, 1.0 - start)
            else:
                width *= 0.5
        total += 0.5 * cut.panels.width[panel] * whole
    return total / cut.length


def _integral_of_size(
    x: Array, y: Array, start: float, width: float, row: int, nodes: PanelNodes
) -> tuple[float, bool]:
    """Integral of the size of a vector over a piece of [−1, 1], and whether its points show it.

    They do not where the vector changes by more than its size from one point to the next: between these it may come
    next to nothing, and of the size's sharp turn there the last orders may be small by chance. The narrowest piece
    is taken as it is.
    """
    size, most = nodes.size[row], len(nodes.size) - 1
    total, scale, last, other = 0.0, 0.0, 0.0, 0.0
    n_points = nodes.size[most]
    before_x, before_y, before = 0.0, 0.0, 0.0
    for node in range(n_points):
        way = start + 0.5 * width * (1.0 + nodes.place[most, node])
        at_x, at_y = _at(x, size, way)[0], _at(y, size, way)[0]
        square = at_x * at_x + at_y * at_y
        by_x, by_y = at_x - before_x, at_y - before_y
        if width >= _NARROWEST and node > 0 and by_x * by_x + by_y * by_y > min(square, before):
            return 0.0, False
        before_x, before_y, before = at_x, at_y, square
        value = np.sqrt(square)
        scale = max(scale, value)
        total += nodes.weight[most, node] * value
        last += nodes.series[most, n_points - 1, node] * value
        other += nodes.series[most, n_points - 2, node] * value
    return 0.5 * width * total, width < _NARROWEST or max(abs(last), abs(other)) <= _SHOWN * scale


def _polished(
    series: Array, sign: float, heights: Array, alike: float, node: int, row: int, nodes: PanelNodes
) -> tuple[float, float]:
    """Top of a series about a point of its panel, by Newton's method: where in [−1, 1], and sign times its value.

    What is level, by slopes that are rounding, has its top at that point.
    """
    low, high = nodes.place[row, max(node - 1, 0)], nodes.place[row, min(node + 1, nodes.size[row] - 1)]
    way, top = _begun(heights, alike, node, row, nodes), heights[node]
    for _step in range(_STEPS):
        at, slope, bend = _at(series, nodes.size[row], way)
        if abs(slope) <= _LEVEL * alike and abs(bend) <= _LEVEL * alike:
            break
        move = _toward_top(sign * slope, sign * bend, low - way, high - way)
        way += move
        top = sign * (at + move * (slope + 0.5 * bend * move))
        if abs(move) <= _SETTLED:
            break
    return (way, top) if top >= heights[node] else (nodes.place[row, node], heights[node])


def _polished_size(
    x: Array, y: Array, squares: Array, alike: float, node: int, row: int, nodes: PanelNodes
) -> tuple[float, float]:
    """Top of the square of a vector by the series of its components; as `_polished`."""
    size = nodes.size[row]
    low, high = nodes.place[row, max(node - 1, 0)], nodes.place[row, min(node + 1, size - 1)]
    way, top = _begun(squares, alike, node, row, nodes), squares[node]
    for _step in range(_STEPS):
        at_x, slope_x, bend_x = _at(x, size, way)
        at_y, slope_y, bend_y = _at(y, size, way)
        slope = at_x * slope_x + at_y * slope_y
        bend = slope_x * slope_x + slope_y * slope_y + at_x * bend_x + at_y * bend_y
        move = _toward_top(slope, bend, low - way, high - way)
        way += move
        top = at_x * at_x + at_y * at_y + move * (2.0 * slope + bend * move)
        if abs(move) <= _SETTLED:
            break
    return (way, top) if top >= squares[node] else (nodes.place[row, node], squares[node])


def _begun(heights: Array, alike: float, node: int, row: int, nodes: PanelNodes) -> float:
    """Where in [−1, 1] a top is looked for first: at that of a parabola through a point and those beside it."""
    place, last = nodes.place[row], nodes.size[row] - 1
    if node == 0 or node == last or heights[node] - max(heights[node - 1], heights[node + 1]) <= _LEVEL * alike:
        return place[node]
    rise = (heights[node] - heights[node - 1]) / (place[node] - place[node - 1])
    fall = (heights[node + 1] - heights[node]) / (place[node + 1] - place[node])
    bend = (fall - rise) / (place[node + 1] - place[node - 1])
    return place[node] - 0.5 * (rise + bend * (place[node] - place[node - 1])) / bend


def _toward_top(slope: float, bend: float, low: float, high: float) -> float:
    """Step to where a slope is 0, no farther than the points beside; half the way uphill where it bends upward."""
    if bend < 0.0:
        return min(max(-slope / bend, low), high)
    return high / 2 if slope > 0.0 else low / 2


def _series(values: Array, first: int, row: int, nodes: PanelNodes, series: Array) -> None:
    """Coefficients of Chebyshev's polynomials of a curve in the panel whose points begin at `first`."""
    size = nodes.size[row]
    own = values[first : first + size]
    for order in range(size):
        total, weights = 0.0, nodes.series[row, order]
        for node in range(size):
            total += weights[node] * own[node]
        series[order] = total


def _at(series: Array, size: int, way: float) -> tuple[float, float, float]:
    """A series of Chebyshev's polynomials at a place in [−1, 1], with its first two derivatives."""
    twice = 2.0 * way
    one, other = way, 1.0
    slope_one, slope_other = 1.0, 0.0
    bend_one, bend_other = 0.0, 0.0
    at, slope, bend = series[0] + series[1] * way, series[1], 0.0
    for order in range(2, size):
        bend_one, bend_other = 4.0 * slope_one + twice * bend_one - bend_other, bend_one
        slope_one, slope_other = 2.0 * one + twice * slope_one - slope_other, slope_one
        one, other = twice * one - other, one
        at += series[order] * one
        slope += series[order] * slope_one
        bend += series[order] * bend_one
    return at, slope, bend


def _counted(angle: float, cycle: float) -> float:
    """Bring an angle into [0, cycle); what rounding put just before its end stands at its start."""
    counted = angle - cycle * np.floor(angle / cycle)
    return 0.0 if cycle - counted < 1e-13 else counted


def unresolved(values: Array, cut: CutCycle, part: float) -> bool:
    """Whether the last orders of a curve's series are, in any panel, more than a part of its largest size."""
    scale, last = 0.0, 0.0
    for panel in range(cut.n_panels):
        first, row = cut.panels.first[panel], cut.panels.size[panel]
        size = cut.nodes.size[row]
        own, one, other = values[first : first + size], cut.nodes.series[row, size - 1], cut.nodes.series[row, size - 2]
        of_one, of_other = 0.0, 0.0
        for node in range(size):
            scale = max(scale, abs(own[node]))
            of_one += one[node] * own[node]
            of_other += other[node] * own[node]
        last = max(last, abs(of_one), abs(of_other))
    return not last <= part * scale
