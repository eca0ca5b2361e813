"""Sketches of plans: a mechanism in positions, polygons of velocities and accelerations, Klein's construction."""

from collections.abc import Iterator, Sequence

import numpy as np

from cranktrain.grouping import grouped
from cranktrain.mechanisms.drawing import Drawing, DrawnLink
from cranktrain.motion import Array
from cranktrain.numerics.ties import first_smallest
from cranktrain.panels.formulas import INDICES
from cranktrain.plans.klein import Klein
from cranktrain.plans.polygons import Polygon
from cranktrain.plans.positions import PositionPlan
from cranktrain.plans.shown_loads import ShownLoads
from cranktrain.plans.stroke_lines import Along, guide_line
from cranktrain.plans.vectors import POLE, Part, angle_of, spoken_name
from cranktrain.viz.paper import shapes
from cranktrain.viz.paper.sketch import Circle, Habit, Layer, Line, Sketch, Wish, placed_labels, together
from cranktrain.viz.plans.load_sketches import Wording, drawn_loads

_ONE_PLACE = 0.4
"""Points nearer to each other have one place with all their names. [mm]"""

_CORNER = 3.0
"""A normal part shorter than this leaves no room to name its end; nor does a tangential part to name its start. [mm]"""

_LETTERS_FROM = 0.35
"""A vector shorter than this part of the longest has no room for its symbol."""

_HEADED = 2.5
"""A vector shorter than this has no arrowhead. [mm]"""

_MANY_PINS, _NUMBER = 5, 1.5
"""Where more pins move, only the positions of crank and sliders have numbers, if each has so much room. [mm]"""

_MANY = 8
"""Of more vectors only those from the pole have their symbols beside them: the table names the others by their ends."""


def positions_sketch(
    plan: PositionPlan,
    track: Drawing | None = None,
    *,
    hidden: Sequence[str] = (),
    is_lettered: bool = False,
    loads: ShownLoads | None = None,
    said: Wording | None = None,
) -> Sketch:
    """Mechanism in positions as line drawings, numbered from 0; in mm of metal.

    Parameters
    ----------
    plan : PositionPlan
    track : Drawing, optional
        The same mechanism over a turn, for the paths of its pins. [drawing mm]
    hidden : sequence of str
        Pins that have no words: a detail has them.
    is_lettered : bool
        Of several positions name the pins in the first one, and those that stand still.
    loads : ShownLoads, optional
        Of the machine file.
    said : mapping of mechanism and name to symbol, optional
        In one position symbols of loads instead of their names and sizes.
    """
    sketch, pins = line_drawing(plan, track)
    scale = sketch.scale
    if len(plan.angles) == 1:
        wishes = pin_wishes(plan.drawing, pins)
    else:
        numbered = _numbered(plan.drawing, pins, scale)
        wishes = [
            wish
            for name in numbered
            if name not in hidden
            for wish in _numbers(name, pins, plan.drawing, scale, spoken_name(name) if is_lettered else "")
        ]
        if is_lettered:
            rest = [one for one in pins if one not in (*numbered, *hidden, *plan.drawing.ends)]
            wishes += _still_names(plan.drawing, pins, rest)
    acting = drawn_loads(loads, plan.angles, plan.drawing, pins, scale, said)
    sketch.add(acting.lines)
    lines = [line.points for line in sketch.lines if line.habit != "dotted"]
    sketch.add(placed_labels([*wishes, *acting.wishes], lines, scale))
    return sketch


def _numbered(drawing: Drawing, pins: dict[str, Array], scale: float) -> list[str]:
    """Pins whose positions have numbers: all that move; of many the crank's and those that slide far on paper."""
    moving = [name for name in pins if name not in (*drawing.fixed, *drawing.ends)]
    if len(moving) <= _MANY_PINS:
        return moving
    sliding = [guide.pin for guide in drawing.guides]
    far = [name for name in sliding if np.max(np.ptp(pins[name], axis=1)) > _NUMBER * pins[name].shape[1] * scale]
    return [drawing.links[0].pins[1], *far, *drawing.points]


def _still_names(drawing: Drawing, pins: dict[str, Array], names: Sequence[str]) -> Iterator[Wish]:
    """Names of pins that stand still, and in their first position of moving ones that have no numbers."""
    middle = np.mean(np.concatenate(list(pins.values()), axis=1), axis=1)
    for name in names:
        is_still = name in drawing.fixed
        point, words = pins[name][:, 0], spoken_name(name)
        towards = -np.pi / 4 if is_still else angle_of(point - middle)
        yield Wish(point, words if is_still else f"{words}{'0'.translate(INDICES)}", towards, "number")


def line_drawing(plan: PositionPlan, track: Drawing | None = None) -> tuple[Sketch, dict[str, Array]]:
    """Links, guides and pivots of a mechanism in its positions, without words; its pins by name, in mm of metal."""
    scale = 1e3 * plan.scale
    sketch = Sketch(scale)
    pins = {name: scale * pin for name, pin in plan.drawing.positions.items()}
    sketch.add(frame_lines(plan.drawing, pins, scale))
    sketch.add(_blocks(plan.drawing, pins, scale))
    if track is not None:
        paths = track.positions
        sketch.add(
            Line(scale * paths[name], "PATHS", "curve" if name in track.points else "dotted", 1) for name in track.paths
        )
    for i in range(len(plan.angles)):
        habit = "outline" if i == 0 else "thin"
        for link in plan.drawing.links:
            for names in sides_of(link, plan.drawing):
                ends = np.stack([pins[name][:, i] for name in names], axis=1)
                sketch.add([Line(ends, "LINKS", habit, 4 if i == 0 else 3)])
        sketch.add(Circle(pin[:, i], 0.6 * scale, "LINKS", habit, 5, "paper") for pin in pins.values())
    return sketch, pins


def sides_of(link: DrawnLink, drawing: Drawing) -> Iterator[tuple[str, str]]:
    """Pins two by two between which a link is drawn: from its first to each; to a point on it from its second too.

    A slot beside its first pin is a line of its own.
    """
    for name in link.pins[1:]:
        yield link.pins[0], name
        if name in drawing.points:
            yield link.pins[1], name
    for block in drawing.blocks:
        if len(block.link) > 1 and {*block.link} <= {*link.pins} - {link.pins[0]}:
            yield block.link[0], block.link[-1]


def pin_wishes(drawing: Drawing, pins: dict[str, Array]) -> list[Wish]:
    """Names of the pins in the first position, outside the mechanism."""
    middle = np.mean(np.concatenate(list(pins.values()), axis=1), axis=1)
    return [
        Wish(pin[:, 0], spoken_name(name), angle_of(pin[:, 0] - middle))
        for name, pin in pins.items()
        if name not in drawing.ends
    ]


def _numbers(name: str, pins: dict[str, Array], drawing: Drawing, scale: float, letter: str = "") -> Iterator[Wish]:
    """Numbers of a pin's positions; where it passes a place twice, both stand together; the first with its letter."""
    pin = pins[name]
    bases = [link.pins[0] for link in drawing.links if name in link.pins[1:] and link.pins[0] in drawing.fixed]
    across = [float(np.squeeze(guide.direction)) - np.pi / 2 for guide in drawing.guides if guide.pin == name]
    for number, few in enumerate(sorted(alike(pin, scale), key=lambda one: tuple(pin[:, one[0]]))):
        point = pin[:, few[0]]
        if across:
            outward = across[0] + np.pi * (number % 2)
            point = point + 2.6 * scale * np.array([np.cos(outward), np.sin(outward)])
        else:
            outward = angle_of(point - pins[bases[0] if bases else "O"][:, 0])
        words = ",".join(map(str, few))
        is_named = 0 in few and letter
        yield Wish(point, f"{letter}{words.translate(INDICES)}" if is_named else words, outward, "number")


def alike(points: Array, scale: float) -> list[list[int]]:
    """Put points together that fall on one place on paper, by their numbers; without those that are nowhere."""
    drawn = np.flatnonzero(np.all(np.isfinite(points), axis=0)).tolist()
    return list(grouped((tuple(np.round(points[:, i] / (0.5 * scale))), i) for i in drawn).values())


def frame_lines(drawing: Drawing, pins: dict[str, Array], scale: float) -> Iterator[Line | Circle]:
    """Guides and fixed pivots."""
    for guide in drawing.guides:
        line = guide_line(guide.direction, pins[guide.pin][:, 0])
        places = line.along @ pins[guide.pin]
        for side in (-2.0, 2.0):
            wall = line.path((min(places) - 5 * scale, side * scale), (max(places) + 5 * scale, side * scale))
            yield Line(wall, "GUIDES", "thin", 2)
            yield shapes.hatch(wall[:, 0], wall[:, 1], np.sign(side) * line.across, scale)
        shafts = [float(line.along @ pins[name][:, 0]) for name in drawing.fixed if name.startswith("O")]
        own = shafts[first_smallest(np.abs(np.array(shafts) - places[0]))] if shafts else 0.0
        beyond = max(places) + 8 * scale if places[0] > own else min(places) - 8 * scale
        yield Line(line.path((own, 0.0), (beyond, 0.0)), "GUIDES", "axis", 1)
    for name in drawing.fixed:
        yield from shapes.pivot(pins[name][:, 0], 2.0 * scale, scale)


def _blocks(drawing: Drawing, pins: dict[str, Array], scale: float) -> Iterator[Line]:
    """Blocks in slots in the first position: along the drawn link that has the slot, or toward the slider that has."""
    for block in drawing.blocks:
        slotted = block.link if len(block.link) > 1 else drawing.slotted(block) or (block.pin, *block.link)
        ends = pins[slotted[-1]][:, 0] - pins[slotted[0]][:, 0]
        if np.hypot(*ends) >= 0.1 * scale:
            along = ends / np.hypot(*ends)
            line = Along(pins[block.pin][:, 0], along)
            corners = [(-2.0, -1.2), (2.0, -1.2), (2.0, 1.2), (-2.0, 1.2)]
            points = line.path(*((scale * u, scale * v) for u, v in corners))
            yield Line(points, "LINKS", "outline", 2, is_closed=True, fill="light")


def polygon_sketch(polygon: Polygon, *, with_symbols: bool = True, with_corners: bool = True) -> Sketch:
    """Polygon in drawing millimetres: vectors from the pole full, about another pin thin, parts dashed.

    Without room for them, vectors have no symbols, or corners between the parts of a vector no names.
    """
    layer: Layer = "PLAN_V" if polygon.quantity == "velocity" else "PLAN_A"
    habits: dict[Part, Habit] = {
        "absolute": "vector",
        "relative": "part" if polygon.quantity == "velocity" else "thin",
    }
    sketch = Sketch(1.0)
    points = {name: np.array(point) for name, point in polygon.points.items()}
    longest = max(polygon.length(vector) for vector in polygon.vectors)
    for vector in polygon.vectors:
        sketch.add(arrow(points[vector.start], points[vector.end], layer, habits.get(vector.part, "part")))
    sketch.add([Circle(points[POLE], 0.7, layer, "outline", 6, "paper")])
    middle = np.mean(np.stack(list(points.values())), axis=0)
    short = [vector for vector in polygon.vectors if polygon.length(vector) < _CORNER]
    corners = {
        *(vector.end for vector in short if vector.part == "normal"),
        *(vector.start for vector in short if vector.part == "tangential"),
    }
    named = {name: point for name, point in points.items() if name not in corners and (with_corners or "_" not in name)}
    wishes = [Wish(point, name, angle_of(point - middle)) for name, point in _separate(named)]
    is_crowded = len(polygon.vectors) > _MANY
    for vector in polygon.vectors:
        enough = max(_LETTERS_FROM * longest, 10.0)
        if vector.part != "relative":
            enough = min(enough, 12.0)
        is_named = with_symbols and (vector.part == "absolute" or not is_crowded)
        if is_named and polygon.length(vector) > enough:
            half = 0.5 * (points[vector.start] + points[vector.end])
            wishes.append(Wish(half, vector.symbol, angle_of(half - middle)))
    sketch.add(placed_labels(wishes, list(sketch.outline()), 1.0))
    return sketch


def arrow(start: Array, end: Array, layer: Layer, habit: Habit) -> Iterator[Line]:
    """A vector on paper, with a head where it is long enough."""
    yield Line(np.stack([start, end], axis=1), layer, habit, 3)
    if np.hypot(*(end - start)) > _HEADED:
        yield shapes.arrowhead(end, angle_of(end - start), 2.0)._replace(layer=layer)


def _separate(points: dict[str, Array]) -> Iterator[tuple[str, Array]]:
    """Give points by name; those that fall together share their names."""
    names, places = list(points), np.stack(list(points.values()), axis=1)
    for of in together(places, _ONE_PLACE):
        for number, i in enumerate(of):
            yield names[i], places[:, of[0]] + np.array([0.0, -1e-6 * number])


def klein_sketch(construction: Klein, scale: float) -> Sketch:
    """Klein's construction in mm of metal: rod and crank full, what is constructed thin, its polygons dashed."""
    sketch = Sketch(scale)
    points = {name: 1e3 * point for name, point in construction.points.items()}

    def line(names: str, habit: Habit, layer: Layer = "LINKS") -> Line:
        return Line(np.stack([points[name] for name in names], axis=1), layer, habit, 3)

    middle = points["A"]
    arm = float(np.hypot(*(points["C"] - middle)))
    rod = points["B"] - middle
    reaches = (1.15 * float(points["B"] @ construction.stroke), -8.0 * scale)
    axis = np.stack([points["B"] - reach * construction.stroke for reach in reaches], axis=1)
    sketch.add(
        [
            *(line("OAB", "outline"), line("OC", "vector", "PLAN_V"), line("AC", "part", "PLAN_V")),
            *(line("KL", "thin", "PLAN_A"), line("ADN", "part", "PLAN_A"), line("ON", "vector", "PLAN_A")),
            Line(axis, "GUIDES", "axis", 1),
            Circle(middle + rod / 2, float(np.hypot(*rod)) / 2, "PLAN_A", "thin", 2),
            Circle(middle, arm, "PLAN_A", "thin", 2),
            *shapes.pivot(points["O"], 2.0 * scale, scale),
            *(Circle(points[name], 0.7 * scale, "LINKS", "outline", 6, "paper") for name in "OAB"),
        ]
    )
    drawn = {name: point for name, point in points.items() if np.all(np.isfinite(point))}
    wishes = [Wish(point, name, angle_of(point - middle)) for name, point in drawn.items()]
    sketch.add(placed_labels(wishes, [line.points for line in sketch.lines], scale))
    return sketch
