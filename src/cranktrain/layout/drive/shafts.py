"""Shafts of a drive as its tables name them: the motor's, and those behind stages, by their numbers."""

from collections.abc import Iterator
from typing import Annotated, Literal, TypeAlias

from pydantic import Field, ValidationError, ValidatorFunctionWrapHandler, WrapValidator

from cranktrain.errors import InputError, Problem
from cranktrain.language import _
from cranktrain.quantities.refusal import written


def _of_shaft(given: object, inner: ValidatorFunctionWrapHandler) -> object:
    """Take what names a shaft; refuse the rest in one sentence."""
    try:
        return inner(given)
    except ValidationError:
        allowed = _('must be "motor" or the number of a stage, 1 or more')
        raise InputError([Problem("", str(written(given)), allowed)]) from None


OnShaft: TypeAlias = Annotated[Literal["motor"] | Annotated[int, Field(ge=1)], WrapValidator(_of_shaft)]
"""As a table writes it: "motor", or how many stages stand before the shaft."""


def shaft_number(on: OnShaft) -> int:
    """How many stages stand before a shaft; none before the motor's."""
    return 0 if on == "motor" else on


def absent_shaft(path: str, on: OnShaft, n_stages: int) -> Iterator[Problem]:
    """Find a shaft that is not there."""
    if shaft_number(on) > n_stages:
        allowed = _('must be "motor" or the number of a stage, of which there are {n}', n=n_stages)
        yield Problem(path, str(on), allowed)
