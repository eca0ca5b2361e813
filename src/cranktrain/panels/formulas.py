"""Formulas among words: marked as such, so that a $ in a name begins none, and symbols set as mathematics."""

import re

_LETTERS = 2
"""So many letters side by side are pins; more are a word."""

_NUMBERED = re.compile(r"([^\W\d_])(\d+)('*)")
"""A pin of several alike: its number is an index."""

FORMULA = "\ue000"
"""Stands on both sides of a formula; what comes from a file has no such sign, see `visible`."""

_SETTABLE = re.compile(
    r"[A-Za-z0-9\u0370-\u03ff][A-Za-z0-9\u0370-\u03ff,.'′_-]*(?:\^[A-Za-z0-9\u0370-\u03ff]+)?|[A-Z]_[а-я]"
)
"""What can be set as a symbol; one letter of a Russian text as an index, too."""

_RUSSIAN = re.compile(r"[а-я]")

INDICES = str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")
"""Figures as indices, in plain text."""


def formula(tex: str) -> str:
    """Mark a formula, which stands among words that are drawn as they are: a $ in a name begins none."""
    return f"{FORMULA}{tex}{FORMULA}"


def is_formula(words: str) -> bool:
    """Whether words are a formula and nothing else."""
    return len(words) > 1 and words[0] == words[-1] == FORMULA


def mathematics(symbol: str) -> str:
    """Set a symbol as mathematics: a_BA^n with index and exponent, letters slanted and whole words upright.

    A name with signs that mean something in a formula, or that its fonts lack, stays as it is.
    """
    if not _SETTABLE.fullmatch(symbol):
        return symbol
    head, _mark, rest = symbol.partition("_")
    index, _mark, exponent = rest.partition("^")
    set_index = ",".join(map(_letters_or_word, index.split(",")))
    numbered = _NUMBERED.fullmatch(head)
    if numbered and not index:
        return formula(f"{numbered[1]}_{{{numbered[2]}}}{'′' * len(numbered[3])}")
    ending = f"{f'_{{{set_index}}}' if index else ''}{f'^{{{exponent}}}' if exponent else ''}"
    return formula(f"{_letters_or_word(head)}{ending}")


def _letters_or_word(name: str) -> str:
    """Leave letters as they are; set a word upright, and a Russian letter, which slanted looks like a Latin one.

    A prime's own sign is larger than what ' becomes.
    """
    bare = name.rstrip("'")
    primes = "′" * (len(name) - len(bare))
    if len(bare.replace("'", "")) <= _LETTERS and "_" not in bare and not _RUSSIAN.fullmatch(bare):
        return bare.replace("'", "′") + primes
    return rf"\mathrm{{{bare.replace('_', chr(92) + '_')}}}{primes}"


def in_words(pin: str) -> str:
    """Give a pin's name in plain text, its number as an index: B₂."""
    return pin.translate(INDICES) if _NUMBERED.fullmatch(pin) else pin
