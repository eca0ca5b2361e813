"""The oscillating cylinder's table of the machine file."""

from typing import Literal

from cranktrain.language import _
from cranktrain.linkage import CrankAndPivot
from cranktrain.mechanisms.rocking_guide import RockingGuideSpec
from cranktrain.wording import precise


class OscillatingCylinderSpec(RockingGuideSpec, frozen=True):
    """Crank, trunnion and the offset of the cylinder's axis from it."""

    kind: Literal["oscillating_cylinder"]


def oscillating_cylinder_advice(geometry: CrankAndPivot) -> str:
    """Say how far the trunnion must be for the crank to turn."""
    radius, offset = float(geometry.crank_radius), abs(float(geometry.offset))
    return _("ground_length must be more than crank_radius + |offset| = {least}").format(least=precise(radius + offset))
