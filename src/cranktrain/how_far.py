"""How far long work is: whoever works says it in words, which are made only where somebody listens and asks."""

from collections.abc import Callable, Generator
from contextlib import contextmanager
from contextvars import ContextVar
from typing import TypeAlias

Words: TypeAlias = Callable[[], object]
"""How far a piece of work is, as of now: what `str` says."""

_listener: ContextVar[Callable[[tuple[Words, ...]], None] | None] = ContextVar("listener", default=None)
_around: ContextVar[tuple[Words, ...]] = ContextVar("around", default=())


def say_how_far(words: Words) -> None:
    """Say how far the work is; where nobody listens, nothing is done.

    Parameters
    ----------
    words : callable
        Called when it is asked for, from another thread: of what does not change.
    """
    listener = _listener.get()
    if listener is not None:
        listener((*_around.get(), words))


@contextmanager
def within(words: Words) -> Generator[None]:
    """Do a piece of a larger work, of which `words` say how far that is."""
    token = _around.set((*_around.get(), words))
    try:
        yield
    finally:
        _around.reset(token)


@contextmanager
def listened_to(listener: Callable[[tuple[Words, ...]], None]) -> Generator[None]:
    """Have a listener told how far work is, the larger pieces first."""
    token = _listener.set(listener)
    try:
        yield
    finally:
        _listener.reset(token)
