"""Keys of thousands of parts, for which what reads TOML takes minutes and gigabytes: found before it reads."""

import re

from cranktrain.paths import DEEPEST_NESTING

_KEY_PART = re.compile(r"""[A-Za-z0-9_-]+|"(?:[^"\\\n]|\\.)*"?|'[^'\n]*'?""")
_TEXTS_AND_KEYS = re.compile(
    rf"""
    "{{3}} (?: [^"\\] | \\[\s\S] | "(?!"") )* (?:"{{3}})?
    | '{{3}} (?: [^'] | '(?!'') )* (?:'{{3}})?
    | \#[^\n]*
    | (?P<key> (?:{_KEY_PART.pattern}) (?: [ \t]* \. [ \t]* (?:{_KEY_PART.pattern}) )* )
    """,
    re.VERBOSE,
)
"""Texts of several lines, comments, keys with dots; a text of one line, or a number, looks like a key of few parts."""


def long_key(text: str) -> re.Match[str] | None:
    """Find the first key of more parts than a machine file may have; one in a text or a comment is none.

    Parameters
    ----------
    text : str

    Returns
    -------
    re.Match or None
        Its group `key` is the key as it is written.
    """
    for found in _TEXTS_AND_KEYS.finditer(text):
        key = found["key"] or ""
        if key.count(".") >= DEEPEST_NESTING and len(_KEY_PART.findall(key)) > DEEPEST_NESTING:
            return found
    return None
