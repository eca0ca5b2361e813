"""The text of a machine file with more tables of a list in it, and with some of what it has behind comment marks."""

from collections.abc import Iterable, Mapping, Sequence
from typing import cast

from cranktrain.io.document import Document
from cranktrain.io.editing import with_value
from cranktrain.io.text_spans import TextSpan, TextSpans, places
from cranktrain.mechanisms.by_hand import AddedTable
from cranktrain.paths import PathParts, path_text, quantity_path, quoted


def with_tables(text: str, path: str, tables: Sequence[Mapping[str, str]], taken_out: Sequence[str] = ()) -> str:
    """Give a text with more tables in a list, and all else as it was.

    Parameters
    ----------
    text : str
        A TOML text that can be read.
    path : str
        Of the list: `balance.weight`.
    tables : sequence of mapping of str to str
        Keys of each table, with their values as TOML.
    taken_out : sequence of str
        Paths of keys and of items of that list that are to stand behind comment marks.

    Returns
    -------
    str
    """
    source = _without(text.encode(), quantity_path(path), [quantity_path(one) for one in taken_out])
    if not tables:
        return source.decode()
    found = places(source)
    place = found.deepest(quantity_path(path))
    if place.is_value:
        inline = ["{ " + ", ".join(f"{key} = {value}" for key, value in table.items()) + " }" for table in tables]
        if place.kind == "list":
            kept = [item.decode() for item in _items(source, found.by_path, place)]
            return with_value(source, path, "[\n    " + ",\n    ".join([*kept, *inline]) + ",\n]").decode()
        return with_value(source, path, "[" + ", ".join(inline) + "]").decode()
    newline = "\r\n" if b"\r\n" in source else "\n"
    lines = [
        line for table in tables for line in ("", f"[[{path}]]", *(f"{key} = {value}" for key, value in table.items()))
    ]
    end = _end_of_items(source, found, place)
    before, behind = source[:end].decode(), source[end:].decode()
    line_end = "" if before.endswith("\n") else newline
    gap = newline if behind.partition("\n")[0].strip() else ""
    return before + line_end + newline.join(lines) + newline + gap + behind


def with_part(text: str, home: str, added: AddedTable) -> str:
    """Give a text with a part that is added to a mechanism, and all else as it was.

    Parameters
    ----------
    text : str
        A TOML text that can be read.
    home : str
        Path of the mechanism's table.
    added : AddedTable

    Returns
    -------
    str
    """
    path, keys = f"{home}.{added.path}", {key: toml_text(value) for key, value in added.keys.items()}
    if added.is_item:
        return with_tables(text, path, [keys])
    return with_values(text, {f"{path}.{key}": value for key, value in keys.items()})


def with_values(text: str, values: Mapping[str, str], whole: Sequence[str] = ()) -> str:
    r"""Give a text with other values, and all else as it was.

    Parameters
    ----------
    text : str
        A TOML text that can be read.
    values : mapping of str to str
        TOML by path.
    whole : sequence of str
        Paths of tables of which nothing else is to stand: their other keys go behind comment marks.

    Returns
    -------
    str

    Examples
    --------
    >>> print(with_values('[motor]\nkind = "table"\nspeed = 3', {"motor.kind": '"cage"'}, ["motor"]))
    [motor]
    kind = "cage"
    # speed = 3
    """
    source = text.encode()
    for path in whole:
        source = _with_table(source, path, {key: value for key, value in values.items() if key.startswith(f"{path}.")})
    for path, value in values.items():
        source = with_value(source, path, value)
    return source.decode()


def toml_text(value: object) -> str:
    """Write a value as TOML has it in a line."""
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, str):
        return quoted(Document.from_text(value, "save").text)
    if isinstance(value, Mapping):
        pairs = (
            f"{path_text((key,))} = {toml_text(item)}" for key, item in cast("Mapping[str, object]", value).items()
        )
        return "{ " + ", ".join(pairs) + " }"
    if isinstance(value, list):
        return f"[{', '.join(map(toml_text, cast('list[object]', value)))}]"
    return repr(value)


def commented_out(text: str, paths: Iterable[PathParts]) -> str:
    """Give a text with some keys and tables behind comment marks."""
    return _without(text.encode(), (), paths).decode()


def _with_table(source: bytes, path: str, values: Mapping[str, str]) -> bytes:
    """Give the text with nothing of a table but some of its keys."""
    parts = quantity_path(path)
    spans = places(source).by_path
    if parts in spans and spans[parts].kind == "inline":
        inline = ", ".join(f"{key.removeprefix(f'{path}.')} = {value}" for key, value in values.items())
        return with_value(source, path, f"{{ {inline} }}")
    kept = {quantity_path(key) for key in values}
    others = [one for one in spans if len(one) == len(parts) + 1 and one[:-1] == parts and one not in kept]
    return _without(source, (), others)


def _end_of_items(source: bytes, found: TextSpans, place: TextSpan) -> int:
    """Where the last line of a list of tables with heads ends, all of its last table in it; else the text."""
    if place.kind != "sections":
        return len(source)
    last = (*place.path, place.n_items - 1)
    own = (span for path, span in found.by_path.items() if path[: len(last)] == last)
    line = source.find(b"\n", max(max(span.tail, span.end) for span in own))
    return line + 1 if line >= 0 else len(source)


def _items(source: bytes, by_path: Mapping[PathParts, TextSpan], place: TextSpan) -> list[bytes]:
    """The items of an inline list as they are written."""
    items = [by_path[*place.path, number] for number in range(place.n_items)]
    return [source[item.start : item.end] for item in items]


def _without(source: bytes, path: PathParts, taken_out: Iterable[PathParts]) -> bytes:
    """Give the text with some keys and sections behind comment marks; items of a list in one line leave it."""
    spans = places(source).by_path
    wanted = [one for one in taken_out if one in spans]
    items = {one[-1] for one in wanted if one[:-1] == path and spans[one].kind == "inline"}
    for one in sorted(wanted, key=lambda parts: -spans[parts].start):
        span = spans[one]
        if span.kind == "section":
            source = _commented(source, span.start, max(span.tail, span.end))
        elif one[:-1] != path:
            source = _commented(source, span.key, span.end)
    if items:
        place = places(source).by_path[path]
        kept = [item for n, item in enumerate(_items(source, places(source).by_path, place)) if n not in items]
        written = b"[" + b", ".join(kept) + b"]"
        return (
            with_value(source, path_text(path), written.decode()) if kept else _commented(source, place.key, place.end)
        )
    return source


def _commented(source: bytes, start: int, end: int) -> bytes:
    """Put the lines from one place to another behind comment marks."""
    first = source.rfind(b"\n", 0, start) + 1
    last = source.find(b"\n", end)
    last = len(source) if last < 0 else last
    lines = source[first:last].split(b"\n")
    return source[:first] + b"\n".join(b"# " + line if line.strip() else line for line in lines) + source[last:]
