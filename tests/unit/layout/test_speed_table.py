"""A speed over the crank angle from a file: its spline by moments in 40 digits, and what a machine does at it."""

import mpmath
import numpy as np
import pytest
from tests.machines import RADIUS, ROD, banks, slider, throws
from tests.sentences import AS_AT_THE_START, NO_FILE, NO_UNIT, SPEED_AS_GIVEN, THREE_COLUMNS

import cranktrain as ct
from cranktrain.analysis import speed_over_cycle
from cranktrain.cli import main

ANGLES = [0.0, 40.0, 110.0, 200.0, 290.0, 330.0]
SPEEDS = [98.0, 104.0, 111.0, 99.5, 93.0, 95.0]
MASS = 2.5


def csv(angles, speeds, header="angle [deg];speed [rad/s]"):
    return "\n".join([header, *(f"{a!r};{s!r}" for a, s in zip(angles, speeds, strict=True))])


TEXT = csv([*ANGLES, 360.0], [*SPEEDS, SPEEDS[0]])


def machine(text=TEXT, curve=None, speed=None, **tables):
    main_shaft = {"speed_curve": {"file": "speed.csv", "text": text, **(curve or {})}}
    if speed:
        main_shaft["speed"] = speed
    given = {"mechanism": slider(), "masses": {"piston": {"mass": f"{MASS} kg"}}, **tables}
    return ct.Machine(shaft={"main": main_shaft}, **given)


class Exact:
    """The periodic cubic spline of ω² by its moments (second derivatives at the points), in 40 digits."""

    def __init__(self, angles=ANGLES, speeds=SPEEDS, period=360):
        with mpmath.workdps(40):
            self.x = [mpmath.radians(mpmath.mpf(a)) for a in angles]
            self.period = mpmath.radians(mpmath.mpf(period))
            self.y = [mpmath.mpf(s) ** 2 for s in speeds]
            n = len(self.x)
            self.h = [(self.x[(i + 1) % n] - self.x[i]) % self.period for i in range(n)]
            matrix, right = mpmath.matrix(n, n), mpmath.matrix(n, 1)
            for i in range(n):
                before, after = self.h[i - 1], self.h[i]
                matrix[i, (i - 1) % n] += before
                matrix[i, i] += 2 * (before + after)
                matrix[i, (i + 1) % n] += after
                right[i] = 6 * ((self.y[(i + 1) % n] - self.y[i]) / after - (self.y[i] - self.y[i - 1]) / before)
            self.m = mpmath.lu_solve(matrix, right)

    def square(self, angle):
        """ω² and its derivative at an angle in rad."""
        x = (mpmath.mpf(angle) - self.x[0]) % self.period + self.x[0]
        i = max(k for k, knot in enumerate(self.x) if knot <= x)
        j, h = (i + 1) % len(self.x), self.h[i]
        a, b = (self.x[i] + h - x) / h, (x - self.x[i]) / h
        value = a * self.y[i] + b * self.y[j] + ((a**3 - a) * self.m[i] + (b**3 - b) * self.m[j]) * h**2 / 6
        slope = (self.y[j] - self.y[i]) / h - ((3 * a**2 - 1) * self.m[i] - (3 * b**2 - 1) * self.m[j]) * h / 6
        return value, slope

    def drive(self, angles):
        """ω and ε at angles in rad."""
        with mpmath.workdps(40):
            found = [self.square(float(angle)) for angle in angles]
            return np.array([[float(mpmath.sqrt(value)), float(slope / 2)] for value, slope in found]).T

    def mean(self):
        with mpmath.workdps(40):
            marks = [*self.x, self.x[0] + self.period]
            return float(self.period / mpmath.quad(lambda x: 1 / mpmath.sqrt(self.square(x)[0]), marks))


def test_the_curve_is_the_spline_through_the_files_points():
    angles = np.random.default_rng(1).uniform(-7, 14, 200)
    curve = speed_over_cycle(machine(), "constant")
    drive = curve.drive(angles)
    speed, acceleration = Exact().drive(angles)
    np.testing.assert_allclose(np.ravel(drive.speed), speed, rtol=1e-13)
    np.testing.assert_allclose(np.ravel(drive.acceleration), acceleration, rtol=0, atol=1e-11 * np.max(acceleration))
    assert curve.mean[0, 0, 0] == pytest.approx(Exact().mean(), rel=1e-12)


def test_forces_are_at_that_speed_and_acceleration():
    result = ct.run(machine())
    phi = np.radians(result.crank_angle)
    speed, acceleration = Exact().drive(phi)
    sin, cos = RADIUS * np.sin(phi), RADIUS * np.cos(phi)
    root = np.sqrt(ROD**2 - sin**2)
    first = -sin - sin * cos / root
    second = -cos - (cos**2 - sin**2) / root - (sin * cos) ** 2 / root**3
    outward = second * speed**2 + first * acceleration
    np.testing.assert_allclose(result.piston_velocity[0], -first * speed, atol=1e-12)
    np.testing.assert_allclose(result.piston_acceleration[0], -outward, atol=1e-10)
    np.testing.assert_allclose(result.driving_torque, MASS * first * outward, atol=1e-10)
    assert result.mean_piston_speed[0] == pytest.approx(2 * RADIUS * Exact().mean() / np.pi, rel=1e-12)
    assert SPEED_AS_GIVEN in result.summary()


@pytest.mark.parametrize("step", [1.0, 5.0])
def test_the_grid_does_not_matter(step):
    """Unlike speeds that are given on the grid."""
    fine, result = ct.run(machine()), ct.run(machine(), step_degrees=step)
    np.testing.assert_allclose(result.driving_torque, fine.driving_torque[:: int(step)], rtol=1e-12, atol=1e-12)
    assert result.largest_torque == pytest.approx(fine.largest_torque, rel=1e-9)


def test_even_steps_are_as_speeds_in_a_list():
    degrees = np.arange(360.0)
    speeds = 100 + 5 * np.cos(np.radians(degrees)) + 2 * np.sin(np.radians(3 * degrees))
    listed = ct.Machine(
        shaft={"main": {"speed": "100 rad/s"}}, mechanism=slider(), masses={"piston": {"mass": f"{MASS} kg"}}
    )
    expected = ct.run(listed, speed=speeds)
    result = ct.run(machine(csv(degrees.tolist(), speeds.tolist())))
    for name in ("driving_torque", "piston_acceleration", "shaking_force_y", "largest_torque"):
        np.testing.assert_allclose(getattr(result, name), getattr(expected, name), rtol=1e-9, atol=1e-8)


def test_angles_count_as_crank_angles_are_shown():
    turned = ct.run(machine(crank_zero="90 deg"))
    drive = Exact().drive(np.radians(turned.crank_angle))
    plain = ct.run(machine())
    coefficient = np.roll(plain.piston_velocity_coefficient[0], -90)
    np.testing.assert_allclose(turned.piston_velocity[0], coefficient * drive[0], rtol=1e-12, atol=1e-12)


def test_one_turn_is_repeated_in_a_cycle_of_two():
    gas = {"bore": "80 mm", "cycle": "four-stroke"}
    result = ct.run(machine(cylinder=gas))
    np.testing.assert_allclose(result.driving_torque[360:], result.driving_torque[:360], rtol=1e-12, atol=1e-12)
    two = csv([0.0, 100.0, 300.0, 420.0, 600.0, 720.0], [100.0, 110.0, 95.0, 101.0, 99.0, 100.0])
    drive = Exact([0, 100, 300, 420, 600], [100, 110, 95, 101, 99], 720).drive(np.radians(np.arange(720.0)))
    result = ct.run(machine(two, cylinder=gas))
    coefficient = result.piston_velocity_coefficient[0]
    np.testing.assert_allclose(result.piston_velocity[0], coefficient * drive[0], rtol=1e-12, atol=1e-12)
    for more in ({}, {"cylinder": {"bore": "80 mm", "cycle": "two-stroke"}}):
        alone = ct.run(machine(two, **more))
        np.testing.assert_allclose(alone.driving_torque, result.driving_torque, rtol=1e-14, atol=1e-14)


def test_designs_have_speeds_of_their_own():
    slow = csv([0.0, 90.0, 200.0, 360.0], [50.0, 60.0, 40.0, 50.0])
    both = ct.run([machine(), machine(slow)])
    for design, text in enumerate((TEXT, slow)):
        alone = ct.run(machine(text))
        np.testing.assert_allclose(both.driving_torque[design], alone.driving_torque, rtol=1e-12, atol=1e-12)


def test_units():
    rpm = csv([*ANGLES, 360.0], [s * 30 / np.pi for s in (*SPEEDS, SPEEDS[0])], "angle [deg];n [rpm]")
    bare = csv([*ANGLES, 360.0], [*SPEEDS, SPEEDS[0]], "angle;speed")
    expected = ct.run(machine()).driving_torque
    np.testing.assert_allclose(ct.run(machine(rpm)).driving_torque, expected, rtol=1e-11, atol=1e-11)
    np.testing.assert_allclose(ct.run(machine(bare, {"speed_unit": "rad/s"})).driving_torque, expected, rtol=1e-14)


@pytest.mark.parametrize(
    ("text", "curve", "said"),
    [
        ("0;1\n90;2\n180;1", {}, f"shaft.main.speed_curve.speed_unit: the file {NO_UNIT} speed"),
        (
            "0;1\n90;2\n180;1",
            {"speed_unit": "mm"},
            "shaft.main.speed_curve.speed_unit = mm: must be one of: rpm, rad/s",
        ),
        (csv([0, 90, 180], [1, 2, 1]), {}, "speed.csv:4:1  shaft.main.speed_curve.file = speed.csv: reaches from 0°"),
        (csv([0, 90, 80, 360], [1, 2, 1, 1]), {}, "speed.csv:4:1  shaft.main.speed_curve = 80: must be more than"),
        (
            csv([0, 90, 180, 360], [1, -2, 1, 1]),
            {},
            "shaft.main.speed_curve.file = speed.csv: must have speeds of more than 0",
        ),
        (csv([0, 180, 360], [1, 2, 1]), {}, "speed_curve.file = speed.csv: must have at least 3 angles"),
        (csv([0, 10, 180, 360], [1, 100, 1, 1]), {}, "speed_curve.file = speed.csv: must have more angles"),
        (csv([0, 90, 180, 360], [1, 2, 1, 9]), {}, f"{AS_AT_THE_START}, 1"),
        ("0;1;2\n360;1;2", {}, f"columns: {THREE_COLUMNS} are crank angle and speed"),
        ("0\n360", {}, "has one column; a speed curve needs two, crank angle and speed"),
    ],
)
def test_files_that_cannot_be(text, curve, said):
    with pytest.raises(ct.InputError) as caught:
        machine(text, curve)
    assert said in str(caught.value)


def test_a_file_that_nobody_has_read():
    with pytest.raises(ct.InputError, match=r"shaft\.main\.speed_curve\.file|has not been read"):
        ct.run(ct.Machine(shaft={"main": {"speed_curve": {"file": "a.csv"}}}, mechanism=slider()))


def test_what_does_not_stand_beside_it():
    with pytest.raises(ct.InputError, match=r"shaft\.main\.acceleration = 5 rad/s²: must not stand beside speed_curve"):
        curve = {"file": "speed.csv", "text": TEXT}
        main_shaft = {"speed": "5 rpm", "acceleration": "5 rad/s²", "speed_curve": curve}
        ct.Machine(shaft={"main": main_shaft}, mechanism=slider())
    with pytest.raises(ct.InputError, match=r"shaft\.b\.speed_curve: must stand in \[shaft.main\]"):
        curve = {"file": "speed.csv", "text": TEXT}
        ct.Machine(shaft={"b": {"speed_curve": curve}}, bank={"A": {"mechanism": slider(), "shaft": "b"}})
    with pytest.raises(ct.InputError, match=r"speed = running: must be left out: \[shaft.main.speed_curve\] says"):
        ct.run(machine(evenness={"flywheel": "1 kg·m²"}), speed="running")


def test_ones_own_speeds_are_instead_of_the_files():
    own = ct.run(machine(), speed=np.full(360, 50.0))
    assert own.mean_piston_speed[0] == pytest.approx(2 * RADIUS * 50 / np.pi, rel=1e-12)


MACHINE = """
[shaft.main]
throws = ["0 deg"]
{speed}
[mechanism]
kind = "slider_crank"
crank_radius = "50 mm"
rod_length = "180 mm"
[masses.piston]
mass = "2.5 kg"
"""


def test_in_a_machine_file_and_at_the_terminal(tmp_path, monkeypatch, capsys):
    (tmp_path / "machines").mkdir()
    (tmp_path / "machines/own.csv").write_text(TEXT, encoding="utf-8")
    (tmp_path / "typed.csv").write_text(csv([0, 90, 200, 360], [50, 60, 40, 50]), encoding="utf-8")
    table = '[shaft.main.speed_curve]\nfile = "own.csv"'
    (tmp_path / "machines/with.toml").write_text(MACHINE.format(speed=table), encoding="utf-8")
    (tmp_path / "machines/plain.toml").write_text(MACHINE.format(speed='speed = "900 rpm"'), encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    loaded = ct.run(ct.load("machines/with.toml"))
    np.testing.assert_allclose(loaded.driving_torque, ct.run(machine()).driving_torque, rtol=1e-13)
    speeds = Exact([0, 90, 200], [50, 60, 40]).drive(np.radians(np.arange(360.0)))[0] * 30 / np.pi
    said = f"All of this is {SPEED_AS_GIVEN}, {min(speeds):.1f} rpm to {max(speeds):.1f} rpm"
    for name in ("with", "plain"):
        assert main(["run", f"machines/{name}.toml", "--speed-curve", "typed.csv"]) == 0
        assert said in " ".join(capsys.readouterr().out.split())
    assert main(["run", "machines/plain.toml", "--speed-curve", "typo.csv"]) != 0
    assert f"--speed-curve  typo.csv: {NO_FILE}" in capsys.readouterr().err
    picture = ["plot", "machines/plain.toml", "--speed-curve", "typed.csv", "-o", "a.png"]
    assert main([*picture, "--plan", "klein", "--at", "30 deg"]) != 0
    assert "--speed-curve: must be left out: Klein's construction" in capsys.readouterr().err
    assert main(["plot", "machines/with.toml", "-o", "a.png", "--plan", "klein", "--at", "30 deg"]) != 0
    assert "must turn evenly for Klein's construction" in capsys.readouterr().err


def test_a_bank_needs_no_more():
    curve = {"file": "speed.csv", "text": TEXT}
    shaft = throws(0, 180)
    shaft["main"] |= {"speed_curve": curve}
    result = ct.run(ct.Machine(shaft=shaft, bank=banks(A=0)))
    np.testing.assert_allclose(result.piston_velocity[0][0:1], 0.0, atol=1e-12)
    assert result.mean_piston_speed.tolist() == pytest.approx([2 * RADIUS * Exact().mean() / np.pi] * 2, rel=1e-12)
