"""Facts and sentences of designs as arrays of a store, and read from there when they are asked for."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import cached_property, partial
from typing import Any, ClassVar, Generic, TypeVar, overload

import numpy as np
from numpy.typing import NDArray

from cranktrain.errors import Problem
from cranktrain.motion import Array
from cranktrain.saying.catalogue import Entry
from cranktrain.study.facts_of_rows import FactsOfRows
from cranktrain.study.sweep import Sweep
from cranktrain.study.sweep.kept import stopped

Item = TypeVar("Item")


class TextsOfDesigns:
    """What is said of each design, as arrays of texts; and its status, a number."""

    STATUS: ClassVar = "status"
    REFUSED: ClassVar = "refused"
    PATH: ClassVar = "refused_path"
    GIVEN: ClassVar = "refused_given"
    FAILING: ClassVar = "failing"
    ENDED: ClassVar = "ended"
    FLAGS: ClassVar = "flags"
    NOT_COMPUTED, COMPUTED, CANNOT_BE, FAILS = range(4)

    @classmethod
    def arrays(cls) -> dict[str, tuple[str, dict[str, object]]]:
        """Names, kinds and attributes of the arrays."""
        meanings = "not_computed computed cannot_be does_not_hold_a_check"
        said = {
            cls.REFUSED: "What is wrong with a design that cannot be",
            cls.PATH: "Where in the machine file that is",
            cls.GIVEN: "What was given there",
            cls.FAILING: "Which check does not hold",
            cls.ENDED: "Why a start ended",
            cls.FLAGS: "What is to be minded, a line for each",
        }
        return {
            cls.STATUS: ("u1", {"long_name": "Status", "flag_values": [0, 1, 2, 3], "flag_meanings": meanings}),
            **{name: ("str", {"long_name": sentence}) for name, sentence in said.items()},
        }

    @classmethod
    def of(cls, found: FactsOfRows) -> Iterator[tuple[str, list[str]]]:
        """Give the texts of designs by the names of arrays."""
        refused = found.refused
        yield cls.REFUSED, ["" if one is None else str(one.allowed) for one in refused]
        yield cls.PATH, ["" if one is None else one.path for one in refused]
        yield cls.GIVEN, ["" if one is None or one.given is None else str(one.given) for one in refused]
        yield cls.FAILING, list(map(str, found.failing))
        yield cls.ENDED, list(map(str, found.ended))
        yield cls.FLAGS, ["\n".join(map(str, flags)) for flags in found.flags]

    @classmethod
    def status(cls, found: FactsOfRows) -> NDArray[np.uint8]:
        """Status of designs that were computed."""
        each = zip(found.refused, found.failing, strict=True)
        said = [cls.CANNOT_BE if one is not None else cls.FAILS if words else cls.COMPUTED for one, words in each]
        return np.array(said, dtype=np.uint8)


class StoredFacts:
    """Facts of all designs of a store."""

    def __init__(
        self, group: Any, sweep: Sweep, entries: Mapping[str, Entry], labels: Mapping[str, tuple[str, ...]]
    ) -> None:
        self._group, self._sweep, self._entries, self._labels = group, sweep, entries, labels

    def as_facts(self) -> FactsOfRows:
        """Give them as a sweep takes them."""
        n_designs = len(self._sweep.designs)
        refused = Later(n_designs, self._refused)
        failing, ended = (
            Later(n_designs, partial(self._texts, name)) for name in (TextsOfDesigns.FAILING, TextsOfDesigns.ENDED)
        )
        flags = Later(
            n_designs, lambda: [tuple(filter(None, text.split("\n"))) for text in self._texts(TextsOfDesigns.FLAGS)]
        )
        values = StoredValues(tuple(self._entries), self.flat)
        return FactsOfRows(dict(self._entries), dict(self._labels), values, refused, failing, ended, flags)

    def flat(self, name: str) -> Array:
        """Read an array, shape (design, …)."""
        values: Any = self._group[name][:]
        shape, over = self._sweep.shape, self._sweep.over
        apart = values if over is None else np.moveaxis(values, -1, over)
        return np.reshape(apart, (len(self._sweep.designs), *apart.shape[len(shape) :]))

    def _texts(self, name: str) -> list[str]:
        return [str(text) for text in self.flat(name).tolist()]

    def _refused(self) -> list[Problem | None]:
        """What is wrong with designs; of one that is not computed, and nothing else is said of it, that."""
        found: list[Problem | None] = [None] * len(self._sweep.designs)
        status = self.flat(TextsOfDesigns.STATUS)
        wrong = np.flatnonzero((status == TextsOfDesigns.CANNOT_BE) | (status == TextsOfDesigns.NOT_COMPUTED)).tolist()
        if wrong:
            texts, paths, given = map(self._texts, (TextsOfDesigns.REFUSED, TextsOfDesigns.PATH, TextsOfDesigns.GIVEN))
            for place in wrong:
                is_said = bool(texts[place])
                found[place] = (
                    Problem(paths[place], given[place] or None, texts[place])
                    if is_said
                    else Problem("", None, stopped())
                )
        return found


class Later(Sequence[Item], Generic[Item]):
    """Items that are read when one of them is asked for."""

    def __init__(self, size: int, read: Callable[[], Sequence[Item]]) -> None:
        self._size, self._read = size, read

    @cached_property
    def _items(self) -> Sequence[Item]:
        return self._read()

    @overload
    def __getitem__(self, place: int) -> Item: ...
    @overload
    def __getitem__(self, place: slice) -> Sequence[Item]: ...
    def __getitem__(self, place: int | slice) -> Item | Sequence[Item]:
        return self._items[place]

    def __len__(self) -> int:
        return self._size


class StoredValues(Mapping[str, Array]):
    """Arrays by name, read each time that one is asked for: they may be larger than memory together."""

    def __init__(self, names: tuple[str, ...], read: Callable[[str], Array]) -> None:
        self._names, self._read = names, read

    def __getitem__(self, name: str) -> Array:
        if name not in self._names:
            raise KeyError(name)
        return self._read(name)

    def __contains__(self, name: object) -> bool:
        return name in self._names

    def __iter__(self) -> Iterator[str]:
        return iter(self._names)

    def __len__(self) -> int:
        return len(self._names)
