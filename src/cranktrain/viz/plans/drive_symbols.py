"""Symbols of kinematic diagrams for a drive: shafts seen from the side, in millimetres of paper."""

from collections.abc import Callable, Iterator, Mapping
from typing import NamedTuple, TypeAlias

import numpy as np

from cranktrain.motion import Array
from cranktrain.viz.paper.sketch import Circle, Fill, Habit, Label, Line

Part: TypeAlias = Line | Circle | Label

_MOTOR, _DISC, _PLATE, _WHEEL = 4.0, 4.8, 3.0, 0.9
"""Radius of a motor; half heights of a disc and of a clutch's plate; half of a wheel's rim. [mm]"""
_PULLEY, _STRAND, _LINK = 1.5, 0.7, 0.45
"""Half of a pulley's face, from a belt's middle to each strand, radius of a chain's links. [mm]"""
_WORM = (2.6, 1.7)
"""Half length and radius of a worm. [mm]"""
_APART = {"gear": 13.0, "belt": 13.0, "chain": 13.0, "worm": 5.4}
"""Of the shafts before and behind a stage, if they are not in one line. [mm]"""
_LEAST_WHEEL, _FREE = 0.26, 0.36
"""The smaller wheel of a stage, and what a belt leaves free between its pulleys, in parts of the shafts' distance."""
_RING = (0.8, 1.6)
"""Radii of the mark of the crank's shaft. [mm]"""


class Seat(NamedTuple):
    """Where a symbol stands: along the chain, the heights of its shaft and of the next one [mm], ratio."""

    x: float
    level: float
    beyond: float
    ratio: float = 1.0


def symbol_parts(symbol: str, seat: Seat) -> list[Part]:
    """Lines, circles and letters of a symbol, by the name that `DriveElement` has for it. [mm]"""
    return list(_SYMBOLS[symbol](seat))


def reach(symbol: str, seat: Seat) -> float:
    """How far a symbol goes from its shaft, on the side away from the next one. [mm]"""
    if symbol in _WHEELS:
        return max(_radii(seat, 1.0 if symbol == "gear" else 1.0 - _FREE)[0], 2.0)
    return {"worm": _WORM[1], "coupling": 2.6, "linkage": 2.0, "crank": _RING[1], "stage": 3.4}.get(symbol, _DISC)


def shafts_apart(symbol: str) -> float:
    """How far the shaft behind a symbol lies beside that before it; 0 in one line. [mm]"""
    return _APART.get(symbol, 0.0)


def crank_mark(centre: Array, scale: float) -> list[Circle]:
    """Rings that mark the crank's shaft, in the chain and in the mechanism, with so many mm to one of paper."""
    inner, outer = _RING
    ring = Circle(centre, outer * scale, "DRIVE", "outline", 7)
    return [ring, Circle(centre, inner * scale, "DRIVE", "outline", 8, "paper")]


def line(points: list[tuple[float, float]], habit: Habit = "outline", fill: Fill = "none") -> Line:
    """A polyline through points [mm], closed if it is filled."""
    return Line(np.array(points, dtype=float).T, "DRIVE", habit, 5 if fill != "none" else 4, fill != "none", fill)


def _block(x: float, y: float, half: tuple[float, float], fill: Fill = "paper") -> Line:
    """A rectangle about a point."""
    wide, high = half
    return line([(x - wide, y - high), (x + wide, y - high), (x + wide, y + high), (x - wide, y + high)], fill=fill)


def _circle(x: float, y: float, radius: float, fill: Fill = "paper") -> Circle:
    return Circle(np.array([x, y]), radius, "DRIVE", "outline", 5, fill)


def _motor(seat: Seat) -> Iterator[Part]:
    yield _circle(seat.x, seat.level, _MOTOR)
    yield Label(np.array([seat.x, seat.level]), "M")


def _disc(seat: Seat) -> Iterator[Part]:
    yield _block(seat.x, seat.level, (0.7, _DISC), "ink")


def _brake(seat: Seat) -> Iterator[Part]:
    """A disc between two shoes that are fixed, on hatched ground."""
    x, y = seat.x, seat.level
    yield _block(x, y, (0.5, _DISC), "ink")
    for side in (-1.0, 1.0):
        yield _block(x + 1.3 * side, y - _DISC + 1.7, (0.4, 1.4), "light")
        yield line([(x + 1.7 * side, y - _DISC + 1.7), (x + 3.2 * side, y - _DISC + 1.7)])
        yield line([(x + 3.2 * side, y - _DISC + 0.5), (x + 3.2 * side, y - _DISC + 2.9)])
        for up in (0.6, 1.7, 2.8):
            yield line([(x + 3.2 * side, y - _DISC + up), (x + 4.0 * side, y - _DISC + up - 0.8)], "hatch")


def _clutch(seat: Seat) -> Iterator[Part]:
    """Two plates apart: the shaft is open between them."""
    yield _block(seat.x, seat.level, (0.5, 0.5), "paper")._replace(habit="none")
    for side in (-0.9, 0.9):
        yield _block(seat.x + side, seat.level, (0.4, _PLATE), "ink")


def _radii(seat: Seat, part: float) -> tuple[float, float]:
    """Radii of two wheels by their ratio, together so large a part of their shafts' distance."""
    first = float(np.clip(1 / (1 + seat.ratio), _LEAST_WHEEL, 1 - _LEAST_WHEEL))
    both = part * abs(seat.beyond - seat.level)
    return first * both, (1 - first) * both


def _toothed(x: float, axis: float, radius: float) -> Iterator[Part]:
    """A gear or chain wheel from the side: a web with its rim."""
    yield line([(x, axis - radius), (x, axis + radius)])
    for rim in (axis - radius, axis + radius):
        yield line([(x - _WHEEL, rim), (x + _WHEEL, rim)])


def _gear(seat: Seat) -> Iterator[Part]:
    for axis, radius in zip((seat.level, seat.beyond), _radii(seat, 1.0), strict=True):
        yield from _toothed(seat.x, axis, radius)


def _between(seat: Seat) -> tuple[float, float]:
    """Where what runs between two wheels leaves the first and comes to the second."""
    first, second = _radii(seat, 1.0 - _FREE)
    toward = float(np.sign(seat.beyond - seat.level))
    return seat.level + toward * first, seat.beyond - toward * second


def _belt(seat: Seat) -> Iterator[Part]:
    """Two pulleys, and the belt's two strands between them."""
    for axis, radius in zip((seat.level, seat.beyond), _radii(seat, 1.0 - _FREE), strict=True):
        yield _block(seat.x, axis, (_PULLEY, radius), "light")
    start, end = _between(seat)
    for side in (-_STRAND, _STRAND):
        yield line([(seat.x + side, start), (seat.x + side, end)], "rod")


def _chain(seat: Seat) -> Iterator[Part]:
    """Two toothed wheels, and links between them."""
    for axis, radius in zip((seat.level, seat.beyond), _radii(seat, 1.0 - _FREE), strict=True):
        yield from _toothed(seat.x, axis, radius)
    start, end = _between(seat)
    yield line([(seat.x, start), (seat.x, end)], "rod")
    n_links = max(2, round(abs(end - start) / (3.2 * _LINK)))
    inset = float(np.sign(end - start)) * 1.4 * _LINK
    for height in np.linspace(start + inset, end - inset, n_links).tolist():
        yield _circle(seat.x, height, _LINK)


def _worm(seat: Seat) -> Iterator[Part]:
    """A worm on its shaft with its threads, and the wheel as seen along its own axis."""
    half, radius = _WORM
    yield _block(seat.x, seat.level, _WORM)
    step = half / 2
    for at in np.linspace(-half, half, 5)[:-1].tolist():
        yield line([(seat.x + at, seat.level - radius), (seat.x + at + step, seat.level + radius)], "rod")._replace(
            order=6
        )
    yield _circle(seat.x, seat.beyond, abs(seat.beyond - seat.level) - radius)
    yield _circle(seat.x, seat.beyond, 0.5, "ink")


def _coupling(seat: Seat) -> Iterator[Part]:
    """Two halves that touch."""
    for side in (-0.8, 0.8):
        yield _block(seat.x + side, seat.level, (0.8, 2.6))


def _linkage(seat: Seat) -> Iterator[Part]:
    """A link between two pins."""
    yield _block(seat.x, seat.level, (2.6, 0.5), "paper")._replace(habit="none")
    yield line([(seat.x - 2.6, seat.level), (seat.x + 2.6, seat.level)], "load")._replace(order=6)
    for side in (-2.6, 2.6):
        yield _circle(seat.x + side, seat.level, 1.0)._replace(order=7)


def _stage(seat: Seat) -> Iterator[Part]:
    """A plain box, of a stage whose kind is not said."""
    yield _block(seat.x, seat.level, (2.6, 3.4))
    yield Label(np.array([seat.x, seat.level]), "i")


def _crank(seat: Seat) -> Iterator[Part]:
    yield from crank_mark(np.array([seat.x, seat.level]), 1.0)


_WHEELS = ("gear", "belt", "chain")
_SYMBOLS: Mapping[str, Callable[[Seat], Iterator[Part]]] = {
    "motor": _motor,
    "disc": _disc,
    "brake": _brake,
    "clutch": _clutch,
    "gear": _gear,
    "worm": _worm,
    "belt": _belt,
    "chain": _chain,
    "coupling": _coupling,
    "linkage": _linkage,
    "stage": _stage,
    "crank": _crank,
}
