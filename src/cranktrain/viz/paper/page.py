"""A sheet of paper: a figure on which everything is placed in millimetres, and a sketch drawn on it to scale."""

from collections.abc import Generator, Iterable, Sequence
from contextlib import contextmanager
from functools import partial
from importlib import import_module
from textwrap import wrap
from typing import Any, NamedTuple, TypeAlias

import numpy as np

from cranktrain.errors import InputError, Problem
from cranktrain.language import said as _
from cranktrain.motion import Array
from cranktrain.one_line import visible
from cranktrain.panels.formulas import FORMULA, mathematics
from cranktrain.plans.positions import rounded_scale, scale_words
from cranktrain.saying.amounts import KEPT
from cranktrain.saying.scales import scale_for
from cranktrain.saying.wording import plain
from cranktrain.viz.paper.sketch import Circle, Label, Line, Sketch
from cranktrain.viz.paper.style import FILLS, HEADING, INK, MUTED, RULE, SETTINGS, SYMBOL, TEXT, pen_of

# The plotting library is loaded only where a sheet is drawn, and its own types are partial.
Artist: TypeAlias = Any
Axes: TypeAlias = Any
Figure: TypeAlias = Any
Text: TypeAlias = Any

MARGIN = 10.0
LINE = 4.2
"""From one line of notes to the next. [mm]"""

_INCH = 25.4
_LETTERS = 68
"""Letters in a line of notes, for each 100 mm."""
_SIZES = {"A4": (297.0, 210.0), "A3": (420.0, 297.0)}
_LABEL = 2.5
"""What a label needs inside the edge of a detail. [mm]"""

_SCALES = (1.0, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 7.5, 10.0)


class Box(NamedTuple):
    """A room on paper. [mm]"""

    left: float
    bottom: float
    width: float
    height: float

    @property
    def middle(self) -> Array:
        """Its middle, shape (2,)."""
        return np.array([self.left + self.width / 2, self.bottom + self.height / 2])

    def columns(self, share: float, axis: float) -> tuple["Box", "Box"]:
        """Part it: curves with a share of the width, of which their axis takes some [mm], and what stands beside."""
        start = self.left + share * self.width + 8.0
        curves = self._replace(left=self.left + axis, width=share * self.width - (axis + 6.0))
        return curves, self._replace(left=start, width=self.left + self.width - start)


@contextmanager
def drawing_settings() -> Generator[None]:
    """Draw with our settings, whatever a user's own are."""
    matplotlib: Any = import_module("matplotlib")
    with matplotlib.rc_context():
        matplotlib.rcdefaults()
        matplotlib.rcParams.update(SETTINGS)
        yield


class Page:
    """A sheet of paper, lying; lengths on it are in millimetres from its lower left corner.

    Of several sheets, one below the other in one picture, they are from the corner of the first.
    """

    def __init__(self, width: float, height: float) -> None:
        from matplotlib import figure
        from matplotlib.backends.backend_agg import FigureCanvasAgg

        self.width = width
        self.height = height
        self.figure: Figure = figure.Figure(figsize=(width / _INCH, height / _INCH), facecolor="white")
        FigureCanvasAgg(self.figure)
        self.paper: Axes = self.figure.add_axes((0.0, 0.0, 1.0, 1.0))
        self.paper.set(xlim=(0.0, width), ylim=(0.0, height), xticks=(), yticks=())
        self.paper.set_axis_off()
        # Everything on the paper is clipped to it, and the library would make this transform anew for each line.
        self.paper.patch.get_transform = partial(_itself, self.paper.patch.get_transform())

    def lengthen(self, n_sheets: int) -> None:
        """Take so many sheets, one below the other."""
        self.figure.set_size_inches(self.width / _INCH, n_sheets * self.height / _INCH)
        self.paper.set(ylim=((1 - n_sheets) * self.height, self.height))

    def sheet(self, number: int, first: Box) -> Box:
        """Give the room on a sheet, from 0: on the first a given one; below, without head, to its margin. [mm]"""
        height = self.height - MARGIN - first.bottom if number else first.height
        return first._replace(bottom=first.bottom - number * self.height, height=height)

    def place_of(self, axes: Axes, points: Array) -> Array:
        """Where points of axes lie on the sheet, shape (2, n). [mm]"""
        return axes.transData.transform(points.T).T / self.figure.dpi * _INCH

    def text(self, x: float, y: float, words: str, **manner: Any) -> Text:
        """Write words at a place; left and on the line unless said otherwise."""
        return self.paper.text(
            x, y, **set_words(words), **({"ha": "left", "va": "baseline", "fontsize": TEXT} | manner)
        )

    def rule(self, y: float, left: float | None = None, right: float | None = None) -> None:
        """Draw a hairline across."""
        ends = (MARGIN if left is None else left, self.width - MARGIN if right is None else right)
        self.paper.plot(ends, (y, y), color=RULE, linewidth=0.6)

    def heading(self, x: float, y: float, words: str) -> Text:
        """Write a heading."""
        return self.text(x, y, words, fontsize=HEADING, fontweight="bold")

    def notes(self, x: float, y: float, sentences: Iterable[str]) -> None:
        """Write sentences one below the other, as second text."""
        for number, sentence in enumerate(sentences):
            self.text(x, y - LINE * number, sentence, color=MUTED)

    def wrapped(self, words: object, width: float) -> list[str]:
        """Fold words into lines of a width. [mm]"""
        return wrap(str(words), max(int(width * _LETTERS / 100.0), 1))

    def ends(self, words: Text) -> tuple[float, float]:
        """Say where written words begin on the left and end on the right. [mm]"""
        start, end = words.get_window_extent().intervalx / self.figure.dpi * _INCH
        return float(start), float(end)

    def sample(self, start: float, end: float, y: float, **manner: Any) -> None:
        """Draw a sample of a line, for a legend."""
        self.paper.plot((start, end), (y, y), **manner)

    def scale_bar(self, x: float, y: float, scale: float) -> float:
        """Draw a bar of a round length of metal and say the scale; give where it ends. [mm]"""
        length = scale_for("m", 0.0)
        metal = 1e3 * length.one
        size = rounded_down(40.0 * scale / metal)
        end = x + size * metal / scale
        half = (x + end) / 2
        for start, stop, colour in ((x, half, INK), (half, end, "white")):
            self.paper.fill(
                [start, stop, stop, start], [y, y, y + 1.1, y + 1.1], facecolor=colour, edgecolor=INK, linewidth=0.5
            )
        words = _("{size} {unit}, scale {scale}", size=plain(size), unit=length.label, scale=scale_words(scale))
        self.text(end + 2.0, y - 0.4, words)
        return end

    def draw(self, sketch: Sketch, origin: tuple[float, float], within: float | None = None) -> list[Artist]:
        """Draw a sketch to its scale, its origin at a place on the sheet; only what is so near to its origin. [mm]

        Gives what draws its lines and circles, in their order, so that `move` can draw the next one with it.
        """
        from matplotlib import patches

        artists = [_artist_of(line, line.order + 1e-4 * number) for number, line in enumerate(sketch.lines)]
        artists += [_artist_of(one, one.order + 0.5 + 1e-4 * number) for number, one in enumerate(sketch.circles)]
        self.move(artists, sketch, origin)
        edge = None if within is None else patches.Circle(origin, within, transform=self.paper.transData)
        for artist in artists:
            self.paper.add_artist(artist)
            if edge is not None:
                artist.set_clip_path(edge)
        for label in sketch.labels:
            at = label.position / sketch.scale
            if within is None or np.hypot(*at) < within - _LABEL:
                self._label(label, np.array(origin) + at)
        return artists

    def _label(self, label: Label, at: Array) -> None:
        """Write a label, its middle at a place. [mm]"""
        self.text(
            float(at[0]),
            float(at[1]),
            mathematics(label.text) if label.manner == "symbol" else label.text,
            ha="center",
            va="center_baseline",
            fontsize=SYMBOL if label.manner == "symbol" else TEXT,
            fontweight="bold" if label.manner == "name" else "normal",
            bbox={"facecolor": "white", "edgecolor": "none", "pad": 0.6}
            if label.manner in ("number", "name")
            else None,
            zorder=20,
        )

    def move(self, artists: Sequence[Artist], sketch: Sketch, origin: tuple[float, float]) -> None:
        """Move what `draw` gave to where the same parts are in another sketch."""
        place = np.array(origin)
        for artist, part in zip(artists, (*sketch.lines, *sketch.circles), strict=True):
            if isinstance(part, Circle):
                artist.set(center=tuple(place + part.centre / sketch.scale), radius=part.radius / sketch.scale)
            else:
                points = place[:, np.newaxis] + part.points / sketch.scale
                artist.set(**({"xy": points.T} if part.is_closed else {"data": points}))


def _itself(given: Any) -> Any:
    """What was given."""
    return given


def _artist_of(part: Line | Circle, layer: float) -> Artist:
    """What draws a line or a circle, still without its place."""
    from matplotlib import lines, patches

    pen = pen_of(part)
    style: Any = (0, pen.dashes) if pen.dashes and isinstance(part, Line) else "-"
    manner: dict[str, Any] = {"linewidth": pen.width, "linestyle": style, "zorder": layer}
    if isinstance(part, Line) and not part.is_closed:
        return lines.Line2D([], [], color=pen.colour, **manner)
    manner |= {"facecolor": pen.colour if part.fill == "ink" else FILLS[part.fill], "edgecolor": pen.colour}
    return patches.Circle((0.0, 0.0), **manner) if isinstance(part, Circle) else patches.Polygon([(0.0, 0.0)], **manner)


def paper(size: str) -> tuple[float, float]:
    """Width and height of a sheet. [mm]"""
    if size not in _SIZES:
        allowed = _("must be one of: {sizes}", sizes=", ".join(_SIZES))
        raise InputError([Problem("size", size, allowed)])
    return _SIZES[size]


def fitting_scale(width: float, height: float, room: tuple[float, float]) -> float:
    """Choose the round scale at which metal of a width and height fits a room on paper; metal mm in one of paper."""
    least = max(width / room[0], height / room[1])
    return 1.0 / rounded_down(1.0 / least) if least < 0.8 else rounded_scale(least, _SCALES)


def rounded_down(size: float) -> float:
    """Give the next 1, 2 or 5 times a power of ten that is not larger."""
    power = 10.0 ** float(np.floor(np.log10(size)))
    return next(step * power for step in (5.0, 2.0, 1.0) if step * power <= size * (1 + 1e-9))


def set_words(words: str) -> dict[str, Any]:
    """Give words to the plotting library: formulas as such, all else plain, and nothing that no font has."""
    written = visible(words, kept=f"\n{FORMULA}").replace(KEPT, " ")
    if FORMULA not in written:
        return {"s": written, "parse_math": False}
    return {"s": written.replace("$", r"\$").replace(FORMULA, "$"), "parse_math": True}
