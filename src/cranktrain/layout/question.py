"""What a question is made of: tables that it reads and uses, what it makes of them, and how its results are told."""

import inspect
import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import field, fields
from functools import cache, cached_property
from types import NoneType
from typing import Any, NamedTuple, TypeAlias, get_args, get_origin, get_type_hints

from cranktrain.errors import Problem
from cranktrain.language import N_, Words
from cranktrain.layout.design import Design, Designs
from cranktrain.record import record
from cranktrain.saying.catalogue import entries
from cranktrain.saying.checks import Checked, Flagged
from cranktrain.saying.labels import Titles, titled
from cranktrain.saying.rows import AnswerLine

Parts: TypeAlias = dict[type, object]
"""What machines declare, as SI arrays with a leading design axis: one object of each type."""

Written = Callable[[Design], Sequence[str]]
"""Which of some tables or keys the file of a design has, as they are written there."""


def _nothing(_of: Any, _known: object = None) -> tuple[()]:
    """Of a question that asks for nothing of its kind."""
    return ()


def _always(_needs: object, _design: object) -> bool:
    """Of a question that may be asked of any machine."""
    return True


_NO_NEEDS = ("return", "of", "labels", "design")
"""What is returned, and which of a result is asked for."""


def _hints(function: Callable[..., Any]) -> Mapping[str, Any]:
    """Give its annotations; only those that are texts have to be read."""
    annotations: Mapping[str, Any] = {} if isinstance(function, type) else getattr(function, "__annotations__", {})
    is_read = annotations and not any(isinstance(one, str) for one in annotations.values())
    return annotations if is_read else get_type_hints(function)


class Needs(NamedTuple):
    """What the parameters of a function ask for: types by name, and which of them may be absent."""

    types: Mapping[str, type]
    optional: frozenset[str]

    @property
    def required(self) -> frozenset[type]:
        """Types of those that may not."""
        return frozenset(need for name, need in self.types.items() if name not in self.optional)


@cache
def needs_of(function: Callable[..., Any]) -> Needs:
    """Read needs from annotations, but for which design is meant; one that is `X | None` may be absent."""
    hints = {name: hint for name, hint in _hints(function).items() if name not in _NO_NEEDS}
    choices = {name: [one for one in get_args(hint) if one is not NoneType] for name, hint in hints.items()}
    optional = frozenset(name for name, hint in hints.items() if NoneType in get_args(hint))
    return Needs({name: choices[name][0] if name in optional else hint for name, hint in hints.items()}, optional)


RESULT, CALCULATOR, HAND_OVER = N_("result"), N_("calculator"), N_("hand-over")
"""What a stage gives: what people read; what later stages ask, as functions; or what they go on from, as arrays."""


def _can_be_asked(outcome: type) -> bool:
    """Whether it has functions that take something, among its fields or its methods."""
    if any(get_origin(hint) is Callable for hint in get_type_hints(outcome).values()):
        return True
    methods = (method for name, method in inspect.getmembers(outcome, inspect.isfunction) if not name.startswith("_"))
    return any(set(inspect.signature(method).parameters).difference(("self", *_NO_NEEDS)) for method in methods)


def tables_of(part: type) -> tuple[str, ...]:
    """Tables of the machine file of which a part is made: of what it `needs`, and what it says that it `reads`."""
    return tuple(dict.fromkeys((*re.findall(r"\[[^]]+\]", getattr(part, "needs", "")), *getattr(part, "reads", ()))))


NOT_FOR_IT = ""
"""Among what a file would have to say: nothing that it could say would help."""

Applies: TypeAlias = bool | str | tuple[str, ...]
"""Whether a step is for a machine, or what the file would have to say."""


@record
class Stage:
    """One step of the computation: a function whose parameter types are its needs and whose return type is its result.

    A class whose fields are just what the step needs is such a function.

    Attributes
    ----------
    function : callable
    applies : callable, optional
        Whether the step is for this machine, by parts that its parameters name as those of `function` do: True; False,
        and then nobody misses what it would give; or what the file would have to say.
    beside : tuple of type
        Needs that may be absent, and are wherever nothing else asks for them: it takes what there is.
    refuses : bool
        Whether it may find a machine wrong, and raise an `InputError`: it is run at once, not when somebody reads it.
    """

    function: Callable[..., Any]
    applies: Callable[..., Applies] | None = None
    beside: tuple[type, ...] = ()
    refuses: bool = False

    @cached_property
    def gives(self) -> type:
        """Type of the result."""
        return self.function if isinstance(self.function, type) else _hints(self.function)["return"]

    @cached_property
    def word(self) -> str:
        """Whether it gives a result, with quantities or with checks and flags alone; a calculator; or a hand-over."""
        beside = (held.name for kind in (Checked, Flagged) for held in fields(kind))
        own = {held.name for held in fields(self.gives)}.difference(beside)
        if entries(self.gives) or not own:
            return RESULT
        return CALCULATOR if _can_be_asked(self.gives) else HAND_OVER

    @cached_property
    def needs(self) -> Mapping[str, type]:
        """Type of every parameter."""
        return needs_of(self.function).types

    @property
    def optional(self) -> frozenset[str]:
        """Parameters that may be None: never reported as missing."""
        return needs_of(self.function).optional

    @cached_property
    def outcome(self) -> str:
        """Name of the class of what it gives."""
        return self.gives.__name__

    @cached_property
    def results(self) -> tuple[str, ...]:
        """Names of the quantities that it gives."""
        return tuple(entry.name for entry in entries(self.gives))

    @cached_property
    def lacks(self) -> Mapping[str, str]:
        """What it cannot do without, by the names of classes: what the file would have to say, where that gives it."""
        return {
            need.__name__: getattr(need, "needs", NOT_FOR_IT)
            for name, need in self.needs.items()
            if name not in self.optional
        }

    @cached_property
    def wanted(self) -> frozenset[type]:
        """Types for which other stages are run."""
        return frozenset(self.needs.values()).difference(self.beside)

    @cached_property
    def required(self) -> frozenset[type]:
        """Types without which it cannot run."""
        return needs_of(self.function).required

    def applies_to(self, parts: Mapping[type, object]) -> Applies:
        """Say whether it applies to a machine of some parts; where it asks for one that is not there, it does not."""
        if self.applies is None:
            return True
        asked, given = needs_of(self.applies), dict[str, object]()
        for name, kind in asked.types.items():
            given[name] = parts.get(kind)
            if given[name] is None and name not in asked.optional:
                return False
        return self.applies(**given)


class ResultDimension(NamedTuple):
    """A dimension of results.

    Attributes
    ----------
    name : str
    title : str
        What one of its members is called, in the user's language where it is a number.
    is_number : bool
        Whether its members are numbers, by which they are asked for: `sel(order=6)`.
    family : str
        Of dimensions whose members are called alike, as a piston and its chamber: their facts share a table.
    own : int, optional
        Of a dimension whose members are rivals, each another answer to one question, as methods are: the place of the
        one that is meant where none is named. No table takes anything over them all.
    is_apart : bool
        Whether each member is of its own size, as modes are: nothing is rounding beside what is of another.
    is_asked : bool
        Whether the file asks for its members one by one: then all that there is of them is shown in full.
    is_compared : bool
        Whether its rivals are there to be compared: that which is meant is a quantity of its own.
    titles : Titles
        What people call members whose labels are keys of the program; all others are called by their labels.
    """

    name: str
    title: str
    is_number: bool = False
    family: str = ""
    own: int | None = None
    is_apart: bool = False
    is_asked: bool = False
    is_compared: bool = False
    titles: Titles = {}  # noqa: RUF012 - nobody changes them

    def called(self, labels: Sequence[str]) -> tuple[Words, ...]:
        """What people call some members."""
        return tuple(titled(self.titles, label) for label in labels)


class Use(NamedTuple):
    """What a table of the file is for.

    Attributes
    ----------
    tables : callable
        The names that it has in a machine's file, as the file has them: `[gas]`.
    results : tuple of type
        That show that it is used.
    instead : type, optional
        A result that there is without it, and of which `consequence` says what it lacks then, as a clause.
    consequence : str
    """

    tables: Callable[[Design], Sequence[str]]
    results: tuple[type, ...]
    instead: type | None = None
    consequence: str = ""


ANY_NAME = "*"
"""In the path of a table, for those of all names."""


class TableFile(NamedTuple):
    """A table of the machine file that names a file: its path, its `kind` where only one has a file, what this is.

    `ANY_NAME` in the path stands for every name.
    """

    table: tuple[str, ...]
    kind: str | None
    noun: str


@record
class Question:
    """A question that an engineer asks of a machine.

    Attributes
    ----------
    name : str
        Of its folder.
    tables : mapping of str to type
        Its tables of the machine file by key, or the type of what stands under that key by name.
    problems : callable
        What only the tables together show to be wrong, in one design.
    parts : callable
        What the tables of all designs declare, as arrays; the parts that are known by then come as well. None in it
        stands for what is not declared.
    stages : tuple of Stage
        In the order in which people read their results.
    over_time : callable
        The stages that only a start asks, loaded then: what they give is over the time. Several may give one thing; of
        these one applies.
    dimensions : tuple of ResultDimension
        That its results bring.
    headline : tuple of str
        Its facts that say most, the first first.
    title : str
        Of its rows.
    rows : tuple of callable (of, …) → rows
        Its lines of the answer: a `Telling` of one design, and by their types the results that they say, as stages ask
        for them.
    offers : mapping of str to str
        Of quantities that people ask for next what they are, in words.
    curve_tables : mapping of str to tuple of str
        Curves that people put side by side in a table, by its name, which questions may share.
    is_for : callable (needs, design) → bool
        Whether it makes sense to ask a machine's file for what some results lack, as far as its own tables go.
    uses : tuple of Use
        What may stand in a file without being used.
    files : tuple of TableFile
        Tables that name files.
    """

    name: str
    tables: Mapping[str, type] = field(default_factory=dict[str, type])
    problems: Callable[[Design], Iterable[Problem]] = _nothing
    parts: Callable[[Designs, Parts], Iterable[object | None]] = _nothing
    stages: tuple[Stage, ...] = ()
    over_time: Callable[[], tuple[Stage, ...]] = tuple
    dimensions: tuple[ResultDimension, ...] = ()
    headline: tuple[str, ...] = ()
    title: str = ""
    rows: tuple[Callable[..., Iterable[AnswerLine]], ...] = ()
    offers: Mapping[str, str] = field(default_factory=dict[str, str])
    curve_tables: Mapping[str, tuple[str, ...]] = field(default_factory=dict[str, tuple[str, ...]])
    is_for: Callable[[Sequence[str], Design], bool] = _always
    uses: tuple[Use, ...] = ()
    files: tuple[TableFile, ...] = ()


def table(name: str) -> Written:
    """A table of the file that is one thing."""
    return lambda design: [f"[{name}]"] if design.tables.get(name) else []


def keys(path: str, *names: str) -> Written:
    """Keys of a table, or of those of single members in it."""

    def written(design: Design) -> Sequence[str]:
        common: Any = design.tables.get(path)
        if common is None:
            return []
        below: Mapping[str, Any] = getattr(common, "overrides", {})
        tables = {path: common} | {f"{path}.{name}": own for name, own in below.items()}
        return [f"[{where}] {name}" for name in names for where, own in tables.items() if name in own.model_fields_set]

    return written


def inner_table(path: str, name: str) -> Written:
    """A table within another."""
    return lambda design: [f"[{path}.{name}]" for _key in keys(path, name)(design)]
