import tomllib

import numpy as np
import pytest
from tests.reference_case import ReferenceCase

from cranktrain.analysis import run
from cranktrain.errors import InputError
from cranktrain.machine import Machine
from cranktrain.synthesis.radial import STRATEGIES, radial

COLUMNS = {
    "articulation_radius_mm": ("knuckle_radius", 1e3),
    "zeta_deg": ("articulation_angle", np.degrees(1)),
    "slave_rod_length_mm": ("rod_length", 1e3),
    "stroke_mm": ("stroke", 1e3),
    "tdc_shift_deg": ("top_shift", np.degrees(1)),
    "bdc_shift_deg": ("bottom_shift", np.degrees(1)),
    "pin_height_minus_master_mm": ("height_over_master", 1e3),
    "compression_ratio_if_master_6p5": ("compression_ratio", 1.0),
}
NINE = {"knuckle_radius": 0.075, "slave_rod_length": 0.235, "compression_ratio": 6.5}


@pytest.mark.parametrize(("label", "strategy"), list(zip(("S0", "S1", "S2", "S3", "S4"), STRATEGIES, strict=True)))
def test_reference_case(label, strategy):
    case = ReferenceCase.load("radial9").selected(label)
    slaves = ReferenceCase(case.name, case.machine, case.document, case.rows[1:])
    proposal = radial(0.08, 0.31, 9, strategy, bore=0.08, **NINE)
    slaves.compare(
        {
            column: [scale * proposal.value(f"{name}({i})") for i in range(2, 10)]
            for column, (name, scale) in COLUMNS.items()
        }
    )
    result = run(Machine(**tomllib.loads(proposal.machine_file())))
    for name, found in (("stroke", result.stroke), ("compression_ratio", result.compression_ratio)):
        np.testing.assert_allclose(found[1:], [proposal.value(f"{name}({i})") for i in range(2, 10)], rtol=1e-12)


def test_alternatives_are_all_strategies_with_their_spread():
    # docs/theory/synthesis: strokes, largest shift of a top, compression ratios
    expected = {
        "plain": (160.00, 161.06, 4.42, 5.98, 6.50),
        "unshifted": (160.00, 173.42, 0.0, 6.50, 6.96),
        "equal_ratio": (160.00, 161.05, 4.41, 6.50, 6.50),
        "equal_stroke": (160.00, 160.00, 5.08, 6.50, 6.50),
        "unshifted_equal_ratio": (160.00, 173.48, 0.0, 6.50, 6.50),
    }
    alternatives = {
        str(one.label): [n.value for n in one.numbers] for one in radial(0.08, 0.31, 9, "plain", **NINE).alternatives
    }
    scale = (1e3, 1e3, np.degrees(1), 1, 1)
    for strategy, numbers in expected.items():
        np.testing.assert_allclose(np.multiply(alternatives[STRATEGIES[strategy]], scale), numbers, rtol=0, atol=0.0051)


def test_slave_opposite_to_its_master_cannot_have_its_stroke():
    with pytest.raises(InputError, match=r"slave at 180\.00 deg can have strokes from 160\.0004 mm"):
        radial(0.08, 0.31, 8, "equal_stroke", **NINE)
    left = [str(one.label) for one in radial(0.08, 0.31, 8, "plain", **NINE).alternatives]
    assert STRATEGIES["equal_stroke"] not in left
    assert len(left) == 4


@pytest.mark.parametrize(
    ("changes", "path"),
    [
        ({"n_cylinders": 2}, "n_cylinders"),
        ({"strategy": "equal"}, "strategy"),
        ({"compression_ratio": 1.0}, "compression_ratio"),
        ({"knuckle_radius": 0.0}, "knuckle_radius"),
        ({"rod_length": 0.07}, "rod_length"),
        ({"slave_rod_length": 0.05}, "slave_rod_length"),
    ],
)
def test_impossible_requirements(changes, path):
    requirements = {"crank_radius": 0.08, "rod_length": 0.31, "n_cylinders": 9, "strategy": "plain", **NINE}
    with pytest.raises(InputError) as caught:
        radial(**requirements | changes)
    assert [problem.path for problem in caught.value.problems] == [path]
