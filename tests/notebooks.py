"""Notebooks of the documentation, typed by a test as by a reader: an empty folder, cell after cell."""

import re
import shlex
from pathlib import Path
from typing import Any

import matplotlib as mpl
import matplotlib.pyplot as plt

from cranktrain.cli import main

DOCS = Path(__file__).parents[1] / "docs"
NOTEBOOKS = sorted(page for folder in ("lessons", "tasks") for page in (DOCS / folder).glob("[!i]*.md"))
_CELL = re.compile(r"^```\{code-cell\}\n(.*?)^```$", re.MULTILINE | re.DOTALL)
_FILE = re.compile(r"%%writefile (?P<more>-a )?(?P<name>\S+)\n")
_COMMAND = re.compile(r"^!cranktrain (?P<arguments>.*)$", re.MULTILINE)


def followed(page: Path) -> dict[str, Any]:
    """Do in the working directory what a notebook says, and give the names that it then knows."""
    known: dict[str, Any] = {"typed": typed}
    with mpl.rc_context({"backend": "agg"}):
        for cell in cells(page):
            do(cell, known)
        plt.close("all")
    return known


def cells(page: Path) -> list[str]:
    """What a notebook says is to be run."""
    return _CELL.findall(page.read_text(encoding="utf-8"))


def do(cell: str, known: dict[str, Any]) -> None:
    """Do one cell: write a file, or run Python, in which a line with `!` is for a terminal."""
    file = _FILE.match(cell)
    if file:
        with Path(file["name"]).open("a" if file["more"] else "w", encoding="utf-8") as written:
            written.write(cell[file.end() :])
    else:
        python = _COMMAND.sub(lambda command: f"typed(f{command['arguments']!r})", cell)
        exec(compile(python, "cell", "exec"), known)


def typed(arguments: str) -> None:
    """Type a command, which must do what it says."""
    assert main(shlex.split(arguments)) == 0, arguments
