"""Shafts by length and diameter: closed forms of two discs, stepped and hollow ones, gaps of their own."""

from math import pi, sqrt

import numpy as np
import pytest
from tests.unit.questions.torsion.test_throw_stiffness import four

import cranktrain as ct

G = 206e9 / 2.6


def two_discs(**shaft):
    """A throw of 2 kg·m² and a flywheel of the same."""
    return ct.Machine(
        mechanism={"kind": "slider_crank", "stroke": "80 mm", "rod_length": "136 mm"},
        torsion={
            "throw_inertia": "2 kg·m²",
            "disc": {"flywheel": {"inertia": "2 kg·m²", "beside": 1, **shaft}},
        },
    )


def frequency(machine):
    return ct.run(machine).natural_frequency


PLAIN = {"length": "400 mm", "diameter": "50 mm"}


def test_a_plain_shaft():
    """ω² = 2k/J with k = πGd⁴/32l."""
    np.testing.assert_allclose(frequency(two_discs(**PLAIN)), [sqrt(pi * G * 0.05**4 / (32 * 0.4))], rtol=1e-13)


def test_metal_and_bore():
    found = frequency(two_discs(**PLAIN, bore="20 mm", shear_modulus="26 GPa"))
    np.testing.assert_allclose(found, [sqrt(pi * 26e9 * (0.05**4 - 0.02**4) / (32 * 0.4))], rtol=1e-13)


def test_a_stepped_shaft():
    """Parts one behind another: their flexibilities add up."""
    stepped = {"length": ["100 mm", "250 mm"], "diameter": ["60 mm", "45 mm"], "bore": ["0 mm", "15 mm"]}
    flexibility = 32 / (pi * G) * (0.1 / 0.06**4 + 0.25 / (0.045**4 - 0.015**4))
    np.testing.assert_allclose(frequency(two_discs(**stepped)), [sqrt(1 / flexibility)], rtol=1e-13)


def test_a_cut_in_words_changes_nothing():
    cut = {"length": ["150 mm", "250 mm"], "diameter": "50 mm", "bore": ["0 mm", "0 mm"]}
    np.testing.assert_allclose(frequency(two_discs(**cut)), frequency(two_discs(**PLAIN)), rtol=1e-14)


def test_a_stiffness_beside_its_sizes():
    """Rounded it counts as given."""
    stiffness = pi * G * 0.05**4 / (32 * 0.4)
    found = frequency(two_discs(**PLAIN, stiffness=f"{stiffness * 1.008:.6g} N·m/rad"))
    np.testing.assert_allclose(found, [sqrt(stiffness * 1.008)], rtol=1e-5)
    with pytest.raises(ct.InputError, match=r"flywheel.stiffness = 1.3e5 N·m/rad: must be that of its length and"):
        two_discs(**PLAIN, stiffness="1.3e5 N·m/rad")


def test_designs():
    machines = [two_discs(length="400 mm", diameter=d) for d in ("50 mm", "42 mm")]
    found = ct.run(machines).natural_frequency
    np.testing.assert_array_equal(found, [frequency(one) for one in machines])


WRONG = {
    "no diameter": ({"length": "400 mm"}, "diameter: is missing; a shaft twists by its length and its diameter"),
    "no length": ({"diameter": "50 mm"}, "length: is missing"),
    "a bore alone": ({"bore": "50 mm"}, "length: is missing"),
    "all bore": ({**PLAIN, "bore": "50 mm"}, "bore = 50 mm: must be less than the diameter, 50 mm"),
    "lists": (
        {"length": ["1 mm", "2 mm", "3 mm"], "diameter": ["1 mm", "2 mm"]},
        "diameter = a list of 2: must be one value, or one for each of 3 parts",
    ),
    "one length of two": (
        {"length": "1 mm", "diameter": ["1 mm", "2 mm"]},
        "length = a list of 1: must be one for each",
    ),
    "none": ({"length": "0 mm", "diameter": "50 mm"}, "length = 0 mm: must be"),
    "a mass": ({"length": "4 kg", "diameter": "50 mm"}, "length = 4 kg: kg measures a mass"),
}


@pytest.mark.parametrize("shaft, wanted", WRONG.values(), ids=WRONG)
def test_refused(shaft, wanted):
    with pytest.raises(ct.InputError) as found:
        two_discs(**shaft)
    assert f"torsion.disc.flywheel.{wanted}" in str(found.value)


def in_line(**torsion):
    return ct.Machine(
        shaft={"main": {"throws": ["0 deg"] * 4}},
        bank={"A": {"mechanism": {"kind": "slider_crank", "stroke": "80 mm", "rod_length": "136 mm"}}},
        torsion={"throw_inertia": "0.1 kg·m²", **torsion},
    )


def test_a_gap_of_its_own():
    """In place of the stiffness of all, as a list has it."""
    own = in_line(stiffness="1 MN·m/rad", gap={"2": {"stiffness": "9000 N·m/deg"}})
    listed = in_line(stiffness=["1 MN·m/rad", "9000 N·m/deg", "1 MN·m/rad"])
    np.testing.assert_array_equal(frequency(own), frequency(listed))
    stiffness = pi * G * 0.09**4 / (32 * 0.3)
    sized = in_line(gap={name: {"length": "300 mm", "diameter": "90 mm"} for name in "123"})
    # Four equal discs: docs/theory/torsion, eq. (23.12).
    wanted = 2 * np.sqrt(stiffness / 0.1) * np.sin(np.arange(1, 4) * pi / 8)
    np.testing.assert_allclose(frequency(sized), wanted, rtol=1e-13)


def test_a_gap_beside_sizes():
    """What the others are by the sizes of the crankshaft stays."""
    of_sizes = ct.run(four()).dataset.throw_stiffness.sel(throw_method="frame").values
    found = ct.run(four().with_({"torsion.gap": {"2": {"stiffness": "300 kN·m/rad"}}})).dataset.throw_stiffness
    wanted = np.where(np.arange(of_sizes.size) == 1, 300e3, of_sizes)
    np.testing.assert_allclose(found.sel(throw_method="given"), wanted, rtol=1e-14)
    np.testing.assert_allclose(found.sel(throw_method="frame"), of_sizes, rtol=1e-14)


WRONG_GAPS = {
    "no such gap": (
        {"stiffness": "1 MN·m/rad", "gap": {"4": {"stiffness": "1 MN·m/rad"}}},
        "gap.4: must be the number",
    ),
    "a name": ({"stiffness": "1 MN·m/rad", "gap": {"a": {"stiffness": "1 MN·m/rad"}}}, "gap.a: must be the number"),
    "nothing": ({"stiffness": "1 MN·m/rad", "gap": {"2": {}}}, "gap.2.stiffness: is missing"),
    "others": (
        {"gap": {"2": {"stiffness": "1 MN·m/rad"}}},
        "stiffness: is missing; give it for gaps 1, 3 between throws, or [crankshaft]",
    ),
    "a method": (
        {"gap": {name: {"stiffness": "1 MN·m/rad"} for name in "123"}, "stiffness_method": "frame"},
        "stiffness_method = frame: is for a stiffness by the sizes of [crankshaft]; here all gaps have their own",
    ),
}


@pytest.mark.parametrize("table, wanted", WRONG_GAPS.values(), ids=WRONG_GAPS)
def test_gaps_refused(table, wanted):
    with pytest.raises(ct.InputError) as found:
        ct.run(in_line(**table))
    assert f"torsion.{wanted}" in str(found.value)


def test_one_throw_has_no_gap():
    disc = {"inertia": "2 kg·m²", "beside": 1, "stiffness": "1 MN·m/rad"}
    with pytest.raises(ct.InputError) as refused:
        single = ct.Machine(
            shaft={"main": {"speed": "600 rpm"}},
            mechanism={"kind": "slider_crank", "crank_radius": "50 mm", "rod_length": "200 mm"},
            torsion={"throw_inertia": "1 kg·m²", "disc": {"wheel": disc}, "gap": {"1": {"stiffness": "1 MN·m/rad"}}},
        )
        ct.run(single)
    assert "torsion.gap.1: is for the gaps between throws; this crankshaft has one throw" in str(refused.value)
