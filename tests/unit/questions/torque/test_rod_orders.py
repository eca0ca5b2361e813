"""Harmonics of pistons by order, against a table by quadrature."""

import json
from typing import Any

import numpy as np
import pytest
from tests.machines import V12, slider, throws
from tests.reference_case import GOLDEN

import cranktrain as ct

TABLE: dict[str, Any] = json.loads((GOLDEN / "theory/harmonics_pnskt.json").read_text(encoding="utf-8"))["harmonics"]


@pytest.mark.parametrize("ratio", TABLE)
def test_table_of_quadrature(ratio):
    mechanism = slider(crank_radius="60 mm", rod_length=f"{60 / float(ratio)!r} mm")
    result = ct.run(ct.Machine(shaft=throws(0), bank={"A": {"mechanism": mechanism}}), step_degrees=10)
    assert result.labels["order"] == tuple(f"{order}" for order in range(1, 25))
    for name, known in (("acceleration_harmonic", "A"), ("inertia_torque_harmonic", "D")):
        found = getattr(result, name)[:, 0]
        for order in range(1, 9):
            if f"{known}{order}" in TABLE[ratio]:
                assert found[order - 1] == pytest.approx(TABLE[ratio][f"{known}{order}"], rel=0, abs=1e-15)
    np.testing.assert_array_equal(result.acceleration_harmonic[2::2], 0.0)


def test_half_orders_are_none_and_slaves_have_none_of_their_own():
    result = ct.run(ct.Machine(**V12), step_degrees=10)
    assert result.labels["order"][:3] == ("0.5", "1", "1.5")
    names = result.labels["piston"]
    masters = [place for place, name in enumerate(names) if name.endswith("L")]
    slaves = [place for place, name in enumerate(names) if name.endswith("R")]
    np.testing.assert_array_equal(result.acceleration_harmonic[::2, masters], 0.0)
    np.testing.assert_array_equal(result.acceleration_harmonic[1, masters], 1.0)
    assert np.all(np.isnan(result.inertia_torque_harmonic[:, slaves]))
    assert not np.any(np.isnan(result.inertia_torque_harmonic[:, masters]))


def test_an_offset_piston_has_none():
    machine = ct.Machine(shaft=throws(0), bank={"A": {"mechanism": slider(offset="5 mm")}})
    assert np.all(np.isnan(ct.run(machine, step_degrees=10).acceleration_harmonic))
