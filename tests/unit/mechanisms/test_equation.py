"""Equations of motion as functions of the crank angle: compiled as on arrays, and an energy that stays."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from tests.contract.force_kernels import KINDS as EXAMPLES

from cranktrain.linkage.forces import Body, Gravity
from cranktrain.mechanisms import KINDS
from cranktrain.mechanisms.equation import compiled_equation, equation_of_motion
from cranktrain.mechanisms.slider_crank.kinematics import SliderCrank

ANGLES = np.linspace(0.0, 6.0, 7)


def flat(equation):
    return np.array([equation.inertia.value, equation.inertia.first, equation.load])


@pytest.mark.parametrize("name", EXAMPLES)
def test_compiled_for_numbers(name):
    kind = KINDS.named(name)
    _, geometry, bodies, _ = EXAMPLES[name](0.0, float, 1.0)
    gravity = Gravity(0.5, -9.0)
    expected = flat(equation_of_motion(kind)(ANGLES, geometry, bodies, 5.0, gravity))
    at = compiled_equation(kind)
    got = np.transpose([flat(at(float(angle), geometry, bodies, 5.0, gravity)) for angle in ANGLES])
    apart = np.max(np.abs(got - expected), axis=-1) / np.max(np.abs(expected), axis=-1)
    assert np.all(apart < 2e-15)


def test_energy_of_a_crank_left_alone():
    """Swinging under its weight: the kinetic energy ½Jω² is what the weights have given."""
    kind = KINDS.named("slider_crank")
    at = equation_of_motion(kind)
    geometry = SliderCrank(0.1, 0.3, 0.02)
    bodies = (Body(3.0, 0.05, 0.01, 0.02), Body(2.0, 0.1, 0.02, 0.03), Body(4.0, 0.0, 0.0, 0.0))
    gravity = Gravity(-9.0, -3.0)

    def rate(_time, state):
        phi, omega, _work = state
        inertia, load = at(phi, geometry, bodies, 7.0, gravity)
        return [omega, (load - 0.5 * inertia.first * omega**2) / inertia.value, load * omega]

    found = solve_ivp(rate, (0.0, 3.0), [0.2, 1.5, 0.0], rtol=1e-12, atol=1e-13, method="DOP853")
    phi, omega, work = found.y
    kinetic = 0.5 * at(phi, geometry, bodies, 7.0, gravity).inertia.value * omega**2
    np.testing.assert_allclose(kinetic - work, kinetic[0], atol=1e-9 * np.max(kinetic))
    assert np.ptp(phi) > 1.0
