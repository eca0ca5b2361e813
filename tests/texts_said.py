"""What the pages of the texts say."""

from cranktrain.texts.contents import text_called


def sentence(name: str, words: str, number: str = "") -> str:
    """The one sentence of a text's page, or of a formula there by its number, that has the words."""
    text = text_called(name)
    formulas = [one for one in text.formulas if number in ("", one.number)]
    each = {text.said_of, *(part for one in formulas for part in (one.valid, one.note, one.subject))}
    (found,) = (part for part in each if words in part)
    return found
