"""A start as a sheet: speed, torque, power and energy over time, its way through the motor's curve, its events."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from cranktrain.language import Listed, Message, Words, _
from cranktrain.motion import Array
from cranktrain.panels.parts import CurveCard, Sheet, SheetColumn, Stack, facts_table
from cranktrain.panels.shapes import Curve, Panel, PanelLine, Role
from cranktrain.panels.sheets.drive.torque_speed import torque_speed_panel
from cranktrain.questions.start.facts import StartFacts
from cranktrain.questions.start.record import StartEvent
from cranktrain.saying.amounts import Amount
from cranktrain.saying.rows import Telling
from cranktrain.saying.wording import power_of_ten
from cranktrain.study.start import Start

_CHAMBERS: tuple[Role, ...] = ("card", "later_card", "side", "resultant")
_FEW, _MOST = 3, 60
"""Events of one name that each have a number and a row; lines of one that has none."""


class EventSort(NamedTuple):
    """Events of one name: their number on the picture, 0 of those that come too often for one, and their times. [s]"""

    name: Words
    number: int
    times: tuple[float, ...]


def event_sorts(events: Sequence[StartEvent]) -> list[EventSort]:
    """Sort events by name: the rare ones, numbered, before the others, each in the order in which it first comes."""
    times: dict[Words, list[float]] = {}
    for event in events:
        times.setdefault(event.name, []).append(event.time)
    rare = [name for name, own in times.items() if len(own) <= _FEW]
    numbered = [EventSort(name, number, tuple(times[name])) for number, name in enumerate(rare, start=1)]
    return numbered + [EventSort(name, 0, tuple(own)) for name, own in times.items() if name not in rare]


def start_picture(start: Start) -> Sheet:
    """Collect what became of a start.

    Parameters
    ----------
    start : Start

    Returns
    -------
    Sheet
        Curves over the time with its events, its way through the motor's curve, and facts; of a start that takes no
        time facts alone.
    """
    run, sorts = start.run, event_sorts(start.events)
    rows = [*_facts(start), *_event_rows(sorts)]
    table = facts_table(_("The start"), rows)
    title = _("Start: {reason}", reason=run.reason)
    if run.whole_time[-1] <= run.whole_time[0]:
        return Sheet(start.machine, title, (SheetColumn(1.0, (table,)),))
    cards: tuple[CurveCard, ...] = ()
    if start.motor is not None:
        way = (run.whole.motor_speed, run.whole.motor_torque)
        cards = (CurveCard((torque_speed_panel(start.motor, 0, way, _("this start")),), height=0.5),)
    left = Stack(tuple(_panels(start, tuple(_levels(sorts)))), _("Time, s"))
    return Sheet(start.machine, title, (SheetColumn(0.56, (left,)), SheetColumn(0.44, (*cards, table))))


def _levels(sorts: Sequence[EventSort]) -> Iterator[PanelLine]:
    """Lines at events."""
    for one in sorts:
        role = "event" if one.number else "often"
        for time in one.times if len(one.times) <= _MOST else ():
            yield PanelLine(time, role, number=one.number, is_upright=True)


def _panels(start: Start, levels: tuple[PanelLine, ...]) -> Iterator[Panel]:
    """Curves one above the other: of the whole run, whatever times were asked for."""
    curves = start.run.whole

    def panel(title: Message, unit: str, *lines: Curve) -> Panel:
        return Panel(title, unit, start.run.whole_time, lines, across_unit="s", levels=levels)

    def of(name: str, role: Role, letter: str, symbol: str = "") -> Curve:
        values: Array = getattr(curves, name)
        return Curve(values, role, letter, symbol)

    yield panel(_("Speed of the motor"), "rpm", of("motor_speed", "card", "v"))
    if start.run.stroke is not None:
        yield panel(_("Speed of the crank"), "rpm", of("crank_speed", "card", "s"))
    if start.motor is not None:
        yield panel(_("Torque of the motor"), "N*m", of("motor_torque", "card", "T"))
        yield panel(_("Power of the motor"), "W", of("motor_power", "card", "j"))
    if start.run.gas is not None and start.run.gas.names:
        names = start.run.gas.names
        lines = (
            Curve(own, _CHAMBERS[place % len(_CHAMBERS)], "p", name=name if len(names) > 1 else "")
            for place, (name, own) in enumerate(zip(names, start.run.gas.whole, strict=True))
        )
        yield panel(_("Pressure in the chambers"), "Pa", *lines)
    yield panel(
        _("Energy"),
        "J",
        of("motor_work", "card", "T", "W_m"),
        of("load_work", "carried", "s", "W_Q"),
        of("lost_work", "resultant", "N", "W_v"),
        of("kinetic_energy", "side", "F", "T"),
    )


def _facts(start: Start) -> Iterator[tuple[Words, Words]]:
    """What stands in the table, of the whole run, whatever times were asked for."""
    of, facts = Telling(start.labels, start.titles, 0), start.given[StartFacts]
    named = {
        "start_duration": _("ends after"),
        "crank_turns": _("turns of the crank"),
        "largest_motor_torque": _("largest torque of the motor"),
        "largest_motor_power": _("largest power of the motor"),
        "final_motor_work": _("work of the motor"),
        "final_load_work": _("work that the loads took"),
        "final_lost_work": _("lost in gearing, clutch and brake"),
        "final_kinetic_energy": _("in motion at the end"),
    }
    if facts.final_motor_heat[0] > 0:
        named["final_motor_heat"] = _("heat in the motor")
    yield from ((words, of.amount(facts, name)) for name, words in named.items())
    yield _("energy left over, of what was put in"), power_of_ten(float(facts.energy_left_over[0]))


def _event_rows(sorts: Sequence[EventSort]) -> Iterator[tuple[Words, Words]]:
    """What the table says of events: the number of a mark, its name and time, or how many lines there are."""
    for one in sorts:
        if one.number:
            yield from ((Listed((str(one.number), one.name), "  "), Amount(time, "s")) for time in one.times)
        else:
            said = _("{name}, dotted: {n}") if len(one.times) <= _MOST else _("{name}, not drawn: {n}")
            yield said.format(name=one.name, n=len(one.times)), _("first {time}", time=Amount(one.times[0], "s"))
