"""The articulated rod's table of the machine file."""

from typing import ClassVar, Literal

import numpy as np
from pydantic import Field

from cranktrain.language import N_, Words, _
from cranktrain.mechanisms.articulated_rod.kinematics import ArticulatedRod, articulated_rod
from cranktrain.mechanisms.spec import Master, MechanismSpec
from cranktrain.numerics import largest
from cranktrain.quantities import Angle, Given, Length, NonNegativeLength, PositiveLength
from cranktrain.saying.wording import as_limit


class ArticulatedRodSpec(MechanismSpec, frozen=True):
    """A slave rod on a knuckle pin of the master rod that works on the same throw in bank `master`."""

    kind: Literal["articulated_rod"]
    master: str = Field(description=N_("The bank whose rod, on the same throw, carries the knuckle pin."))
    knuckle_radius: NonNegativeLength = Field(description=N_("From crank pin to knuckle pin."))
    rod_length: PositiveLength = Field(description=N_("From knuckle pin to the slave's piston pin."))
    articulation_angle: Angle = Field(
        description=N_("From the master rod to the knuckle pin about the crank pin, in the sense of rotation.")
    )
    offset: Length = Field(
        default=Given(0.0, "0 mm"),
        description=N_("Of the slave's line of stroke from the shaft, in its own cylinder's axes."),
    )

    master_field: ClassVar[str | None] = "master"


def articulated_rod_geometry(spec: ArticulatedRodSpec, master: Master | None) -> ArticulatedRod:
    """Geometry of master and slave in SI; the slave's axis counts from the master's."""
    assert master is not None  # the layout finds the master or refuses the machine
    return ArticulatedRod(
        master.geometry,
        spec.knuckle_radius.array,
        spec.articulation_angle.array,
        master.bank_angle,
        spec.rod_length.array,
        spec.offset.array,
    )


def articulated_rod_advice(geometry: ArticulatedRod) -> Words:
    """Say how long the slave rod must be; its master closes."""
    farthest = largest(lambda phi: np.abs(articulated_rod(phi, geometry).knuckle.y.value - geometry.offset))
    return _("rod_length must be more than {least}", least=as_limit(float(farthest.value[0])))
