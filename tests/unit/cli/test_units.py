"""`--units` and [units]: on the screen, and in what is written."""

import csv
import json
import re

import numpy as np
import pytest

import cranktrain as ct


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


ASKED = (((), "m", 0.0254), (("--units", "in"), "in", 1.0), (("--set", "units.length=cm"), "cm", 2.54))
"""Options, the unit of what is written then, and an inch in it."""


@pytest.mark.parametrize(("options", "unit", "inch"), ASKED)
def test_data_follow_what_is_asked_and_not_the_habit_of_a_file(typed, tmp_path, options, unit, inch):
    """The stroke of 49.524 in [api-11e], in inches on the screen; in data only where they are asked for."""
    wanted = ("run", "pumping_unit_c57", *options, "--quantities")
    typed(*wanted, "load_displacement", "-o", "a.csv")
    head, *rows = [line for line in (tmp_path / "a.csv").read_text().splitlines() if not line.startswith("#")]
    assert head.split(",")[1] == f"load_displacement(1) [{unit}]"
    assert np.ptp([float(row.split(",")[1]) for row in rows]) == pytest.approx(49.524 * inch, rel=1e-3)
    typed(*wanted, "load_stroke", "--facts", "-o", "facts.csv")
    _head, fact = (tmp_path / "facts.csv").read_text().splitlines()
    assert (fact.split(",")[3], float(fact.split(",")[2])) == (unit, pytest.approx(49.524 * inch, rel=1e-4))


@pytest.mark.parametrize(("options", "unit", "inch"), ASKED)
def test_workbooks_do_so_too(typed, tmp_path, options, unit, inch):
    openpyxl = pytest.importorskip("openpyxl")
    typed("run", "pumping_unit_c57", *options, "--quantities", "load_stroke,load_displacement", "-o", "a.xlsx")
    book = openpyxl.load_workbook(tmp_path / "a.xlsx")
    assert [cell.value for cell in next(book["curves"].iter_rows())][1] == f"load_displacement(1) [{unit}]"
    fact = next(row for row in book["facts"].iter_rows(values_only=True) if row[0] == "load_stroke")
    assert fact[2:4] == (pytest.approx(49.524 * inch, rel=1e-4), unit)


def test_datasets_have_values_and_their_unit_together():
    """1 psi = 6894.757293 Pa; back in SI they are what they were."""
    result = ct.run("3d12", quantities=["peak_pressure", "gas_pressure", "stroke", "piston_velocity_coefficient"])
    with ct.units("psi", "in"):
        asked = result.dataset
    usual = result.dataset
    units = {"peak_pressure": "psi", "gas_pressure": "psi", "stroke": "in", "piston_velocity_coefficient": "in/rad"}
    sizes = {"psi": 6894.757293168361, "in": 0.0254, "in/rad": 0.0254}
    for name, unit in units.items():
        assert asked[name].attrs["units"] == unit
        assert usual[name].attrs["units"] == result.catalogue[name].unit
        np.testing.assert_allclose(asked[name] * sizes[unit], usual[name], rtol=1e-14)
    assert asked["crank_angle"].attrs["units"] == "deg"
    of_table = ct.run(ct.load("3d12", set={"units": {"pressure": "bar"}}), quantities="peak_pressure").dataset
    assert of_table["peak_pressure"].attrs["units"] == "bar"
    np.testing.assert_allclose(of_table["peak_pressure"] * 1e5, usual["peak_pressure"], rtol=1e-14)


def test_a_file_in_kpa_is_shown_in_kpa(typed):
    """47.844 bar are 4784 kPa; one number of two is no habit."""
    setting = ("--set", "gas.start_pressure=90 kPa")
    both = typed("run", "3d12", *setting, "--set", "gas.exhaust_pressure=106 kPa").output
    assert next(line for line in both.splitlines() if "peak pressure" in line).split()[2:5] == ["4784", "5011", "kPa,"]
    one = typed("run", "3d12", *setting).output
    assert "47.84" in one and "kPa" not in one


@pytest.mark.parametrize("name", ["3d12", "gas_compressor", "great_northern", "inline_six", "pumping_unit_c57"])
def test_tables_have_no_powers_of_ten_and_true_minuses(typed, name):
    said = typed("run", name, "--full").output
    results = said.partition("\nResults\n")[2].partition("\nChecks\n")[0]
    assert len(results.splitlines()) > 10
    assert not re.search(r"\de[+-]?\d", results)
    assert not re.search(r"(?<![\w.–-])-\d", said.partition("\nChecks\n")[0])
    assert not re.search(r"\*|\^", results)


def test_shaft_speeds_are_in_rpm_in_every_table(typed):
    """1500 rpm on the mean: the answer, the table of facts and the comparison say so alike."""
    full = typed("run", "3d12", "--full").output
    row = next(line for line in full.splitlines() if line.startswith("  mean_speed_over_time"))
    assert row.split()[1:] == ["ω_t", "rpm", "1500"]
    compared = ct.compare("3d12", set={"shaft.main.speed": "1800 rpm"}, quantities="mean_speed_over_time")
    assert "1500" in str(compared) and "1800 rpm" in str(compared)
    assert str(ct.run("3d12").facts["peak_pressure"]).endswith("Pa>")
    assert "e+" not in repr(ct.run("deltic").facts["indicated_power"])


SIX = 216.58355700527412
"""Lowest natural frequency of the example inline_six. [Hz]"""


@pytest.mark.parametrize("options", [("--units", "Hz"), ("--set", "units.frequency=Hz")])
def test_natural_frequencies_in_hertz(options, typed, tmp_path):
    """The usual unit, asked for by its name, changes no number: of the screen, of tables."""
    said = [typed("run", "inline_six", *more).output for more in ((), options)]
    rows = [next(line for line in text.splitlines() if "natural frequencies" in line) for text in said]
    assert rows[0] == rows[1]
    typed("run", "inline_six", *options, "--quantities", "natural_frequency", "--facts", "-o", "facts.csv")
    row = next(csv.DictReader((tmp_path / "facts.csv").read_text(encoding="utf-8").splitlines()))
    assert (row["unit"], float(row["value"])) == ("Hz", pytest.approx(SIX, rel=1e-9))


def test_a_dataset_with_natural_frequencies_in_hertz():
    """Without a wish they are as the catalogue says, in rad/s."""
    result = ct.run("inline_six", quantities="natural_frequency")
    for units, label, size in (
        (("Hz",), "Hz", 1.0),
        (("kHz",), "kHz", 1e-3),
        (("1/h",), "1/h", 3600.0),
        ((), "rad/s", 2 * np.pi),
    ):
        with ct.units(*units):
            found = result.dataset["natural_frequency"]
        assert found.attrs["units"] == label
        assert found.values.ravel()[0] == pytest.approx(SIX * size, rel=1e-9)


def test_times_are_in_seconds_beside_delays_in_milliseconds(typed):
    """A clutch that engages in 30 ms makes no start last 3700 ms; asked for, it does."""
    wanted = ("run", "high_slip_press", "--full")
    assert {"s"} == set(re.findall(r"^  cycle_time +T +(m?s) ", typed(*wanted).output, re.MULTILINE))
    assert {"ms"} == set(re.findall(r"^  cycle_time +T +(m?s) ", typed(*wanted, "--units", "ms").output, re.MULTILINE))
