"""Forces of Walschaerts' gear: those of its chain."""

from cranktrain.mechanisms.chain.forces import chain_dynamics
from cranktrain.mechanisms.walschaerts.kinematics import STRUCTURE, walschaerts_size

DYNAMICS = chain_dynamics(STRUCTURE, walschaerts_size)
