"""What is asked of a triad's walk round the turn."""

import numpy as np


def comes_back(walk, legs):
    """Whether the link is after the turn as it was before, shape (..., 1); else it has gone over to another mode."""
    x, y, angle = walk.pose.value[..., -1:] - walk.pose.value[..., :1]
    size = np.maximum.reduce([leg.point.radius for leg in legs])
    turned = np.abs(np.angle(np.exp(1j * angle)))
    return np.maximum(np.maximum(np.abs(x), np.abs(y)) / size, turned) <= 1e-3
