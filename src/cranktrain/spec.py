"""The base of all specs, and what is wrong with an input in our words: every error of pydantic becomes a `Problem`."""

import re
import types
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import (
    Annotated,
    Any,
    ClassVar,
    Literal,
    NamedTuple,
    Self,
    TypeVar,
    Union,
    cast,
    get_args,
    get_origin,
)

from pydantic import BaseModel, ConfigDict, Discriminator, Tag, ValidationError, model_validator
from pydantic.fields import FieldInfo
from pydantic_core import ErrorDetails, core_schema

from cranktrain.allowed import ALLOWED, OTHERWISE
from cranktrain.brief import BriefSignature, brief_fields
from cranktrain.errors import InputError, Problem, refuse
from cranktrain.grouping import grouped
from cranktrain.language import Words, _
from cranktrain.paths import path_text, value_at
from cranktrain.quantities import Given, Quantity, nearest, one_of, unknown_key, unlisted, written
from cranktrain.spec_class import SpecClass
from cranktrain.when_given import meant


class Spec(BaseModel, frozen=True, metaclass=SpecClass):
    """A table of the machine file: frozen, no unknown keys, nothing coerced; its lists become tuples."""

    model_config = ConfigDict(extra="forbid", strict=True, allow_inf_nan=False, defer_build=True)

    of_file: ClassVar[frozenset[str]] = frozenset()
    """Fields that say where a curve's numbers are and how they are read: as numbers, they may differ among designs."""

    unlisted: ClassVar[frozenset[str]] = frozenset(
        {"coming_from", "master_field", "of_file", "others", "typed_in", "unlisted", "words"}
    )
    """Names that the program needs, and nobody who has a spec in hand."""

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
    def _lists_as_tuples(cls, data: object) -> object:
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


class Bare(NamedTuple):
    """A declared type without `Annotated` and `| None`, what marks it, and of a union its alternatives."""

    annotation: object
    marks: tuple[object, ...]
    alternatives: tuple[object, ...] = ()

    @property
    def tag(self) -> str | None:
        """Key that tells the alternatives of a union; None where none does."""
        tags = [mark.discriminator for mark in self.marks if isinstance(mark, FieldInfo | Discriminator)]
        return next((tag for tag in tags if isinstance(tag, str)), None)


def _location(model: type[Spec], loc: tuple[str | int, ...]) -> _Location:
    """Follow pydantic's location, which also names the alternatives of unions, along the declared types."""
    where = _Location("", model, None, ())
    for index, item in enumerate(loc):
        declared = bare(where.annotation)
        if declared.alternatives:
            tried = () if declared.tag else ((loc[:index], item),)
            inner = _alternative(declared, str(item))
            where = where._replace(annotation=inner, alternatives=(*where.alternatives, *tried))
        elif item != "[key]":  # after a key: not its value is wrong, but itself
            path = _joined(where.path, path_text((item,)))
            is_key = loc[index + 1 :] == ("[key]",)
            inner = get_args(declared.annotation)[0] if is_key else _inner(declared.annotation, item)
            where = _Location(path, inner, _table(declared.annotation), where.alternatives)
    return where


def bare(annotation: object, marks: tuple[object, ...] = ()) -> Bare:
    """Take a declared type apart as far as pydantic's locations do; `marks` are those that stood around it."""
    if get_origin(annotation) is Annotated:
        inner, *own = get_args(annotation)
        within = [part for mark in own for part in (mark, *(mark.metadata if isinstance(mark, FieldInfo) else ()))]
        return bare(meant(inner, within), (*marks, *within))
    if get_origin(annotation) in (Union, types.UnionType):
        alternatives = [part for part in get_args(annotation) if part is not types.NoneType]
        return Bare(annotation, marks, tuple(alternatives)) if len(alternatives) > 1 else bare(alternatives[0], marks)
    return Bare(annotation, marks)


def _alternative(union: Bare, label: str) -> object:
    """Find the alternative of a union that pydantic means by its tag, class or type."""
    for alternative in union.alternatives:
        marks = get_args(alternative)[1:] if get_origin(alternative) is Annotated else ()
        if any(isinstance(mark, Tag) and mark.tag == label for mark in marks):
            return alternative
    kind = re.sub(r"^(?:function-\w+\[[^,]*, )+", "", label)  # what wraps its validators round it
    for alternative in union.alternatives:
        declared = bare(alternative)
        table = _table(declared.annotation)
        if table is not None and union.tag is not None:
            if label in map(str, words_of(table.model_fields[union.tag].annotation)):
                return alternative
        elif re.match(rf"{_type_name(declared)}\b", kind):
            return alternative
    return object


def _type_name(declared: Bare) -> str:
    """Name a type as pydantic begins to."""
    if declared.alternatives:
        return "tagged-union"
    origin = get_origin(declared.annotation) or declared.annotation
    return "literal" if origin is Literal else str(getattr(origin, "__name__", origin))


def _inner(annotation: object, item: str | int) -> object:
    """Declared type of an item of a table, dictionary or list; `object` where it has none."""
    table = _table(annotation)
    arguments = get_args(annotation)
    if table is not None:
        field = next((field for name, field in table.model_fields.items() if item == _key(name, field)), None)
        return object if field is None else Annotated[field.annotation, field]
    if not arguments:
        return object
    if isinstance(item, int) and len(arguments) > item and Ellipsis not in arguments:
        return arguments[item]
    return arguments[0] if isinstance(item, int) else arguments[-1]


def _table(annotation: object) -> type[BaseModel] | None:
    """Take a declared type for a table of fixed keys, if it is one."""
    return annotation if isinstance(annotation, type) and issubclass(annotation, BaseModel) else None


def _key(name: str, field: FieldInfo) -> str:
    """Key of a field in the machine file."""
    return field.alias or name


def parts_of(annotation: object) -> Iterator[object]:
    """Simple types of a declared one, and what marks them."""
    if get_origin(annotation) is Annotated:
        inner, *marks = get_args(annotation)
        own = [part for mark in marks for part in (mark.metadata if isinstance(mark, FieldInfo) else (mark,))]
        yield from own
        yield from parts_of(meant(inner, own))
    elif get_origin(annotation) in (Union, types.UnionType):
        for part in get_args(annotation):
            yield from parts_of(part)
    else:
        yield annotation


def quantity_of(annotation: object) -> Quantity | None:
    """Give the quantity as which a value of a declared type is read; None where it is none."""
    return next((part for part in parts_of(annotation) if isinstance(part, Quantity)), None)


def words_of(annotation: object) -> list[object]:
    """Words that a declared type allows: a `Literal`, or a tuple of words that marks it."""
    found: list[object] = []
    for part in parts_of(annotation):
        found += part if type(part) is tuple else get_args(part) if get_origin(part) is Literal else ()
    return found


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
            stood = _as_written(value_at(detail["input"], problem.path)) if problem.given is None else problem.given
            yield replace(problem, path=_joined(where.path, problem.path), given=stood)
    elif kind == "extra_forbidden" and where.table is not None:
        known = [_key(name, field) for name, field in where.table.model_fields.items()]
        yield unknown_key(where.path, str(detail["loc"][-1]), _as_written(detail["input"]), known)
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
        yield Problem(where.path, given, _with_example(allowed, where) if kind == "tuple_type" else allowed)
    else:  # a validator's own PydanticCustomError
        yield Problem(where.path, given, detail["msg"])


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
    tables = filter(None, map(_table, parts_of(where.annotation)))
    kinds = [kind for table in tables for kind in words_of(table.model_fields[tag].annotation)]
    path = _joined(where.path, tag)
    if detail["type"] == "union_tag_invalid":
        return unlisted(path, value_at(detail["input"], tag), kinds)
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
    """Turn lists into tuples, through and through."""
    if isinstance(data, list):
        return tuple(map(with_tuples, cast("list[object]", data)))
    if isinstance(data, dict):
        table = cast("dict[str, object]", data)
        return {key: value if isinstance(value, str) else with_tuples(value) for key, value in table.items()}
    return data
