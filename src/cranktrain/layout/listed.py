"""Fields of a table that are one value or a list of them."""

from typing import Annotated, TypeVar, cast

from pydantic import BeforeValidator, Field

Item = TypeVar("Item")


def _listed(data: object) -> object:
    """Take one value for a list of one."""
    return cast(object, data) if isinstance(data, list | tuple) else (data,)


OneOrMany = Annotated[tuple[Item, ...], BeforeValidator(_listed), Field(min_length=1)]
"""One value, or a list of them."""
