"""What is to be minded of a result: what of its file is not used, which check does not hold, what is doubtful."""

from typing import NamedTuple

from cranktrain.analysis.result import Result
from cranktrain.analysis.unused import sentences
from cranktrain.language import Words, _
from cranktrain.saying.wording import InPrint
from cranktrain.texts.comparison import TextbookMotion


class ToMind(NamedTuple):
    """Sentences: on what is not used, on checks that do not hold, and flags."""

    unused: list[Words]
    failed: list[Words]
    flags: list[Words]


def to_mind(result: Result) -> ToMind:
    """Say what is to be minded of one machine; ranges of textbook forms stand with these."""
    book = result.get(TextbookMotion)
    of_books = () if book is None else book.flags
    failed: list[Words] = [
        _("A check does not hold: {sentence}", sentence=check.sentence)
        for check in result.checks
        if check.judged[0] and not check.passed[0]
    ]
    flags: list[Words] = [InPrint(flag) for flag in result.flag_words if flag not in of_books]
    return ToMind(sentences(result.unused), failed, flags)
