"""Largest values of curves that are known at Chebyshev's points of panels; plain loops, which compile."""

from typing import Any

import numpy as np

from cranktrain.motion import Array
from cranktrain.study.cycle.nodes import PanelNodes
from cranktrain.study.cycle.panels import Panels

MOST_TOPS = 64
"""Tops of one curve that are looked at."""
_STEPS = 12
_SETTLED = 1e-8
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


def highest(
    values: Array, sign: float, panels: Panels, count: int, nodes: PanelNodes, zero: float, cycle: float, room: Array
) -> tuple[float, float]:
    """Largest value of a curve, or its smallest.

    Parameters
    ----------
    values : Array, shape (point,)
        At the points of the panels.
    sign : float
        +1 for the largest value, −1 for the smallest.
    panels : Panels
    count : int
        How many panels there are.
    nodes : PanelNodes
    zero, cycle : float
        From where angles count, and after which they do again. [rad]
    room : Array, shape (4, 64)
        To work in.

    Returns
    -------
    angle, value : float
        The angle from `zero` in [0, cycle), of alike tops the first. [rad]
    """
    most, least = -np.inf, np.inf
    last = panels.first[count - 1] + nodes.size[panels.size[count - 1]] - 1
    for point in range(last + 1):
        height = sign * values[point]
        most, least = max(most, height), min(least, height)
    enough, best, n_tops = most - _LOOKED_AT * (most - least), most, 0
    alike = _ALIKE * max(abs(most), abs(least))
    for panel in range(count):
        first, row = panels.first[panel], panels.size[panel]
        has_series = False
        for node in range(nodes.size[row]):
            height = sign * values[first + node]
            if height < enough or n_tops >= MOST_TOPS:
                continue
            before = sign * values[first + node - 1] if node > 0 or panel > 0 else sign * values[last]
            after = sign * values[first + node + 1] if node < nodes.size[row] - 1 else -np.inf
            # of what is level the first; before a panel stands the one before it
            goes_on = height <= before + alike
            if (goes_on and node > 0) or height < before - alike or height < after - alike:
                continue
            if not has_series:
                _series(values, first, row, nodes, room[2])
                has_series = True
            way, top = _polished(room[2], sign, height, alike, node, row, nodes)
            if goes_on and way == nodes.place[row, 0]:
                continue
            room[0, n_tops] = panels.start[panel] + panels.width[panel] * (0.5 + 0.5 * way)
            room[1, n_tops] = top
            best = max(best, top)
            n_tops += 1
    angle = np.inf
    for top in range(n_tops):
        counted = _counted(room[0, top] - zero, cycle)
        if room[1, top] >= best - alike and counted < angle:
            angle = counted
    return angle, sign * best


def largest_size(
    x: Array, y: Array, panels: Panels, count: int, nodes: PanelNodes, zero: float, cycle: float, room: Array
) -> tuple[float, float]:
    """Largest size of a vector whose components are x and y; parameters and returns as of `highest`."""
    most, least = -1.0, np.inf
    last = panels.first[count - 1] + nodes.size[panels.size[count - 1]] - 1
    for point in range(last + 1):
        square = x[point] * x[point] + y[point] * y[point]
        most, least = max(most, square), min(least, square)
    enough, best, n_tops, alike = most - _LOOKED_AT * (most - least), most, 0, 2.0 * _ALIKE * most
    for panel in range(count):
        first, row = panels.first[panel], panels.size[panel]
        has_series = False
        for node in range(nodes.size[row]):
            point = first + node
            square = x[point] * x[point] + y[point] * y[point]
            if square < enough or n_tops >= MOST_TOPS:
                continue
            beside = point - 1 if point > 0 else last
            before = x[beside] * x[beside] + y[beside] * y[beside]
            is_last = node == nodes.size[row] - 1
            after = -np.inf if is_last else x[point + 1] * x[point + 1] + y[point + 1] * y[point + 1]
            goes_on = square <= before + alike
            if (goes_on and node > 0) or square < before - alike or square < after - alike:
                continue
            if not has_series:
                _series(x, first, row, nodes, room[2])
                _series(y, first, row, nodes, room[3])
                has_series = True
            way, top = _polished_size(room[2], room[3], square, node, row, nodes)
            if goes_on and way == nodes.place[row, 0]:
                continue
            room[0, n_tops] = panels.start[panel] + panels.width[panel] * (0.5 + 0.5 * way)
            room[1, n_tops] = top
            best = max(best, top)
            n_tops += 1
    angle = np.inf
    for top in range(n_tops):
        counted = _counted(room[0, top] - zero, cycle)
        if room[1, top] >= best - alike and counted < angle:
            angle = counted
    return angle, np.sqrt(best)


def mean_size(x: Array, y: Array, panels: Panels, count: int, nodes: PanelNodes, cycle: float, room: Array) -> float:
    """Mean over the cycle of the size of a vector, whose square is smooth and which may come near to 0."""
    total = 0.0
    for panel in range(count):
        first, row = panels.first[panel], panels.size[panel]
        _series(x, first, row, nodes, room[2])
        _series(y, first, row, nodes, room[3])
        # pieces of the panel, each halved until it shows the size
        start, width, whole = -1.0, 2.0, 0.0
        while start < 1.0 - _NOTHING:
            part, is_shown = _integral_of_size(room[2], room[3], start, width, row, nodes)
            if is_shown or width < _NARROWEST:
                whole += part
                start += width
                width = min(2.0 * width, 1.0 - start)
            else:
                width *= 0.5
        total += 0.5 * panels.width[panel] * whole
    return total / cycle


def _integral_of_size(
    x: Array, y: Array, start: float, width: float, row: int, nodes: PanelNodes
) -> tuple[float, bool]:
    """Integral of the size of a vector over a piece of [−1, 1], and whether its points show it."""
    size, most = nodes.size[row], len(nodes.size) - 1
    total, scale, last, other = 0.0, 0.0, 0.0, 0.0
    n_points = nodes.size[most]
    for node in range(n_points):
        way = start + 0.5 * width * (1.0 + nodes.place[most, node])
        at_x, at_y = _at(x, size, way)[0], _at(y, size, way)[0]
        value = np.sqrt(at_x * at_x + at_y * at_y)
        scale = max(scale, value)
        total += nodes.weight[most, node] * value
        last += nodes.series[most, n_points - 1, node] * value
        other += nodes.series[most, n_points - 2, node] * value
    return 0.5 * width * total, max(abs(last), abs(other)) <= _SHOWN * scale


def _polished(
    series: Array, sign: float, height: Any, alike: float, node: int, row: int, nodes: PanelNodes
) -> tuple[float, float]:
    """Top of a series about a point of its panel, by Newton's method: where in [−1, 1], and sign times its value.

    What is level, by slopes that are rounding, has its top at that point.
    """
    low, high = nodes.place[row, max(node - 1, 0)], nodes.place[row, min(node + 1, nodes.size[row] - 1)]
    way, at = nodes.place[row, node], height
    for _step in range(_STEPS):
        at, slope, bend = _at(series, nodes.size[row], way)
        if abs(slope) <= _LEVEL * alike and abs(bend) <= _LEVEL * alike:
            break
        move = _toward_top(sign * slope, sign * bend, low - way, high - way)
        way += move
        if abs(move) <= _SETTLED:
            break
    at = sign * _at(series, nodes.size[row], way)[0]
    return (way, at) if at >= height else (nodes.place[row, node], height)


def _polished_size(x: Array, y: Array, square: Any, node: int, row: int, nodes: PanelNodes) -> tuple[float, float]:
    """Top of the square of a vector by the series of its components; as `_polished`."""
    size = nodes.size[row]
    low, high = nodes.place[row, max(node - 1, 0)], nodes.place[row, min(node + 1, size - 1)]
    way = nodes.place[row, node]
    for _step in range(_STEPS):
        at_x, slope_x, bend_x = _at(x, size, way)
        at_y, slope_y, bend_y = _at(y, size, way)
        slope = at_x * slope_x + at_y * slope_y
        bend = slope_x * slope_x + slope_y * slope_y + at_x * bend_x + at_y * bend_y
        move = _toward_top(slope, bend, low - way, high - way)
        way += move
        if abs(move) <= _SETTLED:
            break
    at_x, at_y = _at(x, size, way)[0], _at(y, size, way)[0]
    top = at_x * at_x + at_y * at_y
    return (way, top) if top >= square else (nodes.place[row, node], square)


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


def unresolved(values: Array, panels: Panels, count: int, nodes: PanelNodes, part: float) -> bool:
    """Whether the last orders of a curve's series are, in any panel, more than a part of its largest size."""
    scale, last = 0.0, 0.0
    for panel in range(count):
        first, row = panels.first[panel], panels.size[panel]
        size = nodes.size[row]
        own, one, other = values[first : first + size], nodes.series[row, size - 1], nodes.series[row, size - 2]
        of_one, of_other = 0.0, 0.0
        for node in range(size):
            scale = max(scale, abs(own[node]))
            of_one += one[node] * own[node]
            of_other += other[node] * own[node]
        last = max(last, abs(of_one), abs(of_other))
    return not last <= part * scale
