"""Which size of motor for a torque over time, and which ratio; the reference case is that of the crank-rocker."""

import json
from pathlib import Path

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import minimize_scalar

from cranktrain.motors.cage.catalogue import four_pole_motors
from cranktrain.motors.cage.law import cage_torque, catalogue_curve
from cranktrain.motors.cage.range import motor_range
from cranktrain.motors.cage.spec import CageSpec
from cranktrain.questions.sizing.choosing import (
    ALL_CRITERIA,
    StartDemand,
    TorqueHistory,
    duty_factor,
    of_period,
    of_pieces,
    size_choice,
)
from cranktrain.questions.sizing.choosing_ratio import (
    CrankDemand,
    best_ratio,
    history_at,
    nearest_ratio,
    preferred_ratios,
    rms_by_ratio,
    transmitted_torque,
)
from cranktrain.questions.sizing.duty import rms_torque

SIZING = json.loads((Path(__file__).parents[3] / "golden/drive/sizing.json").read_text(encoding="utf-8"))["sizing"]
MOTORS = four_pole_motors()
PLACE = {round(power / 1e3, 3): place for place, power in enumerate(MOTORS.power)}
N_POINTS = 4001


def reference_rocker():
    """Coefficients over a turn of the reference's crank-rocker, by its closed form: α, α1', β' and what J takes."""
    r, rod, rocker, ground = 0.25, 0.7, 0.5, 0.8
    angle = np.linspace(0.0, 2 * np.pi, N_POINTS)
    bx, by = r * np.cos(angle), r * np.sin(angle)
    dx, dy = ground - bx, -by
    square = dx * dx + dy * dy
    k = (square + rod**2 - rocker**2) / (2 * square)
    h = np.sqrt(rod**2 / square - k * k)
    px, py = k * dx - h * dy, k * dy + h * dx
    beta, alpha1 = np.arctan2(py, px), np.arctan2(py - dy, px - dx)
    first = r * np.sin(angle - beta) / (rocker * np.sin(alpha1 - beta))
    of_rod = r * np.sin(angle - alpha1) / (rod * np.sin(alpha1 - beta))
    return angle, first, of_rod, beta


ANGLE, FIRST, _OF_ROD, _BETA = reference_rocker()
STATIC = 2000.0 * np.abs(FIRST) / (SIZING["i"] * SIZING["eta"])
HISTORY = TorqueHistory(STATIC, ANGLE / 3.9)


def reduced_inertia():
    """Of crank, rod and rocker of the reference; its rod's centre of mass lies at p = .33, q = .02."""
    x, q, rod, r, rocker = 0.33 / 0.7, 0.02, 0.7, 0.25, 0.5
    of_rod = (1 - x) * r**2 + x * rocker**2 * FIRST**2 - x * (1 - x) * rod**2 * _OF_ROD**2 + q**2 * _OF_ROD**2
    of_rod += 2 * q * r * _OF_ROD * np.sin(ANGLE - _BETA)
    return 2.0 + 60.0 * of_rod + 3.2 * _OF_ROD**2 + 50.0 * FIRST**2


class TestReference:
    found = size_choice(HISTORY, StartDemand(np.max(STATIC), np.mean(reduced_inertia()[:-1]) / 1600.0), MOTORS)

    def test_torques(self):
        assert self.found.rms[0] == pytest.approx(SIZING["static"]["T_rms"], rel=1e-6)
        assert self.found.peak[0] == pytest.approx(SIZING["static"]["T_max"], rel=1e-6)

    def test_four_kilowatts_pass_and_three_fail_by_rms_and_start(self):
        choice = self.found.choice
        assert MOTORS.power[choice.motor] == 1e3 * SIZING["picked"]["P"]
        smaller = dict(zip(ALL_CRITERIA, choice.smaller_uses, strict=True))
        assert smaller["rms"] - 1 == pytest.approx(0.128, abs=5e-4)
        assert smaller["start"] - 1 == pytest.approx(0.171, abs=5e-4)
        assert ALL_CRITERIA[choice.misses] == "start"
        assert choice.misses_by == pytest.approx(0.171, abs=5e-4)

    @pytest.mark.parametrize("power", SIZING["first_rows"])
    def test_every_check_of_the_sizes_around(self, power):
        row = SIZING["first_rows"][power]
        uses = dict(zip(ALL_CRITERIA, self.found.uses[PLACE[float(power)]], strict=True))
        assert {name: bool(uses[name] <= 1) for name in ("rms", "peak", "start")} == {
            name: row[name] for name in ("rms", "peak", "start")
        }

    def test_inertia_ratio(self):
        ratio = self.found.inertia_ratio[PLACE[4.0]]
        assert ratio == pytest.approx(SIZING["inertia_ratio_mean"], rel=1e-9)


class TestStart:
    start = StartDemand(np.array(10.0), np.array(0.4), np.array(12.0), np.array(1.5))

    def test_time_and_heat_are_those_of_the_equation_of_motion(self):
        found = size_choice(of_pieces(np.array([12.0]), np.array([1.0])), self.start, MOTORS)
        place = PLACE[7.5]
        curve = catalogue_curve(MOTORS.values)
        own = type(curve)(*(np.broadcast_to(field, MOTORS.power.shape)[place] for field in curve))
        inertia, top = 0.4 + MOTORS.inertia[place], own.synchronous_speed

        def slopes(_time, state):
            torque = 0.81 * cage_torque(state[0], own)
            return [(torque - 12.0) / inertia, torque * (top - state[0])]

        def there(_time, state):
            return state[0] - (1 - 2 * (1 - MOTORS.values.rated_speed[place] / top)) * top

        there.terminal = True
        run = solve_ivp(slopes, (0.0, 10.0), [0.0, 0.0], events=there, rtol=1e-10, atol=1e-9)
        assert found.start_time[place] == pytest.approx(run.t[-1], rel=1e-6)
        assert found.rotor_heat[place] == pytest.approx(run.y[1, -1], rel=1e-6)

    def test_a_start_that_takes_too_long_asks_for_a_larger_motor(self):
        free = self.start._replace(longest=np.array(np.inf))
        history = of_pieces(np.array([12.0]), np.array([1.0]))
        choices = [size_choice(history, one, MOTORS) for one in (free, self.start)]
        assert choices[0].choice.motor < choices[1].choice.motor
        assert ALL_CRITERIA[choices[1].choice.misses] == "start_time"
        assert choices[1].start_time[choices[1].choice.motor] <= 1.5

    def test_stuck_is_no_choice(self):
        found = size_choice(of_pieces(np.array([1.0]), np.array([1.0])), self.start, MOTORS)
        stuck = np.isnan(found.start_time)
        assert np.any(stuck)
        assert np.all(np.isinf(found.uses[stuck, -1]))


class TestOwnMotors:
    plate = {"kind": "cage", "breakdown_ratio": 3.2, "starting_ratio": 2.3, "pull_up_ratio": 1.8}  # noqa: RUF012

    def test_of_typical_sizes_it_is_the_catalogue(self):
        sizes = [CageSpec(kind="cage", size=f"{power} kW") for power in (5.5, 3, 4)]
        found, places = motor_range(sizes), [PLACE[power] for power in (3.0, 4.0, 5.5)]
        for ours, listed in zip(found.values, MOTORS.values, strict=True):
            np.testing.assert_array_equal(ours, listed[places])
        np.testing.assert_array_equal(found.inertia, MOTORS.inertia[places])
        assert found.is_typical

    def test_makers_motors_are_checked_as_well(self):
        """4 kW at 1460 rpm with the ratios of the reference's pick, beside a smaller one."""
        motors = motor_range(
            [
                CageSpec(**self.plate, power="4 kW", speed="1460 rpm", inertia="0.014 kg·m²"),
                CageSpec(**self.plate, power="3 kW", speed="1455 rpm"),
            ]
        )
        found = size_choice(HISTORY, StartDemand(np.max(STATIC)), motors)
        assert found.choice.motor == 1
        assert motors.values.rated_torque[1] == pytest.approx(SIZING["picked"]["Tn"], rel=1e-12)
        assert motors.inertia.tolist() == [0.0, 0.014]


class TestHistory:
    def test_pieces_have_the_rms_of_their_sum(self):
        history = of_pieces(np.array([30.0, -10.0, 0.0]), np.array([1.0, 2.0, 5.0]))
        assert rms_torque(history.torque, history.time) == pytest.approx(np.sqrt((900 + 200) / 8), rel=1e-15)

    def test_period(self):
        """A sine of 20 N·m: rms 20/√2, up to the straight lines between 720 samples."""
        history = of_period(20 * np.sin(np.linspace(0, 2 * np.pi, 720, endpoint=False)), np.array(3.0))
        assert rms_torque(history.torque, history.time) == pytest.approx(20 / np.sqrt(2), rel=1e-5)
        assert history.time[-1] == 3.0

    def test_the_rotor_takes_its_own(self):
        """Torque and acceleration in opposite phase: of one inertia nothing is left."""
        turn = np.sin(np.linspace(0, 2 * np.pi, 720, endpoint=False))
        history = of_period(10 * turn, np.array(1.0), -turn * 10 / MOTORS.inertia[5])
        found = size_choice(history, StartDemand(np.array(0.1)), MOTORS)
        assert found.rms[5] == pytest.approx(0.0, abs=1e-12)
        assert found.rms[6] > 0

    def test_many_histories_are_what_each_is_alone(self):
        torque = np.array([[30.0, 5.0], [300.0, 50.0]])
        together = size_choice(
            of_pieces(torque, np.ones((2, 2))), StartDemand(np.array([28.0, 28.0]), np.array([0.1, 2.0])), MOTORS
        )
        for place in range(2):
            alone = size_choice(
                of_pieces(torque[place], np.ones(2)),
                StartDemand(np.array(28.0), np.array([0.1, 2.0])[place]),
                MOTORS,
            )
            np.testing.assert_allclose(together.uses[place], alone.uses, rtol=1e-12)
            assert together.choice.motor[place] == alone.choice.motor


class TestDuty:
    def test_reference(self):
        assert duty_factor("S3") == pytest.approx(1.2911991026213605, rel=1e-12)
        assert duty_factor("S1") == 1.0

    def test_constant_losses_that_go_on_do_not_matter(self):
        """(1 − ab)(1 − q_c) over (1 − a)(1 − q_c): in S6 they cancel, as in S3 where rest cools as speed does."""
        a, b = np.exp(-240 / 1800), np.exp(-360 / 1800)
        expected = np.sqrt((1 - a * b) / (1 - a))
        for factor in (duty_factor("S6"), duty_factor("S6", constant_share=0.3), duty_factor("S3", cooling=1.0)):
            assert factor == pytest.approx(expected, rel=1e-13)

    def test_a_duty_lets_a_smaller_motor_do(self):
        history, start = of_pieces(np.array([25.0]), np.array([1.0])), StartDemand(np.array(1.0))
        running, resting = (size_choice(history, start, MOTORS, duty_factor(duty)) for duty in ("S1", "S3"))
        assert (MOTORS.power[running.choice.motor], MOTORS.power[resting.choice.motor]) == (4e3, 3e3)
        assert running.uses[0, 0] == pytest.approx(resting.uses[0, 0] * duty_factor("S3"), rel=1e-14)


def demand(efficiency=1.0):
    """A crank that turns evenly at 10 rad/s on the whole, with a load in one half."""
    time = np.linspace(0.0, 2 * np.pi / 10, 401)
    acceleration = 40.0 * np.cos(10 * time)
    static = np.where(np.sin(10 * time) > 0, 80.0, -20.0)
    return CrankDemand(static, 12.0 * acceleration, acceleration, time, np.array(efficiency), np.array(efficiency))


class TestRatio:
    def test_preferred_numbers(self):
        np.testing.assert_allclose(preferred_ratios(0.8, 1.2), [0.8, 0.9, 1.0, 1.12])
        assert preferred_ratios(1.0, 100.0).size == 41

    def test_nearest(self):
        found = nearest_ratio(np.array([38.7, 42.3]), preferred_ratios(1.0, 100.0))
        np.testing.assert_allclose(found.ratio, [40.0, 40.0])
        assert found.speed_ratio[0] == pytest.approx(38.7 / 40)

    def test_inertia_alone_is_matched(self):
        pure = demand()._replace(static_torque=np.zeros(401))
        found = best_ratio(pure, np.array(0.03))
        assert found.ratio == pytest.approx(20.0, rel=1e-13)

    @pytest.mark.parametrize("efficiency", [1.0, 0.8])
    def test_best_is_the_least_of_all(self, efficiency):
        asked = demand(efficiency)
        least = minimize_scalar(lambda ratio: float(rms_by_ratio(asked, 0.03, ratio)), (5.0, 60.0), tol=1e-10)
        found = best_ratio(asked, np.array(0.03))
        assert found.ratio == pytest.approx(least.x, rel=1e-5)
        assert found.rms == pytest.approx(least.fun, rel=1e-12)

    def test_nothing_accelerates(self):
        even = demand()._replace(inertia_torque=np.zeros(401), acceleration=np.zeros(401))
        assert np.isinf(best_ratio(even, np.array(0.03)).ratio)

    def test_loss_goes_with_the_transmitted_power(self):
        asked = demand(0.8)
        bare = asked.static_torque + asked.inertia_torque
        assert np.all(transmitted_torque(asked) >= bare)

    def test_a_quicker_pace_has_its_square_in_inertia_and_its_time(self):
        asked = demand()
        slow, quick = history_at(asked, np.array(20.0)), history_at(asked, np.array(20.0), np.array(2.0))
        assert quick.time[-1] == pytest.approx(slow.time[-1] / 2)
        np.testing.assert_allclose(quick.acceleration, 4 * slow.acceleration)
        np.testing.assert_allclose(
            20 * quick.torque, asked.static_torque + 4 * asked.inertia_torque, rtol=1e-12, atol=1e-9
        )

    def test_a_list_of_ratios_at_once(self):
        ratios = preferred_ratios(10.0, 40.0)
        history = history_at(demand(0.9), ratios)
        found = size_choice(history, StartDemand(80.0 / 0.9 / ratios), MOTORS)
        assert found.uses.shape == (ratios.size, 30, 4)
        for place, ratio in enumerate(ratios):
            alone = size_choice(history_at(demand(0.9), ratio), StartDemand(80.0 / 0.9 / ratio), MOTORS)
            np.testing.assert_allclose(found.uses[place], alone.uses, rtol=1e-12)
