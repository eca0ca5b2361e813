"""The Diesel cycle's table of the machine file."""

from typing import ClassVar, Literal

from pydantic import Field

from cranktrain.fluids.dual.spec import CUT_OFF, HeatRatio, IdealCycleSpec
from cranktrain.language import N_


class DieselSpec(IdealCycleSpec, frozen=True):
    """Diesel cycle: heat at constant pressure; the dual cycle with a pressure ratio of 1."""

    elsewhere: ClassVar = {**IdealCycleSpec.elsewhere, **CUT_OFF}

    kind: Literal["diesel"] = Field(description=N_("Kind of gas model."))
    cut_off_ratio: HeatRatio = Field(description=N_("Volume when heat ends, over the smallest volume."))
