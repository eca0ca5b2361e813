"""The fluids of the machine file, as numbers: which table fills which chamber."""

from collections.abc import Sequence
from typing import Any, ClassVar, NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.fluids import AnyFluid, FluidSpec, fluid_of, of_designs
from cranktrain.language import N_
from cranktrain.questions.cylinders.volumes import Chambers
from cranktrain.record import record


class GasTable(NamedTuple):
    """One table: its path, its fluid, the numbers of all designs, shape (design, 1, 1), and its flags."""

    path: str
    fluid: AnyFluid
    numbers: Any
    flags: tuple[str, ...]


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


def declared_gas(specs: Sequence[FluidSpec], chambers: Chambers | None) -> DeclaredGas:
    """Take the numbers of all designs."""
    fluid = fluid_of(specs[0])
    flags = dict.fromkeys(flag for spec in specs for flag in fluid.flags(spec))
    table = GasTable("gas", fluid, of_designs([fluid.numbers(spec) for spec in specs]), tuple(flags))
    return DeclaredGas((table,), np.zeros(0 if chambers is None else len(chambers.names), dtype=np.intp))
