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
    squares : Array, shape (point,)
        Of the sizes of a vector.
    most, least : Array, shape (panel,)
        The largest of the values in each, and the smallest.
    panel, node : array of int, shape (top,)
        Where tops are looked for.
    begins : array of bool, shape (top,)
        Whether it is the first point of what is level so far.
    angle, value : Array, shape (top,)
    series : Array, shape (2, 2, order)
        Of one curve or of two, each its even orders and its odd ones.
    """

    squares: Array
    most: Array
    least: Array
    panel: NDArray[np.intp]
    node: NDArray[np.intp]
    begins: NDArray[np.bool_]
    angle: Array
    value: Array
    series: Array


def room_for_tops(squares: Array, nodes: PanelNodes) -> Tops:
    """Room for a curve of as many points as `squares` has."""
    panel, node = np.zeros((2, MOST_TOPS), dtype=np.intp)
    angle, value = np.zeros((2, MOST_TOPS))
    most, least = np.zeros((2, MOST_PANELS))
    begins = np.zeros(MOST_TOPS, dtype=np.bool_)
    series = np.zeros((2, 2, nodes.even.shape[2]))
    return Tops(squares, most, least, panel, node, begins, angle, value, series)


def extremes(values: Array, cut: CutCycle, tops: Tops) -> tuple[float, float, float, float]:
    """Largest and smallest value of a curve.

    Parameters
    ----------
    values : Array, shape (point,)
        At the points of the panels.
    cut : CutCycle
    tops : Tops
        To work in.

    Returns
    -------
    float, float, float, float
        The angle of the largest value, from where angles count, of alike tops the first, and the value; the angle of
        the smallest value, and that. [rad]
    """
    most, least = _spread(values, cut, tops)
    up, down, largest, smallest = 0.0, 0.0, most, least
    for end in range(2):
        angle, value = _highest(values, 1.0 - 2.0 * end, most, least, cut, tops)
        if end == 0:
            up, largest = angle, value
        else:
            down, smallest = angle, value
    return up, largest, down, smallest


def highest(values: Array, sign: float, cut: CutCycle, tops: Tops) -> tuple[float, float]:
    """Angle and largest value of a curve, or for a sign of −1 its smallest; otherwise as `extremes`."""
    most, least = _spread(values, cut, tops)
    return _highest(values, sign, most, least, cut, tops)


def _highest(values: Array, sign: float, most: float, least: float, cut: CutCycle, tops: Tops) -> tuple[float, float]:
    """Largest value of a curve or its smallest, of one that is spread between two values at its points."""
    alike, top = _ALIKE * max(abs(most), abs(least)), most if sign > 0.0 else -least
    best, before, series = top, -1, tops.series[0]
    n_tops = _tops_at_points(values, sign, top, most - least, alike, cut, tops)
    for place in range(n_tops):
        panel, node = int(tops.panel[place]), int(tops.node[place])
        first, row = cut.panels.first[panel], cut.panels.size[panel]
        tops.value[place] = -np.inf
        if sign * values[first + node] + _rise(values[first:], node, row, cut.nodes) < top - alike:
            continue
        if panel != before:
            _series(values, first, row, cut.nodes, series)
            before = panel
        way, value = _polished(series, sign, values[first:], alike, node, row, cut.nodes)
        best = max(best, value)
        _note(place, way, value, cut, tops)
    return _first_of_alike(n_tops, best - alike, cut, tops), sign * best


def largest_size(x: Array, y: Array, cut: CutCycle, tops: Tops) -> tuple[float, float]:
    """Largest size of a vector whose components are x and y: its angle, and the size; otherwise as `extremes`."""
    own_x, own_y, squares = x[: cut.n_points], y[: cut.n_points], tops.squares[: cut.n_points]
    for point in range(cut.n_points):
        squares[point] = own_x[point] * own_x[point] + own_y[point] * own_y[point]
    most, least = _spread(squares, cut, tops)
    alike = 2.0 * _ALIKE * most
    best, before, of_x, of_y = most, -1, tops.series[0], tops.series[1]
    n_tops = _tops_at_points(squares, 1.0, most, most - least, alike, cut, tops)
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


def _spread(values: Array, cut: CutCycle, tops: Tops) -> tuple[float, float]:
    """Largest and smallest of some values; those of each panel are noted."""
    most, least = -np.inf, np.inf
    for panel in range(cut.n_panels):
        first, size = cut.panels.first[panel], cut.nodes.size[cut.panels.size[panel]]
        own, own_most, own_least = values[first : first + size], -np.inf, np.inf
        for node in range(size):
            own_most, own_least = max(own_most, own[node]), min(own_least, own[node])
        tops.most[panel], tops.least[panel] = own_most, own_least
        most, least = max(most, own_most), min(least, own_least)
    return most, least


def _tops_at_points(
    values: Array, sign: float, most: float, spread: float, alike: float, cut: CutCycle, tops: Tops
) -> int:
    """Find points beside which a top of a curve or of its negative may be the highest; give how many there are."""
    enough, n_tops = most - _LOOKED_AT * spread, 0
    for panel in range(cut.n_panels):
        first, size = cut.panels.first[panel], cut.nodes.size[cut.panels.size[panel]]
        own = values[first : first + size]
        highest_there = tops.most[panel] if sign > 0.0 else -tops.least[panel]
        for node in range(size if highest_there >= enough else 0):
            height = sign * own[node]
            if height < enough or n_tops >= MOST_TOPS:
                continue
            # before a panel stands the one before it; of what is level the first. Where the curve jumps down as a panel
            # begins, it may rise again before the next point.
            before = sign * (own[node - 1] if node > 0 else values[(first if first > 0 else cut.n_points) - 1])
            after = sign * own[node + 1] if node < size - 1 else -np.inf
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
        last += nodes.last[most, 0, node] * value
        other += nodes.last[most, 1, node] * value
    return 0.5 * width * total, width < _NARROWEST or max(abs(last), abs(other)) <= _SHOWN * scale


def _polished(
    series: Array, sign: float, values: Array, alike: float, node: int, row: int, nodes: PanelNodes
) -> tuple[float, float]:
    """Top of a series about a point of its panel, by Newton's method: where in [−1, 1], and sign times its value.

    What is level, by slopes that are rounding, has its top at that point.
    """
    low, high = nodes.place[row, max(node - 1, 0)], nodes.place[row, min(node + 1, nodes.size[row] - 1)]
    height = sign * values[node]
    way, top = _begun(values, sign, alike, node, row, nodes), height
    for _step in range(_STEPS):
        at, slope, bend = _at(series, nodes.size[row], way)
        if abs(slope) <= _LEVEL * alike and abs(bend) <= _LEVEL * alike:
            break
        move = _toward_top(sign * slope, sign * bend, low - way, high - way)
        way += move
        top = sign * (at + move * (slope + 0.5 * bend * move))
        if abs(move) <= _SETTLED:
            break
    return (way, top) if top >= height else (nodes.place[row, node], height)


def _polished_size(
    x: Array, y: Array, squares: Array, alike: float, node: int, row: int, nodes: PanelNodes
) -> tuple[float, float]:
    """Top of the square of a vector by the series of its components; as `_polished`."""
    size = nodes.size[row]
    low, high = nodes.place[row, max(node - 1, 0)], nodes.place[row, min(node + 1, size - 1)]
    way, top = _begun(squares, 1.0, alike, node, row, nodes), squares[node]
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


def _begun(values: Array, sign: float, alike: float, node: int, row: int, nodes: PanelNodes) -> float:
    """Where in [−1, 1] a top is looked for first: at that of a parabola through a point and those beside it."""
    place, own = nodes.place[row], values[node]
    if node == 0 or node == nodes.size[row] - 1:
        return place[node]
    up, down = own - values[node - 1], values[node + 1] - own
    if min(sign * up, -sign * down) <= _LEVEL * alike:
        return place[node]
    to_here, from_here = place[node] - place[node - 1], place[node + 1] - place[node]
    bend = (down / from_here - up / to_here) / (to_here + from_here)
    return place[node] - 0.5 * (up / to_here + bend * to_here) / bend


def _rise(values: Array, node: int, row: int, nodes: PanelNodes) -> float:
    """By how much a curve may rise above one of its points before the next: eight times as much as a parabola."""
    place, middle = nodes.place[row], min(max(node, 1), nodes.size[row] - 2)
    before, after = place[middle] - place[middle - 1], place[middle + 1] - place[middle]
    rise, fall = (values[middle] - values[middle - 1]) / before, (values[middle + 1] - values[middle]) / after
    wider = max(before, after)
    return abs(fall - rise) / (before + after) * wider * wider


def _toward_top(slope: float, bend: float, low: float, high: float) -> float:
    """Step to where a slope is 0, no farther than the points beside; half the way uphill where it bends upward."""
    if bend < 0.0:
        return min(max(-slope / bend, low), high)
    return high / 2 if slope > 0.0 else low / 2


def _series(values: Array, first: int, row: int, nodes: PanelNodes, series: Array) -> None:
    """Coefficients of Chebyshev's polynomials of a curve in the panel whose points begin at `first`: even, odd."""
    half = nodes.size[row] // 2
    own, even, odd = values[first : first + 2 * half], series[0], series[1]
    for order in range(even.size):
        even[order], odd[order] = 0.0, 0.0
    for node in range(half):
        both, rise = own[node] + own[2 * half - 1 - node], own[node] - own[2 * half - 1 - node]
        to_even, to_odd = nodes.even[row, node], nodes.odd[row, node]
        for order in range(even.size):
            even[order] += to_even[order] * both
            odd[order] += to_odd[order] * rise


def _at(series: Array, size: int, way: float) -> tuple[float, float, float]:
    """A series of Chebyshev's polynomials at a place x in [−1, 1], with its first two derivatives.

    By Clenshaw's recurrence in y = T₂(x), of the even orders, Tₘ(y), and of the odd ones over x, which go by the same.
    What is carried of first derivatives by y is their half, of second ones their eighth.
    """
    y, twice = 2.0 * way * way - 1.0, 4.0 * way * way - 2.0
    even, even_1, even_slope, even_slope_1, even_bend, even_bend_1 = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    odd, odd_1, odd_slope, odd_slope_1, odd_bend, odd_bend_1 = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    for down in range(1, size // 2 + 1):
        order = size // 2 - down
        even_bend, even_bend_1 = even_slope - even_bend_1 + twice * even_bend, even_bend
        odd_bend, odd_bend_1 = odd_slope - odd_bend_1 + twice * odd_bend, odd_bend
        even_slope, even_slope_1 = even - even_slope_1 + twice * even_slope, even_slope
        odd_slope, odd_slope_1 = odd - odd_slope_1 + twice * odd_slope, odd_slope
        even, even_1 = series[0, order] - even_1 + twice * even, even
        odd, odd_1 = series[1, order] - odd_1 + twice * odd, odd
    # T₋₁(y) = y, and of the odd ones over x 1
    of_even, of_odd = even - y * even_1, odd - odd_1
    first, first_odd = 2.0 * (even_slope - y * even_slope_1) - even_1, 2.0 * (odd_slope - odd_slope_1)
    second = 8.0 * (even_bend - y * even_bend_1) - 4.0 * even_slope_1
    second_odd = 8.0 * (odd_bend - odd_bend_1)
    by_way = 4.0 * way
    return (
        of_even + way * of_odd,
        by_way * first + of_odd + way * by_way * first_odd,
        4.0 * first + by_way * by_way * second + 3.0 * by_way * first_odd + way * by_way * by_way * second_odd,
    )


def _counted(angle: float, cycle: float) -> float:
    """Bring an angle into [0, cycle); what rounding put just before its end stands at its start."""
    counted = angle - cycle * np.floor(angle / cycle)
    return 0.0 if cycle - counted < 1e-13 else counted


def unresolved(values: Array, cut: CutCycle, part: float) -> bool:
    """Whether the last orders of a curve's series are, in any panel, more than a part of its largest size."""
    most = 0.0
    for panel in range(cut.n_panels):
        first, row = cut.panels.first[panel], cut.panels.size[panel]
        size = cut.nodes.size[row]
        own, one, other = values[first : first + size], cut.nodes.last[row, 0], cut.nodes.last[row, 1]
        of_one, of_other = 0.0, 0.0
        for node in range(size):
            of_one += one[node] * own[node]
            of_other += other[node] * own[node]
        most = max(most, abs(of_one), abs(of_other))
    return not most <= part * greatest(values, cut.n_points)


def greatest(values: Array, n_points: int) -> float:
    """Largest size of some values, or what is no number: by their bits, of which a processor compares several."""
    most = np.int64(0)
    for point in range(n_points):
        most = max(most, np.float64(abs(values[point])).view(np.int64))
    return float(np.int64(most).view(np.float64))
