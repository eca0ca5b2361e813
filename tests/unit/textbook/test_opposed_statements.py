"""(I.11), (I.12) of a machine, on two shafts or on one: against 40 digits, and against what `run` says."""

import mpmath as mp
import numpy as np
import pytest

import cranktrain as ct
from cranktrain.errors import InputError
from cranktrain.textbook.opposed_statements import opposed_cylinders

NEAR, FAR = ("0.45", "1.8"), ("0.35", "3.0")
"""Crank radius and rod. [m]"""


def engine(far="scavenge", throw="170 deg", sizes=(NEAR, FAR), **changes):
    """One shaft with two throws, one of both pistons on side rods."""
    bank = {
        end: {
            "throws": [place],
            "side_rods": end == far,
            "mechanism": {"kind": "slider_crank", "crank_radius": f"{radius} m", "rod_length": f"{rod} m"},
        }
        for place, (end, (radius, rod)) in enumerate(zip(("exhaust", "scavenge"), sizes, strict=True), 1)
    }
    return ct.Machine(
        shaft={"main": {"throws": ["0 deg", throw], "speed": "300 rpm"}},
        bank={"A": bank},
        cylinder={"bore": "600 mm", "cycle": "two-stroke"},
        **changes,
    )


def travel(theta, size, is_far):
    """Exact, outward from the inner dead centre."""
    radius, rod = map(mp.mpf, size)
    bent = rod - mp.sqrt(rod**2 - (radius * mp.sin(theta)) ** 2)
    return radius * (1 - mp.cos(theta)) + (-bent if is_far else bent)


def by_text(theta, size, is_far):
    radius, rod = map(mp.mpf, size)
    ratio = -radius / rod if is_far else radius / rod
    return radius * (1 + ratio / 4 - mp.cos(theta) - ratio / 4 * mp.cos(2 * theta))


def motions(alpha, far, form, lead):
    ends = ((NEAR, "exhaust", alpha), (FAR, "scavenge", alpha - lead))
    exhaust, scavenge = (form(theta, size, end == far) for size, end, theta in ends)
    return exhaust, scavenge, exhaust + scavenge


def value(found, equation, symbol, at, name=None):
    (one,) = (
        one
        for one in found
        if (one.equation, one.symbol, one.at) == (equation, symbol, at) and name in (None, one.name)
    )
    return one


@pytest.mark.parametrize("far", ["scavenge", "exhaust"])
def test_volumetric_dead_centres_of_one_shaft(far):
    """Roots of the sum's derivative in 40 digits; what `run` says; to first order; half the lead."""
    machine = engine(far)
    found, result = ct.textbook.opposed(machine), ct.run(machine)
    (lead,) = (one for one in found if one.symbol == "Δ")
    assert np.degrees(lead.value) == pytest.approx(10.0, abs=1e-9)
    assert result.lead[0] == pytest.approx(10.0, abs=1e-9)
    with mp.workdps(40):
        turn = mp.radians(10)

        def both(alpha):
            return motions(alpha, far, travel, turn)[2]

        roots = [mp.findroot(lambda a: mp.diff(both, a), start) for start in (turn / 2, mp.pi + turn / 2)]
        stroke = both(roots[1]) - both(roots[0])
    ratios = [mp.mpf(radius) / mp.mpf(rod) * (-1 if end == far else 1)
              for end, (radius, rod) in (("exhaust", NEAR), ("scavenge", FAR))]  # fmt: skip
    for at, sign, root, shift in zip(
        ("inner", "outer"),
        (1, -1),
        roots,
        (result.inner_volumetric_shift[0], result.outer_volumetric_shift[0] + 180.0),
        strict=True,
    ):
        half, better = value(found, "", "Δ/2", at), value(found, "", "Δ·w_s/(w_e + w_s)", at)
        assert half.exact == better.exact == pytest.approx(float(root), abs=1e-10)
        assert np.degrees(half.exact) == pytest.approx(shift, abs=1e-12)
        assert half.value == pytest.approx(np.radians(5.0 + (180.0 if at == "outer" else 0.0)), abs=1e-9)
        w_e, w_s = (
            float(mp.mpf(size[0]) * (1 + sign * ratio)) for size, ratio in zip((NEAR, FAR), ratios, strict=True)
        )
        first = np.radians(10.0) * w_s / (w_e + w_s) + (np.pi if at == "outer" else 0.0)
        assert better.value == pytest.approx(first, abs=1e-9)
        assert abs(better.error) < abs(half.error)
    assert value(found, "(I.11) (I.12)", "S_Σ", "").exact == pytest.approx(float(stroke), rel=1e-13)


def test_inner_dead_centre_of_the_reported_engine():
    half = value(ct.textbook.opposed(engine()), "", "Δ/2", "inner")
    assert round(np.degrees(half.exact), 2) == 3.55


@pytest.mark.parametrize("running", ["ahead", "astern"])
@pytest.mark.parametrize("far", ["scavenge", "exhaust"])
def test_largest_errors_and_curves_of_one_shaft(far, running):
    found = ct.textbook.opposed(engine(far, running=running))
    names = ("exhaust", "scavenge", "both")
    with mp.workdps(20):
        lead = mp.radians(10 if running == "ahead" else -10)
        angles = [mp.pi * step / 360 for step in range(720)]
        exact = list(zip(*(motions(angle, far, travel, lead) for angle in angles), strict=True))
        form = list(zip(*(motions(angle, far, by_text, lead) for angle in angles), strict=True))
    for part, (equation, name) in enumerate(zip(("(I.11)", "(I.12)", "(I.11) (I.12)"), names, strict=True)):
        true, own = (np.array([float(one) for one in curve[part]]) for curve in (exact, form))
        share = np.max(np.abs(own - true)) / np.ptp(true)
        error = value(found, equation, "Δx", "largest", name)
        assert error.exact == 0.0
        assert error.value == pytest.approx(share, rel=2e-4)
        (curve,) = (one for one in found.over_turn if (one.equation, one.symbol) == (equation, "S"))
        np.testing.assert_allclose(curve.values[:-1], own[::2], rtol=0, atol=1e-9)
        np.testing.assert_allclose(curve.exact[:-1], true[::2], rtol=0, atol=1e-9)


def test_with_the_printed_sign_the_far_piston_is_off_by_twice_its_rods_term():
    """At θ = 90°: the exact L − √(L² − R²) and λR/2 add up."""
    found = ct.textbook.opposed(engine())
    error = value(found, "(I.12)", "Δx", "largest", "scavenge, λ as printed")
    by_hand = (3.0 - np.sqrt(9.0 - 0.35**2) + 0.35**2 / 6.0) / 0.7
    assert error.verdict == "out of range"
    assert error.value == pytest.approx(by_hand, rel=1e-9)
    assert not [one for one in found if one.name == "exhaust, λ as printed"]


@pytest.mark.parametrize("far", ["scavenge", "exhaust"])
def test_exact_travel_is_that_of_a_run(far):
    machine = engine(far)
    found, result = ct.textbook.opposed(machine), ct.run(machine)
    both = next(one.exact for one in found.over_turn if (one.equation, one.symbol) == ("(I.11) (I.12)", "S"))
    start = 180.0 if far == "exhaust" else 0.0
    at = np.searchsorted(result.crank_angle, (found.crank_angle[:-1] + start) % 360.0)
    wanted = result.combined_displacement[0, at] + result.least_combined_travel[0]
    np.testing.assert_allclose(both[:-1], wanted, rtol=0, atol=1e-10)


def test_equal_cranks_and_rods_of_one_shaft_are_not_alike():
    """The rods' terms do not cancel where one piston is on side rods: half the lead is no dead centre."""
    (one,) = opposed_cylinders(engine(sizes=(NEAR, NEAR)).places)
    assert not one.pair.is_alike
    found = ct.textbook.opposed(engine(sizes=(NEAR, NEAR)))
    assert value(found, "", "Δ/2", "inner").verdict == "printed"
    assert np.degrees(abs(value(found, "", "Δ/2", "inner").error)) > 1.0


def test_two_shafts_with_equal_rods_are_as_the_text_has_them():
    found = ct.textbook.opposed("10d100")
    assert {one.verdict for one in found if one.symbol == "Δ/2"} == {"right"}
    (stroke,) = (one for one in found if one.symbol == "4R cos(Δ/2)")
    assert stroke.value == pytest.approx(4 * 0.127 * np.cos(np.radians(6.0)), rel=1e-13)
    assert stroke.value == pytest.approx(stroke.exact, rel=1e-13)
    assert {one.symbol for one in found if one.equation == "fig. 1.3"} == {f"{a}_{b}" for a in "RLλ" for b in "вп"}


def test_the_deltic_has_both_schemes():
    (said,) = (" ".join(notes) for subject, notes in ct.textbook.opposed("deltic").notes.items() if "I.11" in subject)
    assert "1A–6A: fig. 1.3 а: two shafts that turn alike." in said
    assert "1B–6B, 1C–6C: fig. 1.3 б: two shafts that turn against each other." in said


def test_what_has_no_opposed_pistons_is_refused():
    with pytest.raises(InputError, match="must have cylinders with two opposed pistons"):
        ct.textbook.opposed("3d12")
    with pytest.raises(InputError, match="leed"):
        ct.textbook.opposed("10d100", set={"bank.A.leed": "12 deg"})


def test_data_frames():
    found = ct.textbook.opposed("10d100")
    assert len(found.frame) == len(found.each)
    assert found.curve_frame.shape == (361, 2 * len(found.over_turn))
