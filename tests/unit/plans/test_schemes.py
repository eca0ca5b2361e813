"""Schemes with the sources' letters: angles, lengths and forces are the results' and the sources' own formulas."""

import numpy as np
import pytest

import cranktrain as ct
from cranktrain.errors import InputError
from cranktrain.panels.formulas import mathematics
from cranktrain.plans.schemes import scheme

FOUR_BAR = {
    "kind": "crank_rocker",
    "crank_radius": "50 mm",
    "rod_length": "120 mm",
    "rocker_length": "100 mm",
    "ground_length": "140 mm",
}


def values(found):
    return {one.letter: one.value for one in (*found.angles, *found.lengths, *found.forces)}


def drawn(found):
    """Angles as drawn, in the sense from their first direction to their second. [rad]"""
    return {one.letter: (one.end - one.start) for one in found.angles}


@pytest.mark.parametrize("rotation", ["clockwise", "anticlockwise"])
@pytest.mark.parametrize("angle", [20, 50, 200])
def test_crank_rocker_has_the_letters_of_figure_1(rotation, angle):
    machine = ct.Machine(rotation=rotation, mechanism=FOUR_BAR)
    result = ct.run(machine)
    found = scheme(machine, angle)
    assert (found.source, found.figure) == ("gandzha", "1")
    assert dict(found.letters) == {"O": "O", "A": "B", "B": "A", "C": "O_1"}
    marks = values(found)
    alpha, beta, rocker = (marks[letter] for letter in ("α", "β", "α_1"))
    assert np.degrees(alpha) == pytest.approx(angle)
    assert np.cos(beta - result.coupler_angle[0, angle]) == pytest.approx(1.0, abs=1e-12)
    assert np.cos(rocker - result.rocker_angle[0, angle]) == pytest.approx(1.0, abs=1e-12)
    swing = result.largest_rocker_angle[0] - result.smallest_rocker_angle[0]
    assert marks["γ"] == pytest.approx(swing, rel=1e-9)
    assert (marks["r"], marks["r_1"]) == pytest.approx((0.05, 0.1))
    # power of T at the crank and of Q at the rocker, (5)-(9): T r = Q r₁ ω₁/ω
    ratio = result.rocker_velocity_coefficient[0, angle]
    assert marks["T"] == pytest.approx(abs(0.1 / 0.05 * ratio), rel=1e-9)
    sense = -1.0 if rotation == "clockwise" else 1.0
    for letter, shown in drawn(found).items():
        assert shown == pytest.approx(sense * marks[letter], rel=1e-12)


def test_instant_centre_lies_on_the_lines_of_crank_and_rocker():
    found = scheme(ct.Machine(mechanism=FOUR_BAR), 50.0)
    pins = {name: pin[:, 0] for name, pin in found.drawing.positions.items()}
    for start, end in (("O", "A"), ("C", "B")):
        one, other = pins[end] - pins[start], found.points["C"] - pins[start]
        assert one[0] * other[1] - one[1] * other[0] == pytest.approx(0.0, abs=1e-15)


def test_articulated_rod_has_the_letters_of_figure_1_4():
    machine = ct.load("3d12")
    found = scheme(machine, 50.0)
    marks = values(found)
    assert (found.source, found.figure) == ("bolotin", "1.4")
    assert marks["γ"] == pytest.approx(np.radians(60.0))
    assert marks["ψ"] == pytest.approx(marks["ζ"] - marks["γ"])
    assert np.sin(marks["β"]) == pytest.approx(marks["R"] / marks["L"] * np.sin(marks["α"]))
    assert np.degrees(marks["α"]) == pytest.approx(50.0)
    pins = {name: pin[:, 0] for name, pin in found.drawing.positions.items()}
    (zeta,) = (one for one in found.angles if one.letter == "ζ")
    for direction, end in ((zeta.start, "B"), (zeta.end, "C")):
        arm = pins[end] - pins["A"]
        np.testing.assert_allclose(arm / np.hypot(*arm), [np.cos(direction), np.sin(direction)], atol=1e-12)
    (beta,) = (one for one in found.angles if one.letter == "β")
    assert np.cos(beta.end - beta.start) == pytest.approx(np.cos(beta.value), rel=1e-12)


@pytest.mark.parametrize(("name", "lead"), [("jumo_205", 11.0), ("10d100", 12.0)])
def test_opposed_pistons_have_the_letters_of_figure_1_3(name, lead):
    found = scheme(ct.load(name), 50.0)
    marks = values(found)
    assert (found.source, found.figure) == ("bolotin", "1.3")
    assert np.degrees(marks["Δ"]) == pytest.approx(lead, abs=1e-9)
    assert set(found.letters.values()) == {"O_в", "A_в", "B_в", "O_п", "A_п", "B_п"}
    assert {one.letter: one.words for one in found.lengths}["L_п"] == "scavenge rod"
    assert mathematics("R_в") != "R_в"  # is set as mathematics, with an index
    assert marks["α"] - marks["α − Δ"] == pytest.approx(marks["Δ"], abs=1e-9)
    pins = {pin: place[:, 0] for pin, place in found.drawing.positions.items()}
    for one in found.angles:  # α and α − Δ end at their cranks
        if one.letter != "Δ":
            number = "" if np.allclose(one.vertex, 0.0) else "2"
            arm = pins[f"A{number}"] - pins[f"O{number}"]
            np.testing.assert_allclose(arm / np.hypot(*arm), [np.cos(one.end), np.sin(one.end)], atol=1e-9)


@pytest.mark.parametrize("far", ["exhaust", "scavenge"])
def test_opposed_pistons_on_one_shaft_have_the_letters_of_figure_1_3(far):
    """One shaft O; the far piston's crank counts from where it points away from the cylinder. By hand at φ = 50°."""
    bank = {
        end: {
            "throws": [place],
            "side_rods": end == far,
            "mechanism": {"kind": "slider_crank", "crank_radius": f"{radius} mm", "rod_length": f"{rod} mm"},
        }
        for place, (end, radius, rod) in enumerate((("exhaust", 450, 1800), ("scavenge", 350, 3000)), 1)
    }
    machine = ct.Machine(
        shaft={"main": {"throws": ["0 deg", "170 deg"]}}, bank={"A": bank}, cylinder={"cycle": "two-stroke"}
    )
    found = scheme(machine, 50.0)
    marks = values(found)
    assert (found.source, found.figure) == ("bolotin", "1.3")
    assert set(found.letters.values()) == {"O", "A_в", "B_в", "A_п", "B_п"}
    own = 50.0 if far == "scavenge" else 230.0
    assert np.degrees(marks["α"]) == pytest.approx(own, abs=1e-9)
    assert np.degrees(marks["Δ"]) == pytest.approx(10.0, abs=1e-9)
    assert np.degrees(marks["α − Δ"]) == pytest.approx(own - 10.0, abs=1e-9)
    assert (marks["R_п"], marks["L_п"]) == pytest.approx((0.35, 3.0), rel=1e-12)
    pins = {pin: place[:, 0] for pin, place in found.drawing.positions.items()}
    for letter, pin in (("α", "A"), ("α − Δ", "A2")):
        (one,) = (one for one in found.angles if one.letter == letter)
        arm = pins[pin] / np.hypot(*pins[pin])
        np.testing.assert_allclose(arm, [np.cos(one.end), np.sin(one.end)], atol=1e-9)


def test_a_source_without_such_a_figure_is_refused():
    with pytest.raises(InputError, match="has no figure of such a mechanism"):
        scheme(ct.load("3d12"), letters="gandzha")
    with pytest.raises(InputError, match="must be one of: bolotin, gandzha, steam-engine"):
        scheme(ct.load("3d12"), letters="newton")
    with pytest.raises(InputError, match="no source has a figure"):
        scheme(ct.load("toggle_press"))
