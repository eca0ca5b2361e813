"""Write the types of what a page is given, as TypeScript has them, out of the records that say it: src/data.ts."""

import sys
from collections.abc import Mapping, Sequence
from dataclasses import fields, is_dataclass
from pathlib import Path
from types import NoneType, UnionType
from typing import Any, Literal, Union, get_args, get_origin, get_type_hints

import numpy as np

from cranktrain.language import Said
from cranktrain.web.case import PageCase, PageHandles
from cranktrain.web.gallery import Gallery
from cranktrain.web.going_on import PageGoingOn
from cranktrain.web.sweeping import SweptDesignsOfPage
from cranktrain.web.whence import PageWhence

HEAD = """// What a page is given. Written by write_types.py out of the records of cranktrain.web; do not edit.

/** A number; null where there is none. */
export type Float = number | null;

/** Numbers row by row, with how many there are along each dimension. */
export interface Numbers {
  readonly values: Float32Array;
  readonly shape: readonly number[];
}
"""


class Types:
    """Collects interfaces as they are met."""

    def __init__(self) -> None:
        self.written: dict[str, str] = {}

    def name(self, hint: Any) -> str:
        """Name a type as TypeScript does."""
        simple = {str: "string", float: "Float", int: "number", bool: "boolean", NoneType: "null", object: "unknown"}
        if hint in simple:
            return simple[hint]
        origin, arguments = get_origin(hint), get_args(hint)
        if origin is Literal:
            return " | ".join(f'"{one}"' for one in arguments)
        if origin in (Union, UnionType):
            return " | ".join(dict.fromkeys(self.name(one) for one in arguments))
        if origin is tuple and arguments[-1] is not Ellipsis:
            return f"readonly [{', '.join(map(self.name, arguments))}]"
        if origin is np.ndarray:
            (kind,) = get_args(arguments[1])
            return {"f": "Numbers", "b": "readonly boolean[]", "i": "readonly number[]"}[np.dtype(kind).kind]
        if isinstance(origin, type) and issubclass(origin, Mapping):
            return f"Readonly<Record<string, {self.name(arguments[1])}>>"
        if isinstance(origin, type) and issubclass(origin, Sequence):
            return f"readonly ({self.name(arguments[0])})[]"
        if isinstance(hint, type) and issubclass(hint, Said):
            return "string"
        return self.interface(hint)

    def interface(self, kind: type) -> str:
        """Write a record, and give its name."""
        if kind.__name__ not in self.written:
            self.written[kind.__name__] = ""  # it may hold others of its kind
            hints = get_type_hints(kind)
            names = [field.name for field in fields(kind)] if is_dataclass(kind) else list(hints)
            own = "".join(f"  readonly {name}: {self.name(hints[name])};\n" for name in names)
            self.written[kind.__name__] = (
                f'export interface {kind.__name__} {{\n  readonly is: "{kind.__name__}";\n{own}}}\n'
            )
        return kind.__name__


def types_text() -> str:
    """Give all of them."""
    types = Types()
    for kind in (PageCase, PageHandles, PageGoingOn, Gallery, SweptDesignsOfPage, PageWhence):
        types.interface(kind)
    return "\n".join([HEAD, *types.written.values()])


if __name__ == "__main__":
    sys.exit(not Path(__file__).with_name("src").joinpath("data.ts").write_text(types_text(), encoding="utf-8"))
