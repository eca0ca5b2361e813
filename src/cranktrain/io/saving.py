"""A machine as a file again: the text that it was read from with what was changed, comments and layout as they were."""

import os
import tomllib
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from itertools import takewhile
from pathlib import Path
from typing import Any, cast

from cranktrain.errors import InputError
from cranktrain.io.added_tables import commented_out, toml_text, with_values
from cranktrain.io.output import write_machine_file
from cranktrain.machine import Machine
from cranktrain.paths import PathParts, is_table, path_text
from cranktrain.quantities import Given
from cranktrain.spec import Spec


def save_machine(machine: Machine, path: "str | os.PathLike[str]", *, force: bool = False) -> None:
    """Write a machine file, as `Machine.save` does."""
    name = os.fspath(path)
    write_machine_file(name, machine_text(machine, Path(name).parent), force=force)


def machine_text(machine: Machine, folder: Path) -> str:
    """Give the text of a machine file.

    Parameters
    ----------
    machine : Machine
    folder : Path
        Where the file will be: files that the tables name are found from there.

    Returns
    -------
    str
        That of the file of which the machine was read, if it was: a value that is another is put in its place, one that
        is new is added, and what is gone goes behind comment marks. Where that would not be read as the same tables in
        the same order, as one that was taken away has others in it, all is written anew, below the file's first lines.
    """
    file = machine.typed_in
    typed, plain = file.data, plain_tables(machine.declared)
    declared = _with_files(plain, typed, file.folder.absolute(), folder.absolute())
    with suppress(InputError, ValueError):  # of changes that cannot be made in the text, or leave none that is TOML
        changed = _written(commented_out(file.text, _gone(typed, declared)), _changed(typed, declared))
        if _is_same(tomllib.loads(changed), declared):
            return changed
    head = "".join(takewhile(lambda line: line.startswith("#"), file.text.splitlines(keepends=True)))
    return _written(head, _changed({}, declared))


def _written(text: str, values: Iterable[tuple[PathParts, Any]]) -> str:
    """Put values into a text."""
    return with_values(text, {path_text(path): toml_text(value) for path, value in values})


def _is_same(one: Any, other: Any) -> bool:
    """Whether tables are the same, those that stand by name in the same order."""
    if not (is_table(one) and is_table(other)):
        return bool(type(one) is type(other) and one == other)
    named = [[key for key, item in table.items() if is_table(item)] for table in (one, other)]
    return one.keys() == other.keys() and named[0] == named[1] and all(_is_same(one[key], other[key]) for key in one)


def plain_tables(value: object) -> Any:
    """Give what was declared as TOML reads it: tables, lists, texts, numbers."""
    if isinstance(value, Given):
        about = {name: getattr(value, name) for name in ("status", "note", "source")}
        said = {name: text for name, text in about.items() if text is not None}
        return {"value": value.text, **said} if said else value.text
    if isinstance(value, Spec):
        fields = type(value).model_fields
        own: dict[str, Any] = {fields[name].alias or name: getattr(value, name) for name in value.model_fields_set}
        others: Mapping[str, Any] = {} if value.others is None else own.pop(value.others, {})
        return plain_tables({**own, **others})
    if isinstance(value, Mapping):
        return {key: plain_tables(item) for key, item in cast("Mapping[str, object]", value).items()}
    if isinstance(value, list | tuple):
        return [plain_tables(item) for item in cast("Sequence[object]", value)]
    return float(value) if isinstance(value, float) else value  # NumPy's numbers too


def _with_files(declared: Mapping[str, Any], typed: Mapping[str, Any], old: Path, new: Path) -> dict[str, Any]:
    """Name files as they are found from another folder, and leave out what was read from them; not what was typed."""
    found: dict[str, Any] = {}
    is_read, is_moved = "file" in typed and "text" not in typed, old != new
    for key, value in declared.items():
        if isinstance(value, dict):
            of_table = typed.get(key)
            found[key] = _with_files(cast("dict[str, Any]", value), of_table if is_table(of_table) else {}, old, new)
        elif not is_read or key != "text":
            is_name = is_read and is_moved and key == "file"
            found[key] = Path(os.path.relpath(old / value, new)).as_posix() if is_name else value
    return found


def _changed(
    typed: Mapping[str, Any], declared: Mapping[str, Any], above: PathParts = ()
) -> Iterator[tuple[PathParts, Any]]:
    """Values that are new, or others than were typed, by their paths."""
    for key, value in declared.items():
        old = typed.get(key)
        if is_table(value) and value:
            yield from _changed(old if is_table(old) else {}, value, (*above, key))
        elif old != value:
            yield (*above, key), value


def _gone(typed: Mapping[str, Any], declared: Mapping[str, Any], above: PathParts = ()) -> Iterator[PathParts]:
    """Paths of what was typed and is not there any more, or is no table, or no list of tables, any more."""
    for key, old in typed.items():
        path, value = (*above, key), declared.get(key)
        if is_table(old) and is_table(value):
            yield from _gone(old, value, path)
        elif key not in declared or is_table(old):
            yield path
        elif isinstance(old, list) and old != value and any(map(is_table, cast("list[object]", old))):
            yield from ((*path, place) for place in range(len(cast("list[object]", old))))
