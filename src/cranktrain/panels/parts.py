"""A sheet as data: columns of parts, each a shape or a table with the room that it wants; and what heads it."""

from collections.abc import Callable, Sequence
from functools import cached_property
from typing import TypeAlias

import numpy as np

from cranktrain.analysis import Result, sentences
from cranktrain.language import Message, Words
from cranktrain.layout.speed import SpeedCurve
from cranktrain.machine import Machine
from cranktrain.motion import Array
from cranktrain.panels.figures import column
from cranktrain.panels.shapes import Bars, Panel, PolarDiagram, Rays, ShaftShape, peak
from cranktrain.panels.throw_scene import Scene
from cranktrain.record import record
from cranktrain.saying.scales import scale_for
from cranktrain.saying.wording import ABSENT


@record
class Stack:
    """Panels one above the other over the same: the crank angle unless said; they fill what a column has left.

    Those `of_motion` have the symbol of their quantity beside their title; tall ones are as high as there is room.
    """

    panels: tuple[Panel, ...]
    over: Words | None = None
    of_motion: bool = False
    is_tall: bool = False


@record
class CurveCard:
    """Panels side by side, each over its own: `height` in parts of the column's; named curves have a legend below.

    Where there is no room for it, it may be left out.
    """

    panels: tuple[Panel, ...]
    height: float
    is_optional: bool = False


@record
class Polars:
    """Polar diagrams side by side, all to one scale, over the words for that.

    `height` is in parts of the column's, `least` in mm; without a height they fill what the column has left. Groups of
    `n_beside` stay beside each other, on as many sheets one below the other as let them be told apart.
    """

    diagrams: tuple[PolarDiagram, ...]
    height: float | None = None
    least: float = 0.0
    notes: Words = ""
    n_beside: int | None = None


@record
class BarChart:
    """Bars over their notes: `height` in parts of the column's."""

    bars: Bars
    height: float


@record
class Stars:
    """Rays with names, side by side."""

    title: Words
    rays: tuple[Rays, ...]


@record
class WearCircles:
    """Circles, in rows that belong together, off which loads take; they fill what a column has left.

    words: with `{force}`, `{unit}`, of their scale; left_out: with `{n}`, of those that find no room.
    """

    rows: tuple[tuple[Rays, ...], ...]
    words: Message
    left_out: Message


@record
class ShaftShapes:
    """Shapes along one shaft, the first at the top, over the names of its places."""

    title: Words
    shapes: tuple[ShaftShape, ...]
    names: tuple[str, ...]


@record
class TableColumn:
    """A column of a table.

    Attributes
    ----------
    head : Words
    cells : Array or sequence of Words
        Numbers in SI; or what is said.
    unit : str
        Of the numbers, as the catalogue has it; none where they stand as they are.
    beside : float
        Size of a number in whose unit they stand, if that is larger than all.
    decimals : int, optional
        Of numbers that stand as they are; four figures unless given.
    group : str
        What stands over it and its neighbours.
    """

    head: Words
    cells: Array | Sequence[Words]
    unit: str = ""
    beside: float = 0.0
    decimals: int | None = None
    group: str = ""


def column_texts(of: TableColumn) -> list[str]:
    """Write the cells of a column."""
    cells = of.cells
    if not isinstance(cells, np.ndarray):
        return list(map(str, cells))
    if of.decimals is not None:
        return [f"{one:.{of.decimals}f}" if np.isfinite(one) else ABSENT for one in cells.tolist()]
    return column(cells.tolist(), scale_for(of.unit or "1", max(peak(cells), of.beside)))


@record
class Table:
    """A table; where it has no room, rows of low rank are left out, and that is said.

    Attributes
    ----------
    columns : tuple of TableColumn
        The first to the left, all others to the right.
    ends : tuple of float
        Where the others end, in parts of the width; evenly unless given.
    samples : tuple of int
        Places of methods whose lines stand before the rows, if any.
    ranks : Array, shape (row,), optional
        By which rows stay; the first ones unless given.
    left_out : Message
        With `{n}`, what is said of those that do not; how many they are, unless given.
    notes : tuple of Words
        Below it.
    title : Words
        Over it, if any.
    """

    columns: tuple[TableColumn, ...]
    ends: tuple[float, ...] = ()
    samples: tuple[int, ...] = ()
    ranks: Array | None = None
    left_out: Message | None = None
    notes: tuple[Words, ...] = ()
    title: Words = ""

    @property
    def n_rows(self) -> int:
        """How many rows it has below its head."""
        return len(self.columns[0].cells)


@record
class Notes:
    """Sentences, each in lines of its own; where they can go on, what finds no room stands below the column before."""

    sentences: tuple[Words, ...]
    can_go_on: bool = False


@record
class ThrowAtAngle:
    """A throw at a crank angle [deg] under its loads, and what heads it; left out where there is no room."""

    scene: Scene
    at: float
    title: Words


@record
class ThrowsAtAngle:
    """Throws: scenes, the crank angle [deg], dead positions of each member [deg], what is said of it."""

    scenes: tuple[Scene, ...]
    at: float
    dead: tuple[tuple[tuple[float, ...], ...], ...]
    notes: tuple[Words, ...]


@record
class DrawnThrows:
    """Throws that fill what a column has left: found when they are drawn, as a page draws its own.

    `scale` is that which is asked for, millimetres of metal in one of paper.
    """

    find: Callable[[], ThrowsAtAngle]
    scale: float | None = None

    @cached_property
    def found(self) -> ThrowsAtAngle:
        """Those throws."""
        return self.find()


@record
class RulerMark:
    """A dead centre: whose, at which crank angle [deg], whether it is the top, and its word."""

    name: str
    angle: float
    is_top: bool
    word: Words


@record
class Ruler:
    """Dead centres over the curves below it.

    Attributes
    ----------
    heading : Words
    marks : tuple of RulerMark
    pistons : tuple of str
        Names of the curves.
    textbook : Words
        Forms beside the curves, if any.
    is_of_cylinders : bool
        Whether the marks are of cylinders and not of these pistons.
    """

    heading: Words
    marks: tuple[RulerMark, ...]
    pistons: tuple[str, ...] = ()
    textbook: Words = ""
    is_of_cylinders: bool = False


Part: TypeAlias = (
    Stack
    | CurveCard
    | Polars
    | BarChart
    | Stars
    | WearCircles
    | ShaftShapes
    | Table
    | Notes
    | ThrowAtAngle
    | DrawnThrows
    | Ruler
)


@record
class SheetColumn:
    """Parts one below the other, in a share of the sheet's width."""

    share: float
    parts: tuple[Part, ...]


@record
class Sheet:
    """A sheet of paper.

    Attributes
    ----------
    machine : Machine
        Which it is of.
    title : Words
    columns : tuple of SheetColumn
    at_speed : Words
        At which speed, if that is not constant.
    unused : tuple of Words
        What of the machine's file is not used.
    """

    machine: Machine
    title: Words
    columns: tuple[SheetColumn, ...]
    at_speed: Words = ""
    unused: tuple[Words, ...] = ()


def sheet_of(result: Result, design: int, title: Words, *columns: SheetColumn) -> Sheet:
    """Make a sheet of a design of a result."""
    curve = result.get(SpeedCurve)
    at_speed = "" if curve is None else curve.condition(design)
    return Sheet(result.machines[design], title, columns, at_speed, tuple(sentences(result.unused)))


def facts_table(heading: Words, facts: Sequence[tuple[Words, Words]]) -> Table:
    """Make a table of facts: what each is, and its amount."""
    words, amounts = zip(*facts, strict=True)
    return Table((TableColumn(heading, words), TableColumn("", amounts)), (1.0,))
