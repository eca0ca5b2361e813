"""Data as a browser takes it: records as objects that say what they are, arrays in one block of 32-bit numbers."""

import json
import struct
from collections.abc import Callable, Mapping, Sequence
from dataclasses import fields, is_dataclass
from functools import cache
from math import isfinite
from types import NoneType
from typing import Any, NamedTuple, cast

import numpy as np
from numpy.typing import NDArray

from cranktrain.language import Said


class Packed(NamedTuple):
    """What a browser takes.

    Attributes
    ----------
    data : object
        As JSON has it; an array is `{"at": first, "shape": [...]}`, its place among the numbers, row by row.
    numbers : array of float32, shape (n,)
    """

    data: object
    numbers: NDArray[np.float32]

    @property
    def content(self) -> bytes:
        """JSON behind its length, and the first byte of every number, then the second of each, and so on.

        In this order those of curves, which differ little from one to the next, take a third less room compressed.
        """
        text = json.dumps(self.data, ensure_ascii=False, allow_nan=False, separators=(",", ":")).encode()
        each = self.numbers.astype("<f4").view(np.uint8).reshape(-1, 4)
        return struct.pack("<I", len(text)) + text + each.T.tobytes()


def packed(value: object) -> Packed:
    """Pack records, named tuples, mappings, sequences, arrays, words and numbers; words are said here and now.

    Parameters
    ----------
    value : object

    Returns
    -------
    Packed
        Arrays that are the same stand among the numbers once; NaN that stands alone becomes null.

    Raises
    ------
    TypeError
        For what is none of these.
    """
    packer = _Packer()
    return Packed(packer.plain(value), packer.numbers)


@cache
def _names_in(kind: Any) -> tuple[str, ...]:
    """Names of what a record or a named tuple of a class holds; none of what is neither, nor of words."""
    if issubclass(kind, Said):
        return ()
    return tuple(field.name for field in fields(kind)) if is_dataclass(kind) else getattr(kind, "_fields", ())


_AS_THEY_ARE = frozenset((NoneType, bool, int, str))
"""Classes of what JSON has, too."""


@cache
def _way_to_pack(kind: Any) -> Callable[["_Packer", Any], object]:
    """How values of a class are packed."""
    ways: tuple[tuple[Any, Callable[[_Packer, Any], object]], ...] = (
        (tuple(_AS_THEY_ARE), lambda _packer, value: value),
        (float, lambda _packer, value: value if isfinite(value) else None),
        (kind if _names_in(kind) else (), _Packer.record),
        ((tuple, list), _Packer.each),
        (np.ndarray, _Packer.array),
        (Said, lambda _packer, value: str(value)),
        (np.generic, lambda packer, value: packer.plain(value.item())),
        (Mapping, _Packer.named),
        (Sequence, _Packer.each),
    )
    for kinds, way in ways:
        if issubclass(kind, kinds):
            return way
    raise TypeError(kind.__name__)


class _Packer:
    """Collects arrays as they come."""

    def __init__(self) -> None:
        self._blocks: list[NDArray[np.float32]] = []
        self._places: dict[bytes, int] = {}
        self._size = 0

    @property
    def numbers(self) -> NDArray[np.float32]:
        """All of them, one behind the other."""
        return np.concatenate(self._blocks) if self._blocks else np.empty(0, np.float32)

    def plain(self, value: object) -> object:
        """Give a value as JSON has it."""
        kind = type(value)
        return value if kind in _AS_THEY_ARE else _way_to_pack(kind)(self, value)

    def each(self, values: Sequence[Any]) -> object:
        """Give each of some values."""
        return [self.plain(one) for one in values]

    def named(self, values: Mapping[object, Any]) -> object:
        """Give values by their names."""
        return {str(name): self.plain(one) for name, one in values.items()}

    def record(self, value: Any) -> object:
        """Give what a record or a named tuple holds."""
        names = _names_in(cast(object, type(value)))
        return {"is": type(value).__name__, **{name: self.plain(getattr(value, name)) for name in names}}

    def array(self, array: NDArray[Any]) -> object:
        """Give numbers their place; truths and whole numbers, of which there are few, stand where they are."""
        if array.dtype.kind != "f":
            return array.tolist()
        block = np.ascontiguousarray(array, np.float32).ravel()
        key = block.tobytes()
        if key not in self._places:
            self._places[key] = self._size
            self._blocks.append(block)
            self._size += block.size
        return {"at": self._places[key], "shape": list(array.shape)}
