"""`list`: examples, kinds of mechanism, results."""

from collections.abc import Iterator, Mapping
from dataclasses import replace
from typing import Any, cast

from cranktrain.errors import InputError, Problem, problems_as, refuse
from cranktrain.language import said as _


def show_list(what: str, behind: str | None = None, file: str | None = None) -> None:
    """Show a list, one line for each item, so that it can be searched; or what stands behind a result."""
    lists = {"examples": _examples, "kinds": _kinds, "results": _results}
    if what not in lists:
        from cranktrain.quantities import unlisted  # only after a mistake

        raise InputError([unlisted("list", what, list(lists))])
    if behind is not None and what == "results":
        _show_behind(behind, file)
        return
    refuse(_out_of_place({"--behind": behind, "--of": file}))
    for line in lists[what]():
        print(line)


def _show_behind(quantity: str, file: str | None) -> None:
    """Show what leads to a quantity, of a machine that is named in that one."""
    from cranktrain.public import behind

    with problems_as(lambda problem: replace(problem, path="--behind") if problem.path == "behind" else problem):
        found = behind(quantity, file)
    for line in found.lines():
        print(line)


def _out_of_place(options: Mapping[str, str | None]) -> Iterator[Problem]:
    """Refuse options that only go with a result."""
    for option, given in options.items():
        if given is not None:
            allowed = _("goes with {example}", example="list results --behind NAME")
            yield Problem(option, given, allowed)


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
    banks = cast("Mapping[str, Mapping[str, object]]", data.get("bank", {})).values()
    opposed: list[Any] = [table for bank in banks for table in bank.values() if isinstance(table, Mapping)]
    tables = cast("list[Mapping[str, object]]", [data, *banks, *opposed])
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
    from cranktrain.analysis import every_stage
    from cranktrain.saying.catalogue import entries

    every = [entry for stage in every_stage() for entry in entries(stage.gives)]
    width, units = max(len(entry.name) for entry in every), max(len(entry.unit) for entry in every)
    for entry in every:
        symbol = entry.symbol if entry.is_fact else f"{entry.symbol}(φ)"
        yield f"{entry.name:{width}}  {entry.unit:{units}}  {symbol:10}  {entry.sentence}"
