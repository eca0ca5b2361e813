"""The slotted lever's table of the machine file."""

from typing import Literal

from pydantic import Field

from cranktrain.language import N_, _
from cranktrain.mechanisms.kind import Master, MechanismSpec
from cranktrain.mechanisms.slotted_lever.kinematics import SlottedLever
from cranktrain.motion import single
from cranktrain.quantities import Given, Length, PositiveLength
from cranktrain.wording import precise


class SlottedLeverSpec(MechanismSpec, frozen=True):
    """Crank, pivot and the offset of the slot's line from it."""

    kind: Literal["slotted_lever"]
    crank_radius: PositiveLength = Field(description=N_("From shaft centre to crank pin."))
    ground_length: PositiveLength = Field(
        description=N_("From shaft centre to the lever's pivot; shorter than the crank, the lever turns.")
    )
    offset: Length = Field(
        default=Given(0.0, "0 mm"),
        description=N_("Of the slot's line from the pivot, to the left of its direction toward the crank pin."),
    )

    @property
    def rod_field(self) -> str:
        """There is no rod: the ground decides whether it closes."""
        return "ground_length"


def slotted_lever_geometry(spec: SlottedLeverSpec, master: Master | None = None) -> SlottedLever:
    """Lengths in SI."""
    del master
    radius, ground = spec.crank_radius.si, spec.ground_length.si
    way = 1.0 if ground >= radius else -1.0
    return SlottedLever(single(radius), single(ground), single(spec.offset.si), single(way))


def slotted_lever_advice(geometry: SlottedLever) -> str:
    """Say how far the pivot must be for the crank to turn."""
    radius, offset = float(geometry.crank_radius), abs(float(geometry.offset))
    if radius <= offset:
        return _("ground_length must be more than crank_radius + |offset| = {least}").format(
            least=precise(radius + offset)
        )
    return _("ground_length must be more than {least}, or less than {most} for a lever that turns all round").format(
        least=precise(radius + offset), most=precise(radius - offset)
    )
