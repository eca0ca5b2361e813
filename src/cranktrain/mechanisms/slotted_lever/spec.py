"""The slotted lever's table of the machine file."""

from typing import Literal

from pydantic import Field

from cranktrain.language import N_, Words, _
from cranktrain.linkage import CrankAndPivot
from cranktrain.mechanisms.rocking_guide import RockingGuideSpec
from cranktrain.quantities import Given, Length, PositiveLength
from cranktrain.saying.wording import as_limit


class SlottedLeverSpec(RockingGuideSpec, frozen=True):
    """Crank, pivot and the offset of the slot's line from it."""

    kind: Literal["slotted_lever"]
    ground_length: PositiveLength = Field(
        description=N_("From shaft centre to the lever's pivot; shorter than the crank, the lever turns.")
    )
    offset: Length = Field(
        default=Given(0.0, "0 mm"),
        description=N_("Of the slot's line from the pivot, to the left of its direction toward the crank pin."),
    )


def slotted_lever_advice(geometry: CrankAndPivot) -> Words:
    """Say how far the pivot must be for the crank to turn."""
    radius, offset = float(geometry.crank_radius), abs(float(geometry.offset))
    if radius <= offset:
        return _("ground_length must be more than crank_radius + |offset| = {least}", least=as_limit(radius + offset))
    return _(
        "ground_length must be more than {least}, or less than {most} for a lever that turns all round",
        least=as_limit(radius + offset),
        most=as_limit(radius - offset),
    )
