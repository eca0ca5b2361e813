"""`list`: examples, kinds of mechanism, results."""

from collections.abc import Iterator, Mapping
from typing import cast

from cranktrain.errors import InputError
from cranktrain.language import _
from cranktrain.layout.ends import ENDS


def show_list(what: str) -> None:
    """Show a list, one line for each item, so that it can be searched."""
    lists = {"examples": _examples, "kinds": _kinds, "results": _results}
    if what not in lists:
        from cranktrain.quantities import unlisted  # only after a mistake

        raise InputError([unlisted("list", what, list(lists))])
    for line in lists[what]():
        print(line)


def _examples() -> Iterator[str]:
    """Give name, title and mechanisms of every example."""
    from cranktrain.io.examples import example_document, example_names

    names = example_names()
    width = max(map(len, names))
    for name in names:
        data = example_document(name).data
        yield f"{name:{width}}  {data.get('name', '')} ({', '.join(_mechanisms(data))})"


def _mechanisms(data: Mapping[str, object]) -> list[str]:
    """Name the kinds of mechanism in a machine file, each once."""
    banks = cast("Mapping[str, Mapping[str, object]]", data.get("bank", {}))
    opposed = [table[end] for table in banks.values() for end in ENDS if end in table]
    tables = cast("list[Mapping[str, object]]", [data, *banks.values(), *opposed])
    mechanisms = [table["mechanism"] for table in tables if "mechanism" in table]
    return list(dict.fromkeys(cast("Mapping[str, str]", mechanism)["kind"] for mechanism in mechanisms))


def _kinds() -> Iterator[str]:
    """Give name and title of every kind."""
    from cranktrain.mechanisms import KINDS

    width = max(len(kind.name) for kind in KINDS)
    for kind in KINDS:
        yield f"{kind.name:{width}}  {_(kind.title)}"


def _results() -> Iterator[str]:
    """Give name, unit, symbol and sentence of every result, curves marked by (φ)."""
    from cranktrain.analysis import STAGES
    from cranktrain.catalogue import entries

    every = [entry for stage in STAGES for entry in entries(stage.gives)]
    width, units = max(len(entry.name) for entry in every), max(len(entry.unit) for entry in every)
    for entry in every:
        symbol = entry.symbol if entry.is_fact else f"{entry.symbol}(φ)"
        yield f"{entry.name:{width}}  {entry.unit:{units}}  {symbol:10}  {entry.sentence}"
