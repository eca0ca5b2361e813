"""What a mechanism's forces come to, of whichever kind it is."""

from typing import Generic, NamedTuple, TypeVar

from cranktrain.motion import Array

Joints = TypeVar("Joints")


class Forces(NamedTuple, Generic[Joints]):
    """Wrenches in the joints, and the torque that must be applied to the crank, by two ways that share little. [N·m]

    driving_torque is what the joints' reactions leave to the shaft; torque_by_work needs none of them but friction.
    """

    joints: Joints
    driving_torque: Array
    torque_by_work: Array
