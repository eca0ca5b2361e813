"""The text of a machine file with more tables of a list in it, and with some of what it has behind comment marks."""

from collections.abc import Iterable, Mapping, Sequence

from cranktrain.io.editing import with_value
from cranktrain.io.text_spans import VALUES, TextSpan, places
from cranktrain.paths import PathParts, path_text, quantity_path


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
    if place.kind in VALUES:
        inline = ["{ " + ", ".join(f"{key} = {value}" for key, value in table.items()) + " }" for table in tables]
        if place.kind == "list":
            kept = [item.decode() for item in _items(source, found.by_path, place)]
            return with_value(source, path, "[\n    " + ",\n    ".join([*kept, *inline]) + ",\n]").decode()
        return with_value(source, path, "[" + ", ".join(inline) + "]").decode()
    newline = "\r\n" if b"\r\n" in source else "\n"
    lines = [
        line for table in tables for line in ("", f"[[{path}]]", *(f"{key} = {value}" for key, value in table.items()))
    ]
    before = source.decode()
    end = "" if before.endswith("\n") else newline
    return before + end + newline.join(lines) + newline


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
