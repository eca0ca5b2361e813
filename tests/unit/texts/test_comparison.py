"""Textbook forms beside the exact motion: the digest's table of errors, where they are, and what is out of range."""

import copy
import re

import numpy as np
import pytest
from tests.machines import RADIUS, ROCKER, V12, banks, slider, slider_position, throws
from tests.told import texts_of

import cranktrain as ct

FORMS = ("exact", "infinite_rod", "two_harmonics", "brix", "derived", "reconstructed")
LARGEST_ERRORS = {
    0.10: (6.3e-5, 2.7e-4, 2.51e-2, 1.6e-4, 4.6e-4),
    0.20: (5.1e-4, 1.23e-3, 5.05e-2, 1.30e-3, 3.4e-3),
    0.25: (1.01e-3, 2.04e-3, 6.35e-2, 2.55e-3, 6.6e-3),
    0.30: (1.77e-3, 3.14e-3, 7.68e-2, 4.42e-3, 1.11e-2),
}
"""By λ: displacement by (333), by Brix, by (334); velocity by (336); acceleration by (337). Printed to these digits."""


def run(**table):
    return ct.run(ct.Machine(mechanism={"kind": "slider_crank", "crank_radius": "50 mm", **table}, shaft=throws(0)))


def of(values, method):
    """One method's values; the last axis is the piston's, or the curve's of one piston."""
    return values[FORMS.index(method)]


def to_printed_digits(printed):
    """Half a unit of the last of the digits that are printed, which are two or three."""
    mantissa, exponent = f"{printed:.2e}".split("e")
    digits = 1 if mantissa.endswith("0") else 2
    return 0.5 * 10.0 ** (int(exponent) - digits)


@pytest.mark.parametrize("ratio", LARGEST_ERRORS)
def test_table_of_errors(ratio):
    result = run(crank_to_rod_ratio=ratio)
    found = (
        of(result.displacement_error, "two_harmonics"),
        of(result.displacement_error, "brix"),
        of(result.displacement_error, "infinite_rod"),
        of(result.velocity_error, "two_harmonics"),
        of(result.acceleration_error, "two_harmonics"),
    )
    for error, printed in zip(found, LARGEST_ERRORS[ratio], strict=True):
        assert error[0] == pytest.approx(printed, abs=to_printed_digits(printed))


def test_curves_by_each_method():
    """(333), (334), (336), (337) and Brix's construction as the digest writes them."""
    result = run(crank_to_rod_ratio=0.25)
    phi, rod = np.radians(result.crank_angle), RADIUS / 0.25
    displacement, velocity, acceleration = (
        getattr(result, f"{name}_by_method")[:, 0]
        for name in ("displacement", "velocity_coefficient", "acceleration_coefficient")
    )
    exact = RADIUS + rod - slider_position(phi, rod=rod)
    np.testing.assert_allclose(of(displacement, "exact"), exact, atol=1e-15)
    np.testing.assert_allclose(of(displacement, "infinite_rod"), RADIUS * (1 - np.cos(phi)), atol=1e-16)
    two = RADIUS * (1 - np.cos(phi) + 0.125 * np.sin(phi) ** 2)
    np.testing.assert_allclose(of(displacement, "two_harmonics"), two, atol=1e-16)
    brix = RADIUS * (1 - np.cos(phi + np.arcsin(0.125 * np.sin(phi))))
    np.testing.assert_allclose(of(displacement, "brix"), brix, atol=1e-16)
    second = RADIUS * (np.sin(phi) + 0.125 * np.sin(2 * phi))
    np.testing.assert_allclose(of(velocity, "two_harmonics"), second, atol=1e-16)
    third = RADIUS * (np.cos(phi) + 0.25 * np.cos(2 * phi))
    np.testing.assert_allclose(of(acceleration, "two_harmonics"), third, atol=1e-16)
    assert np.isnan(of(displacement, "derived")).all()


def test_places_of_the_errors():
    """(334) is farthest off across the line of stroke, where the rod's foot lies L − √(L² − R²) behind the pin's."""
    result = run(crank_to_rod_ratio=0.2)
    assert np.mod(of(result.displacement_error_at, "infinite_rod")[0], 180) == pytest.approx(90, abs=1e-6)
    rod = RADIUS / 0.2
    by_hand = (rod - np.sqrt(rod**2 - RADIUS**2)) / (2 * RADIUS)
    assert of(result.displacement_error, "infinite_rod")[0] == pytest.approx(by_hand, rel=1e-13)


@pytest.mark.parametrize("offset", ["0 mm", "8 mm"])
def test_errors_bound_the_difference_of_the_curves(offset):
    """On any grid the difference is less than the refined error, and on a fine one hardly less."""
    machine = ct.Machine(mechanism=slider(offset=offset))
    result = ct.run(machine, step_degrees=0.05)
    exact = result.displacement_by_method[0, 0]
    for method in ("infinite_rod", "two_harmonics", "brix"):
        error = np.max(np.abs(of(result.displacement_by_method, method)[0] - exact)) / result.stroke[0]
        refined = of(result.displacement_error, method)[0]
        assert error <= refined * (1 + 1e-12)
        assert error == pytest.approx(refined, rel=1e-5)


def test_articulated_rods():
    """Every slave of the V12 has the same errors, those of any grid bounded by them; masters have no such form."""
    result = ct.run(ct.Machine(**V12), step_degrees=0.25)
    for method in ("derived", "reconstructed"):
        errors = of(result.displacement_error, method)
        assert np.isnan(errors[:6]).all()
        np.testing.assert_array_equal(errors[6:], errors[6])
        difference = of(result.displacement_by_method, method)[6:] - of(result.displacement_by_method, "exact")[6:]
        largest = np.max(np.abs(difference), axis=-1) / result.stroke[6:]
        assert np.all(largest <= errors[6:] * (1 + 1e-12))
        np.testing.assert_allclose(largest, errors[6:], rtol=1e-4)
        at = of(result.displacement_error_at, method)[6:]
        np.testing.assert_allclose(
            np.mod(at - result.top_dead_centre[6:], 360), np.mod(at - result.top_dead_centre[6:], 360)[0]
        )
    # The digest, on real proportions: 0.15 to 0.41 % of the stroke, velocity 0.4 to 1.1 %, acceleration 0.9 to 2.8 %.
    assert 0.0015 < of(result.displacement_error, "reconstructed")[6] < 0.0041
    assert 0.004 < of(result.velocity_error, "reconstructed")[6] < 0.011
    assert 0.009 < of(result.acceleration_error, "reconstructed")[6] < 0.028


def test_exact_has_no_error():
    result = ct.run(ct.Machine(**V12))
    for name in ("displacement_error", "velocity_error", "acceleration_error"):
        assert np.all(of(getattr(result, name), "exact") == 0)
        assert np.all(np.isnan(of(getattr(result, f"{name}_at"), "exact")))
    np.testing.assert_array_equal(of(result.displacement_by_method, "exact"), result.piston_displacement)
    assert result.labels["motion_method"] == FORMS


def methods_flagged(result):
    return {re.split(r" \(| fig", flag)[0] for flag in texts_of(result.flags)}


@pytest.mark.parametrize(
    ("table", "flagged"),
    [
        ({"crank_to_rod_ratio": 0.09}, set()),
        ({"crank_to_rod_ratio": 0.1}, {"infinitely long rod"}),
        ({"crank_to_rod_ratio": 0.3}, {"infinitely long rod"}),
        ({"crank_to_rod_ratio": 0.31}, {"infinitely long rod", "two harmonics", "Brix's construction"}),
        (
            {"crank_to_rod_ratio": 0.05, "offset": "1 mm"},
            {"infinitely long rod", "two harmonics", "Brix's construction"},
        ),
    ],
)
def test_flags_outside_a_range(table, flagged):
    assert methods_flagged(run(**table)) == flagged


def test_flags_name_pistons_source_and_condition():
    bank = banks(A=0)
    bank["B"] = {"angle": "60 deg", "mechanism": slider(rod_length="160 mm")}
    result = ct.run(ct.Machine(shaft=throws(0, 90, 180), bank=bank))
    (flag,) = [flag for flag in texts_of(result.flags) if flag.startswith("two harmonics")]
    assert flag == (
        "two harmonics (333), (336), (337) is outside its source's range (central mechanism, λ ≤ 0.3) "
        "for 1B–3B, as λ = 0.3125 [steam-engine]"
    )


def test_the_usual_forms_of_a_v12_miss_a_little_of_the_stroke():
    """0.14 % by two harmonics, (333) to (337); 0.37 % by (I.13), reconstructed."""
    error = ct.run(ct.Machine(**V12)).displacement_error
    assert np.nanmax(of(error, "two_harmonics")) == pytest.approx(0.0014, abs=5e-5)
    assert np.nanmax(of(error, "reconstructed")) == pytest.approx(0.0037, abs=5e-5)


def test_slave_jointed_on_the_crank_pin():
    """With no knuckle radius and the master's rod length, (I.13) derived anew is (333), with the same errors."""
    data = copy.deepcopy(V12)
    data["bank"]["R"]["mechanism"] |= {"knuckle_radius": "0 mm", "rod_length": "320 mm"}
    result = ct.run(ct.Machine(**data))
    for name in ("displacement_error", "velocity_error", "acceleration_error"):
        plain = of(getattr(result, name), "two_harmonics")[0]
        np.testing.assert_allclose(of(getattr(result, name), "derived")[6:], plain, rtol=1e-9)


def test_a_machine_without_pistons_has_no_textbook():
    assert "displacement_error" not in ct.run(ct.Machine(mechanism=ROCKER)).catalogue
