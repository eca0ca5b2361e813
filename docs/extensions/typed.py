"""What the program says and draws, made while the pages are built.

`{terminal}` types commands and shows what they say; `:lines: 12` shows so many lines of each, `:lines: 0` none;
`:status: 2` is for mistakes. `{drawn}` shows the picture of `cranktrain plot` with its arguments, `{gallery}` several
of them small, each a line: `3d12 --sheet forces | what is said below it`. All of one page happens in one empty folder.
"""

import contextlib
import io
import shlex
import shutil
from hashlib import sha256
from pathlib import Path
from typing import ClassVar

from docutils import nodes
from docutils.parsers.rst import directives
from sphinx.application import Sphinx
from sphinx.util.docutils import SphinxDirective
from sphinx.writers.html5 import HTML5Translator

from cranktrain.cli import main

_FOLDERS = "typed"
_DRAWN = "_images"


class drawn_picture(nodes.General, nodes.Inline, nodes.Element):  # noqa: N801 - docutils names nodes so
    """A picture that the build drew: `file` in the folder of pictures, and `alt`, what it shows."""


class _Typing(SphinxDirective):
    """What both directives do: type a command in the folder of the page."""

    def said(self, command: str, wanted: int = 0) -> str:
        """Type a command and give what it says; a status that is not wanted is a mistake of the page."""
        self.env.note_reread()
        program, *arguments = shlex.split(command)
        if program != "cranktrain":
            raise self.error(f"not a command of cranktrain: {command}")
        out = io.TextIOWrapper(io.BytesIO(), encoding="utf-8", write_through=True)
        with contextlib.chdir(self.folder), contextlib.redirect_stdout(out), contextlib.redirect_stderr(out):
            status = main(arguments)
        text = "\n".join(line.rstrip() for line in out.buffer.getvalue().decode().splitlines())
        if status != wanted:
            raise self.error(f"$ {command}\nended with status {status}:\n{text}")
        return text.rstrip("\n")

    def drawn(self, command: str, shown: str) -> drawn_picture:
        """Draw the picture of a command; `shown` is what it shows, in words."""
        name = f"{sha256(f'{self.env.docname} {command}'.encode()).hexdigest()[:12]}.svg"
        self.said(f"{command} -o {name} --force")
        shutil.move(self.folder / name, _kept(self.env.app) / name)
        return drawn_picture(file=name, alt=shown)

    @property
    def folder(self) -> Path:
        """The folder of the page, as the page before this directive left it."""
        folder = Path(self.env.doctreedir) / _FOLDERS / self.env.docname
        folder.mkdir(parents=True, exist_ok=True)
        return folder


class Terminal(_Typing):
    """Commands, each with what it says."""

    has_content = True
    option_spec: ClassVar = {"lines": directives.nonnegative_int, "status": directives.nonnegative_int}

    def run(self) -> list[nodes.Node]:
        """Give the terminal as text."""
        shown = [self._shown(typed.removeprefix("$ ")) for typed in self.content]
        text = "\n\n".join("\n".join(lines) for lines in shown)
        return [nodes.literal_block("", text, language="text", classes=["terminal"])]

    def _shown(self, command: str) -> list[str]:
        """Give the command and as much of its answer as is wanted."""
        lines = self.said(command, self.options.get("status", 0)).splitlines()
        most = self.options.get("lines", len(lines))
        return [f"$ {command}", *lines[:most], *(["..."] if 0 < most < len(lines) else [])]


class Drawn(_Typing):
    """A picture, with the command that draws it below."""

    required_arguments = 1
    final_argument_whitespace = True
    option_spec: ClassVar = {"alt": directives.unchanged_required, "caption": directives.unchanged_required}

    def run(self) -> list[nodes.Node]:
        """Give a figure."""
        command = f"cranktrain plot {self.arguments[0]}"
        picture = self.drawn(command, self.options["alt"])
        caption = nodes.caption("", "", *self._caption(command))
        return [nodes.figure("", picture, caption, classes=["drawn"])]

    def _caption(self, command: str) -> list[nodes.Node]:
        """Give what the picture shows, and what draws it."""
        words, _ = self.parse_inline(self.options.get("caption", ""))
        return [*words, nodes.Text(" ") if words else nodes.Text(""), nodes.literal("", f"{command} -o sheet.svg")]


class Gallery(_Typing):
    """Small pictures side by side, each with words below it."""

    has_content = True

    def run(self) -> list[nodes.Node]:
        """Give a figure for each line."""
        return [nodes.container("", *map(self._figure, filter(None, self.content)), classes=["gallery"])]

    def _figure(self, line: str) -> nodes.Node:
        """Give a picture and what is said of it."""
        arguments, _bar, words = (part.strip() for part in line.partition("|"))
        said, _messages = self.parse_inline(words)
        caption = nodes.caption("", "", *said)
        return nodes.figure("", self.drawn(f"cranktrain plot {arguments}", caption.astext()), caption)


def _kept(app: Sphinx) -> Path:
    """Give the folder where pictures wait until pages are written."""
    folder = Path(app.doctreedir) / _FOLDERS / _DRAWN
    folder.mkdir(parents=True, exist_ok=True)
    return folder


def _visit(self: HTML5Translator, node: drawn_picture) -> None:
    """Show the picture; it opens alone, where a phone is too small for it."""
    where = f"{self.builder.imgpath}/{node['file']}"
    picture = self.emptytag(node, "img", "", src=where, alt=node["alt"], loading="lazy")
    self.body.append(f'<a class="reference internal image-reference" href="{where}">{picture}</a>')
    raise nodes.SkipNode


def _emptied(app: Sphinx, docname: str, source: list[str]) -> None:
    """Begin each page in an empty folder."""
    shutil.rmtree(Path(app.doctreedir) / _FOLDERS / docname, ignore_errors=True)


def _copied(app: Sphinx, failed: Exception | None) -> None:
    """Put the pictures beside those of Sphinx."""
    if failed is None and app.builder.format == "html":
        shutil.copytree(_kept(app), Path(app.outdir) / _DRAWN, dirs_exist_ok=True)


def setup(app: Sphinx) -> dict[str, bool]:
    """Join Sphinx."""
    app.add_directive("terminal", Terminal)
    app.add_directive("drawn", Drawn)
    app.add_directive("gallery", Gallery)
    app.add_node(drawn_picture, html=(_visit, None))
    app.connect("source-read", _emptied)
    app.connect("build-finished", _copied)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
