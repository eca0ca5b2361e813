"""Places along the shaft, added up by hand."""

import numpy as np
import pytest
from tests.machines import banks, slider, throws
from tests.told import texts_of

import cranktrain as ct


def positions(shaft, bank):
    result = ct.run(ct.Machine(shaft=shaft, bank=bank))
    return dict(zip(result.labels["mechanism"], result.axial_position.tolist(), strict=True))


def test_one_gap_for_all_and_staggered_banks():
    bank = banks(L=-45, R=45)
    bank["R"]["stagger"], bank["L"]["stagger"] = "14.75 mm", "-14.75 mm"
    found = positions(throws(0, 90, 270, 180, spacing="155 mm"), bank)
    for name, place in found.items():
        expected = 0.155 * (int(name[0]) - 1) + (0.01475 if name[1] == "R" else -0.01475)
        assert place == pytest.approx(expected, abs=1e-15)


def test_list_of_gaps_with_two_throws_at_one_place():
    found = positions(throws(0, 30, 180, spacing=["0 mm", "90 mm"]), banks(A=0))
    assert found == pytest.approx({"1": 0, "2": 0, "3": 0.09})


def test_bank_on_some_throws():
    bank = banks(A=0)
    bank["A"]["throws"] = [3, 1]
    assert positions(throws(0, 30, 180, spacing=["10 mm", "90 mm"]), bank) == pytest.approx({"1": 0.1, "2": 0})


def test_one_throw_needs_no_spacing():
    assert ct.run(ct.Machine(mechanism=slider())).axial_position.tolist() == [0.0]


def test_several_throws_without_spacing_lack_it():
    result = ct.run(ct.Machine(shaft=throws(0, 180), bank=banks(A=0)))
    assert "axial_position" not in result.catalogue
    (missing,) = [missing for missing in result.missing if "axial_position" in missing.results]
    assert texts_of(missing.needs) == ("[shaft.main] spacing",)


@pytest.mark.parametrize("spacing", [["10 mm", "10 mm"], ["10 mm"] * 4, []])
def test_gaps_must_fit_the_throws(spacing):
    with pytest.raises(ct.InputError, match=r"shaft\.main\.spacing"):
        ct.Machine(shaft=throws(0, 90, 180, 270, spacing=spacing), bank=banks(A=0))


def test_designs():
    machines = [ct.Machine(shaft=throws(0, 180, spacing=f"{gap} mm"), bank=banks(A=0)) for gap in (100, 120)]
    np.testing.assert_allclose(ct.run(machines).axial_position, [[0, 0.1], [0, 0.12]])
