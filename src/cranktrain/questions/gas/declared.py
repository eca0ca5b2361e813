"""The fluids of the machine file, as numbers: which table fills which chamber."""

from collections.abc import Iterator, Mapping
from typing import Any, ClassVar, NamedTuple, cast

import numpy as np
from numpy.typing import NDArray

from cranktrain.errors import Problem, judged
from cranktrain.fluids import KINDS, AnyFluid, FluidSpec, fluid_of, table_path
from cranktrain.grouping import grouped
from cranktrain.language import N_, Words, _
from cranktrain.layout.design import Design, Designs
from cranktrain.numerics.designs import by_design
from cranktrain.paths import quantity_path
from cranktrain.questions.cylinders.parts import chamber_names, chamber_sides, cylinders
from cranktrain.record import record

_GAS = "gas"


class GasTable(NamedTuple):
    """One table: its path, its fluid, the numbers of all designs, shape (design, 1, 1), and its flags."""

    path: str
    fluid: AnyFluid
    numbers: Any
    flags: tuple[Words, ...]


@record
class DeclaredGas:
    """What the file says of the gas.

    Attributes
    ----------
    tables : tuple of GasTable
    table : array of int, shape (chamber,)
        Which of them fills each chamber.
    """

    needs: ClassVar[str] = N_("[gas]")

    tables: tuple[GasTable, ...]
    table: NDArray[np.intp]

    @property
    def fires(self) -> bool:
        """Whether cylinders fire, and so need a cycle and an order."""
        return any(table.fluid.fires for table in self.tables)

    @property
    def are_cards(self) -> bool:
        """Whether all that is known of the gas was measured."""
        return all(table.fluid.name == "indicator" for table in self.tables)

    def numbers(self, path: str) -> Any:
        """Numbers of the table with that path."""
        return next(table.numbers for table in self.tables if table.path == path)


def gas_tables(design: Design) -> dict[str, FluidSpec]:
    """Give the fluids of a machine by their paths; none where it has no `[gas]`."""
    given = design.tables.get(_GAS)
    if given is None or isinstance(given, FluidSpec):
        return {} if given is None else {_GAS: given}
    return {table_path(name): spec for name, spec in cast("Mapping[str, FluidSpec]", given).items()}


def filled_by(design: Design) -> list[str | None]:
    """Give the path of the table that fills each chamber, the nearest one: its own, its cylinder's, its bank's."""
    tables = gas_tables(design)
    if _GAS in tables:
        return [_GAS for _name in chamber_names(design.once(cylinders))]
    return [next((path for name in names if (path := table_path(name)) in tables), None) for names in _names(design)]


def _names(design: Design) -> list[tuple[str, ...]]:
    """Names by which each chamber may be called, the nearest first."""
    each = design.once(cylinders)
    named = zip(chamber_names(each), chamber_sides(each), strict=True)
    return [
        tuple(filter(None, dict.fromkeys((chamber, f"{cylinder.name}.{side}", cylinder.name, cylinder.bank))))
        for chamber, (cylinder, side) in named
    ]


def declared_gas(designs: Designs) -> DeclaredGas | None:
    """Take the numbers of all designs; None where they have no gas."""
    given = gas_tables(designs.together)
    if not given:
        return None
    each = [gas_tables(design) for design in designs.different]
    tables: list[GasTable] = []
    for path, spec in given.items():
        fluid = fluid_of(spec)
        flags = dict.fromkeys(flag for tables_of in each for flag in fluid.flags(tables_of[path]))
        tables.append(GasTable(path, fluid, by_design([fluid.numbers(spec)], designs.n_designs), tuple(flags)))
    paths = list(given)
    filled = [paths.index(path) for path in filled_by(designs.together) if path is not None]
    return DeclaredGas(tuple(tables), np.array(filled, dtype=np.intp))


def gas_problems(design: Design) -> Iterator[Problem]:
    """Find tables of nothing, chambers without gas beside others, and what the fluids see together."""
    tables = gas_tables(design)
    if not tables:
        return
    if not design.once(cylinders):
        yield Problem(_GAS, None, _("is not for this machine, which has no pistons"))
        return
    yield from judged(_fillings(design, tables))
    by_kind = grouped((spec.kind, (path, spec)) for path, spec in tables.items())
    for name in filter(by_kind.__contains__, KINDS.names):
        yield from judged(KINDS.named(name).problems(dict(by_kind[name])))


def _fillings(design: Design, tables: Mapping[str, FluidSpec]) -> Iterator[Problem]:
    """Find tables that fill nothing, and chambers that nothing fills."""
    known = list(dict.fromkeys(name for names in _names(design) for name in names))
    used = filled_by(design)
    for path in tables:
        if path != _GAS and quantity_path(path)[-1] not in known:
            allowed = _("is neither a bank nor a cylinder or chamber of this machine: {known}")
            yield Problem(path, None, allowed.format(known=", ".join(known)))
        elif path not in used:
            yield Problem(path, None, _("fills nothing: every chamber that it names has a nearer table"))
    without = [name for name, path in zip(chamber_names(design.once(cylinders)), used, strict=True) if path is None]
    if without and len(without) < len(used):
        allowed = _("has no table for {chambers}, while others have one", chambers=", ".join(without))
        yield Problem(_GAS, None, allowed)
