"""The Diesel cycle's table of the machine file."""

from typing import Literal

from pydantic import Field

from cranktrain.fluids.dual.spec import HeatRatio, IdealCycleSpec
from cranktrain.language import N_


class DieselSpec(IdealCycleSpec, frozen=True):
    """Diesel cycle: heat at constant pressure; the dual cycle with a pressure ratio of 1."""

    kind: Literal["diesel"] = Field(description=N_("Kind of gas model."))
    cut_off_ratio: HeatRatio = Field(description=N_("Volume when heat ends, over the smallest volume."))
