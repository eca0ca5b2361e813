"""Sketches of the sources' constructions, in mm of metal: the construction on the crank circle, and the mechanism."""

from collections.abc import Iterator, Sequence

import numpy as np

from cranktrain.motion import Array
from cranktrain.plans.constructions import Construction
from cranktrain.plans.stroke_lines import Along, unit
from cranktrain.plans.vectors import angle_of
from cranktrain.viz.paper import shapes
from cranktrain.viz.paper.sketch import Circle, Label, Line, Sketch, Wish, placed_labels
from cranktrain.viz.plans.sketches import alike

_RULER, _ROW, _DIMENSION = 5.0, 3.6, 5.0
"""Ruler below the words about the crank circle, a row of its numbers, and a dimension below these, on paper. [mm]"""

_DIGIT = 2.1
"""Width of a figure with its share of room on paper. [mm]"""

_HIGH = 0.6
"""How high over the line a crank pin is whose letters have room, in parts of the crank radius."""

_PRIMES = ("'", "''")
"""Of the letters of the first positions that have any."""


def construction_sketch(found: Construction, scale: float) -> Sketch:
    """Crank circle, what is constructed on it, and a ruler of the readings below it, with bars where they should be.

    Parameters
    ----------
    found : Construction
    scale : float
        Millimetres of metal in one of paper.

    Returns
    -------
    Sketch
        In the sense of rotation of the crank as seen from the free end, the cylinder at the right.
    """
    sketch = Sketch(scale)
    radius = 1e3 * float(found.geometry.crank_radius)
    chosen = lettered_positions(found)
    sketch.add(_axes(found, radius, scale))
    sketch.add(_constructed(found, scale, chosen))
    numbers = [
        Wish(seen[:, few[0]], ",".join(map(str, few)), angle_of(seen[:, few[0]]), "words")
        for seen, few in _met(found, scale)
    ]
    feet = 1e3 * found.seen(found.foot)
    lines = [line.points for line in sketch.lines]
    lines += [shapes.arc(np.zeros(2), radius, 0.0, 2 * np.pi)]
    lines += [np.array([[foot[0], foot[0]], [foot[1], -radius - 2 * _RULER * scale]]) for foot in feet.T]
    labels = list(placed_labels([*_letters(found, chosen), *numbers], lines, scale))
    sketch.add(labels)
    lowest = min(-radius - 5.0 * scale, *(float(label.position[1]) for label in labels), float(np.min(feet[1])))
    sketch.add(_ruler(found, lowest - _RULER * scale, scale, chosen))
    return sketch


def lettered_positions(found: Construction) -> tuple[int, ...]:
    """Positions that have the source's letters: the first whose crank pin is off the line; of Brix's method two."""
    height = np.abs(found.on_circle[1]) > _HIGH * found.geometry.crank_radius
    most = len(_PRIMES) if found.method.startswith("brix") else 1
    return tuple(np.flatnonzero(height)[:most].tolist())


def _met(found: Construction, scale: float) -> Iterator[tuple[Array, list[int]]]:
    """Points of the crank circle, with the numbers of the positions that fall on each."""
    seen = 1e3 * found.seen(found.on_circle)
    yield from ((seen, few) for few in alike(seen, scale))


def _axes(found: Construction, radius: float, scale: float) -> Iterator[Line | Circle]:
    """Crank circle and line of stroke; with an offset the parallel through the shaft, too."""
    ends = np.array([-radius - 6.0 * scale, radius + 6.0 * scale])
    height = 1e3 * float(found.seen(np.array([0.0, found.geometry.offset]))[1])
    for y in {0.0, height}:
        yield Line(np.stack([ends, np.full(2, y)]), "GUIDES", "axis", 1)
    yield Circle(np.zeros(2), radius, "PATHS", "rod", 2)
    yield Circle(np.zeros(2), 0.7 * scale, "LINKS", "outline", 6, "paper")


def _constructed(found: Construction, scale: float, chosen: Sequence[int]) -> Iterator[Line | Circle]:
    """Arcs, perpendiculars or rays, those of the lettered positions in ink; dots where they end."""
    pins, feet, pistons = (1e3 * found.seen(one) for one in (found.on_circle, found.foot, found.piston))
    pole = 1e3 * np.array([found.pole, 0.0])
    for number, (pin, foot, piston) in enumerate(zip(pins.T, feet.T, pistons.T, strict=True)):
        is_chosen = number in chosen
        if found.method == "arc":
            start, end = angle_of(pin - piston) % (2 * np.pi), np.pi
            curve = shapes.arc(piston, 1e3 * float(found.geometry.rod_length), start, end)
            yield Line(curve, "LINKS", "outline" if is_chosen else "construction", 4 if is_chosen else 3)
        else:
            yield Line(np.stack([pin, foot], axis=1), "LINKS", "outline" if is_chosen else "construction", 3)
        if found.method.startswith("brix"):
            yield Line(np.stack([pole, pin], axis=1), "LINKS", "outline" if is_chosen else "thin", 3)
        elif is_chosen:
            yield Line(np.stack([np.zeros(2), pin], axis=1), "LINKS", "outline", 4)
        for point in (pin, foot):
            yield Circle(point, 0.55 * scale, "LINKS", "rod", 6, "paper")
    if found.method == "arc":
        for i in chosen:
            yield from _perpendiculars(found, scale, i)
    if found.method.startswith("brix"):
        yield Circle(pole, 0.7 * scale, "LINKS", "outline", 7, "ink")


def _perpendiculars(found: Construction, scale: float, i: int) -> Iterator[Line | Circle]:
    """AD; and A′D′ with the arc A′C′, the same angle after the crank-side dead centre."""
    other = found.from_crank_side
    radius = 1e3 * float(found.geometry.rod_length)
    pins, pistons = (1e3 * found.seen(one) for one in (other.on_circle, other.piston))
    start = angle_of(pins[:, i] - pistons[:, i]) % (2 * np.pi)
    yield Line(shapes.arc(pistons[:, i], radius, start, np.pi), "LINKS", "outline", 4)
    yield Line(np.stack([np.zeros(2), pins[:, i]], axis=1), "LINKS", "outline", 4)
    for pin, foot in ((found.on_circle, found.projected), (other.on_circle, other.projected)):
        ends = 1e3 * found.seen(np.stack([pin[:, i], foot[:, i]], axis=1))
        yield Line(ends, "LINKS", "construction", 3)
        yield Circle(ends[:, 1], 0.55 * scale, "LINKS", "rod", 6, "paper")
    for point in (pins[:, i], 1e3 * found.seen(other.foot)[:, i]):
        yield Circle(point, 0.55 * scale, "LINKS", "rod", 6, "paper")


def _ruler(found: Construction, low: float, scale: float, chosen: Sequence[int]) -> Iterator[Line | Label]:
    """Readings below the circle on a line, bars where the exact ones are, numbers, displacements by letters."""
    feet = 1e3 * found.seen(found.foot)
    start = 1e3 * found.seen(found.start)
    shift = start[0] - 1e3 * found.exact_displacement
    radius = 1e3 * float(found.geometry.crank_radius)
    ends = [min(float(np.min(feet[0])), float(np.min(shift)), -radius), max(float(np.max(feet[0])), start[0], radius)]
    yield Line(np.array([ends, [low, low]]), "GUIDES", "thin", 2)
    for foot in feet.T:
        yield Line(np.array([[foot[0], foot[0]], [foot[1], low]]), "GUIDES", "dotted", 1)
    is_backward = found.method == "brix_backward"
    for place in () if is_backward else shift:
        yield Line(np.array([[place, place], [low - 1.4 * scale, low + 1.4 * scale]]), "PLAN_V", "outline", 5)
    rows = _rows([(float(feet[0, few[0]]), ",".join(map(str, few))) for few in alike(feet, scale)], scale)
    for place, words, row in rows:
        yield Label(np.array([place, low - (3.6 + _ROW * row) * scale]), words)
    deepest = max(row for _place, _words, row in rows)
    for number, i in enumerate(chosen):
        y = low - (4.5 + _ROW * (deepest + 1) + _DIMENSION * number) * scale
        prime = _PRIMES[number] if found.method.startswith("brix") else ""
        top = low - (2.4 + _ROW * (deepest + 1)) * scale
        yield from _dimension((start[0], float(feet[0, i])), top, y, f"S{prime}", scale)


def _rows(places: Sequence[tuple[float, str]], scale: float) -> list[tuple[float, str, int]]:
    """Put numbers of a ruler into rows, so that none touches another."""
    reached: list[float] = []
    found: list[tuple[float, str, int]] = []
    for place, words in sorted(places):
        half = 0.5 * _DIGIT * len(words) * scale
        row = next((i for i, end in enumerate(reached) if place - half > end), len(reached))
        reached[row : row + 1] = [place + half]
        found.append((place, words, row))
    return found


def _dimension(ends: tuple[float, float], top: float, y: float, words: str, scale: float) -> Iterator[Line | Label]:
    """A length between two places, with its letter."""
    right, left = max(ends), min(ends)
    for x in (left, right):
        yield Line(np.array([[x, x], [top, y - 1.0 * scale]]), "DIMENSIONS", "thin", 2)
    yield Line(np.array([[left, right], [y, y]]), "DIMENSIONS", "thin", 2)
    if right - left > 6.0 * scale:
        yield shapes.arrowhead(np.array([left, y]), np.pi, 2.0 * scale)
        yield shapes.arrowhead(np.array([right, y]), 0.0, 2.0 * scale)
    yield Label(np.array([right + 3.5 * scale, y]), words, "symbol")


def _letters(found: Construction, chosen: Sequence[int]) -> Iterator[Wish]:
    """Letters of the source: O, P; A, C, D, A′, C′ and D′ of its figure 146, A′ and B′ of its figure 147."""
    yield Wish(np.zeros(2), "O", np.pi / 4)
    is_brix = found.method.startswith("brix")
    if is_brix:
        yield Wish(1e3 * np.array([found.pole, 0.0]), "P", 3 * np.pi / 4)
    foot_letter = {"arc": "C", "projection": "D"}.get(found.method, "B")
    pins, feet = (1e3 * found.seen(one) for one in (found.on_circle, found.foot))
    for number, i in enumerate(chosen):
        prime = _PRIMES[number] if is_brix else ""
        yield Wish(pins[:, i], f"A{prime}", angle_of(pins[:, i]) + 0.5)
        yield Wish(feet[:, i], f"{foot_letter}{prime}", -np.pi / 2 * np.sign(pins[1, i]))
        if found.method == "arc":
            other = found.from_crank_side
            away = -np.pi / 2 * float(np.sign(pins[1, i]))
            named = {"D": (found.projected, away), "C'": (other.foot, -away), "D'": (other.projected, -away)}
            for letter, (points, towards) in named.items():
                yield Wish(1e3 * found.seen(points)[:, i], letter, towards)
            opposite = 1e3 * found.seen(other.on_circle)[:, i]
            yield Wish(opposite, "A'", angle_of(opposite) + 0.5)


def scheme_sketch(found: Construction, scale: float, bore: float | None) -> Sketch:
    """The mechanism in its cylinder in the lettered position, and thin in both dead positions; the sense of rotation.

    Parameters
    ----------
    found : Construction
    scale : float
        Millimetres of metal in one of paper.
    bore : float or None
        Of the cylinder, where it is known [mm]; else there are guides.
    """
    sketch = Sketch(scale)
    radius = 1e3 * float(found.geometry.crank_radius)
    pins, pistons = (1e3 * found.seen(one) for one in found.dead_pins)
    at = next(iter(lettered_positions(found)), 0)
    width = 0.6 * 1e3 * found.stroke if bore is None else bore
    line = Along(np.array([0.0, pistons[1, 0]]), np.array([1.0, 0.0]))
    above, below = 0.35 * width, 0.25 * width
    span = float(pistons[0, 1]) - below, float(pistons[0, 0]) + above + 0.06 * width
    sketch.add([Line(line.path((-radius - 4.0 * scale, 0.0), (span[1] + 4.0 * scale, 0.0)), "GUIDES", "axis", 1)])
    sketch.add(shapes.walls(line, width, span, scale, has_head=bore is not None))
    sketch.add([Line(shapes.arc(np.zeros(2), radius, 0.0, 2 * np.pi), "PATHS", "dotted", 1)])
    for number in range(pins.shape[1]):
        chain = np.stack([np.zeros(2), pins[:, number], pistons[:, number]], axis=1)
        sketch.add([Line(chain, "LINKS", "thin", 3)])
        sketch.add(Circle(point, 0.6 * scale, "LINKS", "thin", 5, "paper") for point in chain.T)
    pin, piston = 1e3 * found.seen(_crank_pin(found, at)), 1e3 * found.seen(_exact_piston(found, at))
    crown = float(piston[0])
    sketch.add([Line(line.block((crown - below, crown + above), 0.485 * width), "LINKS", "outline", 4, True, "light")])
    chain = np.stack([np.zeros(2), pin, piston], axis=1)
    sketch.add([Line(chain, "LINKS", "outline", 5)])
    sketch.add(Circle(point, 0.8 * scale, "LINKS", "outline", 6, "paper") for point in chain.T)
    sketch.add(_turning(found, radius, scale))
    names = {"O": (np.zeros(2), -0.7 * np.pi), "A": (pin, angle_of(pin)), "B": (piston, -np.pi / 4)}
    names |= {"A_M": (pins[:, 0], 0.5), "A_M'": (pins[:, 1], np.pi - 0.5)}
    names |= {"B_M": (pistons[:, 0], np.pi / 3), "B_M'": (pistons[:, 1], 2 * np.pi / 3)}
    lines = [one.points for one in sketch.lines if one.habit != "hatch"]
    sketch.add(placed_labels([Wish(point, name, towards) for name, (point, towards) in names.items()], lines, scale))
    return sketch


def _turning(found: Construction, radius: float, scale: float) -> Iterator[Line]:
    """Arrow of the sense in which the crank turns, left of the crank circle."""
    reach, half = radius + 5.0 * scale, min(0.6, 9.0 * scale / radius)
    sense = -found.sense
    yield Line(shapes.arc(np.zeros(2), reach, np.pi - sense * half, np.pi + sense * half), "DIMENSIONS", "outline", 5)
    end = np.pi + sense * half
    tip = reach * unit(end)
    yield shapes.arrowhead(tip, float(end + sense * (np.pi / 2 - 1.0 * scale / reach)), 2.4 * scale)


def _crank_pin(found: Construction, at: int) -> Array:
    """Where the crank pin truly is in a position; Brix's rays meet the circle elsewhere. [m]"""
    return float(found.geometry.crank_radius) * unit(float(found.exact_angle[at]))


def _exact_piston(found: Construction, at: int) -> Array:
    """Where the piston's pin truly is. [m]"""
    return found.dead_pins[1][:, 0] - np.array([float(found.exact_displacement[at]), 0.0])
