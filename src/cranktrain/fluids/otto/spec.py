"""The Otto cycle's table of the machine file."""

from typing import ClassVar, Literal

from pydantic import Field

from cranktrain.fluids.dual.spec import RAISED, HeatRatio, IdealCycleSpec
from cranktrain.language import N_


class OttoSpec(IdealCycleSpec, frozen=True):
    """Otto cycle: heat at constant volume; the dual cycle with a cut-off ratio of 1."""

    elsewhere: ClassVar = {**IdealCycleSpec.elsewhere, **RAISED}

    kind: Literal["otto"] = Field(description=N_("Kind of gas model."))
    pressure_ratio: HeatRatio = Field(description=N_("By how much heat raises the pressure, p₃/p₂."))
