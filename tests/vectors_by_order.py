"""What tests ask of vectors by order beside what the program does: other axes, and the largest length."""

import numpy as np

from cranktrain.numerics import largest
from cranktrain.numerics.plane_vectors import vector_curve


def turned_vectors(of, angle):
    """Vectors in axes from which their own are turned by an angle [rad] of shape (...), from x toward y."""
    turn = np.exp(1j * np.asarray(angle))[..., np.newaxis]
    return of._replace(forward=of.forward * turn, backward=of.backward * turn)


def largest_length(of):
    """Largest length of the vector of all orders together over a turn."""
    return largest(lambda angle: np.abs(vector_curve(of, angle)))
