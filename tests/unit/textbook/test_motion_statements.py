"""`ct.textbook.motion`: whose statements there are, their verdicts, curves and refusals."""

import numpy as np
import pytest
from tests.machines import ROCKER, V12, slider

import cranktrain as ct


def test_slaves_have_both_forms_of_i13_and_masters_those_of_the_steam_engine():
    """Errors are those of the run, whose angles count from where the crank points along the slave's cylinder."""
    found = ct.textbook.motion(V12)
    result = ct.run(V12)
    slaves = [one for one in found if one.source == "bolotin"]
    assert [one.symbol for one in slaves] == ["Δx", "Δv", "Δj"] * 2
    assert {one.of for one in slaves} == {"1R–6R"}
    assert {one.verdict for one in slaves} == {"approximate"}
    row = result.labels["motion_method"].index("derived")
    assert slaves[0].value == result.displacement_error[row, 6]
    assert {one.of for one in found if one.source == "steam-engine"} == {"1L–6L"}


def test_errors_of_slaves_are_where_their_curves_differ_most():
    found = ct.textbook.motion(V12)
    names = {one.name for one in found if one.source == "bolotin"}
    assert len(names) == 2
    for name in names:
        error = next(one for one in found if (one.name, one.symbol) == (name, "Δx"))
        curve = next(one for one in found.over_turn if (one.name, one.symbol) == (name, "S"))
        off = np.abs(curve.values - curve.exact)
        apart = abs(found.crank_angle[np.argmax(off)] - error.crank_angle)
        assert min(apart, 360.0 - apart) < 1.0
        assert np.max(off) / np.ptp(curve.exact) == pytest.approx(error.value, rel=1e-3)


def test_curves_are_the_texts_formulas():
    """R = 50, λ = 0.25: (333), (336) and (337) from both dead centres, and the closed root."""
    found = ct.textbook.motion({"mechanism": slider(rod_length="200 mm")})
    phi, radius, ratio = np.radians(found.crank_angle), 0.05, 0.25
    for sign, name in ((1, "two harmonics"), (-1, "two harmonics from the crank-side dead centre")):
        curves = {one.equation: one.values for one in found.over_turn if one.name == name}
        expected = {
            "(333)": radius * (1 - np.cos(phi) + sign * ratio / 2 * np.sin(phi) ** 2),
            "(336)": radius * (np.sin(phi) + sign * ratio / 2 * np.sin(2 * phi)),
            "(337)": radius * (np.cos(phi) + sign * ratio * np.cos(2 * phi)),
        }
        for equation, values in expected.items():
            np.testing.assert_allclose(curves[equation], values, rtol=0, atol=1e-16)
    root = radius * (1 - np.cos(phi)) + 0.2 * (1 - np.sqrt(1 - (ratio * np.sin(phi)) ** 2))
    curve = next(one for one in found.over_turn if (one.name, one.symbol) == ("exact root", "S"))
    np.testing.assert_allclose(curve.values, root, rtol=0, atol=1e-16)
    np.testing.assert_allclose(curve.exact, root, rtol=0, atol=1e-16)
    assert [one.unit for one in found.over_turn[:3]] == ["m", "m/rad", "m/rad^2"]


def test_an_offset_line_of_stroke_is_out_of_every_range():
    """Z has no exact one beside it; arcs are exact all the same."""
    found = ct.textbook.motion({"mechanism": slider(offset="8 mm")})
    verdicts = {(one.equation, one.name): one.verdict for one in found if one.symbol == "Δx"}
    arcs = verdicts.pop(("fig. 146", "arcs of the rod's length about the piston's pin"))
    assert arcs == "right"
    assert set(verdicts.values()) == {"out of range"}
    (difference,) = found.numbered("335")
    assert np.isnan(difference.exact) and difference.verdict == "out of range"
    root = next(one for one in found if one.name == "exact root")
    assert root.value > 1e-4


def test_the_largest_rods_lose_no_figures():
    """A rod of 1e6 radii: (334) is off by λ/4, (333) by nothing that a double has."""
    found = ct.textbook.motion({"mechanism": slider(crank_radius="50 mm", rod_length="50000 m")})
    by = {one.name: one.value for one in found if one.symbol == "Δx"}
    assert by["infinitely long rod (orthogonal projection of the crank pin)"] == pytest.approx(1e-6 / 4, rel=1e-9)
    assert by["two harmonics"] < 1e-15


def test_pins_of_a_crank_rocker():
    """v_A/v_B by differences of the rocker's angle in a run over 0.2°."""
    found = ct.textbook.motion({"mechanism": ROCKER})
    result = ct.run({"mechanism": ROCKER}, step_degrees=0.1)
    ratio = np.gradient(np.unwrap(result.rocker_angle[0]), np.radians(0.1))
    lengths = {name: float(ROCKER[name].split()[0]) for name in ("crank_radius", "rocker_length")}
    ratio = ratio[2:-2] * lengths["rocker_length"] / lengths["crank_radius"]
    low, high = (one for one in found if one.symbol == "v_A/v_B")
    assert sorted([abs(low.value), abs(high.value)]) == pytest.approx(
        sorted([abs(np.min(ratio)), abs(np.max(ratio))]), rel=1e-5
    )
    assert (low.value, high.value) == pytest.approx((low.exact, high.exact), rel=1e-12)
    (printed,) = found.numbered("13")
    assert (1e3 * printed.value, 1e3 * printed.exact) == pytest.approx(
        (lengths["rocker_length"], lengths["crank_radius"])
    )
    assert {one.verdict for one in found} == {"right", "refuted", "printed"}
    curves = {(one.equation, one.verdict): one for one in found.over_turn}
    np.testing.assert_allclose(curves["(10)", "right"].values, curves["(10)", "right"].exact, rtol=0, atol=1e-12)
    np.testing.assert_allclose(curves["(17)", "right"].values, curves["(10)", "right"].exact ** 2, rtol=0, atol=1e-12)


def test_refused():
    with pytest.raises(ct.InputError, match=r"chain: must have a slider-crank, an eccentric, an articulated rod or"):
        ct.textbook.motion("shaper")
    with pytest.raises(ct.InputError, match="no such file"):
        ct.textbook.motion("no_engine.toml")
    with pytest.raises(ct.InputError, match="rod_length"):
        ct.textbook.motion("great_northern", set={"bank.valve.mechanism.rod_length": "45 kg"})
