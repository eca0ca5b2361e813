"""The base of all specs, and what is wrong with an input in our words: every error of pydantic becomes a `Problem`."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import (
    Any,
    ClassVar,
    NamedTuple,
    Self,
    TypeVar,
    cast,
    get_args,
)

import numpy as np
from pydantic import BaseModel, ConfigDict, ValidationError, model_validator
from pydantic_core import ErrorDetails, core_schema

from cranktrain.allowed import ALLOWED, OTHERWISE
from cranktrain.brief import BriefSignature, brief_fields
from cranktrain.declared_types import alternative_of, bare, inner_of, key_of, parts_of, quantity_of, table_of, words_of
from cranktrain.errors import InputError, Problem, judged, refuse
from cranktrain.grouping import grouped
from cranktrain.language import Words, _
from cranktrain.paths import path_text, value_at
from cranktrain.quantities import NOWHERE, Given, nearest, one_of, unknown_key, unlisted, written
from cranktrain.spec_class import SpecClass, listed_property


class Spec(BaseModel, frozen=True, metaclass=SpecClass):
    """A table of the machine file: frozen, no unknown keys, nothing coerced; its lists become tuples."""

    model_config = ConfigDict(
        extra="forbid", strict=True, allow_inf_nan=False, defer_build=True, ignored_types=(listed_property,)
    )

    of_file: ClassVar[frozenset[str]] = frozenset()
    """Fields that say where a curve's numbers are and how they are read: as numbers, they may differ among designs."""

    unlisted: ClassVar[frozenset[str]] = frozenset(
        {
            "as_fields",
            "coming_from",
            "elsewhere",
            "kinds_elsewhere",
            "in_one_word",
            "master_field",
            "of_file",
            "others",
            "typed_in",
            "unlisted",
            "words",
        }
    )
    """Names that the program needs, and nobody who has a spec in hand."""

    elsewhere: ClassVar[Mapping[str, str]] = {}
    """Words for its keys in books and other programs, and what is written for them: `crank_to_rod_ratio` for λ."""

    kinds_elsewhere: ClassVar[Mapping[str, str]] = {}
    """Words for kinds of which it is one, likewise."""

    in_one_word: ClassVar[str | None] = None
    """Key of what a text that stands in place of the table means."""

    others: ClassVar[str | None] = None
    """Field that holds, by name, the tables that stand in the file under keys of the user's own."""

    def __repr__(self) -> str:
        """Show what was given, in one line."""
        given = ((name, getattr(self, name)) for name in type(self).model_fields if name in self.model_fields_set)
        return brief_fields(type(self).__name__, given)

    __str__ = __repr__

    def __dir__(self) -> list[str]:
        """Fields, and what is the specs' own."""
        return sorted({*type(self).model_fields, *dir(type(self))})

    @classmethod
    def __pydantic_init_subclass__(cls, **_options: object) -> None:
        """Give the class its signature."""
        type.__setattr__(cls, "__signature__", BriefSignature())

    @classmethod
    def __pydantic_on_complete__(cls) -> None:
        """Give it once more, over the one that pydantic makes with what it reads by."""
        type.__setattr__(cls, "__signature__", BriefSignature())

    @model_validator(mode="before")
    @classmethod
    def _read_as_fields(cls, data: object) -> object:
        return cls.as_fields(data)

    @classmethod
    def as_fields(cls, data: object) -> object:
        """Take TOML's lists for the tuples of a frozen spec, which a strict one would refuse."""
        return with_tuples(data)

    @model_validator(mode="after")
    def _fits_together(self) -> Self:
        """Refuse values that do not go together, all at once."""
        refuse(self._problems())
        return self

    def _problems(self) -> Iterable[Problem]:
        """Find what its fields show together to be wrong; paths are relative to the spec."""
        return ()


SpecType = TypeVar("SpecType", bound=Spec)


class Refused(InputError):  # noqa: N818 - it is raised as a sentence: raise Refused(...)
    """What a validator of a spec raises: the value, alone or together with others, is not allowed.

    What fields show only together a spec says in `_problems` instead; the paths of both are relative to the spec.

    Parameters
    ----------
    allowed : Words
        What is allowed, as a clause: "must be more than crank_radius = 50 mm, or the crank cannot turn".
    repair : Words, optional
        What to write instead.
    path : str, optional
        Path of the value below the spec, e.g. "rod_length" or "throws[3]"; the spec itself where left out.
    """

    def __init__(self, allowed: Words, repair: Words | None = None, *, path: str = "") -> None:
        super().__init__((Problem(path, None, allowed, repair),))


def validated(model: type[SpecType], data: object) -> SpecType:
    """Read a spec.

    Parameters
    ----------
    model : type of Spec
    data : mapping
        As `tomllib` reads it, with `Given` and specs allowed in place of texts and tables.

    Returns
    -------
    Spec
        An instance of `model`.

    Raises
    ------
    InputError
        With everything that is wrong.
    """
    try:
        return model.model_validate(data)
    except ValidationError as error:
        raise InputError(problems(error, model)) from None


def problems(error: ValidationError, model: type[Spec]) -> tuple[Problem, ...]:
    """Say what is wrong in our words.

    Parameters
    ----------
    error : pydantic.ValidationError
        As raised when reading `model`.
    model : type of Spec

    Returns
    -------
    tuple of Problem
        In the order of the fields; of a union, only what is wrong with the alternative that fits best.
    """
    details = error.errors(include_url=False)
    locations = [_location(model, detail["loc"]) for detail in details]
    fitting = _fitting_alternatives(details, locations)
    said: dict[str | int, Problem] = {}
    for detail, where in zip(details, locations, strict=True):
        if all(label in fitting[union] for union, label in where.alternatives):
            for problem in _problems_of(detail, where):
                # alternatives that fit equally well are told in one sentence; otherwise each problem is its own
                key = problem.path if where.alternatives else len(said)
                said[key] = _either(said[key], problem) if key in said else problem
    return tuple(said.values())


class _Location(NamedTuple):
    """Where an error stands.

    Its dotted path, what the spec declares there, the spec it is a key of, and of the unions without a `kind` that
    it lies in, each one's location and the alternative tried.
    """

    path: str
    annotation: object
    table: type[BaseModel] | None
    alternatives: tuple[tuple[tuple[str | int, ...], str | int], ...]


def _location(model: type[Spec], loc: tuple[str | int, ...]) -> _Location:
    """Follow pydantic's location, which also names the alternatives of unions, along the declared types."""
    where = _Location("", model, None, ())
    for index, item in enumerate(loc):
        declared = bare(where.annotation)
        if declared.alternatives:
            tried = () if declared.tag else ((loc[:index], item),)
            inner = alternative_of(declared, str(item))
            where = where._replace(annotation=inner, alternatives=(*where.alternatives, *tried))
        elif item != "[key]":  # after a key: not its value is wrong, but itself
            path = _joined(where.path, path_text((item,)))
            is_key = loc[index + 1 :] == ("[key]",)
            inner = get_args(declared.annotation)[0] if is_key else inner_of(declared.annotation, item)
            where = _Location(path, inner, table_of(declared.annotation), where.alternatives)
    return where


def _fitting_alternatives(
    details: Sequence[ErrorDetails], locations: Sequence[_Location]
) -> dict[tuple[str | int, ...], set[str | int]]:
    """Of every union, the alternatives that got farthest before something was wrong; a wrong type is no start."""
    tried = grouped(
        (union, (label, (len(detail["loc"]), not detail["type"].endswith("_type"))))
        for detail, where in zip(details, locations, strict=True)
        for union, label in where.alternatives
    )
    farthest = {union: max(reach for _label, reach in each) for union, each in tried.items()}
    return {union: {label for label, reach in each if reach == farthest[union]} for union, each in tried.items()}


def _problems_of(detail: ErrorDetails, where: _Location) -> Iterator[Problem]:
    """Say what one error of pydantic is in our words; an `InputError` of a validator holds several problems."""
    kind, context, given = detail["type"], detail.get("ctx", {}), _as_written(detail["input"])
    cause = context.get("error")
    if isinstance(cause, InputError):
        for problem in cause.problems:
            yield _placed(problem, where.path, detail["input"])
    elif kind == "extra_forbidden" and where.table is not None:
        known = [key_of(name, field) for name, field in where.table.model_fields.items()]
        elsewhere = where.table.elsewhere if issubclass(where.table, Spec) else NOWHERE
        yield unknown_key(where.path, str(detail["loc"][-1]), _as_written(detail["input"]), known, elsewhere)
    elif kind.startswith("union_tag") and bare(where.annotation).tag:
        yield _wrong_kind(detail, where)
    elif kind == "missing":
        yield Problem(where.path, None, missing(where.annotation, str(detail["loc"][-1])))
    elif kind == "literal_error" and (words := words_of(where.annotation)):
        yield unlisted(where.path, detail["input"], words)
    elif isinstance(cause, Exception):
        yield Problem(where.path, given, str(cause))
    elif kind in get_args(core_schema.ErrorType):
        if kind in ("int_type", "float_type", "bool_type") and isinstance(detail["input"], str):
            given = f'"{given}"'  # the quotes are what is wrong with "5"
        allowed = _(ALLOWED.get(kind, OTHERWISE), **context)
        said = _with_example(allowed, where) if kind == "tuple_type" else allowed
        yield Problem(where.path, given, said, _as_table(detail, where))
    else:  # a validator's own PydanticCustomError
        yield Problem(where.path, given, detail["msg"])


def problems_within(spec: Spec, path: str, data: object) -> Iterator[Problem]:
    """Find what the fields of a spec, read at least half from what stands at a path, show together to be wrong."""
    yield from (_placed(problem, path, data) for problem in judged(_own_problems(spec)))


def _own_problems(spec: Spec) -> Iterator[Problem]:
    """Ask a spec when its answer is wanted."""
    try:
        yield from spec._problems()  # pyright: ignore[reportPrivateUsage]
    except InputError as error:
        yield from error.problems


def _placed(problem: Problem, path: str, data: object) -> Problem:
    """Put a problem of a spec at its path in the file, with what stands there."""
    given = _as_written(value_at(data, problem.path)) if problem.given is None else problem.given
    return replace(problem, path=_joined(path, problem.path), given=given)


def _as_table(detail: ErrorDetails, where: _Location) -> Words | None:
    """Say how what is written in one word is written as the table that belongs there; None where no word suffices."""
    table, word = table_of(bare(where.annotation).annotation), detail["input"]
    if table is None or not issubclass(table, Spec) or table.in_one_word is None or not isinstance(word, str):
        return None
    key = where.path.rpartition(".")[2]
    return _('write {key} = {{ {inner} = "{word}" }}', key=key, inner=table.in_one_word, word=word)


def _with_example(allowed: Words, where: _Location) -> Words:
    """Say how a list of quantities is written, with the example that suits the key."""
    items = get_args(bare(where.annotation).annotation)
    quantity = quantity_of(items[0]) if items else None
    if quantity is None:
        return allowed
    key = where.path.rpartition(".")[2].partition("[")[0]
    example = quantity.of_field(key).example or quantity.dimension.example
    return _('{allowed}, such as ["{example}", …]', allowed=allowed, example=example)


def _wrong_kind(detail: ErrorDetails, where: _Location) -> Problem:
    """Refuse the `kind` of a table, or say that it is missing."""
    tag = bare(where.annotation).tag or ""
    tables = list(filter(None, map(table_of, parts_of(where.annotation))))
    kinds = [kind for table in tables for kind in words_of(table.model_fields[tag].annotation)]
    path = _joined(where.path, tag)
    if detail["type"] == "union_tag_invalid":
        specs = [table for table in tables if issubclass(table, Spec)]
        elsewhere = {word: what for table in specs for word, what in table.kinds_elsewhere.items()}
        return unlisted(path, value_at(detail["input"], tag), kinds, elsewhere)
    meant = nearest(tag, map(str, cast("Mapping[object, object]", detail["input"])))
    repair = _("write {key} instead of {given}", key=tag, given=meant) if meant else None
    return Problem(path, None, _("is missing; {expected}", expected=one_of(kinds)), repair)


def missing(annotation: object, key: str | None = None) -> Words:
    """Say that a value is missing, and what it could be; the key in the file, where it is known, gives the example."""
    quantity, words = quantity_of(annotation), words_of(annotation)
    if quantity is None and not words:
        return _("is missing")
    wanted = quantity.of_field(key).expected if quantity else one_of(words)
    return _("is missing; {expected}", expected=wanted)


def _either(one: Problem, other: Problem) -> Problem:
    """Join what two alternatives say of the same value."""
    if one.allowed == other.allowed:
        return one
    allowed = _("{one}, or {other}", one=one.allowed, other=other.allowed)
    return replace(one, allowed=allowed, repair=one.repair or other.repair)


def _joined(path: str, part: str) -> str:
    """Extend a dotted path by a key, or by an index in brackets."""
    return path + part if not path or not part or part.startswith("[") else f"{path}.{part}"


def _as_written(data: object) -> str | None:
    """A value nearly as the user wrote it; of a quantity with its status, the quantity."""
    if isinstance(data, Given):
        return data.text
    if isinstance(data, Mapping):
        return written(cast("Mapping[str, object]", data).get("value"))
    return written(data)


def with_tuples(data: object) -> Any:
    """Turn lists and arrays into tuples, numbers of NumPy's into Python's, through and through."""
    if isinstance(data, np.ndarray | np.generic):
        data = cast("object", data.tolist())
    if isinstance(data, list):
        return tuple(map(with_tuples, cast("list[object]", data)))
    if isinstance(data, dict):
        table = cast("dict[str, object]", data)
        return {key: value if isinstance(value, str) else with_tuples(value) for key, value in table.items()}
    return data
