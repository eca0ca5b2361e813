"""What a servo must do for a wanted motion: a scotch yoke's slider by closed forms and another quadrature."""

import numpy as np
import pytest
from scipy.integrate import quad

import cranktrain as ct
from cranktrain.motors.servo.law import Servo, servo_limit
from cranktrain.questions.servo.rocking import RockingDrive
from cranktrain.questions.servo.stages import ServoDrive
from cranktrain.questions.sizing.duty import rms_torque

RADIUS, MASS, RATIO, ROTOR = 0.05, 40.0, 12.0, 0.02
OUT, REST, BACK = 0.6, 0.2, 0.4


def press(*, stage=None, motion=None, **tables):
    pieces = [
        {"duration": f"{OUT} s", "to": "100 mm"},
        {"duration": f"{REST} s"},
        {"duration": f"{BACK} s", "to": "0 mm"},
    ]
    return ct.Machine(
        mechanism={"kind": "scotch_yoke", "crank_radius": "50 mm"},
        shaft={"main": {"motion": motion or {"piece": pieces}}},
        masses={"piston": {"mass": f"{MASS} kg"}},
        drive={
            "stage": [{"ratio": f"{RATIO}", **(stage or {})}],
            "part": {"rotor": {"inertia": f"{ROTOR} kg*m^2"}},
        },
        **tables,
    )


def crank(time):
    """φ, ω and ε of x = r cos φ for the 4-5-6-7 law, at one time away from the dead centres."""
    is_out = time < OUT
    span = OUT if is_out else BACK
    s = time / span if is_out else (OUT + REST + BACK - time) / span
    y = 35 * s**4 - 84 * s**5 + 70 * s**6 - 20 * s**7
    # By the law's symmetry from its nearer end, so that nothing cancels.
    near, sense = min(s, 1 - s), np.sign(0.5 - s)
    first = 140 * near**3 * (1 - near) ** 3 / span
    second = sense * 420 * near**2 * (1 - near) ** 2 * (1 - 2 * near) / span**2
    # cos φ = 1 − 2y; sin φ = ±2√(y(1−y)), with 1 − y by the law's own symmetry.
    u = 1 - s
    rest = 35 * u**4 - 84 * u**5 + 70 * u**6 - 20 * u**7
    sin = 2 * np.sqrt(y * rest) * (1 if is_out else -1)
    away = 2 * first * (1 if is_out else -1)
    speed = away / sin
    return sin, speed, (2 * second - (rest - y) * speed**2) / sin


def torque(time):
    """At the motor without losses: m ẍ x′/i + J i ε."""
    sin, speed, acceleration = crank(time)
    cos = np.sqrt(np.maximum(0, 1 - sin**2))
    inertia = MASS * RADIUS**2 * sin * (sin * acceleration + _signed(time, cos) * speed**2)
    return inertia / RATIO + ROTOR * RATIO * acceleration


def _signed(time, cos):
    return cos if time < OUT / 2 or time > OUT + REST + BACK / 2 else -cos


@pytest.fixture(scope="module")
def result():
    return ct.run(press())


def test_the_motor_moves_slider_and_rotor(result):
    eps = 1e-10
    square = sum(
        quad(lambda t: torque(t) ** 2, *ends, limit=200)[0]
        for ends in ((eps, OUT / 2), (OUT / 2, OUT - eps), (OUT + REST + eps, OUT + REST + BACK - eps))
    )
    rms = np.sqrt(square / (OUT + REST + BACK))
    assert result.servo_rms_torque == pytest.approx(rms, rel=1e-6)
    times = np.concatenate([np.linspace(1e-6, OUT - 1e-6, 4001), np.linspace(OUT + REST + 1e-6, 1.2 - 1e-6, 4001)])
    peak = max(abs(torque(t)) for t in times)
    assert result.servo_peak_torque == pytest.approx(peak, rel=2e-5)
    # Out of the rest φ = 2√35 s², so that the crank sets off with its largest acceleration, and nothing else moves yet.
    assert result.servo_peak_torque == pytest.approx(ROTOR * RATIO * 4 * np.sqrt(35) / BACK**2, rel=1e-9)
    assert result.servo_mean_power == pytest.approx(0.0, abs=1e-9 * result.servo_peak_power)
    speeds = [crank(t)[1] * RATIO for t in times]
    assert result.servo_peak_speed == pytest.approx(max(speeds), rel=1e-3)


def test_the_crank_is_told_over_its_angle(result):
    assert result.wanted_period == pytest.approx(1.2)
    assert result.resting_time == pytest.approx(0.2)
    at = [90, 270]
    expected = [crank(OUT / 2), crank(OUT + REST + BACK / 2)]
    np.testing.assert_allclose(result.wanted_time[at], [0.3, 1.0], rtol=1e-12)
    np.testing.assert_allclose(result.wanted_crank_speed[at], [one[1] for one in expected], rtol=1e-10)
    np.testing.assert_allclose(result.wanted_crank_acceleration[at], [one[2] for one in expected], atol=1e-8)
    assert all(check.holds.all() if hasattr(check, "holds") else True for check in result.checks)


def test_a_rest_under_load_is_held_with_the_help_of_losses():
    """At half stroke the weight of 1000 N turns the crank by 50 N·m; the gear's friction takes its part."""
    pieces = [
        {"duration": "0.5 s", "to": "50 mm"},
        {"duration": "0.5 s"},
        {"duration": "0.5 s", "to": "100 mm"},
        {"duration": "1 s", "to": "0 mm"},
    ]
    load = {"weight": {"on": "piston", "force": "1000 N", "sense": "active"}}
    found = ct.run(press(stage={"efficiency": 0.9}, motion={"piece": pieces}, load=load)).get(ServoDrive)
    (demand,) = found.demands
    resting = (demand.crank.time > 0.5) & (demand.crank.time < 1.0)
    np.testing.assert_allclose(np.abs(demand.motor_torque[resting]), 50 / RATIO * (2 - 1 / 0.9), rtol=1e-9)


def test_a_constant_speed_misses_itself_by_nothing():
    motion = {
        "piece": [
            {"duration": "1 s", "to": "100 mm", "law": "constant crank"},
            {"duration": "1 s", "to": "0 mm", "law": "constant crank"},
        ]
    }
    assert ct.run(press(motion=motion)).constant_speed_miss < 1e-8


def test_a_constant_speed_misses_by_the_least_of_all_phases(result):
    time = np.arange(1200) / 1000
    s = np.where(time < OUT, time / OUT, np.where(time < OUT + REST, 1.0, (1.2 - time) / BACK))
    wanted = RADIUS - 2 * RADIUS * (35 * s**4 - 84 * s**5 + 70 * s**6 - 20 * s**7)
    phases = np.linspace(0, 2 * np.pi, 4000)
    turned = phases[:, np.newaxis] + 2 * np.pi * time / 1.2
    least = np.min(np.max(np.abs(RADIUS * np.cos(turned) - wanted), axis=1)) / (2 * RADIUS)
    assert result.constant_speed_miss == pytest.approx(least, abs=1e-3)


def test_a_servo_is_asked_for_a_share_of_its_limits(result):
    servo = Servo(np.float64(40.0), np.float64(3000.0), np.float64(0.0))
    (demand,) = result.get(ServoDrive).demands
    share = demand.peak_share(servo_limit(demand.motor_speed, servo))
    order = np.argsort(demand.crank.time)
    torque, speed = demand.motor_torque[order], demand.motor_speed[order]
    at_nodes = np.max(np.abs(torque) / np.minimum(40.0, 3000.0 / np.maximum(np.abs(speed), 1e-9)))
    assert share == pytest.approx(ROTOR * RATIO * 4 * np.sqrt(35) / BACK**2 / 40.0, rel=1e-9)
    assert at_nodes == pytest.approx(share, rel=5e-3)
    assert demand.rms == pytest.approx(float(rms_torque(torque, demand.crank.time[order])), rel=2e-2)


def _largest_rocking_power():
    """1000 N and inertia of slider and rotor for x = r cos φ, by the chain rule at many times of both ways."""
    largest = 0.0
    for begin, way in ((0.03, 0.03), (0.06, -0.03)):
        s = np.linspace(0, 1, 200_001)[1:-1]
        cos = (RADIUS - begin - way * (10 * s**3 - 15 * s**4 + 6 * s**5)) / RADIUS
        sin = np.sqrt(1 - cos**2)
        velocity = way * 30 * s**2 * (1 - s) ** 2 / 0.5
        acceleration = way * 60 * s * (1 - s) * (1 - 2 * s) / 0.5**2
        speed = velocity / (RADIUS * sin)
        turning = (acceleration - RADIUS * cos * speed**2) / (RADIUS * sin)
        power = 1000 * np.abs(velocity) + MASS * acceleration * velocity + ROTOR * RATIO**2 * turning * speed
        largest = max(largest, np.max(np.abs(power)))
    return largest


def test_a_rocking_crank_works_against_friction_both_ways():
    """1000 N over 30 mm out and 30 mm back, once a second, is 60 W; what moves takes none over a period."""
    pieces = [
        {"duration": "0.5 s", "to": "60 mm", "law": "3-4-5"},
        {"duration": "0.5 s", "to": "30 mm", "law": "3-4-5"},
    ]
    machine = press(
        motion={"mode": "rocking", "piece": pieces},
        load={"friction": {"on": "piston", "force": "1000 N"}},
    ).with_({"shaft.main.speed": "30 rpm"})
    result = ct.run(machine)
    (demand,) = result.get(RockingDrive).demands
    assert demand.mean(demand.power) == pytest.approx(60.0, rel=1e-9)
    assert result.rocking_peak_power == pytest.approx(_largest_rocking_power(), rel=1e-6)
    least, most = np.degrees(np.arccos([1 - 0.03 / RADIUS, 1 - 0.06 / RADIUS]))
    assert (result.least_rocking_angle, result.greatest_rocking_angle) == pytest.approx((least, most), rel=1e-9)


@pytest.mark.parametrize("efficiency", [0.9, 0.2])
@pytest.mark.parametrize("inertia", [0.0, 3e-3])
def test_a_held_speed_is_held_whatever_turns_with_it(efficiency, inertia):
    """Of no inertia too, and behind irreversible gearing: what drives is Q/(iη), what pulls Q(2 − 1/η)/i, ε = 0."""
    machine = ct.Machine(
        mechanism={"kind": "scotch_yoke", "crank_radius": "50 mm"},
        shaft={"main": {"speed": "60 rpm"}},
        load={"given": {"on": "main", "crank_angles": ["0 deg", "120 deg"], "torque": ["30 N*m", "-20 N*m"]}},
        drive={
            "stage": [{"ratio": 10, "efficiency": efficiency}],
            "motor": {"kind": "servo", "torque": "40 N*m", "peak_torque": "90 N*m", "speed": "3000 rpm"},
            "part": {"rotor": {"on": "motor", "inertia": f"{inertia} kg*m^2"}} if inertia else {},
        },
    )
    found = ct.run(machine)
    load = np.interp(np.arange(360), [0, 120, 360], [30.0, -20.0, 30.0])
    np.testing.assert_array_equal(found.drive_acceleration, np.zeros(found.drive_acceleration.shape))
    factor = np.where(load > 0, 1 / efficiency, 2 - 1 / efficiency)
    np.testing.assert_allclose(np.ravel(found.motor_torque), load * factor / 10, rtol=1e-12, atol=1e-12)
    assert all(
        np.all(check.judged) and np.all(check.passed) for check in found.checks if check.name.startswith("drive_")
    )
