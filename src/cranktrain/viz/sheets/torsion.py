"""The sheet of torsion: modes along the shaft, Campbell's diagram, the critical speeds that matter most."""

from typing import TypeVar

import numpy as np

from cranktrain.analysis import Result
from cranktrain.errors import InputError, Problem
from cranktrain.language import _
from cranktrain.one_line import short
from cranktrain.quantities import shown
from cranktrain.questions.torsion.campbell import Campbell, Crossing, campbell
from cranktrain.questions.torsion.critical import CriticalSpeeds, ModeVectorSums
from cranktrain.questions.torsion.modes import TorsionalModes, TorsionalTrain
from cranktrain.viz.paper.page import MARGIN, Axes, Figure, Page, drawing_settings, formula, muted, paper, set_words
from cranktrain.viz.paper.style import COLOURS, GRID, INK, MUTED, SYMBOL, TEXT
from cranktrain.viz.paper.words import running_words, speed_of, speed_words, unused_words, zero_words
from cranktrain.viz.plans.sheet import Box, write_table
from cranktrain.viz.sheets.motion import title_block
from cranktrain.wording import number

Stage = TypeVar("Stage")

_MODES = 4
"""Modes that have a drawing."""
_LEFT = 0.5
"""Share of the modes in the width."""
_ROWS = 8
"""Critical speeds in the table."""
_LARGEST_MARK, _LEAST_MARK = 10.0, 1.6
"""Diameter of the marks of vector sums as large as the number of cylinders, and of hardly any. [pt]"""
_WHOLE, _HALF = 0.7, 0.35
"""Width of the rays of whole and half orders. [pt]"""
_APART = 4.5
"""Between the numbers of rays, and the names of levels. [mm]"""
_BRANCH = (4.0, 2.0)
"""Dashes of a shaft that passes other discs on the drawing."""
_LETTER, _LONGEST = 1.75, 16
"""Width of a letter [mm], and how many of a disc's name are written."""


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
        If the machine has no [torsion], or no natural frequencies.
    """
    modes, discs, critical = (_gift(result, kind) for kind in (TorsionalModes, TorsionalTrain, CriticalSpeeds))
    if modes is None or discs is None or critical is None:
        raise InputError([Problem("", None, _("a sheet of torsion needs {needs}").format(needs="[torsion]"))])
    if not np.all(np.isfinite(modes.natural_frequency[design])):
        raise InputError([Problem("torsion", None, _("gives no natural frequencies, so there is no sheet of them"))])
    sums = _gift(result, ModeVectorSums)
    diagram = campbell(modes, critical, sums, design=design)
    with drawing_settings():
        page = Page(*paper(size))
        machine = result.machines[design]
        head = [_("Torsional vibration. {zero}").format(zero=zero_words(machine))]
        at_speed = speed_words(speed_of(result), design)
        top = title_block(page, machine, [running_words(machine)], head, at_speed, unused_words(result))
        width = page.width - 2 * MARGIN
        _draw_modes(page, modes, discs, design, Box(MARGIN, MARGIN, _LEFT * width - 8.0, top - 4.0 - MARGIN))
        right = Box(MARGIN + _LEFT * width + 10.0, MARGIN, (1 - _LEFT) * width - 10.0, top - 4.0 - MARGIN)
        n_cylinders = max(len(result.labels.get("cylinder", ())), 1)
        below = _draw_campbell(
            page, diagram, None if critical.speed is None else float(critical.speed[design]), n_cylinders, right
        )
        _write_speeds(page, diagram, (right.left, below, right.width))
        return page.figure


def _gift(result: Result, kind: type[Stage]) -> Stage | None:
    return next((gift for gift in result.gifts if isinstance(gift, kind)), None)


def _draw_modes(page: Page, modes: TorsionalModes, discs: TorsionalTrain, design: int, box: Box) -> None:
    """Draw the lowest modes one above the other, the lowest at the top, and name the discs below."""
    names = [short(name, _LONGEST) for name in discs.labels["disc"]]
    longest = _LETTER * max(map(len, names)) + 2.0
    step = (box.width - 8.0) / len(names)
    following = discs.train.following
    n = min(_MODES, modes.natural_frequency.shape[-1])
    foot = 8.0 if longest < step else 5.0 + longest
    height = (box.height - 6.0 - foot) / n
    page.heading(box.left, _top(box) - 3.0, _("Modes, and their nodes"))
    for mode in range(n):
        bottom = _top(box) - 6.0 - (mode + 1) * height
        axes = page.axes(box.left + 8.0, bottom + 1.5, box.width - 8.0, height - 6.5)
        _prepare(axes)
        axes.set_xlim(-0.5, len(names) - 0.5)
        axes.axhline(0.0, color=INK, linewidth=0.6)
        shape = modes.mode_shape[design, mode]
        for disc, other in enumerate(following.tolist()):
            dashes = () if other == disc + 1 else _BRANCH
            axes.plot([disc, other], shape[[disc, other]], color=COLOURS["s"], linewidth=1.4, dashes=dashes)
            share = float(modes.mode_node[design, mode, disc])
            if np.isfinite(share):
                axes.plot([disc + share * (other - disc)], [0.0], "o", ms=4.0, mfc="white", mec=INK, mew=0.8, zorder=6)
        axes.vlines(np.arange(len(names)), 0.0, shape, color=MUTED, linewidth=0.6)
        axes.plot(np.arange(len(names)), shape, "o", ms=3.2, color=COLOURS["s"], zorder=5)
        axes.set_xticks(np.arange(len(names)), [""] * len(names))
        words = _("mode {n}, {frequency}; amplitude 1 at {disc}").format(
            n=mode + 1,
            frequency=number(float(modes.natural_frequency[design, mode]), "Hz"),
            disc=_named(names[int(modes.unit[design, mode])]),
        )
        page.text(box.left + 8.0, bottom + height - 3.8, words)
    for place, name in enumerate(names):
        x, y = box.left + 8.0 + (place + 0.5) * step, box.bottom + foot - 4.0
        page.text(x, y, name, ha="center", va="top", rotation=0 if longest < step else 90)


def _top(box: Box) -> float:
    return box.bottom + box.height


def _named(disc: str) -> str:
    return _("throw {n}").format(n=disc) if disc.isdigit() else disc


def _prepare(axes: Axes) -> None:
    """Light grid, small figures, no frame above and on the right."""
    from matplotlib.ticker import MaxNLocator

    axes.grid(color=GRID, linewidth=0.5)
    axes.set_axisbelow(True)
    axes.tick_params(labelsize=TEXT, pad=2.0)
    axes.spines[["top", "right"]].set_visible(False)
    axes.yaxis.set_major_locator(MaxNLocator(nbins=4))


def _draw_campbell(page: Page, of: Campbell, running: float | None, n_cylinders: int, box: Box) -> float:
    """Draw frequencies over the speed; give where the diagram ends. [mm]"""
    height = 0.54 * box.height
    page.heading(box.left, _top(box) - 3.0, _("Campbell's diagram: frequency in Hz over speed in rpm"))
    room = Box(box.left + 2.0, _top(box) - 9.5 - height, box.width - 12.0, height)
    axes = page.axes(*room)
    _prepare(axes)
    end, high = float(shown(of.largest_speed, "rpm")), _hertz(of.highest_frequency)
    axes.set(xlim=(0.0, end), ylim=(0.0, high))
    for order in of.order.tolist():
        reach = min(end, 60.0 * high / order)
        width = _WHOLE if order == int(order) else _HALF
        axes.plot([0.0, reach], [0.0, order * reach / 60.0], color=MUTED, linewidth=width)
    _number_rays(page, of, room)
    if running is not None:
        axes.axvline(float(shown(running, "rpm")), color=COLOURS["T"], linewidth=0.9, dashes=(6.0, 3.0))
    _draw_levels(axes, of, room)
    for one in of.crossings:
        place = [shown(one.speed, "rpm")], [_hertz(one.frequency)]
        axes.plot(*place, "o", ms=_mark(one, n_cylinders), color=INK, mew=0, zorder=6)
    return room.bottom - 9.0


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
            set_words(formula(rf"\omega_{{{mode}}}"))["s"],
            xy=(axes.get_xlim()[1], _hertz(frequency)),
            xytext=(-2.0, 2.0),
            textcoords="offset points",
            ha="right",
            va="bottom",
            fontsize=SYMBOL,
            color=COLOURS["s"],
            bbox={"facecolor": "white", "edgecolor": "none", "pad": 0.4},
            zorder=5,
        )


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
        page.text(x if order > steepest else x + 1.0, y + 0.6 * (order > steepest), f"{order:g}", **muted(), **manner)


def _hertz(speed: float) -> float:
    return speed / (2 * np.pi)


def _mark(one: Crossing, n_cylinders: int) -> float:
    """Diameter of the mark of a critical speed. [pt]"""
    if np.isnan(one.weight):
        return _LARGEST_MARK / 3
    return max(_LEAST_MARK, _LARGEST_MARK * float(np.sqrt(one.weight / n_cylinders)))


def _write_speeds(page: Page, of: Campbell, place: tuple[float, float, float]) -> None:
    """Write the critical speeds in sight that have the largest marks, by their speed."""
    left, top, width = place
    if not of.crossings:
        words = _("No order up to {order:g} has a natural frequency at the speeds of the diagram.")
        page.text(left, top, words.format(order=float(of.order[-1])))
        return
    has_sums = bool(np.isfinite(of.crossings[0].weight))
    chosen = sorted(of.crossings, key=lambda one: -one.weight if has_sums else one.order)[:_ROWS]
    page.heading(left, top, _("Critical speeds with the largest marks") if has_sums else _("Critical speeds"))
    head = [_("mode"), _("order"), _("speed, rpm"), *([_("vector sum")] if has_sums else [])]
    rows = [
        [
            f"{one.mode}",
            f"{one.order:g}",
            f"{shown(one.speed, 'rpm'):.1f}",
            *([f"{one.vector_sum:.3f}"] if has_sums else []),
        ]
        for one in sorted(chosen, key=lambda one: one.speed)
    ]
    below = write_table(page, [head, *rows], (left, top - 2.0, width), (0.3, 0.65, 1.0)[: len(head) - 1])
    if has_sums:
        notes = (
            _("Vector sums are those of amplitude 1 at the free end; the marks' areas are"),
            _("as those of amplitude 1 where the mode has its largest."),
        )
        for number, note in enumerate(notes):
            page.text(left, below + 1.0 - 4.0 * number, note, **muted())
