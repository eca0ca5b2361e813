"""The tab of a start: the terminal's rows, curves over time with what happens, and how the crank turns meanwhile."""

from collections.abc import Iterator
from dataclasses import replace
from itertools import pairwise
from math import log10

import numpy as np

from cranktrain.analysis import Result
from cranktrain.errors import InputError
from cranktrain.language import N_, _
from cranktrain.motion import Array
from cranktrain.panels.parts import CurveCard, Part, Stack
from cranktrain.panels.shapes import Curve, Panel
from cranktrain.panels.sheets.drive.start import event_sorts, start_picture
from cranktrain.saying.row_table import WrittenGroup, written_group
from cranktrain.saying.row_words import row_sentence
from cranktrain.saying.scales import Scale, scale_for
from cranktrain.study.start import Start, event_texts, quantities_of_start, whole_start
from cranktrain.web.parts import EventStrip, PageEvent, PageEvents, PagePart, page_parts
from cranktrain.web.tabs import AskedTab, CourseWords, PageCourse, PagePace, PageSheet, TabContent, lacking_sheet

_NAME = N_("Start")

_MOST = 4000
"""Points of a curve; of a longer run a page has the least and the largest value in each of half as many spans."""
_STEPS = 100
"""Of a run, about which one is the step of a key."""
_LEAST_SHOWN = 4.0
"""A run that is over sooner is shown slower at first, so that it takes as long. [s]"""
_SLOWER = (1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0)
"""Seconds of a page for one of the run."""


def _is_there(result: Result) -> bool:
    """Whether a machine has a start: what drives its crank, and what that moves."""
    if result.machines[0].drive is None:
        return False
    try:
        quantities_of_start(result.machines[0])
    except InputError:
        return False
    return True


def _content(result: Result) -> TabContent:
    """Run the machine over time."""
    try:
        found = whole_start(result.machines[0])
    except InputError as error:
        return TabContent("", WrittenGroup(str(_(_NAME)), (), ()), (lacking_sheet(error),))
    ((title, rows),) = found.answer_rows()
    sentence = row_sentence(title, rows[:1])  # when and why it ends
    return TabContent(sentence, written_group(title, rows), (_sheet(found),), course=_course(found))


START = AskedTab(_NAME, _is_there, _content)


def _sheet(found: Start) -> PageSheet:
    """Give what is over time, and beside it the way through the motor's curve and what happens."""
    picture = start_picture(found)
    events = tuple(_events(found))
    listed = PageEvents(_("Events"), events)
    curves, *beside = [_drawn(found, column.parts) for column in picture.columns]
    if not curves:
        return PageSheet(picture.title, ((listed,),))
    strip = EventStrip(events, _scale(found).of(float(found.run.whole_time[-1])))
    return PageSheet(picture.title, ((strip, *curves), (*(part for each in beside for part in each), listed)))


def _drawn(found: Start, parts: tuple[Part, ...]) -> tuple[PagePart, ...]:
    """Curves of a column of the sheet, with that of the motor's heat; facts stand in the rows."""
    with_heat: list[Part] = []
    for part in parts:
        match part:
            case Stack(panels=panels):
                with_heat.append(replace(part, panels=tuple(map(_fewer_points, (*panels, *_heat(found, panels[0]))))))
            case CurveCard(panels=panels):
                with_heat.append(replace(part, panels=tuple(map(_fewer_points, panels))))
            case _:
                pass
    return tuple(page_parts(with_heat))


def _heat(found: Start, like: Panel) -> Iterator[Panel]:
    """Heat in a motor that has any, over the same."""
    heat = found.run.whole.motor_heat
    if np.any(heat > 0):
        entry = found.catalogue["motor_heat"]
        curve = Curve(heat, "card", "N")
        yield replace(like, title=_(entry.message), unit=entry.shown, symbol=entry.symbol, curves=(curve,))


def _fewer_points(panel: Panel) -> Panel:
    """Give a panel whose curves have no more points than a page draws."""
    return replace(panel, curves=tuple(_thinned(curve, panel.across_of(curve)) for curve in panel.curves))


def _thinned(curve: Curve, across: Array) -> Curve:
    """Give the least and the largest value of each span of a curve with many points, and both its ends."""
    n = curve.values.size
    if n <= _MOST:
        return curve
    spans = np.linspace(0, n, _MOST // 2 + 1).astype(np.intp)
    least, largest = (
        [first + int(of(curve.values[first:last])) for first, last in pairwise(spans.tolist())]
        for of in (np.argmin, np.argmax)
    )
    chosen = np.unique([0, *least, *largest, n - 1])
    return replace(curve, values=curve.values[chosen], across=across[chosen])


def _scale(found: Start) -> Scale:
    """In which unit the panels have the time."""
    return scale_for("s", float(found.run.whole_time[-1]))


def _events(found: Start) -> Iterator[PageEvent]:
    """Give what happens as the terminal writes it, with the numbers of the curves."""
    numbers = {str(sort.name): sort.number for sort in event_sorts(found.events)}
    scale = _scale(found)
    for event in found.events:
        texts = event_texts(event)
        at, number = scale.of(event.time), numbers[str(event.name)]
        yield PageEvent(at, number, texts.time.strip(), texts.name, texts.angle, texts.speed)


def _course(found: Start) -> PageCourse | None:
    """Give how the crank turns; nothing where no time passes."""
    time, angle = found.run.whole_time, np.degrees(found.run.whole.crank_angle_turned)
    duration = float(time[-1])
    if duration <= 0:
        return None
    chosen = np.unique(np.linspace(0, time.size - 1, min(time.size, _MOST)).astype(np.intp))
    scale = _scale(found)
    step = 10.0 ** round(log10(scale.of(duration) / _STEPS))
    paces = tuple(
        PagePace(scale.of(1.0 / slower), _("real speed") if slower == 1 else _("{n:.0f} times slower", n=slower))
        for slower in _SLOWER
    )
    at_first = next((place for place, slower in enumerate(_SLOWER) if slower * duration >= _LEAST_SHOWN), -1)
    return PageCourse(
        unit=scale.label,
        time=scale.of(time[chosen]),
        crank_angle=angle[chosen],
        step=step,
        paces=paces,
        at_first=at_first % len(paces),
        words=_words(f"{step:g} {scale.label}"),
    )


def _words(step: str) -> CourseWords:
    """Say how it is moved."""
    return CourseWords(
        drawing=_("The mechanism at a moment of its start; drag to turn the crank"),
        time=_("Time"),
        play=_("Let the start run"),
        stop=_("Stop at this moment"),
        back=_("{step} back", step=step),
        on=_("{step} on", step=step),
        keys=_("space runs and stops · ← → {step}, with shift ten of them · Home to the beginning", step=step),
        pace=_("How fast"),
    )
