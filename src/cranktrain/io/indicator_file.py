"""The file of an indicator diagram beside a machine file: found, decoded, and put into the machine's table."""

import codecs
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import cast

from cranktrain.errors import InputError
from cranktrain.io.files import Wanted, content_of, refusal
from cranktrain.language import _

LARGEST_FILE = 16 * 2**20
"""Bytes; a cycle in steps of 0.1° has some 200 000."""

_WIDE = {codecs.BOM_UTF16_LE: "utf-16", codecs.BOM_UTF16_BE: "utf-16"}


def indicator_text(path: Path, name: str) -> str:
    """Read the file of a diagram.

    Parameters
    ----------
    path : Path
    name : str
        As shown in messages.

    Returns
    -------
    str
        UTF-8 or UTF-16 with a byte-order mark; else Windows-1251, in which ° stands where Western code pages have it.

    Raises
    ------
    InputError
        If there is no such file, it cannot be read, or is no text.
    """
    too_large = _("is larger than {limit} MiB, and no indicator diagram is").format(limit=LARGEST_FILE // 2**20)
    wanted = Wanted(LARGEST_FILE, too_large, _("is a folder, not an indicator diagram"))
    content = content_of(path, name, wanted, suffix=".csv")
    encoding = _WIDE.get(content[:2])
    if encoding is None and b"\0" in content:
        raise refusal(name, _("is no text: it has NUL bytes"), _("save the diagram as CSV"))
    if encoding is not None:
        return content.decode(encoding, errors="replace")
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError:
        return content.decode("cp1251", errors="replace")


def with_indicator(data: Mapping[str, object], folder: Path) -> dict[str, object]:
    """Put what the file of `[gas]` holds into the table, where it names one.

    Parameters
    ----------
    data : mapping
        The tables of a machine file.
    folder : Path
        Where the machine file is: the diagram's path is relative to it.

    Returns
    -------
    dict
        The same, with `gas.text`; unchanged without an indicator diagram, or where the table holds it itself.

    Raises
    ------
    InputError
        If the file cannot be read, with the path `gas.file`.
    """
    gas = data.get("gas")
    if not isinstance(gas, Mapping):
        return dict(data)
    table = cast(Mapping[str, object], gas)
    file = table.get("file")
    if table.get("kind") != "indicator" or not isinstance(file, str) or "text" in table:
        return dict(data)
    try:
        text = indicator_text(folder / file, file)
    except InputError as error:
        raise InputError(
            replace(problem, path="gas.file", given=file, position=None) for problem in error.problems
        ) from None
    return {**data, "gas": {**table, "text": text}}
