"""Diagrams of evenness on paper: Wittenbauer's energy over inertia, Mertsalov's energy over the crank angle."""

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import numpy as np

from cranktrain.analysis import Result
from cranktrain.language import said as _
from cranktrain.motion import Array
from cranktrain.plans.evenness_diagrams import mertsalov_diagram, wittenbauer_diagram
from cranktrain.quantities import shown
from cranktrain.quantities import shown as in_unit
from cranktrain.questions.evenness.flywheel import FlywheelSize
from cranktrain.saying.scales import Scale, scale_for
from cranktrain.texts.flywheel_diagrams import Tangent
from cranktrain.viz.figures import figure, plain, written_apart
from cranktrain.viz.panel import Curve, OneDesign, Panel, as_shown
from cranktrain.viz.paper.head import result_page
from cranktrain.viz.paper.page import Axes, Box, Figure, Page, drawing_settings, formula, set_words
from cranktrain.viz.paper.panels import axes_in, draw_curves, line_of
from cranktrain.viz.paper.sketch import Wish, placed_labels, together
from cranktrain.viz.paper.style import COLOURS, INK, MUTED, SYMBOL
from cranktrain.viz.paper.tables import write_table
from cranktrain.viz.sheets.evenness.panels import mertsalov_panels, wittenbauer_panel

_ONE_POINT = 1.5
"""Marks of the crank angle nearer to each other are one, with one label. [mm]"""
_NAMED = 2
"""Of more angles at one mark not each is named."""

_TABLE = 86.0
"""Width of the tables. [mm]"""

_UPPER, _LOWER = (9.0, 3.0), (3.0, 2.0)
"""Dashes of the tangents at the largest and the smallest speed."""


@drawing_settings()
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
    panel = wittenbauer_panel(result, design)
    energy = scale_for("J", float(np.max(np.abs(panel.values))))
    panel = as_shown(panel)
    upper, lower = (_in_unit(Tangent(*(part[design] for part in one)), energy) for one in (found.upper, found.lower))
    tangents = {_UPPER: upper, _LOWER: lower}
    origin = np.array([found.origin_inertia[design], energy.of(found.origin_work[design])])
    inertia, work = panel.across, panel.curves[0].values
    title = _("Wittenbauer's diagram: excess work over inertia of the moving parts")
    page, box = _page(result, size, design, title)
    # Where there is hardly any work, or hardly any change of inertia, the tangents' slope sets the scale.
    rise, run = float(upper.slope) * float(np.ptp(inertia)), float(np.ptp(work)) / float(upper.slope)
    heights = np.append(work, np.mean(work[:-1]) + rise * np.array([-0.2, 0.2]))
    widths = np.append(inertia, np.mean(inertia[:-1]) + run * np.array([-0.05, 0.05]))
    across = _("Inertia of the moving parts {symbol}, kg·m²", symbol=formula("J_v"))
    axes = _axes(page, box, across, _("Excess work {symbol}, {unit}", symbol=formula("A"), unit=panel.unit))
    axes.set(xlim=_wide(widths, 0.25), ylim=_wide(heights, 0.12))
    draw_curves(axes, panel)
    for dashes, tangent in tangents.items():
        _draw_tangent(axes, tangent, axes.get_xlim(), dashes)
        _ring(axes, tangent.inertia, tangent.work)
    _number_angles(page, axes, panel, shown(result.grid.cycle, "deg"), (upper, lower))
    right = box.left + box.width + 10.0
    below = _write_numbers(page, OneDesign(result, design), right, box.bottom + box.height, (upper, lower))
    room = Box(right + 14.0, box.bottom, _TABLE - 14.0, below - box.bottom - 10.0)
    _draw_whole(page, room, panel, tangents, origin)
    return page.figure


@drawing_settings()
def plan_mertsalov(result: Result, *, size: str = "A4", design: int = 0) -> Figure:
    """Draw Mertsalov's diagram of the flywheel; parameters as `plan_wittenbauer` takes them."""
    found = mertsalov_diagram(result)
    panels = mertsalov_panels(result, design)
    upper, lower = map(as_shown, panels)
    energy = scale_for("J", float(np.max(np.abs(panels[1].values))))
    page, box = _page(result, size, design, _("Mertsalov's diagram: the energy that the flywheel takes up"))
    half = (box.height - 14.0) / 2
    _over_cycle(page, upper, Box(box.left, box.bottom + half + 14.0, box.width, half), 0.08)
    axes = _over_cycle(page, lower, Box(box.left, box.bottom, box.width, half), 0.12)
    page.text(box.left + box.width / 2, box.bottom - 8.5, _("Crank angle φ, °"), ha="center")
    ends = [float(energy.of(extreme.value[design, 0])) for extreme in (found.smallest, found.largest)]
    for extreme, value in zip((found.smallest, found.largest), ends, strict=True):
        axes.axhline(value, color=INK, linewidth=0.6, dashes=_LOWER)
        _ring(axes, shown(float(extreme.angle[design, 0]), "deg") % lower.across[-1], value, clip_on=False)
    _dimension(page, page.place_of(axes, np.stack([np.full(2, lower.across[-1]), ends])))
    _write_numbers(page, OneDesign(result, design), box.left + box.width + 10.0, box.bottom + box.height, ())
    return page.figure


def _in_unit(tangent: Tangent, energy: Scale) -> Tangent:
    """Give a tangent with work in a unit."""
    slope, intercept, work = (energy.of(part) for part in (tangent.slope, tangent.intercept, tangent.work))
    return tangent._replace(slope=slope, intercept=intercept, work=work)


def _page(result: Result, size: str, design: int, title: str) -> tuple[Page, Box]:
    """Begin a sheet; give the room of the diagram."""
    page, box = result_page(result, design, size, title)
    return page, Box(box.left + 16.0, box.bottom + 10.0, box.width - _TABLE - 26.0, box.height - 15.0)


def _over_cycle(page: Page, panel: Panel, box: Box, beside: float) -> Axes:
    """Draw a panel over the crank angle with its legend."""
    cycle = float(panel.across[-1])
    axes = _axes(page, box, "", f"{panel.title}, {panel.unit}", every=cycle / 12)
    axes.set(xlim=(0.0, cycle), ylim=_wide(panel.values, beside))
    draw_curves(axes, panel)
    _legend(page, box, panel.curves)
    return axes


def _ring(axes: Axes, x: float | Array, y: float | Array, **manner: Any) -> None:
    """Mark where a speed is largest or smallest."""
    axes.plot([x], [y], "o", ms=4.5, mfc="white", mec=INK, mew=0.9, zorder=6, **manner)


def _axes(page: Page, box: Box, across: str, up: str, every: float | None = None) -> Axes:
    """Axes with words along both."""
    from matplotlib.ticker import MaxNLocator, MultipleLocator

    axes = axes_in(page, box)
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


def _number_angles(page: Page, axes: Axes, panel: Panel, cycle: float, tangents: tuple[Tangent, Tangent]) -> None:
    """Mark crank angles along the curve, every twelfth of the cycle, clear of the curve and of each other."""
    drawn = np.stack([panel.across, panel.curves[0].values])
    angle = np.arange(panel.across.size - 1, dtype=np.float64) * (cycle / (panel.across.size - 1))
    at = np.flatnonzero(np.round(angle, 9) % (round(cycle) // 12) == 0)
    axes.plot(*drawn[:, at], "o", ms=2.6, color=COLOURS["v"], zorder=6)
    curve = page.place_of(axes, drawn)
    points, middle = curve[:, at], np.mean(curve[:, :-1], axis=1)
    away = np.arctan2(*(points - middle[:, np.newaxis])[::-1])
    wishes = [
        Wish(points[:, of[0]], _joined(angle[at[of]]), float(away[of[0]]), "name")
        for of in together(points, _ONE_POINT)
    ]
    ends = np.array(axes.get_xlim())
    lines = [np.stack([ends, one.slope * ends + one.intercept]) for one in tangents]
    for label in placed_labels(wishes, [curve, *(page.place_of(axes, line) for line in lines)], 1.0):
        _write(page, axes, label.position, label.text, ha="center")


def _joined(angles: Array) -> str:
    """Name all crank angles of one point; many at even distances by the first one and the distance, 60° + 180°k."""
    steps = np.diff(angles)
    if len(angles) > _NAMED and np.ptp(steps) < 1e-6:
        return f"{angles[0]:g}° + {steps[0]:g}°k"
    return ", ".join(f"{angle:g}°" for angle in angles)


def _draw_whole(
    page: Page, room: Box, panel: Panel, tangents: Mapping[tuple[float, ...], Tangent], origin: Array
) -> None:
    """Draw the diagram small and whole, with the origin where the tangents meet."""
    drawn = np.stack([panel.across, panel.curves[0].values])
    axes = _axes(page, room, f"{formula('J_v')}, kg·m²", f"{formula('A')}, {panel.unit}")
    widths, heights = np.column_stack([drawn, origin])
    axes.set(xlim=_wide(widths, 0.08), ylim=_wide(heights, 0.08))
    axes.plot(*drawn[:, :-1], color=COLOURS["v"], linewidth=1.2)
    for dashes, tangent in tangents.items():
        _draw_tangent(axes, tangent, (origin[0], float(np.max(panel.across))), dashes)
    axes.plot(*origin, "o", ms=4.0, color=INK, zorder=6)
    words = _("origin {symbols}", symbols=f"{formula('-J_f')}, {formula('-E_0')}")
    _write(page, axes, page.place_of(axes, origin) + np.array([3.0, 0.0]), words, ha="left")


def _write(page: Page, axes: Axes, at: Array, words: str, *, ha: str) -> None:
    """Write words at a place on the sheet over what axes hold. [mm]"""
    manner = {"ha": ha, "va": "center_baseline", "transform": page.paper.transData, "zorder": 20}
    axes.text(float(at[0]), float(at[1]), **set_words(words), **manner)


def _dimension(page: Page, ends: Array) -> None:
    """Draw the range that the flywheel takes up as a dimension beside the right end, clear of the curve. [mm]"""
    (right, _same), (low, high) = ends.tolist()
    x = right + 4.0
    for y in (low, high):
        page.paper.plot((right, x + 1.5), (y, y), color=INK, lw=0.6)
    page.paper.annotate("", (x, high), (x, low), arrowprops={"arrowstyle": "<->", "lw": 0.7, "color": INK})
    page.text(x + 2.0, (low + high) / 2, formula(r"\delta\,\omega_a^2 J_f"), va="center", fontsize=SYMBOL)


def _legend(page: Page, box: Box, curves: Sequence[Curve]) -> None:
    """Say over the right end of a diagram which line is which."""
    end, y = box.left + box.width, box.bottom + box.height + 2.2
    for curve in reversed(curves):
        start, _end = page.ends(page.text(end, y, formula(curve.symbol), ha="right", fontsize=SYMBOL, color=INK))
        page.sample(start - 11.0, start - 2.0, y + 0.9, **(line_of(curve) | {"linewidth": 1.4}))
        end = start - 16.0


def _wide(values: Array, beside: float) -> tuple[float, float]:
    """Range of values with room beside; of one value alone, some about it."""
    low, high = float(np.min(values)), float(np.max(values))
    room = beside * (high - low) or max(abs(high), 1.0) * beside
    return low - room, high + room


def _write_numbers(page: Page, shown: OneDesign, left: float, top: float, tangents: Sequence[Tangent]) -> float:
    """Write speeds and flywheels beside a diagram, and what its tangents are; give where the tables end. [mm]"""
    y = write_table(page, _speeds(shown, tangents), (left, top, _TABLE))
    y = write_table(page, list(_flywheels(shown)), (left, y - 3.0, _TABLE), (0.52, 0.77, 1.0))
    if tangents:
        for words, dashes in ((_("tangent at the largest speed"), _UPPER), (_("tangent at the smallest"), _LOWER)):
            page.sample(left, left + 10.0, y - 1.0, color=INK, lw=0.9, dashes=dashes)
            page.text(left + 12.0, y - 2.0, words, color=MUTED)
            y -= 4.6
    return y


def _speeds(shown: OneDesign, tangents: Sequence[Tangent]) -> list[tuple[str, str]]:
    """What is wanted, the speeds, where they are, and energies."""
    size = shown.result[FlywheelSize]
    fastest, slowest, energy = (
        float(part[shown.design])
        for part in (size.exact.largest_speed, size.exact.smallest_speed, size.exact.initial_energy)
    )
    speed = scale_for("rpm", fastest)
    speeds = written_apart(speed.of(np.array([fastest, slowest])))
    largest = float(shown("largest_excess_work"))
    works = [(one, scale_for("J", abs(one))) for one in (largest, energy)]
    excess, start = ((scale.label, figure(float(scale.of(one)))) for one, scale in works)
    angles = (f"{float(in_unit(tangent.angle, 'deg')) % shown.cycle[-1]:.2f}" for tangent in tangents)
    return [
        (_("Wanted"), ""),
        (_("Coefficient of fluctuation δ"), plain(float(size.wanted[shown.design]))),
        (_("Largest speed, {unit}", unit=speed.label), speeds[0]),
        (_("Smallest speed, {unit}", unit=speed.label), speeds[1]),
        (_("Largest excess work, {unit}", unit=excess[0]), excess[1]),
        (_("Energy at φ = 0, E₀, {unit}", unit=start[0]), start[1]),
        *zip((_("Largest speed at φ, °"), _("Smallest speed at φ, °")), angles, strict=False),
    ]


def _flywheels(shown: OneDesign) -> Iterator[tuple[str, str, str, str]]:
    """Flywheel by each method, and the error of that; the exact one comes first."""
    titles = {"exact": _("exact"), "mertsalov": _("Mertsalov"), "textbook": _("textbook, ΔA/(δω²)")}
    inertias, errors = (shown(name).tolist() for name in ("flywheel_inertia", "flywheel_inertia_error"))
    yield _("Flywheel"), "J, kg·m²", "GD², kg·m²", _("error")
    for name, inertia, error in zip(shown.result.labels["flywheel_method"], inertias, errors, strict=True):
        is_told = inertia > 0 and inertias[0] > 0
        share = f"{100 * error:+.2f} %".replace("-", "−") if is_told else "–"
        moment, doubled = (figure(inertia), figure(4 * inertia)) if inertia > 0 else (_("not needed"), "–")
        yield titles[name], moment, doubled, "" if name == "exact" else share
