"""Work that takes long says in a notebook how far it is: one line of plain text, which is written anew."""

import sys
from collections.abc import Generator
from contextlib import contextmanager
from time import monotonic

from cranktrain.how_far import Words, listened_to

_SEEN = 5.0
"""From when on it is said. [s]"""
_BETWEEN = 0.5
"""Between two lines. [s]"""
_WIDTH = 78


@contextmanager
def said_in_notebooks() -> Generator[None]:
    """Say how far work is, where this is a notebook; a script says nothing that it was not asked for."""
    if not _is_notebook():
        yield
        return
    since = last = monotonic()

    def heard(words: tuple[Words, ...]) -> None:
        nonlocal last
        now = monotonic()
        if now - since >= _SEEN and now - last >= _BETWEEN:
            last = now
            _rewrite(": ".join(str(each()) for each in words))

    with listened_to(heard):
        yield
    if last > since:
        _rewrite("")
        print(end="\r")


def _rewrite(line: str) -> None:
    print(f"\r{line[:_WIDTH]:<{_WIDTH}}", end="", flush=True)


def _is_notebook() -> bool:
    """Whether a kernel of Jupyter runs this: what is there says so itself, and nothing is imported for it."""
    shell = getattr(sys.modules.get("IPython"), "get_ipython", lambda: None)()
    return getattr(shell, "kernel", None) is not None
