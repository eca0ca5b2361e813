"""A result as tables, CSV and JSON: every number with the shortest digits that read back to the same double."""

import csv
import io
import itertools
import json
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence

import numpy as np

from cranktrain.analysis import Result
from cranktrain.analysis.curve_columns import CurveColumn
from cranktrain.io.conventions import conventions
from cranktrain.motion import Array
from cranktrain.saying.catalogue import Entry
from cranktrain.saying.scales import in_asked_unit
from cranktrain.version import VERSION

HEADS = ("quantity", "of", "value", "unit", "meaning")


def csv_text(
    result: Result, columns: Sequence[CurveColumn], angles: Array | None = None, *, comma: bool = False
) -> Iterator[str]:
    """Write curves as a table with one row for each crank angle.

    Parameters
    ----------
    result : Result
        Of one machine.
    columns : sequence of CurveColumn
        To write.
    angles : Array, shape (n,)
        The crank angles of their values; those of the result unless given. [deg]
    comma : bool
        As spreadsheets take it where a comma divides decimals: semicolons between, a byte-order mark before.

    Yields
    ------
    str
        Lines: `#` lines with the conventions, a head `name(index) [unit]`, then the numbers; NaN is written `nan`.
    """
    yield from csv_lines(about(result, columns, angles).items(), headed(result, columns, angles), comma=comma)


def csv_lines(said: Iterable[tuple[str, str]], columns: Mapping[str, Array], *, comma: bool) -> Iterator[str]:
    """Write `#` lines with what is said, the heads of columns, and their numbers; `comma` as of `csv_text`."""
    if comma:
        yield "\ufeff"
    for word, sentence in said:
        yield f"# {word}: {' '.join(sentence.split())}\n"
    row = io.StringIO()
    writer = csv.writer(row, delimiter=";" if comma else ",", lineterminator="\n")
    writer.writerow(columns)
    for numbers in zip(*(column.tolist() for column in columns.values()), strict=True):
        digits = map(repr, numbers)
        writer.writerow([number.replace(".", ",") for number in digits] if comma else digits)
        yield row.getvalue()
        row.seek(0)
        row.truncate()


def about(result: Result, columns: Iterable[CurveColumn], angles: Array | None) -> dict[str, str]:
    """Say what a table of curves is of, what its numbers count from, and which curves are left out; of `csv_text`."""
    said = {"cranktrain": VERSION, "machine": result.machines[0].name, **conventions(result)}
    # Of some angles alone nobody expects all curves.
    if angles is not None:
        return said
    names = {column.entry.name for column in columns}
    left_out = [name for name, entry in result.catalogue.items() if name not in names and not entry.is_fact]
    return said | ({"left out": ", ".join(left_out)} if left_out else {})


def headed(result: Result, columns: Iterable[CurveColumn], angles: Array | None) -> dict[str, Array]:
    """Give the crank angle [deg] and every column by its head, `name(index) [unit]`; parameters as of `csv_text`."""
    found = {"crank_angle [deg]": result.crank_angle if angles is None else angles}
    for column in columns:
        entry = column.entry
        unit, values = in_asked_unit(entry.unit, column.values, entry.shown)
        found[f"{entry.name}({column.of}) [{unit}]" if column.of else f"{entry.name} [{unit}]"] = values
    return found


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
                "sentence": str(check.sentence),
                "residual": _nested(check.residual[0]),
                "limit": check.limit,
                "passed": bool(check.passed[0]) if check.judged[0] else None,
            }
            for check in result.checks
        ],
        "unused": [
            {"table": one.table, "needs": list(map(str, one.needs)), "consequence": str(one.consequence)}
            for one in result.unused
        ],
        "flags": list(result.flags),
        "missing": [
            {"results": list(missing.results), "needs": list(map(str, missing.needs))} for missing in result.missing
        ],
    }
    start = "{\n"
    for name, part in parts.items():
        yield f"{start}{_json(name)}: {_json(part)}"
        start = ",\n"
    yield "\n}\n"


def _described(result: Result, entry: Entry) -> dict[str, object]:
    """One quantity with all that its catalogue entry says."""
    unit, values = in_asked_unit(entry.unit, getattr(result, entry.name), entry.shown)
    return {
        "unit": unit,
        "symbol": entry.symbol,
        "dimensions": entry.dimensions,
        "labels": result.labels_of(entry),
        "sentence": entry.sentence,
        "source": entry.source,
        "equation": entry.equation,
        "values": _nested(values),
    }


def _nested(values: Array) -> object:
    """Nested lists of floats, with None for what JSON has no number for."""
    numbers = np.asarray(values, dtype=np.float64)
    array = numbers.astype(object)
    array[~np.isfinite(numbers)] = None
    return array.tolist()


def _json(data: object) -> str:
    return json.dumps(data, ensure_ascii=False, allow_nan=False)


def fact_rows(result: Result, names: Collection[str]) -> Iterator[tuple[str, str, float, str, str]]:
    """Give the facts one by one.

    Parameters
    ----------
    result : Result
        Of one machine.
    names : collection of str
        Quantities to give; curves are left out.

    Yields
    ------
    tuple
        In the order of `HEADS`: name, what of the machine it is of, the value, its unit, what it is.
    """
    for name, entry in result.catalogue.items():
        if name in names and entry.is_fact:
            unit, values = in_asked_unit(entry.unit, np.asarray(getattr(result, name)), entry.shown)
            for place, of in _places(result, entry):
                yield name, of, float(values[place]), unit, entry.sentence


def _places(result: Result, entry: Entry) -> Iterator[tuple[tuple[int, ...], str]]:
    """Give every place of a quantity's values with its labels."""
    labels = result.labels_of(entry).values()
    for place in itertools.product(*(range(len(names)) for names in labels)):
        yield place, " ".join(names[i] for names, i in zip(labels, place, strict=True))


def fact_csv(result: Result, names: Collection[str], *, comma: bool = False) -> Iterator[str]:
    """Write facts as lines of a CSV; parameters as of `fact_rows`.

    With `comma` as spreadsheets take it where a comma divides decimals: semicolons between, a byte-order mark before.
    """
    text = io.StringIO()
    writer = csv.writer(text, delimiter=";" if comma else ",", lineterminator="\n")
    writer.writerow(HEADS)
    for name, of, value, unit, meaning in fact_rows(result, names):
        number = repr(value).replace(".", ",") if comma else repr(value)
        writer.writerow((name, of, number, unit, meaning))
    yield "\ufeff" * comma + text.getvalue()
