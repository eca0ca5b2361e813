"""Tables of a machine file whose classes are imported when a file gives one, or somebody asks what may stand there."""

from collections.abc import Callable, Iterable
from functools import cached_property
from importlib import import_module
from typing import Annotated, Any, Union, cast

from pydantic import BaseModel, Field, GetCoreSchemaHandler
from pydantic_core import CoreSchema, core_schema

from cranktrain.folders import Folders


class Deferred:
    """Marks a declared type that stands for another one, which is found when it is needed; and how that is read."""

    def __init__(self, find: Callable[[], Any], schema: CoreSchema) -> None:
        self._find, self._schema = find, schema

    @cached_property
    def annotation(self) -> Any:
        """Give the type for which it stands."""
        return self._find()

    def __get_pydantic_core_schema__(self, _source: object, _handler: GetCoreSchemaHandler) -> CoreSchema:
        """Read it without the type, until there is something to read."""
        return self._schema


def when_given(home: str, name: str) -> Any:
    """Type of a table of one class, by the class's module and name."""

    def table() -> type[BaseModel]:
        return getattr(import_module(home), name)

    return Annotated[Any, Deferred(table, _read_by(table))]


def by_kind(kinds: Folders[Any]) -> Any:
    """Type of a table that is one of several, as its key `kind` says; each kind has a `name` and a `spec`."""

    def union() -> Any:
        return Annotated[Union[tuple(kind.spec for kind in kinds)], Field(discriminator="kind")]  # noqa: UP007 - types that are known when it runs

    def read_as(kind: str) -> CoreSchema:
        return _read_by(lambda: kinds.named(kind).spec)

    schema = core_schema.tagged_union_schema({kind: read_as(kind) for kind in kinds.names}, "kind")
    return Annotated[Any, Deferred(union, schema)]


def _read_by(table: Callable[[], type[BaseModel]]) -> CoreSchema:
    """Read a table by its class's own validator."""

    def read(value: object) -> object:
        return table().__pydantic_validator__.validate_python(value)

    return core_schema.no_info_plain_validator_function(read)


def meant(annotation: object, marks: Iterable[object]) -> object:
    """Type that an annotation stands for, as its marks say; itself where none does."""
    deferred = next((mark for mark in marks if isinstance(mark, Deferred)), None)
    return annotation if deferred is None else cast("object", deferred.annotation)
