"""What a mechanism's forces come to, of whichever kind it is."""

from typing import Generic, NamedTuple, TypeVar

from cranktrain.linkage.forces import Wrench
from cranktrain.motion import Array

Joints = TypeVar("Joints", bound=tuple[Wrench, ...], covariant=True)


Each = TypeVar("Each")
"""What each moving link of a mechanism has: its `Link`, its `Body`, or the `Wrench` that it bears."""


class Forces(NamedTuple, Generic[Joints]):
    """Wrenches in the joints, the torque that must be applied to the crank, and that of friction on it. [N·m]

    driving_torque is what the joints' reactions leave to the shaft. friction_torque is what the forces of friction do
    along the crank angle: all of the reactions that the torque by virtual work needs.
    """

    joints: Joints
    driving_torque: Array
    friction_torque: Array
