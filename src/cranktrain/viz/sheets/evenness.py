"""Diagrams of evenness on paper: Wittenbauer's energy over inertia, Mertsalov's energy over the crank angle."""

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from cranktrain.analysis import Result
from cranktrain.language import _
from cranktrain.layout.speed_curve import SpeedCurve
from cranktrain.motion import Array
from cranktrain.plans.evenness_diagrams import mertsalov_diagram, wittenbauer_diagram
from cranktrain.quantities import shown
from cranktrain.questions.evenness.flywheel import FlywheelSize
from cranktrain.textbook.flywheel_diagrams import Tangent
from cranktrain.viz.paper.labels import Wish, placed_labels
from cranktrain.viz.paper.page import MARGIN, Axes, Figure, Page, drawing_settings, formula, muted, paper, set_words
from cranktrain.viz.paper.style import COLOURS, GRID, INK, SYMBOL, TEXT
from cranktrain.viz.paper.words import running_words, speed_words, unused_words, zero_words
from cranktrain.viz.plans.sheet import Box, figure, write_table
from cranktrain.viz.sheets.motion import title_block

_TABLE = 86.0
"""Width of the table beside a diagram. [mm]"""
_UPPER, _LOWER = (9.0, 3.0), (3.0, 2.0)
"""Dashes of the tangents at the largest and the smallest speed."""
_ONE_POINT = 1.5
"""Marks of the crank angle nearer to each other are one, with one label. [mm]"""
_NAMED = 2
"""Of more angles at one mark not each is named."""
_CARRIED = (6.0, 2.5)
"""Dashes of the moving parts' energy."""


class _Frame(NamedTuple):
    """A diagram's room on paper [mm] and the range of its two axes."""

    box: Box
    x: tuple[float, float]
    y: tuple[float, float]

    def on_paper(self, x: Array, y: Array) -> Array:
        """Where points of the diagram lie on the sheet, shape (2, n). [mm]"""
        across = (np.asarray(x) - self.x[0]) / (self.x[1] - self.x[0])
        up = (np.asarray(y) - self.y[0]) / (self.y[1] - self.y[0])
        return np.stack([self.box.left + across * self.box.width, self.box.bottom + up * self.box.height])


def plan_wittenbauer(result: Result, *, size: str = "A4", design: int = 0) -> Figure:
    """Draw Wittenbauer's diagram of the flywheel that a machine is to have.

    Parameters
    ----------
    result : Result
        Of a machine with [evenness] coefficient.
    size : "A4" or "A3"
    design : int
        Which of the result's machines.

    Returns
    -------
    Figure
    """
    found = wittenbauer_diagram(result)
    inertia, work = np.broadcast_arrays(found.inertia[design], found.work[design])
    upper, lower = (Tangent(*(part[design] for part in one)) for one in (found.upper, found.lower))
    origin = float(found.origin_inertia[design]), float(found.origin_work[design])
    with drawing_settings():
        page, box = _page(
            result, size, design, _("Wittenbauer's diagram: excess work over inertia of the moving parts")
        )
        # Where there is hardly any work, or hardly any change of inertia, the tangents' slope sets the scale.
        rise, run = float(upper.slope) * float(np.ptp(inertia)), float(np.ptp(work)) / float(upper.slope)
        heights = np.append(work, np.mean(work) + rise * np.array([-0.2, 0.2]))
        widths = np.append(inertia, np.mean(inertia) + run * np.array([-0.05, 0.05]))
        close = _Frame(box, _wide(widths, 0.25), _wide(heights, 0.12))
        axes = _axes(
            page,
            close,
            _("Inertia of the moving parts {symbol}, kg·m²").format(symbol=formula("J_v")),
            _("Excess work {symbol}, J").format(symbol=formula("A")),
        )
        axes.plot(np.append(inertia, inertia[0]), np.append(work, work[0]), color=COLOURS["v"], linewidth=1.6)
        for tangent, dashes in ((upper, _UPPER), (lower, _LOWER)):
            _draw_tangent(axes, tangent, close.x, dashes)
            axes.plot([tangent.inertia], [tangent.work], "o", ms=4.5, mfc="white", mec=INK, mew=0.9, zorder=6)
        _number_angles(page, axes, close, result, inertia, work, (upper, lower))
        right = box.left + box.width + 10.0
        below = _write_numbers(page, result, design, (right, box.bottom + box.height), (upper, lower))
        room = Box(right + 14.0, box.bottom, _TABLE - 14.0, below - box.bottom - 10.0)
        whole = _Frame(room, _wide(np.append(inertia, origin[0]), 0.08), _wide(np.append(work, origin[1]), 0.08))
        _draw_whole(page, whole, inertia, work, (upper, lower), origin)
        return page.figure


def plan_mertsalov(result: Result, *, size: str = "A4", design: int = 0) -> Figure:
    """Draw Mertsalov's diagram of the flywheel; parameters as `plan_wittenbauer` takes them."""
    found = mertsalov_diagram(result)
    cycle = float(shown(result.grid.cycle, "deg"))
    angle = np.append(shown(found.angle, "deg"), cycle)
    with drawing_settings():
        page, box = _page(result, size, design, _("Mertsalov's diagram: the energy that the flywheel takes up"))
        half = (box.height - 14.0) / 2
        work, carried, left = (
            _closed(part[min(design, len(part) - 1)])
            for part in (found.work, found.carried_energy, found.flywheel_energy)
        )
        high = Box(box.left, box.bottom + half + 14.0, box.width, half)
        top = _Frame(high, (0.0, cycle), _wide(np.append(work, carried), 0.08))
        axes = _axes(page, top, "", _("Energy, J"), every=cycle / 12)
        axes.plot(angle, work, color=COLOURS["v"], linewidth=1.6)
        axes.plot(angle, carried, color=COLOURS["j"], linewidth=1.1, dashes=_CARRIED)
        _legend(
            page,
            high,
            ((formula("A"), COLOURS["v"], ()), (formula(r"\frac{1}{2}\omega_a^2 J_v"), COLOURS["j"], _CARRIED)),
        )
        low = Box(box.left, box.bottom, box.width, half)
        bottom = _Frame(low, (0.0, cycle), _wide(left, 0.12))
        axes = _axes(page, bottom, _("Crank angle φ, °"), _("Energy, J"), every=cycle / 12)
        axes.plot(angle, left, color=COLOURS["T"], linewidth=1.6)
        for extreme in (found.smallest, found.largest):
            at, value = float(extreme.angle[design, 0]), float(extreme.value[design, 0])
            axes.axhline(value, color=INK, linewidth=0.6, dashes=_LOWER)
            place = [shown(at, "deg") % cycle], [value]
            axes.plot(*place, "o", ms=4.5, mfc="white", mec=INK, mew=0.9, zorder=6, clip_on=False)
        _dimension(page, bottom, (float(found.smallest.value[design, 0]), float(found.largest.value[design, 0])))
        _legend(page, low, ((formula(r"A-\frac{1}{2}\omega_a^2 J_v"), COLOURS["T"], ()),))
        _write_numbers(page, result, design, (box.left + box.width + 10.0, box.bottom + box.height), ())
        return page.figure


def _page(result: Result, size: str, design: int, title: str) -> tuple[Page, Box]:
    """Begin a sheet; give the room of the diagram."""
    width, height = paper(size)
    page = Page(width, height)
    machine = result.machines[design]
    at_speed = speed_words(result.get(SpeedCurve), design)
    below = [f"{title}. {zero_words(machine)}"]
    top = title_block(page, machine, [running_words(machine)], below, at_speed, unused_words(result))
    left, bottom = MARGIN + 16.0, MARGIN + 10.0
    return page, Box(left, bottom, width - MARGIN - _TABLE - 10.0 - left, top - 9.0 - bottom)


def _axes(page: Page, frame: _Frame, across: str, up: str, every: float | None = None) -> Axes:
    """Axes with a light grid and words along both."""
    from matplotlib.ticker import MaxNLocator, MultipleLocator

    box = frame.box
    axes = page.axes(*box)
    axes.set(xlim=frame.x, ylim=frame.y)
    axes.grid(color=GRID, linewidth=0.5)
    axes.set_axisbelow(True)
    axes.tick_params(labelsize=TEXT, pad=2.0)
    axes.spines[["top", "right"]].set_visible(False)
    axes.xaxis.set_major_locator(MaxNLocator(nbins=5) if every is None else MultipleLocator(every))
    axes.yaxis.set_major_locator(MaxNLocator(nbins=6))
    axes.ticklabel_format(useOffset=False)
    page.text(box.left + box.width / 2, box.bottom - 8.5, across, ha="center")
    page.text(box.left, box.bottom + box.height + 2.2, up)
    return axes


def _draw_tangent(axes: Axes, tangent: Tangent, ends: Sequence[float], dashes: tuple[float, ...]) -> None:
    """Draw a tangent from one inertia to another."""
    at = np.array(ends)
    axes.plot(at, tangent.slope * at + tangent.intercept, color=INK, linewidth=0.9, dashes=dashes, zorder=5)


def _number_angles(
    page: Page,
    axes: Axes,
    frame: _Frame,
    result: Result,
    inertia: Array,
    work: Array,
    tangents: tuple[Tangent, Tangent],
) -> None:
    """Mark crank angles along the curve, every twelfth of the cycle, clear of the curve and of each other."""
    cycle = float(shown(result.grid.cycle, "deg"))
    angle: Array = np.arange(inertia.size, dtype=np.float64) * (cycle / inertia.size)
    at = np.flatnonzero(np.round(angle, 9) % (round(cycle) // 12) == 0)
    axes.plot(inertia[at], work[at], "o", ms=2.6, color=COLOURS["v"], zorder=6)
    points = frame.on_paper(inertia[at], work[at])
    middle = np.mean(frame.on_paper(inertia, work), axis=1)
    away = np.arctan2(*(points - middle[:, np.newaxis])[::-1])
    wishes = [
        Wish(points[:, of[0]], _joined(angle[at[of]]), float(away[of[0]]), "name")
        for of in _together(points, _ONE_POINT)
    ]
    lines = [frame.on_paper(np.append(inertia, inertia[0]), np.append(work, work[0]))]
    for tangent in tangents:
        ends = np.array(frame.x)
        lines.append(frame.on_paper(ends, tangent.slope * ends + tangent.intercept))
    for label in placed_labels(wishes, lines, 1.0):
        _write(page, axes, label.position, label.text, ha="center")


def _together(points: Array, reach: float) -> list[list[int]]:
    """Group points, shape (2, n), that lie nearer than `reach` to the first of their group."""
    groups: list[list[int]] = []
    for i in range(points.shape[1]):
        near = (of for of in groups if np.hypot(*(points[:, i] - points[:, of[0]])) < reach)
        found = next(near, None)
        if found is None:
            groups.append([i])
        else:
            found.append(i)
    return groups


def _joined(angles: Array) -> str:
    """Name all crank angles of one point; many at even distances by the first one and the distance, 60° + 180°k."""
    steps = np.diff(angles)
    if len(angles) > _NAMED and np.ptp(steps) < 1e-6:
        return f"{angles[0]:g}° + {steps[0]:g}°k"
    return ", ".join(f"{angle:g}°" for angle in angles)


def _draw_whole(
    page: Page,
    frame: _Frame,
    inertia: Array,
    work: Array,
    tangents: tuple[Tangent, Tangent],
    origin: tuple[float, float],
) -> None:
    """Draw the diagram small and whole, with the origin where the tangents meet."""
    axes = _axes(page, frame, f"{formula('J_v')}, kg·m²", f"{formula('A')}, J")
    axes.plot(inertia, work, color=COLOURS["v"], linewidth=1.2)
    for tangent, dashes in zip(tangents, (_UPPER, _LOWER), strict=True):
        _draw_tangent(axes, tangent, (origin[0], float(np.max(inertia))), dashes)
    axes.plot([origin[0]], [origin[1]], "o", ms=4.0, color=INK, zorder=6)
    at = frame.on_paper(np.array([origin[0]]), np.array([origin[1]]))[:, 0]
    _write(
        page,
        axes,
        at + np.array([3.0, 0.0]),
        _("origin {symbols}").format(symbols=f"{formula('-J_f')}, {formula('-E_0')}"),
        ha="left",
    )


def _write(page: Page, axes: Axes, at: Array, words: str, *, ha: str) -> None:
    """Write words at a place on the sheet over what axes hold. [mm]"""
    manner = {"ha": ha, "va": "center_baseline", "transform": page.paper.transData, "zorder": 20}
    axes.text(float(at[0]), float(at[1]), **set_words(words), **manner)


def _dimension(page: Page, frame: _Frame, ends: tuple[float, float]) -> None:
    """Draw the range that the flywheel takes up as a dimension beside the right end, clear of the curve."""
    (right, _same), (low, high) = frame.on_paper(np.full(2, frame.x[1]), np.array(ends)).tolist()
    x = right + 4.0
    for y in (low, high):
        page.paper.plot((right, x + 1.5), (y, y), color=INK, lw=0.6)
    page.paper.annotate("", (x, high), (x, low), arrowprops={"arrowstyle": "<->", "lw": 0.7, "color": INK})
    page.text(x + 2.0, (low + high) / 2, formula(r"\delta\,\omega_a^2 J_f"), va="center", fontsize=SYMBOL)


def _legend(page: Page, box: Box, entries: Sequence[tuple[str, str, tuple[float, ...]]]) -> None:
    """Say over the right end of a diagram which line is which."""
    end, y = box.left + box.width, box.bottom + box.height + 2.2
    for words, colour, dashes in reversed(entries):
        start = page.start(page.text(end, y, words, ha="right", fontsize=SYMBOL, color=INK)) - 2.0
        manner: dict[str, Any] = {"dashes": dashes} if dashes else {}
        page.sample(start - 9.0, start, y + 0.9, color=colour, lw=1.4, **manner)
        end = start - 14.0


def _write_numbers(
    page: Page, result: Result, design: int, place: tuple[float, float], tangents: Sequence[Tangent]
) -> float:
    """Write speeds and flywheels beside a diagram; give where the tables end. [mm]"""
    size = result[FlywheelSize]
    exact = size.exact
    left, top = place
    cycle = float(shown(result.grid.cycle, "deg"))
    rows = [
        (_("Wanted"), ""),
        (_("Coefficient of fluctuation δ"), f"{float(size.wanted[design]):.5g}"),
        (_("Largest speed, rpm"), figure(shown(float(exact.largest_speed[design]), "rpm"))),
        (_("Smallest speed, rpm"), figure(shown(float(exact.smallest_speed[design]), "rpm"))),
        (_("Largest excess work, J"), figure(float(_of(result, "largest_excess_work", design)))),
        (_("Energy at φ = 0, E₀, J"), figure(float(exact.initial_energy[design]))),
    ]
    if tangents:
        names = (_("Largest speed at φ, °"), _("Smallest speed at φ, °"))
        for name, tangent in zip(names, tangents, strict=True):
            rows.append((name, f"{float(shown(tangent.angle, 'deg')) % cycle:.2f}"))
    y = write_table(page, rows, (left, top, _TABLE))
    titles = {"exact": _("exact"), "mertsalov": _("Mertsalov"), "textbook": _("textbook, ΔA/(δω²)")}
    methods = [(_("Flywheel"), "J, kg·m²", "GD², kg·m²", _("error"))]
    for name, inertia, error in zip(
        result.labels["flywheel_method"],
        size.flywheel_inertia[design],
        size.flywheel_inertia_error[design],
        strict=True,
    ):
        if float(inertia) <= 0:
            methods.append((titles[name], _("not needed"), "–", "" if name == "exact" else "–"))
            continue
        share = f"{100 * float(error):+.2f} %".replace("-", "−") if float(size.flywheel_inertia[design, 0]) > 0 else "–"
        share = "" if name == "exact" else share
        methods.append((titles[name], figure(float(inertia)), figure(4 * float(inertia)), share))
    y = write_table(page, methods, (left, y - 3.0, _TABLE), (0.52, 0.77, 1.0))
    if tangents:
        for words, dashes in ((_("tangent at the largest speed"), _UPPER), (_("tangent at the smallest"), _LOWER)):
            page.sample(left, left + 10.0, y - 1.0, color=INK, lw=0.9, dashes=dashes)
            page.text(left + 12.0, y - 2.0, words, **muted())
            y -= 4.6
    return y


def _of(result: Result, name: str, design: int) -> Array:
    """One design's value of a fact."""
    values: Array = getattr(result, name)
    return values[design] if result.has_designs else values


def _wide(values: Array, beside: float) -> tuple[float, float]:
    """Range of values with room beside; of one value alone, some about it."""
    low, high = float(np.min(values)), float(np.max(values))
    room = beside * (high - low) or max(abs(high), 1.0) * beside
    return low - room, high + room


def _closed(values: Array) -> Array:
    """Repeat the first value at the end of the cycle."""
    return np.append(values, values[0])
