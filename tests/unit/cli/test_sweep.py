"""`sweep`: facts over values of the file, and mistakes of who asks for them."""

import csv
import tomllib

import openpyxl
import pytest
from PIL import Image
from tests.sentences import ENDS_IN, FOLDER_NOT_THERE, NO_FILE, WHOLE_NUMBER

SMALL = (
    "# a pump\n"
    '[shaft.main]\nspeed = "1500 rpm"\n'
    '[mechanism]\nkind = "slider_crank"\nstroke = "80 mm"\nrod_length = "136 mm" # of steel\n'
)
RODS = ("--vary", "rod_length=30..150 mm:5", "--wanted", "stroke,mean_piston_speed")


@pytest.fixture
def pump(written):
    written(SMALL, "pump.toml")
    return "pump.toml"


def test_a_line_for_each_value(typed, pump):
    answer = typed("sweep", pump, *RODS)
    assert (answer.status, answer.errors) == (0, "")
    lines = [line.split() for line in answer.output.splitlines()]
    assert ["30", "mm", "–", "–"] in lines  # the rod is shorter than the crank
    assert ["60", "mm", "80.00", "4.000"] in lines  # 2 S n
    assert "1 of 5 designs cannot be: mechanism.rod_length = 30 mm" in answer.output
    assert max(map(len, answer.output.splitlines())) <= 80


def test_the_best_design_is_written_with_its_comments(typed, pump, tmp_path):
    answer = typed("sweep", pump, *RODS, "--least", "closing_margin", "--save", "best.toml")
    assert answer.status == 0
    text = (tmp_path / "best.toml").read_text(encoding="utf-8")
    assert tomllib.loads(text)["mechanism"]["rod_length"] == "60 mm"
    assert text.startswith("# a pump\n")
    assert "Least closing margin" in answer.output
    assert "at mechanism.rod_length = 60 mm" in answer.output


def test_files(typed, pump, tmp_path):
    assert typed("sweep", pump, *RODS, "--vary", "speed=1000, 2000 rpm", "-o", "rods.csv").status == 0
    lines = [line for line in (tmp_path / "rods.csv").read_text(encoding="utf-8").splitlines() if line[0] != "#"]
    rows = list(csv.DictReader(lines))
    assert [float(row["rod_length [mm]"]) for row in rows] == [30, 60, 90, 120, 150]
    assert float(rows[1]["mean_piston_speed(2000 rpm 1) [m/s]"]) == pytest.approx(16 / 3, rel=1e-14)
    for name in ("rods.xlsx", "rods.json", "rods.nc"):
        assert typed("sweep", pump, *RODS, "-o", name).status == 0
        assert (tmp_path / name).stat().st_size > 500


@pytest.mark.parametrize("vary", [(), ("--vary", "speed=1000, 2000 rpm"), ("--vary", "speed=1000..2000 rpm:8")])
def test_pictures(typed, pump, tmp_path, vary):
    """A curve, a family, a map."""
    over = ("--vary", "rod_length=30..150 mm:9", "--wanted", "largest_piston_speed")
    assert typed("sweep", pump, *over, *vary, "-o", "rods.png").status == 0
    with Image.open(tmp_path / "rods.png") as image:
        assert min(image.size) > 300


def test_designs_of_a_list(typed, pump, written):
    written("rod_length [mm];speed\n120;3000 rpm\n# two more\n;750 rpm\n10;\n", "cases.csv")
    answer = typed("sweep", pump, "--cases", "cases.csv", "--wanted", "mean_piston_speed")
    lines = [line.split() for line in answer.output.splitlines()]
    assert ["1", "120", "mm", "3000", "rpm", "8.000"] in lines
    assert ["2", "750", "rpm", "2.000"] in lines
    assert "1 of 3 designs cannot be" in answer.output


@pytest.mark.parametrize(
    "text",
    [
        "rod_length [mm];speed\n120,5;1500,25 rpm\n−120,5;\n",
        "rod_length [mm]\tspeed\n120,5\t1500,25 rpm\n−120,5\t\n",
        "\ufeffrod_length;speed [rpm]\n120,5 mm;1500,25\n−120,5 mm;\n",
        "# of a spreadsheet\nrod_length [mm],speed\n120.5,1500.25 rpm\n−120.5,\n",
        "rod_length[mm],speed[rpm],,\n120.5,1500.25,,\n−120.5,,,\n",
    ],
    ids=["semicolons", "tabs", "units in cells", "points", "no blanks, and empty columns behind"],
)
def test_designs_of_a_spreadsheet(typed, pump, written, text):
    """Where commas do not divide columns they divide decimals, as in curve files."""
    written(text, "cases.csv")
    answer = typed("sweep", pump, "--cases", "cases.csv", "--wanted", "mean_piston_speed")
    assert answer.errors == ""
    assert ["1", "120.5", "mm", "1500.25", "rpm", "4.001"] in [line.split() for line in answer.output.splitlines()]
    assert "1 of 2 designs cannot be" in answer.output


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (
            'rod_length [mm],speed\n"120,5",1500 rpm\n',
            "cases.csv:2  rod_length = 120,5: has a comma in a number, and commas divide the columns here;"
            ' write "120.5"',
        ),
        (
            "rod_length [mm],speed\n120,5,1500 rpm\n",
            "cases.csv:2  120,5,1500 rpm: has 3 values, and 2 columns have a head; where a comma divides decimals,"
            " divide the columns by semicolons",
        ),
        (
            "# a list\nrod_lenght [mm],speed\n120,1500 rpm\n",
            "cases.csv:2  rod_lenght: is no key of this machine's file; did you mean rod_length?",
        ),
        (
            "rod_length (mm),speed\n120,1500 rpm\n",
            'cases.csv:1  rod_length (mm): has its unit in round brackets; write "rod_length [mm]"',
        ),
        (
            "rod_length [mm],speed\n120\n",
            "cases.csv:2  120: has 1 values, and 2 columns have a head; a cell may be empty, between its separators:"
            " then the machine file's value stays",
        ),
        (
            "rod_length [mm],,speed\n120,A,1500 rpm\n",
            "cases.csv:1  column 2 has no head; write the path of what stands below it",
        ),
        (
            "rod_length [mm],speed\n",
            "cases.csv  has no design: needs paths at the heads of columns, and a line below for each design;"
            " write like rod_length [mm],speed [rpm], and below 130,1500",
        ),
        (
            "mechanism\n{kind = scotch_yoke}\n",
            "cases.csv:2  mechanism = {kind = scotch_yoke}: must be a table or a list as TOML has it, in one line",
        ),
    ],
)
def test_mistakes_in_a_list(typed, pump, written, text, said):
    written(text, "cases.csv")
    answer = typed("sweep", pump, "--cases", "cases.csv", "--wanted", "mean_piston_speed")
    assert (answer.status, answer.errors, answer.output) == (2, said + "\n", "")


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["pump.toml"], "needs either --vary PATH=VALUES or --cases FILE"),
        (["pump.toml", "--vary", "rod_length"], "must be PATH=VALUES"),
        (["pump.toml", "--vary", "rod_lenght=1..2 mm"], "did you mean rod_length?"),
        (["pump.toml", "--vary", "rod_length=1 kg, 2 kg"], "kg measures a mass"),
        (["pump.toml", "--vary", "rod_length=1..2 mm"], "the links cannot close"),
        (["pump.toml", "--vary", "rod_length=60..2 km:1"], "at least 2 values"),
        (["pump.toml", *RODS, "--vary", "rod_length=1 mm"], "is varied twice"),
        (["pump.toml", "--vary", "rod_length=60..70 mm", "--wanted", "piston_velocity"], "is a curve"),
        (["pump.toml", "--vary", "rod_length=60..70 mm", "--wanted", "strok"], "did you mean stroke?"),
        (["pump.toml", "--vary", "rod_length=60..70 mm", "--wanted", "gas_pressure"], "needs"),
        (["pump.toml", *RODS, "--least", "strok"], "did you mean stroke?"),
        (["pump.toml", *RODS, "--least", "stroke", "--most", "stroke"], "does not go with --least"),
        (["pump.toml", *RODS, "--save", "best.toml"], "needs --least FACT or --most FACT"),
        (["pump.toml", *RODS, "--processes", "0"], f"{WHOLE_NUMBER} from 1"),
        (["pump.toml", *RODS, "-o", "rods.txt"], ENDS_IN),
        (["pump.toml", *RODS, "--resume"], "--resume: needs a store; write -o NAME.zarr"),
        (["pump.toml", *RODS, "-o", "rods.zarr", "--units", "in"], "is not for a store, whose numbers are in SI"),
        (["pump.toml", *RODS, "--processes", "2", "--scheduler", "x"], "does not go with --processes"),
        (
            ["pump.toml", *RODS, "--set", "mechanism.rod_length=150 mm"],
            "--vary  mechanism.rod_length: is set and varied",
        ),
        (["pum.toml", *RODS], NO_FILE),
        (["pump.toml", "--cases", "none.csv"], NO_FILE),
        (
            ["pump.toml", "--vary", "rod_length=60..70 mm:1000", "--vary", "speed=1..2 rpm:90000"],
            "may be 10000000; ask for",
        ),
        (["pump.toml", "--vary", f"rod_length=60..70 mm:{10**15}"], "has more values than any range may have, 1000000"),
        (
            ["pump.toml", "--vary", "rotation=clockwise, anticlockwise", "--wanted", "stroke", "-o", "x.png"],
            "needs a number that is varied",
        ),
    ],
)
def test_mistakes(typed, pump, tmp_path, arguments, said):
    answer = typed("sweep", *arguments)
    assert answer.status == 2
    assert said in answer.errors
    assert answer.output == ""
    assert [path.name for path in tmp_path.iterdir()] == [pump]


@pytest.mark.parametrize(
    "options", [["-o", "no/a.csv"], ["-o", "no/a.png"], ["-o", "no/a.zarr"], ["--save", "no/a.toml"]]
)
def test_what_cannot_be_written_is_refused_before_it_is_computed(typed, pump, tmp_path, options):
    """None of these rods can be, which is found when they are computed."""
    answer = typed("sweep", pump, "--vary", "rod_length=1..2 mm:3", "--least", "stroke", *options)
    assert (answer.status, answer.output) == (2, "")
    assert answer.errors == f"{options[-1]}  {FOLDER_NOT_THERE}; make it first, or name another\n"
    assert [path.name for path in tmp_path.iterdir()] == [pump]


def test_a_file_that_is_there_is_refused_before_it_is_computed(typed, pump, written):
    written("", "a.csv")
    answer = typed("sweep", pump, "--vary", "rod_length=1..2 mm:3", "-o", "a.csv")
    assert answer.errors.startswith("a.csv  is there already")
    answer = typed("sweep", pump, "--vary", "rod_length=1..2 mm:3", "--least", "stroke", "--save", "a.txt")
    assert "must end in .toml: it is a machine file" in answer.errors


@pytest.mark.parametrize(
    "vary",
    [
        ["--vary", "rod_length=30..150 mm:5"],
        ["--vary", "rod_length=30..150 mm:5", "--decimal", "comma"],
        ["--vary", "stroke=70,5; 80,5 mm"],
        ["--vary", "rotation=clockwise, anticlockwise", "--vary", "name=A, B"],
        ["--cases", "cases.csv"],
    ],
    ids=" ".join,
)
def test_a_file_of_a_sweep_may_be_its_list(typed, pump, written, tmp_path, vary):
    """The same designs have the same facts, one by one."""
    written("name;rod_length [mm];cylinder.compression_ratio\nA;140,5;9\nB;150;10\n", "cases.csv")
    wanted = ("--wanted", "stroke,mean_piston_speed")
    assert typed("sweep", pump, *vary, *wanted, "-o", "one.csv").status == 0
    assert typed("sweep", pump, "--cases", "one.csv", *wanted, "-o", "other.csv").errors == ""
    text = (tmp_path / "one.csv").read_text(encoding="utf-8-sig")
    (tmp_path / "one.csv").write_text(text.replace(",", ".").replace(";", ",") if "--decimal" in vary else text)
    one, other = (_rows(tmp_path / name) for name in ("one.csv", "other.csv"))
    assert [each["mean_piston_speed(1) [m/s]"] for each in other] == [
        each["mean_piston_speed(1) [m/s]"] for each in one
    ]


def test_designs_side_by_side_are_no_list(typed, pump):
    assert typed("sweep", pump, *RODS, "--vary", "speed=1000, 2000 rpm", "-o", "one.csv").status == 0
    answer = typed("sweep", pump, "--cases", "one.csv")
    assert answer.errors == (
        "one.csv  has the facts of several designs side by side, as it was written of values that were combined;"
        " vary them again, with --vary\n"
    )


def test_plain_numbers_of_a_list_have_their_unit(typed, pump, written, tmp_path):
    written("rod_length [mm],cylinder.compression_ratio [1]\n120,9\n130,10.5\n", "cases.csv")
    assert typed("sweep", pump, "--cases", "cases.csv", "--wanted", "stroke", "-o", "out.csv").errors == ""
    rows = _rows(tmp_path / "out.csv")
    assert [float(row["compression_ratio [1]"]) for row in rows] == [9, 10.5]


def test_what_takes_long_has_to_be_meant(typed, pump, monkeypatch):
    """It is told as soon as it is known how long a design takes, which some are computed for."""
    from cranktrain.study.sweep import computed

    monkeypatch.setattr(computed, "_LONG", 0.0)
    monkeypatch.setattr(computed, "_MEASURED", 1e-9)
    answer = typed("sweep", pump, *RODS, "--vary", "speed=1..9 rpm:41")
    assert answer.status == 2
    assert "is 205 designs, which take some" in answer.errors
    assert typed("sweep", pump, *RODS, "--vary", "speed=1..9 rpm:41", "--yes").status == 0


def test_rows_and_columns_without_room_are_told(typed, pump):
    """31 values in even steps on 24 lines at most, 5 of 11 speeds; what all designs share stands in a sentence."""
    over = ("--vary", "rod_length=60..150 mm:31", "--vary", "speed=1000..2000 rpm:11")
    answer = typed("sweep", pump, *over, "--wanted", "stroke,mean_piston_speed")
    lines = answer.output.splitlines()
    shown = [line.split()[0] for line in lines if line.startswith("  ") and line.split()[1:2] == ["mm"]]
    assert list(dict.fromkeys(shown)) == [str(rod) for rod in range(60, 151, 6)]
    assert "alike in all designs: stroke 80.00 mm" in answer.output
    assert "shown are 16 of 31 values of rod length; a file has all" in answer.output
    assert "shown are 5 of 11 values of speed; a file has all" in answer.output
    assert "  c_m mean_piston_speed" in lines


def test_facts_without_room_are_told(typed):
    answer = typed("sweep", "vaz_21213", "--vary", "rod_length=120..150 mm:3")
    assert "no room here for shaking_force_largest, largest_bearing_load" in " ".join(answer.output.split())
    assert answer.output.count("\n") < 60
    answer = typed("sweep", "vaz_21213", "--vary", "rod_length=120..150 mm:3", "--wanted", "largest_bearing_load")
    assert "no room" not in answer.output


def test_plain_numbers_at_the_head_of_a_column_are_told(typed):
    vary = ("--vary", "rod_length=120..150 mm:3", "--vary", "compression_ratio=9, 10")
    answer = typed("sweep", "vaz_21213", *vary, "--wanted", "largest_torque")
    assert "T_max 9  T_max 10" in answer.output
    assert "behind each symbol: compression ratio" in answer.output


@pytest.mark.parametrize("suffix", [".csv", ".xlsx"])
def test_a_file_of_a_list_has_a_row_for_each_design(typed, pump, written, tmp_path, suffix):
    written("name,rod_length [mm],speed\nA,120,3000 rpm\nB,130,\nC,10,\n", "cases.csv")
    asked = ("--cases", "cases.csv", "--wanted", "mean_piston_speed")
    assert typed("sweep", pump, *asked, "-o", f"out{suffix}").status == 0
    rows = _rows(tmp_path / f"out{suffix}")
    heads = ["case", "name", "rod_length [mm]", "speed", "refused", "mean_piston_speed(1) [m/s]"]
    assert list(rows[0]) == heads
    assert [row["name"] for row in rows] == ["A", "B", "C"]
    assert [float(row["rod_length [mm]"]) for row in rows] == [120, 130, 10]
    assert [float(row["mean_piston_speed(1) [m/s]"]) for row in rows[:2]] == pytest.approx([8, 4], rel=1e-14)  # 2 S n
    assert "mechanism.rod_length = 10 mm" in rows[2]["refused"]
    assert not rows[0]["refused"]


def test_a_file_of_words_has_a_row_for_each_combination(typed, pump, tmp_path):
    vary = ("--vary", "rotation=clockwise, anticlockwise", "--vary", "name=A, B")
    assert typed("sweep", pump, *vary, "--wanted", "stroke", "-o", "out.csv").status == 0
    rows = _rows(tmp_path / "out.csv")
    assert [(row["rotation"], row["name"]) for row in rows] == [
        *(("clockwise", "A"), ("clockwise", "B"), ("anticlockwise", "A"), ("anticlockwise", "B"))
    ]
    assert [float(row["stroke(1) [m]"]) for row in rows] == pytest.approx([0.08] * 4, rel=1e-14)


def test_a_table_in_a_cell(typed, pump, written):
    """Mechanisms of two kinds, each with its own keys; the largest speed of a yoke is R ω."""
    yoke, rod = '{kind="scotch_yoke",crank_radius="40 mm"}', '{kind="slider_crank",stroke="80 mm",rod_length="1000 m"}'
    written(f"name;mechanism\nA;{yoke}\nB;{rod}\n".replace('"', '""').replace(";{", ';"{').replace("}", '}"'), "c.csv")
    answer = typed("sweep", pump, "--cases", "c.csv", "--wanted", "largest_piston_speed")
    assert answer.errors == ""
    assert answer.output.count("6.283") == 2  # 0.04 m · 1500 rpm · 2π
    assert max(map(len, answer.output.splitlines())) <= 80


def _rows(path):
    """Rows of a file by their heads."""
    if path.suffix == ".csv":
        lines = [line for line in path.read_text(encoding="utf-8").splitlines() if line[0] != "#"]
        return list(csv.DictReader(lines))
    sheet = openpyxl.load_workbook(path)["designs"]
    heads, *rows = sheet.iter_rows(values_only=True)
    return [dict(zip(heads, row, strict=True)) for row in rows]
