"""The sources' errors: each step that is wrong, what it gives, what is right, and how we know."""

from collections.abc import Iterator, Sequence

from cranktrain.language import Listed, _
from cranktrain.references import REFERENCES
from cranktrain.saying.sections import Part, Rows, ShownSection, Unfolded
from cranktrain.textbook.errata_statements import amounts, errata
from cranktrain.textbook.shown.synthesis import source_requirements, source_velocities
from cranktrain.textbook.statements import Statement
from cranktrain.textbook.synthesis_statements import SOURCE as SYNTHESIS
from cranktrain.texts.contents import TEXTS, Text

_OF_EACH = 4
"""Of a text's errors, where those of all are listed."""


def errata_sections(text: Text | None = None, *, full: bool) -> Iterator[ShownSection]:
    """Give the errors of every text, or of one: all that is said of them, or one in a line."""
    for one in TEXTS if text is None else (text,):
        yield from _errors_of(one) if full else _list_of(one, _OF_EACH if text is None else None)
    if not full:
        yield _go_on(text)


def first_errors(text: Text) -> Iterator[ShownSection]:
    """Give a text's first errors one in a line, and the command for all."""
    yield from _list_of(text, _OF_EACH)
    yield _go_on(text)


def _errors_of(text: Text) -> Iterator[ShownSection]:
    """All that is said of a text's errors."""
    own = (source_requirements(),) if text.name == SYNTHESIS else ()
    yield ShownSection(f"[{text.name}]", (REFERENCES[text.name].text, *own))
    found = errata(text.name)
    for place, one in enumerate(found, start=1):
        gives = [(_(head), amount) for head, amount in amounts(one)]
        rows = [(_("printed"), one.symbol), *gives, (_("because"), *found.sentences[one.words])]
        yield ShownSection(Listed((f"{place}.", one.words), " "), (Rows(rows),))
    if text.name == SYNTHESIS:
        yield source_velocities()


def _list_of(text: Text, most: int | None) -> Iterator[ShownSection]:
    """A text's errors one in a line, or so many of them; of the synthesis all with its table of velocities."""
    each = errata(text.name).each
    parts: list[Part] = [_listed(each[:most])]
    if most is not None and len(each) > most:
        parts.append(Unfolded(f"… `cranktrain textbook errata --source {text.letter}`"))
    yield ShownSection(_("[{name}] {n} wrong steps", name=text.name, n=len(each)), parts)
    if most is None and text.name == SYNTHESIS:
        yield source_velocities()


def _listed(each: Sequence[Statement]) -> Rows:
    """Errors one in a line: what it is, what it gives, and what is right."""
    cells = [dict(amounts(one)) for one in each]
    rows = [
        (f"{place}.", one.words, own.get("gives", ""), own.get("right", ""))
        for place, (one, own) in enumerate(zip(each, cells, strict=True), start=1)
    ]
    return Rows(rows, ("", "", _("gives"), _("right")), right=(0, 2, 3), cut=1)


def _go_on(text: Text | None) -> ShownSection:
    asked = f" --source {text.letter}" if text else ""
    said = _("`{command}`: each as printed, and why it is wrong", command=f"cranktrain textbook errata{asked} --full")
    return ShownSection(_("To go on"), (said,))
