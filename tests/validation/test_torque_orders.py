"""Torque orders of a Wiebe cycle and of an in-line four: tests/golden/theory/torque_orders.json.

The trace is made here from the closed form of single-zone heat release without losses,
p V^γ = p₀ V₀^γ + (γ − 1) Q ∫ x_b′ V^(γ−1) dφ, and gas exchange at 1.05e5 and 0.97e5 Pa.
"""

import json
from pathlib import Path

import numpy as np
import pytest

from cranktrain.numerics.harmonics import harmonics
from cranktrain.questions.torque.fired import fired, firing_angles
from cranktrain.questions.torque.stars import shaft_harmonics

EXPECTED = json.loads((Path(__file__).parents[1] / "golden/theory/torque_orders.json").read_text(encoding="utf-8"))
CYCLE = 4 * np.pi
R, L, BORE, MASS, OMEGA = 0.045, 0.15, 0.08, 0.62, 350.0
COMPRESSION, GAMMA, BOTTOM, CRANKCASE = 10.0, 1.33, 1e5, 1e5
EXHAUST, INTAKE = 1.05e5, 0.97e5
START, DURATION, SHAPE, COMPLETENESS, HEAT = np.radians(-15), np.radians(50), 2.0, np.log(1000), 1000.0
FOUR = firing_angles(np.array([0, 2, 3, 1]), CYCLE)


def volume(phi):
    area = np.pi * BORE**2 / 4
    travel = R * (1 - np.cos(phi)) + L - np.sqrt(L**2 - (R * np.sin(phi)) ** 2)
    return area * (2 * R / (COMPRESSION - 1) + travel)


def burnt_rate(phi):
    share = np.clip((phi - START) / DURATION, 0, 1)
    power = SHAPE + 1
    return COMPLETENESS * power * share**SHAPE * np.exp(-COMPLETENESS * share**power) / DURATION


def pressure(phi):
    """Pressure by the angle from firing, 0 ≤ φ < 4π."""
    own = np.where(phi >= 3 * np.pi - 1e-9, phi - CYCLE, phi)
    node, weight = np.polynomial.legendre.leggauss(80)
    end = np.clip(own, START, START + DURATION)
    angle = START + (end - START)[:, np.newaxis] / 2 * (1 + node)
    released = (end - START) / 2 * np.sum(weight * burnt_rate(angle) * volume(angle) ** (GAMMA - 1), axis=-1)
    closed = (BOTTOM * volume(np.pi) ** GAMMA + (GAMMA - 1) * HEAT * released) / volume(own) ** GAMMA
    return np.where(own <= np.pi + 1e-9, closed, np.where(own < 2 * np.pi, EXHAUST, INTAKE))


def torque(n_points):
    phi = np.arange(n_points) * (CYCLE / n_points)
    root = np.sqrt(L**2 - (R * np.sin(phi)) ** 2)
    slope = R * np.sin(phi) + R**2 * np.sin(phi) * np.cos(phi) / root
    curvature = R * np.cos(phi) + R**2 * np.cos(2 * phi) / root + R**4 * (np.sin(phi) * np.cos(phi)) ** 2 / root**3
    force = (pressure(phi) - CRANKCASE) * np.pi * BORE**2 / 4 - MASS * OMEGA**2 * curvature
    return force * slope


@pytest.fixture(scope="module")
def piston():
    # kinks where combustion begins and at the bottom centres: error falls as 1/n²
    return torque(28800)


def test_orders_of_one_piston(piston):
    found = harmonics(piston, CYCLE)
    for order, expected in EXPECTED["orders"].items():
        at = round(2 * float(order))
        assert found.order[at] == pytest.approx(float(order), rel=1e-15)
        for part, name in ((found.cosine, "a_cos"), (found.sine, "b_sin"), (found.amplitude, "amplitude")):
            assert abs(part[at] - expected[name]) <= 1e-9 * np.abs(piston).max(), (order, name)


def test_in_line_four():
    piston = torque(14400)
    total = np.sum(fired(piston[np.newaxis], FOUR, CYCLE), axis=0)
    peak = np.abs(total).max()
    found = shaft_harmonics(harmonics(piston, CYCLE), FOUR)
    for value, name in (
        (total.max(), "I4_max"),
        (total.min(), "I4_min"),
        (found.mean, "I4_mean"),
        (found.amplitude[4], "I4_order2"),
        (found.amplitude[8], "I4_order4"),
    ):
        assert abs(value - EXPECTED[name]) <= 1e-11 * peak, name
    assert np.delete(found.amplitude, np.arange(0, len(found.order), 4)).max() <= 1e-12 * peak
