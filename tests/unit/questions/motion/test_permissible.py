"""The permissible pressure angle of a slider-crank: asked of the synthesis, kept in the file, drawn at."""

import tomllib
from math import asin, degrees, radians

import numpy as np
import pytest
from tests.told import texts_of

import cranktrain as ct
from cranktrain.plans.positions import source_angles
from cranktrain.synthesis.slider_crank import slider_crank_from_stroke


def press(**fields):
    table = {"kind": "slider_crank", "crank_radius": "80 mm", "rod_length": "140 mm", **fields}
    return ct.Machine(mechanism=table)


def warned(machine):
    return [flag for flag in texts_of(ct.run(machine).flags) if "permissible" in flag]


def test_what_is_over_the_limit_is_said():
    """Of a central mechanism it is asin(R/L), at 90°."""
    (flag,) = warned(press(permissible_pressure_angle="30 deg"))
    angle = degrees(asin(80 / 140))
    for words in (f"{angle:.2f} deg", "crank at 90.00 deg", f"{angle - 30:.2f} deg over", "permissible 30.00 deg"):
        assert words in flag
    assert not warned(press(permissible_pressure_angle="35 deg"))


def test_it_moves_nothing():
    """Every number is as without it."""
    with_limit, without = (ct.run(press(**one)) for one in ({"permissible_pressure_angle": "20 deg"}, {}))
    for name in without.catalogue:
        np.testing.assert_array_equal(getattr(with_limit, name), getattr(without, name))


@pytest.mark.parametrize(("wrong", "said"), [("0 deg", "more than 0"), ("90 deg", "less than 90"), ("3 mm", "angle")])
def test_what_is_no_pressure_angle_is_refused(wrong, said):
    with pytest.raises(ct.InputError, match=said):
        press(permissible_pressure_angle=wrong)


@pytest.mark.parametrize(
    ("options", "kept"),
    [
        ({"pressure_angle": radians(30)}, 30.0),
        ({"pressure_angle": radians(30), "rod_length": 0.27}, 30.0),
        ({"pressure_angle": radians(20), "return_pressure_angle": radians(35), "offset": None}, 35.0),
        ({"pressure_angle": radians(20), "return_pressure_angle": radians(35)}, 20.0),
        ({"rod_length": 0.27}, None),
    ],
)
def test_the_synthesis_keeps_it_in_the_file(options, kept):
    """With an offset one stroke may have the wider of two limits, which then is the one all round the turn."""
    machine = ct.Machine(**tomllib.loads(slider_crank_from_stroke(0.16, **options).machine_file()))
    found = machine.mechanism.permissible_pressure_angle
    assert (None if found is None else degrees(found.si)) == (kept if kept is None else pytest.approx(kept, rel=1e-15))
    assert not warned(machine)


def test_the_source_draws_at_the_angle_that_was_asked_for():
    """Of a rod of 270 mm the largest is 17.2°, but the limit 30°, as the source has it; typed, it is another."""
    made = slider_crank_from_stroke(0.16, radians(30), rod_length=0.27)
    machine = ct.Machine(**tomllib.loads(made.machine_file()))
    assert source_angles(machine) == pytest.approx(range(0, 360, 30))
    assert source_angles(machine, permissible=20.0)[1] == 20.0
    assert source_angles(machine.with_({"mechanism.permissible_pressure_angle": None}))[1] == pytest.approx(
        degrees(asin(80 / 270)), abs=1e-8
    )
