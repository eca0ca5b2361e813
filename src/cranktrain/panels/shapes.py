"""The six shapes of a panel: curves, polar diagrams, bars, rays, shapes along a shaft, maps; all as data, in SI.

Words are said, and units chosen, by whoever draws them.
"""

from dataclasses import replace
from typing import Literal, TypeAlias

import numpy as np
from numpy.typing import NDArray

from cranktrain.language import Words
from cranktrain.motion import Array
from cranktrain.numerics.ties import ALIKE
from cranktrain.record import record
from cranktrain.saying.scales import Scale, scale_for

# fmt: off
Role: TypeAlias = Literal[
    "first", "second", "other", "textbook", "error", "main", "side", "radial", "resultant", "formula", "chamber",
    "whole", "mean", "each", "carried", "card", "later_card", "ray", "half_ray",
    "saved",
]
# fmt: on
"""What a curve is among those of its panel, by which a face chooses its line."""


_MARKS = 30.0
"""Between marks of the crank angle along a polar diagram. [deg]"""


def peak(values: Array) -> float:
    """Size of the largest value that is known."""
    return float(np.fmax.reduce(np.abs(values), axis=None, initial=0.0))  # as nanmax, in a third of its time


def is_level(values: Array) -> bool:
    """Whether all values that are known are one, but for rounding; so is one alone, and none is not."""
    known = values[np.isfinite(values)]
    return bool(known.size and np.ptp(known) <= ALIKE * peak(known))


def scale_of(unit: Words, size: float) -> Scale:
    """In which unit values are shown, of which the largest has a size: a message is its own unit."""
    return scale_for(unit, size) if isinstance(unit, str) else Scale(str(unit), factor=1.0)


@record
class Curve:
    """A curve of a panel.

    Attributes
    ----------
    values : Array, shape (n,)
        In SI until the panel is as it is shown, then in its unit; NaN where links cannot close.
    role : Role
    letter : str
        Of the quantity whose colour it has; none of what is of no quantity.
    symbol : str
        By which a legend names it, as mathematics sets it; of a curve without a name there nothing.
    name : Words
        Whose it is, or what.
    across : Array, shape (n,), optional
        Where it stands, unless with all others.
    is_cloud : bool
        Whether it is points that no line joins.
    """

    values: Array
    role: Role
    letter: str
    symbol: str = ""
    name: Words = ""
    across: Array | None = None
    is_cloud: bool = False


@record
class Mark:
    """A point of a panel.

    Attributes
    ----------
    across, value : float
    sort : "ring", "dot", "angle" or "change"
        A hollow ring on a curve; a filled dot; a dot at a crank angle, named beside it; a ring with a line down
        through the panel.
    words : Words
        What stands beside it, or of a change in rows below.
    size : float
        Area of a dot, in parts of the largest that there may be.
    angle : float
        Crank angle of a dot at one. [deg]
    """

    across: float
    value: float
    sort: Literal["ring", "dot", "angle", "change"]
    words: Words = ""
    size: float = 1.0
    angle: float = np.nan


@record
class PanelLine:
    """A line across a panel at a value, or with `is_upright` at what the panel is over.

    Attributes
    ----------
    at : float
    role : "limit", "natural", "declared", "event" or "often"
        An end of a range; a natural frequency; the declared speed; something that happens, rarely or often.
    symbol : str
        As mathematics sets it.
    number : int
        By which a table names it, 0 of one without.
    is_upright : bool
    """

    at: float
    role: Literal["limit", "natural", "declared", "event", "often"]
    symbol: str = ""
    number: int = 0
    is_upright: bool = False


@record
class Panel:
    """Curves of one quantity, with what marks them.

    Attributes
    ----------
    title : Words
    unit : Words
        Of the catalogue; once it is as it is shown, or a message, what is written.
    across : Array, shape (n,)
        What the curves are over: crank angles from 0 to the end of the turn or the cycle, both included, unless the
        title or the stack in which it stands says something else.
    curves : tuple of Curve
    symbol : str
        Of the quantity, as mathematics sets it, where all curves have one.
    across_unit : str
        Of what the curves are over, likewise.
    over : Words
        What is written along it, of a panel that stands alone.
    marks : tuple of Mark
    levels : tuple of PanelLine
    below : tuple of (float, Words)
        What stands in rows under the curves, as far as there is room, and where.
    corner : tuple of Words
        Lines in the upper right corner.
    limits : tuple of float, optional
        Least and largest value that are drawn.
    reach : tuple of float, optional
        From where to where it is drawn across.
    hatched : tuple of (float, float)
        From where to where across nothing can be.
    dimension : str
        Symbol of the distance between the two limits among its levels, drawn as a dimension; none unless given.
    """

    title: Words
    unit: Words
    across: Array
    curves: tuple[Curve, ...]
    symbol: str = ""
    across_unit: str = "deg"
    over: Words = ""
    marks: tuple[Mark, ...] = ()
    levels: tuple[PanelLine, ...] = ()
    below: tuple[tuple[float, Words], ...] = ()
    corner: tuple[Words, ...] = ()
    limits: tuple[float, float] | None = None
    reach: tuple[float, float] | None = None
    hatched: tuple[tuple[float, float], ...] = ()
    dimension: str = ""

    @property
    def size(self) -> float:
        """Of the largest value that is drawn."""
        drawn = [curve.values for curve in self.curves] if self.limits is None else [np.array(self.limits)]
        return max(map(peak, drawn))

    @property
    def values(self) -> Array:
        """Values of all curves over the same, shape (n_curves, n)."""
        return np.stack([curve.values for curve in self.curves if curve.across is None])

    def across_of(self, curve: Curve) -> Array:
        """Where a curve stands."""
        return self.across if curve.across is None else curve.across


@record
class Map:
    """A quantity over two numbers.

    Attributes
    ----------
    title, unit : Words
        As of a `Panel`.
    across, up : Array, shape (n,), (m,)
        The two numbers, in their units; what they are over stands with the plot.
    values : Array, shape (m, n)
        NaN where there is none.
    up_unit : str
    upward : Words
        What is written along the second.
    marks : tuple of Mark
    """

    title: Words
    unit: Words
    across: Array
    up: Array
    values: Array
    up_unit: str
    upward: Words
    marks: tuple[Mark, ...] = ()


def map_as_shown(shown: Map) -> Map:
    """Give a map with its values in the unit in which they are shown, and the label of that."""
    scale = scale_of(shown.unit, peak(shown.values))
    return replace(shown, unit=scale.label, values=scale.of(shown.values))


def scales_of(panel: Panel) -> tuple[Scale, Scale]:
    """In which units a panel is shown, along and up."""
    own = [curve.across for curve in panel.curves if curve.across is not None]
    furthest = max(map(peak, own if len(own) == len(panel.curves) else [panel.across, *own]))
    return scale_for(panel.across_unit, furthest), scale_of(panel.unit, panel.size)


def as_shown(panel: Panel) -> Panel:
    """Give a panel with all in the units in which they are shown, and the labels of these."""
    along, up = scales_of(panel)

    def both(ends: tuple[float, float] | None, scale: Scale) -> tuple[float, float] | None:
        return None if ends is None else (float(scale.of(ends[0])), float(scale.of(ends[1])))

    return replace(
        panel,
        unit=up.label,
        across_unit=along.label,
        across=along.of(panel.across),
        curves=tuple(
            replace(curve, values=up.of(curve.values), across=None if curve.across is None else along.of(curve.across))
            for curve in panel.curves
        ),
        marks=tuple(
            replace(one, across=float(along.of(one.across)), value=float(up.of(one.value))) for one in panel.marks
        ),
        levels=tuple(replace(one, at=float((along if one.is_upright else up).of(one.at))) for one in panel.levels),
        below=tuple((float(along.of(at)), words) for at, words in panel.below),
        limits=both(panel.limits, up),
        reach=both(panel.reach, along),
        hatched=tuple((float(along.of(one)), float(along.of(other))) for one, other in panel.hatched),
    )


@record
class PolarCurve:
    """Load over the cycle: to the right and up, closed, shape (2, n) [N]; place of its method by trust, from 0.

    What is by no method has the place None.
    """

    points: Array
    place: int | None = None


@record
class PolarDiagram:
    """Loads of one bearing, pin or joint.

    Attributes
    ----------
    title : Words
    curves : tuple of PolarCurve
        The first one first.
    largest : Array, shape (2,)
        Where the first has its largest, on its curve. [N]
    largest_at, cycle : float
        Crank angle of that, and after which all repeats. [deg]
    marked : Array, shape (k,)
        Crank angles of marks along the first curve, each 30°. [deg]
    marks : Array, shape (2, k)
        Where these are, on the curve. [N]
    """

    title: Words
    curves: tuple[PolarCurve, ...]
    largest: Array
    largest_at: float
    cycle: float
    marked: Array
    marks: Array


def polar_diagram(
    title: Words, curves: tuple[PolarCurve, ...], angles: Array, largest: Array, largest_at: float
) -> PolarDiagram:
    """Give a polar diagram with its marks.

    Parameters
    ----------
    title : Words
    curves : tuple of PolarCurve
    angles : Array, shape (n,)
        Crank angles of the points of all curves, from 0 to the end of the cycle, both included. [deg]
    largest : Array, shape (2,)
        [N]
    largest_at : float
        [deg]
    """
    cycle = float(angles[-1])
    marked = np.arange(0.0, cycle, _MARKS)
    ways: list[Array] = [np.asarray(np.interp(marked, angles, part), np.float64) for part in curves[0].points]
    marks: Array = np.stack(ways)
    return PolarDiagram(title, curves, largest, largest_at, cycle, marked, marks)


@record
class Bars:
    """Bars from one value to another, side by side.

    Attributes
    ----------
    title : Words
    unit : str
        Of the catalogue.
    low, high : Array, shape (n,)
        Where each begins and ends.
    is_filled : array of bool, shape (n,)
    across : Array, shape (n,)
        Where they stand: numbers of what they are over, such as orders, or their places.
    names : tuple of str
        Of those that are places, by groups "group.name" where there are several; "" of one without.
    framed : int
        Which is framed; −1 of none.
    notes : tuple of Words
    """

    title: Words
    unit: str
    low: Array
    high: Array
    is_filled: NDArray[np.bool_]
    across: Array
    names: tuple[str, ...] = ()
    framed: int = -1
    notes: tuple[Words, ...] = ()


@record
class Rays:
    """Sizes in directions round a point.

    Attributes
    ----------
    title : Words
    direction : Array, shape (n,)
        On paper, anticlockwise from the right. [rad]
    size : Array, shape (n,)
        Of a wear in N, taken off a circle; of a star 1.
    names : tuple of str
        Of a star's rays.
    hole : float
        Direction of an oil hole, NaN of none. [rad]
    hole_angle : float
        What is written beside it. [rad]
    """

    title: Words
    direction: Array
    size: Array
    names: tuple[str, ...] = ()
    hole: float = np.nan
    hole_angle: float = np.nan


@record
class ShaftShape:
    """A shape along a shaft, such as a mode of torsion.

    Attributes
    ----------
    title : Words
    amplitude : Array, shape (place,)
    following : array of int, shape (place − 1,)
        To which place the shaft of each but the last leads.
    nodes : Array, shape (node,)
        Where it is 0: 2.3 is 0.3 of the way from place 2 to the one that its shaft leads to, if that is place 3.
    """

    title: Words
    amplitude: Array
    following: NDArray[np.intp]
    nodes: Array
