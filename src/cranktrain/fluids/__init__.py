"""What fills a chamber: one folder for each fluid, with its table, pressure and README; a new one is a line here.

A fluid takes its numbers and the chambers that it fills, and then gives the pressure by their state; of the mechanism
it knows nothing else:

    fluid = fluid_of(spec)
    ready = fluid.prepared(by_design([fluid.numbers(spec)], n_designs), rooms)
    pressure = fluid.pressure(chamber_state(volume, limits, angle_from_firing, cycle), ready)
"""

from typing import TYPE_CHECKING

from cranktrain.fluids.fluid import AnyFluid, Fluid, FluidSpec, Kink, Rooms, table_path
from cranktrain.fluids.state import ChamberState, VolumeLimits, chamber_state
from cranktrain.folders import Folders
from cranktrain.when_given import by_kind

__all__ = [
    "KINDS",
    "AnyFluid",
    "AnyGas",
    "ChamberState",
    "Fluid",
    "FluidSpec",
    "Kink",
    "Rooms",
    "VolumeLimits",
    "chamber_state",
    "fluid_of",
    "table_path",
]

KINDS: Folders[AnyFluid] = Folders(
    "cranktrain.fluids", "KIND", ("indicator", "otto", "diesel", "dual", "wiebe", "compressor")
)

if TYPE_CHECKING:
    AnyGas = FluidSpec
else:
    AnyGas = by_kind(KINDS)


def fluid_of(spec: FluidSpec) -> AnyFluid:
    """Give the fluid that a table declares."""
    return KINDS.named(spec.kind)
