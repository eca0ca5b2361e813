"""Commands that a page names, so that they can be copied."""

import shlex
from collections.abc import Sequence

from cranktrain.one_line import one_line


def textbook_command(*words: str, settings: Sequence[str] = ()) -> str:
    """Write `textbook` with what follows it, and with the values that were set.

    Examples
    --------
    >>> textbook_command("my engine.toml", "--full", settings=["shaft.main.speed=5 rpm"])
    "cranktrain textbook 'my engine.toml' --full --set 'shaft.main.speed=5 rpm'"
    """
    typed = ["cranktrain", "textbook", *words, *(word for one in settings for word in ("--set", one))]
    return one_line(shlex.join(typed))
