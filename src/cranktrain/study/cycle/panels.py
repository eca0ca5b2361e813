"""Panels of a cycle: between events, and as narrow as what is near them asks for; plain loops, which compile."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array
from cranktrain.study.cycle.nodes import PanelNodes

MOST_PANELS = 512
"""Of one design."""
_ALIKE = 1e-11
"""Edges that are closer are one. [rad]"""
_WIDEST = 3.2
"""Of a panel, for the motion itself. [rad]"""
_REACH = 2.2
"""How wide a panel may be for the distance of the pole that a pressure has beside its least volume."""


class Panels(NamedTuple):
    """Room for the panels of one design, and for their points.

    Attributes
    ----------
    start, width : Array, shape (panel,)
        [rad]
    size, first : array of int, shape (panel,)
        Which of the sizes of `PanelNodes`, and the first of its points.
    angle : Array, shape (point,)
        φ. [rad]
    edge : Array, shape (panel + 1,)
        To sort events in.
    """

    start: Array
    width: Array
    size: NDArray[np.intp]
    first: NDArray[np.intp]
    angle: Array
    edge: Array


class CutCycle(NamedTuple):
    """A cycle cut into panels; of one that repeats itself within, what it repeats.

    Attributes
    ----------
    panels : Panels
    nodes : PanelNodes
    n_panels, n_points : int
        How many there are of each; no panels where there was no room for them.
    length, zero : float
        After which all repeats, and from where angles count. [rad]
    """

    panels: Panels
    nodes: PanelNodes
    n_panels: int
    n_points: int
    length: float
    zero: float


def panel_room(nodes: PanelNodes) -> Panels:
    """Room for the panels of one design."""
    most = int(nodes.size[-1])
    start, width = np.zeros((2, MOST_PANELS))
    size, first = np.zeros((2, MOST_PANELS), dtype=np.intp)
    return Panels(start, width, size, first, np.zeros(MOST_PANELS * most), np.zeros(MOST_PANELS + 1))


def sorted_edges(edge: Array, n_edges: int, cycle: float) -> int:
    """Bring the first `n_edges` of some angles into one cycle, in order and each once; give how many there are."""
    for place in range(n_edges):
        angle = edge[place] - cycle * np.floor(edge[place] / cycle)
        before = place
        while before > 0 and edge[before - 1] > angle:
            edge[before] = edge[before - 1]
            before -= 1
        edge[before] = angle
    kept = 0
    for place in range(n_edges):
        if kept == 0 or edge[place] - edge[kept - 1] > _ALIKE:
            edge[kept] = edge[place]
            kept += 1
    if kept > 1 and edge[0] + cycle - edge[kept - 1] <= _ALIKE:
        kept -= 1
    return kept


def cut_cycle(
    panels: Panels, n_edges: int, length: float, poles: Array, away: Array, finer: float, nodes: PanelNodes
) -> tuple[int, int]:
    """Cut the cycle at its edges, and further where poles are near.

    Parameters
    ----------
    panels : Panels
        Whose `edge` holds the sorted edges, and which is filled.
    n_edges : int
    length : float
        As of `CutCycle`. [rad]
    poles, away : Array, shape (pole,)
        φ beside which the curves have poles, and how far from the real axis; 0 of what has none. [rad]
    finer : float
        By what panels are narrower than usual.
    nodes : PanelNodes

    Returns
    -------
    int, int
        How many panels and how many points there are, as of `CutCycle`.
    """
    count, n_points, share = 0, 0, 1.0 / finer
    for place in range(max(n_edges, 1)):
        start = panels.edge[place] if n_edges > 0 else 0.0
        end = start + length
        if n_edges > 0:
            end = panels.edge[place + 1] if place + 1 < n_edges else panels.edge[0] + length
        while end - start > 0:
            width = end - start
            # from the start as wide as the poles allow, which lie where other panels begin
            widest = _widest(start, width, poles, away, length, share)
            while width > widest * (1 + _ALIKE):
                width = max(widest, width / 2)
                widest = _widest(start, width, poles, away, length, share)
            if end - start - width <= _ALIKE:
                width = end - start
            if count == len(panels.start):
                return 0, 0
            size = 0
            while width > nodes.share[size] * widest:
                size += 1
            panels.start[count], panels.width[count] = start, width
            panels.size[count], panels.first[count] = size, n_points
            n_own, middle, half = nodes.size[size], start + 0.5 * width, 0.5 * width
            x, angle = nodes.place[size], panels.angle[n_points : n_points + n_own]
            for node in range(n_own):
                angle[node] = middle + half * x[node]
            n_points += n_own
            count += 1
            if width == end - start:
                break
            start += width
    return count, n_points


def _widest(start: float, width: float, poles: Array, away: Array, cycle: float, share: float) -> float:
    """How wide a panel may be that begins somewhere."""
    middle, half, nearest = start + width / 2, width / 2, np.inf
    for place in range(len(poles)):
        # from the panel's nearest point, round the cycle either way
        apart = middle - poles[place]
        apart = abs(apart - cycle * np.floor(apart * (1.0 / cycle) + 0.5))
        beside = max(apart - half, 0.0)
        nearest = min(nearest, beside * beside + away[place] * away[place])
    return min(_WIDEST, _REACH * np.sqrt(nearest)) * share
