"""What is to be minded, before all numbers: tables not used, flags, checks that do not hold; like ones joined."""

from collections.abc import Iterator, Sequence

from cranktrain.analysis import Result, sentences
from cranktrain.cli.screen.text import folded
from cranktrain.cli.screen.typesetting import typeset
from cranktrain.grouping import grouped
from cranktrain.language import _
from cranktrain.one_line import visible
from cranktrain.texts.comparison import TextbookMotion

_MOST_LINES = 3
"""Of one flag; `--full` has the rest."""
_MARK = "! "


def minded(result: Result) -> list[str]:
    """Give sentences to mind; ranges of textbook forms stand with these."""
    book = result.get(TextbookMotion)
    of_books = () if book is None else book.flags
    failed = [
        _("A check does not hold: {sentence}").format(sentence=check.sentence)
        for check in result.checks
        if check.judged[0] and not check.passed[0]
    ]
    return [*sentences(result.unused), *failed, *joined([one for one in result.flags if one not in of_books])]


def joined(flags: Sequence[str]) -> Iterator[str]:
    """Join flags that say the same of several: what they have in common stands for all.

    Examples
    --------
    >>> list(joined(["Far off: 1L; 3L.", "Near.", "Far off: 2L."]))
    ['Far off … (--full)', 'Near.']
    """
    for head, ends in grouped((one.partition(": ")[0], one) for one in flags).items():
        yield ends[0] if len(ends) == 1 else _of_several(head)


def _of_several(said: str) -> str:
    """What flags of several have in common, before their list."""
    return _("{said} … (--full)").format(said=said.partition(": ")[0])


def minded_lines(result: Result, width: int) -> Iterator[str]:
    """Lay them out, each behind a mark, in a width of columns."""
    for sentence in minded(result):
        said = typeset(visible(sentence))
        lines = folded(said, width, _MARK, " " * len(_MARK))
        if len(lines) >= _MOST_LINES and "; " in said:  # a list
            lines = folded(_of_several(said), width, _MARK, " " * len(_MARK))
        if len(lines) > _MOST_LINES:
            lines = folded(said, width, _MARK, " " * len(_MARK), at_most=_MOST_LINES)
        yield from lines
