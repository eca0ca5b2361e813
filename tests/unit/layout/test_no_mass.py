"""A mass of 0: a part that weighs nothing, and is said to."""

import numpy as np
import pytest

import cranktrain as ct

MECHANISM = {"kind": "slider_crank", "stroke": "150 mm", "rod_length": "375 mm"}


def run(**masses):
    return ct.run(ct.Machine(mechanism=MECHANISM, shaft={"main": {"speed": "600 rpm"}}, masses=masses))


def test_a_rod_that_weighs_nothing_is_as_one_that_is_not_given_but_for_the_warning():
    declared, left_out = run(piston={"mass": "2 kg"}, rod={"mass": "0 kg"}), run(piston={"mass": "2 kg"})
    np.testing.assert_array_equal(declared.piston_force, left_out.piston_force)
    assert any("Without mass" in flag for flag in left_out.flags)
    assert not any("Without mass" in flag for flag in declared.flags)
    assert not any("two masses" in flag for flag in declared.flags)


def test_less_than_nothing_is_refused():
    with pytest.raises(ct.InputError, match=r"masses\.piston\.mass"):
        run(piston={"mass": "-1 kg"})


def test_a_rod_that_weighs_something_still_needs_its_centroid():
    with pytest.raises(ct.InputError, match=r"masses\.rod\.along"):
        run(rod={"mass": "1 kg"})


@pytest.mark.parametrize(("inertia", "is_doubted"), [("0 kg m2", False), ("1 kg m2", True)])
def test_an_inertia_of_no_mass_is_doubted(inertia, is_doubted):
    result = run(piston={"mass": "2 kg"}, rod={"mass": "0 kg", "along": "100 mm", "inertia": inertia})
    assert any("is hardly that of a link" in flag for flag in result.flags) is is_doubted
