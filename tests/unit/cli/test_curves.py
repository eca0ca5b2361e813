"""`run --at` and `run --table`: curves at some crank angles, exact, on the screen and in files; data frames of them."""

import csv
import re

import numpy as np
import pytest
from matplotlib.text import Text
from tests.sentences import ENDS_IN, WHOLE_NUMBER

import cranktrain as ct
from cranktrain.all_questions import QUESTIONS
from cranktrain.analysis.curve_columns import at_angles, by_default, curve_columns, of_member
from cranktrain.panels.parts import sheet_of
from cranktrain.viz.curve_table import curve_table


def columns_of(path):
    """Columns of a table by their heads."""
    lines = [line for line in path.read_text(encoding="utf-8").splitlines() if not line.startswith("#")]
    heads, *rows = csv.reader(lines)
    return {head: np.array(column, dtype=float) for head, column in zip(heads, zip(*rows, strict=True), strict=True)}


def test_angles_off_every_grid_are_exact(typed, tmp_path):
    """Against x = R(1 − cos φ) + L − √(L² − R² sin² φ) of 78 × 78 with λ = 0.285."""
    typed("run", "textbook_78x78", "--at", "13.37,14,200.5", "--quantities", "piston_displacement", "-o", "at.csv")
    machine = ct.load("textbook_78x78")
    (mechanism,) = machine.bank["line"].mechanism
    radius = mechanism.stroke.si / 2
    rod = radius / mechanism.crank_to_rod_ratio.si
    columns = columns_of(tmp_path / "at.csv")
    assert columns["crank_angle [deg]"].tolist() == [13.37, 14.0, 200.5]
    angle = np.radians([13.37, 14.0, 200.5])
    expected = radius * (1 - np.cos(angle)) + rod - np.sqrt(rod**2 - (radius * np.sin(angle)) ** 2)
    np.testing.assert_allclose(columns["piston_displacement(1) [m]"], expected, rtol=1e-12)


def test_a_table_of_forces_closes(typed, tmp_path):
    """P is gas, inertia, loads and weight; T·R is the torque of a rod without slaves, N of it stands in the table."""
    machine = "vaz_21213"
    settings = ("--set", "gravity=true", "--set", "load.drag.force=60 N", "--set", "load.drag.on=piston")
    typed("run", machine, *settings, "--table", "forces", "--piston", "3", "--every", "7.5", "-o", "forces.csv")
    columns = columns_of(tmp_path / "forces.csv")
    parts = {head.split("(")[0]: values for head, values in columns.items()}
    assert len(parts["crank_angle [deg]"]) == 97
    whole = parts["gas_force"] + parts["inertia_force"] + parts["load_force"] + parts["weight_force"]
    np.testing.assert_allclose(parts["piston_force"], whole, rtol=0, atol=1e-12 * np.max(np.abs(whole)))
    assert np.max(np.abs(parts["load_force"])) == pytest.approx(60.0, rel=1e-12)
    # The first line and the last are one crank angle of the cycle.
    assert all(values[0] == values[-1] for head, values in parts.items() if head != "crank_angle [deg]")


def test_help_names_every_table(typed):
    tables = {name for question in QUESTIONS for name in question.curve_tables}
    words = " ".join(typed("run", "--help").output.split())
    (named,) = re.findall(r"A table of curves: ([\w, ]+)\.", words)
    assert set(re.split(r", | or ", named)) == tables


def test_a_table_on_the_screen(typed):
    output = typed("run", "vaz_21213", "--table", "forces", "--at", "0,30..60").output
    assert "Table forces of 1 (others by --of: 2, 3, 4)" in output
    heads, units, *rows = [line.split() for line in output[output.index("φ °") :].splitlines()[:5]]
    assert heads == ["φ", "°", "P_g", "P_j", "P", "N", "S", "K", "T", "M_i"]
    assert units == ["kN"] * 7 + ["N·m"]
    assert [row[0] for row in rows] == ["0", "30", "60"]
    result = ct.run("vaz_21213")
    shown = float(rows[1][3])
    assert shown == pytest.approx(result.piston_force[0, 0, 30] / 1e3, rel=5e-4)
    assert max(map(len, output.splitlines())) <= 80


@pytest.mark.parametrize(
    ("machine", "table", "names"),
    [
        ("3d12", "bearings", ["main_bearing_load_x", "journal_load_across"]),
        ("tilting_table", "drive", ["static_torque", "motor_torque"]),
        ("servo_press", "drive", ["static_motor_torque", "servo_torque"]),
        ("pumping_unit_c57", "pumping", ["rod_position", "gearbox_torque"]),
        ("pumping_unit_c57", "motion", ["rocker_angle", "load_displacement"]),
        ("gas_compressor", "motion", ["piston_displacement", "rod_angle"]),
    ],
)
def test_tables_of_other_questions(typed, machine, table, names):
    words = " ".join(typed("run", machine, "--table", table).output.split())
    assert all(re.search(rf"\b{name}\b", words) for name in names)


def test_a_table_on_paper(typed, tmp_path):
    """In two parts beside each other where one is too low; every number of the screen on it."""
    typed("run", "vaz_21213", "--table", "forces", "--every", "15", "-o", "forces.svg")
    assert (tmp_path / "forces.svg").read_text(encoding="utf-8").startswith("<?xml")
    result = ct.run("vaz_21213")
    columns = of_member(curve_columns(result, ("gas_force", "side_force"), of_each_method=False), "1")
    places = np.arange(0, 720, 15)
    sheet = sheet_of(result, 0, "Table forces of 1")
    figure = curve_table(sheet, at_angles(columns, places), places.astype(float))
    texts = {text.get_text() for text in figure.findobj(Text)}
    assert {f"{angle}" for angle in places} <= texts
    assert {"33.33", "0.2078", "kN"} <= texts
    assert len([text for text in figure.findobj(Text) if text.get_text() == "°"]) == 2


def test_curves_at_one_angle_are_told_as_facts_are(typed):
    output = typed("run", "vaz_21213", "--at", "140").output
    assert "At 140°" in output
    assert "by_method" not in output
    speed = next(line for line in output.splitlines() if "piston_velocity " in line).replace("−", "-").split()
    result = ct.run("vaz_21213")
    np.testing.assert_allclose([float(text) for text in speed[-2:]], result.piston_velocity[:2, 140], rtol=5e-4)


@pytest.mark.parametrize(
    ("typed_words", "said"),
    [
        (("--at", "x"), "--at = x: must be crank angles from 0 to 720 deg, such as 140 or 0,30..720"),
        (("--at", "0..30"), "write the first two before the dots: 0,30..720"),
        (("--at", "720,700..0"), "write the first two before the dots"),
        (("--at", "900"), "must be crank angles from 0 to 720 deg"),
        (("--at", "-1"), "must be crank angles from 0 to 720 deg"),
        (("--at", "nan"), "must be crank angles from 0 to 720 deg"),
        (("--at", "1e999999999"), "must be crank angles from 0 to 720 deg"),
        (("--at", "1e-300,2"), f"--at = 1e-300: {WHOLE_NUMBER} of hundredths of a degree"),
        (("--at", "13.377"), f"--at = 13.377: {WHOLE_NUMBER} of hundredths of a degree"),
        (("--table", "force"), "--table = force: must be one of: motion, forces"),
        (("--table", "forces", "--of", "9"), "--of = 9: must be one of: 1, 2, 3, 4"),
        (("--every", "3"), "--every = 3: is for a table; name one, such as --table forces"),
        (("--of", "1"), "--of = 1: is for a table"),
        (
            ("--table", "forces", "--every", "0"),
            "--every = 0: must be a number of degrees from 0.01 to 720, such as 30",
        ),
        (("--table", "forces", "--every", "2,4"), "--every = 2,4: must be a number of degrees from 0.01 to 720"),
        (("--table", "forces", "--every", "much"), "--every = much: must be a number of degrees from 0.01 to 720"),
        (("--table", "forces", "--every", "2", "--at", "3"), "must be left out beside --at"),
        (("--table", "forces", "--full"), "leave --full and"),
        (("--table", "forces", "-o", "forces.json"), "write a .csv or an .xlsx"),
        (("--table", "forces", "-o", "forces.gif"), f"{ENDS_IN}.csv, .json, .xlsx, .nc, .png, .svg, .pdf"),
        (("--at", "30", "-o", "at.png"), f"{ENDS_IN}.csv, .json, .xlsx, .nc"),
        (("--table", "forces", "--every", "1", "-o", "f.svg"), "of 721 lines does not fit on a sheet, which holds 62"),
        (("--at", "3", "--quantities", "stroke"), "--at = 3: has no curve that this machine has"),
    ],
)
def test_what_cannot_be(typed, typed_words, said):
    assert said in " ".join(typed("run", "vaz_21213", *typed_words).errors.split())


def test_a_table_says_what_it_needs(typed):
    assert "--table = forces: needs " in typed("run", "textbook_78x78", "--table", "forces").errors


def test_what_is_written_unless_named(typed, tmp_path):
    """What is meant of what each method gives; nothing that is there to be compared."""
    typed("run", "vaz_21213", "-o", "all.csv")
    heads = list(columns_of(tmp_path / "all.csv"))
    assert "piston_force(exact 1) [N]" in heads
    assert not any("textbook" in head or "by_method" in head for head in heads)
    typed("run", "vaz_21213", "--quantities", "piston_force", "-o", "named.csv")
    assert "piston_force(textbook 1) [N]" in columns_of(tmp_path / "named.csv")


def test_files_say_their_units(typed, tmp_path):
    typed("run", "vaz_21213", "-o", "all.csv", "--units", "bar,mm")
    text = (tmp_path / "all.csv").read_text(encoding="utf-8")
    assert "# units: bar, mm where they fit, else SI, in brackets; crank angles in degrees" in text


def test_data_frames():
    result = ct.run("vaz_21213")
    frame = result.curves()
    assert set(frame.columns.get_level_values("quantity")) == set(by_default(result))
    np.testing.assert_array_equal(frame["piston_force"]["2"], result.piston_force[0, 1])
    np.testing.assert_array_equal(frame.index, result.crank_angle)
    assert frame.attrs["units"]["piston_force"] == "N"
    each = result.curves("piston_force", of_each_method=True)
    np.testing.assert_array_equal(each["piston_force"]["textbook 2"], result.piston_force[1, 1])
    facts = result.facts_table()
    stroke = facts[(facts["quantity"] == "stroke") & (facts["of"] == "1")]
    assert stroke["value"].item() == result.stroke[0]
    assert stroke["unit"].item() == "m"


def test_data_frames_of_designs():
    machine = ct.load("gas_compressor")
    result = ct.run([machine, machine.with_({"shaft.main.speed": "900 rpm"})])
    np.testing.assert_array_equal(
        result.curves("piston_velocity", design=1)["piston_velocity"].to_numpy().T, result.piston_velocity[1]
    )
    assert len(result.facts_table(design=1)) == len(result.facts_table())
    with pytest.raises(ct.InputError, match="design = 2: must be from 0 to 1"):
        result.curves(design=2)
    with pytest.raises(
        ct.InputError, match='curves = piston_velocty: is no curve of this result; write "piston_velocity"'
    ):
        result.curves("piston_velocty")


def test_a_data_frame_of_all_combinations_is_refused():
    dataset = ct.run("vaz_21213").dataset
    with pytest.raises(ct.InputError, match=r"to_dataframe: would have .* rows, one for each combination of piston,"):
        dataset.to_dataframe()
    assert len(dataset[["piston_velocity"]].to_dataframe()) == 4 * 720


def test_a_start_at_some_times(typed, tmp_path):
    """By the interval of the file the same states; none after its end."""
    typed("start", "tilting_table", "--at", "0.25,0.5..1.25", "-o", "at.csv")
    typed("start", "tilting_table", "--set", "drive.start.interval=0.25 s", "-o", "every.csv")
    at, every = (columns_of(tmp_path / name) for name in ("at.csv", "every.csv"))
    assert at["time [s]"].tolist() == [0.25, 0.5, 0.75, 1.0, 1.25]
    for head, values in at.items():
        np.testing.assert_allclose(values, every[head][1:6], rtol=1e-9, atol=1e-9 * np.max(np.abs(every[head])))
    output = typed("start", "tilting_table", "--at", "0.5").output
    assert re.search(r"0\.5 s +17\.11", output)


@pytest.mark.parametrize(
    ("machine", "times", "said"),
    [
        ("tilting_table", "99", "--at 99.000 s: must be at most 4.912 s, when it ends"),
        ("high_slip_press", "99", "must be at most"),
        ("tilting_table", "-1", "--at = -1: must be times in seconds from 0 on, such as 0.5 or 0,0.1..2"),
        ("tilting_table", "soon", "must be times in seconds"),
        ("tilting_table", "1e400", "must be times in seconds"),
    ],
)
def test_times_that_cannot_be(typed, machine, times, said):
    assert said in " ".join(typed("start", machine, "--at", times).errors.split())
