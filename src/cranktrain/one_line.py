"""Text from outside, written so that it can stand in one line of a terminal or a drawing."""

from unicodedata import category

LONGEST_SHOWN = 60
"""Characters of a value in a message."""


def one_line(text: str) -> str:
    r"""Write a text of the user's in one line: a control or half a character by its number, for no terminal to obey.

    Examples
    --------
    >>> print(one_line("two lines\nand a \x1b[31mred one"))
    two lines and a \x1b[31mred one
    """
    return visible(" ".join(text.split()))


def visible(text: str, kept: str = "") -> str:
    """Write controls and halves of characters by their numbers, but those that are kept; blanks stay."""
    if text.isprintable():  # as nearly every text is
        return text
    return "".join(
        character
        if character.isprintable() or character in kept or category(character) == "Zs"
        else character.encode("unicode_escape").decode()
        for character in text
    )


def short(text: str, longest: int = LONGEST_SHOWN) -> str:
    """Write a text of the user's in one line, of which a long one is cut.

    Examples
    --------
    >>> short("a rod of 320 mm", 9)
    'a rod of…'
    """
    # What is beyond is never shown, however much it is; one character that is written may stand for several blanks.
    line = one_line(" ".join(text.split())[: longest + 1])
    return line if len(line) <= longest else line[: longest - 1].rstrip() + "…"
