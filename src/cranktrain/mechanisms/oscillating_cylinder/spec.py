"""The oscillating cylinder's table of the machine file."""

from typing import Literal

from pydantic import Field

from cranktrain.language import N_, Words, _
from cranktrain.linkage import CrankAndPivot
from cranktrain.mechanisms.rocking_guide import RockingGuideSpec
from cranktrain.quantities import Given, Length, PositiveLength
from cranktrain.saying.wording import as_limit


class OscillatingCylinderSpec(RockingGuideSpec, frozen=True):
    """Crank, trunnion and the offset of the cylinder's axis from it."""

    kind: Literal["oscillating_cylinder"]
    ground_length: PositiveLength = Field(
        description=N_("From shaft centre to the trunnion about which the cylinder rocks.")
    )
    offset: Length = Field(
        default=Given(0.0, "0 mm"),
        description=N_("Of the cylinder's axis from the trunnion, to the left of its direction toward the crank pin."),
    )


def oscillating_cylinder_advice(geometry: CrankAndPivot) -> Words:
    """Say how far the trunnion must be for the crank to turn."""
    radius, offset = float(geometry.crank_radius), abs(float(geometry.offset))
    return _("ground_length must be more than crank_radius + |offset| = {least}", least=as_limit(radius + offset))
