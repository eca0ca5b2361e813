"""Fig. 35 of [crankshaft-reactions]: a throw with its lengths to scale and its forces, from the side and from above."""

from collections.abc import Iterator, Sequence
from itertools import pairwise

import numpy as np

from cranktrain.language import said as _
from cranktrain.motion import Array
from cranktrain.panels.figures import with_unit
from cranktrain.panels.formulas import mathematics
from cranktrain.plans.machine_throw import MachineThrow, ThrownMachine
from cranktrain.plans.stroke_lines import unit
from cranktrain.plans.throw_loads import CrankMasses
from cranktrain.plans.throw_scheme import SchemeForce, SchemeLength, ThrowScheme, throw_scheme
from cranktrain.references import REFERENCES
from cranktrain.saying.scales import scale_for
from cranktrain.texts.throw_table import Throw
from cranktrain.viz.paper import shapes
from cranktrain.viz.paper.curves import axes_in
from cranktrain.viz.paper.page import MARGIN, Box, Figure, Page, drawing_settings, fitting_scale, paper
from cranktrain.viz.paper.sketch import Circle, Label, Line, Sketch
from cranktrain.viz.paper.style import COLOURS, MUTED, TITLE
from cranktrain.viz.paper.tables import LEAST_ROW, write_table

_RADIUS, _JOURNAL, _PIN, _WEB, _BELOW = 17.0, 4.5, 4.0, 7.0, 10.0
"""Of the throw, which has none in the text; half a journal, a pin, a web; a web below the axis. [mm of paper]"""

_LONGEST, _SHORTEST, _HEAD = 14.0, 6.5, 2.4
"""Length of the arrow of the largest force and of a small one, and of its head. [mm of paper]"""

_PLAN, _CHAIN, _OVER = 72.0, 34.0, 41.5
"""How far below the shaft's axis the view from above is, and the lines of lengths. [mm of paper]"""

_NARROW = 6.5
"""A length so short on paper has its letter a row lower. [mm]"""

_TABLE = 76.0
"""Width of the table. [mm]"""

_ASIDE = 4.6
"""From one arrow to the next where several act at one place. [mm of paper]"""

_FREE = 5.6
"""Of a letter above its arrow. [mm of paper]"""


_OVER_CYCLE = 92.0
"""Height of the curves over the cycle. [mm]"""


@drawing_settings()
def throw_figure(throw: Throw, name: str = "", size: str = "A4") -> Figure:
    """Draw a throw with the symbols of the source's figure, beside what each is.

    Parameters
    ----------
    throw : Throw
    name : str
        Of its file.
    size : "A4" or "A3"

    Returns
    -------
    Figure
    """
    page = Page(*paper(size))
    heads = (name or _("Throw"), _("Scheme with the symbols of fig. 35 of [{source}]"))
    _draw_scheme(page, throw, heads, MARGIN, is_clockwise=True)
    return page.figure


@drawing_settings()
def machine_throw_figure(
    of: ThrownMachine, name: str | None = None, at: float | None = None, masses: CrankMasses = "given", size: str = "A3"
) -> Figure:
    """Draw a machine's throw as fig. 35 has it, and the loads on its bearings over the cycle by the text.

    Parameters
    ----------
    of : ThrownMachine
    name : str, optional
        Of the throw; the first unless given.
    at : float, optional
        Crank angle of the forces; where the largest load of both bearings is unless given. [deg]
    masses : "given" or "sizes"
    size : "A4" or "A3"

    Returns
    -------
    Figure
    """
    name = next(iter(of.throws)) if name is None else name
    over = of.throw(name, of.crank_angle, masses)
    at = of.usual_angle(over) if at is None else at
    one = of.throw(name, np.array([at]), masses)
    page = Page(*paper(size))
    heading = _("Throw {name} at {at}°, bearings {left} (L) and {right} (P), with the symbols of fig. 35 of [{source}]")
    said = heading.format(
        name=name, at=f"{at:g}".replace("-", "−"), left=one.bearings[0], right=one.bearings[1], source=_SOURCE
    )
    _draw_scheme(page, one.first(), (of.machine.name, said), MARGIN + _OVER_CYCLE, is_clockwise=one.is_clockwise)
    _draw_cycle(page, of.crank_angle, over, at)
    return page.figure


def _draw_scheme(page: Page, throw: Throw, heads: tuple[str, str], bottom: float, *, is_clockwise: bool) -> None:
    """Both views of a throw with its table, from the head of the page down to a height on it."""
    found = throw_scheme(throw)
    top = page.height - MARGIN
    page.text(MARGIN, top - 4.5, heads[0], fontsize=TITLE, fontweight="bold")
    page.text(MARGIN, top - 10.0, heads[1].format(source=_SOURCE))
    page.text(MARGIN, top - 14.5, REFERENCES[_SOURCE].text, color=MUTED)
    page.rule(top - 17.5)
    wide = page.width - 2 * MARGIN - _TABLE - 8.0
    start, end = found.over[0].start, found.over[-1].end
    scale = fitting_scale(1e3 * (end - start), 1.0, (wide - 34.0, 1.0))
    sketch = throw_sketch(found, scale)
    left = MARGIN + 20.0 - 1e3 * start / scale + (wide - 34.0 - 1e3 * (end - start) / scale) / 2
    axis = top - 81.0
    page.draw(sketch, (left, axis))
    page.heading(MARGIN, top - 23.5, _("From the side: forces in the crank's plane"))
    page.heading(MARGIN, axis - _OVER - 8.5, _("From above: forces across the crank's plane"))
    _write_table(page, throw, found, Box(page.width - MARGIN - _TABLE, bottom, _TABLE, top - 21.0 - bottom))
    bar_end = page.scale_bar(MARGIN, bottom, scale)
    said = _("To scale along the shaft alone. A longer arrow is a larger force; those of 0 are left out.")
    page.text(bar_end + 36.0, bottom - 0.4, said, color=MUTED)
    seen = (
        _("Seen from the left end the throw turns clockwise: above it moves toward whoever looks from the side.")
        if is_clockwise
        else _("Drawn as if it turned clockwise, seen from the left end; it turns anticlockwise.")
    )
    page.text(MARGIN, bottom + 6.0, seen, color=MUTED)


_PENS = {"k": ("K", COLOURS["K"]), "t": ("T", COLOURS["T"])}
"""Of each part of a load its letter and its colour."""


def _draw_cycle(page: Page, degrees: Array, over: MachineThrow, at: float) -> None:
    """Loads of both bearings over the cycle, by the text and by the split shaft, side by side."""
    wide = (page.width - 2 * MARGIN - 24.0) / 2
    by_text, high = over.by_text, _OVER_CYCLE - 34.0
    loads = [np.broadcast_to(part, degrees.shape) / 1e3 for part in (*by_text, *over.exact)]
    limits = (min(float(np.min(one)) for one in loads), max(float(np.max(one)) for one in loads))
    for place, (side, bearing) in enumerate((("l", over.bearings[0]), ("p", over.bearings[1]))):
        left = MARGIN + 12.0 + place * (wide + 12.0)
        axes = axes_in(page, Box(left, MARGIN + 12.0, wide - 6.0, high))
        for part, (letter, colour) in _PENS.items():
            own, exact = (
                np.broadcast_to(getattr(one, part + side), degrees.shape) / 1e3 for one in (by_text, over.exact)
            )
            axes.plot(degrees, exact, color=MUTED, linewidth=3.2, alpha=0.45, zorder=2)
            axes.plot(
                degrees, own, color=colour, linewidth=1.1, linestyle="-" if letter == "K" else (0, (6.0, 2.0)), zorder=3
            )
        axes.axhline(0.0, color=MUTED, linewidth=0.6, zorder=1)
        axes.axvline(at, color=MUTED, linewidth=0.6, linestyle=(0, (2.0, 2.0)), zorder=1)
        margin = 0.06 * (limits[1] - limits[0])
        cycle = float(degrees.size * (degrees[1] - degrees[0]))
        axes.set(xlim=(0.0, cycle), ylim=(limits[0] - margin, limits[1] + margin))
        axes.set_xticks(np.arange(0.0, cycle + 1.0, cycle / 8.0))
        heading = _("Load on bearing {name} ({letter}), kN", name=bearing, letter=side.upper())
        page.heading(left, MARGIN + 12.0 + high + 6.4, heading)
        _write_legend(page, left, MARGIN + 12.0 + high + 2.0)
    page.text(page.width / 2, MARGIN, _("Crank angle, °; K inward, T with the rotation, at the crank pin"), ha="center")


def _write_legend(page: Page, x: float, y: float) -> None:
    """Samples of the curves."""
    samples = [
        ("K", {"color": COLOURS["K"], "linewidth": 1.1}),
        ("T", {"color": COLOURS["T"], "linewidth": 1.1, "linestyle": (0, (6.0, 2.0))}),
        (_("both by the split shaft"), {"color": MUTED, "linewidth": 3.2, "alpha": 0.45}),
    ]
    for words, pen in samples:
        page.sample(x, x + 9.0, y + 0.8, **pen)
        _start, end = page.ends(page.text(x + 10.5, y, words))
        x = end + 6.0


_SOURCE = "crankshaft-reactions"

_COLUMNS = (0.7, 1.0)
"""Where the columns of the tables end, in parts of their width."""


def throw_sketch(found: ThrowScheme, scale: float) -> Sketch:
    """Both views with their forces and lengths; the left support at the origin, in mm of metal.

    Parameters
    ----------
    found : ThrowScheme
    scale : float
        Millimetres of metal in one of paper.
    """
    sketch = Sketch(scale)
    sketch.add(_throw(found, scale))
    sketch.add(_lengths(found.chain, -_CHAIN, scale))
    sketch.add(_lengths(found.over, -_OVER, scale))
    sketch.add(_extensions(found, scale))
    largest = max((abs(one.value) for one in found.forces), default=1.0)
    sizes = [_SHORTEST + (_LONGEST - _SHORTEST) * abs(one.value) / largest for one in found.forces]
    on_pin = [size for one, size in zip(found.forces, sizes, strict=True) if one.at == "pin"]
    above = max(on_pin) + _FREE + 0.6 if on_pin else 0.6
    for one, size, aside in zip(found.forces, sizes, _asides(found.forces), strict=True):
        sketch.add(_force(one, size, aside, above, scale))
    sketch.add(_rotation(found, scale))
    return sketch


def _throw(found: ThrowScheme, scale: float) -> Iterator[Line | Circle | Label]:
    """Journals, webs and the pin in both views, and the supports."""
    start, end = found.over[0].start, found.over[-1].end
    ends = (1e3 * start - 3.0 * scale, 1e3 * end + 3.0 * scale)
    (one, left), (right, other) = ((1e3 * web[0], 1e3 * web[1]) for web in (found.left_web, found.right_web))
    for middle, is_above in ((0.0, False), (-_PLAN, True)):
        pin = middle if is_above else middle + _RADIUS
        web = (middle - _WEB, middle + _WEB) if is_above else (middle - _BELOW, pin + _WEB)
        yield _block((ends[0], one), middle - _JOURNAL, middle + _JOURNAL, scale, 2)
        yield _block((other, ends[1]), middle - _JOURNAL, middle + _JOURNAL, scale, 2)
        yield _block((left, right), pin - _PIN, pin + _PIN, scale, 2)
        for span in ((one, left), (right, other)):
            yield _block(span, *web, scale, 3)
        axis = np.array([[ends[0] - 4.0 * scale, ends[1] + 4.0 * scale], [middle * scale, middle * scale]])
        yield Line(axis, "GUIDES", "axis", 4)
        if not is_above:
            yield Line(np.array([[left, right], [pin * scale, pin * scale]]), "GUIDES", "axis", 4)
    for place, letter, side in ((0.0, "L", -1.0), (1e3 * _support(found), "P", 1.0)):
        foot = np.array([place, -_JOURNAL * scale])
        yield from shapes.pivot(foot, 3.0 * scale, scale)
        yield Label(np.array([place + 7.0 * side * scale, (-_JOURNAL - 4.5) * scale]), letter, "name")


def _support(found: ThrowScheme) -> float:
    """Place of the right support. [m]"""
    return next(one.end for one in found.over if one.letter == "l")


def _block(span: tuple[float, float], low: float, high: float, scale: float, order: int) -> Line:
    """A rectangle along the shaft, between two heights on paper."""
    x, y = [span[0], span[1], span[1], span[0]], [low * scale, low * scale, high * scale, high * scale]
    return Line(np.array([x, y]), "LINKS", "outline", order, True, "light")


def _asides(forces: Sequence[SchemeForce]) -> Iterator[float]:
    """How far each arrow stands aside, so that those at one place are seen side by side. [mm of paper]"""
    places = [(round(one.place, 9), one.at, one.way) for one in forces]
    for i, place in enumerate(places):
        yield _ASIDE * (places[:i].count(place) - 0.5 * (places.count(place) - 1))


def _force(one: SchemeForce, size: float, aside: float, above: float, scale: float) -> Iterator[Line | Label]:
    """An arrow so long on paper with its letter; a force of less than 0 points the other way.

    Those of the rods in the crank's plane press on the pin from above the arrows of what turns there.
    """
    near, up = _foot(one, above)
    ends = (near, near + up * size)
    points_away = (one.at != "rod" or one.way == "with") == (one.value > 0)
    x = 1e3 * one.place + aside * scale
    start, end = (np.array([x, y * scale]) for y in (ends if points_away else ends[::-1]))
    direction = float(np.arctan2(*(end - start)[::-1]))
    line = np.stack([start, end - 0.7 * _HEAD * scale * unit(direction)], axis=1)
    yield Line(line, "DIMENSIONS", "vector", 8)
    yield shapes.arrowhead(end, direction, _HEAD * scale)._replace(order=9)
    letter = np.array([x, (ends[1] + 2.4 * up) * scale])
    yield Label(letter, _set(one.letter), "words") if "+" in one.letter else Label(letter, one.letter, "symbol")


def _foot(one: SchemeForce, above: float) -> tuple[float, float]:
    """Where a force's arrow begins beside the throw, and on which side of it: +1 above. [mm of paper]

    In the view from above what is against the rotation is up, and T, toward whoever looks from the side, down.
    """
    if one.way in ("against", "with"):
        up = 1.0 if one.way == "against" else -1.0
        return -_PLAN + up * {"rod": _PIN, "web": _WEB}.get(one.at, _JOURNAL), up
    if one.at == "rod":
        return _RADIUS + _PIN + above, 1.0
    feet = {"web": _RADIUS + _WEB, "pin": _RADIUS + _PIN, "counterweight": -_BELOW, "journal": -_JOURNAL}
    return feet[one.at], 1.0 if one.way == "outward" else -1.0


def _lengths(lengths: Sequence[SchemeLength], y: float, scale: float) -> Iterator[Line | Label]:
    """Lengths in a row, each between its arrows; the letter of a short one a little lower."""
    for one in lengths:
        start, end = 1e3 * one.start, 1e3 * one.end
        yield Line(np.array([[start, end], [y * scale, y * scale]]), "DIMENSIONS", "thin", 4)
        wide = (end - start) / scale
        if wide > 4.0:
            yield shapes.arrowhead(np.array([start, y * scale]), np.pi, 1.8 * scale)
            yield shapes.arrowhead(np.array([end, y * scale]), 0.0, 1.8 * scale)
        else:
            yield _tick(start, y, scale)
            yield _tick(end, y, scale)
        above = 2.2 if wide > _NARROW or y != -_CHAIN else -2.6
        yield Label(np.array([(start + end) / 2, (y + above) * scale]), one.letter, "symbol")


def _tick(place: float, y: float, scale: float) -> Line:
    """A stroke where there is no room for an arrow."""
    x = np.array([place - 0.9 * scale, place + 0.9 * scale])
    return Line(np.stack([x, np.array([(y - 0.9) * scale, (y + 0.9) * scale])]), "DIMENSIONS", "thin", 4)


def _extensions(found: ThrowScheme, scale: float) -> Iterator[Line]:
    """Thin lines from what is measured down to its length."""
    l = _support(found)
    for one, following in pairwise((*found.chain, None)):
        if one is not None and following is not None:
            inside = found.left_web[1] < one.end < found.right_web[0]
            top = _RADIUS - _PIN - 1.0 if inside else -_BELOW - 1.0
            yield _upright(one.end, top, -_CHAIN - 1.5, scale)
    for place in {one for length in found.over for one in (length.start, length.end)}:
        top = -_JOURNAL - 9.0 if place in (0.0, l) else -_JOURNAL - _LONGEST - _FREE
        yield _upright(place, top, -_OVER - 1.5, scale)


def _upright(place: float, high: float, low: float, scale: float) -> Line:
    x = np.full(2, 1e3 * place)
    return Line(np.stack([x, np.array([high * scale, low * scale])]), "DIMENSIONS", "thin", 1)


def _rotation(found: ThrowScheme, scale: float) -> Iterator[Line | Label]:
    """Sense of rotation about the shaft's left end, as drawn from the side: the near side goes down from the pin."""
    x = 1e3 * found.over[0].start - 14.0 * scale
    bent = np.array([[x], [0.0]]) + np.array([[2.8], [8.0]]) * scale * shapes.arc(np.zeros(2), 1.0, 1.9, -1.4)
    yield Line(bent, "DIMENSIONS", "outline", 5)
    step: Array = bent[:, -1] - bent[:, -2]
    yield shapes.arrowhead(bent[:, -1], float(np.arctan2(*step[::-1])), 2.4 * scale)
    yield Label(np.array([x, 10.5 * scale]), "ω", "symbol")


def _write_table(page: Page, throw: Throw, found: ThrowScheme, box: Box) -> None:
    """Letters with where they point and their values; lengths below."""
    ways = {
        "outward": _("outward"),
        "inward": _("inward"),
        "against": _("against the rotation"),
        "with": _("with the rotation"),
    }
    rows = [(_("force"), _("positive"), "")]
    rows += [(_set(one.letter), ways[one.way], with_unit(one.value, scale_for("N", 0.0))) for one in found.forces]
    place = (box.left, box.bottom + box.height, box.width)
    low = write_table(page, rows, place, _COLUMNS, LEAST_ROW)
    sizes = [(_("length"), "", "")]
    sizes += [
        (mathematics(one.letter), "", with_unit(one.end - one.start, scale_for("m", 0.0)))
        for one in (*found.chain, *found.over)
    ]
    low = write_table(page, sizes, (box.left, low - 1.0, box.width), _COLUMNS, LEAST_ROW)
    notes = {
        "one": (_("One rod."),),
        "two": (_("Two rods side by side."),),
        "articulated": (_("An articulated pair: K₁, T₁ are its"), _("resultant, on the master's axis.")),
    }[throw.rods]
    page.notes(box.left, low - 1.0, notes)


def _set(letters: str) -> str:
    """Set a sum of letters as mathematics."""
    return " + ".join(map(mathematics, letters.split("+")))
