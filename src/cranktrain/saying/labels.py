"""Names of members along dimensions: those of a file as they are typed, the program's as keys with titles beside."""

import re
from collections.abc import Mapping
from functools import cache
from string import Formatter

from cranktrain.language import Words, _

Titles = Mapping[str, str]
"""From the key of a member to what people call it, not yet translated; `{n}` in both stands for the same."""


def titled(titles: Titles, label: str) -> Words:
    """Say what people call a member.

    Parameters
    ----------
    titles : Titles
        Of the dimension, tried in their order.
    label : str
        A name of the file, which stays as it is typed, has none.

    Examples
    --------
    >>> str(titled({"crank": "crank", "shaft_{n}": "shaft {n}"}, "shaft_2"))
    'shaft 2'
    """
    for key, title in titles.items():
        found = _form(key).fullmatch(label)
        if found is not None:
            return _(title, **{name: titled(titles, piece) for name, piece in found.groupdict().items()})
    return label


@cache
def _form(key: str) -> re.Pattern[str]:
    """Labels that are made of a key."""
    parts = Formatter().parse(key)
    return re.compile("".join(re.escape(text) + (f"(?P<{name}>.+)" if name else "") for text, name, *_rest in parts))
