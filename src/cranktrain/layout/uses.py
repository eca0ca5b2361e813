"""Tables and keys of a machine file by the names that they have in it, for what may stand there without being used."""

from collections.abc import Callable, Mapping, Sequence
from typing import Any

from cranktrain.layout.design import Design

Written = Callable[[Design], Sequence[str]]
"""Which of some tables or keys the file of a design has, as they are written there."""


def table(name: str) -> Written:
    """A table of the file that is one thing."""
    return lambda design: [f"[{name}]"] if design.tables.get(name) else []


def keys(path: str, *names: str) -> Written:
    """Keys of a table, or of those of single members in it."""

    def written(design: Design) -> Sequence[str]:
        common: Any = design.tables.get(path)
        below: Mapping[str, Any] = getattr(common, "overrides", {})
        tables = {path: common} | {f"{path}.{name}": own for name, own in below.items()}
        return [
            f"[{where}] {name}"
            for name in names
            for where, own in tables.items()
            if own is not None and name in own.model_fields_set
        ]

    return written


def inner_table(path: str, name: str) -> Written:
    """A table within another."""
    return lambda design: [f"[{path}.{name}]" for _key in keys(path, name)(design)]
