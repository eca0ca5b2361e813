"""Words for people, in the language of whoever reads them: every string that a user reads passes through here."""

import gettext
from abc import ABC, abstractmethod
from collections.abc import Callable, Generator, Iterable, Mapping, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from typing import TypeAlias

_chosen: ContextVar[str | None] = ContextVar("chosen language", default=None)
"""None for that of the surroundings, `LANGUAGE` or `LANG`."""
_LOCALE = Path(__file__).parent / "locale"
_DOMAIN = "cranktrain"
_OF_THE_CODE = "en"


@contextmanager
def in_language(language: str | None) -> Generator[None]:
    """Say words in a language for a while, such as `ru`, or in that of the surroundings: here, not in other threads."""
    token = _chosen.set(language)
    try:
        yield
    finally:
        _chosen.reset(token)


def chosen_language() -> str | None:
    """Which language words are said in here: what is kept of them is kept for it alone."""
    return _chosen.get()


def languages() -> tuple[str, ...]:
    """Languages that there are words in: that of the code, and those that it is translated to."""
    found = _LOCALE.glob(f"*/LC_MESSAGES/{_DOMAIN}.mo")
    return (_OF_THE_CODE, *sorted(path.parts[-3] for path in found))


def spoken_language() -> str:
    """In which of these words are said in here."""
    language = _chosen.get()
    found = gettext.find(_DOMAIN, _LOCALE, None if language is None else [language])
    return _OF_THE_CODE if found is None else Path(found).parts[-3]


@cache
def _catalogue(language: str | None) -> gettext.NullTranslations:
    """Words of a language; those of the code where there are none."""
    asked = None if language is None else [language]
    return gettext.translation(_DOMAIN, _LOCALE, asked, fallback=True)


class Said(ABC):
    """Words that are said when they are read, in the language and the units of whoever reads them then."""

    __slots__ = ()

    def __str__(self) -> str:
        """Say them."""
        return self.said(lambda piece: piece)

    def __repr__(self) -> str:
        """Show them as a text is shown."""
        return repr(str(self))

    @abstractmethod
    def said(self, say: Callable[[object], object]) -> str:
        """Say them with what `say` makes of each of their pieces."""

    def each(self) -> Iterable[object]:
        """Give what they are made of."""
        return ()


Words: TypeAlias = Said | str
"""What is said, or a text of the file, of a user, of another program, which stays as it is."""


@dataclass(frozen=True, slots=True, repr=False)
class Message(Said):
    """A message with its pieces.

    Attributes
    ----------
    text : str
        As it is given to translators, `{name}` in it standing for a piece.
    pieces : mapping of str to object
        What is not `Said` is written as it is.
    """

    text: str
    pieces: Mapping[str, object] = field(default_factory=dict[str, object])

    def __hash__(self) -> int:
        """Tell messages apart by their pieces, too: of a thousand designs each may have its own numbers."""
        try:
            return hash((self.text, frozenset(self.pieces.items())))
        except TypeError:  # a piece that cannot be hashed
            return hash(self.text)

    def said(self, say: Callable[[object], object]) -> str:
        """Say it with what `say` makes of each of its pieces."""
        translated = _catalogue(_chosen.get()).gettext(self.text) if self.text else ""
        pieces = {name: say(piece) for name, piece in self.pieces.items()}
        return translated.format(**pieces) if pieces else translated

    def each(self) -> Iterable[object]:
        """Give its pieces."""
        return self.pieces.values()

    def format(self, **pieces: object) -> "Message":
        """Give it with more pieces."""
        return Message(self.text, {**self.pieces, **pieces})


@dataclass(frozen=True, slots=True, repr=False)
class Listed(Said):
    """Parts one behind the other.

    Attributes
    ----------
    parts : sequence of Words
    between : str
        Stands between them.
    """

    parts: Sequence[Words]
    between: str = ", "

    def __post_init__(self) -> None:
        """Keep what nobody changes."""
        object.__setattr__(self, "parts", tuple(self.parts))

    def __bool__(self) -> bool:
        """Whether there is anything to say."""
        return any(self.parts)

    def said(self, say: Callable[[object], object]) -> str:
        """Say one after the other."""
        return self.between.join(str(say(part)) for part in self.parts)

    def each(self) -> Iterable[object]:
        """Give its parts."""
        return self.parts


def _(message: str, /, **pieces: object) -> Message:
    """Give a message that is said in the reader's language when it is read, `{name}` in it standing for a piece.

    Examples
    --------
    >>> str(_("{first} and {last}", first="1L", last="6L"))
    '1L and 6L'
    """
    return Message(message, pieces)


def said(message: str, /, **pieces: object) -> str:
    """Say a message in the reader's language, `{name}` in it standing for a piece: for those who show it.

    Examples
    --------
    >>> said("{first} and {last}", first="1L", last="6L")
    '1L and 6L'
    """
    return str(Message(message, pieces))


def N_(message: str) -> str:  # noqa: N802 - the name that gettext's tools look for
    """Mark a message for translation where it is declared; it is translated where it is shown."""
    return message
