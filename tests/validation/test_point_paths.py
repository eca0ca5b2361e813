"""Paths of points on links: extents, lengths, speeds and shares of the turn, by closed forms and by brute force."""

import tomllib

import numpy as np
import pytest

import cranktrain as ct

FOUR_BAR = """
[shaft.main]
speed = "600 rpm"
[mechanism]
kind = "crank_rocker"
crank_radius = "100 mm"
rod_length = "300 mm"
rocker_length = "250 mm"
ground_length = "280 mm"
[mechanism.points.pin]
link = "rod"
along = "0 mm"
across = "0 mm"
band = "20 mm"
[mechanism.points.tip]
link = "rod"
along = "150 mm"
across = "120 mm"
band = "15 mm"
toward = "37 deg"
[mechanism.points.joint]
link = "rocker"
along = "250 mm"
across = "0 mm"
"""


@pytest.fixture(scope="module")
def result():
    return ct.run(ct.Machine(**tomllib.loads(FOUR_BAR)))


@pytest.fixture(scope="module")
def fine():
    """The same paths in steps of a hundredth of a degree."""
    return ct.run(ct.Machine(**tomllib.loads(FOUR_BAR)), step_degrees=0.01, quantities=["point_x", "point_y"])


def test_a_point_on_the_crank_pin_goes_round_a_circle(result):
    """R 100 mm, 600 rpm: 2πR, ±R, Rω, Rω²; within 20 mm of the lowest while −sin φ > 0.8."""
    omega = 20 * np.pi
    place = result.labels["point"].index("1.pin")
    assert result.point_path_length[place] == pytest.approx(0.2 * np.pi, rel=1e-13)
    assert result.smallest_point_x[place] == pytest.approx(-0.1, rel=1e-14)
    assert result.largest_point_y[place] == pytest.approx(0.1, rel=1e-14)
    assert result.largest_point_y_at[place] == pytest.approx(90, abs=1e-9)
    assert result.largest_point_speed[place] == pytest.approx(0.1 * omega, rel=1e-13)
    assert result.largest_point_acceleration[place] == pytest.approx(0.1 * omega**2, rel=1e-13)
    assert result.point_band_share[place] == pytest.approx(np.arccos(0.8) / np.pi, rel=1e-13)


def test_a_joint_on_a_rocker_goes_to_and_fro_on_an_arc(result):
    """Twice the swing times the arm, with two points at which it stands."""
    place = result.labels["point"].index("1.joint")
    assert result.point_path_length[place] == pytest.approx(2 * 0.25 * result.swing[0], rel=1e-10)


def test_a_coupler_point_by_steps_of_a_hundredth_of_a_degree(result, fine):
    place = result.labels["point"].index("1.tip")
    x, y = fine.point_x[place], fine.point_y[place]
    assert result.smallest_point_x[place] == pytest.approx(np.min(x), abs=1e-8)
    assert result.largest_point_y[place] == pytest.approx(np.max(y), abs=1e-8)
    path = np.append(x, x[0]) + 1j * np.append(y, y[0])
    assert result.point_path_length[place] == pytest.approx(np.sum(np.abs(np.diff(path))), rel=1e-8)
    ahead = x * np.cos(np.radians(37)) + y * np.sin(np.radians(37))
    share = np.mean(ahead > np.max(ahead) - 0.015)
    assert result.point_band_share[place] == pytest.approx(share, abs=1e-4)
    omega = 20 * np.pi
    velocity = np.fft.ifft(np.fft.fft(path[:-1]) * 1j * np.fft.fftfreq(x.size, 1 / x.size)) * omega
    assert result.largest_point_speed[place] == pytest.approx(np.max(np.abs(velocity)), rel=1e-7)


def test_facts_are_those_among_designs_and_at_any_step(result):
    names = ("point_path_length", "point_band_share", "largest_point_speed", "smallest_point_y_at")
    machine = ct.Machine(**tomllib.loads(FOUR_BAR))
    both = ct.run([machine.with_({"mechanism.crank_radius": radius}) for radius in ("100 mm", "90 mm")])
    coarse = ct.run(machine, step_degrees=10)
    for name in names:
        np.testing.assert_allclose(getattr(both, name)[0], getattr(result, name), rtol=1e-11, atol=1e-9, equal_nan=True)
        np.testing.assert_allclose(getattr(coarse, name), getattr(result, name), rtol=1e-12, equal_nan=True)


def test_points_of_several_mechanisms_are_those_of_each_alone(result):
    """Two banks of one linkage on two throws, one with a point more: what is asked of one is not asked of the other."""
    tables = tomllib.loads(FOUR_BAR)
    mechanism = tables["mechanism"]
    fewer = mechanism | {"points": {"tip": mechanism["points"]["tip"]}}
    both = ct.run(
        ct.Machine(
            shaft={"main": {"speed": "600 rpm", "throws": ["0 deg", "70 deg"]}},
            bank={"A": {"throws": [1], "mechanism": mechanism}, "B": {"throws": [2], "mechanism": fewer}},
        )
    )
    names, alone = both.labels["point"], result.labels["point"]
    assert len(names) == len(alone) + 1
    for name in ("smallest_point_x", "largest_point_y", "point_path_length", "point_band_share", "largest_point_speed"):
        found, expected = getattr(both, name), getattr(result, name)
        for place, whose in enumerate(names):
            one = expected[alone.index(f"1.{whose.rpartition('.')[2]}")]
            np.testing.assert_allclose(found[place], one, rtol=1e-12, equal_nan=True)
