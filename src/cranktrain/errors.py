"""What is wrong with an input, as data: where, what was given, what is allowed, how to mend it."""

from collections.abc import Callable, Generator, Iterable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from itertools import islice
from typing import Any, NoReturn

from cranktrain.language import Words, _
from cranktrain.one_line import one_line, short

MOST_TOLD = 50
"""So many problems of one input are told; nobody mends more at once."""

_MOST_OF_A_KIND = 10
"""Problems of one kind that are told; a file of another sort has one in every line."""
_LONGEST_PATH = 120
"""Characters of a path in a message."""


@dataclass(frozen=True)
class Position:
    """A place in a text file: line and column count from 1."""

    file: str
    line: int | None = None
    column: int | None = None

    def __str__(self) -> str:
        """Write the place as editors understand it, `file:line:column`."""
        return ":".join(str(part) for part in (self.file, self.line, self.column) if part is not None)


@dataclass(frozen=True)
class Problem:
    """One thing that is wrong with an input.

    Attributes
    ----------
    path : str
        Dotted path of the value in the machine file, e.g. `bank.R.mechanism.rod_length`; empty for the file itself.
    given : Words or None
        What was given, as the user wrote it; None where nothing was.
    allowed : Words
        What is allowed there, as a clause: "must be more than 50 mm, or the crank cannot turn".
    repair : Words or None
        What to write instead, where one thing is the likely cure.
    position : Position or None
        Where it stands.
    """

    path: str
    given: Words | None
    allowed: Words
    repair: Words | None = None
    position: Position | None = None

    def __str__(self) -> str:
        """Say it in one line, what is long cut: `file:line:column  path = given: allowed; repair`."""
        path, given = _short_path(one_line(self.path)), None if self.given is None else short(str(self.given))
        subject = path if given is None else f"{path} = {given}" if path else given
        said = ": ".join(part for part in (subject, one_line(str(self.allowed))) if part)
        place = f"{one_line(str(self.position))}  " if self.position else ""
        return place + said + (f"; {one_line(str(self.repair))}" if self.repair else "")


def _short_path(path: str) -> str:
    """Cut a long path in its middle: its end says most."""
    half = _LONGEST_PATH // 2
    return path if len(path) <= _LONGEST_PATH else f"{path[:half]}…{path[1 - half :]}"


class InputError(ValueError):
    """All that is wrong with one input, at once; what it says of itself names the first of many."""

    def __init__(self, problems: Iterable[Problem]) -> None:
        self.problems: Sequence[Problem] = tuple(problems)
        super().__init__(self.problems)

    def __reduce__(self) -> tuple[object, ...]:
        """Let it be sent to other processes, whatever its own arguments are."""
        return InputError, (self.problems,)

    def __str__(self) -> str:
        """Say each in a line, many by their number."""
        lines = [str(problem) for problem in self.problems[:MOST_TOLD]]
        if len(self.problems) > MOST_TOLD:
            lines.append(str(_("and {n} more", n=len(self.problems) - MOST_TOLD)))
        return "\n".join(lines)


def first_of(problems: Iterable[Problem], more: Callable[[int], Problem]) -> Iterator[Problem]:
    """Keep the first problems of a kind; `more` tells how many others there are."""
    each = iter(problems)
    yield from islice(each, _MOST_OF_A_KIND)
    if n_others := sum(1 for _problem in each):
        yield more(n_others)


def refuse(problems: Iterable[Problem]) -> None:
    """Raise all that is wrong with an input; nothing is done where nothing is wrong."""
    found = tuple(problems)
    if found:
        raise InputError(found)


@contextmanager
def problems_as(said: Callable[[Problem], Problem]) -> Generator[None]:
    """Say each problem that comes up within as `said` does, who knows where the user would look for it."""
    try:
        yield
    except InputError as error:
        raise InputError(map(said, error.problems)) from None


class UnreadError(LookupError):
    """Raised where a rule asks for what cannot be read: it is not judged."""


def _refuse_use(*_used: object, **_named: object) -> NoReturn:
    raise UnreadError


def _unread(*_used: object, **_named: object) -> Any:
    return UNREAD


class _Unread(type):
    """A class of which nobody can ask what a spec's says, such as its fields."""

    def __getattr__(cls, name: str) -> NoReturn:
        """Refuse to say; of what Python itself asks for, that there is none."""
        if name.startswith("__"):
            raise AttributeError(name)
        raise UnreadError


class Unread(metaclass=_Unread):
    """Stands where a file has something that cannot be read: what is made of it is unknown, who looks cannot judge."""

    __call__ = __array_ufunc__ = __neg__ = __abs__ = __eq__ = __ne__ = __lt__ = __le__ = __gt__ = __ge__ = _unread
    __add__ = __radd__ = __sub__ = __rsub__ = __mul__ = __rmul__ = __truediv__ = __rtruediv__ = _unread
    __pow__ = __rpow__ = __mod__ = __rmod__ = _unread
    __bool__ = __len__ = __iter__ = __contains__ = __getitem__ = __hash__ = _refuse_use
    __str__ = __repr__ = __format__ = __int__ = __float__ = __index__ = __array__ = _refuse_use

    def __getattr__(self, name: str) -> Any:
        """Give what it has, which cannot be read either; nothing that Python itself asks for."""
        if name.startswith("__"):
            raise AttributeError(name)
        return UNREAD


UNREAD: Any = Unread()


def judged(found: Iterable[Problem]) -> Iterator[Problem]:
    """Give what a rule finds until it asks for what cannot be read; others beside it go on."""
    try:
        yield from found
    except UnreadError:
        return
