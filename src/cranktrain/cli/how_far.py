"""Work that takes long says on the standard error how far it is."""

import sys
from collections.abc import Generator
from contextlib import contextmanager, suppress
from contextvars import copy_context
from itertools import count
from time import monotonic, process_time
from typing import TYPE_CHECKING

from cranktrain.how_far import Words, listened_to
from cranktrain.language import said as _

if TYPE_CHECKING:
    from threading import Event

_LONG = 5.0
"""From when on it is said where no terminal is: each time after twice as long. [s]"""
_SEEN = 1.0
"""From when on it is said to a terminal. [s]"""
_BETWEEN = 0.25
"""Between two looks at it. [s]"""
_WIDTH = 78


@contextmanager
def says_how_far() -> Generator[None]:
    """Say on the standard error how far work is that takes long.

    Notes
    -----
    A terminal has one line of it, which is gone before anything else is written; Ctrl-C then reaches the work as ever.
    Elsewhere it is a line now and then, by the time that was computed: a computer with much else to do says no more.
    """
    if sys.stderr is not sys.__stderr__:  # whoever catches what is said wants to know what is wrong, and no more
        yield
        return
    from threading import Event, Thread  # not for what takes no time

    latest: list[tuple[Words, ...]] = [()]

    def heard(words: tuple[Words, ...]) -> None:
        latest[0] = words

    done = Event()
    # In a context like this one: numbers are in the units that are chosen here.
    tell = Thread(target=copy_context().run, args=(_tell, latest, done), daemon=True)
    tell.start()
    try:
        with listened_to(heard):
            yield
    finally:
        done.set()
        tell.join()


def _tell(latest: list[tuple[Words, ...]], done: "Event") -> None:
    """Say it until the work is done."""
    is_terminal = sys.stderr.isatty()
    clock, next_at = (monotonic, _SEEN) if is_terminal else (process_time, _LONG)
    since, is_told = clock(), False
    for _look in count():
        if done.wait(_BETWEEN):
            break
        taken = clock() - since
        if taken < next_at:
            continue
        said = ": ".join(str(words()) for words in latest[0]) or _("at work")
        line = _("{seconds:.0f} s  {said}", seconds=taken, said=said)
        with suppress(OSError):  # nobody has to hear it
            if is_terminal:
                print(f"\r{line[:_WIDTH]:<{_WIDTH}}", end="", file=sys.stderr, flush=True)
            else:
                print(line, file=sys.stderr, flush=True)
        is_told, next_at = True, next_at if is_terminal else 2 * next_at
    if is_terminal and is_told:
        with suppress(OSError):
            print(f"\r{'':<{_WIDTH}}", end="\r", file=sys.stderr, flush=True)
