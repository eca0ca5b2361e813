"""A double-acting cylinder with a card works once a turn on either side, whether the file says a cycle or not."""

import tomllib
from importlib.resources import files

import numpy as np
import pytest

import cranktrain as ct

MILL = tomllib.loads(files("cranktrain.examples").joinpath("mill_engine.toml").read_text(encoding="utf-8"))


def without(table, *keys):
    return {key: value for key, value in table.items() if key not in keys}


def test_a_card_without_a_cycle_is_of_one_turn():
    declared, bare = (
        ct.run(ct.Machine(**MILL | {"cylinder": cylinder}))
        for cylinder in (MILL["cylinder"], without(MILL["cylinder"], "cycle"))
    )
    for name in ("gas_pressure", "indicated_work", "mean_torque", "largest_rod_compression"):
        np.testing.assert_array_equal(getattr(bare, name), getattr(declared, name))


def test_two_cylinders_work_as_their_cranks_come():
    """Of a locomotive, cranks at 90°: the second one's head is at its top a quarter of a turn earlier."""
    tables = without(MILL, "crankshaft", "bank", "shaft", "evenness", "masses", "balance")
    mechanism = {"kind": "slider_crank", "stroke": "12 in", "rod_length": "30 in"}
    tables |= {
        "bank": {"line": {"mechanism": mechanism}},
        "shaft": {"main": {"throws": ["0 deg", "90 deg"], "spacing": "1 m", "speed": "180 rpm"}},
    }
    results = [
        ct.run(ct.Machine(**tables | {"cylinder": cylinder}))
        for cylinder in (tables["cylinder"], without(tables["cylinder"], "cycle"))
    ]
    np.testing.assert_array_equal(results[0].firing_angle, results[1].firing_angle)
    assert results[1].firing_angle == pytest.approx([0, 270])


def test_what_burns_on_both_sides_is_asked_for_its_cycle():
    """Double-acting engines of four strokes were built, too."""
    gas = {"kind": "otto", "start_pressure": "95 kPa", "compression_exponent": 1.35, "expansion_exponent": 1.27}
    tables = MILL | {"cylinder": without(MILL["cylinder"], "cycle"), "gas": gas | {"pressure_ratio": 3.6}}
    assert "gas_pressure" not in ct.run(ct.Machine(**tables)).catalogue


def test_a_single_acting_cylinder_is_still_asked_for_its_cycle():
    cylinder = without(MILL["cylinder"], "cycle") | {"chambers": ["head"]}
    result = ct.run(ct.Machine(**MILL | {"cylinder": cylinder}))
    assert "gas_pressure" not in result.catalogue
