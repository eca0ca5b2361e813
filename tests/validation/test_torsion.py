"""Torsional trains against worked examples: Bevan, chapter 15, example 9; Sarkar, chapter 11, example 12.

Both books take shafts of plain steel. Their printed results are rounded to 0.3 %; the exact ones were computed from the
frequency equations of two and three discs in closed form.
"""

import json
from pathlib import Path

import numpy as np
import pytest

from cranktrain.questions.torsion.parts import declared_train
from cranktrain.questions.torsion.spec import TorsionSpec
from cranktrain.questions.torsion.train import Train, natural_modes
from cranktrain.spec import validated

CASES = {
    case["id"]: case
    for case in json.loads(
        (Path(__file__).parents[1] / "golden/textbook_examples/case.json").read_text(encoding="utf-8")
    )["machine"]
}
PRINTED = 0.003


def round_shaft(length, diameter, modulus):
    """Stiffness G I_p/l."""
    return modulus * np.pi * diameter**4 / 32 / length


def test_three_rotors_of_bevan():
    case = CASES["B15.9"]
    given = case["inputs"]
    inertia = np.array(given["inertia_ton_ft2"]) * given["long_ton_lb"] / given["g_ft_s2"]
    modulus = given["shear_modulus_psi"] * 144
    stiffness = np.array(
        [round_shaft(feet, given["shaft_diameter_in"] / 12, modulus) for feet in given["shaft_length_ft"]]
    )
    per_minute = natural_modes(Train(inertia, stiffness, np.array([1, 2]))).speed * 60 / (2 * np.pi)
    np.testing.assert_allclose(per_minute, case["exact"]["frequency_per_min"], rtol=1e-12)
    np.testing.assert_allclose(per_minute, case["book"]["frequency_per_min"], rtol=PRINTED)


def test_geared_rotors_of_sarkar():
    """The gears weigh nothing in the book; here one of them weighs 1 mg at 1 m."""
    case = CASES["S11.12"]
    given = case["inputs"]
    motor, pump = (
        round_shaft(*sizes, given["shear_modulus_Pa"])
        for sizes in zip(given["shaft_length_m"], given["shaft_diameter_m"], strict=True)
    )
    spec = validated(
        TorsionSpec,
        {
            "throw_inertia": f"{given['motor_inertia_kgm2']} kg·m²",
            "disc": {
                "gear": {"inertia": "1e-6 kg·m²", "beside": 1, "stiffness": f"{motor!r} N·m/rad"},
                "pump": {
                    "inertia": f"{given['pump_inertia_kgm2']} kg·m²",
                    "beside": "gear",
                    "stiffness": f"{pump!r} N·m/rad",
                    "ratio": f"{given['pump_rpm']}/{given['motor_rpm']}",
                },
            },
        },
    )
    declared = declared_train(spec, 1)
    found = natural_modes(Train(declared.inertia, declared.stiffness, declared.following)).speed[0, 0] / (2 * np.pi)
    assert found == pytest.approx(case["exact"]["frequency_Hz"], rel=1e-8)
    assert found == pytest.approx(case["book"]["frequency_Hz"], rel=PRINTED)
