"""Loops over the angles that fill a table as those of `by_hand` do, and call the compiled kernel at each angle.

Those for points alone fill only what a program gives that knows no directions of links. The kernel is the same; of what
nobody reads, the compiler leaves out what it can.
"""

import numpy as np
from numba import njit

from cranktrain.fluids import VolumeLimits, chamber_state
from cranktrain.fluids.dual import ideal_pressure
from cranktrain.linkage import compiled
from cranktrain.mechanisms.crank_rocker.kinematics import CrankRocker, crank_rocker
from cranktrain.mechanisms.on_crank import force_on_slider
from cranktrain.mechanisms.slider_crank.forces import slider_crank_forces
from cranktrain.mechanisms.slider_crank.kinematics import SliderCrank, slider_crank
from cranktrain.motion import Coefficient

slider_crank_at = compiled(slider_crank)
crank_rocker_at = compiled(crank_rocker)
slider_crank_forces_at = compiled(slider_crank_forces)
force_on_slider_at = compiled(force_on_slider)
chamber_state_at = compiled(chamber_state)
ideal_pressure_at = compiled(ideal_pressure)


@njit(error_model="numpy")
def slider_crank_loop(angles, crank_radius, rod_length, offset, table):
    """Fill `table`, a row per angle, with the columns of `by_hand.slider_crank_numpy`."""
    geometry = SliderCrank(crank_radius, rod_length, offset)
    for i in range(angles.size):
        motion = slider_crank_at(angles[i], geometry)
        pin, slider, rod = motion.pin, motion.slider, motion.rod
        table[i, 0] = pin.x.value
        table[i, 1] = pin.x.first
        table[i, 2] = pin.x.second
        table[i, 3] = pin.y.value
        table[i, 4] = pin.y.first
        table[i, 5] = pin.y.second
        table[i, 6] = slider.value
        table[i, 7] = slider.first
        table[i, 8] = slider.second
        table[i, 9] = rod.angle.value
        table[i, 10] = rod.angle.first
        table[i, 11] = rod.angle.second
        table[i, 12] = rod.cos
        table[i, 13] = rod.sin


@njit(error_model="numpy")
def crank_rocker_loop(angles, crank_radius, rod_length, rocker_length, ground_length, side, table):
    """Fill `table`, a row per angle, with the columns of `by_hand.crank_rocker_numpy`."""
    geometry = CrankRocker(crank_radius, rod_length, rocker_length, ground_length, side)
    for i in range(angles.size):
        motion = crank_rocker_at(angles[i], geometry)
        pin, joint, rod, rocker = motion.pin, motion.joint, motion.rod, motion.rocker
        table[i, 0] = pin.x.value
        table[i, 1] = pin.x.first
        table[i, 2] = pin.x.second
        table[i, 3] = pin.y.value
        table[i, 4] = pin.y.first
        table[i, 5] = pin.y.second
        table[i, 6] = joint.x.value
        table[i, 7] = joint.x.first
        table[i, 8] = joint.x.second
        table[i, 9] = joint.y.value
        table[i, 10] = joint.y.first
        table[i, 11] = joint.y.second
        table[i, 12] = rod.angle.value
        table[i, 13] = rod.angle.first
        table[i, 14] = rod.angle.second
        table[i, 15] = rod.cos
        table[i, 16] = rod.sin
        table[i, 17] = rocker.angle.value
        table[i, 18] = rocker.angle.first
        table[i, 19] = rocker.angle.second
        table[i, 20] = rocker.cos
        table[i, 21] = rocker.sin


@njit(error_model="numpy")
def slider_crank_points_loop(angles, crank_radius, rod_length, offset, table):
    """Fill `table`, a row per angle, with crank pin and slider."""
    geometry = SliderCrank(crank_radius, rod_length, offset)
    for i in range(angles.size):
        motion = slider_crank_at(angles[i], geometry)
        pin, slider = motion.pin, motion.slider
        table[i, 0] = pin.x.value
        table[i, 1] = pin.x.first
        table[i, 2] = pin.x.second
        table[i, 3] = pin.y.value
        table[i, 4] = pin.y.first
        table[i, 5] = pin.y.second
        table[i, 6] = slider.value
        table[i, 7] = slider.first
        table[i, 8] = slider.second


@njit(error_model="numpy")
def crank_rocker_points_loop(angles, crank_radius, rod_length, rocker_length, ground_length, side, table):
    """Fill `table`, a row per angle, with crank pin and joint."""
    geometry = CrankRocker(crank_radius, rod_length, rocker_length, ground_length, side)
    for i in range(angles.size):
        motion = crank_rocker_at(angles[i], geometry)
        pin, joint = motion.pin, motion.joint
        table[i, 0] = pin.x.value
        table[i, 1] = pin.x.first
        table[i, 2] = pin.x.second
        table[i, 3] = pin.y.value
        table[i, 4] = pin.y.first
        table[i, 5] = pin.y.second
        table[i, 6] = joint.x.value
        table[i, 7] = joint.x.first
        table[i, 8] = joint.x.second
        table[i, 9] = joint.y.value
        table[i, 10] = joint.y.first
        table[i, 11] = joint.y.second


@njit(error_model="numpy")
def slider_crank_forces_loop(angles, geometry, bodies, pressing, conditions, table):
    """Fill `table`, a row per angle, with the columns of `by_hand.slider_crank_forces_numpy`."""
    for i in range(angles.size):
        motion = slider_crank_at(angles[i], geometry)
        load = force_on_slider_at(motion, geometry, -pressing)
        forces = slider_crank_forces_at(motion, geometry, bodies, load, conditions)
        main_bearing, crank_pin, wrist_pin, guide = forces.joints
        table[i, 0] = main_bearing.x
        table[i, 1] = main_bearing.y
        table[i, 2] = crank_pin.x
        table[i, 3] = crank_pin.y
        table[i, 4] = wrist_pin.x
        table[i, 5] = wrist_pin.y
        table[i, 6] = guide.y
        table[i, 7] = forces.driving_torque


@njit(error_model="numpy")
def ideal_gas_loop(angles, crank_radius, rod_length, area, clearance, cycle, table):
    """Fill `table`, a row per angle, with the columns of `by_hand.ideal_gas_numpy`."""
    geometry = SliderCrank(crank_radius, rod_length, 0.0)
    limits = VolumeLimits(clearance, clearance + 2.0 * area * crank_radius)
    for i in range(angles.size):
        slider = slider_crank_at(angles[i], geometry).slider
        below = crank_radius + rod_length - slider.value
        volume = Coefficient(clearance + area * below, -area * slider.first, -area * slider.second)
        table[i, 0] = volume.value
        table[i, 1] = ideal_pressure_at(chamber_state_at(volume, limits, angles[i], 4 * np.pi), cycle)
