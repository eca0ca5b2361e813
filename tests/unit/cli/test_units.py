"""`--units` and [units]: on the screen, and in what is written."""

import json

import numpy as np
import pytest


def test_screen_and_tables(typed, tmp_path):
    for units, said in (((), "49.52 in"), (("--units", "mm"), "1258 mm")):
        lines = typed("run", "pumping_unit_c57", *units).output.splitlines()
        assert next(line for line in lines if "stroke of the load" in line).endswith(said)
    typed("run", "3d12", "--units", "psi", "--quantities", "peak_pressure,stroke", "-o", "out.json")
    facts = json.loads((tmp_path / "out.json").read_text(encoding="utf-8"))["facts"]
    assert facts["stroke"]["unit"] == "m"
    assert facts["peak_pressure"]["unit"] == "psi"
    # 47.844 bar
    assert np.ravel(facts["peak_pressure"]["values"])[0] == pytest.approx(693.9, abs=0.05)


@pytest.mark.parametrize(
    ("setting", "said"),
    [
        ("units.pressure=mm", "units.pressure = mm: must be one of: kPa, Pa, MPa"),
        ("units.presure=bar", "units.presure = bar: must be one of: "),
    ],
)
def test_wrong_tables_of_units(typed, setting, said):
    assert said in typed("run", "3d12", "--set", setting).errors


def test_facts_of_a_table_are_in_the_units_of_its_curves(typed, tmp_path):
    typed("run", "3d12", "--units", "psi", "--quantities", "peak_pressure,stroke", "--facts", "-o", "facts.csv")
    rows = (tmp_path / "facts.csv").read_text(encoding="utf-8").splitlines()
    assert {row.split(",")[3] for row in rows if row.startswith("peak_pressure,")} == {"psi"}
    assert {row.split(",")[3] for row in rows if row.startswith("stroke,")} == {"m"}
