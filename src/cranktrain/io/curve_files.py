"""Files of curves that a machine file names, such as indicator diagrams: found, decoded, put into its tables."""

import codecs
from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import TypeAlias, cast

from cranktrain.all_questions import QUESTIONS
from cranktrain.errors import InputError, Problem, problems_as
from cranktrain.io.examples import EXAMPLES_FOLDER
from cranktrain.io.files import content_of, refusal
from cranktrain.language import said as _
from cranktrain.layout.parts import FILES
from cranktrain.layout.question import ANY_NAME, TableFile
from cranktrain.paths import item_at, path_text, replaced

LARGEST_FILE = 16 * 2**20
"""Bytes; a cycle in steps of 0.1° has some 200 000."""

CurveReader: TypeAlias = Callable[[str, str], str]
"""Gives the text of a file by its name, as a table has it, and what it should be, as `TableFile` says it."""

_WIDE = {codecs.BOM_UTF16_LE: "utf-16", codecs.BOM_UTF16_BE: "utf-16"}


def curve_text(path: Path, name: str, noun: str) -> str:
    """Read the file of a curve.

    Parameters
    ----------
    path : Path
    name : str
        As shown in messages.
    noun : str
        What it should be, as `TableFile` says it.

    Returns
    -------
    str
        UTF-8 or UTF-16 with a byte-order mark; else Windows-1251, in which ° stands where Western code pages have it.

    Raises
    ------
    InputError
        If there is no such file, it cannot be read, or is no text.
    """
    if path.exists() and not (path.is_file() or path.is_dir()):  # one would wait for what nobody writes
        raise refusal(name, _("is a pipe or a device, not {noun}", noun=_(noun)), _("save it as a file"))
    content = content_of(
        path,
        name,
        LARGEST_FILE,
        suffix=".csv",
        too_large=_("is larger than {limit} MiB, too large for {noun}", limit=LARGEST_FILE // 2**20, noun=_(noun)),
        folder=_("is a folder, not {noun}", noun=_(noun)),
        says_where=True,
    )
    encoding = _WIDE.get(content[:2])
    if encoding is None and b"\0" in content:
        raise _no_text(name)
    if encoding is not None:
        return content.decode(encoding, errors="replace")
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError:
        return content.decode("cp1251", errors="replace")


def _no_text(name: str) -> InputError:
    return refusal(name, _("is no text: it has NUL bytes"), _("save it as CSV"))


def beside(folder: Path) -> CurveReader:
    """Read files of the disk.

    Parameters
    ----------
    folder : Path
        Where the machine file is: the paths of the others are relative to it. Beside an example are its own files
        alone; others are relative to the working folder.

    Returns
    -------
    callable
    """
    return partial(_of_disk, folder)


def _of_disk(folder: Path, file: str, noun: str) -> str:
    return curve_text(_place_of(file, folder), file, noun)


def among(files: Mapping[str, str]) -> CurveReader:
    """Read what was sent along with the text of a machine file; whatever a name says, the disk is not looked at.

    Parameters
    ----------
    files : mapping of str
        Texts by the names that tables have for them, letter by letter.

    Returns
    -------
    callable
    """
    return partial(_of_those_sent, files)


def _of_those_sent(files: Mapping[str, str], file: str, noun: str) -> str:
    if file not in files:
        raise refusal(file, _("is not among the files that came with the machine"), _("send {noun}", noun=_(noun)))
    if "\0" in files[file]:
        raise _no_text(file)
    return files[file].removeprefix("\ufeff")


def with_curves(data: Mapping[str, object], read: CurveReader) -> tuple[dict[str, object], tuple[Problem, ...]]:
    """Put what the files of curves hold into the tables that name them.

    Parameters
    ----------
    data : mapping
        The tables of a machine file.
    read : callable
        What gives their texts: `beside` a machine file, or `among` those that were sent.

    Returns
    -------
    data : dict
        The same, with `text` beside each `file`; unchanged where no file is named, a table holds its text itself, or
        the file cannot be read.
    problems : tuple of Problem
        Of the files that cannot be read, each with the path of its `file`.
    """
    found: list[Problem] = []
    filled = dict(data)
    asked = map(QUESTIONS.named, QUESTIONS.by(data))
    each = (*(file for question in asked for file in question.files), *FILES)
    for curve in (one for one in each if one.table[0] in data):
        for path in _paths(data, curve):
            try:
                filled = _filled(filled, path, curve, read)
            except InputError as error:
                found += error.problems
    return filled, tuple(found)


def _paths(data: Mapping[str, object], curve: TableFile) -> Iterator[tuple[str, ...]]:
    """Where such tables may stand: at their path, or, of those told by their kind, below it by name."""
    if ANY_NAME in curve.table:
        yield from _named(data, curve.table)
        return
    yield curve.table
    table = item_at(data, curve.table)
    if curve.kind is not None and isinstance(table, Mapping) and "kind" not in table:
        yield from ((*curve.table, name) for name in cast("Mapping[str, object]", table))


def _named(data: object, table: tuple[str, ...]) -> Iterator[tuple[str, ...]]:
    """Tables of a path in which any name may stand."""
    if not table:
        yield ()
    elif isinstance(data, Mapping):
        found = cast("Mapping[str, object]", data)
        names = found if table[0] == ANY_NAME else {table[0]} & found.keys()
        yield from ((name, *rest) for name in names for rest in _named(found[name], table[1:]))


def _filled(data: dict[str, object], parts: tuple[str, ...], curve: TableFile, read: CurveReader) -> dict[str, object]:
    """Put the text of one file into its table."""
    found = item_at(data, parts)
    table = cast("Mapping[str, object]", found if isinstance(found, Mapping) else {})
    file = table.get("file")
    if not isinstance(file, str) or table.get("kind") != curve.kind or table.get("text") is not None:
        return data
    with problems_as(lambda problem: replace(problem, path=f"{path_text(parts)}.file", given=file, position=None)):
        text = read(file, curve.noun)
    return cast("dict[str, object]", replaced(data, (*parts, "text"), text))


def _place_of(file: str, folder: Path) -> Path:
    """Where a file is that a table names."""
    there = folder / file
    return Path(file) if folder == EXAMPLES_FOLDER and not _is_there(there) else there


def _is_there(path: Path) -> bool:
    """Whether there is a file; of a name that no file can have none."""
    try:
        return path.exists()
    except ValueError:
        return False
