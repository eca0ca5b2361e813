"""A run as tables, CSV and JSON: every number with the shortest digits that read back to the same double."""

import csv
import io
import itertools
import json
import math
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from typing import Any

import numpy as np

from cranktrain.analysis import Result
from cranktrain.analysis.curve_columns import CurveColumn
from cranktrain.motion import Array
from cranktrain.saying.catalogue import Entry
from cranktrain.saying.run import Axis, RowHeads, Run
from cranktrain.saying.scales import in_asked_unit
from cranktrain.version import VERSION

HEADS = ("quantity", "of", "value", "unit", "meaning")


def csv_text(
    run: Run, columns: Sequence[CurveColumn], places: Array | None = None, *, comma: bool = False
) -> Iterator[str]:
    """Write curves as a table with one row for each place of the axis, such as a crank angle.

    Parameters
    ----------
    run : Run
        Of one design.
    columns : sequence of CurveColumn
        To write.
    places : Array, shape (n,)
        Where on the axis their values are; all along it unless given.
    comma : bool
        As spreadsheets take it where a comma divides decimals: semicolons between, a byte-order mark before.

    Yields
    ------
    str
        Lines: `#` lines with the conventions, a head `name(index) [unit]`, then the numbers; NaN is written `nan`.
    """
    yield from csv_lines(about(run, columns, places), headed(run, columns, places), comma=comma)


def csv_lines(said: Iterable[tuple[str, str]], columns: Mapping[str, Array], *, comma: bool) -> Iterator[str]:
    """Write `#` lines with what is said, the heads of columns, and their numbers; `comma` as of `csv_text`."""
    if comma:
        yield "\ufeff"
    for word, sentence in said:
        yield _remark(word, sentence)
    row = io.StringIO()
    writer = csv.writer(row, delimiter=";" if comma else ",", lineterminator="\n")
    writer.writerow(columns)
    for row_of_table in zip(*(column.tolist() for column in columns.values()), strict=True):
        writer.writerow([_digits(value, comma=comma) for value in row_of_table])
        yield row.getvalue()
        row.seek(0)
        row.truncate()


def _digits(value: float | str, *, comma: bool) -> str:
    """A number with all its digits, or words as they are."""
    if isinstance(value, str):
        return value
    return repr(value).replace(".", ",") if comma else repr(value)


def _remark(word: str, sentence: str) -> str:
    """A line that is no row."""
    return f"# {word}: {' '.join(sentence.split())}\n"


def about(run: Run, columns: Iterable[CurveColumn], places: Array | None) -> Iterator[tuple[str, str]]:
    """Say what a table of curves is of, what its numbers count from, and which curves are left out; of `csv_text`."""
    yield "cranktrain", VERSION
    for word, sentence in run.about():
        yield word, str(sentence)
    # Of some places alone nobody expects all curves.
    names = {column.entry.name for column in columns}
    left_out = [name for name, entry in run.catalogue.items() if name not in names and run.is_curve(entry)]
    if places is None and left_out:
        yield "left out", ", ".join(left_out)


def headed(run: Run, columns: Iterable[CurveColumn], places: Array | None) -> dict[str, Array]:
    """Give the axis and every column by its head, `name(index) [unit]`; parameters as of `csv_text`.

    Of a run whose facts have a row each the columns that say which before them.
    """
    found: dict[str, Array] = {}
    if run.axis is not None:
        found[f"{run.axis.name} [{run.axis.unit or '1'}]"] = run.axis.values if places is None else places
    for column in columns:
        entry = column.entry
        unit, values = in_asked_unit(entry.unit, column.values, entry.shown)
        found[f"{entry.name}({column.of}) [{unit}]" if column.of else f"{entry.name} [{unit}]"] = values
    if run.design_rows is not None:
        return {**run.design_rows.columns, **dict(_facts_in_rows(run, run.design_rows))}
    for name, of, texts in _marked(run) if places is None else ():
        found[f"{name}({of})" if of else name] = texts
    return found


def _facts_in_rows(run: Run, rows: RowHeads) -> Iterator[tuple[str, Any]]:
    """Facts of runs that have a row each, member by member, and words beside them; in the order of their columns."""
    for name, entry in run.catalogue.items():
        unit, values = in_asked_unit(entry.unit, getattr(run, name), entry.shown)
        members = [labels for dimension, labels in run.labels_of(entry).items() if dimension not in rows.along]
        columns = values.reshape(-1, math.prod(map(len, members))).T
        for own, column in zip(itertools.product(*members), columns, strict=True):
            yield f"{name}({' '.join(own)}) [{unit}]" if own else f"{name} [{unit}]", column
    for name, (_dimensions, texts, _about) in run.marks.items():
        yield name, np.ravel(texts)


def _marked(run: Run) -> Iterator[tuple[str, str, Any]]:
    """Words beside quantities: their name, what they are of, those along the axis or alone."""
    over = None if run.axis is None else run.axis.name
    for name, (dimensions, texts, _about) in run.marks.items():
        members = [run.labels[dimension] for dimension in dimensions if dimension != over]
        for place in itertools.product(*(range(len(names)) for names in members)):
            yield name, " ".join(names[i] for names, i in zip(members, place, strict=True)), texts[place]


def json_text(run: Run, machine: Mapping[str, object], names: Collection[str]) -> Iterator[str]:
    """Write a run whole.

    Parameters
    ----------
    run : Run
        Of one design.
    machine : mapping
        The data of its file; left out where it is of none.
    names : collection of str
        Quantities to write.

    Yields
    ------
    str
        A JSON object: `cranktrain`, `machine`, what the run has before its numbers, such as `conventions`, its axis,
        `quantities`, `facts`, and what it has behind them, such as `checks`. Values are nested lists in the order of
        `dimensions`; NaN is null.
    """
    chosen = {name: entry for name, entry in run.catalogue.items() if name in names}
    axis = {} if run.axis is None else {run.axis.name: _along(run.axis)}
    parts = {
        "cranktrain": VERSION,
        **({"machine": machine} if machine else {}),
        **run.before(),
        **axis,
        "quantities": {name: _described(run, entry) for name, entry in chosen.items() if run.is_curve(entry)},
        "facts": {name: _described(run, entry) for name, entry in chosen.items() if not run.is_curve(entry)},
        **run.after(),
    }
    start = "{\n"
    for name, part in parts.items():
        yield f"{start}{_json(name)}: {_json(part)}"
        start = ",\n"
    yield "\n}\n"


def checks_record(result: Result) -> dict[str, object]:
    """Give checks of a result, what is not used, flags and what is missing, as JSON has them."""
    return {
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


def _along(axis: Axis) -> dict[str, object]:
    """The axis with all that is known of it."""
    return {"unit": axis.unit, "symbol": axis.symbol, "values": _nested(axis.values)}


def _described(run: Run, entry: Entry) -> dict[str, object]:
    """One quantity with all that its catalogue entry says."""
    unit, values = in_asked_unit(entry.unit, getattr(run, entry.name), entry.shown)
    return {
        "unit": unit,
        "symbol": entry.symbol,
        "dimensions": entry.dimensions,
        "labels": run.labels_of(entry),
        "sentence": entry.sentence,
        "source": entry.source,
        "equation": entry.equation,
        **({"line": line} if (line := entry.in_symbols(run.catalogue)) else {}),
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


def fact_rows(run: Run, names: Collection[str]) -> Iterator[tuple[str, str, float, str, str]]:
    """Give the facts one by one.

    Parameters
    ----------
    run : Run
        Of one design.
    names : collection of str
        Quantities to give; curves are left out.

    Yields
    ------
    tuple
        In the order of `HEADS`: name, what of the machine it is of, the value, its unit, what it is.
    """
    for name, entry in run.catalogue.items():
        if name in names and not run.is_curve(entry):
            unit, values = in_asked_unit(entry.unit, np.asarray(getattr(run, name)), entry.shown)
            for place, of in _places(run, entry):
                # Of runs side by side not each has every quantity.
                if run.axis is not None or not np.isnan(values[place]):
                    yield name, of, float(values[place]), unit, entry.sentence


def _places(run: Run, entry: Entry) -> Iterator[tuple[tuple[int, ...], str]]:
    """Give every place of a quantity's values with its labels."""
    labels = run.labels_of(entry).values()
    for place in itertools.product(*(range(len(names)) for names in labels)):
        yield place, " ".join(names[i] for names, i in zip(labels, place, strict=True))


def fact_csv(run: Run, names: Collection[str], *, comma: bool = False) -> Iterator[str]:
    """Write facts as lines of a CSV; parameters as of `fact_rows`.

    With `comma` as spreadsheets take it where a comma divides decimals: semicolons between, a byte-order mark before.
    """
    text = io.StringIO()
    # Where there are curves, too, their file says what all numbers count from.
    if run.axis is None:
        text.writelines(_remark(word, str(sentence)) for word, sentence in run.about())
    writer = csv.writer(text, delimiter=";" if comma else ",", lineterminator="\n")
    writer.writerow(HEADS)
    for name, of, value, unit, meaning in fact_rows(run, names):
        writer.writerow((name, of, _digits(value, comma=comma), unit, meaning))
    for name, of, words in _marked(run) if run.axis is None else ():
        if words:
            writer.writerow((name, of, words, "", str(run.marks[name].about)))
    yield "\ufeff" * comma + text.getvalue()
