"""Data that does not change: `record`, as `dataclass(frozen=True, eq=False)` is, but quickly made."""

import sys
from dataclasses import MISSING, Field, FrozenInstanceError, dataclass, field, fields
from typing import Any, TypeVar, dataclass_transform

from cranktrain.brief import brief_fields

__all__ = ["record"]

Data = TypeVar("Data")


@dataclass_transform(frozen_default=True, eq_default=False, field_specifiers=(field,))
def record(data: type[Data]) -> type[Data]:
    """Make a class of fields a frozen dataclass whose instances are equal only to themselves, as arrays ask for.

    A frozen `dataclass` writes and compiles four functions for every class. With hundreds of classes that is a
    seventh of the time in which the terminal answers, so here all share three of the four, and the fourth, `__init__`,
    is written for those classes that have an instance.

    Examples
    --------
    >>> @record
    ... class Rod:
    ...     length: float
    >>> Rod(0.136)
    Rod(length=0.136)
    """
    frozen: Any = dataclass(init=False, eq=False, repr=False)(data)
    frozen.__init__ = _Unwritten(data)
    frozen.__setattr__, frozen.__delattr__ = _refuse, _refuse
    if "__repr__" not in data.__dict__:
        frozen.__repr__ = _shown
    return frozen


class _Unwritten:
    """Stands for the `__init__` of a record until somebody calls it or looks at it."""

    def __init__(self, data: type) -> None:
        self._data = data

    def __get__(self, instance: object, owner: type | None = None) -> Any:
        """Write it, and give it as a function is given."""
        written: Any = _init(self._data)
        self._data.__init__ = written
        return written if instance is None else written.__get__(instance, owner)


class _Maker:
    """Makes a field's value where it is not given."""

    def __init__(self, make: Any) -> None:
        self.make = make

    def __repr__(self) -> str:
        """Show it as dataclasses show theirs."""
        return "<factory>"


def _init(data: Any) -> Any:
    """Write what takes the fields of a record and sets them."""
    each: tuple[Field[Any], ...] = fields(data)
    usual = {_kept(one): one.default for one in each if one.default is not MISSING}
    makers = {_kept(one): _Maker(one.default_factory) for one in each if one.default_factory is not MISSING}
    in_order = [one for one in each if not one.kw_only]
    named = [one for one in each if one.kw_only]
    taken = [_taken(one) for one in in_order] + (["*"] if named else []) + [_taken(one) for one in named]
    lines = [
        f"def written({', '.join((*usual, *makers))}):",
        f"    def __init__(self, {', '.join(taken)}):",
        "        __own__ = self.__dict__",
        *(f"        __own__['{one.name}'] = {_value(one)}" for one in each),
        "    return __init__",
    ]
    found: dict[str, Any] = {}
    exec("\n".join(lines), vars(sys.modules[data.__module__]), found)
    made = found["written"](**usual, **makers)
    made.__qualname__ = f"{data.__qualname__}.__init__"
    made.__annotations__ = {one.name: one.type for one in each} | {"return": None}
    return made


def _taken(one: Field[Any]) -> str:
    """Name a field as a parameter, with what it is unless given: its maker, which is no value of it."""
    return one.name if one.default is MISSING and one.default_factory is MISSING else f"{one.name}={_kept(one)}"


def _value(one: Field[Any]) -> str:
    """Give a field's value, made where it was not given."""
    made = f"{_kept(one)}.make() if {one.name} is {_kept(one)} else {one.name}"
    return one.name if one.default_factory is MISSING else made


def _kept(one: Field[Any]) -> str:
    """Name what a field is unless given, or its maker, as no field is named."""
    return f"__{one.name}__"


def _refuse(self: object, name: str, _value: object = None) -> None:
    """Refuse a change."""
    raise FrozenInstanceError(f"{type(self).__name__} is frozen: {name} cannot be changed")


def _shown(self: Any) -> str:
    """Show class and fields in one line."""
    return brief_fields(type(self).__qualname__, ((each.name, getattr(self, each.name)) for each in fields(self)))
