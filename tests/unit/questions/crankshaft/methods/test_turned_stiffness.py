"""Bearings that give differently in two directions, which may lean: the machine turned as a whole is the same one."""

import numpy as np
import pytest
from tests.validation.test_crankshaft_arrangements import PLAIN, SECTIONS

import cranktrain as ct


def vee(turned=0.0, rotation="clockwise", stiffness=("300 kN/mm", "90 kN/mm"), more=None, **crankshaft):
    """Two banks on three bearings, all of it turned by some degrees but the stiffness."""
    return ct.Machine(
        rotation=rotation,
        shaft={"main": {"throws": ["0 deg", "180 deg"], "spacing": "150 mm", "speed": "750 rpm"}},
        bank={name: {"angle": f"{angle + turned} deg", "mechanism": PLAIN} for name, angle in (("A", -30), ("B", 40))},
        masses={"piston": {"mass": "5 kg"}, "crank": {"mass": "6 kg", "along": "20 mm", "inertia": "0.02 kg·m²"}},
        crankshaft={
            **SECTIONS,
            "bearing_stiffness": list(stiffness),
            "pull": {"belt": {"z": "-150 mm", "force": "2 kN", "direction": f"{75 + turned} deg"}},
            **crankshaft,
        },
        **(more or {}),
    )


def largest(machine):
    return ct.run(machine).dataset.largest_bearing_load.sel(bearing_method=["frame_elastic", "five_moment"]).values


@pytest.mark.parametrize("rotation", ["clockwise", "anticlockwise"])
@pytest.mark.parametrize("turned", [30.0, -75.0])
def test_turned_as_a_whole(turned, rotation):
    upright, leaning = vee(rotation=rotation), vee(turned, rotation, bearing_stiffness_direction=f"{turned} deg")
    np.testing.assert_allclose(largest(leaning), largest(upright), rtol=1e-10)
    assert np.max(np.abs(largest(vee(turned, rotation)) / largest(upright) - 1)) > 1e-3


def test_a_quarter_turn_changes_both():
    """To the right and up are then down and to the right."""
    swapped = vee(stiffness=("90 kN/mm", "300 kN/mm"))
    np.testing.assert_allclose(largest(vee(bearing_stiffness_direction="90 deg")), largest(swapped), rtol=1e-11)
    np.testing.assert_allclose(largest(vee(bearing_stiffness_direction="180 deg")), largest(vee()), rtol=1e-11)


def test_of_one_bearing():
    """Its own direction counts, with the stiffness of all."""
    own = {"bearing": {name: {"stiffness_direction": "30 deg"} for name in "123"}}
    np.testing.assert_array_equal(largest(vee(**own)), largest(vee(bearing_stiffness_direction="30 deg")))


def test_flags_are_of_its_own_directions():
    """A stiffness of 0.1 N/mm one way is told however the housing leans."""
    for direction in ("0 deg", "30 deg"):
        machine = vee(stiffness=("300 kN/mm", "1 N/mm"), bearing_stiffness_direction=direction)
        said = [str(flag) for flag in ct.run(machine).unlikely if "stiffness of bearing" in str(flag)]
        assert said


WRONG = {
    "of one": (
        {"bearing_stiffness": "300 kN/mm", "bearing_stiffness_direction": "30 deg"},
        "bearing_stiffness_direction",
    ),
    "of a bearing with one": (
        {"bearing": {"2": {"stiffness": "1 kN/mm", "stiffness_direction": "30 deg"}}},
        "bearing.2.stiffness_direction",
    ),
    "no angle": ({"bearing_stiffness_direction": "30 mm"}, "bearing_stiffness_direction = 30 mm"),
}


@pytest.mark.parametrize("table, where", WRONG.values(), ids=WRONG)
def test_refused(table, where):
    with pytest.raises(ct.InputError) as found:
        ct.run(vee(**table))
    assert f"crankshaft.{where}" in str(found.value)
