"""A slave without mass, by the formulas of a rod hung on a rod."""

import numpy as np

from cranktrain.linkage.forces import NO_FRICTION, Body, Conditions, Drive, Gravity, turned_wrench
from cranktrain.mechanisms.articulated_rod.forces import DYNAMICS, articulated_rod_forces, articulated_rod_load
from cranktrain.mechanisms.articulated_rod.kinematics import ArticulatedRod, articulated_rod
from cranktrain.mechanisms.slider_crank.kinematics import SliderCrank


def test_side_forces_on_slave_and_master():
    """From a derivation for massless rods, checked there by virtual work to 2e-12."""
    phi, force = np.linspace(0, 6, 50), 20e3
    gamma, zeta, radius = np.deg2rad(60), np.deg2rad(66.6), 0.085
    geometry = ArticulatedRod(SliderCrank(0.09, 0.32, 0.0), radius, zeta, gamma, 0.235, 0.0)
    motion = articulated_rod(phi, geometry)
    nothing = Body(0.0, 0.0, 0.0, 0.0)
    standing = Conditions(Drive(0.0, 0.0), Gravity(0.0, 0.0), (NO_FRICTION,))
    load = articulated_rod_load(motion, geometry, -force)
    found = articulated_rod_forces(motion, geometry, (nothing, nothing), load, standing)
    joints = DYNAMICS.by_joint(found.joints)
    beta = np.arcsin(0.09 * np.sin(phi) / 0.32)
    chi = np.arcsin((0.09 * np.sin(phi - gamma) + radius * np.sin(zeta - gamma - beta)) / 0.235)
    np.testing.assert_allclose(joints["guide"].y, force * np.tan(chi), atol=1e-10)
    eta = zeta - gamma + chi - beta
    master = turned_wrench(joints["master_guide"], -gamma)
    np.testing.assert_allclose(
        master.y, -force * radius * np.sin(eta) / (0.32 * np.cos(beta) * np.cos(chi)), atol=1e-10
    )
    np.testing.assert_allclose(master.x, 0.0, atol=1e-11)
    np.testing.assert_allclose(found.driving_torque, force * motion.slider.first, atol=1e-10)
