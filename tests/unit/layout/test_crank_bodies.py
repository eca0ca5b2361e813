"""Whose the body of a throw is, whichever bank says it; and rods that share a pin."""

import numpy as np
import pytest
from tests.contract.test_every_mass_counts import CRANK, vee

import cranktrain as ct

SECTIONS = {
    "journal_diameter": "60 mm",
    "pin_diameter": "52 mm",
    "pin_length": "50 mm",
    "web_thickness": "20 mm",
    "web_width": "90 mm",
}
PLAIN = {"kind": "slider_crank", "crank_radius": "45 mm", "rod_length": "150 mm"}
ECCENTRIC = {"kind": "eccentric", "eccentricity": "20 mm", "rod_length": "150 mm", "angle_ahead": "120 deg"}


def inertia(machine):
    """Of everything, at each angle of a turn."""
    return ct.run(machine, step_degrees=30, quantities=["reduced_inertia"]).reduced_inertia


@pytest.mark.parametrize("where", ["masses", "left", "right"])
def test_load_of_the_bearings(where):
    """Half of m r ω² goes to either side of each throw, and both throws pull apart in the middle bearing."""
    machine = vee(**{where: {"crank": CRANK}}, crankshaft=SECTIONS)
    result = ct.run(machine, step_degrees=5, quantities=["largest_bearing_load"])
    found = np.asarray(result.largest_bearing_load)[result.labels["bearing_method"].index("split")]
    half = 0.5 * 2 * 0.045 * (100 * np.pi) ** 2
    np.testing.assert_allclose(found, [half, 0, half], rtol=1e-12, atol=1e-10 * half)


@pytest.mark.parametrize("where", ["left", "right"])
def test_a_bank_replaces_the_default(where):
    """J + m r² of both throws, whatever the default says."""
    found = inertia(vee(masses={"crank": {**CRANK, "mass": "7 kg"}}, **{where: {"crank": CRANK}}))
    np.testing.assert_allclose(found, 2 * (0.004 + 2 * 0.045**2), rtol=1e-12)


def test_a_bank_speaks_of_its_own_throws():
    machine = vee(masses={"crank": {**CRANK, "mass": "7 kg"}}, right={"crank": CRANK})
    found = inertia(machine.with_({"bank.R.throws": [2]}))
    np.testing.assert_allclose(found, 2 * 0.004 + (7 + 2) * 0.045**2, rtol=1e-12)


def test_two_bodies_of_one_throw():
    with pytest.raises(ct.InputError) as caught:
        inertia(vee(left={"crank": CRANK}, right={"crank": {**CRANK, "mass": "2.1 kg"}}))
    (problem,) = caught.value.problems
    assert problem.path == "bank.R.masses.crank"
    assert "bank.L.masses.crank" in str(problem.allowed)


def test_one_body_in_two_wordings():
    found = inertia(vee(left={"crank": CRANK}, right={"crank": {**CRANK, "mass": "2000 g", "along": "4.5 cm"}}))
    np.testing.assert_allclose(found, 2 * (0.004 + 2 * 0.045**2), rtol=1e-12)


def test_an_eccentric_has_a_body_of_its_own():
    """Its sheave counts where it stands, and the throw's body with the throw; the default is the throw's."""
    sheave = {"mass": "3 kg", "along": "20 mm", "inertia": "0.002 kg·m²"}
    banks = {"A": {"mechanism": PLAIN}, "V": {"mechanism": ECCENTRIC, "masses": {"crank": sheave}}}
    for order in ("AV", "VA"):
        machine = ct.Machine(
            shaft={"main": {"speed": "300 rpm"}}, bank={name: banks[name] for name in order}, masses={"crank": CRANK}
        )
        np.testing.assert_allclose(inertia(machine), 0.006 + 2 * 0.045**2 + 3 * 0.02**2, rtol=1e-12)


def moved(**tables):
    """How a machine moves, or what is wrong with it."""
    return ct.run(ct.Machine(**tables), step_degrees=30, quantities=["rod_angle"])


class TestRodsOnOnePin:
    """One pin has one radius; far pistons of a cylinder, and eccentrics, have pins of their own."""

    @pytest.mark.parametrize("given", [{"crank_radius": "46 mm"}, {"stroke": "92 mm"}])
    def test_two_radii(self, given):
        other = {**PLAIN, **given}
        if "stroke" in given:
            del other["crank_radius"]
        with pytest.raises(ct.InputError) as caught:
            moved(shaft={"main": {"speed": "1 rpm"}}, bank={"L": {"mechanism": PLAIN}, "R": {"mechanism": other}})
        (problem,) = caught.value.problems
        assert problem.path == f"bank.R.mechanism.{next(iter(given))}"
        assert "bank.L.mechanism.crank_radius" in str(problem.allowed)

    def test_two_wordings_of_one_radius(self):
        other = {"kind": "slider_crank", "stroke": "90 mm", "rod_length": "150 mm"}
        moved(shaft={"main": {"speed": "1 rpm"}}, bank={"L": {"mechanism": PLAIN}, "R": {"mechanism": other}})

    def test_two_throws_at_one_place(self):
        """What the message says helps."""
        shaft = {"main": {"throws": ["0 deg", "0 deg"], "spacing": ["0 mm"], "speed": "1 rpm"}}
        other = {**PLAIN, "crank_radius": "46 mm"}
        banks = {"L": {"mechanism": PLAIN, "throws": [1]}, "R": {"mechanism": other, "throws": [2]}}
        moved(shaft=shaft, bank=banks)

    def test_opposed_pistons_on_one_shaft(self):
        other = {**PLAIN, "crank_radius": "30 mm"}
        shaft = {"main": {"throws": ["0 deg", "180 deg"], "speed": "1 rpm"}}
        pair = {"exhaust": {"mechanism": PLAIN, "throws": [1]}}
        pair |= {"scavenge": {"mechanism": other, "throws": [2], "side_rods": True}}
        moved(shaft=shaft, bank={"A": pair}, cylinder={"bore": "80 mm"})
