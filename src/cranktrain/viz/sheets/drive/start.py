"""A start on paper: speed, torque, power and energy over time, and its way through the motor's curve."""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from cranktrain.language import _
from cranktrain.motion import Array
from cranktrain.scales import scale_for
from cranktrain.study.start import Start
from cranktrain.viz.figures import with_unit
from cranktrain.viz.paper.head import title_block
from cranktrain.viz.paper.page import MARGIN, Box, Figure, Page, drawing_settings, formula, paper
from cranktrain.viz.paper.panels import axes_in
from cranktrain.viz.paper.style import COLOURS, INK, MUTED
from cranktrain.viz.paper.tables import write_table
from cranktrain.viz.sheets.drive.torque_speed import draw_torque_speed

_LEFT, _LOOP = 0.56, 0.5
_GAP, _FOOT = 9.0, 9.0
_MOST_MARKS, _NAMED = 14, 3
"""Events that are marked over the time, and that the table has room for."""
_RPM = 60 / (2 * np.pi)


class _Line(NamedTuple):
    """A curve over time: symbol, values in SI, colour, dashes."""

    symbol: str
    values: Array
    colour: str
    dashes: tuple[float, ...] = ()


@drawing_settings()
def start_picture(start: Start) -> Figure:
    """Draw what became of a start."""
    page = Page(*paper("A4"))
    top = title_block(page, start.machine, _("Start: {reason}").format(reason=start.run.reason)) - 4.0
    box = Box(MARGIN, MARGIN, page.width - 2 * MARGIN, top - MARGIN)
    left = Box(box.left + 14.0, box.bottom, _LEFT * box.width - 20.0, box.height)
    _draw_over_time(page, start, left)
    begin = box.left + _LEFT * box.width + 8.0
    right = Box(begin, box.bottom, box.left + box.width - begin, box.height)
    below = right.bottom + right.height
    if start.motor is not None:
        room = right._replace(bottom=below - _LOOP * right.height, height=_LOOP * right.height)
        way = (start.run.curves.motor_speed, start.run.curves.motor_torque)
        below = draw_torque_speed(page, start.motor, 0, way, room, _("this start")) - 2.0
    write_table(page, list(_facts(start)), (right.left, below, right.width), (1.0,))
    return page.figure


def _panels(start: Start) -> Iterator[tuple[str, str, tuple[_Line, ...]]]:
    """Heads, units and curves, one above the other."""
    curves = start.run.curves
    speed = _Line("n", curves.motor_speed * _RPM, COLOURS["v"])
    yield _("Speed of the motor, rpm"), "1", (speed,)
    if start.run.stroke is not None:
        yield _("Speed of the crank, rpm"), "1", (_Line("n", curves.crank_speed * _RPM, COLOURS["s"]),)
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


def _draw_over_time(page: Page, start: Start, box: Box) -> None:
    """Stack the curves over the time."""
    panels = list(_panels(start))
    each = (box.height - _FOOT - 5.2 - _GAP * (len(panels) - 1)) / len(panels)
    low = box.bottom + box.height - 5.2 + _GAP
    for place, (title, unit, lines) in enumerate(panels, start=1):
        low -= each + _GAP
        scale = scale_for(unit, float(np.max(np.abs([line.values for line in lines]))))
        axes = axes_in(page, Box(box.left, low, box.width, each))
        axes.axhline(0.0, color=MUTED, linewidth=0.6, zorder=1)
        for line in lines:
            dashes = (0, line.dashes) if line.dashes else "-"
            axes.plot(start.time, scale.of(line.values), color=line.colour, linewidth=1.4, linestyle=dashes)
        for event in start.events[:_MOST_MARKS] if len(start.events) <= _MOST_MARKS else ():
            axes.axvline(event.time, color=MUTED, linewidth=0.4, linestyle=(0, (1.0, 3.0)))
        axes.set(xlim=(float(start.time[0]), float(start.time[-1])))
        axes.tick_params(labelbottom=place == len(panels))
        page.heading(box.left, low + each + 2.2, f"{title}, {scale.label}".removesuffix(", "))
        _write_legend(page, lines, (box.left + box.width, low + each + 2.2))
    page.text(box.left + box.width / 2, low - _FOOT, _("Time, s"), ha="center")


def _write_legend(page: Page, lines: tuple[_Line, ...], place: tuple[float, float]) -> None:
    """Name the curves of a panel over its right end, where there are several."""
    x, y = place
    for line in reversed(lines) if len(lines) > 1 else ():
        words = page.text(x, y, formula(line.symbol), ha="right", color=line.colour)
        begin, _end = page.ends(words)
        dashes = (0, line.dashes) if line.dashes else "-"
        page.sample(begin - 9.0, begin - 1.5, y + 0.9, color=line.colour, linewidth=1.4, linestyle=dashes)
        x = begin - 13.0


def _facts(start: Start) -> Iterator[tuple[str, str]]:
    """Rows of the table."""
    curves, run = start.run.curves, start.run

    def of(words: str, value: float, unit: str) -> tuple[str, str]:
        return words, with_unit(float(value), scale_for(unit, abs(float(value))))

    yield _("The start"), ""
    yield of(_("ends after"), run.time[-1], "s")
    yield _("turns of the crank"), f"{float(np.ptp(curves.crank_angle_turned)) / (2 * np.pi):.3f}"
    yield of(_("largest torque of the motor"), np.max(curves.motor_torque), "N*m")
    yield of(_("largest power of the motor"), np.max(curves.motor_power), "W")
    yield of(_("work of the motor"), curves.motor_work[-1], "J")
    yield of(_("work that the loads took"), curves.load_work[-1], "J")
    yield of(_("lost in gearing, clutch and brake"), curves.lost_work[-1], "J")
    yield of(_("in motion at the end"), curves.kinetic_energy[-1], "J")
    yield of(_("heat in the motor"), curves.motor_heat[-1], "J")
    yield _("energy left over"), f"{abs(run.residual) / run.supplied if run.supplied else 0.0:.1e}"
    yield _("events"), str(len(run.events))
    for event in run.events[:_NAMED]:
        yield event.name, f"{event.time:.4f} s"
