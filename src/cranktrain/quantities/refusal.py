"""How a wrong word or value is refused: with what is allowed, and what was probably meant."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass

from cranktrain.errors import InputError, Problem
from cranktrain.language import Said, Words, _

_LONGEST_WORD = 100
"""Characters; what is longer was meant to be no word of ours."""
_SLIP, _AS_LIKE = 0.85, 0.05
"""Likeness, of which 1 is the same, from which a word is another's slip of the pen; and by how much less is as like."""


@dataclass(frozen=True, slots=True, repr=False)
class Instead(Said):
    """What to write instead of a value: one text, or either of two."""

    texts: tuple[str, ...]

    def said(self, say: Callable[[object], object]) -> str:
        """Say it."""
        return self._message.said(say)

    def each(self) -> Iterable[object]:
        """Give what it is made of."""
        return self._message.each()

    @property
    def _message(self) -> Said:
        if len(self.texts) == 1:
            return _('write "{text}"', text=self.texts[0])
        one, other = self.texts
        return _('write "{one}" or "{other}"', one=one, other=other)


class QuantityError(InputError):
    """A text that is not the quantity asked for: what was given, what is allowed, what to write instead."""

    def __init__(self, given: Words | None, allowed: Words, repair: Words | None = None) -> None:
        super().__init__((Problem("", given, allowed, repair),))


def written(given: object) -> str | None:
    """A value nearly as the user wrote it; None for a table or a list."""
    match given:
        case bool():
            return "true" if given else "false"
        case int() | float():
            return str(given)
        case str():
            return given if given.strip() else f'"{given}"'
        case _:
            return None


def nearest(word: str, known: Iterable[str]) -> str | None:
    """Find the known word that differs in letter case only, or else is most like it.

    None where none is like it, and where another is nearly as like: which of them is meant nobody knows.
    """
    import difflib  # only needed after a mistake

    if len(word) > _LONGEST_WORD:
        return None
    words = list(dict.fromkeys(known))
    same = [candidate for candidate in words if candidate.casefold() == word.casefold()]
    if same:
        return same[0]
    like = difflib.get_close_matches(word, words, n=2)
    likeness = [difflib.SequenceMatcher(None, one, word).ratio() for one in like]
    is_doubtful = len(like) > 1 and likeness[0] < _SLIP and likeness[0] - likeness[1] < _AS_LIKE
    return like[0] if like and not is_doubtful else None


NOWHERE: Mapping[str, str] = {}
"""Of words that nobody writes for others."""


def one_of(listed: Iterable[object]) -> Words:
    """Say which words are allowed."""
    return _("must be one of: {values}", values=", ".join(str(written(value)) for value in listed))


def unlisted(path: str, given: object, listed: Sequence[object], elsewhere: Mapping[str, str] = NOWHERE) -> Problem:
    """Refuse a value that is not of a list; `elsewhere`: what others call it, and what is written for that."""
    meant = nearest(given, [str(value) for value in listed]) if isinstance(given, str) else None
    repair = _written_for(given, elsewhere) or (Instead((meant,)) if meant else None)
    return Problem(path, written(given), one_of(listed), repair)


def _written_for(word: object, elsewhere: Mapping[str, str]) -> Words | None:
    """Say what is written for a word of books."""
    what = elsewhere.get(word) or elsewhere.get(word.lower()) if isinstance(word, str) else None
    return None if what is None else _("write {what}", what=what)


def unknown_key(
    path: str, key: str, given: object, known: Sequence[str], elsewhere: Mapping[str, str] = NOWHERE
) -> Problem:
    """Refuse a key that the table at a path does not have; a long list of keys is not told.

    elsewhere: keys by which books and other programs say something, and what is written for them here.
    """
    if (repair := _written_for(key, elsewhere)) is not None:
        return Problem(path, written(given), _("is not a key of this table"), repair)
    meant = nearest(key, known)
    allowed = _("is not a key of this table")
    if 0 < len(known) <= 16:
        allowed = _("is not a key of this table, whose keys are: {keys}", keys=", ".join(known))
    return Problem(path, written(given), allowed, _("did you mean {key}?", key=meant) if meant else None)
