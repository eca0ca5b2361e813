"""Torques of shafts and journals, the gear's reversals, orders: against closed forms."""

import re

import mpmath
import numpy as np
import pytest
from tests.machines import ROCKER, slider, throws
from tests.told import line_of

import cranktrain as ct
from cranktrain.questions.torque.torques import reversals

PISTON = {"piston": {"mass": "0.6 kg"}}
SPEED = 300.0


def inertia(*angles: float, **changes):
    tables = {"shaft": throws(*angles, speed=f"{SPEED!r} rad/s"), "bank": {"A": {"mechanism": slider()}}}
    return ct.run(ct.Machine(**(tables | {"masses": PISTON} | changes)))


def piston_torque(phi, sin=np.sin, cos=np.cos, sqrt=np.sqrt):
    """−m x′x″ω² of a central slider-crank of 50 and 180 mm, by hand."""
    r, rod = 0.05, 0.18
    root = sqrt(rod**2 - (r * sin(phi)) ** 2)
    first = r * sin(phi) + r**2 * sin(phi) * cos(phi) / root
    second = r * cos(phi) + r**2 * cos(2 * phi) / root + r**4 * (sin(phi) * cos(phi)) ** 2 / root**3
    return -0.6 * SPEED**2 * first * second


def test_extremes_are_refined():
    """Of the closed form, its derivative's roots in 30 digits; the torque is odd, so both extremes are alike."""
    result = inertia(0)
    phi = np.radians(np.arange(180))
    start = float(phi[np.argmax(np.abs(piston_torque(phi)))])
    with mpmath.workdps(30):
        exact = mpmath.findroot(
            lambda phi: mpmath.diff(lambda x: piston_torque(x, mpmath.sin, mpmath.cos, mpmath.sqrt), phi), start
        )
        value = float(piston_torque(exact, mpmath.sin, mpmath.cos, mpmath.sqrt))
    least, most = sorted((value, -value))
    assert result.smallest_torque == pytest.approx(least, rel=1e-13)
    assert result.largest_torque == pytest.approx(most, rel=1e-13)
    at = np.degrees(float(exact))
    ends = (at, 360 - at) if value > 0 else (360 - at, at)
    assert (result.largest_torque_at, result.smallest_torque_at) == pytest.approx(ends, abs=1e-6)
    np.testing.assert_allclose(result.machine_torque, piston_torque(np.radians(result.crank_angle)), atol=1e-12 * most)
    assert abs(result.mean_torque) < 1e-13 * most


def test_shown_angles_count_from_crank_zero():
    plain, shifted = inertia(0), inertia(0, crank_zero="40 deg")
    assert shifted.largest_torque == pytest.approx(float(plain.largest_torque), rel=1e-12)
    assert shifted.largest_torque_at == pytest.approx((float(plain.largest_torque_at) - 40) % 360, abs=1e-6)
    order = plain.labels["order"].index("2")
    turned = plain.torque_order_phase[order] - 2 * 40
    assert (shifted.torque_order_phase[order] - turned + 180) % 360 - 180 == pytest.approx(0, abs=1e-9)


def test_journals_gather_from_the_free_end():
    result = inertia(0, 90, 200)
    assert result.labels["journal"] == ("1", "2", "3", "4")
    phi = np.radians(result.crank_angle)
    fine = np.linspace(0, 2 * np.pi, 1_000_001)
    expected, between = np.zeros_like(phi), np.zeros_like(fine)
    peak = np.max(np.abs(result.machine_torque))
    for journal, throw in enumerate((0, 90, 200), start=1):
        expected = expected + piston_torque(phi + np.radians(throw))
        between = between + piston_torque(fine + np.radians(throw))
        np.testing.assert_allclose(result.journal_torque[journal], expected, rtol=0, atol=1e-12 * peak)
        assert result.largest_journal_torque[journal] == pytest.approx(np.max(np.abs(between)), rel=1e-10)
    assert np.all(result.journal_torque[0] == 0.0)
    np.testing.assert_array_equal(result.shaft_torque[0], result.machine_torque)


def test_orders_of_the_pistons_inertia():
    """D_k sin kφ with the exact D_k at λ = 5/18 by quadrature in 30 digits; no sine of a star that closes."""
    result = inertia(0)
    peak = 0.6 * 0.05**2 * SPEED**2
    for order in (1, 2, 3, 4):
        with mpmath.workdps(30):
            sine = mpmath.quad(
                lambda x, k=order: piston_torque(x, mpmath.sin, mpmath.cos, mpmath.sqrt) * mpmath.sin(k * x),
                mpmath.linspace(0, 2 * mpmath.pi, 9),
            )
            expected = float(sine / mpmath.pi)
        assert result.torque_order_amplitude[order - 1] == pytest.approx(abs(expected), abs=1e-13 * peak)
        assert result.torque_order_phase[order - 1] == pytest.approx(90 * np.sign(expected), abs=1e-7)
    assert np.max(inertia(0, 120, 240).torque_order_amplitude[[0, 1, 3, 4]]) < 1e-12 * peak


def test_answers_name_no_rounding_and_the_first_of_equals():
    """Of four even throws the rest are rounding; every crank pin has the same load."""
    result = inertia(0, 90, 180, 270, shaft=throws(0, 90, 180, 270, speed="300 rad/s"))
    assert re.fullmatch(r"4: [1-9]\d\.\d\d N·m", line_of(result, "Torque", "largest orders"))
    assert re.fullmatch(r"\d\.\d+ kN at 0\.0°, rod of 1", line_of(result, "Largest forces", "on a crank pin"))


def test_an_order_that_is_rounding_has_no_phase():
    result = inertia(0, 90, 180, 270, shaft=throws(0, 90, 180, 270, speed="300 rad/s"))
    order = np.arange(1, len(result.torque_order_phase) + 1)
    assert np.all(np.isnan(result.torque_order_phase[order % 4 > 0]))
    assert np.all(np.isfinite(result.torque_order_phase[[3, 7, 11]]))


def test_orders_do_not_depend_on_the_steps_of_the_curves():
    tables = {"shaft": throws(0, speed="900 rpm"), "bank": {"A": {"mechanism": slider()}}, "masses": PISTON}
    fine, coarse = (ct.run(ct.Machine(**tables), step_degrees=step) for step in (1, 30))
    assert len(coarse.crank_angle) == 12
    np.testing.assert_array_equal(coarse.torque_order_amplitude, fine.torque_order_amplitude)


def test_shafts_that_turn_against_each_other():
    """Both cylinders see the same motion: the shafts' torques are alike, each in its own sense."""
    bank = {
        "exhaust": {"mechanism": slider()},
        "scavenge": {"mechanism": slider(), "shaft": "upper"},
        "lead": "0 deg",
    }
    result = ct.run(
        ct.Machine(
            shaft={"main": {"speed": f"{SPEED!r} rad/s"}, "upper": {"ratio": -1}}, bank={"A": bank}, masses=PISTON
        )
    )
    assert result.labels["journal"] == ("main.1", "main.2", "upper.1", "upper.2")
    peak = np.max(result.shaft_torque)
    np.testing.assert_allclose(result.shaft_torque[0], result.shaft_torque[1], rtol=0, atol=1e-12 * peak)
    np.testing.assert_allclose(result.gear_torque[1], result.machine_torque / 2, rtol=0, atol=1e-12 * peak)
    assert np.isnan(result.gear_reversals[0])
    assert result.gear_reversals[1] == 4
    # Inertia does no work: nobody has a share in it.
    assert np.all(np.isnan(result.work_share))
    passed = np.max(result.machine_torque) / 2
    said = f"−{passed:.2f} to {passed:.2f} N·m, reversing 4 times a cycle"
    assert line_of(result, "Torque", "gear from upper") == said
    assert "of the work" not in result.summary()


def test_a_rocker_has_torque_without_gas():
    result = ct.run(
        ct.Machine(
            mechanism=ROCKER,
            shaft={"main": {"speed": "60 rpm"}},
            masses={"rocker": {"mass": "5 kg", "along": "100 mm", "inertia": "0.1 kg·m²"}},
        )
    )
    np.testing.assert_array_equal(result.machine_torque, -result.driving_torque)
    assert "gear_torque" not in result.catalogue
    assert result.crankpin_load_radial.shape == (1, 360)


@pytest.mark.parametrize(
    ("curve", "expected"),
    [
        ([1.0, 2.0, 1.0], 0),
        ([1.0, -1.0, 1.0, -1.0], 4),
        ([1.0, 0.0, -1.0, 0.0], 2),
        ([1.0, 0.0, 1.0, 0.0], 0),
        ([0.0, 1.0, 0.0, -1.0], 2),
        ([0.0, 0.0], 0),
        ([1.0, -1e-14, 1.0, 2.0], 0),
        ([1.0, np.nan, -1.0, -1.0], 2),
    ],
)
def test_reversals(curve, expected):
    assert reversals(np.array(curve)) == expected
