"""Sizing: which motor, how often it may start, what a clutch and a servo motor are asked for."""

import numpy as np
import pytest
from tests.motors import CATALOGUE, SYNCHRONOUS

from cranktrain.motors.cage.catalogue import four_pole_motors
from cranktrain.motors.cage.law import cage_breaks, cage_torque, catalogue_curve
from cranktrain.questions.sizing.checks import CRITERIA, TorqueDemand, motor_choice
from cranktrain.questions.sizing.clutch import Engagement, engaged, held_torque
from cranktrain.questions.sizing.duty import rms_torque
from cranktrain.questions.sizing.starting import inertia_ratio, loaded_start, starts_per_hour


def demand(rms, peak, start):
    """The same of every motor, shape (..., 1)."""
    return TorqueDemand(*(np.asarray(one, dtype=float)[..., np.newaxis] for one in (rms, peak, start)))


class TestChoice:
    motors = four_pole_motors()

    def test_each_criterion_may_govern(self):
        found = motor_choice(demand([100.0, 10.0, 10.0], [10.0, 240.0, 10.0], [10.0, 10.0, 150.0]), self.motors)
        assert [CRITERIA[which] for which in found.governs] == ["rms", "peak", "start"]
        assert [CRITERIA[which] for which in found.misses] == ["rms", "peak", "start"]
        np.testing.assert_allclose(found.misses_by, np.max(found.smaller_uses, axis=-1) - 1)
        assert np.all(found.misses_by > 0)
        assert np.all(np.max(found.uses, axis=-1) <= 1)

    def test_none_is_enough(self):
        found = motor_choice(demand(3000.0, 10.0, 10.0), self.motors)
        assert (found.motor, found.governs) == (-1, -1)
        assert np.all(np.isnan(found.uses))
        assert found.misses_by == pytest.approx(3000.0 / self.motors.values.rated_torque[-1] - 1)

    def test_the_smallest_is_enough(self):
        found = motor_choice(demand(0.5, 0.5, 0.5), self.motors)
        assert (found.motor, found.misses) == (0, -1)
        assert np.isnan(found.misses_by)

    def test_a_demand_may_hang_on_the_motor(self):
        """As where its inertia has to be accelerated too: here so that only the largest is asked for little."""
        rms = np.where(self.motors.power == self.motors.power[-1], 1.0, 1e6)
        assert motor_choice(TorqueDemand(rms, rms, rms), self.motors).motor == 29


def test_starts_per_hour_fall_with_what_is_driven():
    assert starts_per_hour(3000.0, 0.02, 0.04) == pytest.approx(1000.0)
    assert starts_per_hour(3000.0, 0.02, 0.04, 0.5) == pytest.approx(500.0)


def test_inertia_ratio_goes_with_the_square_of_the_ratio():
    assert inertia_ratio(32.0, 40.0, 0.02) == pytest.approx(1.0)


class TestClutch:
    both = Engagement(40.0, 6.0, 900.0, 150.0, 40.0, 5.0)

    def test_energy(self):
        """What is lost is heat, and the work of the load."""
        found = engaged(self.both)
        before, after = 0.5 * (40.0 * 40.0**2 + 6.0 * 5.0**2), 0.5 * 46.0 * found.speed**2
        load = 150.0 * 0.5 * (5.0 + found.speed) * found.slip_time
        assert before - after == pytest.approx(found.heat + load, rel=1e-13)

    def test_momentum(self):
        found = engaged(self.both)
        assert 46.0 * found.speed == pytest.approx(40.0 * 40.0 + 6.0 * 5.0 - 150.0 * found.slip_time, rel=1e-13)

    def test_too_weak(self):
        """The load slows the driven side more than the clutch slows the driving one: they never meet."""
        assert np.all(np.isnan(engaged(self.both._replace(torque=0.999 * 150.0 * 40.0 / 46.0))))

    def test_held(self):
        """Of no torque on the driving side the load slows both."""
        assert held_torque(self.both, 0.0) == pytest.approx(150.0 * 40.0 / 46.0)
        assert held_torque(self.both, 150.0) == pytest.approx(150.0)


def test_a_pause_cools_less():
    """One second of 30 N·m, then three at rest, which count as one and a half."""
    torque, time = np.array([30.0, 30.0, 0.0, 0.0]), np.array([0.0, 1.0, 1.0, 4.0])
    assert rms_torque(torque, time) == pytest.approx(15.0)
    assert rms_torque(torque, time, np.array([1.0, 1.0, 0.5])) == pytest.approx(30.0 / np.sqrt(2.5))


def test_loaded_starts_of_designs_are_those_of_each_alone():
    """Of curves with breaks, too; a stuck one beside one that gets up."""
    inertia, loads = np.array([0.1, 0.3, 0.2]), np.array([[10.0], [40.0], [95.0]])
    motor = catalogue_curve(CATALOGUE)
    breaks = [float(speed) for speed in sorted(cage_breaks(motor).speeds)]
    speeds = np.tile([*breaks, 0.97 * SYNCHRONOUS], (3, 1))
    together = loaded_start(lambda w: cage_torque(w, motor), lambda w: 0 * w + loads, inertia, SYNCHRONOUS, speeds)
    assert np.isnan(together.time).tolist() == [False, False, True]
    for design in range(2):
        alone = loaded_start(
            lambda w: cage_torque(w, motor),
            lambda w, by=loads[design]: 0 * w + by,
            inertia[design],
            SYNCHRONOUS,
            speeds[design],
        )
        np.testing.assert_allclose(np.array(together)[:, design], alone, rtol=1e-14)
    kinetic = 0.5 * 0.1 * (0.97 * SYNCHRONOUS) ** 2
    assert together.rotor_heat[0] > kinetic
