"""Gases by the names of banks, cylinders and chambers: which table fills which, and what is refused, with its path."""

import numpy as np
import pytest
from tests.told import problems_told

import cranktrain as ct
from cranktrain.errors import InputError

MECHANISM = {"kind": "slider_crank", "stroke": "160 mm", "rod_length": "400 mm"}
COMPRESSOR = {"kind": "compressor", "compression_exponent": 1.3}
FIRST = COMPRESSOR | {"suction_pressure": "1 bar"}
LAST = COMPRESSOR | {"takes_from": "low", "discharge_pressure": "9 bar"}
WHOLE = FIRST | {"discharge_pressure": "4 bar"}


def machine(gas, **cylinder):
    return ct.Machine(
        shaft={"main": {"speed": "720 rpm", "throws": ["0 deg", "100 deg"]}},
        bank={name: {"throws": [i + 1], "mechanism": MECHANISM} for i, name in enumerate(("low", "high"))},
        cylinder={"bore": "200 mm", "compression_ratio": 13.5} | cylinder,
        gas=gas,
    )


@pytest.mark.parametrize(
    ("gas", "path", "words"),
    [
        ({"low": WHOLE, "hihg": WHOLE}, "gas.hihg", "neither a bank nor a cylinder or chamber"),
        ({"low": WHOLE}, "gas", "has no table for 1high, while others have one"),
        (WHOLE | {"low": WHOLE}, "gas.low", "must not stand beside kind"),
        ({"suction_pressure": "1 bar"}, "gas.kind", "is missing"),
        ({}, "gas.kind", "is missing"),
        ({"peg": {"exponent": 1.3}}, "gas.kind", "give every chamber a table"),
        ({"low": 3}, "gas.kind", "is missing"),
        ({"low": {"kind": "compresor"}, "high": WHOLE}, "gas.low.kind", "must be one of"),
        ({"low": {"x": WHOLE}, "high": WHOLE}, "gas.low.kind", "is missing"),
        ({"1low": WHOLE, "low": WHOLE, "high": WHOLE}, "gas.low", "fills nothing"),
        ("air", "gas", "must be a table"),
        ([WHOLE], "gas", "must be a table"),
        ({"low": FIRST, "high": LAST | {"takes_from": "x"}}, "gas.high.takes_from", "another compressor's name"),
        ({"low": WHOLE, "high": LAST | {"takes_from": "high"}}, "gas.high.takes_from", "another compressor's name"),
        (
            {"low": COMPRESSOR | {"takes_from": "high"}, "high": COMPRESSOR | {"takes_from": "low"}},
            "gas.high.takes_from",
            "goes round",
        ),
        ({"low": COMPRESSOR | {"discharge_pressure": "3 bar"}, "high": WHOLE}, "gas.low.suction_pressure", "missing"),
        ({"low": WHOLE, "high": LAST}, "gas.low.discharge_pressure", "leave it out"),
        ({"low": FIRST, "high": LAST | {"suction_pressure": "3 bar"}}, "gas.high.suction_pressure", "leave it out"),
        (
            COMPRESSOR | {"suction_pressure": "5 bar", "discharge_pressure": "1 bar"},
            "gas.discharge_pressure",
            "more than",
        ),
        (WHOLE | {"suction_loss": 1.5}, "gas.suction_loss", "less than 1"),
    ],
)
def test_refused(gas, path, words):
    with pytest.raises(InputError) as refusal:
        ct.run(machine(gas))
    assert words in {problem.path: problem.allowed for problem in problems_told(refusal.value.problems)}[path]


def test_stages_without_a_common_flow():
    """A second stage of 25 times the area swallows more than the first delivers against any pressure."""
    with pytest.raises(InputError, match="no flow in common with the stage before, at any pressure from 1 to 9 bar"):
        ct.run(machine({"low": FIRST, "high": LAST}, low={"bore": "100 mm"}, high={"bore": "500 mm"}))


@pytest.mark.parametrize(("key", "given"), [("cycle", "four-stroke"), ("firing_order", "1low-1high")])
def test_compressors_do_not_fire(key, given):
    with pytest.raises(InputError, match=rf"cylinder.{key}.*is for cylinders that fire"):
        ct.run(machine(WHOLE, **{key: given}))


def test_the_nearest_table_counts():
    """Both sides of the low piston: one by its own name, one by the bank's."""
    gas = {"low": WHOLE, "1low.crank": WHOLE | {"discharge_pressure": "6 bar"}, "1high": WHOLE}
    result = ct.run(machine(gas, chambers=("head", "crank"), piston_rod="40 mm"))
    assert result.labels["chamber"] == ("1low.head", "1low.crank", "1high.head", "1high.crank")
    np.testing.assert_allclose(result.discharge_line_pressure, [4e5, 6e5, 4e5, 4e5])


def test_a_stage_may_take_from_one_side_of_a_piston():
    """Its name has a dot, and stands in quotes in the path."""
    gas = {
        "1low.head": FIRST,
        "1low.crank": LAST | {"takes_from": "1low.head"},
        "1high": WHOLE,
    }
    result = ct.run(machine(gas, chambers=("head", "crank"), piston_rod="150 mm", high={"chambers": ["head"]}))
    low, crank, high = result.suction_line_pressure
    assert (low, high) == (1e5, 1e5)
    assert 1e5 < crank == result.discharge_line_pressure[0] < 9e5


def test_a_compressor_beside_an_engine_works_in_every_turn():
    """A gas-engine compressor: over a cycle of two turns its valves open twice, and the torque does the gas's work."""
    engine = {"kind": "otto", "start_pressure": "1 bar", "compression_exponent": 1.3, "expansion_exponent": 1.3}
    gas = {"low": engine | {"pressure_ratio": 3.0}, "high": WHOLE}
    result = ct.run(machine(gas, cycle="four-stroke", firing_order="1low-1high"))
    alone = ct.run(machine(WHOLE))
    assert result.indicated_work[1] == pytest.approx(2 * alone.indicated_work[1], rel=1e-14)
    assert [check.name for check in result.checks if not np.all(check.passed)] == []
    (work,) = (check for check in result.checks if check.name == "work")
    assert work.residual[0] < 1e-12
