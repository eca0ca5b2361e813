"""A start on paper: speed, torque, power and energy over time, and its way through the motor's curve."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from cranktrain.language import said as _
from cranktrain.motion import Array
from cranktrain.questions.start.record import StartEvent
from cranktrain.saying.scales import scale_for
from cranktrain.study.start import Start
from cranktrain.viz.figures import figure, power_of_ten, with_unit
from cranktrain.viz.paper.head import title_block
from cranktrain.viz.paper.page import MARGIN, Axes, Box, Figure, Page, drawing_settings, formula, paper
from cranktrain.viz.paper.panels import axes_in
from cranktrain.viz.paper.style import COLOURS, INK, MUTED, SYMBOL
from cranktrain.viz.paper.tables import LEAST_ROW, ROW, write_table
from cranktrain.viz.sheets.drive.torque_speed import draw_torque_speed

_STRIP = 4.0
"""Height of the numbers over the marks. [mm]"""
_FEW, _MOST = 3, 60
"""Events of one name that each have a number and a row; lines of one that has none."""
_WIDE = 2.2
"""Of a number over its mark; nearer ones stand together. [mm]"""

_LEFT, _LOOP = 0.56, 0.5
_HEAD, _GAP, _FOOT = 5.2, 9.0, 9.0
_CHANGES = 0.5
"""A curve whose least value is a larger part of its largest is drawn without its zero."""


class EventSort(NamedTuple):
    """Events of one name: their number on the picture, 0 of those that come too often for one, and their times. [s]"""

    name: str
    number: int
    times: tuple[float, ...]


def _event_sorts(events: Sequence[StartEvent]) -> list[EventSort]:
    """Sort events by name: the rare ones, numbered, before the others, each in the order in which it first comes."""
    times: dict[str, list[float]] = {}
    for event in events:
        times.setdefault(str(event.name), []).append(event.time)
    rare = [name for name, own in times.items() if len(own) <= _FEW]
    numbered = [EventSort(name, number, tuple(times[name])) for number, name in enumerate(rare, start=1)]
    return numbered + [EventSort(name, 0, tuple(own)) for name, own in times.items() if name not in rare]


def _draw_events(axes: Axes, sorts: Sequence[EventSort]) -> None:
    """Draw a line at each event: dashed where it has a number, else dotted."""
    for one in sorts:
        line = {"color": INK, "linewidth": 0.7, "linestyle": (0, (5.0, 2.0))}
        if not one.number:
            line = {"color": MUTED, "linewidth": 0.5, "linestyle": (0, (1.0, 2.5))}
        for time in one.times if len(one.times) <= _MOST else ():
            axes.axvline(time, zorder=1.2, **line)


def write_numbers(page: Page, sorts: Sequence[EventSort], place: tuple[float, float, float], until: float) -> None:
    """Write the numbers of marks over a panel, from its left to its right end [mm], which is at a time. [s]

    Those that would stand over each other stand side by side behind the first.
    """
    left, right, y = place
    marks = sorted((time, one.number) for one in sorts if one.number for time in one.times)
    together: list[tuple[float, list[int]]] = []
    for time, number in marks:
        x = left + (right - left) * time / until
        if together and x - together[-1][0] < _WIDE * (2 * len(together[-1][1]) - 1) + 1.0:
            together[-1][1].append(number)
        else:
            together.append((x, [number]))
    for x, numbers in together:
        page.text(x, y, ",".join(map(str, numbers)), ha="center" if len(numbers) == 1 else "left")


def _event_rows(sorts: Sequence[EventSort]) -> Iterator[tuple[str, str]]:
    """Rows of the table: the number of a mark, its name and time, or how many lines there are."""
    for one in sorts:
        if one.number:
            yield from ((f"{one.number}  {one.name}", _time(time)) for time in one.times)
        else:
            said = _("{name}, dotted: {n}") if len(one.times) <= _MOST else _("{name}, not drawn: {n}")
            yield said.format(name=one.name, n=len(one.times)), _("first {time}", time=_time(one.times[0]))


def _time(time: float) -> str:
    return with_unit(time, scale_for("s", abs(time)))


class _Line(NamedTuple):
    """A curve over time: symbol, values in SI, colour, dashes."""

    symbol: str
    values: Array
    colour: str
    dashes: tuple[float, ...] = ()


@drawing_settings()
def start_picture(start: Start, *, size: str = "A4") -> Figure:
    """Draw what became of a start.

    Parameters
    ----------
    start : Start
    size : "A4" or "A3"
        Lying.

    Returns
    -------
    Figure
        Curves over the time with its events, its way through the motor's curve, and facts; of a start that takes no
        time facts alone.
    """
    page = Page(*paper(size))
    top = title_block(page, start.machine, _("Start: {reason}", reason=start.run.reason)) - 4.0
    box = Box(MARGIN, MARGIN, page.width - 2 * MARGIN, top - MARGIN)
    sorts = _event_sorts(start.events)
    left, right = box.columns(_LEFT, 14.0)
    below = right.bottom + right.height
    time = start.run.whole_time
    if time[-1] <= time[0]:
        right = right._replace(left=box.left)
    else:
        _draw_over_time(page, start, sorts, left)
        if start.motor is not None:
            room = right._replace(bottom=below - _LOOP * right.height, height=_LOOP * right.height)
            way = (start.run.whole.motor_speed, start.run.whole.motor_torque)
            below = draw_torque_speed(page, start.motor, 0, way, room, _("this start")) - 2.0
    _write_facts(page, [*_facts(start), *_event_rows(sorts)], (right.left, below, right.width))
    return page.figure


def _panels(start: Start) -> Iterator[tuple[str, str, tuple[_Line, ...]]]:
    """Heads, units and curves, one above the other: of the whole run, whatever times were asked for."""
    curves = start.run.whole
    yield _("Speed of the motor"), "rpm", (_Line("n", curves.motor_speed, COLOURS["v"]),)
    if start.run.stroke is not None:
        yield _("Speed of the crank"), "rpm", (_Line("n", curves.crank_speed, COLOURS["s"]),)
    if start.motor is not None:
        yield _("Torque of the motor"), "N*m", (_Line("M_m", curves.motor_torque, COLOURS["T"]),)
        yield _("Power of the motor"), "W", (_Line("P_m", curves.motor_power, COLOURS["j"]),)
    yield (
        _("Energy"),
        "J",
        (
            _Line("W_m", curves.motor_work, COLOURS["T"]),
            _Line("W_Q", curves.load_work, COLOURS["s"], (6.0, 2.0)),
            _Line("W_v", curves.lost_work, COLOURS["N"], (2.0, 2.0)),
            _Line("T", curves.kinetic_energy, INK, (8.0, 2.0, 2.0, 2.0)),
        ),
    )


def _draw_over_time(page: Page, start: Start, sorts: Sequence[EventSort], box: Box) -> None:
    """Stack the curves over the time, numbers of the events over the first."""
    panels, time = list(_panels(start)), start.run.whole_time
    strip = _STRIP if any(one.number for one in sorts) else 0.0
    each = (box.height - _FOOT - _HEAD - strip - _GAP * (len(panels) - 1)) / len(panels)
    low = box.bottom + box.height - _HEAD - strip + _GAP
    for place, (title, unit, lines) in enumerate(panels, start=1):
        low -= each + _GAP
        scale = scale_for(unit, float(np.max(np.abs([line.values for line in lines]))))
        axes = axes_in(page, Box(box.left, low, box.width, each))
        if _goes_near_zero(lines):
            axes.axhline(0.0, color=MUTED, linewidth=0.6, zorder=1)
        for line in lines:
            dashes = (0, line.dashes) if line.dashes else "-"
            axes.plot(time, scale.of(line.values), color=line.colour, linewidth=1.4, linestyle=dashes)
        _draw_events(axes, sorts)
        axes.set(xlim=(float(time[0]), float(time[-1])))
        axes.tick_params(labelbottom=place == len(panels))
        head = low + each + 2.2 + (strip if place == 1 else 0.0)
        page.heading(box.left, head, f"{title}, {scale.label}".removesuffix(", "))
        _write_legend(page, lines, (box.left + box.width, head))
        if place == 1:
            write_numbers(page, sorts, (box.left, box.left + box.width, low + each + 1.2), float(time[-1]))
    page.text(box.left + box.width / 2, low - _FOOT, _("Time, s"), ha="center")


def _goes_near_zero(lines: tuple[_Line, ...]) -> bool:
    """Whether a panel needs its zero: a speed that hardly changes is drawn without it."""
    values = np.stack([line.values for line in lines])
    return bool(np.min(values) <= _CHANGES * np.max(values))


def _write_legend(page: Page, lines: tuple[_Line, ...], place: tuple[float, float]) -> None:
    """Name the curves of a panel over its right end, where there are several."""
    x, y = place
    for line in reversed(lines) if len(lines) > 1 else ():
        words = page.text(x, y, formula(line.symbol), ha="right", color=line.colour, fontsize=SYMBOL)
        begin, _end = page.ends(words)
        dashes = (0, line.dashes) if line.dashes else "-"
        page.sample(begin - 9.0, begin - 1.5, y + 0.9, color=line.colour, linewidth=1.4, linestyle=dashes)
        x = begin - 13.0


def _facts(start: Start) -> Iterator[tuple[str, str]]:
    """Rows of the table, of the whole run, whatever times were asked for."""
    curves, run = start.run.whole, start.run
    turned = float(curves.crank_angle_turned[-1] - curves.crank_angle_turned[0])

    def of(words: str, value: float, unit: str) -> tuple[str, str]:
        return words, with_unit(float(value), scale_for(unit, abs(float(value))))

    yield _("The start"), ""
    yield of(_("ends after"), run.whole_time[-1], "s")
    yield _("turns of the crank"), figure(turned / (2 * np.pi))
    yield of(_("largest torque of the motor"), np.max(curves.motor_torque), "N*m")
    yield of(_("largest power of the motor"), np.max(curves.motor_power), "W")
    yield of(_("work of the motor"), curves.motor_work[-1], "J")
    yield of(_("work that the loads took"), curves.load_work[-1], "J")
    yield of(_("lost in gearing, clutch and brake"), curves.lost_work[-1], "J")
    yield of(_("in motion at the end"), curves.kinetic_energy[-1], "J")
    if np.any(curves.motor_heat > 0):
        yield of(_("heat in the motor"), curves.motor_heat[-1], "J")
    left_over = float(abs(run.residual) / run.supplied) if run.supplied else 0.0
    yield _("energy left over, of what was put in"), power_of_ten(left_over)


def _write_facts(page: Page, rows: Sequence[tuple[str, str]], place: tuple[float, float, float]) -> None:
    """Write the table, its rows lower where there are many; say how many find no room."""
    _left, top, _width = place
    free = top - MARGIN - 4.0
    line = ROW if len(rows) * ROW <= free else LEAST_ROW
    most = int(free / line)
    if len(rows) > most:
        rows = [*rows[: most - 1], (_("and {n} more", n=len(rows) - most + 1), "")]
    write_table(page, rows, place, (1.0,), line)
