"""The sheet of torsion: modes along the shaft, Campbell's diagram, the critical speeds that matter most."""

from collections.abc import Sequence

import numpy as np

from cranktrain.analysis import Result
from cranktrain.errors import InputError, Problem
from cranktrain.language import said as _
from cranktrain.numerics.ties import first_largest, largest_first
from cranktrain.one_line import short
from cranktrain.saying.scales import Scale, scale_for
from cranktrain.viz.figures import figure, with_unit
from cranktrain.viz.paper.head import result_page
from cranktrain.viz.paper.page import Axes, Box, Figure, Page, drawing_settings, formula, set_words
from cranktrain.viz.paper.panels import axes_in
from cranktrain.viz.paper.style import COLOURS, INK, MUTED, SYMBOL
from cranktrain.viz.paper.tables import write_table
from cranktrain.viz.sheets.torsion.panels import Campbell, Crossing, ModeShape, campbell, mode_shapes

_MODES = 4
"""Modes that have a drawing."""
_BRANCH = (4.0, 2.0)
"""Dashes of a shaft that passes other discs on the drawing."""
_LONGEST = 16
"""Letters of a disc's name that are written."""
_SCALE, _HEAD, _WORDS = 8.0, 6.0, 6.5
"""Room for the figures of the scale, for the heading, and for the words over each mode. [mm]"""

_ROWS = 8
"""Critical speeds in the table."""
_LARGEST_MARK, _LEAST_MARK = 10.0, 1.6
"""Diameter of the marks of vector sums as large as the number of cylinders, and of hardly any. [pt]"""
_WHOLE, _HALF = 0.7, 0.35
"""Width of the rays of whole and half orders. [pt]"""
_APART = 4.5
"""Between the numbers of rays, and the names of levels. [mm]"""

_LEFT = 0.5
"""Share of the modes in the width."""


@drawing_settings()
def sheet_torsion(result: Result, *, size: str = "A4", design: int = 0) -> Figure:
    """Draw the sheet of torsion of a machine.

    Parameters
    ----------
    result : Result
        Of a machine with [torsion].
    size : "A4" or "A3"
        Lying.
    design : int
        Which of the result's machines.

    Returns
    -------
    Figure

    Raises
    ------
    InputError
        If the machine has no natural frequencies.
    """
    shapes = mode_shapes(result, design)
    if not all(np.isfinite(shape.frequency) for shape in shapes):
        raise InputError([Problem("torsion", None, _("gives no natural frequencies, so there is no sheet of them"))])
    page, box = result_page(result, design, size, _("Torsional vibration"))
    draw_modes(page, shapes, result.labels["disc"], box._replace(width=_LEFT * box.width - 8.0))
    room = box._replace(left=box.left + _LEFT * box.width + 10.0, width=(1 - _LEFT) * box.width - 10.0)
    draw_campbell(page, campbell(result, design), max(len(result.labels.get("cylinder", ())), 1), room)
    return page.figure


def draw_modes(page: Page, shapes: Sequence[ModeShape], discs: Sequence[str], box: Box) -> None:
    """Draw the lowest modes, the lowest at the top, and name the discs below them.

    Parameters
    ----------
    page : Page
    shapes : sequence of ModeShape
    discs : sequence of str
        Their names, by the rows of Holzer's table.
    box : Box
    """
    step = (box.width - _SCALE) / len(discs)
    starts = [box.left + _SCALE + (place + 0.5) * step for place in range(len(discs))]
    names = [
        page.text(x, box.bottom, short(name, _LONGEST), ha="center") for x, name in zip(starts, discs, strict=True)
    ]
    longest = max(float(np.ptp(page.ends(name))) for name in names) + 1.5
    is_turned = longest > step
    foot = 5.0 + longest if is_turned else 8.0
    for name in names:
        name.set(y=box.bottom + foot - 4.0, va="top", rotation=90 if is_turned else 0)
    few = shapes[:_MODES]
    height = (box.height - _HEAD - foot) / len(few)
    top = box.bottom + box.height
    page.heading(box.left, top - 3.0, _("Modes, and their nodes"))
    for place, shape in enumerate(few, start=1):
        bottom = top - _HEAD - place * height
        room = Box(box.left + _SCALE, bottom + 1.5, box.width - _SCALE, height - _WORDS)
        _draw_mode(axes_in(page, room), shape)
        words = _(
            "mode {n}, {frequency}; amplitude 1 at {disc}",
            n=shape.mode,
            frequency=with_unit(shape.frequency, scale_for("Hz", shape.frequency)),
            disc=_called(short(shape.unit, _LONGEST)),
        )
        page.text(box.left + _SCALE, bottom + height - 3.8, words)


def _draw_mode(axes: Axes, shape: ModeShape) -> None:
    """Draw amplitudes over the discs, joined as these are by shafts, and the nodes."""
    places = np.arange(shape.amplitude.size)
    axes.set(xlim=(-0.5, places.size - 0.5))
    axes.set_xticks(places, [""] * places.size)
    axes.axhline(0.0, color=INK, linewidth=0.6)
    for disc, other in enumerate(shape.following.tolist()):
        dashes = () if other == disc + 1 else _BRANCH
        axes.plot([disc, other], shape.amplitude[[disc, other]], color=COLOURS["s"], linewidth=1.4, dashes=dashes)
    axes.vlines(places, 0.0, shape.amplitude, color=MUTED, linewidth=0.6)
    axes.plot(places, shape.amplitude, "o", ms=3.2, color=COLOURS["s"], zorder=5)
    axes.plot(shape.nodes, np.zeros_like(shape.nodes), "o", ms=4.0, mfc="white", mec=INK, mew=0.8, zorder=6)


def _called(disc: str) -> str:
    """Name a disc in a sentence."""
    return _("throw {n}", n=disc) if disc.isdigit() else disc


def draw_campbell(page: Page, of: Campbell, n_cylinders: int, box: Box) -> None:
    """Draw frequencies over the speed, and below them the critical speeds that have the largest marks.

    Parameters
    ----------
    page : Page
    of : Campbell
    n_cylinders : int
        To which the marks are scaled.
    box : Box
    """
    height = 0.54 * box.height
    page.heading(box.left, (box.bottom + box.height) - 3.0, _heading(of))
    room = Box(box.left + 2.0, (box.bottom + box.height) - 9.5 - height, box.width - 12.0, height)
    axes = axes_in(page, room)
    speed = _speed(of)
    end, high = float(speed.of(of.largest_speed)), _hertz(of.highest_frequency)
    axes.set(xlim=(0.0, end), ylim=(0.0, high))
    for order in of.order.tolist():
        reach = min(end, float(speed.of(of.highest_frequency)) / order)
        width = _WHOLE if order == int(order) else _HALF
        axes.plot([0.0, reach], [0.0, _hertz(order * reach * speed.one)], color=MUTED, linewidth=width)
    _number_rays(page, of, room)
    if of.speed is not None:
        axes.axvline(float(speed.of(of.speed)), color=COLOURS["T"], linewidth=0.9, dashes=(6.0, 3.0))
    _draw_levels(axes, of, room)
    for one in of.crossings:
        place = [speed.of(one.speed)], [_hertz(one.frequency)]
        axes.plot(*place, "o", ms=_mark(one, n_cylinders), color=INK, mew=0, zorder=6)
    _write_speeds(page, of, box.left, room.bottom - 9.0, box.width)


def _draw_levels(axes: Axes, of: Campbell, room: Box) -> None:
    """Draw the natural frequencies in sight, and name them as far as they have room one above the other."""
    below = -np.inf
    for mode, frequency in enumerate(of.frequency.tolist(), start=1):
        height = room.height * frequency / of.highest_frequency
        if height > room.height:
            return
        axes.axhline(_hertz(frequency), color=COLOURS["s"], linewidth=1.2)
        if height - below < _APART:
            continue
        below = height
        axes.annotate(
            set_words(formula(f"f_{{{mode}}}"))["s"],
            xy=(float(_speed(of).of(_free_speed(of, frequency, room))), _hertz(frequency)),
            xytext=(0.0, 2.0),
            textcoords="offset points",
            ha="center",
            va="bottom",
            fontsize=SYMBOL,
            color=COLOURS["s"],
            zorder=5,
        )


def _free_speed(of: Campbell, frequency: float, room: Box) -> float:
    """Speed in the middle of the widest room over a level, between rays and the declared speed. [rad/s]"""
    above = frequency + _APART * of.highest_frequency / room.height
    speeds = np.zeros(0) if of.speed is None else np.array([of.speed])
    starts = np.concatenate([[0.0], above / of.order, speeds])
    ends = np.concatenate([frequency / of.order, speeds, [of.largest_speed]])
    starts, ends = np.sort(starts), np.sort(np.minimum(ends, of.largest_speed))
    widest = first_largest(ends - starts)
    return float(starts[widest] + ends[widest]) / 2


def _number_rays(page: Page, of: Campbell, room: Box) -> None:
    """Write whole orders at the ends of their rays, as far as they have room side by side. [mm]"""
    steepest = of.highest_frequency / of.largest_speed
    before = np.inf, np.inf
    for order in (order for order in of.order.tolist() if order == int(order)):
        x = room.left + room.width * min(1.0, steepest / order)
        y = room.bottom + room.height * min(1.0, order / steepest)
        if np.hypot(x - before[0], y - before[1]) < _APART:
            continue
        before = x, y
        manner = {"ha": "center", "va": "bottom"} if order > steepest else {"ha": "left", "va": "center_baseline"}
        page.text(x if order > steepest else x + 1.0, y + 0.6 * (order > steepest), f"{order:g}", color=MUTED, **manner)


def _speed(of: Campbell) -> Scale:
    """The unit of speeds."""
    return scale_for("rpm", of.largest_speed)


def _heading(of: Campbell) -> str:
    return _("Campbell's diagram: frequency in Hz over speed in {unit}", unit=_speed(of).label)


def _hertz(speed: float) -> float:
    return speed / (2 * np.pi)


def _mark(one: Crossing, n_cylinders: int) -> float:
    """Diameter of the mark of a critical speed. [pt]"""
    if np.isnan(one.weight):
        return _LARGEST_MARK / 3
    return max(_LEAST_MARK, _LARGEST_MARK * float(np.sqrt(one.weight / n_cylinders)))


def _write_speeds(page: Page, of: Campbell, left: float, top: float, width: float) -> None:
    """Write the critical speeds in sight that have the largest marks, by their speed."""
    if not of.crossings:
        words = _("No order up to {order:g} has a natural frequency at the speeds of the diagram.")
        page.text(left, top, words.format(order=float(of.order[-1])))
        return
    has_sums = bool(np.isfinite(of.crossings[0].weight))
    chosen = largest_first(of.crossings, lambda one: one.weight if has_sums else -one.order)[:_ROWS]
    page.heading(left, top, _("Critical speeds with the largest marks") if has_sums else _("Critical speeds"))
    head = [
        _("mode"),
        _("order"),
        _("speed, {unit}", unit=_speed(of).label),
        *([_("vector sum")] if has_sums else []),
    ]
    rows = [
        [
            f"{one.mode}",
            f"{one.order:g}",
            figure(float(_speed(of).of(one.speed))),
            *([figure(one.vector_sum)] if has_sums else []),
        ]
        for one in sorted(chosen, key=lambda one: one.speed)
    ]
    below = write_table(page, [head, *rows], (left, top - 2.0, width), (0.3, 0.65, 1.0)[: len(head) - 1])
    if has_sums:
        notes = (
            _("Vector sums are those of amplitude 1 at the free end; the marks' areas are"),
            _("as those of amplitude 1 where the mode has its largest."),
        )
        page.notes(left, below - 1.0, notes)
