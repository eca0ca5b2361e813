"""Dotted paths of a machine file, as `bank.R.mechanism.rod_length`, and what stands at them in its data."""

import json
import re
import tomllib
from collections.abc import Iterable, Mapping, Sequence
from functools import lru_cache
from typing import Any, TypeAlias, TypeGuard, cast

from cranktrain.errors import InputError, Problem, refuse
from cranktrain.language import Words, _

PathParts: TypeAlias = tuple[str | int, ...]

DEEPEST_NESTING = 32
"""Tables and lists in one another; a machine needs six. Bounds the recursion of all that walks the data."""

_PATH_PART = re.compile(
    r"""\s* (?: (?P<quoted> "(?:[^"\\]|\\.)*" | '[^']*' ) | (?P<bare> (?: WORD (?: [^\S\x00-\x1f]+ WORD )* )? ) )
        \s* (?P<indices> (?: \[ \s* [0-9]{1,9} \s* \] \s* )* ) (?P<end> \. | $ )""".replace(
        "WORD", r"""[^\s.\[\]"'=\x00-\x1f]+"""
    ),
    re.VERBOSE,
)
_BARE_KEY = re.compile(r"[A-Za-z0-9_-]+")

_MOST_PATHS = 4096
"""That are kept as they are written: of a machine whose numbers are set anew all stay."""


def quantity_path(path: str) -> PathParts:
    """Split a dotted path into names and list places.

    Parameters
    ----------
    path : str
        E.g. `bank.R.mechanism.rod_length`, `shaft.main.throws[2]` (places count from 0), `cylinder."1.exhaust".bore`.

    Returns
    -------
    tuple of str and int

    Raises
    ------
    InputError
        If it is no such path.

    Examples
    --------
    >>> quantity_path('mechanism.part[1]."rod 2".length')
    ('mechanism', 'part', 1, 'rod 2', 'length')
    """
    parts: list[str | int] = []
    start, more, is_text = 0, True, isinstance(cast("object", path), str)  # Python's users may write anything
    while more and len(parts) <= DEEPEST_NESTING:
        found = _PATH_PART.match(path, start) if is_text else None
        name = found and (found["bare"] or unquoted(found["quoted"] or ""))
        if not found or name is None:
            allowed = _("is no path of a machine file: names with dots between, [0], [1], … for the items of a list")
            repair = _('write like bank.R.mechanism.rod_length or shaft.main.throws[2]; other names in quotes: "1.a"')
            raise InputError([Problem("", path if is_text else repr(path), allowed, repair)])
        parts += [name, *(int(place) for place in re.findall("[0-9]+", found["indices"]))]
        start, more = found.end(), found["end"] == "."
    if len(parts) > DEEPEST_NESTING:
        raise InputError([Problem("", path, too_many_parts())])
    return tuple(parts)


def parts_of(path: str) -> PathParts:
    """Split a path as `quantity_path` does; nothing of one that is none, as a key that no path can name."""
    try:
        return quantity_path(path) if path else ()
    except InputError:
        return ()


def too_many_parts() -> Words:
    """Say that a path leads deeper than any machine's."""
    return _("has more than {limit} parts with dots between", limit=DEEPEST_NESTING)


def unquoted(key: str) -> str | None:
    """Read a quoted key as TOML does, or None if it cannot be read."""
    try:
        return tomllib.loads(f"key = {key}")["key"]
    except tomllib.TOMLDecodeError:
        return None


def path_text(parts: Iterable[str | int]) -> str:
    """Write names and list places as a dotted path, quoting where TOML needs it; undoes `quantity_path`.

    Examples
    --------
    >>> path_text(("mechanism", "part", 1, "rod 2", "length"))
    'mechanism.part[1]."rod 2".length'
    """
    return _path_text(tuple(parts))


@lru_cache(_MOST_PATHS)
def _path_text(parts: PathParts) -> str:
    """Write it."""
    return "".join(
        f"[{part}]" if isinstance(part, int) else f".{part if _BARE_KEY.fullmatch(part) else quoted(part)}"
        for part in parts
    ).removeprefix(".")


def quoted(text: str) -> str:
    """Write text as a TOML basic string; JSON's escapes are TOML's, but for DEL."""
    return json.dumps(text, ensure_ascii=False).replace("\x7f", "\\u007f")


def is_table(value: object) -> TypeGuard[Mapping[str, Any]]:
    """Whether a value of a machine file is a table of keys, and no number that says where it is from."""
    return isinstance(value, Mapping) and "value" not in value


def value_at(data: object, path: str) -> object:
    """What stands at a path of some data; None where nothing does, or where it is no path."""
    try:
        return item_at(data, quantity_path(path) if path else ())
    except InputError:
        return None


def item_at(data: object, parts: PathParts) -> object:
    """What stands in some data at a path that is split already; None where nothing does."""
    for part in parts:
        if isinstance(data, Mapping):
            data = cast("Mapping[object, object]", data).get(part)
        elif isinstance(data, list | tuple):
            items = cast("Sequence[object]", data)
            data = items[part] if isinstance(part, int) and part < len(items) else None
        else:
            data = getattr(data, part, None) if isinstance(part, str) else None
    return data


def replaced(data: object, parts: PathParts, value: object, *, above: PathParts = ()) -> object:
    """Give data with another value at a path; a table that is not there is made, all that is elsewhere is shared.

    Parameters
    ----------
    data : mapping, list or tuple
    parts : tuple of str and int
        As `quantity_path` gives them; not empty.
    value : object
    above : tuple of str and int
        Path of the data themselves, for what is said of them.

    Returns
    -------
    dict or tuple

    Raises
    ------
    InputError
        If the path leads through what is no table or list, or to an item that a list does not have.
    """
    part, *rest = parts

    def inner(old: object) -> object:
        return replaced(old, tuple(rest), value, above=(*above, part)) if rest else value

    if isinstance(data, Mapping) and isinstance(part, str):
        table = cast("Mapping[str, object]", data)
        return {**table, part: inner(table.get(part, {}))}
    if isinstance(data, list | tuple) and isinstance(part, int):
        items = cast("Sequence[object]", data)
        if part < len(items):
            return (*items[:part], inner(items[part]), *items[part + 1 :])
    said = _no_way(cast("object", data), path_text(above))
    raise InputError([Problem(path_text((*above, *parts)), None, said)])


def values_by_path(path: str, values: object, call: str) -> dict[str, object]:
    """Take values by path; refuse what is none, with how they are written: the call, with `{}` for them."""
    if not isinstance(values, Mapping):
        repair = _("write {example}", example=call.format('{"mechanism.rod_length": "140 mm"}'))
        raise InputError([Problem(path, str(values), _("must be a mapping of paths to values"), repair)])
    return dict(cast("Mapping[str, object]", values))


def with_values(data: object, values: Mapping[str, object]) -> tuple[Any, tuple[PathParts, ...]]:
    """Give data with other values at some paths.

    Parameters
    ----------
    data : mapping
        The tables of a machine; unchanged.
    values : mapping of str
        By path, as `quantity_path` reads it. Where it is a `file`, the `text` that was read from the old one goes.

    Returns
    -------
    data : dict
    paths : tuple of tuple of str and int
        Where the values stand.

    Raises
    ------
    InputError
        With every path that leads nowhere, and what is set twice.
    """
    found: list[Problem] = []
    done: list[PathParts] = []
    for path, value in values.items():
        try:
            parts = quantity_path(path)
            if any(parts[: len(other)] == other[: len(parts)] for other in done):
                found.append(Problem(path, None, _("is set twice; keep one of the two")))
            done.append(parts)
            data = replaced(data, parts, value)
            if parts[-1] == "file":
                data = replaced(data, (*parts[:-1], "text"), None)
        except InputError as error:
            found += error.problems
    refuse(found)
    return data, tuple(done)


def _no_way(data: object, here: str) -> Words:
    """Say why a path does not go on."""
    if isinstance(data, Mapping):
        return _("{path} is a table, whose keys are names", path=here)
    if isinstance(data, list | tuple):
        n_items = len(cast("Sequence[object]", data))
        return _("{path} is a list of {n}, whose items are [0], [1], …", path=here, n=n_items)
    return _("{path} is no table or list; set it whole", path=here)
