"""Parts of a sheet as a page draws them: in the units in which they are shown, tables as text."""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import TypeAlias

import numpy as np

from cranktrain.language import Words, _
from cranktrain.panels.construction_drawing import ConstructionDrawing
from cranktrain.panels.parts import (
    BarChart,
    CurveCard,
    Notes,
    Part,
    Polars,
    Ruler,
    ShaftShapes,
    Stack,
    Stars,
    Table,
    WearCircles,
    column_texts,
)
from cranktrain.panels.shapes import Bars, Map, Panel, PolarDiagram, Rays, as_shown
from cranktrain.record import record
from cranktrain.saying.scales import Scale, scale_for
from cranktrain.saying.wording import plain
from cranktrain.web.as_seen import in_bits_seen, outlined
from cranktrain.web.saved_curves import differences, with_saved

_UNSEEN = 1e-3
"""Of the largest load of polar diagrams: a line that passes by so far is the same, less than a pixel even enlarged."""


@record
class PageCurves:
    """Panels of curves, one above the other over the same, or side by side, each over its own.

    Attributes
    ----------
    panels : tuple of Panel
        As they are shown.
    over : Words
        What all are over; none where each says its own.
    is_stack : bool
    differences : tuple of Panel
        By how much more each curve is than that of a saved case; none where nothing is beside.
    """

    panels: tuple[Panel, ...]
    over: Words
    is_stack: bool
    differences: tuple[Panel, ...] = ()


@record
class PagePolars:
    """Polar diagrams to one scale, all in its unit, what is said of them, and what enlarges their middle."""

    diagrams: tuple[PolarDiagram, ...]
    unit: str
    notes: Words
    zoom: Words


@record
class PageWear:
    """Circles off which loads take, their sizes in a unit.

    Attributes
    ----------
    rows : tuple of tuple of Rays
    most : float
        The largest size of all.
    words : Words
        Of the scale.
    """

    rows: tuple[tuple[Rays, ...], ...]
    most: float
    words: Words


@record
class PageMaps:
    """Maps over the same two numbers, as they are shown, and what is written along the first."""

    maps: tuple[Map, ...]
    over: Words


@record
class PageTable:
    """A table as text.

    Attributes
    ----------
    title : Words
    heads, groups : tuple of Words
        Of each column; of which group it is.
    rows : tuple of tuple of str
    methods : tuple of int
        Places of methods whose lines stand before the rows, if any.
    notes : tuple of Words
    of_words : tuple of int
        Columns that stand to the left, beside the first.
    """

    title: Words
    heads: tuple[Words, ...]
    groups: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]
    methods: tuple[int, ...]
    notes: tuple[Words, ...]
    of_words: tuple[int, ...] = ()


@record
class PageSection:
    """Tables and sentences under a heading."""

    heading: Words
    parts: tuple[PageTable | Notes, ...]


@record
class PageEvent:
    """Something that happens in time.

    Attributes
    ----------
    at : float
        When, in the unit of the curves.
    number : int
        By which the curves name it, 0 of what comes often.
    time, name, angle, speed : Words
        When, what, at which crank angle and speed of the crank, as the terminal writes it.
    """

    at: float
    number: int
    time: Words
    name: Words
    angle: Words
    speed: Words


@record
class PageEvents:
    """Events in the order of time, under a title."""

    title: Words
    events: tuple[PageEvent, ...]


@record
class EventStrip:
    """Events where they stand over the curves below, which go from the beginning to an end."""

    events: tuple[PageEvent, ...]
    end: float


PagePart: TypeAlias = (
    PageCurves
    | PageMaps
    | PagePolars
    | Bars
    | Stars
    | PageWear
    | ShaftShapes
    | PageTable
    | PageSection
    | ConstructionDrawing
    | PageEvents
    | EventStrip
    | Notes
    | Ruler
)


def page_parts(parts: Sequence[Part], saved: Sequence[Part] = ()) -> Iterator[PagePart]:
    """Give parts of a sheet as a page draws them; throws it draws itself, at the angle at which it stands.

    saved: the parts of the same sheet of a saved case, whose curves stand among these.
    """
    for place, part in enumerate(parts):
        beside = saved[place] if place < len(saved) and type(saved[place]) is type(part) else None
        match part:
            case Stack(over=over):
                yield page_curves(part, over or _("Crank angle φ, °"), beside)
            case CurveCard():
                yield page_curves(part, "", beside)
            case Polars(diagrams=diagrams, notes=notes):
                yield _polars(diagrams, notes)
            case BarChart(bars=bars):
                yield _bars(bars)
            case WearCircles():
                yield _wear(part)
            case Table():
                yield _table(part)
            case Stars() | ShaftShapes() | Notes() | Ruler():
                yield part
            case _:
                pass


def page_curves(part: Stack | CurveCard, over: Words, saved: Part | None = None) -> PageCurves:
    """Give panels in the units in which they are shown, with those of a saved case among them."""
    others = saved.panels if isinstance(saved, Stack | CurveCard) else ()
    return PageCurves(
        tuple(map(as_shown, with_saved(part.panels, others))),
        over,
        is_stack=isinstance(part, Stack),
        differences=tuple(map(as_shown, differences(part.panels, others))),
    )


def _polars(diagrams: Sequence[PolarDiagram], notes: Words) -> PagePolars:
    """Give diagrams in one unit."""
    most = max(float(np.max(np.abs(curve.points))) for diagram in diagrams for curve in diagram.curves)
    scale = scale_for("N", most)
    shown = tuple(_polar(one, scale, most) for one in diagrams)
    return PagePolars(shown, scale.label, notes, _("Enlarge the middle"))


def _polar(diagram: PolarDiagram, scale: Scale, most: float) -> PolarDiagram:
    """Give a diagram in a unit: the first curve whole, as it is read, too, of the others what is seen."""
    first, *others = (curve.points for curve in diagram.curves)
    seen = (in_bits_seen(scale.of(own), scale.of(most)) for own in outlined(others, _UNSEEN * most))
    points = zip(diagram.curves, (scale.of(first), *seen), strict=True)
    curves = tuple(replace(curve, points=own) for curve, own in points)
    return replace(diagram, curves=curves, largest=scale.of(diagram.largest), marks=scale.of(diagram.marks))


def _bars(bars: Bars) -> Bars:
    """Give bars in the unit in which they are shown."""
    scale = scale_for(bars.unit, float(np.max(np.abs([bars.low, bars.high]))))
    return replace(bars, unit=scale.label, low=scale.of(bars.low), high=scale.of(bars.high))


def _wear(circles: WearCircles) -> PageWear:
    """Give circles with the words of their scale: the largest load, as it is."""
    most = max(float(np.max(one.size)) for row in circles.rows for one in row)
    scale = scale_for("N", most)
    return PageWear(circles.rows, most, circles.words.format(force=plain(float(scale.of(most))), unit=scale.label))


def _table(table: Table) -> PageTable:
    """Give a table as text."""
    columns = [column_texts(one) for one in table.columns]
    return PageTable(
        title=table.title,
        heads=tuple(one.head for one in table.columns),
        groups=tuple(one.group for one in table.columns),
        rows=tuple(zip(*columns, strict=True)),
        methods=table.samples,
        notes=table.notes,
    )
