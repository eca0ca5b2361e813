"""The steam-engine text on an eccentric, R = e, λ = e/l, in 40 digits: a valve of e = 60 mm on l = 1200 mm, λ = 0.05.

Displacement by its closed form, velocity and acceleration by differentiating it numerically; each form as printed.
The machine is one that a reader sent: a cylinder with λ = 0.25 and a valve set 120° ahead of its crank.
"""

import mpmath as mp
import numpy as np
import pytest

import cranktrain as ct

ECC2 = {
    "name": "valve",
    "rotation": "clockwise",
    "shaft": {"main": {"speed": "120 rpm"}},
    "bank": {
        "cylinder": {"mechanism": {"kind": "slider_crank", "crank_radius": "300 mm", "rod_length": "1200 mm"}},
        "valve": {
            "mechanism": {
                "kind": "eccentric",
                "eccentricity": "60 mm",
                "rod_length": "1200 mm",
                "angle_of_advance": "30 deg",
            }
        },
    },
}
SIZES = {"1cylinder": ("0.3", "1.2"), "1valve": ("0.06", "1.2")}
AHEAD = 120.0
SYMBOLS = ("Δx", "Δv", "Δj")


def exact(phi, radius, rod):
    return radius * (1 - mp.cos(phi)) + rod - mp.sqrt(rod**2 - (radius * mp.sin(phi)) ** 2)


def two(phi, radius, rod, sign=1):
    return radius * (1 - mp.cos(phi) + sign * radius / rod / 2 * mp.sin(phi) ** 2)


def projection(phi, radius, _rod):
    return radius * (1 - mp.cos(phi))


def brix(phi, radius, rod):
    """The ray from P = (−λR/2, 0) at φ meets the circle where |P + t u| = R."""
    pole = radius**2 / (2 * rod)
    reach = pole * mp.cos(phi) + mp.sqrt(radius**2 - (pole * mp.sin(phi)) ** 2)
    return radius - (reach * mp.cos(phi) - pole)


FORMS = {"two harmonics": two, "infinitely long rod (orthogonal projection of the crank pin)": projection}
FORMS["Brix's construction"] = brix


def error(form, order, radius, rod):
    """Difference of the derivatives of that order, a function of φ."""

    def off(phi):
        return abs(mp.diff(lambda x: form(x, radius, rod) - exact(x, radius, rod), phi, order))

    return off


def peak(curve):
    """Largest value over half a turn, to some 20 digits: a grid, then thirds of its best interval."""
    grid = [mp.pi * i / 60 for i in range(61)]
    best = max(range(61), key=lambda i: curve(grid[i]))
    low, high = grid[max(best - 1, 0)], grid[min(best + 1, 60)]
    for _ in range(60):
        a, b = low + (high - low) / 3, high - (high - low) / 3
        low, high = (a, high) if curve(a) < curve(b) else (low, b)
    return curve((low + high) / 2)


@pytest.fixture(scope="module")
def stated():
    return ct.textbook.motion(ECC2)


def of(stated, piston, name, at="largest"):
    return [one for one in stated if (one.of, one.name, one.at) == (piston, name, at)]


@pytest.mark.parametrize("piston", SIZES)
@pytest.mark.parametrize("name", FORMS)
@pytest.mark.parametrize("order", [0, 1, 2])
def test_largest_errors_and_their_angles(stated, piston, name, order):
    with mp.workdps(40):
        radius, rod = map(mp.mpf, SIZES[piston])
        off = error(FORMS[name], order, radius, rod)
        size = 2 * radius if order == 0 else peak(lambda phi: abs(mp.diff(lambda x: exact(x, radius, rod), phi, order)))
        (one,) = (each for each in of(stated, piston, name) if each.symbol == SYMBOLS[order])
        largest = float(peak(off) / size)
        there = float(off(mp.radians(mp.mpf(one.crank_angle))) / size)
    assert one.value == pytest.approx(largest, rel=1e-8)
    assert there == pytest.approx(largest, rel=1e-8)
    assert (one.exact, one.unit) == (0.0, "1")


@pytest.mark.parametrize("piston", SIZES)
def test_crank_side_is_the_mirror_of_the_head_side(stated, piston):
    """S + S′ = 2R for both, so that the errors are the same; in 40 digits for the displacement."""
    minus = of(stated, piston, "two harmonics from the crank-side dead centre", "largest, from the crank side")
    with mp.workdps(40):
        radius, rod = map(mp.mpf, SIZES[piston])

        def off(phi):
            return abs(two(phi, radius, rod, -1) - (2 * radius - exact(phi + mp.pi, radius, rod))) / (2 * radius)

        largest = float(peak(off))
    assert minus[0].value == pytest.approx(largest, rel=1e-8)
    head = of(stated, piston, "two harmonics")
    assert [one.value for one in minus] == pytest.approx([one.value for one in head], rel=1e-8)


@pytest.mark.parametrize("piston", SIZES)
def test_largest_difference(stated, piston):
    with mp.workdps(40):
        radius, rod = map(mp.mpf, SIZES[piston])
        printed, right = float(radius**2 / (2 * rod)), float(rod - mp.sqrt(rod**2 - radius**2))
    (found,) = (one for one in stated.numbered("335") if one.of == piston)
    assert (found.value, found.exact) == pytest.approx((printed, right), rel=1e-14)
    (pole,) = (one for one in stated if (one.symbol, one.of) == ("OP", piston))
    assert pole.value == pytest.approx(printed, rel=1e-14)


@pytest.mark.parametrize("piston", SIZES)
def test_brix_backwards(stated, piston):
    """φ by the ray from P to the point over S, less the angle in the triangle of R, L and R + L − S."""
    with mp.workdps(40):
        radius, rod = map(mp.mpf, SIZES[piston])

        def off(phi):
            way = exact(phi, radius, rod)
            pole = radius**2 / (2 * rod)
            ray = mp.atan2(mp.sqrt(way * (2 * radius - way)), radius - way + pole)
            return abs(ray - phi)

        largest = float(peak(lambda phi: off(min(max(phi, mp.mpf("1e-9")), mp.pi - mp.mpf("1e-9")))))
        by = {one.symbol: one for one in stated if (one.of, one.at) == (piston, "largest, backwards")}
        there = float(exact(mp.radians(mp.mpf(by["Δφ"].crank_angle)), radius, rod))
    # sought among 720 parts of the stroke, so to second order in these
    assert abs(by["Δφ"].value) == pytest.approx(largest, rel=1e-5)
    assert by["S"].value == pytest.approx(there, rel=1e-12)


@pytest.mark.parametrize("piston", SIZES)
def test_exact_root_and_arcs_are_off_by_rounding(stated, piston):
    exact_ones = [one for one in stated if one.of == piston and one.equation == "fig. 146"]
    assert len(exact_ones) == 4
    assert all(one.verdict == "right" and one.value < 1e-14 and np.isnan(one.crank_angle) for one in exact_ones)


def test_ranges(stated):
    """λ = 0.25 and 0.05: (334) is for λ < 0.1, the others for λ ≤ 0.3."""
    verdicts = {(one.of, one.equation): one.verdict for one in stated}
    assert verdicts["1cylinder", "(334)"] == "out of range"
    assert verdicts["1valve", "(334)"] == "approximate"
    assert {verdicts[piston, "(333)"] for piston in SIZES} == {"approximate"}
    ranges = stated.notes["Two harmonics: (333), (336), (337) [steam-engine]"]
    assert ranges[1] == "1cylinder: inside, λ = 0.25; 1valve: inside, λ = 0.05"


@pytest.mark.parametrize("running", ["ahead", "astern"])
@pytest.mark.parametrize("rotation", ["clockwise", "anticlockwise"])
def test_an_eccentric_is_the_slider_crank_of_its_size_set_ahead(running, rotation):
    """In a run: every form over the turn, 120° later; astern 120° earlier."""
    valve = ct.run(ECC2, set={"running": running, "rotation": rotation})
    crank = {"kind": "slider_crank", "crank_radius": "60 mm", "rod_length": "1200 mm"}
    plain = ct.run({"mechanism": crank, "running": running, "rotation": rotation})
    step = plain.crank_angle[1] - plain.crank_angle[0]
    turn = plain.crank_angle < 360.0
    shift = -round((AHEAD if running == "ahead" else -AHEAD) / step)
    for name in ("displacement", "velocity_coefficient", "acceleration_coefficient"):
        own = getattr(valve, f"{name}_by_method")[:, 1][:, turn]
        expected = np.roll(getattr(plain, f"{name}_by_method")[:, 0][:, turn], shift, axis=-1)
        assert np.isfinite(own[:4]).all()
        # in mm or mm/rad², of 120 mm
        np.testing.assert_allclose(own, expected, rtol=0, atol=120 * 1e-12)
    for name in ("displacement_error", "velocity_error", "acceleration_error"):
        np.testing.assert_allclose(getattr(valve, name)[:, 1], getattr(plain, name)[:, 0], rtol=0, atol=1e-13)


@pytest.mark.parametrize("running", ["ahead", "astern"])
def test_statements_are_those_of_the_slider_crank(running):
    valve = [one for one in ct.textbook.motion(ECC2, set={"running": running}) if one.of == "1valve"]
    crank = {"kind": "slider_crank", "crank_radius": "60 mm", "rod_length": "1200 mm"}
    plain = ct.textbook.motion({"mechanism": crank, "running": running})
    assert [(one.equation, one.symbol, one.verdict) for one in valve] == [
        (one.equation, one.symbol, one.verdict) for one in plain
    ]
    np.testing.assert_allclose([one.value for one in valve], [one.value for one in plain], rtol=0, atol=1e-12)
    curves = [one for one in ct.textbook.motion(ECC2, set={"running": running}).over_turn if one.of == "1valve"]
    for own, other in zip(curves, plain.over_turn, strict=True):
        np.testing.assert_allclose(own.values, other.values, rtol=0, atol=1e-12)
        np.testing.assert_allclose(own.exact, other.exact, rtol=0, atol=1e-12)


def test_statements_agree_with_a_run(stated):
    result = ct.run(ECC2)
    methods = {"two_harmonics": "two harmonics", "brix": "Brix's construction"}
    for key, name in methods.items():
        row = result.labels["motion_method"].index(key)
        for column, piston in enumerate(SIZES):
            values = [
                getattr(result, f"{quantity}_error")[row, column]
                for quantity in ("displacement", "velocity", "acceleration")
            ]
            assert [one.value for one in of(stated, piston, name)] == pytest.approx(values, rel=1e-8)
