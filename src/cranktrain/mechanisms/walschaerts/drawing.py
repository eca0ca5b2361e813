"""Walschaerts' gear, to be drawn."""

from cranktrain.mechanisms.chain.drawing import chain_drawing
from cranktrain.mechanisms.kind import Drawing
from cranktrain.mechanisms.walschaerts.kinematics import STRUCTURE, Walschaerts, walschaerts_size
from cranktrain.motion import Array


def walschaerts_drawing(angle: Array, geometry: Walschaerts) -> Drawing:
    """Positions of all joints at each angle, shape (..., n), and what joins them; the valve's guide comes first."""
    return chain_drawing(STRUCTURE, angle, walschaerts_size(geometry))
