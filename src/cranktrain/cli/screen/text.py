"""The screen: its width and colours, headings, paragraphs, tables without lines."""

import re
import sys
import textwrap
from collections.abc import Container, Generator, Iterable, Iterator, Sequence
from contextlib import contextmanager
from itertools import dropwhile, zip_longest
from typing import Any

from rich.cells import cell_len
from rich.console import Console
from rich.text import Text

from cranktrain.language import said as _
from cranktrain.one_line import visible
from cranktrain.saying.typesetting import KEPT, as_printed

INDENT = 2
"""Of what stands under a heading."""

GAP = 2
"""Between columns."""

_WIDTH = 80
"""Where there is no terminal."""

_COMMAND = re.compile(r"`cranktrain [^`]*`")
_WORD = re.compile(r"(?:--set )?(?:'[^']*'|\"[^\"]*\"|[^\s'\"])+")
"""Of a command: what stands between blanks outside of quotes, a setting with its option."""

_PIECE = re.compile(r"[^\s._]+[._]*|[._]+")
"""Of a cell that is folded: a word, or what of it ends in a dot or an underline."""

_LEAST_FOLDED, _NARROWEST = 9, 6
"""A cell that is narrower than the first makes gaps narrow; than the second it is not, however narrow the screen."""


@contextmanager
def page(head: str = "") -> Generator[Console]:
    """Collect a page for the standard output below its head, if any, and show it without blanks at line ends.

    Without a head it begins with its first line that is not empty.
    """
    console = _screen()
    with console.capture() as shown:
        if head:
            console.print(Text(head, style="bold"))
        yield console
    lines = shown.get().splitlines()
    sys.stdout.writelines(
        f"{line.rstrip()}\n".replace(KEPT, " ") for line in (lines if head else dropwhile(lambda line: not line, lines))
    )


def show_lines(console: Console, lines: Iterable[Text]) -> None:
    """Show lines that are laid out."""
    for line in lines:
        console.print(line, soft_wrap=True)


def _screen() -> Console:
    """Give a console for the standard output: as wide as a terminal is, else of 80 columns and without colour."""
    options: dict[str, Any] = {"highlight": False, "markup": False, "emoji": False}
    if not sys.stdout.isatty():
        options |= {"width": _WIDTH, "height": _WIDTH, "color_system": None, "force_terminal": False}
    return Console(**options)


def heading_lines(heading: str, width: int) -> list[Text]:
    """Lay out a heading after an empty line; nothing without one."""
    said = as_printed(visible(heading))
    lines = textwrap.wrap(said, width, break_on_hyphens=False, break_long_words=False)
    return [Text(), *(Text(line, "bold") for line in lines)] if heading else []


def paragraph(text: str, width: int, style: str = "") -> list[Text]:
    """Fold a text to a width; an empty one is an empty line.

    A command in it stays in one line, or is folded as a shell takes it.
    """
    whole = _COMMAND.sub(lambda found: found[0].replace(" ", KEPT), as_printed(visible(text)))
    lines = textwrap.wrap(whole, width, break_on_hyphens=False, break_long_words=False)
    return [Text(part, style) for line in lines for part in _in_width(line, width)] or [Text()]


def _in_width(line: str, width: int) -> list[str]:
    """Fold a line that is one long word: a command between its words, with a backslash; any other anywhere."""
    if cell_len(line) <= width:
        return [line]
    if KEPT not in line:
        return textwrap.wrap(line, width)
    return command_lines(line.replace(KEPT, " "), width)


def command_lines(command: str, width: int) -> list[str]:
    r"""Fold a command between its words as a shell takes it; what stands in quotes is one word.

    Examples
    --------
    >>> command_lines("`cranktrain run a --set 'x=2 mm'`", 20)
    ['`cranktrain run a \\', "    --set 'x=2 mm'`"]
    """
    words = _WORD.findall(command)
    lines = [words[0]]
    for word, after in zip_longest(words[1:], words[2:]):
        if cell_len(f"{lines[-1]} {word}") <= width - (2 if after else 0):
            lines[-1] += f" {word}"
        else:
            lines[-1] += " \\"
            lines.append(f"    {word}")
    return lines


def folded(
    text: str, width: int, begin: str = "", indent: str = "", *, at_hyphens: bool = False, at_most: int | None = None
) -> list[str]:
    """Fold a text to a width between its words.

    Parameters
    ----------
    text : str
    width : int
    begin, indent : str
        What stands before the first line, and before the others.
    at_hyphens : bool
        Whether it may be folded after hyphens, too.
    at_most : int, optional
        So many lines, the last of which says that there is more; all unless given.

    Returns
    -------
    list of str
    """
    lines = _Wrapper(
        width,
        initial_indent=begin,
        subsequent_indent=indent,
        break_on_hyphens=at_hyphens,
        break_long_words=False,
        max_lines=at_most,
        placeholder=_(" … (--full)"),
    ).wrap(text)
    return [line.replace(KEPT, " ") for line in lines]


class _Wrapper(textwrap.TextWrapper):
    """Folds after any hyphen, where it may: Python's own has letters on both sides, and a firing order has not."""

    wordsep_re = re.compile(r"([ \t\n]+|[^ \t\n-]+-(?=[^ \t\n]))")


def table(
    heads: Sequence[str], rows: Sequence[Sequence[str]], *, right: Container[int] = (), fold: int | None = None
) -> list[Text]:
    """Lay out a table without lines.

    Parameters
    ----------
    heads : sequence of str
        All empty for none.
    rows : sequence of sequences of str
    right : container of int
        Columns whose cells stand to the right.
    fold : int, optional
        Width to which the last column is folded so that the table keeps it, with narrower gaps where there is little
        room; unlimited unless given.

    Returns
    -------
    list of Text
        Its lines.
    """
    # Rich's own table takes thirty times as long, a tenth of the time in which `run` answers, and folds elsewhere.
    has_heads = any(heads)
    every = [[as_printed(visible(cell)) for cell in row] for row in ([heads, *rows] if has_heads else rows)]
    widths = [max((cell_len(row[i]) for row in every), default=0) for i in range(len(heads))]
    gap = GAP
    if fold is not None:
        pieces = (cell_len(piece) for row in every for piece in _PIECE.findall(row[-1]))
        least = max(pieces, default=0)
        gap = GAP if fold - _width(widths[:-1], GAP) >= min(widths[-1], max(_LEAST_FOLDED, least)) else 1
        widths[-1] = max(1, min(widths[-1], max(_NARROWEST, fold - _width(widths[:-1], gap))))
    lines: list[Text] = []
    for number, row in enumerate(every):
        *cells, last = row
        folded = list(_folded(last, widths[-1])) if fold is not None else [last]
        style = "dim" if has_heads and number == 0 else ""
        for i, part in enumerate(folded or [""]):
            texts = [*(cells if i == 0 else [""] * len(cells)), part]
            lines.append(
                Text((" " * gap).join(_cell(text, widths[k], k in right) for k, text in enumerate(texts)), style)
            )
    return lines


def _folded(text: str, width: int) -> Iterator[str]:
    """Fold a text to a width; a word that is longer, as `1A.exhaust.main_bearing`, after a dot or underline in it."""
    for line in textwrap.wrap(text, width, break_long_words=False) or [""]:
        parts = [""]
        for piece in _PIECE.findall(line) if len(line) > width else [line]:
            if parts[-1] and len(parts[-1] + piece) > width:
                parts.append("")
            parts[-1] += piece
        yield from (cut for part in parts for cut in textwrap.wrap(part, width) or [""])


def _width(columns: Sequence[int], gap: int) -> int:
    """Columns of the screen that these take with a gap after each."""
    return sum(columns) + gap * len(columns)


def _cell(text: str, width: int, is_right: bool) -> str:
    """Pad a cell to the width of its column."""
    blank = " " * (width - cell_len(text))
    return blank + text if is_right else text + blank
