"""Makes the pages of the texts from what the program knows of them: `python docs/text_pages.py` writes docs/texts."""

from collections.abc import Iterable, Iterator
from pathlib import Path

from cranktrain.references import REFERENCES
from cranktrain.textbook import errata
from cranktrain.textbook.errata_statements import amounts
from cranktrain.texts.contents import TEXTS, Formula, Text

FOLDER = Path(__file__).parent / "texts"
_MADE = "% Made by docs/text_pages.py from src/cranktrain/texts/contents: change it there.\n"
_HEAD = ("number", "what it is", "is it right, and in which range?", "to see it")


def pages() -> dict[str, str]:
    """Every page by the name of its file."""
    return {"index.md": _index(), **{f"{text.name}.md": page(text) for text in TEXTS}}


def page(text: Text) -> str:
    """The page of a text: its formulas, the commands that show them, and its errors."""
    lines = [
        _MADE,
        f"# {text.title[:1].upper()}{text.title[1:]}",
        "",
        f"{REFERENCES[text.name].text} [{text.name}].",
        "",
        "```console",
        f"$ cranktrain textbook --source {text.name}",
        f"[{text.name}] {text.title}",
        "...",
        "```",
        "",
        "## Formulas and figures",
        "",
        *_table(_HEAD, map(_row, text.formulas)),
        "",
        *_errors(text.name),
    ]
    return "\n".join(lines).rstrip("\n") + "\n"


def _row(one: Formula) -> tuple[str, ...]:
    """What is said of a formula, and the command that shows it."""
    said = "; ".join(filter(None, (one.valid, one.note)))
    verdict = f"*{one.said_verdict}*"
    seen = f"`{one.command}`" + (f"; of a machine `{one.of_machine}`" if one.of_machine else "")
    return one.number, one.subject, f"{verdict}: {said}" if said else verdict, seen


def _errors(name: str) -> Iterator[str]:
    """The errors of a text, as `textbook errata` has them."""
    found = errata(name)
    yield "## What is wrong in it"
    yield ""
    rows = [
        (
            one.name,
            one.symbol,
            *(dict(amounts(one)).get(head, "") for head in ("gives", "right")),
            *found.notes[one.name],
        )
        for one in found
    ]
    yield from _table(("step", "printed", "gives", "right", "because"), rows)


def _index() -> str:
    """The list of the texts."""
    rows = [(f"[{text.name}]({text.name}.md)", text.title, REFERENCES[text.name].text) for text in TEXTS]
    lines = [
        _MADE,
        "# Texts",
        "",
        "Five texts on crank mechanisms stand behind this program. Each page lists the formulas and figures of one,",
        "says which are right and in which range, and names the commands that show them. The equations, derived and",
        "with their errors, are in [textbook forms](../theory/textbook-forms.md).",
        "",
        *_table(("text", "about", "source"), rows),
        "",
        "```{toctree}",
        ":hidden:",
        "",
        *(text.name for text in TEXTS),
        "```",
    ]
    return "\n".join(lines) + "\n"


def _table(heads: tuple[str, ...], rows: Iterable[tuple[str, ...]]) -> Iterator[str]:
    """A table of Markdown."""
    yield _line(heads)
    yield "|" + "---|" * len(heads)
    yield from map(_line, rows)


def _line(cells: tuple[str, ...]) -> str:
    """A row of a table."""
    return "| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |"


if __name__ == "__main__":
    FOLDER.mkdir(exist_ok=True)
    for name, text in pages().items():
        (FOLDER / name).write_text(text, encoding="utf-8")
