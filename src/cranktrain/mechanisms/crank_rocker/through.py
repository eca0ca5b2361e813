"""Crank-rockers that pass change points: parallelograms and kites, which come through by continuity."""

import numpy as np

from cranktrain.linkage import Crank, Ends, Pin, crank, fixed
from cranktrain.linkage.change_point import Hinged
from cranktrain.mechanisms.change_points import FORMS, Form
from cranktrain.mechanisms.crank_rocker.kinematics import CrankRocker, CrankRockerMotion
from cranktrain.motion import Array


def crank_rocker_through(form: Form, angle: Array, geometry: CrankRocker) -> CrankRockerMotion:
    """Four-bar linkage that passes change points, in one of its forms; parameters and returns as of `crank_rocker`."""
    crank_pin = crank(angle, Crank(geometry.crank_radius))
    group = Pin(geometry.rod_length, geometry.rocker_length, geometry.side)
    ends = Ends(crank_pin, fixed(geometry.ground_length, 0.0 * geometry.ground_length))
    still = 0.0 * geometry.ground_length
    motion = FORMS[form](Hinged(ends, fixed(still, still)), group)
    return CrankRockerMotion(crank_pin, motion.joint, motion.rod, motion.rocker)


def in_line(geometry: CrankRocker) -> Array:
    """Angles at which crank and ground lie in line, and with them all links of a form, shape (..., 2). [rad]"""
    return np.array([0.0, np.pi]) + 0.0 * geometry.crank_radius


def apart(form: Form, angle: Array, geometry: CrankRocker) -> Array:
    """How far the ends of a form are apart, which is all that it needs; of a parallelogram its rod's length. [m]"""
    crank_pin = crank(angle, Crank(geometry.crank_radius))
    distance = np.hypot(crank_pin.x.value - geometry.ground_length, crank_pin.y.value)
    return geometry.rod_length + 0.0 * distance if form == "parallelogram" else distance
