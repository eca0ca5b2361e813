"""`textbook --drive`: (1) to (21) of a crank-rocker's drive as typed, of a table and of a machine, and mistakes."""

import csv
import math
import re
from decimal import Decimal
from itertools import pairwise

import numpy as np
import pytest
from tests.sentences import ENDS_IN

import cranktrain as ct
from cranktrain.textbook.drive_statements import PEAKS

LINKS = 'r = "250 mm"\nl = "700 mm"\nr1 = "500 mm"\nd = "800 mm"\n'
DRIVE = 'i = 40\neta_p = 0.94\neta_sh = 0.9\nQ = "4 kN"\nGD2_0 = "2.4 kgf*m^2"\nGD2_O1 = "200 kgf*m^2"\n'
OF_MACHINE = ("--set=i=40", "--set=eta_p=0.94", "--set=eta_sh=0.9", "--set=GD2_0=2.4 kg*m^2")


def rows(output, number):
    """Of each row of a formula: verdict, at α, peaks with angles, mean, rms."""
    over = output.splitlines()[output.splitlines().index("Over a turn") :]
    return [
        [below.strip().partition(":")[0], *line.split()[1:]]
        for line, below in pairwise(over)
        if line.startswith(f"  {number} ")
    ]


def test_example(typed):
    answer = typed("textbook", "--drive", "example", "--full")
    assert (answer.status, answer.errors) == (0, "")
    assert all(len(line) <= 80 for line in answer.output.splitlines())
    active, same, dry, printed, refuted = rows(answer.output, "(14)")
    assert active == ["right", "18.56", "29.86", "112.8°", "−24.981", "334.4°", "2.9226", "19.053", "734.5"]
    assert same == ["right", "18.56", "29.86", "112.8°", "−25.397", "334.4°", "2.8069", "19.165", "705.4"]
    assert dry[2:] == ["29.86", "112.8°", "35.485", "334.4°", "19.747", "22.204", "4963.0"]
    assert printed[2:] == ["29.86", "112.8°", "−35.485", "334.4°", "0", "22.204", "0.0"]
    assert refuted[2:6] == ["29.377", "105.2°", "−25.494", "317.0°"]
    moments = rows(answer.output, "(20)")
    assert [row[2] for row in moments] == ["2.4319", "2.4463", "3.9086", "2.4311"]
    assert [row[4] for row in moments] == ["2.4451", "2.4609", "4.5305", "2.373"]
    said = re.sub(r"\s+", " ", answer.output)
    for words in ("220.4 J", "47.28 times", "0.922276", "0.916161", "214.622–218.050°", "59.1 N·m", "31.7525°"):
        assert words in said


def test_machine_has_the_same_numbers_as_the_table(typed):
    """The example tilting_table is the drive of the table; only its idle torque is Q r₁."""
    table = typed("textbook", "--drive", "example", "--set", "M_xx0=2000 N*m", "--full").output
    machine = typed("textbook", "--drive", "tilting_table", *OF_MACHINE, "--full").output
    for number in ("(4)", "(14)", "(20)", "(21)"):
        assert rows(machine, number) == rows(table, number)


def test_curves_are_written(typed, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert typed("textbook", "--drive", "example", "-o", "drive.csv").output == "written: drive.csv\n"
    with (tmp_path / "drive.csv").open(encoding="utf-8", newline="") as file:
        read = list(csv.reader(file))
    assert len(read) == 362
    assert read[1][0] == "0"
    column = next(i for i, head in enumerate(read[0]) if head.startswith("(14) M_st right") and "active" in head)
    assert float(read[61][column]) == pytest.approx(18.560, abs=5e-4)


def test_table_is_written_and_read_again(typed, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert typed("textbook", "--drive", "example", "--set", "i=20", "-o", "drive.toml").status == 0
    again = typed("textbook", "--drive", "drive.toml", "--full").output
    assert again == typed("textbook", "--drive", "example", "--set", "i=20", "--full").output
    assert typed("textbook", "--drive", "tilting_table", *OF_MACHINE, "-o", "other.toml").status == 2


@pytest.mark.parametrize(
    ("change", "said"),
    [
        (("r", "900 mm"), "must be a crank-rocker"),
        (("eta_p", "1.2"), "eta_p"),
        (("i", "0"), "i = 0: "),
        (("GD2_0", "-1 kgf*m^2"), "must not be less than 0"),
        (("m", "10 kg"), "is missing; m has it"),
        (("I", "1 kg*m^2"), "must be left out without m"),
        (("f", "0.1"), "is missing, with r_B, r_A, r_O1"),
        (("speed", "3 rpm"), "speed"),
    ],
)
def test_mistakes_in_a_table(typed, written, change, said):
    written(LINKS + DRIVE, "drive.toml")
    assert typed("textbook", "--drive", "drive.toml").status == 0
    wrong = typed("textbook", "--drive", "drive.toml", "--set", "=".join(change))
    assert wrong.status == 2
    assert said in wrong.errors


@pytest.mark.parametrize(
    ("options", "said"),
    [
        (["--drive", "tilting_table", "--at", "nan"], "'--at': nan must be a number of degrees"),
        (["--drive", "example", "--table"], "must be left out beside --drive"),
        (["--drive", "example", "--throw", "example"], "must be left out beside --drive"),
        (["--drive", "example", "-o", "drive.docx"], ENDS_IN),
        (["--drive", "vaz_21213"], "must have a crank-rocker"),
        (["--drive", "pumping_unit_c57", *OF_MACHINE], "  load: must have a torque on the rocker"),
        (["--drive", " "], "must be a file with a drive's table"),
        (["tilting_table", "--at", "20"], "is for a throw or a drive: ask for --throw FILE or --drive FILE, too"),
        (["--drive", "example", "--set", "Q"], "must be SYMBOL=VALUE"),
    ],
)
def test_mistakes(typed, options, said):
    wrong = typed("textbook", *options)
    assert wrong.status == 2
    assert said in wrong.errors


def test_without_pins_there_is_no_friction(typed, written):
    written(LINKS + DRIVE, "drive.toml")
    assert (
        "No pins are given: f with r_O, r_B, r_A, r_O1." in typed("textbook", "--drive", "drive.toml", "--full").output
    )


def table_rows(output):
    """Of each formula over a turn, its verdict and name, the cells as written, of tables one below another too."""
    found = {}
    lines = output.splitlines()
    for line, below in pairwise(lines[lines.index("Over a turn") :]):
        number, *cells = line.split() or [""]
        if number.startswith("(") and ": " in below:
            found.setdefault((number, *below.strip().split(": ", 1)), []).extend(cells)
    return found


def is_written(cell, value):
    """Whether a cell is a number to its last figure."""
    written = Decimal(cell.replace("−", "-").rstrip("°"))
    return abs(float(written) - value) <= 0.51 * 10.0 ** written.as_tuple().exponent


UNITS = {"Q": " N", "M_xx0": " N*m", "GD2_0": " kg*m^2", "GD2_O1": " kg*m^2", "i": "", "m": " kg"}


@pytest.mark.parametrize("symbols", [tuple(UNITS), ("Q",), ("i",)], ids=" ".join)
@pytest.mark.parametrize("power", range(-3, 7, 3))
def test_every_number_of_a_turn_is_shown_whole(typed, symbols, power):
    """However wide the numbers are, what stands on the screen is the record, to the last figure shown."""
    values = {one: f"{'-' if one == 'Q' else ''}{1.2345 * 10.0**power:.8g}{UNITS[one]}" for one in symbols}
    options = [word for symbol, value in values.items() for word in ("--set", f"{symbol}={value}")]
    answer = typed("textbook", "--drive", "example", *options, "--full")
    assert (answer.status, answer.errors) == (0, "")
    assert max(map(len, answer.output.splitlines())) <= 80
    shown, records = table_rows(answer.output), ct.textbook.drive(set=values)
    curves = [one for one in records.over_turn if one.verdict != "beyond"]
    assert set(shown) == {(one.equation, one.verdict, one.name) for one in curves}
    for (equation, _verdict, name), cells in shown.items():
        own = [one for one in records if (one.equation, one.name) == (equation, name)]
        expected = []
        for one in own:
            expected += (
                [one.value, one.crank_angle] if one.at in PEAKS and np.isfinite(one.crank_angle) else [one.value]
            )
        assert len(cells) == len(expected)
        assert [*map(is_written, cells, expected)] == [True] * len(cells), (cells, expected)


PUMPING = ("--set=i=40", "--set=eta_p=0.94", "--set=Q=4 kN", "--set=GD2_0=2 kg*m^2", "--set=GD2_O1=200 kg*m^2")


def test_what_a_machine_lacks_is_asked_for_and_what_is_taken_is_shown(typed):
    without = typed("textbook", "--drive", "pumping_unit_c57", *PUMPING)
    assert without.status == 2
    assert "or --set eta_sh=0.9" in without.errors
    shown = typed("textbook", "--drive", "pumping_unit_c57", *PUMPING, "--set=eta_sh=0.8").output
    assert re.search(r"i = 40, η_p = 0\.94, η_ш = 0\.8; Q = 4000\.0 N", shown)
    assert re.search(r"\(GD²\)₀ =\s+2\.000 kg·m², of what is driven\s+GD² = 200\.000 kg·m²", shown)
    assert len(shown.splitlines()) <= 45


def test_masses_have_a_row_where_there_are_some(typed):
    of_masses = "rod and crank with their masses"
    assert of_masses in typed("textbook", "--drive", "example").output
    assert of_masses not in typed("textbook", "--drive", "pumping_unit_c57", *PUMPING, "--set=eta_sh=0.8").output


@pytest.mark.parametrize(
    ("sense", "said"), [("active", "the first row is its own"), ("resisting", "dry friction is its")]
)
def test_screen_says_which_row_is_the_machines(typed, sense, said):
    shown = typed("textbook", "--drive", "tilting_table", "--set", f"load.table.sense={sense}").output
    assert said in re.sub(r"\s+", " ", shown)


def test_friction_circles_have_the_load_as_a_couple_on_the_rockers_shaft(typed):
    """By an equilibrium of rod, rocker and crank at α = 0, in which a force at A, not a couple, presses on O₁."""
    rubbing = next(one for one in ct.textbook.drive().over_turn if one.verdict == "beyond")
    assert rubbing.values[0] == pytest.approx(_torque_at_zero(with_force_at_a=False), rel=1e-9)
    assert _torque_at_zero(with_force_at_a=True) == pytest.approx(-844.6367, abs=1e-4)
    assert "torque Q r₁ on the rocker's shaft" in re.sub(
        r"\s+", " ", typed("textbook", "--drive", "example", "--full").output
    )


def _torque_at_zero(*, with_force_at_a):
    """Crank torque of the example's rubbing pins at α = 0, from the joints' places: circles of ρ = R sin(atan f)."""
    r, l, r1, d, load = 0.25, 0.7, 0.5, 0.8, 4000.0
    pin_o, pin_b, _pin_a, pin_1 = (size * math.sin(math.atan(0.08)) for size in (0.07, 0.05, 0.05, 0.06))
    span = d - r  # from B, on the line of the pivots, to O₁
    along = (l * l - r1 * r1 + span * span) / (2 * span)
    a = np.array([r + along, math.sqrt(l * l - along * along)])
    b, o1 = np.array([r, 0.0]), np.array([d, 0.0])
    rocker, rod = (a - o1) / r1, (a - b) / l
    # With the crank on the line of the pivots the rocker turns as the crank does by −r/(d − r), and so does the rod.
    turning = -r / span
    sense_b, sense_1 = np.sign(turning - 1), np.sign(turning)  # A stands
    tilt = pin_b * sense_b / l
    cosine = math.sqrt(1 - tilt * tilt)
    across = np.array([-rod[1], rod[0]])
    force_at_a = -load * np.array([-rocker[1], rocker[0]]) * with_force_at_a
    for sign in (1, -1):
        unit = sign * cosine * rod - tilt * across
        arm = r1 * (rocker[0] * unit[1] - rocker[1] * unit[0])
        size = load * r1 / arm
        for _round in range(60):
            size = (load * r1 + pin_1 * sense_1 * np.hypot(*(size * unit + force_at_a))) / arm
        if size > 0:
            return size * (b[0] * unit[1] - b[1] * unit[0] - pin_b * sense_b + pin_o)
    raise AssertionError


def test_without_friction_nothing_is_said_of_locked_pins(typed):
    said = re.sub(r"\s+", " ", typed("textbook", "--drive", "example", "--set", "f=0", "--full").output)
    assert "The pins have no friction: f or all their radii are 0." in said
    assert "cannot drive" not in said
    assert "beyond" not in {one.verdict for one in ct.textbook.drive(set={"f": 0}).over_turn}
