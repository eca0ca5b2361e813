"""The texts on the screen: which there are, and what one of them holds, formula by formula."""

import shlex
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from textwrap import shorten

from rich.cells import cell_len
from rich.text import Text as Line

from cranktrain.cli.screen.text import GAP, INDENT, page, paragraph, section, show_lines, table
from cranktrain.errors import InputError, Problem, refuse
from cranktrain.grouping import grouped
from cranktrain.language import said as _
from cranktrain.references import REFERENCES
from cranktrain.texts.contents import TEXTS, Formula, plain_number, text_called, with_equation
from cranktrain.texts.contents import Text as Source

_LONGEST = 34
"""A longer number, which is a formula, has a width of its own."""


def show_texts() -> None:
    """Show which texts there are, with how many of their formulas are right."""
    with page(_("The texts whose formulas stand beside the exact ones")) as console:
        for text in TEXTS:
            lines = [_(text.title), _counted(text), REFERENCES[text.name].text]
            section(console, text.name, lines)
        go_on = [
            _("`cranktrain textbook --source NAME`: what one of them holds, formula by formula"),
            _("`cranktrain textbook FILE`: how far their forms are off for a machine"),
            _("`cranktrain textbook errata`: what is wrong in them"),
        ]
        section(console, _("To go on"), go_on)


def _counted(text: Source) -> str:
    """Say how many formulas and figures a text has, by verdict."""
    by_verdict = Counter(one.said_verdict for one in text.formulas)
    return _(
        "{n} formulas and figures: {verdicts}",
        n=len(text.formulas),
        verdicts="; ".join(f"{n} {verdict}" for verdict, n in by_verdict.items()),
    )


def show_text(text: Source, *, has_forms: bool, full: bool) -> None:
    """Show the formulas and figures of a text, one in a line by what they are: right, right in a range, or wrong.

    Parameters
    ----------
    text : Text
    has_forms : bool
        Whether it has forms for machines.
    full : bool
        Whether to show of each its range, what to mind, and the command that shows it.
    """
    with page(f"[{text.name}] {_(text.title)}") as console:
        width = console.width - INDENT
        source = REFERENCES[text.name].text
        if full:
            section(console, _("Source"), [source])
            for one in text.formulas:
                section(console, f"{one.number}  {_(one.subject)}", _lines(one, width))
        else:
            show_lines(console, [Line(" " * INDENT) + line for line in paragraph(console, source)])
            for verdict, formulas in grouped((one.said_verdict, one) for one in text.formulas).items():
                section(console, verdict[:1].upper() + verdict[1:], _listed(text, formulas, width))
        section(console, _("To go on"), _go_on(text, has_forms=has_forms, full=full))


def _listed(text: Source, formulas: Sequence[Formula], width: int) -> Iterator[Line]:
    """Formulas one in a line, a subject cut where there is no room; numbers have one width, but long ones."""
    usual = max((cell_len(one.number) for one in text.formulas if cell_len(one.number) <= _LONGEST), default=0)
    for one in formulas:
        number = one.number + " " * (usual - cell_len(one.number) + GAP if cell_len(one.number) <= usual else GAP)
        yield Line(number + shorten(_(one.subject), width - cell_len(number), placeholder=" …"))


def show_equation(number: str, source: str | None, *, others: Mapping[str, str | None]) -> None:
    """Show formulas and figures by their number, of every text that has one of that number, or of one text.

    Parameters
    ----------
    number : str
    source : str, optional
    others : mapping of options to str or None
        What else was typed and means nothing here.

    Raises
    ------
    InputError
        If no text has such a number, or something else was typed.
    """
    allowed = _("must be left out beside --equation")
    refuse(Problem(name, value or None, allowed) for name, value in others.items() if value is not None)
    texts = [text_called(source)] if source else TEXTS
    found = with_equation(number, texts)
    if not found:
        elsewhere = [] if source is None else with_equation(number)
        repair = None
        if elsewhere:
            letters = ", ".join(dict.fromkeys(f"{text.letter} {text.name}" for text, _one in elsewhere))
            repair = _("that number is in {texts}", texts=letters)
        missing = _(
            "must be the number of a formula, figure or page: {numbers}",
            numbers="; ".join(f"{text.letter} {', '.join(text.number_ranges)}" for text in texts),
        )
        raise InputError([Problem("--equation", number, missing, repair)])
    with page(_("By the number {number}", number=number)) as console:
        for text, one in found:
            heading = f"{one.number}  {_(one.subject)}  [{text.name}]"
            section(console, heading, _lines(one, console.width - INDENT))


def _lines(one: Formula, width: int) -> Iterator[Line]:
    """What is said of a formula below its heading; the command is not folded, so that it can be copied."""
    said = [(_("it is"), one.said_verdict), (_("range"), _(one.valid)), (_("mind"), _(one.note))]
    seen = [(_("see"), one.command), (_("of a machine"), one.of_machine)]
    heads = [head for head, text in (*said, *seen) if text]
    room = max(map(cell_len, heads))
    yield from table(("", ""), [(head.ljust(room), text) for head, text in said if text], fold=width)
    yield from table(("", ""), [(head.ljust(room), text) for head, text in seen if text])


def _go_on(text: Source, *, has_forms: bool, full: bool) -> Iterator[str]:
    """Say what else shows the text."""
    if not full:
        number = plain_number(next(one.number for one in text.formulas if one.verdict != "right"))
        asked = shlex.join(["cranktrain", "textbook", "--source", text.letter, "--equation", number])
        yield _("`{one}`: one, with its range and the command that shows it", one=asked)
        yield _("`{all}`: all of them so", all=f"cranktrain textbook --source {text.letter} --full")
    if has_forms:
        yield _("`cranktrain textbook FILE --source {name}`: its forms for a machine of yours", name=text.letter)
    yield _("`cranktrain textbook errata --source {name}`: its errors", name=text.letter)
