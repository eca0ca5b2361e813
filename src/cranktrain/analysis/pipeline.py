"""The pipeline read as a page: what a machine file declares, and stages in the order in which they run."""

from collections.abc import Iterable, Iterator, Sequence
from textwrap import wrap
from typing import NamedTuple

from cranktrain.language import Words
from cranktrain.language import said as _
from cranktrain.record import record
from cranktrain.saying.catalogue import Entry
from cranktrain.saying.run import BehindQuantity


class Place(NamedTuple):
    """Where code stands: the file in the package, and the line."""

    file: str
    line: int

    def __str__(self) -> str:
        """Name both, as editors open them."""
        return f"{self.file}:{self.line}"


@record
class PartBehind:
    """What the machine file declares of one subject.

    Attributes
    ----------
    name, sentence : str
        Of its class, as its docstring says.
    place : Place
    tables : tuple of str
        Of the machine file of which it is made: of the machine that is asked about those that it has.
    """

    name: str
    sentence: Words
    place: Place
    tables: tuple[str, ...]


@record
class StageBehind:
    """A stage on the way.

    Attributes
    ----------
    name, sentence : str
        Of its function, as its docstring says.
    place : Place
    gives, word : str
        The class of what it gives, and whether that is a `result`, a `calculator` or a `hand-over`.
    takes : tuple of str
        Classes of what it goes on from, parts and what earlier stages give.
    tables : tuple of str
        Of the machine file of which its own parts are made.
    sources : tuple of str
        What its docstring cites, as `docs/theory/gas, eq. (14.8)`; if that is nothing, what those of its
        quantities are.
    """

    name: str
    sentence: Words
    place: Place
    gives: str
    word: str
    takes: tuple[str, ...]
    tables: tuple[str, ...]
    sources: tuple[str, ...]


@record
class Pipeline:
    """What leads to a quantity, read as a page.

    Attributes
    ----------
    entry : Entry
        The quantity as the catalogue has it.
    declared : tuple of PartBehind
        What the stages take of the file, in the order in which they do.
    stages : tuple of StageBehind
        In the order in which they run; the last one gives the quantity.
    """

    entry: Entry
    declared: tuple[PartBehind, ...]
    stages: tuple[StageBehind, ...]

    @property
    def in_short(self) -> BehindQuantity:
        """Names of the stages, and all tables that are read."""
        tables = frozenset(table.strip("[]") for part in self.declared for table in part.tables)
        return BehindQuantity(tuple(stage.name for stage in self.stages), tables)

    def lines(self, width: int = 80) -> Iterator[str]:
        """Write it as a page.

        Parameters
        ----------
        width : int
            Columns of the screen.

        Yields
        ------
        str
        """
        yield from wrap(f"{self.entry.name} {self.entry.symbol} [{self.entry.unit}]: {self.entry.sentence}", width)
        yield from _indented((self.entry.citation,), width)
        yield from ("", _("What the machine file declares"))
        for part in self.declared:
            yield from _titled("    ", part.name, part.place, width)
            yield from _indented((str(part.sentence), *_naming(_("reads {names}"), part.tables)), width)
        yield from ("", _("Stages, in the order in which they run"))
        for number, stage in enumerate(self.stages, start=1):
            yield from _titled(f"{number:3} ", stage.name, stage.place, width)
            gives = _("gives {name}, a {word}", name=stage.gives, word=_(stage.word))
            told = (*_naming(_("takes {names}"), stage.takes), *_naming(_("reads {names}"), stage.tables))
            yield from _indented((str(stage.sentence), gives, *told, *stage.sources), width)

    def __repr__(self) -> str:
        """Say in one line what it is."""
        said = _("<Pipeline to {name}: {n_parts} parts of the file, {n_stages} stages>")
        return said.format(name=self.entry.name, n_parts=len(self.declared), n_stages=len(self.stages))

    def __str__(self) -> str:
        """Write it as a page."""
        return "\n".join(self.lines())


def _naming(sentence: str, names: Sequence[str]) -> tuple[str, ...]:
    """Name some; nothing where there is none."""
    return (sentence.format(names=", ".join(names)),) if names else ()


def _titled(begin: str, name: str, place: Place, width: int) -> list[str]:
    """Name code and say where it stands, which has a line of its own where there is no room for both."""
    title = f"{begin}{name}  {place}"
    return [title] if len(title) <= width else [begin + name, f"{' ' * 4}{place}"]


def _indented(texts: Iterable[str], width: int) -> Iterator[str]:
    """Fold texts below a head, each on lines of its own."""
    for text in texts:
        yield from wrap(text, width, initial_indent=" " * 6, subsequent_indent=" " * 8, break_long_words=False)
