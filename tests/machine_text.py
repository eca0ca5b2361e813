"""A machine file from its tables."""

from collections.abc import Iterator


def toml(tables: dict) -> str:
    """Tables as a machine file."""
    return "\n".join(_lines(tables, ())) + "\n"


def _lines(table: dict, path: tuple[str, ...]) -> Iterator[str]:
    if path:
        yield f"[{'.'.join(path)}]"
    inner = {}
    for key, value in table.items():
        if isinstance(value, dict):
            inner[key] = value
        else:
            yield f"{key} = {_value(value)}"
    for key, value in inner.items():
        yield from _lines(value, (*path, key))


def _value(value) -> str:
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, str):
        return f'"{value}"'
    if isinstance(value, list):
        return f"[{', '.join(map(_value, value))}]"
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{key} = {_value(one)}" for key, one in value.items()) + " }"
    return repr(value)
