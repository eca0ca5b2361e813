"""`textbook --forces` as typed."""

import pytest
from tests.sentences import TEXTBOOK_WITHOUT_FILE

import cranktrain as ct
from cranktrain.plans.force_table import force_table

HEADINGS = (
    "Forces of piston 2L by the reactions in the joints, over its area of 176.71 cm²",
    "The same by the textbook's P·f(β)",
    "Their errors, of the exact peaks",
)
LETTERS = ["P", "N", "S", "S_A", "K", "T", "M"]


def test_table(typed):
    answer = typed("textbook", "3d12", "--forces", "kgf/cm2", "--step", "10", "--piston", "2L", "--full")
    assert (answer.status, answer.errors) == (0, "")
    lines = answer.output.splitlines()
    assert all(len(line) <= 80 for line in lines)
    starts = [lines.index(heading) for heading in HEADINGS]
    assert [lines[start + 1].split() for start in starts] == [LETTERS] * 2 + [[f"Δ{one}" for one in LETTERS]]
    assert lines[starts[0] + 2].split() == ["kgf/cm²"] * 6 + ["kgf·m"]
    rows = [line.replace("−", "-").split() for line in lines[starts[0] + 3 : starts[0] + 75]]
    assert [row[0] for row in rows] == [f"{angle}°" for angle in range(0, 720, 10)]
    table = force_table(ct.load("3d12"), step=10.0, unit="kgf/cm2", piston="2L")
    for place, one in enumerate(table.columns):
        digits = len(rows[0][1 + place].partition(".")[2])
        assert [float(row[1 + place]) for row in rows] == pytest.approx(one.exact, abs=0.51 * 10.0**-digits)


def test_offset_mechanisms_have_two_harmonics_too(typed):
    lines = typed("textbook", "vaz_21213", "--forces", "N", "--full").output.splitlines()
    at = lines.index("The same by two harmonics of inertia")
    assert lines[at + 3].split()[0] == "0°"
    assert "NaN" not in "".join(lines)


def test_a_slaves_table_says_whose_pin_it_shares(typed):
    answer = typed("textbook", "3d12", "--forces", "kN", "--piston", "1R")
    assert (answer.status, answer.errors) == (0, "")
    assert "nan" not in answer.output
    assert "textbook's P·f(β)" not in answer.output
    assert "its share of what its master's crank pin bears" in " ".join(answer.output.split())


def test_a_rod_that_is_two_masses_needs_no_second_table(typed):
    lines = typed("textbook", "deltic", "--forces", "kN", "--full").output.splitlines()
    assert lines[lines.index(HEADINGS[1]) + 1].startswith("  The same: this rod is as two masses")


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["--forces", "N"], f"{TEXTBOOK_WITHOUT_FILE}; such as: cranktrain textbook 3d12 --forces N"),
        (["3d12", "--step", "10"], "--step = 10: is for tables of forces: ask for --forces UNIT, too"),
        (
            ["3d12", "--forces", "N", "--piston", "1l"],
            '--piston = 1l: must be one of: 1L, 2L, 3L, 4L, 5L, 6L, 1R, 2R, 3R, 4R, 5R, 6R; write "1L"',
        ),
        (
            ["textbook_78x78", "--forces", "N"],
            "example textbook_78x78:1:1  masses: is missing, and [gas] too: nothing acts on the links",
        ),
    ],
)
def test_what_is_refused(typed, arguments, said):
    answer = typed("textbook", *arguments)
    assert (answer.status, answer.output) == (2, "")
    assert answer.errors.splitlines() == [said]
