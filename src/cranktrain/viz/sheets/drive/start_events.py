"""What happens on the way of a start, on paper: marks over the time, and rows that say what they are."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from cranktrain.language import _
from cranktrain.questions.start.record import StartEvent
from cranktrain.scales import scale_for
from cranktrain.viz.figures import with_unit
from cranktrain.viz.paper.page import Axes, Page
from cranktrain.viz.paper.style import INK, MUTED

STRIP = 4.0
"""Height of the numbers over the marks. [mm]"""
_FEW, _MOST = 3, 60
"""Events of one name that each have a number and a row; lines of one that has none."""
_WIDE = 2.2
"""Of a number over its mark; nearer ones stand together. [mm]"""


class EventSort(NamedTuple):
    """Events of one name: their number on the picture, 0 of those that come too often for one, and their times. [s]"""

    name: str
    number: int
    times: tuple[float, ...]


def event_sorts(events: Sequence[StartEvent]) -> list[EventSort]:
    """Sort events by name: the rare ones, numbered, before the others, each in the order in which it first comes."""
    times: dict[str, list[float]] = {}
    for event in events:
        times.setdefault(event.name, []).append(event.time)
    rare = [name for name, own in times.items() if len(own) <= _FEW]
    numbered = [EventSort(name, number, tuple(times[name])) for number, name in enumerate(rare, start=1)]
    return numbered + [EventSort(name, 0, tuple(own)) for name, own in times.items() if name not in rare]


def draw_events(axes: Axes, sorts: Sequence[EventSort]) -> None:
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


def event_rows(sorts: Sequence[EventSort]) -> Iterator[tuple[str, str]]:
    """Rows of the table: the number of a mark, its name and time, or how many lines there are."""
    for one in sorts:
        if one.number:
            yield from ((f"{one.number}  {one.name}", _time(time)) for time in one.times)
        else:
            said = _("{name}, dotted: {n}") if len(one.times) <= _MOST else _("{name}, not drawn: {n}")
            yield said.format(name=one.name, n=len(one.times)), _("first {time}").format(time=_time(one.times[0]))


def _time(time: float) -> str:
    return with_unit(time, scale_for("s", abs(time)))
