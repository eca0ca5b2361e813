"""Names of the program in words: `mean_piston_speed` is "mean piston speed" to people, in their language."""

import unicodedata

from cranktrain.language import said as _


def spelled(name: str) -> str:
    """Write a name in words, as translators are given it."""
    return name.replace("_", " ")


def said_name(name: str) -> str:
    """Say a name in the reader's language; one that no translator was given stays as it is, without underscores."""
    return _(spelled(name))


def key_of_symbol(text: str) -> str:
    """Write a symbol, or a few words, as names of data are written: ASCII letters, digits and underlines.

    Examples
    --------
    >>> key_of_symbol("θ″₂"), key_of_symbol("Δx"), key_of_symbol("(I.11)"), key_of_symbol("1L")
    ('theta_2_2', 'Delta_x', 'I_11', '1L')
    """
    parts = unicodedata.normalize("NFKD", text).replace("″", "′′").replace("′′", " 2 ").replace("′", " 1 ")
    return "_".join("".join(one if one.isascii() and one.isalnum() else _in_ascii(one) for one in parts).split())


def _in_ascii(letter: str) -> str:
    """Name a letter that is not ASCII as it is called, α alpha; of all else a blank stays."""
    if not letter.isalpha():
        return " "
    *_before, size, _letter, called = ("", "", *unicodedata.name(letter).split(" "))[-4:]
    return f" {called.capitalize() if size == 'CAPITAL' else called.lower()} "
