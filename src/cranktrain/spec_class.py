"""The class that specs have: what completion and `help` list of a spec is its own."""

from functools import cached_property
from typing import TYPE_CHECKING, TypeVar

from pydantic import BaseModel

Found = TypeVar("Found")


class listed_property(cached_property[Found]):  # noqa: N801 - it is written above a method, as `cached_property` is
    """What is found once and kept, and listed: for users, too."""


if TYPE_CHECKING:
    # A checker sees the class that models have anyway, by which it knows their fields.
    from pydantic._internal._model_construction import ModelMetaclass as SpecClass  # pyright: ignore[reportPrivateUsage]
else:

    class SpecClass(type(BaseModel)):
        """Class of specs: lists what users need, not the hundred names that pydantic brings."""

        def __dir__(cls) -> list[str]:
            """Public names of the specs' own; what is found once and kept is for the program, unless it is listed."""
            mine = [base for base in cls.__mro__ if issubclass(base, BaseModel) and base is not BaseModel]
            own = {name: part for base in mine for name, part in vars(base).items()}
            kept = {name for name, part in own.items() if type(part) is cached_property}
            return sorted(name for name in own.keys() - kept - cls.unlisted if not name.startswith(("_", "model_")))


__all__ = ["SpecClass", "listed_property"]
