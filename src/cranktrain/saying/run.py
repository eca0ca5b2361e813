"""One kind of run: quantities over named dimensions, and what is said of them, whatever was asked.

A cycle, a start, a comparison, a proposal, what a text states: each is a `Run`, and what writes files, makes data
frames, draws curves or fills the screen knows no other.
"""

from abc import abstractmethod
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import AbstractContextManager, nullcontext
from functools import cached_property
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.errors import InputError, Problem
from cranktrain.faces import face
from cranktrain.language import Words, _
from cranktrain.motion import Array
from cranktrain.quantities import nearest, units_asked
from cranktrain.saying.amounts import Amount
from cranktrain.saying.catalogue import Entry

if TYPE_CHECKING:
    import pandas
    import xarray

    from cranktrain.saying.rows import AnswerLine
    from cranktrain.saying.sections import PagePart


class Axis(NamedTuple):
    """What the curves of a run are over: the name of the dimension, unit and symbol, and where values stand."""

    name: str
    unit: str
    symbol: str
    values: Array


class Marks(NamedTuple):
    """Words that stand beside quantities, along some dimensions, the axis last; and what they are about."""

    dimensions: tuple[str, ...]
    texts: NDArray[np.object_]
    about: Words


class RowHeads(NamedTuple):
    """Rows of a table of facts: dimensions along which they stand, and columns that say which each of them is."""

    along: tuple[str, ...]
    columns: Mapping[str, NDArray[Any]]


class BehindQuantity(NamedTuple):
    """What leads to a quantity: names of stages as they run, tables of the file that they read; where more is said."""

    stages: tuple[str, ...]
    tables: frozenset[str]
    more: Words = ""


class Run:
    """What was asked, and what came of it.

    Every quantity of `catalogue` is an attribute: an array along its entry's dimensions, in its unit.
    """

    @property
    @abstractmethod
    def subject(self) -> Words:
        """What it is of."""

    @property
    @abstractmethod
    def catalogue(self) -> Mapping[str, Entry]:
        """What there is, by name."""

    @property
    def labels(self) -> Mapping[str, tuple[str, ...]]:
        """Keys of the members along dimensions."""
        return {}

    @property
    def titles(self) -> Mapping[str, tuple[Words, ...]]:
        """What people call the members."""
        return self.labels

    @property
    def axis(self) -> Axis | None:
        """What its curves are over; None where it has no curves."""
        return None

    @property
    def number_axes(self) -> Iterable[Axis]:
        """Dimensions whose members are numbers with a unit: the axis, and what a run has besides."""
        return () if self.axis is None else (self.axis,)

    @property
    def case_coordinates(self) -> Iterable[Axis]:
        """Numbers and words that tell the members of the first dimension apart, of a list of designs."""
        return ()

    @property
    def cycle(self) -> float:
        """At which crank angle all begins again; infinity where it does not. [deg]"""
        return np.inf

    @property
    def n_designs(self) -> int | None:
        """How many designs its arrays have along a leading dimension; None where they have no such dimension."""
        return None

    @property
    def wanted(self) -> Iterable[str]:
        """Names of what was asked for."""
        return self.catalogue

    def about(self) -> Iterable[tuple[str, Words]]:
        """What heads a file of it: words, by what they are about."""
        return ()

    def before(self) -> Mapping[str, object]:
        """What a .json has before its numbers, as JSON has it."""
        return {word: str(words) for word, words in self.about()}

    def after(self) -> Mapping[str, object]:
        """What a .json has behind its numbers: checks, flags, events; as JSON has it."""
        return {}

    def attributes(self) -> Mapping[str, object]:
        """What a dataset says of it as a whole."""
        return {"name": str(self.subject)}

    @property
    def marks(self) -> Mapping[str, Marks]:
        """Words beside its quantities, by name: flags of designs."""
        return {}

    @property
    def design_rows(self) -> RowHeads | None:
        """Of which its facts are, where a table has a row for each; None where they stand one below the other."""
        return None

    def needs_of(self, *_quantities: str) -> tuple[Words, ...]:
        """What quantities that are missing would need."""
        return ()

    def in_its_units(self) -> AbstractContextManager[None]:
        """Show numbers in the units that it has of its own, as far as nobody chose others."""
        return nullcontext()

    def is_curve(self, entry: Entry) -> bool:
        """Whether a quantity is over the axis."""
        return self.axis is not None and self.axis.name in entry.dimensions

    def labels_of(self, entry: Entry) -> dict[str, tuple[str, ...]]:
        """Keys along each dimension of a quantity, but for the axis."""
        over = None if self.axis is None else self.axis.name
        return {dimension: self.labels[dimension] for dimension in entry.dimensions if dimension != over}

    def titles_of(self, entry: Entry) -> dict[str, tuple[str, ...]]:
        """What people here and now call the members along each dimension of a quantity, but for the axis."""
        return {dimension: tuple(map(str, self.titles[dimension])) for dimension in self.labels_of(entry)}

    def answer_rows(self) -> "Iterable[tuple[Words, Sequence[AnswerLine]]]":
        """Lines of its answer, under their titles; none where it has no answer of words."""
        return ()

    def sections(self) -> "Iterable[PagePart]":
        """What is shown of it: its facts, and at how many places its curves stand, unless it says more."""
        from cranktrain.saying.sections import Column, Grid, Rows, section  # an answer needs none

        single = [name for name, entry in self.catalogue.items() if not entry.dimensions]
        cells = [
            (entry.sentence, entry.symbol, Amount(float(getattr(self, name)), entry.shown, name))
            for name in single
            for entry in (self.catalogue[name],)
        ]
        yield from section(_("Facts"), [Rows(cells, right=(2,), is_folded=False)] if cells else [])
        for name, entry in self.catalogue.items():
            labels = self.labels_of(entry)
            if labels and not self.is_curve(entry):
                values = np.reshape(getattr(self, name), (-1, len(self.labels[entry.dimensions[-1]])))
                columns = [Column(entry.symbol, row.tolist(), entry.shown, "amounts", name) for row in values]
                yield from section(entry.sentence, [Grid(columns, self.titles[entry.dimensions[-1]])])
        curves = [name for name, entry in self.catalogue.items() if self.is_curve(entry)]
        if curves and self.axis is not None:
            said = _("{curves}, at {n} places", curves=", ".join(curves), n=len(self.axis.values))
            yield from section(_("Curves over {axis}", axis=self.axis.name), [said])

    def page(self, width: int = 80) -> str:
        """Write all that is shown of it as text, in a width of columns."""
        with self.in_its_units():
            return "\n".join(line.plain.rstrip() for line in face("page_lines")(self.sections(), width))

    def why(self, name: str) -> Iterator[Words]:
        """Where a quantity is from: what it is, its equation, and in symbols where it is a line of others."""
        if name not in self.catalogue:
            meant = nearest(name, list(self.catalogue))
            repair = _('write "{text}"', text=meant) if meant else _("`catalogue` names all")
            raise InputError([Problem("why", name, _("is no quantity of this run"), repair)])
        entry = self.catalogue[name]
        yield f"{entry.symbol or entry.name} [{entry.unit}]: {entry.sentence}"
        yield entry.citation
        if line := entry.in_symbols(self.catalogue):
            yield line

    def behind(self, _name: str) -> BehindQuantity | None:
        """What leads to a quantity in the machine; None where no stages do."""
        return None

    @property
    def dataset(self) -> "xarray.Dataset":
        """Give the quantities that were asked for, or all, as an xarray dataset with what the catalogue says of them.

        In SI and degrees unless a table [units] of the machine, or `ct.units`, asks for other units. xarray comes with
        `pip install 'cranktrain[dataset]'`.
        """
        with self.in_its_units():
            units = tuple(units_asked().items())
            if units not in self._datasets:
                self._datasets[units] = face("dataset_of")(self)
        return self._datasets[units]

    @cached_property
    def _datasets(self) -> "dict[object, xarray.Dataset]":
        """Datasets that were made, by the units that were asked for."""
        return {}

    def curves(self, *quantities: str, design: int = 0, of_each_method: bool = False) -> "pandas.DataFrame":
        """Give curves as a data frame, a row for each place of the axis.

        Parameters
        ----------
        *quantities : str
            Names of curves; all but those by methods that are there to be compared unless given.
        design : int
            Which of several designs.
        of_each_method : bool
            Whether by each method; else by the one that is meant where none is named.

        Returns
        -------
        pandas.DataFrame
            Its columns are called by quantity and by whose it is: `result.curves()["piston_force"]["1L"]`; its
            `attrs["units"]` has their units, SI unless others were asked for. `pip install 'cranktrain[dataset]'`.
        """
        with self.in_its_units():
            return face("curves_frame")(self, quantities, design=design, of_each_method=of_each_method)

    def facts_table(self, *, design: int = 0) -> "pandas.DataFrame":
        """Give the facts of one machine as a data frame: quantity, of, value, unit, meaning."""
        with self.in_its_units():
            return face("facts_frame")(self, design=design)

    def plot(self, *quantities: str, design: int = 0, **members: Any) -> Any:
        """Draw curves over the axis.

        Parameters
        ----------
        *quantities : str
            Names of curves; the main ones unless given.
        design : int
            Which of several designs.
        **members : str or sequence of str
            Whose, by dimension: `piston="1R"`, `joint=["1L.guide", "1R.guide"]`; the first few unless given.

        Returns
        -------
        matplotlib.figure.Figure

        Raises
        ------
        InputError
            Where there is no such curve, or member.
        """
        with self.in_its_units():
            return face("plot_run")(self, *quantities, design=design, **members)
