"""Comments of TOML that the program gives to people, in their language: keys and values stay as they are."""

import re
from collections.abc import Iterator

from cranktrain.language import said as _

_COMMENT = re.compile(r"^(?P<before>(?:.* )?# )(?P<said>(?!\[|[\w.]+ = ).+)$", re.MULTILINE)
"""What stands behind the last `#` of a line, unless that marks a key or a table."""


def comments_in(text: str) -> Iterator[str]:
    """Give the comments of a text, as translators are given them."""
    yield from (found["said"] for found in _COMMENT.finditer(text))


def with_said_comments(text: str) -> str:
    """Give the text with its comments in the reader's language.

    Examples
    --------
    >>> with_said_comments('# bore = "80 mm"   # with it: volumes')
    '# bore = "80 mm"   # with it: volumes'
    """
    return _COMMENT.sub(lambda found: found["before"] + _(found["said"]), text)
