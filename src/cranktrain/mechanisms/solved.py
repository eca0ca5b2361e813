"""What a mechanism's forces come to, of whichever kind it is."""

from typing import NamedTuple

from cranktrain.linkage.forces import Wrench
from cranktrain.motion import Array


class Forces(NamedTuple):
    """Wrenches in the joints, the torque that must be applied to the crank, and that of friction on it. [N·m]

    joints: in the order of the kind's `reactions`, which name them. driving_torque is what their reactions leave to the
    shaft. friction_torque is what the forces of friction do along the crank angle: all of the reactions that the torque
    by virtual work needs.
    """

    joints: tuple[Wrench, ...]
    driving_torque: Array
    friction_torque: Array
