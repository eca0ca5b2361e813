"""The articulated rod's table of the machine file."""

from typing import ClassVar, Literal

import numpy as np

from cranktrain.language import _
from cranktrain.mechanisms.articulated_rod.kinematics import ArticulatedRod, articulated_rod
from cranktrain.mechanisms.spec import Master, MechanismSpec
from cranktrain.motion import single
from cranktrain.numerics import largest
from cranktrain.quantities import Angle, Given, Length, NonNegativeLength, PositiveLength
from cranktrain.wording import precise


class ArticulatedRodSpec(MechanismSpec, frozen=True):
    """A slave rod on a knuckle pin of the master rod that works on the same throw in bank `master`."""

    kind: Literal["articulated_rod"]
    master: str
    knuckle_radius: NonNegativeLength
    rod_length: PositiveLength
    articulation_angle: Angle
    offset: Length = Given(0.0, "0 mm")

    master_field: ClassVar[str | None] = "master"


def articulated_rod_geometry(spec: ArticulatedRodSpec, master: Master | None) -> ArticulatedRod:
    """Geometry of master and slave in SI; the slave's axis counts from the master's."""
    assert master is not None  # the layout finds the master or refuses the machine
    return ArticulatedRod(
        master.geometry,
        single(spec.knuckle_radius.si),
        single(spec.articulation_angle.si),
        single(master.bank_angle),
        single(spec.rod_length.si),
        single(spec.offset.si),
    )


def articulated_rod_advice(geometry: ArticulatedRod) -> str:
    """Say how long the slave rod must be; its master closes."""
    farthest = largest(lambda phi: np.abs(articulated_rod(phi, geometry).knuckle.y.value - geometry.offset))
    return _("rod_length must be more than {least}").format(least=precise(float(farthest.value[0])))
