"""Working fluid: one folder for each kind of gas model, with spec, pressure and README; a new kind is one line here.

A model takes the state of a chamber (`chamber_state`) and gives its pressure; of the mechanism it knows nothing else:

    kind = kind_of(spec)
    model = kind.model(spec, chamber)
    pressure = kind.pressure(chamber_state(volume, limits, angle_from_firing, cycle), model)
"""

from typing import Annotated

from pydantic import Field

from cranktrain.gas import diesel, dual, indicator, otto
from cranktrain.gas.kind import AnyGasKind, Chamber, GasKind, GasSpec, Kink
from cranktrain.gas.state import ChamberState, VolumeLimits, chamber_state

__all__ = [
    "KINDS",
    "AnyGas",
    "AnyGasKind",
    "Chamber",
    "ChamberState",
    "GasKind",
    "GasSpec",
    "Kink",
    "VolumeLimits",
    "chamber_state",
    "kind_named",
    "kind_of",
]

KINDS: tuple[AnyGasKind, ...] = (indicator.KIND, otto.KIND, diesel.KIND, dual.KIND)

AnyGas = Annotated[
    indicator.IndicatorSpec | otto.OttoSpec | diesel.DieselSpec | dual.DualSpec, Field(discriminator="kind")
]


def kind_named(name: str) -> AnyGasKind:
    """Give the kind of that name."""
    return next(kind for kind in KINDS if kind.name == name)


def kind_of(spec: GasSpec) -> AnyGasKind:
    """Give the kind of a gas model."""
    return kind_named(spec.kind)
