"""Forces of Stephenson's link motion: those of its chain."""

from functools import partial

from cranktrain.mechanisms.chain.forces import chain_dynamics
from cranktrain.mechanisms.chain.steps import Structure
from cranktrain.mechanisms.kind import Dynamics
from cranktrain.mechanisms.stephenson.kinematics import stephenson_size


def stephenson_dynamics(structure: Structure) -> Dynamics:
    """What forces gears with a curved slot give, or with a straight one."""
    return chain_dynamics(structure, partial(stephenson_size, structure))
