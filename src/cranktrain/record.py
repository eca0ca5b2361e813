"""Data that does not change: `record`, as `dataclass(frozen=True, eq=False)` is, but quickly made."""

from dataclasses import FrozenInstanceError, dataclass, field, fields
from typing import Any, TypeVar, dataclass_transform

from cranktrain.brief import brief_fields

__all__ = ["record"]

Data = TypeVar("Data")


@dataclass_transform(frozen_default=True, eq_default=False, field_specifiers=(field,))
def record(data: type[Data]) -> type[Data]:
    """Make a class of fields a frozen dataclass whose instances are equal only to themselves, as arrays ask for.

    A frozen `dataclass` writes and compiles four functions for every class. With more than a hundred classes that is a
    seventh of the time in which the terminal answers, so here all share three of the four.

    Examples
    --------
    >>> @record
    ... class Rod:
    ...     length: float
    >>> Rod(0.136)
    Rod(length=0.136)
    """
    frozen: Any = dataclass(eq=False, repr=False)(data)
    frozen.__setattr__, frozen.__delattr__ = _set_once, _refuse
    if "__repr__" not in data.__dict__:
        frozen.__repr__ = _shown
    return frozen


def _set_once(self: Any, name: str, value: object) -> None:
    """Let `__init__` set each field, and nobody after it."""
    own: dict[str, object] = self.__dict__
    if name in own or name not in self.__dataclass_fields__:
        _refuse(self, name)
    own[name] = value


def _refuse(self: object, name: str) -> None:
    """Refuse a change."""
    raise FrozenInstanceError(f"{type(self).__name__} is frozen: {name} cannot be changed")


def _shown(self: Any) -> str:
    """Show class and fields in one line."""
    return brief_fields(type(self).__qualname__, ((each.name, getattr(self, each.name)) for each in fields(self)))
