"""`[gas]`: one fluid for all chambers, or tables by the names of banks, cylinders and chambers."""

from collections.abc import Iterator, Mapping
from functools import cache
from typing import Annotated, Any, TypeAlias, cast

from pydantic import BeforeValidator, Discriminator, Tag

from cranktrain.allowed import Name
from cranktrain.errors import Problem, refuse
from cranktrain.fluids import KINDS, AnyGas
from cranktrain.language import _
from cranktrain.quantities import one_of


@cache
def _own_keys() -> frozenset[str]:
    """Keys of fluids, which are no names of chambers."""
    return frozenset(name for fluid in KINDS for name in fluid.spec.model_fields)


def _form(data: object) -> str:
    """Whether a table is a fluid itself or holds fluids by name."""
    return "named" if isinstance(data, Mapping) and "kind" not in data else "one"


def _one_way(data: object) -> object:
    """Refuse a fluid's own keys without its kind, and named tables beside a kind."""
    if isinstance(data, Mapping):
        refuse(_wrong(cast("Mapping[str, Any]", data)))
    return cast("object", data)


def _wrong(table: Mapping[str, Any]) -> Iterator[Problem]:
    """Find what is wrong with the keys of the table as they stand together."""
    if "kind" in table:
        allowed = _("must not stand beside kind; give each named table a kind of its own, and [gas] none")
        yield from (Problem(name, None, allowed) for name, value in table.items() if _is_fluid(value))
        return
    own = [name for name, value in table.items() if not isinstance(value, Mapping) or name in _own_keys()]
    if own or not table:
        kinds = one_of(KINDS.names)
        allowed = _("is missing; {kinds}; or give every chamber a table by its name, its cylinder's or its bank's")
        yield Problem("kind", None, allowed.format(kinds=kinds), _("write [gas.NAME] with a kind of its own"))


def _is_fluid(value: object) -> bool:
    """Whether a value is a fluid's table."""
    return isinstance(value, Mapping) and "kind" in value


GasTables: TypeAlias = Annotated[
    Annotated[AnyGas, Tag("one")] | Annotated[Mapping[Name, AnyGas], Tag("named")],
    Discriminator(_form),
    BeforeValidator(_one_way),
]
