"""What kinds of motors have in common with each other, or what their numbers say at single points."""

import numpy as np
import pytest
from tests.motors import CAGE, CIRCUIT, FULL_LOAD, ROTOR, SYNCHRONOUS

from cranktrain.motors.cage.inverter import FluxInverter, flux_inverter_torque
from cranktrain.motors.cage.law import cage_torque, kloss_curve
from cranktrain.motors.cage.soft_start import SoftStart, limit_slip, soft_start_torque, voltage_part
from cranktrain.motors.cage.star_delta import StarDelta, star_delta_torque
from cranktrain.motors.circuit.inverter import Inverter, inverter_torque
from cranktrain.motors.circuit.law import kloss_of_circuit
from cranktrain.motors.induction.current import line_current, rotor_current, rotor_heat
from cranktrain.motors.induction.kloss import slip_of
from cranktrain.motors.induction.ramp import Ramp
from cranktrain.motors.prime_mover.law import PrimeMover, prime_mover_breaks, prime_mover_torque
from cranktrain.motors.series.law import SeriesMotor, series_torque
from cranktrain.motors.servo.law import Servo, servo_torque
from cranktrain.motors.shunt.law import shunt_motor, shunt_torque
from cranktrain.motors.table.law import TableMotor, table_torque
from cranktrain.motors.wound_rotor.law import wound_rotor_torque
from cranktrain.motors.wound_rotor.rheostat import (
    Rheostat,
    SteppedRotor,
    TimedRotor,
    fewest_steps,
    resistance_steps,
    stepped_rotor_torque,
    timed_rotor_torque,
)

SPEEDS = np.linspace(-100.0, 250.0, 71)


def test_a_field_that_turns_the_other_way_is_the_mirror():
    mirrored = CAGE._replace(synchronous_speed=-SYNCHRONOUS)
    np.testing.assert_allclose(cage_torque(-SPEEDS, mirrored), -cage_torque(SPEEDS, CAGE), rtol=1e-13)


def test_plugging_brakes_with_the_starting_torque():
    mirrored = CAGE._replace(synchronous_speed=-SYNCHRONOUS)
    np.testing.assert_allclose(cage_torque(np.array([150.0, 30.0]), mirrored), -CAGE.starting_torque)


def test_simplified_curve_is_odd_about_synchronous_speed():
    away = np.linspace(0.0, 0.135, 9) * SYNCHRONOUS
    sums = cage_torque(SYNCHRONOUS + away, CAGE) + cage_torque(SYNCHRONOUS - away, CAGE)
    np.testing.assert_allclose(sums, 0.0, atol=1e-10)


class TestStarDelta:
    start = StarDelta(CAGE, 2.0, 0.5)

    def test_a_third_then_nothing_then_all(self):
        direct = cage_torque(SPEEDS, CAGE)
        for time, part in ((0.0, 1 / 3), (1.99, 1 / 3), (2.0, 0.0), (2.49, 0.0), (2.5, 1.0), (9.0, 1.0)):
            np.testing.assert_allclose(star_delta_torque(SPEEDS, time, self.start), part * direct, rtol=1e-15)


class TestSoftStart:
    start = SoftStart(CAGE, 0.4, 2.0, 7.2, 3.0)

    def test_ramp_alone(self):
        free = self.start._replace(current_limit=np.inf)
        for time, voltage in ((0.0, 0.4), (1.0, 0.7), (2.0, 1.0), (5.0, 1.0)):
            np.testing.assert_allclose(
                soft_start_torque(SPEEDS, time, free), voltage**2 * cage_torque(SPEEDS, CAGE), rtol=1e-14
            )

    def test_current_stays_within_its_limit_and_reaches_it(self):
        slips = np.linspace(0.01, 1.0, 100)
        current = voltage_part(slips, 5.0, self.start) * line_current(slips, CAGE.breakdown_slip, 7.2)
        assert np.max(current) == pytest.approx(3.0, rel=1e-14)
        above = slips > limit_slip(self.start)
        np.testing.assert_allclose(current[above], 3.0, rtol=1e-14)
        assert np.all(current[~above] < 3.0)

    def test_current_of_a_circuit_without_stator_resistance(self):
        """|V/(R/s + jX)| over that at standstill."""
        slips, rotor, reactance = np.linspace(0.05, 2.0, 20), 0.7, 2.6
        expected = np.abs((rotor + 1j * reactance) / (rotor / slips + 1j * reactance))
        np.testing.assert_allclose(line_current(slips, rotor / reactance, 1.0), expected, rtol=1e-14)

    def test_without_a_limit_that_matters_there_is_no_such_slip(self):
        assert np.isnan(limit_slip(self.start._replace(current_limit=8.0)))


def test_rotor_current_and_heat_are_those_of_the_circuit():
    speed = 0.9 * SYNCHRONOUS
    torque = cage_torque(speed, kloss_of_circuit(CIRCUIT))
    current = abs(230.0 / complex(0.9 + 0.7 / 0.1, 2.6))
    assert rotor_current(torque, slip_of(speed, SYNCHRONOUS), SYNCHRONOUS, 0.7) == pytest.approx(current, rel=1e-12)
    assert rotor_heat(torque, speed, SYNCHRONOUS) == pytest.approx(3 * current**2 * 0.7, rel=1e-12)


class TestInverter:
    def test_at_rated_frequency_it_is_the_motor(self):
        inverter = Inverter(CIRCUIT, Ramp(0.0, SYNCHRONOUS, 2.0), 0.1, np.inf)
        np.testing.assert_allclose(
            inverter_torque(SPEEDS, 2.0, inverter), cage_torque(SPEEDS, kloss_of_circuit(CIRCUIT)), rtol=1e-11
        )

    @pytest.mark.parametrize("last", [20.0, 157.0, 300.0, -90.0])
    def test_without_stator_resistance_both_are_one(self, last):
        """Below rated frequency by slip speed alone, above it with the square of the frequency."""
        circuit = CIRCUIT._replace(stator_resistance=0.0)
        curve, ramp = kloss_of_circuit(circuit), Ramp(0.0, last, 1.0)
        flux = FluxInverter(SYNCHRONOUS, curve.breakdown_torque, curve.breakdown_slip, ramp, np.inf)
        np.testing.assert_allclose(
            inverter_torque(SPEEDS, 1.0, Inverter(circuit, ramp, 0.0, np.inf)),
            flux_inverter_torque(SPEEDS, 1.0, flux),
            rtol=1e-11,
        )

    def test_ramp_from_rest_without_boost_begins_with_nothing(self):
        inverter = Inverter(CIRCUIT, Ramp(0.0, SYNCHRONOUS, 2.0), 0.0, np.inf)
        assert inverter_torque(0.0, 0.0, inverter) == 0.0

    def test_limit_holds_both_ways(self):
        inverter = Inverter(CIRCUIT, Ramp(0.0, SYNCHRONOUS, 2.0), 0.0, 40.0)
        torque = inverter_torque(SPEEDS, 2.0, inverter)
        assert (np.min(torque), np.max(torque)) == (-40.0, 40.0)


class TestWoundRotor:
    def test_torque_hangs_on_slip_over_resistance(self):
        """Breakdown is as large with any resistance, and at standstill where the resistance is 1/s_b."""
        for resistance in (1.0, 2.0, 5.0):
            rotor = ROTOR._replace(resistance=resistance)
            speed = SYNCHRONOUS * (1 - 0.2 * resistance)
            assert wound_rotor_torque(speed, rotor) == pytest.approx(95.0, rel=1e-14)

    def test_steps_by_slip(self):
        steps = resistance_steps(3, 2.0, 0.03)
        stepped = SteppedRotor(ROTOR, Rheostat(steps.ratio, 3.0))
        slips = np.array([1.5, 0.99, 0.4, 0.38, 0.16, 0.15, 0.061, 0.059, 0.001, -0.2])
        in_step = [0, 0, 0, 1, 1, 2, 2, 3, 3, 3]
        resistance = np.append(steps.resistance, 1.0)[in_step]
        speeds = SYNCHRONOUS * (1 - slips)
        np.testing.assert_allclose(
            stepped_rotor_torque(speeds, stepped),
            wound_rotor_torque(speeds, ROTOR._replace(resistance=resistance)),
            rtol=1e-13,
        )

    def test_steps_by_time(self):
        timed = TimedRotor(ROTOR, Rheostat(2.5, 2.0), 0.5)
        for time, resistance in ((0.0, 6.25), (0.49, 6.25), (0.51, 2.5), (1.01, 1.0), (7.0, 1.0)):
            expected = wound_rotor_torque(SPEEDS, ROTOR._replace(resistance=resistance))
            np.testing.assert_allclose(timed_rotor_torque(SPEEDS, time, timed), expected, rtol=1e-15)

    def test_too_few_steps_for_full_load(self):
        n_steps = int(fewest_steps(2.0, 0.03, 1.0))
        assert resistance_steps(n_steps, 2.0, 0.03).switching_torque >= 1.0
        assert resistance_steps(n_steps - 1, 2.0, 0.03).switching_torque < 1.0
        assert np.isnan(fewest_steps(2.0, 0.03, 2.0))


class TestDirectCurrent:
    def test_shunt_passes_through_its_rated_point(self):
        motor = shunt_motor(50.0, 150.0, 160.0)
        np.testing.assert_allclose(shunt_torque(np.array([150.0, 160.0, 170.0]), motor), [50.0, 0.0, -50.0], atol=1e-12)

    def test_power_of_a_series_motor_balances(self):
        """Line power = heat + work."""
        motor, speed = SeriesMotor(220.0, 1.5, 0.04), 90.0
        current = np.sqrt(series_torque(speed, motor) / 0.04)
        heat, work = 1.5 * current**2, series_torque(speed, motor) * speed
        assert 220.0 * current == pytest.approx(heat + work, rel=1e-14)


def test_servo_gives_what_is_asked_within_torque_and_power():
    servo = Servo(20.0, 2000.0, np.array([5.0, 30.0, -30.0, 15.0, -15.0, 3.0]))
    np.testing.assert_allclose(
        servo_torque(np.array([0.0, 0.0, 0.0, 200.0, -400.0, 400.0]), servo), [5.0, 20.0, -20.0, 10.0, -5.0, 3.0]
    )
    assert servo_torque(1e6, Servo(20.0, np.inf, 30.0)) == 20.0


def test_table_goes_in_lines_and_on_level():
    table = TableMotor(np.array([0.0, 10.0, 30.0]), np.array([4.0, 6.0, 0.0]))
    np.testing.assert_allclose(table_torque(np.array([-5.0, 5.0, 10.0, 20.0, 40.0]), table), [4.0, 5.0, 6.0, 3.0, 0.0])


class TestPrimeMover:
    engine = PrimeMover(196.0, 188.0, 600.0, FULL_LOAD)

    def test_governor_within_full_load(self):
        speeds = np.array([30.0, 60.0, 110.0, 188.0, 192.0, 196.0, 250.0])
        np.testing.assert_allclose(prime_mover_torque(speeds, self.engine), [0.0, 0.0, 750.0, 600.0, 300.0, 0.0, 0.0])

    def test_it_leaves_full_load_where_the_governor_asks_for_less(self):
        (crossing,) = [speed for speed in prime_mover_breaks(self.engine).speeds if 185 < speed < 190]
        assert 600.0 * (196.0 - crossing) / 8.0 == pytest.approx(float(table_torque(crossing, FULL_LOAD)), rel=1e-12)


def test_kloss_at_synchronous_speed_is_no_exception():
    assert cage_torque(SYNCHRONOUS, kloss_curve(SYNCHRONOUS, 95.0, 0.2, 0.65)) == 0.0
