"""The chain from motor to crank on paper, in the symbols of kinematic diagrams, its parts numbered as in its table."""

import numpy as np

from cranktrain.language import _
from cranktrain.plans.drive_scheme import DriveElement, DriveShaft
from cranktrain.quantities import shown
from cranktrain.scales import scale_for
from cranktrain.viz.figures import figure, with_unit
from cranktrain.viz.paper.page import Box, Page
from cranktrain.viz.paper.style import INK, MUTED
from cranktrain.viz.paper.tables import ROW, write_table

_HEIGHT = 36.0
"""Of the drawing with its numbers. [mm]"""
_APART = 13.0
"""From shaft to shaft. [mm]"""
_WHEEL, _DISC, _MOTOR = 0.9, 5.0, 4.0
"""Half of a wheel's rim, half of a disc's height, radius of a motor. [mm]"""
_LEAST_WHEEL, _LEAST_ROW = 0.2, 3.4
"""Of both wheels of a stage together the smaller one has at least so much; the lowest row of the table. [1, mm]"""
_COLUMNS = (1.0,)
_LINE = {"color": INK, "linewidth": 1.1, "solid_capstyle": "butt"}
_ROUND = np.linspace(0, 2 * np.pi, 73)


def draw_drive_chain(page: Page, chain: tuple[DriveShaft, ...], box: Box) -> None:
    """Draw shafts, stages and what turns with them at the top of a room, and the table of them below."""
    elements = [element for shaft in chain for element in shaft.elements]
    page.heading(box.left, box.bottom + box.height - 3.0, _("Drive, at the declared speed of the crank"))
    apart = box.width / len(elements)
    middle = box.bottom + box.height - 6.0 - 0.5 * _HEIGHT
    number = 0
    for place, shaft in enumerate(chain):
        level, beyond = (middle + 0.5 * _APART * (-1) ** (place + n) for n in (0, 1))
        before = 1.0 if place else 0.0 if shaft.elements[0].symbol == "motor" else 0.25
        begin = box.left + (number + 0.5 - before) * apart
        end = box.left + (number + len(shaft.elements) - 0.15) * apart
        _draw_shaft(page, shaft, (begin, end, level), (box.left + (number + 0.5) * apart, apart))
        for step, element in enumerate(shaft.elements):
            x = box.left + (number + step + 0.5) * apart
            _draw(page, element, (x, level), beyond)
            up = 1 if element.symbol != "stage" else np.sign(level - beyond)
            page.text(
                x, level + up * (_reach(element, level - beyond) + 3.4) - 1.2, str(number + step + 1), ha="center"
            )
        number += len(shaft.elements)
    rows = [(_("part"), ""), *((f"{n}  {one.words}", _value(one)) for n, one in enumerate(elements, start=1))]
    room = box.height - 6.0 - _HEIGHT
    line = max(_LEAST_ROW, min(ROW, (room - 4.0) / len(rows)))
    write_table(page, rows, (box.left, box.bottom + room, box.width), _COLUMNS, line)


def _value(element: DriveElement) -> str:
    """Number of an element with its unit."""
    if not np.isfinite(element.value):
        return ""
    if element.symbol == "stage":
        ratio = f"i = {element.value:.5g}"
        return ratio if element.efficiency == 1 else f"{ratio}, η = {element.efficiency:.4g}"
    if element.unit == "rad/s":
        return f"{figure(shown(element.value, 'rpm'))} rpm"
    return with_unit(element.value, scale_for(element.unit, element.value))


def _draw_shaft(page: Page, shaft: DriveShaft, line: tuple[float, float, float], places: tuple[float, float]) -> None:
    """Draw the shaft's line, open where a clutch divides it."""
    begin, end, level = line
    first, apart = places
    gaps = [first + n * apart for n, one in enumerate(shaft.elements) if one.symbol == "clutch"]
    for start, stop in zip([begin, *(gap + 0.8 for gap in gaps)], [*(gap - 0.8 for gap in gaps), end], strict=True):
        page.paper.plot([start, stop], [level, level], **_LINE)


def _draw(page: Page, element: DriveElement, at: tuple[float, float], beyond: float) -> None:
    """Draw one symbol."""
    x, y = at
    if element.symbol == "motor":
        page.paper.plot(x + _MOTOR * np.cos(_ROUND), y + _MOTOR * np.sin(_ROUND), color=INK, linewidth=1.1, zorder=4)
        page.paper.fill(x + _MOTOR * np.cos(_ROUND), y + _MOTOR * np.sin(_ROUND), color="white", zorder=3)
        page.text(x, y - 1.1, "M", ha="center", zorder=5)
    elif element.symbol == "stage":
        _draw_stage(page, x, y, element.value, beyond)
    elif element.symbol == "crank":
        page.paper.plot([x, x + 3.5], [y, y + 4.5], color=INK, linewidth=2.2)
        page.paper.plot(*at, "o", ms=4.0, mfc="white", mec=INK, mew=1.0, zorder=4)
        page.paper.plot(x + 3.5, y + 4.5, "o", ms=4.0, mfc="white", mec=INK, mew=1.0, zorder=4)
    elif element.symbol == "clutch":
        for side in (-0.8, 0.8):
            page.paper.plot([x + side] * 2, [y - 3.0, y + 3.0], color=INK, linewidth=2.0)
    else:
        page.paper.plot([x, x], [y - _DISC, y + _DISC], color=INK, linewidth=2.6, solid_capstyle="butt")
        if element.symbol == "brake":
            _draw_shoes(page, x, y)


def _draw_shoes(page: Page, x: float, y: float) -> None:
    """Draw the shoes of a brake, which are fixed, on both sides of its disc."""
    for side in (-1.6, 1.6):
        page.paper.plot([x + side] * 2, [y - _DISC + 0.4, y - _DISC + 3.4], color=INK, linewidth=1.6)
        page.paper.plot([x + side, x + 2.2 * side], [y - _DISC + 1.9] * 2, color=MUTED, linewidth=0.8)


def _share(ratio: float) -> float:
    """Part of the way from shaft to shaft that a stage's first wheel takes."""
    return float(np.clip(1 / (1 + ratio), _LEAST_WHEEL, 1 - _LEAST_WHEEL))


def _reach(element: DriveElement, apart: float) -> float:
    """How far a symbol goes from its shaft. [mm]"""
    return max(_DISC, _share(element.value) * abs(apart)) if element.symbol == "stage" else _DISC


def _draw_stage(page: Page, x: float, level: float, ratio: float, beyond: float) -> None:
    """Draw two wheels that meet: their sizes go with the ratio, as far as both can be seen."""
    meets = level + _share(ratio) * (beyond - level)
    for axis in (level, beyond):
        far = 2 * axis - meets
        page.paper.plot([x, x], [far, meets], color=INK, linewidth=1.4)
        for rim in (far, meets):
            page.paper.plot([x - _WHEEL, x + _WHEEL], [rim, rim], color=INK, linewidth=1.4)
