"""`textbook --equation`: formulas and figures of the texts by their number."""

from cranktrain.cli.screen.sections import show_page
from cranktrain.cli.textbook.typed import OF_MOTION, OF_THROW, TextbookRequest
from cranktrain.errors import InputError, Problem, refuse
from cranktrain.language import said as _
from cranktrain.textbook.shown.contents import found_formulas
from cranktrain.texts.contents import TEXTS, text_called, with_equation

_OTHERS = (
    *("FILE", "--table", "--errata", *OF_MOTION, "--set", "--full", *OF_THROW),
    *("--throw", "--drive", "--at", "-o", "--force"),
)


def show_equation(asked: TextbookRequest) -> None:
    """Show formulas and figures by their number, of every text that has one of that number, or of one text.

    Raises
    ------
    InputError
        If no text has such a number, or something else was typed.
    """
    refuse(asked.beside(_("must be left out beside --equation"), *_OTHERS))
    number, source = asked.equation or "", asked.source
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
    show_page(_("By the number {number}", number=number), found_formulas(found))
