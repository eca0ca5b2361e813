"""Parts of a sheet as a page draws them: in the units in which they are shown, tables as text."""

from collections.abc import Iterator, Sequence
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from cranktrain.language import Words, _
from cranktrain.motion import Array
from cranktrain.panels.parts import (
    BarChart,
    CurveCard,
    Notes,
    Part,
    Polars,
    Ruler,
    RulerMark,
    ShaftShapes,
    Stack,
    Stars,
    Table,
    WearCircles,
    column_texts,
)
from cranktrain.panels.shapes import Bars, Panel, PolarDiagram, Rays, ShaftShape, as_shown
from cranktrain.record import record
from cranktrain.saying.scales import Scale, scale_for
from cranktrain.saying.wording import plain


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
    """

    panels: tuple[Panel, ...]
    over: Words
    is_stack: bool


@record
class PagePolarCurve:
    """Load over the cycle: to the right and up, shape (2, n), in the unit of its diagram; place of its method.

    What is by no method has the place −1.
    """

    points: Array
    place: int


@record
class PagePolar:
    """A polar diagram, all in one unit.

    Attributes
    ----------
    title : Words
    curves : tuple of PagePolarCurve
        The first one first.
    largest : Array, shape (2,)
        Where the first has its largest.
    largest_at : float
        [deg]
    cycle : float
        [deg]
    marked : Array, shape (k,)
        Crank angles of marks along the first curve. [deg]
    marks : Array, shape (2, k)
    """

    title: Words
    curves: tuple[PagePolarCurve, ...]
    largest: Array
    largest_at: float
    cycle: float
    marked: Array
    marks: Array


@record
class PagePolars:
    """Polar diagrams to one scale, its unit, and what is said of them."""

    diagrams: tuple[PagePolar, ...]
    unit: str
    notes: Words


@record
class PageBars:
    """Bars in the unit in which they are shown, as `Bars` has them."""

    title: Words
    unit: str
    low: Array
    high: Array
    is_filled: NDArray[np.bool_]
    across: Array
    names: tuple[str, ...]
    framed: int
    notes: tuple[Words, ...]


@record
class PageStars:
    """Rays with names, side by side."""

    title: Words
    rays: tuple[Rays, ...]


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
class PageShapes:
    """Shapes along one shaft, the first at the top, over the names of its places."""

    title: Words
    shapes: tuple[ShaftShape, ...]
    names: tuple[str, ...]


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
    """

    title: Words
    heads: tuple[Words, ...]
    groups: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]
    methods: tuple[int, ...]
    notes: tuple[Words, ...]


@record
class PageNotes:
    """Sentences, each a paragraph."""

    sentences: tuple[Words, ...]


@record
class PageRuler:
    """Dead centres over the curves below it, and which textbook form stands beside these, if any."""

    heading: Words
    marks: tuple[RulerMark, ...]
    textbook: Words


PagePart: TypeAlias = (
    PageCurves | PagePolars | PageBars | PageStars | PageWear | PageShapes | PageTable | PageNotes | PageRuler
)


def page_parts(parts: Sequence[Part]) -> Iterator[PagePart]:
    """Give parts of a sheet as a page draws them; throws it draws itself, at the angle at which it stands."""
    for part in parts:
        match part:
            case Stack(panels=panels, over=over):
                yield PageCurves(tuple(map(as_shown, panels)), over or _("Crank angle φ, °"), is_stack=True)
            case CurveCard(panels=panels):
                yield PageCurves(tuple(map(as_shown, panels)), "", is_stack=False)
            case Polars(diagrams=diagrams, notes=notes):
                yield _polars(diagrams, notes)
            case BarChart(bars=bars):
                yield _bars(bars)
            case Stars(title=title, rays=rays):
                yield PageStars(title, rays)
            case WearCircles():
                yield _wear(part)
            case ShaftShapes(title=title, shapes=shapes, names=names):
                yield PageShapes(title, shapes, names)
            case Table():
                yield _table(part)
            case Notes(sentences=sentences):
                yield PageNotes(sentences)
            case Ruler(heading=heading, marks=marks, textbook=textbook):
                yield PageRuler(heading, marks, textbook)
            case _:
                pass


def _polars(diagrams: Sequence[PolarDiagram], notes: Words) -> PagePolars:
    """Give diagrams in one unit."""
    most = max(float(np.max(np.abs(curve.points))) for diagram in diagrams for curve in diagram.curves)
    scale = scale_for("N", most)
    return PagePolars(tuple(_polar(one, scale) for one in diagrams), scale.label, notes)


def _polar(diagram: PolarDiagram, scale: Scale) -> PagePolar:
    """Give a diagram in a unit."""
    return PagePolar(
        title=diagram.title,
        curves=tuple(
            PagePolarCurve(scale.of(curve.points), -1 if curve.place is None else curve.place)
            for curve in diagram.curves
        ),
        largest=scale.of(diagram.largest),
        largest_at=diagram.largest_at,
        cycle=diagram.cycle,
        marked=diagram.marked,
        marks=scale.of(diagram.marks),
    )


def _bars(bars: Bars) -> PageBars:
    """Give bars in the unit in which they are shown."""
    scale = scale_for(bars.unit, float(np.max(np.abs([bars.low, bars.high]))))
    return PageBars(
        title=bars.title,
        unit=scale.label,
        low=scale.of(bars.low),
        high=scale.of(bars.high),
        is_filled=bars.is_filled,
        across=bars.across,
        names=bars.names,
        framed=bars.framed,
        notes=bars.notes,
    )


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
