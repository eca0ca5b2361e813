"""Gravity of any strength and direction, by closed forms: m g R sin of a crank, and what weights lose in height."""

import numpy as np
import pytest
from tests.machines import slider
from tests.sentences import NOT_POSITIVE, TRUE_OR_FALSE

import cranktrain as ct

MASS, RADIUS = 3.0, 0.05
CRANK = {"crank": {"mass": f"{MASS} kg", "along": f"{RADIUS} m", "inertia": "0 kg·m²"}}


def heavy_crank(gravity, angle=0.0, **fields):
    """A crank with a mass at its pin, on which nothing else weighs; at constant speed its inertia gives no torque."""
    return ct.run(
        ct.Machine(
            shaft={"main": {"speed": "60 rpm"}},
            angle=f"{angle} deg",
            mechanism=slider(),
            masses=CRANK,
            gravity=gravity,
            **fields,
        ),
        quantities=["machine_torque"],
    )


@pytest.mark.parametrize("rotation", ["clockwise", "anticlockwise"])
@pytest.mark.parametrize(("angle", "direction"), [(0, 0), (0, 30), (90, 0), (-40, 115), (90, -90)])
def test_the_weight_of_a_crank(rotation, angle, direction):
    """In the normal sense the crank stands at φ + γ from Y and gravity points to 180° + δ: m g R sin(φ + γ − δ)."""
    gravity = {"acceleration": "9.79 m/s²", "direction": f"{direction} deg"}
    result = heavy_crank(gravity, angle, rotation=rotation)
    expected = MASS * 9.79 * RADIUS * np.sin(np.radians(result.crank_angle + angle - direction))
    np.testing.assert_allclose(result.machine_torque, expected, atol=1e-13)


def test_astern_the_same_metal_stands_in_the_same_field():
    """At −φ in the normal sense, and the torque counts in the other."""
    result = heavy_crank({"direction": "25 deg"}, 10, running="astern")
    expected = -MASS * 9.80665 * RADIUS * np.sin(np.radians(-result.crank_angle + 10 - 25))
    np.testing.assert_allclose(result.machine_torque, expected, atol=1e-13)


def test_true_is_standard_gravity_straight_down():
    true, table = heavy_crank(True, 20), heavy_crank({}, 20)
    np.testing.assert_array_equal(true.machine_torque, table.machine_torque)
    np.testing.assert_allclose(heavy_crank(False, 20).machine_torque, 0.0, atol=1e-15)
    moon = heavy_crank({"acceleration": "162 cm/s^2"}, 20)
    np.testing.assert_allclose(moon.machine_torque, true.machine_torque * 1.62 / 9.80665, rtol=1e-14, atol=1e-15)


@pytest.mark.parametrize("direction", [0, 90, -35])
def test_weights_give_what_they_lose_in_height(direction):
    """Slowly, so that inertia is as nothing: M = −dE/dφ, with heights along the field, by the Fourier series of E."""
    masses = {
        "rod": {"mass": "2 kg", "along": "60 mm", "inertia": "0.01 kg·m²"},
        "piston": {"mass": "1.5 kg"},
    }
    machine = ct.Machine(
        shaft={"main": {"speed": "1e-6 rpm"}},
        angle="20 deg",
        mechanism=slider(points={"centroid": {"link": "rod", "along": "60 mm", "across": "0 mm"}}),
        masses=masses,
        gravity={"direction": f"{direction} deg"},
    )
    result = ct.run(machine)
    up = np.radians(20 - direction)  # of the mechanism's x, from the upward direction
    piston = result.top_position[0] - result.piston_displacement[0]
    along, across = (np.ravel(part) for part in (result.point_x, result.point_y))
    height = 1.5 * piston * np.cos(up) + 2.0 * (along * np.cos(up) - across * np.sin(up))
    series = np.fft.rfft(9.80665 * height)
    slope = np.fft.irfft(series * 1j * np.arange(series.size), height.size)
    np.testing.assert_allclose(result.machine_torque, -slope, atol=1e-10)


def test_designs_may_lean_differently():
    results = ct.run(
        [
            ct.Machine(
                shaft={"main": {"speed": "60 rpm"}},
                mechanism=slider(),
                masses=CRANK,
                gravity={"direction": f"{direction} deg"},
            )
            for direction in (0, 90)
        ],
        quantities=["machine_torque"],
    )
    np.testing.assert_allclose(results.machine_torque[1], np.roll(results.machine_torque[0], 90), atol=1e-13)


@pytest.mark.parametrize(
    ("gravity", "path", "said"),
    [
        (5, "gravity", TRUE_OR_FALSE),
        ({"acceleration": "0 m/s²"}, "gravity.acceleration", NOT_POSITIVE),
        ({"acceleration": "9.8 m/s"}, "gravity.acceleration", "must be an acceleration in m/s²"),
        ({"direction": "5 mm"}, "gravity.direction", "must be an angle"),
        ({"angle": "5 deg"}, "gravity.angle", "acceleration, direction"),
    ],
)
def test_gravity_that_cannot_be(gravity, path, said):
    with pytest.raises(ct.InputError) as caught:
        heavy_crank(gravity)
    (problem,) = caught.value.problems
    assert problem.path == path
    assert said in str(problem)
