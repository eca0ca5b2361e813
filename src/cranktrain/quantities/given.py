"""A quantity as a field of a spec: what was given, in SI, with where it is from."""

import operator
import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from typing import Any, Literal, TypeAlias, cast, get_args

import numpy as np
from numpy.typing import NDArray
from pydantic import GetCoreSchemaHandler, GetJsonSchemaHandler
from pydantic.json_schema import JsonSchemaValue
from pydantic_core import CoreSchema, core_schema

from cranktrain.errors import InputError, Problem
from cranktrain.language import N_, Words, _
from cranktrain.motion import Array, single
from cranktrain.one_line import short
from cranktrain.quantities.conversion import shown
from cranktrain.quantities.dimensions import TURN, Dimension, expected, is_unit, plain, spellings, unit_names
from cranktrain.quantities.examples import EXAMPLES
from cranktrain.quantities.number import PATTERN, measured, rounded
from cranktrain.quantities.reading import Reading, reading
from cranktrain.quantities.refusal import QuantityError, unknown_key, unlisted, written

Status: TypeAlias = Literal["published", "derived", "assumed", "fitted"]

_LARGEST = 1e30
"""Of any quantity in SI: its powers stay within what a number can hold."""

_KEYS = ("value", "status", "note", "source")

_DIGITS = {"²": "2", "³": "3", "2": "²", "3": "³"}


@dataclass(frozen=True)
class Given:
    """A quantity as it was given.

    Attributes
    ----------
    si : float
        Its value in SI and radians.
    text : str
        What was written, e.g. "180 mm" or "7 1/16 in".
    status, note, source : str or None
        How the number came about, in which sense, and from where.
    column : Array, shape (design,), optional
        Its values in SI in several designs that are laid out together, of which all else is the first one's.
    """

    si: float
    text: str
    status: Status | None = None
    note: str | None = None
    source: str | None = None
    column: Array | None = field(default=None, compare=False, repr=False)

    @property
    def array(self) -> Array:
        """Its value as the layout takes it: one number, or that of each design laid out together, shape (design,)."""
        return single(self.si) if self.column is None else self.column

    def __repr__(self) -> str:
        """Show the text, and its status."""
        return f"<{short(self.text)}{f', {self.status}' if self.status else ''}>"


@dataclass(frozen=True)
class Quantity:
    """Annotation of a `Given` field: its dimension, the range that is allowed, in SI; a direction counts no turns.

    The frequency of a vibration may be given as its angular frequency too, in the units of a speed of rotation, one
    oscillation for a turn.

    An example is of use where that of the dimension says little and `EXAMPLES` has none for the key.

    `Annotated[Given, Quantity(Dimension.LENGTH, above=0.0)]` takes "180 mm", a table
    {value = "180 mm", status = "published", note = "...", source = "..."}, or a `Given`.
    """

    dimension: Dimension
    above: float | None = None
    at_least: float | None = None
    below: float | None = None
    at_most: float | None = None
    is_direction: bool = False
    is_of_vibration: bool = False
    example: str | None = None

    @property
    def expected(self) -> Words:
        """What is allowed, with an example that suits."""
        return expected(self.dimension, self.example, self._other_units)

    @property
    def _other_units(self) -> tuple[str, ...]:
        """Units of an angular frequency, if it may be given as one."""
        return tuple(unit_names(Dimension.SPEED)) if self.is_of_vibration else ()

    def of_field(self, name: str | None) -> "Quantity":
        """Give it the example that suits a key of the machine file."""
        return replace(self, example=self.example or EXAMPLES.get(name or ""))

    def given(self, data: object) -> Given:
        """Read what was given.

        Raises
        ------
        InputError
            With everything that is wrong with it; `QuantityError` where that is one thing.
        """
        if isinstance(data, Given):
            if self._in_range(data.text).si != data.si:
                allowed = _("must be the value of its text, but {si} in SI units is not", si=data.si)
                raise QuantityError(data.text, allowed)
            return data
        if isinstance(data, Mapping):
            return self._from_table(cast("Mapping[str, object]", data))
        read = self._in_range(data)
        return Given(read.si, read.text)

    def allows(self, si: Array) -> NDArray[np.bool_]:
        """Whether numbers in SI are within the limits of the field, of the shape of `si`."""
        is_right = (si == 0.0) | ((np.abs(si) > 1 / _LARGEST) & (np.abs(si) < _LARGEST))
        for limit, holds, _allowed in self._limits():
            is_right &= holds(si, limit)
        return is_right

    def _from_table(self, table: Mapping[str, object]) -> Given:
        read, problems = None, list(_table_problems(table))
        try:
            if "value" not in table:
                raise QuantityError(None, _("is missing; {expected}", expected=self.expected))
            read = self._in_range(table["value"])
        except QuantityError as error:
            problems.insert(0, replace(error.problems[0], path="value"))
        if read is None or problems:
            raise InputError(problems)
        about = cast("dict[str, Any]", {key: table[key] for key in _KEYS[1:] if key in table})
        return Given(read.si, read.text, **about)

    def _in_range(self, data: object) -> Reading:
        read = self._reading(data)
        if not (read.si == 0.0 or 1 / _LARGEST < abs(read.si) < _LARGEST):
            raise QuantityError(read.text, _("is beyond the size of any machine"))
        for limit, holds, allowed in self._limits():
            if not holds(read.si, limit):
                name = read.unit.name if read.unit else ""
                size = shown(limit, name) if name else limit
                raise QuantityError(read.text, _(allowed, limit=f"{size:.6g} {name}".strip()))
        return read

    def _reading(self, data: object) -> Reading:
        """Read it; what is refused is told with the example."""
        if self.is_of_vibration and isinstance(data, str) and (read := _read_in_turns(data)) is not None:
            return read
        try:
            return reading(data, self.dimension, is_direction=self.is_direction, example=self.example)
        except QuantityError as error:
            if not self.is_of_vibration:
                raise
            (problem,) = error.problems
            units = ", ".join(self._other_units)
            allowed = _("{allowed}, or in {units}", allowed=problem.allowed, units=units)
            raise QuantityError(problem.given, allowed, problem.repair) from None

    def _limits(self) -> Iterator[tuple[float, Callable[[Any, float], Any], str]]:
        """Limits that are set, what must hold between a value and each, and how to say so."""
        for limit, holds, allowed in (
            (self.above, operator.gt, N_("must be more than {limit}")),
            (self.at_least, operator.ge, N_("must be at least {limit}")),
            (self.below, operator.lt, N_("must be less than {limit}")),
            (self.at_most, operator.le, N_("must be at most {limit}")),
        ):
            if limit is not None:
                yield limit, holds, allowed

    def __get_pydantic_core_schema__(self, source: object, handler: GetCoreSchemaHandler) -> CoreSchema:
        """Let pydantic read with `given` and write what a machine file may hold."""
        return core_schema.no_info_plain_validator_function(
            self.of_field(handler.field_name).given,
            serialization=core_schema.plain_serializer_function_ser_schema(_in_file),
        )

    def __get_pydantic_json_schema__(self, schema: CoreSchema, handler: GetJsonSchemaHandler) -> JsonSchemaValue:
        """Describe it for editors and forms."""
        return self.schema()

    def schema(self) -> dict[str, Any]:
        """Describe text with its unit, or a table that also says where the number is from, as a JSON schema."""
        example = [self.example or self.dimension.example]
        least = max((limit for limit in (self.above, self.at_least) if limit is not None), default=-1.0)
        read_in = (self.dimension, Dimension.SPEED) if self.is_of_vibration else (self.dimension,)
        patterns = "|".join(pattern(dimension, is_signed=least < 0) for dimension in read_in)
        text = {"type": "string", "pattern": patterns, "examples": example}
        value = text if self.dimension.needs_unit else text | {"type": ["number", "string"]}
        table = {
            "type": "object",
            "properties": {
                "value": value,
                "status": {"enum": list(get_args(Status)), "description": str(_("how the number came about"))},
                "note": {"type": "string", "description": str(_("in which sense"))},
                "source": {"type": "string", "description": str(_("from where"))},
            },
            "required": ["value"],
            "additionalProperties": False,
        }
        limits = [str(_(allowed, limit=f"{limit:g} (SI)")) for limit, _holds, allowed in self._limits()]
        sentence = "; ".join([str(self.expected), *limits])
        # not anyOf: a slip would then be one of every alternative
        return {"description": sentence, "if": {"type": "object"}, "then": table, "else": value, "examples": example}


def _read_in_turns(text: str) -> Reading | None:
    """Read an angular frequency as turns in a second; None where it is none."""
    parts = measured(text)
    if parts is None or not is_unit(parts.unit, Dimension.SPEED):
        return None
    read = reading(text, Dimension.SPEED)
    unit, _form = spellings(Dimension.SPEED)[plain(parts.unit)]
    return read._replace(si=rounded(unit.scale * parts.number / TURN))


def unit_of(given: Given, dimension: Dimension) -> str:
    """Unit in which a quantity was given, by its name; limits told beside it are in the same."""
    unit = reading(given.text, dimension).unit
    return unit.name if unit else ""


def _table_problems(table: Mapping[str, object]) -> Iterator[Problem]:
    """What is wrong in the table of a quantity besides its value."""
    for key in table:
        if key not in _KEYS:
            yield unknown_key(key, key, table[key], _KEYS)
    if "status" in table and table["status"] not in get_args(Status):
        yield unlisted("status", table["status"], get_args(Status))
    for key in ("note", "source"):
        if key in table and not isinstance(table[key], str):
            yield Problem(key, written(table[key]), _("must be text in quotes"))


def _in_file(given: Given) -> object:
    """Write a quantity as a machine file holds it: text or plain number, or a table with where it is from."""
    value = next((number for number in (int(given.si), given.si) if str(number) == given.text), given.text)
    about = {key: getattr(given, key) for key in _KEYS[1:] if getattr(given, key) is not None}
    return {"value": value, **about} if about else value


def pattern(dimension: Dimension, *, is_signed: bool) -> str:
    """Regular expression of a number and a unit of its dimension, in each of its spellings.

    Parameters
    ----------
    dimension : Dimension
    is_signed : bool
        Whether a minus may stand before it.

    Returns
    -------
    str
    """
    units = "|".join(dict.fromkeys(_unit_patterns(dimension)))
    signed = PATTERN if is_signed else PATTERN.replace("^", r"^(?!\s*-)", 1)
    optional = "" if dimension.needs_unit else "?"
    return rf"{signed}\s*(?:{units}){optional}\s*$"


def _unit_patterns(dimension: Dimension) -> Iterator[str]:
    """Spell each unit in the ways in which it is read: m² also m^2, N·m also N*m."""
    for key, (_unit, form) in spellings(dimension).items():
        for text in (form, key):
            pattern = re.sub(
                r"[²³]|(?<=[a-zа-я])[23]", lambda found: rf"(?:\^|\*\*)?[{found[0]}{_DIGITS[found[0]]}]", text
            )
            yield pattern.replace("·", r"[\s.*·⋅∙×]*").replace("/", r"\s*/\s*")
