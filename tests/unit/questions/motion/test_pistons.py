"""Motion and speeds of pistons: extremes in closed form, and where they are."""

import mpmath
import numpy as np
import pytest
from tests.machines import RADIUS, ROD, V12, curve, of, slider, slider_position, throws
from tests.told import line_of

import cranktrain as ct

OMEGA = 2000 * np.pi / 30


def run(**mechanism):
    return ct.run(ct.Machine(mechanism=slider(**mechanism), shaft=throws(0, speed="2000 rpm")))


def test_pressure_angle_is_largest_across_the_line_of_stroke():
    """sin β = (R sin φ − e)/L: (R − e)/L at 90°, −(R + e)/L at 270°; alike without an offset, the one at 90° first."""
    central = run()
    assert central.largest_pressure_angle[0] == pytest.approx(np.arcsin(RADIUS / ROD), rel=1e-15)
    assert central.largest_pressure_angle_at[0] == pytest.approx(90)
    assert central.opposite_pressure_angle[0] == pytest.approx(-np.arcsin(RADIUS / ROD), rel=1e-15)
    offset = run(offset="20 mm")
    assert offset.largest_pressure_angle[0] == pytest.approx(-np.arcsin((RADIUS + 0.02) / ROD), rel=1e-15)
    assert offset.largest_pressure_angle_at[0] == pytest.approx(270)
    assert offset.opposite_pressure_angle[0] == pytest.approx(np.arcsin((RADIUS - 0.02) / ROD), rel=1e-15)
    assert offset.opposite_pressure_angle_at[0] == pytest.approx(90)
    np.testing.assert_allclose(np.max(-offset.rod_angle), offset.opposite_pressure_angle[0], rtol=1e-15)


def test_speeds():
    """Mean 2 S n; the largest by a root of s″ in 40 digits; accelerations Rω²(1 ± λ) at the dead centres."""
    result = run()
    mpmath.mp.dps = 40

    def position(phi):
        return RADIUS * mpmath.cos(phi) + mpmath.sqrt(mpmath.mpf(ROD) ** 2 - (RADIUS * mpmath.sin(phi)) ** 2)

    fastest = mpmath.findroot(lambda phi: mpmath.diff(position, phi, 2), 1.3)
    velocity = float(-mpmath.diff(position, fastest)) * OMEGA
    assert result.mean_piston_speed[0] == pytest.approx(2 * 2 * RADIUS * 2000 / 60, rel=1e-14)
    assert result.largest_piston_speed[0] == pytest.approx(velocity, rel=1e-14)
    assert result.largest_piston_speed_at[0] == pytest.approx(float(mpmath.degrees(fastest)), rel=1e-14)
    assert result.smallest_piston_velocity[0] == pytest.approx(-velocity, rel=1e-14)
    assert result.smallest_piston_velocity_at[0] == pytest.approx(360 - float(mpmath.degrees(fastest)), rel=1e-14)
    assert result.largest_piston_acceleration[0] == pytest.approx(RADIUS * OMEGA**2 * (1 + RADIUS / ROD), rel=1e-14)
    assert result.largest_piston_acceleration_at[0] == pytest.approx(0, abs=1e-7)


def test_rod_longer_than_four_cranks_decelerates_most_at_the_bottom():
    result = run(rod_length="250 mm")
    assert result.smallest_piston_acceleration[0] == pytest.approx(-RADIUS * OMEGA**2 * (1 - 0.2), rel=1e-13)
    assert result.smallest_piston_acceleration_at[0] == pytest.approx(180)


def test_short_rod_decelerates_most_on_both_sides_of_the_bottom():
    """For λ > 1/4 there are two equal extremes; the value is theirs, not the bottom's."""
    result = run(rod_length="120 mm")
    alpha = np.radians(np.arange(0, 360, 1e-3))
    step = 1e-4
    second = (
        slider_position(alpha + step, rod=0.12)
        - 2 * slider_position(alpha, rod=0.12)
        + slider_position(alpha - step, rod=0.12)
    ) / step**2
    assert result.smallest_piston_acceleration[0] == pytest.approx(-np.max(second) * OMEGA**2, rel=1e-6)
    assert abs(result.smallest_piston_acceleration_at[0] - 180) > 10


def test_curves():
    result = run(offset="-15 mm")
    phi = np.radians(result.crank_angle)
    position = slider_position(phi, offset=-0.015)
    np.testing.assert_allclose(curve(result, "1"), result.top_position[0] - position, atol=1e-15)
    np.testing.assert_allclose(result.rod_angle[0], np.arcsin((-0.015 - RADIUS * np.sin(phi)) / ROD), atol=1e-15)
    np.testing.assert_allclose(result.piston_velocity, result.piston_velocity_coefficient * OMEGA, rtol=1e-14)
    np.testing.assert_allclose(
        result.rod_angular_acceleration, result.rod_acceleration_coefficient * OMEGA**2, rtol=1e-14
    )


def test_extremes_bound_the_curves():
    result = ct.run(ct.Machine(**V12), step_degrees=0.5)
    for largest, smallest, name in (
        ("largest_piston_velocity", "smallest_piston_velocity", "piston_velocity"),
        ("largest_piston_acceleration", "smallest_piston_acceleration", "piston_acceleration"),
    ):
        values = getattr(result, name)
        top, bottom = getattr(result, largest), getattr(result, smallest)
        scale = np.max(np.abs(values))
        assert np.all(np.max(values, axis=-1) <= top + 1e-13 * scale)
        assert np.all(np.min(values, axis=-1) >= bottom - 1e-13 * scale)
        np.testing.assert_allclose(np.max(values, axis=-1), top, rtol=1e-4)
        np.testing.assert_allclose(np.min(values, axis=-1), bottom, rtol=1e-4)


@pytest.mark.parametrize("offset", ["30 mm", "-30 mm"])
def test_the_largest_speed_is_of_either_stroke(offset):
    """With an offset one stroke is the quicker; its speed by a root of s″ in 40 digits."""
    result = ct.run(
        ct.Machine(
            shaft={"main": {"speed": "500 rpm"}},
            mechanism={"kind": "slider_crank", "crank_radius": "100 mm", "rod_length": "250 mm", "offset": offset},
        )
    )
    with mpmath.workdps(40):
        radius, rod, aside = mpmath.mpf("0.1"), mpmath.mpf("0.25"), mpmath.mpf(float(offset.split()[0])) / 1000

        def place(phi):
            return radius * mpmath.cos(phi) + mpmath.sqrt(rod**2 - (radius * mpmath.sin(phi) - aside) ** 2)

        def speed(phi):
            return abs(mpmath.diff(place, phi)) * 500 * mpmath.pi / 30

        dead = [mpmath.findroot(lambda phi: mpmath.diff(place, phi, 2), start) for start in (1.2, 5.0)]
        both = sorted((float(speed(phi)), float(mpmath.degrees(phi))) for phi in dead)
    assert both[1][0] > 1.005 * both[0][0]
    assert result.largest_piston_speed[0] == pytest.approx(both[1][0], rel=1e-13)
    assert result.largest_piston_speed_at[0] == pytest.approx(both[1][1], abs=1e-9)
    ends = sorted((float(result.largest_piston_velocity[0]), float(-result.smallest_piston_velocity[0])))
    assert ends == pytest.approx([both[0][0], both[1][0]], rel=1e-13)
    assert line_of(result, "Motion", "largest speed") == f"{both[1][0]:.3f} m/s"


def test_four_stroke_grid_holds_two_equal_turns():
    result = ct.run(ct.Machine(**V12))
    assert result.crank_angle.tolist() == list(range(720))
    np.testing.assert_allclose(result.piston_acceleration[:, :360], result.piston_acceleration[:, 360:], rtol=1e-10)


@pytest.mark.parametrize("margin", [1e-1, 1e-3, 1e-5, 1e-6])
def test_check_holds_for_machines_near_locking(margin):
    result = run(rod_length=f"{50 / (1 - margin)!r} mm")
    (check,) = result.checks
    assert check.name == "piston_derivatives"
    assert str(check.verdict()) == "holds"


def test_check_finds_a_wrong_derivative(monkeypatch):
    """An acceleration that is off by a millionth of its peak fails."""
    from cranktrain.questions.motion import dead_centres, pistons

    def off(motion):
        return motion._replace(second=motion.second + 1e-6 * RADIUS)

    sampled, slider = dead_centres.slider_and_rod, pistons.slider_motion

    def wrong_samples(mechanisms, angle):
        found = sampled(mechanisms, angle)
        return found._replace(slider=off(found.slider))

    monkeypatch.setattr(dead_centres, "slider_and_rod", wrong_samples)
    monkeypatch.setattr(pistons, "slider_motion", lambda mechanisms, angle: off(slider(mechanisms, angle)))
    (check,) = run().checks
    assert check.judged[0]
    assert not check.passed[0]
    assert str(check.verdict()) == "does not hold"


def test_answer():
    ram = run()
    assert [line_of(ram, "Motion", name) for name in ("mean speed", "largest speed")] == ["6.667 m/s", "10.87 m/s"]
    piston = ct.Machine(mechanism=slider(), shaft=throws(0, speed="2000 rpm"), cylinder={"bore": "80 mm"})
    engine = ct.run(piston)
    named = [line_of(engine, "Motion", name) for name in ("mean piston speed", "largest piston speed")]
    assert named == ["6.667 m/s", "10.87 m/s"]
    assert of(ram, "1", ram.stroke) == pytest.approx(0.1)
