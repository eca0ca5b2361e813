"""All results in tables, from the catalogue that the program itself reads: `{results}`."""

import re
from collections.abc import Iterator

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.util.docutils import SphinxDirective

from cranktrain.all_questions import QUESTIONS
from cranktrain.analysis import every_stage
from cranktrain.layout.question import Stage
from cranktrain.saying.catalogue import Entry, entries

_HEADS = ("name", "symbol", "unit", "what it is", "from")
_WITHOUT_QUESTION = "textbook and kinds of mechanism"


class Results(SphinxDirective):
    """A head and a table for each question."""

    def run(self) -> list[nodes.Node]:
        """Give what the page would say in Markdown."""
        self.env.note_reread()
        return self.parse_text_to_nodes("\n".join(page_lines()), allow_section_headings=True)


def page_lines() -> Iterator[str]:
    """Give the tables in Markdown, line by line."""
    for title, stages in _groups():
        yield from (f"## {title[:1].upper()}{title[1:]}", "", _line(_HEADS), "|" + "---|" * len(_HEADS))
        yield from (_line(_cells(entry)) for stage in stages for entry in entries(stage.gives))
        yield ""


def _groups() -> Iterator[tuple[str, list[Stage]]]:
    """Give stages by their question, and then those of none."""
    of_questions = {question.name: list(question.stages) for question in QUESTIONS}
    yield from of_questions.items()
    asked = [stage.gives for stages in of_questions.values() for stage in stages]
    yield _WITHOUT_QUESTION, [stage for stage in every_stage() if stage.gives not in asked]


def _cells(entry: Entry) -> tuple[str, ...]:
    """Give what is said of a result; a curve has its angle in the symbol."""
    symbol = entry.symbol if entry.is_fact else f"{entry.symbol}(φ)"
    page = entry.source.removeprefix("docs/")
    linked = re.sub(r"\((.+?)\)", r"{eq}`\1`", entry.numbers)
    where = f"[{page.rpartition('/')[2]}](/{page}.md) {linked}".rstrip()
    return f"`{entry.name}`", symbol, entry.unit, entry.sentence, where


def _line(cells: tuple[str, ...]) -> str:
    """Give a row."""
    return "| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |"


def setup(app: Sphinx) -> dict[str, bool]:
    """Join Sphinx."""
    app.add_directive("results", Results)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
