"""A result as CSV and as JSON: every number with the shortest digits that read back to the same double."""

import csv
import io
import itertools
import json
from collections.abc import Callable, Collection, Iterator, Mapping

import numpy as np

from cranktrain.analysis import Result
from cranktrain.catalogue import Entry
from cranktrain.io.conventions import conventions
from cranktrain.motion import Array
from cranktrain.version import VERSION

Writer = Callable[[Result, Mapping[str, object], Collection[str]], Iterator[str]]
"""Writes a result, the data of its machine file, and those of its quantities that are named, as pieces of text."""


def csv_text(result: Result, machine: Mapping[str, object], names: Collection[str]) -> Iterator[str]:
    """Write curves as a table with one row for each crank angle.

    Parameters
    ----------
    result : Result
        Of one machine.
    machine : mapping
        The data of its file; a table has no place for them.
    names : collection of str
        Quantities to write; facts, which have no crank angle, are left out.

    Yields
    ------
    str
        Lines: `#` lines with the conventions, a head `name(index) [unit]`, then the numbers; NaN is written `nan`.
    """
    del machine
    about = {"cranktrain": VERSION, "machine": result.machines[0].name, **conventions(result)}
    left_out = [name for name, entry in result.catalogue.items() if name not in names and not entry.is_fact]
    if left_out:
        about["left out"] = ", ".join(left_out)
    for word, sentence in about.items():
        yield f"# {word}: {' '.join(sentence.split())}\n"
    written = [entry for name, entry in result.catalogue.items() if name in names and not entry.is_fact]
    columns = {"crank_angle [deg]": result.crank_angle}
    columns.update(column for entry in written for column in _columns(result, entry))
    row = io.StringIO()
    writer = csv.writer(row, lineterminator="\n")
    writer.writerow(columns)
    for numbers in zip(*(column.tolist() for column in columns.values()), strict=True):
        writer.writerow(map(repr, numbers))
        yield row.getvalue()
        row.seek(0)
        row.truncate()


def json_text(result: Result, machine: Mapping[str, object], names: Collection[str]) -> Iterator[str]:
    """Write a result whole.

    Parameters
    ----------
    result : Result
        Of one machine.
    machine : mapping
        The data of its file.
    names : collection of str
        Quantities to write.

    Yields
    ------
    str
        A JSON object: `cranktrain`, `machine`, `conventions`, `crank_angle`, `quantities`, `facts`, `checks`,
        `unused`, `flags`, `missing`. Values are nested lists in the order of `dimensions`; NaN is null.
    """
    chosen = {name: entry for name, entry in result.catalogue.items() if name in names}
    parts = {
        "cranktrain": VERSION,
        "machine": machine,
        "conventions": conventions(result),
        "crank_angle": {"unit": "deg", "symbol": "φ", "values": _nested(result.crank_angle)},
        "quantities": {name: _described(result, entry) for name, entry in chosen.items() if not entry.is_fact},
        "facts": {name: _described(result, entry) for name, entry in chosen.items() if entry.is_fact},
        "checks": [
            {
                "name": check.name,
                "sentence": check.sentence,
                "residual": _nested(check.residual[0]),
                "limit": check.limit,
                "passed": bool(check.passed[0]) if check.judged[0] else None,
            }
            for check in result.checks
        ],
        "unused": [
            {"table": one.table, "needs": list(one.needs), "consequence": one.consequence} for one in result.unused
        ],
        "flags": list(result.flags),
        "missing": [{"results": list(missing.results), "needs": list(missing.needs)} for missing in result.missing],
    }
    start = "{\n"
    for name, part in parts.items():
        yield f"{start}{_json(name)}: {_json(part)}"
        start = ",\n"
    yield "\n}\n"


WRITERS: Mapping[str, Writer] = {".csv": csv_text, ".json": json_text}
"""What a file's suffix means."""


def _columns(result: Result, entry: Entry) -> Iterator[tuple[str, Array]]:
    """Give every column of a curve with its head."""
    curves: Array = np.moveaxis(getattr(result, entry.name), entry.dimensions.index("crank_angle"), -1)
    labels = result.labels_of(entry).values()
    for place in itertools.product(*(range(len(names)) for names in labels)):
        index = " ".join(names[i] for names, i in zip(labels, place, strict=True))
        yield f"{entry.name}({index}) [{entry.unit}]" if index else f"{entry.name} [{entry.unit}]", curves[place]


def _described(result: Result, entry: Entry) -> dict[str, object]:
    """One quantity with all that its catalogue entry says."""
    return {
        "unit": entry.unit,
        "symbol": entry.symbol,
        "dimensions": entry.dimensions,
        "labels": result.labels_of(entry),
        "sentence": entry.sentence,
        "source": entry.source,
        "values": _nested(getattr(result, entry.name)),
    }


def _nested(values: Array) -> object:
    """Nested lists of floats, with None for what JSON has no number for."""
    array = np.asarray(values, dtype=object)
    array[~np.isfinite(values)] = None
    return array.tolist()


def _json(data: object) -> str:
    return json.dumps(data, ensure_ascii=False, allow_nan=False)
