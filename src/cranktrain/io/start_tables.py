"""A start as CSV over time, and as JSON with its events."""

import json
from collections.abc import Iterator, Mapping

import numpy as np

from cranktrain.io.tables import csv_lines
from cranktrain.language import said as _
from cranktrain.motion import Array
from cranktrain.saying.scales import in_asked_unit
from cranktrain.study.start import Start
from cranktrain.version import VERSION

SUFFIXES = (".csv", ".json")


def start_csv(start: Start, *, comma: bool = False) -> Iterator[str]:
    """Write the curves of a start, one row for each time.

    Parameters
    ----------
    start : Start
    comma : bool
        As spreadsheets take it where a comma divides decimals: semicolons between, a byte-order mark before.

    Yields
    ------
    str
        Lines: `#` lines with the machine, why it ended and the events; a head `name [unit]`; then the numbers.
    """
    yield from csv_lines(_about(start), dict(_columns(start)), comma=comma)


def start_json(start: Start, machine: Mapping[str, object]) -> Iterator[str]:
    """Write a start whole: a JSON object with `machine`, why it ended, `events`, `time` and `quantities`."""
    quantities: dict[str, object] = {}
    for name, entry in start.catalogue.items():
        unit, values = in_asked_unit(entry.unit, getattr(start, name), entry.shown)
        said = {"unit": unit, "symbol": entry.symbol, "sentence": entry.sentence}
        where = {"source": entry.source, "equation": entry.equation}
        quantities[name] = {**said, **where, "values": values.tolist()}
    whole = {
        "cranktrain": VERSION,
        "machine": machine,
        "reason": str(start.run.reason),
        "energy_residual": {"unit": "J", "value": start.run.residual, "supplied": start.run.supplied},
        "tolerance": start.run.tolerance,
        "events": [
            {"name": str(event.name), "time": event.time, "crank_angle": np.degrees(event.angle), "speed": event.speed}
            for event in start.events
        ],
        "time": {"unit": "s", "symbol": "t", "values": start.time.tolist()},
        "quantities": quantities,
    }
    yield json.dumps(whole, ensure_ascii=False, allow_nan=False) + "\n"


def _about(start: Start) -> Iterator[tuple[str, str]]:
    """What a table is of."""
    yield "cranktrain", VERSION
    yield "machine", start.machine.name
    yield "ended", str(start.run.reason)
    yield (
        "energy left over",
        _("{residual:.3g} J of {supplied:.6g} J", residual=start.run.residual, supplied=start.run.supplied),
    )
    for event in start.events:
        angle = float(np.degrees(event.angle))
        said = _("{name} at {time!r} s, crank angle {angle!r} deg", name=event.name, time=event.time, angle=angle)
        yield "event", said


def _columns(start: Start) -> Iterator[tuple[str, Array]]:
    """Time and every curve with its head."""
    yield "time [s]", start.time
    for name, entry in start.catalogue.items():
        unit, values = in_asked_unit(entry.unit, getattr(start, name), entry.shown)
        yield f"{name} [{unit}]", values
