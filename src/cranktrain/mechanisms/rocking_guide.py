"""What mechanisms have in common whose crank rocks or turns a guide about a fixed pivot."""

from pydantic import Field

from cranktrain.language import N_
from cranktrain.linkage import CrankAndPivot
from cranktrain.mechanisms.spec import Master, MechanismSpec
from cranktrain.motion import chosen
from cranktrain.quantities import Given, Length, PositiveLength


class RockingGuideSpec(MechanismSpec, frozen=True):
    """Crank, pivot and the offset of the guide's line from it."""

    crank_radius: PositiveLength = Field(description=N_("From shaft centre to crank pin."))
    ground_length: PositiveLength
    offset: Length = Given(0.0, "0 mm")


def rocking_guide_geometry(spec: RockingGuideSpec, _master: Master | None = None) -> CrankAndPivot:
    """Lengths in SI."""
    radius, ground = spec.crank_radius.array, spec.ground_length.array
    return CrankAndPivot(radius, ground, spec.offset.array, chosen(ground >= radius, 1.0, -1.0))
