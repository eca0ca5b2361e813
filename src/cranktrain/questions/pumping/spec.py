"""The table [pumping] of the machine file: which loads are the well's and the counterbalance's, and what is rated."""

from pydantic import Field

from cranktrain.language import N_
from cranktrain.quantities import PositiveForce, PositiveTorque
from cranktrain.spec import Spec


class PumpingSpec(Spec, frozen=True):
    """A beam pumping unit: one crank-rocker whose rocker carries the polished rod, weights on its crank."""

    card: str = Field(
        min_length=1, description=N_("Name of the load that the polished rod pulls with, [load.NAME] on the rocker.")
    )
    counterbalance: str | None = Field(
        default=None, min_length=1, description=N_("Name of the load that is the weights on the crank.")
    )
    rated_torque: PositiveTorque | None = Field(
        default=None, description=N_("What the gearbox may give at its slow shaft.")
    )
    rated_load: PositiveForce | None = Field(default=None, description=N_("What the polished rod may pull with."))
