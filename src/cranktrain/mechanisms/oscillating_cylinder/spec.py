"""The oscillating cylinder's table of the machine file."""

from typing import Literal

from pydantic import Field

from cranktrain.language import N_, _
from cranktrain.mechanisms.kind import Master, MechanismSpec
from cranktrain.mechanisms.oscillating_cylinder.kinematics import OscillatingCylinder
from cranktrain.motion import single
from cranktrain.quantities import Given, Length, PositiveLength
from cranktrain.wording import precise


class OscillatingCylinderSpec(MechanismSpec, frozen=True):
    """Crank, trunnion and the offset of the cylinder's axis from it."""

    kind: Literal["oscillating_cylinder"]
    crank_radius: PositiveLength = Field(description=N_("From shaft centre to crank pin."))
    ground_length: PositiveLength = Field(
        description=N_("From shaft centre to the trunnion about which the cylinder rocks.")
    )
    offset: Length = Field(
        default=Given(0.0, "0 mm"),
        description=N_("Of the cylinder's axis from the trunnion, to the left of its direction toward the crank pin."),
    )

    @property
    def rod_field(self) -> str:
        """There is no rod: the ground decides whether it closes."""
        return "ground_length"


def oscillating_cylinder_geometry(spec: OscillatingCylinderSpec, master: Master | None = None) -> OscillatingCylinder:
    """Lengths in SI."""
    del master
    radius, ground = spec.crank_radius.si, spec.ground_length.si
    way = 1.0 if ground >= radius else -1.0
    return OscillatingCylinder(single(radius), single(ground), single(spec.offset.si), single(way))


def oscillating_cylinder_advice(geometry: OscillatingCylinder) -> str:
    """Say how far the trunnion must be for the crank to turn."""
    radius, offset = float(geometry.crank_radius), abs(float(geometry.offset))
    return _("ground_length must be more than crank_radius + |offset| = {least}").format(least=precise(radius + offset))
