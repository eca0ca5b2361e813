"""The screen: its width and colours, headings, tables without boxes."""

import sys
from collections.abc import Iterable, Sequence

from rich.console import Console, RenderableType
from rich.padding import Padding
from rich.table import Table
from rich.text import Text

_WIDTH = 80
"""Where there is no terminal."""


def screen() -> Console:
    """Give the standard output as it is now: a terminal as wide as it is, anything else 80 columns without colour."""
    if sys.stdout.isatty():
        return Console(highlight=False, markup=False, emoji=False)
    return Console(
        highlight=False, markup=False, emoji=False, width=_WIDTH, height=_WIDTH, color_system=None, force_terminal=False
    )


def plain(text: str) -> str:
    """Write a text of the user's in one line, without what would upset a terminal."""
    return "".join(character for character in " ".join(text.split()) if character.isprintable())


def section(console: Console, heading: str, *parts: RenderableType) -> None:
    """Show a part of the page under its heading."""
    console.print()
    console.print(Text(heading, style="bold"))
    for part in parts:
        console.print(Padding(part, (0, 0, 0, 2)))


def table(heads: Sequence[str], rows: Iterable[Sequence[str | Text]], *, right: int | None = None, fold: bool = True) -> Table:
    """Lay out a table without lines.

    Parameters
    ----------
    heads : sequence of str
    rows : iterable of sequences of str or Text
    right : int, optional
        The first column whose cells stand to the right; none unless given.
    fold : bool
        Whether the last column may be folded into more lines.
    """
    made = Table(box=None, padding=(0, 2, 0, 0), pad_edge=False, show_header=any(heads), header_style="dim")
    for i, head in enumerate(heads):
        numeric = right is not None and i >= right
        folds = fold and i == len(heads) - 1
        made.add_column(Text(head), justify="right" if numeric else "left", no_wrap=not folds, overflow="fold")
    for row in rows:
        made.add_row(*(Text(cell) if isinstance(cell, str) else cell for cell in row))
    return made
