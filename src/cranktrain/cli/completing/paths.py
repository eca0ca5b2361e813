"""Paths of `--set`: those that a machine file has, and the keys that its tables could have."""

import re
import tomllib
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any, cast

from cranktrain.cli.completing.names import EXAMPLES_FOLDER, names
from cranktrain.paths import is_table

_LARGEST = 2**20
_BARE = re.compile(r"[A-Za-z0-9_-]+")


def setting_paths(file: str | None) -> list[str]:
    """Give paths that a machine file has or could have; without a file, those of any."""
    data = {} if file is None else _data(file)
    found = [*_of_values(data, ()), *_of_keys(data)]
    return list(dict.fromkeys(path for path in found if path))


def _data(file: str) -> dict[str, Any]:
    """Read a machine file or example; nothing of what cannot be read."""
    name = file.casefold().replace("-", "_")
    for path in (Path(file), EXAMPLES_FOLDER / f"{name}.toml"):
        try:
            if path.is_file() and path.stat().st_size <= _LARGEST:
                return tomllib.loads(path.read_text(encoding="utf-8-sig"))
        except (OSError, ValueError):
            continue
    return {}


def _of_values(data: object, parts: tuple[str, ...]) -> Iterator[str]:
    """Give the paths of what stands in a table: numbers, texts and lists, and quantities with their status."""
    if is_table(data):
        for key, value in data.items():
            if _BARE.fullmatch(key):
                yield from _of_values(value, (*parts, key))
    else:
        yield ".".join(parts)


def _of_keys(data: Mapping[str, Any]) -> Iterator[str]:
    """Give the paths of keys that tables could have: of tables by names, and by kinds, those that the file has."""
    for pattern, keys in names()["keys"].items():
        for home in _homes(data, (), pattern.split(".") if pattern else []):
            yield from (".".join((*home, key)) for key in keys)


def _homes(data: object, above: tuple[str, ...], pattern: list[str]) -> Iterator[tuple[str, ...]]:
    """Find the tables that a pattern means: `*` any name that the file has, `:word` of the kind that the file has."""
    if not pattern:
        yield above
        return
    part, *rest = pattern
    table = cast("Mapping[str, object]", data if isinstance(data, Mapping) else {})
    if part.startswith(":"):
        if table.get("kind") == part[1:]:
            yield from _homes(table, above, rest)
    elif part == "*":
        for name, value in table.items():
            if isinstance(value, Mapping) and _BARE.fullmatch(name):
                yield from _homes(cast("object", value), (*above, name), rest)
    else:
        yield from _homes(table.get(part), (*above, part), rest)
