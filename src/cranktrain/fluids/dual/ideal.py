"""The ideal cycles as fluids: three tables of one."""

from typing import TypeVar

from cranktrain.fluids.dual.chamber import ideal_kinks, ideal_work, suitable
from cranktrain.fluids.dual.pressure import IdealCycle, ideal_pressure, ideal_slope
from cranktrain.fluids.dual.spec import IdealCycleSpec, cycle_flags, ideal_cycle
from cranktrain.fluids.fluid import Fluid

_Table = TypeVar("_Table", bound=IdealCycleSpec)


def ideal_fluid(name: str, title: str, spec: type[_Table], example: str) -> Fluid[_Table, IdealCycle, IdealCycle]:
    """An ideal cycle by the table that it has of its own; all else they have in common."""
    return Fluid(
        name=name,
        title=title,
        spec=spec,
        example=example,
        numbers=ideal_cycle,
        prepared=suitable,
        pressure=ideal_pressure,
        slope=ideal_slope,
        work=ideal_work,
        flags=cycle_flags,
        kinks=ideal_kinks,
    )
