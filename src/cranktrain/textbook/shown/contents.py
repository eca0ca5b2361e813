"""`textbook --source`: the texts, which there are, and what one of them holds, formula by formula."""

import shlex
from collections import Counter
from collections.abc import Iterator, Sequence

from cranktrain.grouping import grouped
from cranktrain.language import Listed, Words, _
from cranktrain.references import REFERENCES
from cranktrain.saying.sections import Part, Rows, ShownSection
from cranktrain.textbook.statements import Heading
from cranktrain.texts.contents import TEXTS, Formula, Text, plain_number


def list_of_texts() -> Iterator[ShownSection]:
    """Give which texts there are, with how many of their formulas are right."""
    for text in TEXTS:
        yield ShownSection(text.name, (_(text.title), _counted(text), REFERENCES[text.name].text))
    go_on = (
        _("`cranktrain textbook --source NAME`: what one of them holds, formula by formula"),
        _("`cranktrain textbook FILE`: how far their forms are off for a machine"),
        _("`cranktrain textbook errata`: what is wrong in them"),
    )
    yield ShownSection(_("To go on"), go_on)


def _counted(text: Text) -> Words:
    """Say how many formulas and figures a text has, by verdict."""
    by_verdict = Counter(one.verdict_words for one in text.formulas)
    verdicts = Listed([Listed((f"{n}", verdict), " ") for verdict, n in by_verdict.items()], "; ")
    return _("{n} formulas and figures: {verdicts}", n=len(text.formulas), verdicts=verdicts)


def contents_of(text: Text, *, full: bool) -> Iterator[ShownSection]:
    """Give the formulas and figures of a text, one in a line by what they are: right, right in a range, or wrong.

    Parameters
    ----------
    text : Text
    full : bool
        Whether to give of each its range, what to mind, and the command that shows it.
    """
    source = REFERENCES[text.name].text
    yield ShownSection(_("Source") if full else "", (source,))
    if full:
        for one in text.formulas:
            yield ShownSection(Listed((one.number, _(one.subject)), "  "), _of_formula(one))
    else:
        numbers = [one.number for one in text.formulas]
        for verdict, formulas in grouped((one.verdict_words, one) for one in text.formulas).items():
            cells = [(one.number, _(one.subject)) for one in formulas]
            yield ShownSection(Heading(verdict), (Rows(cells, cut=1, like=numbers),))
    yield ShownSection(_("To go on"), tuple(_go_on(text, full=full)))


def found_formulas(found: Sequence[tuple[Text, Formula]]) -> Iterator[ShownSection]:
    """Give some formulas, each with its text."""
    for text, one in found:
        yield ShownSection(Listed((one.number, _(one.subject), f"[{text.name}]"), "  "), _of_formula(one))


def _of_formula(one: Formula) -> tuple[Rows, ...]:
    """What is said of a formula below its heading; the command is not folded, so that it can be copied."""
    said = ((_("it is"), one.verdict_words), (_("range"), _(one.valid)), (_("mind"), _(one.note)))
    seen = ((_("see"), one.command), (_("of a machine"), one.of_machine))
    texts, commands = ([(head, words) for head, words in each if str(words)] for each in (said, seen))
    like = [head for head, _words in (*texts, *commands)]
    found = (Rows(texts, like=like), Rows(commands, like=like, is_folded=False))
    return tuple(one for one in found if one.cells)


def _go_on(text: Text, *, full: bool) -> Iterator[Part]:
    """Say what else shows the text."""
    if not full:
        number = plain_number(next(one.number for one in text.formulas if one.verdict != "right"))
        asked = shlex.join(["cranktrain", "textbook", "--source", text.letter, "--equation", number])
        yield _("`{one}`: one, with its range and the command that shows it", one=asked)
        yield _("`{all}`: all of them so", all=f"cranktrain textbook --source {text.letter} --full")
    if text.of_machine:
        yield _("`cranktrain textbook FILE --source {name}`: its forms for a machine of yours", name=text.letter)
    yield _("`cranktrain textbook errata --source {name}`: its errors", name=text.letter)
