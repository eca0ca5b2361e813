"""Lessons and tasks are followed in this process, each in a shell and an empty folder of its own.

A kernel for each would load everything anew, and so would every command in it; one that is followed in a kernel is a
test, `tests/e2e/test_notebooks.py`.
"""

import contextlib
import io
import shlex
from collections.abc import Iterator
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import matplotlib as mpl
import matplotlib.pyplot as plt
import nbformat
from IPython.core.displayhook import DisplayHook
from IPython.core.displaypub import DisplayPublisher
from IPython.core.interactiveshell import InteractiveShell
from IPython.core.pylabtools import select_figure_formats
from myst_nb import sphinx_ as notebook_pages
from myst_nb.core.config import NbParserConfig
from myst_nb.core.execute import ExecutionError, NotebookClientBase
from myst_nb.core.loggers import LoggerType
from nbformat import NotebookNode
from sphinx.application import Sphinx
from traitlets.config import Config

from cranktrain.cli import main

_PROGRAM = "cranktrain"
_LANGUAGE = {"name": "python", "pygments_lexer": "ipython3"}


class _Terminal(io.TextIOWrapper):
    """What is said, with heads and notes as a terminal shows them."""

    def isatty(self) -> bool:
        """Be one."""
        return True


class _Displayed(DisplayPublisher):
    """What a cell displays, among what it shows."""

    def publish(self, data: dict[str, Any], metadata: dict[str, Any] | None = None, **_kept: object) -> None:
        """Keep a picture or a table."""
        self.shell.show("display_data", data=data, metadata=metadata or {})


class _Result(DisplayHook):
    """What the last line of a cell is, among what the cell shows."""

    def write_output_prompt(self) -> None:
        """Say nothing: pages have no numbers before results."""

    def write_format_data(self, format_dict: dict[str, Any], md_dict: dict[str, Any] | None = None) -> None:
        """Keep it in all its forms."""
        count = self.prompt_count
        self.shell.show("execute_result", data=format_dict, metadata=md_dict or {}, execution_count=count)

    def finish_displayhook(self) -> None:
        """Write no end of a line."""


class _Shell(InteractiveShell):
    """A shell that keeps what cells show, and types `!cranktrain …` in this process."""

    def __init__(self, **settings: Any) -> None:
        self.shown: list[NotebookNode] = []
        self.said = _Terminal(io.BytesIO(), encoding="utf-8", write_through=True)
        # How far long work is would only be written over.
        self.told = io.TextIOWrapper(self.said.buffer, encoding="utf-8", write_through=True)
        super().__init__(
            display_pub_class=_Displayed,
            displayhook_class=_Result,
            config=Config(HistoryManager={"enabled": False}),
            **settings,
        )

    def system(self, cmd: str) -> None:
        """Type a command, which must do what it says."""
        typed = self.var_expand(cmd, depth=1)
        program, *arguments = shlex.split(typed)
        status = main(arguments) if program == _PROGRAM else f"not a command of {_PROGRAM}"
        if status != 0:
            raise RuntimeError(f"$ {typed}\nended with {status}")

    def enable_gui(self, gui: str | None = None) -> None:
        """Need nothing: figures are shown in the page."""

    def show(self, sort: str, **parts: Any) -> None:
        """Keep one thing more that a cell shows, after what it has said before."""
        text = self.said.buffer.getvalue().decode()
        if text:
            self.shown.append(nbformat.v4.new_output("stream", name="stdout", text=text))
            self.said.seek(0)
            self.said.buffer.truncate()
        if sort:
            self.shown.append(nbformat.v4.new_output(sort, **parts))

    def follow(self, source: str) -> list[NotebookNode]:
        """Run a cell and give what it shows."""
        with contextlib.redirect_stdout(self.said), contextlib.redirect_stderr(self.told):
            done = self.run_cell(source, store_history=True)
        self.show("")
        done.raise_error()
        shown, self.shown = self.shown, []
        return shown


@contextlib.contextmanager
def _shell() -> Iterator[_Shell]:
    """Give a shell that knows nothing yet, with figures in the page; and leave all as it was."""
    shell = _Shell.instance()
    backend = mpl.get_backend()
    shell.enable_matplotlib("inline")
    select_figure_formats(shell, {"png"}, bbox_inches="tight")
    try:
        yield shell
    finally:
        plt.close("all")
        plt.switch_backend(backend)
        mpl.interactive(False)
        shell.restore_sys_module_state()
        _Shell.clear_instance()


class _Followed(NotebookClientBase):
    """A notebook that has been followed from its first cell to its last."""

    def start_client(self) -> None:
        """Run all cells; one that fails is no page."""
        self.notebook.metadata["language_info"] = _LANGUAGE
        with TemporaryDirectory() as folder, contextlib.chdir(folder), _shell() as shell:
            cells = [cell for cell in self.notebook.cells if cell.cell_type == "code"]
            for number, cell in enumerate(cells, start=1):
                cell.execution_count = number
                try:
                    cell.outputs = shell.follow(cell.source)
                except Exception as error:  # a cell may raise anything, and whatever it is ends the build
                    raise ExecutionError(f"{self.path}, cell {number}:\n{cell.source}") from error


def _followed(
    notebook: NotebookNode, source: str, settings: NbParserConfig, logger: LoggerType, _reader: dict[str, Any] | None
) -> NotebookClientBase:
    """Follow a notebook, as `myst_nb` would have a kernel do."""
    return _Followed(notebook, Path(source), settings, logger)


def setup(app: Sphinx) -> dict[str, bool]:
    """Join Sphinx."""
    if not hasattr(notebook_pages, "create_client"):
        raise AttributeError("myst_nb runs notebooks in another way than this extension knows")
    notebook_pages.create_client = _followed
    return {"parallel_read_safe": True, "parallel_write_safe": True}
