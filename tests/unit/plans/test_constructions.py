"""Drawn constructions: each is what its source draws, and what the exact triangle has beside it."""

import mpmath as mp
import numpy as np
import pytest

import cranktrain as ct
from cranktrain.errors import InputError
from cranktrain.plans.constructions import construction, exact_crank_angle
from cranktrain.plans.positions import source_angles

R, L, E = 0.05, 0.18, 0.012
ANGLES = (0.0, 24.0, 90.0, 133.0, 180.0, 247.0)


def crank(offset=0.0, **more):
    mechanism = {"kind": "slider_crank", "crank_radius": f"{R} m", "rod_length": f"{L} m", "offset": f"{offset} m"}
    return ct.Machine(mechanism=mechanism, **more)


def is_outside(found):
    return found.limits.outside(found.ratio, found.geometry.offset)


def displacement_exact(degrees, offset):
    """From the true top, in 40 digits."""
    with mp.workdps(40):
        radius, rod, e = (mp.mpf(str(value)) for value in (R, L, offset))
        phi = mp.radians(mp.mpf(degrees))
        place = radius * mp.cos(phi) + mp.sqrt(rod**2 - (radius * mp.sin(phi) - e) ** 2)
        return float(mp.sqrt((radius + rod) ** 2 - e**2) - place)


@pytest.mark.parametrize("offset", [0.0, E, -E])
def test_arc_is_exact_with_an_offset_too(offset):
    found = construction(crank(offset), "arc", ANGLES)
    expected = [displacement_exact(angle, offset) for angle in ANGLES]
    np.testing.assert_allclose(found.displacement, expected, rtol=0, atol=1e-16)
    np.testing.assert_allclose(found.exact_displacement, expected, rtol=0, atol=1e-16)
    assert found.limits is None
    # crank pin and foot are on one circle about the piston's pin
    for point in (found.on_circle, found.foot):
        np.testing.assert_allclose(np.hypot(*(point - found.piston)), L, rtol=1e-14)
    np.testing.assert_allclose(found.foot[1], offset, atol=0)


def test_projection_is_334():
    found = construction(crank(), "projection", ANGLES)
    np.testing.assert_allclose(found.displacement, R * (1 - np.cos(np.radians(ANGLES))), rtol=1e-14, atol=1e-18)
    np.testing.assert_allclose(found.foot[0], found.on_circle[0], rtol=0, atol=1e-16)
    assert is_outside(found) and found.limits.condition == "central mechanism, λ < 0.1"


def test_brix_rays_come_from_the_pole_at_the_crank_angle():
    found = construction(crank(), "brix", ANGLES)
    assert found.pole == pytest.approx(-(R**2) / (2 * L), rel=1e-15)  # behind the shaft, away from the cylinder
    ray = found.on_circle - np.array([[found.pole], [0.0]])
    np.testing.assert_allclose(np.arctan2(ray[1], ray[0]) % (2 * np.pi), np.radians(ANGLES), rtol=0, atol=1e-14)
    np.testing.assert_allclose(np.hypot(*found.on_circle), R, rtol=1e-14)
    np.testing.assert_allclose(R - found.on_circle[0], found.displacement, rtol=0, atol=1e-16)
    assert not is_outside(found) and found.ratio == pytest.approx(R / L)


def test_brix_backwards_reads_the_ray_to_the_point_over_the_displacement():
    found = construction(crank(), "brix_backward", 10)
    np.testing.assert_allclose(found.displacement, 2 * R * np.arange(11) / 10, rtol=1e-14)
    ray = found.on_circle - np.array([[found.pole], [0.0]])
    np.testing.assert_allclose(np.arctan2(ray[1], ray[0]), found.angle, rtol=0, atol=1e-7)  # √ at the ends
    np.testing.assert_allclose(R - found.on_circle[0], found.displacement, rtol=0, atol=1e-16)


@pytest.mark.parametrize("offset", [0.0, E, -E])
def test_exact_angle_has_the_displacement_that_it_comes_from(offset):
    found = construction(crank(offset), "brix_backward", 8)
    again = [displacement_exact(np.degrees(angle), offset) for angle in found.exact_angle]
    np.testing.assert_allclose(again, found.displacement, rtol=0, atol=1e-15)
    assert is_outside(found) == (offset != 0)
    given = construction(crank(offset), "brix_backward", [30.0, 300.0])
    np.testing.assert_allclose(given.exact_angle, np.radians([30.0, 60.0]), rtol=1e-14)
    np.testing.assert_allclose(exact_crank_angle(given.displacement, given.geometry), given.exact_angle, rtol=1e-12)


@pytest.mark.parametrize("times", [1e5, 1e9, 1e12])
def test_exact_angle_of_a_rod_without_end(times):
    """The crank pin's own projection, to λ/2: 1 − cos φ of the radius, at every tenth of the stroke, its ends too."""
    endless = ct.Machine(mechanism={"kind": "slider_crank", "crank_radius": f"{R} m", "rod_length": f"{times * R} m"})
    found = construction(endless, "brix_backward", 10)
    np.testing.assert_allclose(found.displacement, 2 * R * np.arange(11) / 10, rtol=1e-14)
    np.testing.assert_allclose(found.exact_angle, np.arccos(1 - np.arange(11) / 5), rtol=0, atol=1 / times)


def test_beyond_the_stroke_is_no_angle():
    geometry = construction(crank(), "arc").geometry
    assert np.all(np.isnan(exact_crank_angle(np.array([-1e-9, 2 * R + 1e-9]), geometry)))


def test_other_mechanisms_and_angles_are_refused():
    with pytest.raises(InputError, match="no slider-crank"):
        construction(ct.load("pumping_unit_c57"), "arc")
    short = ct.Machine(mechanism={"kind": "slider_crank", "crank_radius": "50 mm", "rod_length": "40 mm"})
    with pytest.raises(InputError, match="cannot close at every angle"):
        construction(short, "arc", [90.0])


def test_source_angles_are_the_pressure_angle_and_its_opposite():
    """λ = 5/18: the largest pressure angle, asin λ, with the crank across; as shown where crank 1 points up is 0."""
    pressure = np.degrees(np.arcsin(R / L))
    found = source_angles(crank())
    assert len(found) == 12
    assert set(found) >= {0.0, 90.0, 180.0, 270.0, round(pressure, 9), round(pressure + 180.0, 9)}
    turned = source_angles(crank(crank_zero="70 deg"))
    np.testing.assert_allclose(np.mod(np.add(turned, 70.0), 360.0), found, rtol=0, atol=1e-8)
    assert source_angles(crank(crank_zero="70 deg"), is_shown=False) == found


@pytest.mark.parametrize("offset", [0.0, E, -E])
@pytest.mark.parametrize(("turns", "sense"), [({}, -1.0), ({"rotation": "anticlockwise"}, 1.0)])
def test_constructions_turn_as_the_machine_does(offset, turns, sense):
    """Seen from the free end with the line of stroke to the right: clockwise the pin at 30° is below, else above."""
    for method in ("arc", "projection", "brix"):
        found = construction(crank(offset, **turns), method, [30.0])
        x, y = found.seen(found.on_circle)[:, 0]
        assert x > 0 and np.sign(y) == sense
        line = found.seen(found.piston)[1, 0]
        assert line == pytest.approx(sense * offset, abs=1e-15)
    astern = construction(crank(offset, running="astern", **turns), "arc", [30.0])
    assert np.sign(astern.seen(astern.on_circle)[1, 0]) == -sense


@pytest.mark.parametrize("offset", [0.0, E, -E])
def test_dead_positions_are_the_results(offset):
    result = ct.run(crank(offset))
    pins, pistons = construction(crank(offset), "arc", [30.0]).dead_pins
    angles = np.degrees(np.arctan2(pins[1], pins[0])) % 360.0
    np.testing.assert_allclose(angles, [result.top_dead_centre[0] % 360.0, result.bottom_dead_centre[0]], atol=1e-9)
    np.testing.assert_allclose(pistons[0, 0], result.top_position[0], rtol=1e-12)
    np.testing.assert_allclose(pistons[0, 0] - pistons[0, 1], result.stroke[0], rtol=1e-12)
    np.testing.assert_allclose(np.hypot(*(pistons - pins)), L, rtol=1e-12)


@pytest.mark.parametrize("offset", [0.0, E, -E])
def test_readings_of_arcs_begin_where_the_top_is_read(offset):
    """The displacement on paper is the distance from there to the foot, in every position."""
    found = construction(crank(offset), "arc", ANGLES)
    np.testing.assert_allclose(found.start[0] - found.foot[0], found.exact_displacement, rtol=0, atol=1e-15)


def valve(running="ahead", offset=0.0):
    mechanism = {"kind": "eccentric", "eccentricity": f"{R} m", "rod_length": f"{L} m", "angle_ahead": "120 deg"}
    return ct.Machine(
        bank={
            "A": {"mechanism": {"kind": "slider_crank", "crank_radius": "0.1 m", "rod_length": "0.4 m"}},
            "B": {"mechanism": mechanism | {"offset": f"{offset} m"}},
        },
        running=running,
    )


@pytest.mark.parametrize("running", ["ahead", "astern"])
@pytest.mark.parametrize("method", ["arc", "projection", "brix", "brix_backward"])
def test_an_eccentric_is_constructed_as_the_crank_of_its_size(method, running):
    """By its own angle, however far ahead it stands."""
    found = construction(valve(running, E), method, ANGLES, mechanism="1B")
    plain = construction(crank(E, running=running), method, ANGLES)
    for name in ("displacement", "exact_displacement", "angle", "exact_angle", "foot", "on_circle", "piston"):
        np.testing.assert_allclose(getattr(found, name), getattr(plain, name), rtol=0, atol=1e-16)
    assert (found.pole, found.sense, found.stroke) == (plain.pole, plain.sense, plain.stroke)
    assert found.is_of_eccentric and not plain.is_of_eccentric


def test_the_first_slider_crank_comes_before_an_eccentric_and_the_eccentric_alone_is_taken():
    assert construction(valve(), "arc").mechanism == "1A"
    alone = {"kind": "eccentric", "eccentricity": "60 mm", "rod_length": "1200 mm", "angle_of_advance": "30 deg"}
    assert construction(ct.Machine(mechanism=alone), "arc").is_of_eccentric


def test_source_angles_of_an_eccentric_are_where_its_own_crank_is_along_and_across():
    """120° ahead of the crank, whose 0 the machine shows."""
    found = source_angles(valve(), mechanism="1B")
    plain = source_angles(crank())
    np.testing.assert_allclose(np.mod(np.add(found, 120.0), 360.0), plain, rtol=0, atol=1e-8)


def test_letters_of_figure_146_from_both_dead_centres():
    """x_B = A_M D + DC and x_B′ = A_M′D′ − D′C′, in 40 digits: A_M D = R(1 − cos φ), DC = L − √(L² − R² sin² φ)."""
    found = construction(crank(), "arc", ANGLES)
    other = found.from_crank_side
    with mp.workdps(40):
        radius, rod = mp.mpf(str(R)), mp.mpf(str(L))
        angles = [mp.radians(mp.mpf(angle)) for angle in ANGLES]
        along = np.array([float(radius * (1 - mp.cos(phi))) for phi in angles])
        lost = np.array([float(rod - mp.sqrt(rod**2 - (radius * mp.sin(phi)) ** 2)) for phi in angles])
    np.testing.assert_allclose(R - found.projected[0], along, rtol=0, atol=1e-16)
    np.testing.assert_allclose(found.projected[0] - found.foot[0], lost, rtol=0, atol=1e-16)
    np.testing.assert_allclose(other.projected[0] + R, along, rtol=0, atol=1e-16)
    np.testing.assert_allclose(other.projected[0] - other.foot[0], lost, rtol=0, atol=1e-16)
    np.testing.assert_allclose(other.displacement, along - lost, rtol=0, atol=1e-16)
    np.testing.assert_allclose(other.exact_displacement, along - lost, rtol=0, atol=1e-16)
    # the crank pin is half a turn from A
    np.testing.assert_allclose(other.on_circle, -found.on_circle, rtol=0, atol=1e-16)


@pytest.mark.parametrize("offset", [E, -E])
def test_from_the_crank_side_with_an_offset(offset):
    """At one place of the crank both displacements add up to the stroke."""
    found = construction(crank(offset), "arc", ANGLES).from_crank_side
    opposite = [displacement_exact(angle + 180.0, offset) for angle in ANGLES]
    whole = np.sqrt((L + R) ** 2 - offset**2) - np.sqrt((L - R) ** 2 - offset**2)
    np.testing.assert_allclose(found.displacement + opposite, whole, rtol=0, atol=1e-15)
    np.testing.assert_allclose(found.projected[1], offset, atol=0)
