"""What is shown, as data: sections of sentences, of rows of words, of numbers in columns; whoever shows it says it.

Nothing here knows of a screen: how wide it is, where it folds, what is bold. Numbers are numbers, and words are said
when they are read, in the units and the language of whoever reads them.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Literal, NamedTuple, Protocol, TypeAlias

from cranktrain.language import Words
from cranktrain.record import record
from cranktrain.saying.catalogue import Entry
from cranktrain.saying.rows import AnswerLine

Value: TypeAlias = "float | Words"
"""A cell of a column: a number, or words, which stay as they are; none are an empty cell."""


class Decimals(NamedTuple):
    """How numbers are written that are in the column's unit already.

    n: so many decimals. least: what is larger than this has as many as show a figure of it.
    """

    n: int
    least: float = float("inf")


How: TypeAlias = Literal["figure", "percent", "amounts"] | Decimals
"""How a column's numbers are written.

figure: SI values, each as `wording.figure` has it; percent: parts of 1, small ones with two figures; amounts: values of
the catalogue, as `amounts.figures` has them, in a unit for all.
"""


@record
class Column:
    """Numbers below one another.

    Attributes
    ----------
    head : Words
        Often a symbol.
    values : sequence of Value
    unit : str
        In which they are shown; of amounts that of the catalogue. Of words alone it stays as it is.
    how : How
    quantity : str
        Name in the catalogue of what they are, if they are of one.
    symbol : Words
        By which the legend names that, once for all columns of it; the head unless given.
    """

    head: Words
    values: Sequence[Value]
    unit: str = ""
    how: How = "figure"
    quantity: str = ""
    symbol: Words = ""


@record
class Grid:
    """Columns beside one another, as many as there is room for, the others below.

    Attributes
    ----------
    columns : sequence of Column
    labels : sequence of Words
        Before the rows.
    title : Words
        Above the labels.
    words : sequence of Words
        Sentences of the rows: behind the numbers, or below each row that has a label, too.
    names_quantities : bool
        Whether the quantities are named below; then units have a row even where none has one.
    """

    columns: Sequence[Column]
    labels: Sequence[Words] = ()
    title: Words = ""
    words: Sequence[Words] = ()
    names_quantities: bool = False


@record
class Rows:
    """Words in rows, with or without heads.

    Attributes
    ----------
    cells : sequence of sequence of Words
    heads : sequence of Words
    right : sequence of int
        Columns that stand to the right.
    is_folded : bool
        Whether the last column may be folded; what is to be copied may not.
    cut : int, optional
        A column that is cut where there is no room.
    like : sequence of Words
        First cells elsewhere, with which these have one width.
    """

    cells: Sequence[Sequence[Words]]
    heads: Sequence[Words] = ()
    right: Sequence[int] = ()
    is_folded: bool = True
    cut: int | None = None
    like: Sequence[Words] = ()


@dataclass(frozen=True, slots=True)
class Unfolded:
    """Words that stay in one line, so that they can be copied; or the head of what follows."""

    words: Words
    is_head: bool = False


@dataclass(frozen=True, slots=True)
class Command:
    """A command and what it shows; where it has no room in a line, other words stand for it."""

    typed: str
    shows: Words
    instead: Words


@dataclass(frozen=True, slots=True)
class Failure:
    """A paragraph on what does not hold."""

    words: Words


class HasFacts(Protocol):
    """A catalogue of facts, whose values are attributes, in the units of their entries."""

    @property
    def catalogue(self) -> Mapping[str, Entry]:
        """What there is, by name."""
        ...

    @property
    def cycle(self) -> float:
        """At which crank angle all begins again; infinity where it does not. [deg]"""
        ...

    def titles_of(self, entry: Entry) -> dict[str, tuple[str, ...]]:
        """What people call the members along each dimension of a quantity."""
        ...


@dataclass(frozen=True, slots=True)
class FactTables:
    """Facts by name: members that are alike share a column, as there is room."""

    of: HasFacts
    names: Sequence[str]


class ComparedFact(NamedTuple):
    """A fact of two beside each other: what it is; both values, NaN for none, in the unit; and in percent of the first.

    The unit is that of the catalogue; percent is NaN where it would say nothing.
    """

    name: Words
    unit: str
    first: float
    second: float
    percent: float


@record
class Compared:
    """Facts of two beside each other, and by how much they differ.

    Attributes
    ----------
    heads : tuple of two Words
        What the two are called.
    groups : sequence of (Words, sequence of ComparedFact)
        Under their titles.
    """

    heads: tuple[Words, Words]
    groups: Sequence[tuple[Words, Sequence[ComparedFact]]]


Part: TypeAlias = "Grid | Rows | Unfolded | Command | Failure | FactTables | Words"
"""Of a section; words are a paragraph, none of them an empty line."""


@record
class ShownSection:
    """Parts under a heading.

    Attributes
    ----------
    heading : Words
        None of what follows at once.
    parts : sequence of Part
        None of a heading for the sections behind it.
    """

    heading: Words
    parts: Sequence[Part] = ()


@dataclass(frozen=True, slots=True)
class Answer:
    """Lines of the answer in groups under their titles, in common columns."""

    groups: Sequence[tuple[Words, Sequence[AnswerLine]]]


PagePart: TypeAlias = "ShownSection | Answer | Compared | Words"
"""Of a page, after an empty line; words stand alone."""


def section(heading: Words, parts: Iterable[Part]) -> Iterator[ShownSection]:
    """Give a section, if there is anything in it.

    Examples
    --------
    >>> [one.parts for one in section("Mind", ["all"])], list(section("Mind", []))
    ([('all',)], [])
    """
    if found := tuple(parts):
        yield ShownSection(heading, found)
