"""Fields of tables that stand in many: one value or a list of them, what a file holds, and in which columns."""

from typing import Annotated, TypeAlias, TypeVar, cast

from pydantic import BeforeValidator, Field

from cranktrain.language import N_

Item = TypeVar("Item")


def _listed(data: object) -> object:
    """Take one value for a list of one."""
    return cast(object, data) if isinstance(data, list | tuple) else (data,)


OneOrMany = Annotated[tuple[Item, ...], BeforeValidator(_listed), Field(min_length=1)]
"""One value, or a list of them."""

OF_FILE = frozenset({"file", "text", "columns"})
"""Fields that say where the numbers of a curve are."""

FileText: TypeAlias = Annotated[
    str | None,
    Field(description=N_("What the file holds, where it is not to be read; `file` is then only its name.")),
]
"""Put there by whoever loads a machine file, who reads the file that `file` names."""

FileColumns: TypeAlias = tuple[Annotated[int, Field(ge=1)], ...] | None
"""Columns of a file, counted from 1."""
