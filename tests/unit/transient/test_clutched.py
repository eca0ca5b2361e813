"""A press with clutch and brake: closed forms of constant inertia, how runs end, energy, and what a stroke tells."""

import math

import numpy as np
import pytest
from tests.presses import BARE, IDLE, KERNELS, PRESS, PRESSING, bare_press, press_with

from cranktrain.questions.sizing.clutch import Engagement, engaged, held_torque
from cranktrain.transient.clutched.courses import PRESSED, RELEASED, Grip, commanded, piece_from
from cranktrain.transient.clutched.equation import (
    ANGLE,
    BRAKE_HEAT,
    CLUTCH_HEAT,
    LOST_WORK,
    MOTOR_WORK,
    SPEED,
    WHEEL,
    kinetic_energy,
    press_of,
)
from cranktrain.transient.clutched.runs import (
    ANGLE_PASSED,
    AT_STAND,
    COMMAND,
    LOCKED,
    LOOSE,
    NOTHING_MOVES,
    OFF,
    PRESS_REASONS,
    RESTS,
    SLIDES,
    SLIPS_ON,
    TIME_IS_OVER,
    WHEEL_STALLS,
    PressPlan,
    at_rest,
    piece_ends,
    piece_of,
    turning,
)
from cranktrain.transient.clutched.settled import settled_stroke
from cranktrain.transient.clutched.stopping import stop_measurement, worst_stop
from cranktrain.transient.clutched.stroke import heat_rate_limit, single_stroke, time_limit
from cranktrain.transient.clutched.walking import run_press, starting, stopping
from cranktrain.transient.equation import DriveTrain, Kernels, no_brake, no_heat
from cranktrain.transient.gearing import stages
from cranktrain.transient.runs import run, wanted

PLAN = PressPlan(4.0, command_angle=math.radians(300.0), jumps=PRESSING)


def plain(kernels, press, start, plan):
    return run_press(kernels, press, start, plan)


def start_of(press, speed=40.0, angle=0.0):
    return starting(at_rest(speed, angle), press)


def stroke_of(press, plan=PLAN, **others):
    return single_stroke(KERNELS, press, plan, wheel_speed=IDLE, **others)


def constant(_speed, _time, motor):
    return motor[0]


class TestCourse:
    grip = Grip(1.0, 1.0, 0.1, 0.4, 0.05, 0.2)

    def test_rise(self):
        course = commanded(RELEASED, self.grip, 1.0, is_on=True)
        assert [piece_from(course, time).level for time in (1.0, 1.1, 1.2, 1.5, 9.0)] == pytest.approx(
            [0.0, 0.0, 0.25, 1.0, 1.0]
        )

    def test_let_go_before_it_is_on(self):
        """It falls from what it has come to with the slope of a full fall."""
        course = commanded(commanded(RELEASED, self.grip, 0.0, is_on=True), self.grip, 0.15, is_on=False)
        assert [piece_from(course, time).level for time in (0.199999, 0.2, 0.225, 0.25, 1.0)] == pytest.approx(
            [0.25, 0.25, 0.125, 0.0, 0.0], abs=1e-5
        )

    def test_a_jump_is_what_is_behind_it(self):
        course = commanded(PRESSED, Grip(1.0, 1.0), 2.0, is_on=False)
        assert piece_from(course, 2.0).level == 0.0
        assert piece_from(course, 1.9).level == 1.0
        assert piece_from(course, 1.9).end == 2.0


@pytest.mark.parametrize("angle", [-7.0, -0.1, 0.0, 1.0, 2.73, 3.0, 3.2, 9.0, 9.3, 100.0])
def test_pieces_between_jumps_hold_the_angle(angle):
    low, high = piece_ends(piece_of(angle, PRESSING), PRESSING)
    assert low <= angle < high
    assert high - low < 2 * math.pi


class TestConstantInertia:
    """Against `sizing.clutch`, and the numbers of the two independent computations in drive theory."""

    def test_slip_and_heat(self):
        found = plain(BARE, bare_press(Grip(900.0, 1000.0)), start_of(bare_press(Grip(900.0, 1000.0))), PressPlan(1.0))
        (lock,) = found.of_kind(LOCKED)
        assert lock.moment.time == pytest.approx(0.271186440678, abs=1e-12)
        assert lock.moment.state[CLUTCH_HEAT] == pytest.approx(4881.355932, abs=5e-7)

    @pytest.mark.parametrize("load", [-100.0, 0.0, 150.0, 700.0])
    @pytest.mark.parametrize("speed", [0.0, 25.0, 70.0])
    def test_either_sense_of_slip(self, load, speed):
        """A crank that is faster than the flywheel gives energy to it."""
        press = bare_press(Grip(900.0, 1000.0), load=load)
        begun = starting(turning(press, speed, 0.0) if speed else at_rest(40.0, 0.0), press)
        begun.state[WHEEL] = 40.0
        released = commanded(RELEASED, press.clutch, 0.0, is_on=True)
        start = type(begun)(0.0, begun.state, False, released, RELEASED, 0, False)
        found = plain(BARE, press, start, PressPlan(2.0))
        sides = Engagement(40.0, 6.0, 900.0, load, 40.0, speed)
        if speed > 40.0:
            sides = Engagement(6.0, 40.0, 900.0, 0.0, speed, 40.0)  # with the load on its driving side
            sides_time = (speed - 40.0) / (900.0 / 40.0 + (900.0 + load) / 6.0)
            heat = 0.5 * 900.0 * (speed - 40.0) * sides_time
        else:
            sides_time, heat = engaged(sides).slip_time, engaged(sides).heat
        (lock, *_) = found.of_kind(LOCKED)
        assert lock.moment.time == pytest.approx(sides_time, rel=1e-12)
        assert lock.moment.state[CLUTCH_HEAT] == pytest.approx(heat, rel=1e-11)
        assert abs(found.residual) < 1e-12 * found.supplied

    @pytest.mark.parametrize("excess", [-1e-6, 1e-6])
    def test_locks_only_within_the_static_torque(self, excess):
        """What it has to hold is `held_torque`; beyond, the driven side falls behind again."""
        load = 700.0
        held = held_torque(Engagement(40.0, 6.0, 500.0, load, 0.0, 0.0), 0.0)
        press = bare_press(Grip(500.0, held * (1 + excess)), load=load)
        start = turning(press, 40.0, 0.0)
        found = plain(BARE, press, start, PressPlan(0.05))
        assert len(found.of_kind(LOOSE)) == int(excess < 0)
        ending = 40.0 - (load - 500.0) / 6.0 * 0.05 if excess < 0 else 40.0 - load / 46.0 * 0.05
        assert found.end.state[SPEED] == pytest.approx(ending, rel=1e-12)

    def test_breaks_loose_where_the_torque_falls(self):
        """It holds `held_torque` until 1000(1 − t/0.2) is less; the brake adds 1 N·m."""
        press = bare_press(Grip(900.0, 1000.0, 0.0, 0.0, 0.0, 0.2))
        start = stopping(turning(press, 40.0, 0.0), press)
        found = plain(BARE, press, start, PressPlan(0.2))
        held = held_torque(Engagement(40.0, 6.0, 900.0, 151.0, 0.0, 0.0), 0.0)
        assert found.of_kind(LOOSE)[0].moment.time == pytest.approx(0.2 * (1 - held / 1000.0), rel=1e-11)

    def test_rise(self):
        """While the torque rises the load holds; it sets off at 150 N·m, and the momentum tells the rest."""
        press = bare_press(Grip(900.0, 1000.0, 0.1, 0.3), load=0.0, dry=150.0)
        press = press._replace(machine=(6.0, 0.0, 150.0))
        found = plain(BARE, press, start_of(press), PressPlan(0.39))
        off = found.of_kind(OFF)[0].moment
        assert off.time == pytest.approx(0.1 + 0.3 * 150.0 / 900.0, rel=1e-14)
        span, rate = 0.39 - off.time, 900.0 / 0.3
        assert found.end.state[SPEED] == pytest.approx(rate * span**2 / 2 / 6.0, rel=1e-12)
        assert found.end.state[ANGLE] == pytest.approx(rate * span**3 / 6 / 6.0, rel=1e-10)
        assert found.end.state[WHEEL] == pytest.approx(40.0 - rate * 0.29**2 / 2 / 40.0, rel=1e-12)

    def test_brake(self):
        """A constant torque after its delay and a rise in a line: speed and angle by integrating it."""
        press = bare_press(Grip(900.0, 1000.0), Grip(300.0, 400.0, 0.05, 0.1), load=0.0)
        found = plain(BARE, press, stopping(turning(press, 40.0, 0.0), press), PressPlan(3.0))
        left = 40.0 - 300.0 / 6.0 * 0.05
        turned = 40.0 * 0.15 - 300.0 / 6.0 * 0.1**2 / 6 + left**2 / (2 * 50.0)
        assert found.reason == RESTS
        rest = found.of_kind(AT_STAND)[0].moment
        assert rest.time == pytest.approx(0.15 + left / 50.0, rel=1e-12)
        assert rest.state[ANGLE] == pytest.approx(turned, rel=1e-12)
        assert rest.state[BRAKE_HEAT] == pytest.approx(0.5 * 6.0 * 40.0**2, rel=1e-11)

    def test_brake_before_the_gear(self):
        """Its torque passes the gear toward the crank, which gives it back with the efficiency of that way."""
        press = bare_press(Grip(900.0, 1000.0), Grip(300.0, 400.0), load=0.0)
        behind = stages(0.2, (4.0, 0.9, 0.8, 0.0, 0.0))
        press = press_of(press.machine, (), press.before, behind, press.clutch, press.brake, brake_on_crank=False)
        found = plain(BARE, press, stopping(turning(press, 10.0, 0.0), press), PressPlan(3.0))
        slowing = 300.0 / (0.2 * 4.0 + 6.0 * 0.8 / 4.0)
        assert found.end.time == pytest.approx(10.0 / slowing, rel=1e-12)
        assert abs(found.residual) < 1e-11 * found.supplied


class TestMoments:
    """What lasts for a moment, or passes nothing on."""

    def test_an_idle_gear(self):
        """Behind an open clutch without inertia the gear hands on nothing: the crank is slowed by what is on it."""
        behind = stages(0.0, (5.0, 0.9, 0.8, 0.0, 0.0))
        press = bare_press(Grip(900.0, 1000.0), Grip(300.0, 300.0))
        press = press_of(press.machine, (), press.before, behind, press.clutch, press.brake, brake_on_crank=True)
        found = plain(BARE, press, stopping(turning(press, 10.0, 0.0), press), PressPlan(3.0))
        assert found.reason == RESTS
        assert found.end.time == pytest.approx(10.0 * 6.0 / (300.0 + 150.0), rel=1e-11)

    def test_falls_back_until_the_clutch_pulls(self):
        """A load that drives back has its way for as long as the clutch takes to rise: speeds of a line's integral."""
        press = bare_press(Grip(900.0, 1000.0, 0.0, 0.003), load=150.0)
        found = plain(BARE, press, start_of(press), PressPlan(0.0025))
        # ω̇ = (900 t/0.003 − 150)/6 turns at 0.0005 s, ω is 0 again at 0.001 s
        kinds = [(event.kind, event.moment.time) for event in found.events]
        assert [kind for kind, _ in kinds] == [OFF, AT_STAND, OFF]
        assert kinds[1][1] == pytest.approx(0.001, rel=1e-9)
        assert kinds[2][1] == kinds[1][1]
        speed = (900.0 / 0.003 * 0.0025**2 / 2 - 150.0 * 0.0025) / 6.0
        assert found.end.state[SPEED] == pytest.approx(speed, rel=1e-9)


class TestEnds:
    def test_slips_on_under_load(self):
        """The load brings the crank to a stand while the flywheel turns on."""
        weak = PRESS._replace(clutch=Grip(1000.0, 1200.0))
        found = stroke_of(weak)
        assert found.run.reason == SLIPS_ON
        assert PRESSING[0] < found.run.end.state[ANGLE] < PRESSING[1]
        assert found.run.end.state[WHEEL] > 0.5 * IDLE
        assert math.isnan(found.brake_angle)
        assert math.isnan(found.recovery_time)

    def test_slips_on_from_the_start(self):
        """It cannot lift what holds the crank."""
        press = bare_press(Grip(100.0, 120.0))._replace(machine=(6.0, 0.0, 150.0))
        found = plain(BARE, press, start_of(press), PressPlan(1.0))
        assert found.reason == SLIPS_ON
        assert found.end.state[SPEED] == 0.0

    def test_slips_on_turning(self):
        """With a load over the closed form's limit they never meet; here the time runs out first."""
        press = bare_press(Grip(160.0, 170.0), load=150.0)
        motor = Kernels(BARE.machine, constant, no_heat, no_brake)
        found = plain(motor, press._replace(motor=(160.0,)), start_of(press), PressPlan(1.0))
        assert found.reason == SLIPS_ON
        assert found.end.state[SPEED] == pytest.approx(10.0 / 6.0, rel=1e-12)

    def test_brake_slides_under_the_weight(self):
        """At mid-stroke the weight's torque is more than the brake's: it does not come to rest."""
        heavy = PRESS._replace(machine=(14.0, 20000.0, 0.0, 150.0, *PRESSING), brake=Grip(2000.0, 2000.0))
        begun = stopping(turning(heavy, 5.0, 1.2, PRESSING), heavy)
        found = plain(KERNELS, heavy, begun, PLAN._replace(end_time=0.2, command_angle=math.inf))
        assert found.reason == SLIDES
        assert found.end.state[SPEED] > 0

    def test_brake_slides_back(self):
        """On its way up the ram stops and falls back."""
        heavy = PRESS._replace(machine=(14.0, 20000.0, 0.0, 150.0, *PRESSING), brake=Grip(2000.0, 2000.0))
        begun = stopping(turning(heavy, 5.0, 4.0, PRESSING), heavy)
        found = plain(KERNELS, heavy, begun, PLAN._replace(command_angle=math.inf))
        assert found.reason == SLIDES
        assert found.end.state[SPEED] == 0.0

    def test_flywheel_stalls(self):
        """A clutch that holds, and a work that is more than the flywheel has."""
        small = press_with(wheel_inertia=0.5, clutch=Grip(50e3, 60e3))
        found = stroke_of(small)
        assert found.run.reason == WHEEL_STALLS
        assert found.run.end.state[WHEEL] == 0.0
        assert found.speed_drop == 1.0

    def test_nothing_moves(self):
        press = bare_press(Grip(900.0, 1000.0), Grip(300.0, 300.0))
        found = plain(BARE, press, at_rest(40.0, 0.0), PressPlan(1.0))
        assert (found.reason, found.end.time) == (NOTHING_MOVES, 0.0)

    def test_every_reason_has_a_sentence(self):
        assert sorted(PRESS_REASONS) == list(range(12))


class TestStroke:
    found = stroke_of(PRESS)

    def test_energy(self):
        assert abs(self.found.run.residual) < 1e-9 * self.found.run.supplied

    def test_rests_before_the_top(self):
        assert self.found.run.reason == RESTS
        turned = math.radians(300.0) + self.found.brake_angle
        assert self.found.stop_angle == pytest.approx(turned - 2 * math.pi, abs=1e-12)
        assert self.found.stroke_time > self.found.brake_time > 0

    def test_speed_drops(self):
        assert 0 < self.found.pressing_drop < self.found.speed_drop < 0.15

    def test_drop_in_pressing_is_of_all_times(self):
        """Not of the ends of steps alone: as seen at a hundred thousand times between locking and the command."""
        run = self.found.run
        locked, command = (run.of_kind(kind)[0].moment.time for kind in (LOCKED, COMMAND))
        speeds = run.at(np.linspace(locked, command, 100_000))[:, WHEEL]
        drop = np.max(np.maximum.accumulate(speeds) - speeds)
        assert self.found.pressing_drop * IDLE == pytest.approx(drop, rel=1e-5)

    def test_recovery_by_quadrature(self):
        """With the crank at rest: t = J ∫dω/M of the motor alone."""
        speeds = np.linspace(self.found.run.end.state[WHEEL], 0.99 * IDLE, 20001)
        torque = KERNELS.motor(speeds * PRESS.motor_ratio, 0.0, PRESS.motor) * PRESS.motor_ratio
        time = 24.0 * np.trapezoid(1 / torque, speeds)
        rested = self.found.run.of_kind(AT_STAND)[-1].moment.time
        assert self.found.recovery_time == pytest.approx(time + self.found.run.end.time - rested, rel=1e-8)

    def test_limits(self):
        rate = heat_rate_limit(self.found, 500.0, 800.0)
        assert rate == min(500.0 / self.found.clutch_heat, 800.0 / self.found.brake_heat)
        assert time_limit(self.found) == 1 / (self.found.stroke_time + self.found.recovery_time)

    def test_tolerance(self):
        found = stroke_of(PRESS, PLAN._replace(tolerance=1e-12))
        assert found.stop_angle == pytest.approx(self.found.stop_angle, abs=1e-8)
        assert found.clutch_heat == pytest.approx(self.found.clutch_heat, rel=1e-8)

    def test_stops_on_top(self):
        settled = settled_stroke(KERNELS, PRESS, PLAN._replace(command_angle=math.inf), idle_speed=IDLE)
        found = stroke_of(PRESS, PLAN._replace(command_angle=settled.command_angle))
        assert found.stop_angle == pytest.approx(0.0, abs=1e-9)

    def test_never_on_top(self):
        """A brake that does not hold has no angle of command that does."""
        slack = PRESS._replace(brake=Grip(20.0, 20.0))
        found = settled_stroke(KERNELS, slack, PLAN._replace(command_angle=math.inf), idle_speed=IDLE)
        assert not found.is_found
        assert found.stroke.run.reason == SLIDES


class TestStops:
    press = PRESS._replace(brake=Grip(2600.0, 2800.0, 0.04, 0.05))

    def test_of_constant_inertia_are_alike(self):
        press = bare_press(Grip(900.0, 1000.0), Grip(300.0, 400.0, 0.05), load=0.0)
        plan = PressPlan(1.0, passed=(0.5, 2.0, 4.0))
        found = stop_measurement(BARE, press, turning(press, 40.0, 0.0), plan)
        np.testing.assert_allclose(found.command_angle, [0.5, 2.0, 4.0], rtol=1e-13)
        np.testing.assert_allclose(found.time, 0.05 + 40.0 / 50.0, rtol=1e-12)
        np.testing.assert_allclose(found.angle, 40.0 * 0.05 + 40.0**2 / 100.0, rtol=1e-12)
        np.testing.assert_allclose(found.heat, 0.5 * 6.0 * 40.0**2, rtol=1e-11)

    def test_worst_is_where_the_ram_falls(self):
        """The weight drives on the way down and helps on the way up."""
        plan = PLAN._replace(end_time=1.0, passed=tuple(np.radians([60.0, 250.0])))
        free = self.press._replace(machine=(14.0, 900.0, 0.0, 150.0, *PRESSING))
        start = turning(free, IDLE / 5, 0.0, PRESSING)
        found = stop_measurement(KERNELS, free, start, plan)
        assert found.reasons == (RESTS, RESTS)
        assert found.worst_angle == found.worst_time == 0

    def test_same_as_a_command_at_that_angle(self):
        angle = math.radians(200.0)
        start = starting(at_rest(IDLE, 0.0, PRESSING), self.press)
        plan = PLAN._replace(passed=(angle,), end_time=0.6)
        found = stop_measurement(KERNELS, self.press, start, plan)
        stroke = stroke_of(self.press, PLAN._replace(command_angle=angle))
        assert found.angle[0] == pytest.approx(stroke.brake_angle, rel=1e-8)
        assert found.time[0] == pytest.approx(stroke.brake_time, rel=1e-8)


def test_locked_is_the_ordinary_equation():
    """Running on with its clutch locked, it is a motor with belt and gear: against that equation's own run."""
    belt, gear = (3.3, 0.95, 0.93, 2.0, 20.0), (5.0, 0.96, 0.95, 1.0, 3.0)
    press = press_of(
        (14.0, 900.0, 0.0, 150.0, *PRESSING), PRESS.motor, stages(0.1, belt), stages(0.4, gear), PRESS.clutch,
        PRESS.brake, brake_on_crank=True,
    )  # fmt: skip
    plan = PressPlan(1.5, passed=(3.0, 8.0), ends_at_rest=False, tolerance=1e-12)
    found = plain(KERNELS, press, turning(press, 9.0, 0.3), plan)
    drive = DriveTrain(press.machine, press.motor, 0.0, stages(0.1, (*belt[:4], 20.4), gear))
    other = run(KERNELS, drive, wanted(1.5, angle=0.3, speed=9.0, tolerance=1e-12), is_compiled=False)
    assert found.reason == TIME_IS_OVER
    np.testing.assert_allclose(found.end.state[[ANGLE, SPEED]], other.end[:2], rtol=1e-9)
    np.testing.assert_allclose(found.end.state[[MOTOR_WORK, LOST_WORK]], other.end[[2, 4]], rtol=1e-8)
    assert [event.moment.state[ANGLE] for event in found.of_kind(ANGLE_PASSED)] == pytest.approx([3.0, 8.0], rel=1e-13)


class TestStages:
    """Belt and gear with losses, about a clutch, of constant torques: speeds are lines."""

    belt, gear = (3.0, 0.9, 0.8, 1.5, 20.0), (5.0, 0.95, 0.9, 2.0, 3.0)
    motor = Kernels(BARE.machine, constant, no_heat, no_brake)

    def press(self, torque, brake, *, on_crank):
        before, behind = stages(0.1, self.belt), stages(0.4, self.gear)
        clutch = Grip(600.0, 700.0, 0.0, 0.0, 0.5, 0.0)
        return press_of((6.0, 100.0, 0.0), (torque,), before, behind, clutch, brake, brake_on_crank=on_crank)

    def test_slipping(self):
        press = self.press(80.0, Grip(1.0, 1.0), on_crank=True)
        found = plain(self.motor, press, start_of(press, 60.0), PressPlan(0.05))
        off = (600.0 - 2.0) * 5.0 * 0.95  # at the crank, before its own inertias
        speed = 0.05 * (off - 100.0) / (6.0 + 3.0 + 0.4 * 25.0 * 0.95)
        back = 60.0 + 0.05 * ((80.0 - 1.5) * 3.0 * 0.8**-1 - 600.0) / (20.0 + 0.1 * 9.0 / 0.8)
        driven = 60.0 + 0.05 * ((80.0 - 1.5) * 3.0 * 0.9 - 600.0) / (20.0 + 0.1 * 9.0 * 0.9)
        assert found.end.state[SPEED] == pytest.approx(speed, rel=1e-12)
        assert found.end.state[WHEEL] == pytest.approx(driven, rel=1e-12)
        assert abs(driven - back) > 0.1
        assert abs(found.residual) < 1e-12 * found.supplied

    @pytest.mark.parametrize("on_crank", [False, True])
    def test_braking_against_the_locked_clutch(self, on_crank):
        """Before the clutch lets go, the brake slows the motor as well, through the gears its own place has."""
        press = self.press(0.0, Grip(300.0, 300.0), on_crank=on_crank)
        found = plain(self.motor, press, stopping(turning(press, 12.0, 0.0), press), PressPlan(0.2))
        # all is slowed: the motor and the flywheel drive, the crank's side is driven or drives
        slowed = (12.0 - found.end.state[SPEED]) / 0.2
        assert np.ptp(np.diff(found.states[:, SPEED]) / np.diff(found.times)) < 1e-8
        brake_speed = 1.0 if on_crank else 5.0
        turned = found.end.state[ANGLE]
        assert found.end.state[BRAKE_HEAT] == pytest.approx(300.0 * brake_speed * turned, rel=1e-11)
        assert found.end.state[WHEEL] == pytest.approx(5.0 * found.end.state[SPEED], rel=1e-13)
        at_belt = 0.1 * 15.0 * slowed - 1.5  # what the rotor gives, less the belt's drag
        entering = (
            at_belt * 3.0 * (0.9 if at_belt > 0 else 1 / 0.8) + 20.4 * 5.0 * slowed - (0.0 if on_crank else 300.0) - 2.0
        )
        efficiency = 0.95 if entering > 0 else 1 / 0.9
        balance = entering * 5.0 * efficiency + (6.0 + 3.0) * slowed - 100.0 - (300.0 if on_crank else 0.0)
        assert balance == pytest.approx(0.0, abs=1e-7)
        assert abs(found.residual) < 1e-12 * found.supplied


def test_kinetic_energy():
    assert kinetic_energy(BARE, bare_press(Grip(1.0, 1.0)), turning(bare_press(Grip(1.0, 1.0)), 2.0, 0.0).state) == 92.0


class TestRepeated:
    """Thirty strokes a minute, each of which begins as the one before."""

    found = settled_stroke(KERNELS, PRESS, PLAN, period=2.0, idle_speed=IDLE)

    def test_it_is_what_strokes_come_to(self):
        """From the flywheel's idle speed on, one after another."""
        speed = IDLE
        for _ in range(12):
            stroke = stroke_of_speed(speed, 2.0)
            waiting = PLAN._replace(end_time=2.0, command_angle=math.inf, ends_at_rest=False)
            speed = plain(KERNELS, PRESS, stroke.run.end, waiting).end.state[WHEEL]
        assert self.found.wheel_speed == pytest.approx(speed, rel=1e-8)
        assert self.found.wheel_speed < IDLE
        assert self.found.is_found

    def test_with_its_command(self):
        """Both at once: a little behind the command of a flywheel at its idle speed, as it is slower."""
        plan = PLAN._replace(command_angle=math.inf)
        both = settled_stroke(KERNELS, PRESS, plan, period=2.0, idle_speed=IDLE)
        alone = settled_stroke(KERNELS, PRESS, plan, idle_speed=IDLE)
        assert both.stroke.stop_angle == pytest.approx(0.0, abs=1e-9)
        end = both.pace.waiting.end.state[WHEEL]
        assert end == pytest.approx(both.wheel_speed, rel=1e-9)
        assert 0 < both.command_angle - alone.command_angle < 0.02

    def test_power(self):
        """What the motor gives is heat, work of the load and loss of the gear; heat of the clutch and brake for two."""
        stroke = self.found.stroke
        taken = stroke.run.end.state[4:8].sum()
        assert self.found.pace.motor_power * 2.0 == pytest.approx(taken, rel=1e-8)
        assert self.found.pace.clutch_power * 2.0 == stroke.clutch_heat

    def test_too_fast(self):
        """It is still on its way when the next one should begin."""
        found = settled_stroke(KERNELS, PRESS, PLAN, period=0.5, idle_speed=IDLE)
        assert not found.is_found
        assert found.stroke.run.reason == TIME_IS_OVER


def test_worst_stop():
    """Against a denser look: the longest lies where the ram is fastest down, before the blank helps to stop it."""
    plan = PLAN._replace(end_time=1.0, command_angle=math.inf)
    start = turning(PRESS, IDLE / 5, 0.0, PRESSING)
    found = worst_stop(KERNELS, PRESS, start, plan, over=(0.5, 1.6), n_angles=6, n_zooms=2)
    passed = tuple(np.linspace(0.6, 1.1, 41).tolist())
    dense = stop_measurement(KERNELS, PRESS, start, plan._replace(passed=passed))
    assert found.angle == pytest.approx(np.max(dense.angle), abs=2e-5)
    assert found.angle >= np.max(dense.angle) - 1e-7
    assert found.time == pytest.approx(np.max(dense.time), abs=2e-6)
    assert 0.6 < found.angle_command < 1.1


def stroke_of_speed(speed, end_time):
    return single_stroke(KERNELS, PRESS, PLAN._replace(end_time=end_time), wheel_speed=speed, recovery_limit=0.0)


def settled_at(period, press=PRESS, idle=IDLE):
    return settled_stroke(KERNELS, press, PLAN, period=period, idle_speed=idle)


def test_how_often_machine_and_motor_are_asked():
    """In six trials, each a stroke and a pause; by half as often again the search would have lost its way."""
    asked = {"machine": 0, "motor": 0}

    def machine(*given):
        asked["machine"] += 1
        return KERNELS.machine(*given)

    def motor(*given):
        asked["motor"] += 1
        return KERNELS.motor(*given)

    plan = PLAN._replace(command_angle=math.inf)
    counting = Kernels(machine, motor, no_heat, no_brake)
    assert settled_stroke(counting, PRESS, plan, period=2.0, idle_speed=IDLE).is_found
    assert asked["machine"] < 8000
    assert asked["motor"] < 10_000


@pytest.mark.parametrize("period", [600.0, 6e6, 6e10])
def test_a_pause_is_one_step_once_the_flywheel_idles(period):
    """As many steps as a pause of a minute, and as much work: nothing before the clutch takes any from a flywheel."""
    short, long = settled_at(60.0), settled_at(period)
    assert long.pace.waiting.n_steps == short.pace.waiting.n_steps < 100
    assert long.pace.motor_power * period == pytest.approx(short.pace.motor_power * 60.0, rel=1e-9)
    assert long.wheel_speed == pytest.approx(IDLE, rel=1e-9)
    assert abs(long.pace.waiting.residual) < 1e-7 * long.pace.waiting.supplied


def test_a_long_pause_takes_what_idling_takes():
    """A seal of 2 N·m at the motor: after a million seconds the mean power is that of Kloss's torque of 2 N·m."""
    before = stages(0.0, (3.3, 1.0, 1.0, 2.0, 24.0))
    press = PRESS._replace(before=before, locked=PRESS.locked._replace(drag=[2.0, *PRESS.locked.drag[1:]]))
    breakdown, slip_at, synchronous = PRESS.motor
    slip = slip_at * (breakdown - math.sqrt(breakdown**2 - 2.0**2)) / 2.0
    idle = synchronous * (1 - slip)
    found = settled_at(1e6, press, idle / 3.3)
    stroke = found.stroke.run.end.state
    taken = (stroke[4:8].sum() - 2.0 * idle * found.stroke.run.end.time) / 1e6
    assert found.pace.motor_power == pytest.approx(2.0 * idle + taken, rel=1e-6)
    assert found.wheel_speed == pytest.approx(idle / 3.3, rel=1e-9)
