"""Facts as a table: a row for each value that holds for the whole cycle."""

import csv
import io
import itertools
from collections.abc import Collection, Iterator

import numpy as np

from cranktrain.analysis import Result
from cranktrain.catalogue import Entry
from cranktrain.scales import in_asked_unit

HEADS = ("quantity", "of", "value", "unit", "meaning")


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
