"""The slotted lever's table of the machine file."""

from typing import Literal

from cranktrain.language import _
from cranktrain.linkage import CrankAndPivot
from cranktrain.mechanisms.rocking_guide import RockingGuideSpec
from cranktrain.wording import precise


class SlottedLeverSpec(RockingGuideSpec, frozen=True):
    """Crank, pivot and the offset of the slot's line from it."""

    kind: Literal["slotted_lever"]


def slotted_lever_advice(geometry: CrankAndPivot) -> str:
    """Say how far the pivot must be for the crank to turn."""
    radius, offset = float(geometry.crank_radius), abs(float(geometry.offset))
    if radius <= offset:
        return _("ground_length must be more than crank_radius + |offset| = {least}").format(
            least=precise(radius + offset)
        )
    return _("ground_length must be more than {least}, or less than {most} for a lever that turns all round").format(
        least=precise(radius + offset), most=precise(radius - offset)
    )
