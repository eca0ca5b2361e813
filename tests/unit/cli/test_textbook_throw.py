"""`textbook --throw`: (44) to (53) as typed, against the reference case, its table and scheme, and mistakes."""

import re

import pytest
from tests.reference_case import ReferenceCase
from tests.sentences import ENDS_IN, NOT_A_KEY

CASE = ReferenceCase.load("formulas_44_53")
EXPECTED = {name: one["value"] for name, one in CASE.document["expected_values"].items()}
ONE = """
l1 = "14 mm"
hL = "22 mm"
l2 = "15 mm"
l5 = "15 mm"
hP = "22 mm"
l6 = "14 mm"
"""


def row(output, head):
    (found,) = re.findall(rf"^  {re.escape(head)} +(.*)$", output, re.MULTILINE)
    return [float(cell) for cell in found.replace("−", "-").split()]


def test_all_sixteen(typed):
    answer = typed("textbook", "--throw", "example")
    assert (answer.status, answer.errors) == (0, "")
    assert all(len(line) <= 80 for line in answer.output.splitlines())
    for head, numbers in (
        ("rotating masses (44) (45) (46) (47)", ("44 KCP", "45 TCP", "46 KCL", "47 TCL")),
        ("left external counterweight (48)", ("48 KP", "48 TP", "48 KL", "48 TL")),
        ("right external counterweight (49)", ("49 KP", "49 TP", "49 KL", "49 TL")),
        ("K of the rods (50) (52)", ("50 KP", None, "52 KL", None)),
        ("T of the rods (51) (53)", (None, "51 TP", None, "53 TL")),
    ):
        wanted = [0.0 if number is None else EXPECTED[number] for number in numbers]
        assert row(answer.output, head) == pytest.approx(wanted, abs=0.0501)
    parts = [value for number, value in EXPECTED.items() if number.endswith(("KP", "KCP"))]
    assert row(answer.output, "together")[0] == pytest.approx(sum(parts), abs=0.0501)
    assert "= 131.00 mm" in answer.output


def test_set_and_sums(typed):
    """K1 alone on a symmetric throw: half on each side; an articulated pair likewise."""
    changes = [f"--set={name}=0 N" for name in ("C8", "C14", "C9", "C15", "C10", "C12", "T1", "T2", "K2")]
    output = typed("textbook", "--throw", "example", *changes, "--set", "K1=13.1 kN").output
    assert row(output, "K of the rods (50) (52)") == pytest.approx([13100 * 51 / 131, 0, 13100 * 80 / 131, 0])
    assert row(output, "T of the rods (51) (53)") == [0.0] * 4


@pytest.mark.parametrize(
    ("forces", "said"),
    [
        ('C4 = "4 kN"\nC1 = "2 kN"\nC7 = "2 kN"\n', "Both hold: the rotating masses load no bearing."),
        ('C4 = "4 kN"\nC1 = "4 kN"\n', "Static balance alone:"),
        ('C4 = "77 N"\nC7 = "51 N"\n', "The resultant passes through L:"),
        ('C4 = "4 kN"\n', "Neither holds:"),
    ],
)
def test_balance(typed, written, forces, said):
    written(ONE + forces, "throw.toml")
    assert said in typed("textbook", "--throw", "throw.toml", "--full").output


def test_articulated_pair(typed, written):
    written(ONE + 'rods = "articulated"\nK1 = "10 kN"\n', "throw.toml")
    output = typed("textbook", "--throw", "throw.toml").output
    assert "An articulated pair: one resultant K1, T1 on the master's axis, K2 = T2 = 0." in output
    assert row(output, "K of the rods (50) (52)") == [5000.0, 0.0, 5000.0, 0.0]


def test_its_table_is_written_and_read_again(typed, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    written = typed("textbook", "--throw", "example", "--set", "K1=1 kN", "-o", "throw.toml")
    assert written == (0, "written: throw.toml\n", "")
    again = typed("textbook", "--throw", "throw.toml", "--full").output
    assert again == typed("textbook", "--throw", "example", "--set", "K1=1 kN", "--full").output
    assert typed("textbook", "--throw", "example", "-o", "throw.toml").status == 2
    assert typed("textbook", "--throw", "example", "-o", "throw.toml", "--force").status == 0


def test_scheme(typed, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert typed("textbook", "--throw", "example", "-o", "throw.svg") == (0, "written: throw.svg\n", "")
    assert (tmp_path / "throw.svg").read_text(encoding="utf-8").startswith("<?xml")


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["--throw", "example", "--set", "l=131 mm"], "--set  l = 131 mm: is no input: it is l1 + hL"),
        (["--throw", "example", "--set", "l7=1 mm"], "--set  l7 = 1 mm: occurs in none of (44) to (53)"),
        (["--throw", "example", "--set", "l1=-1 mm"], "--set  l1 = -1 mm: must be at least 0 mm"),
        (["--throw", "example", "--set", "K1"], "--set  K1: must be SYMBOL=VALUE"),
        (["--throw", "example", "--set", "h_p=1 mm"], f"--set  h_p = 1 mm: {NOT_A_KEY}"),
        (["--throw", "nothing.toml"], "nothing.toml"),
        (["--throw", ""], "must be a file with a throw's table, a machine file, or `example`"),
        (["--throw", "example", "-o", "throw.doc"], f"{ENDS_IN}.toml, .png, .svg, .pdf"),
        (["3d12", "--throw", "example"], "must be left out beside --throw"),
        (["--throw", "example", "--table", "--harmonics"], "--harmonics: must be left out beside --throw"),
        (["3d12", "-o", "throw.svg"], "is for a throw or a drive: ask for --throw FILE or --drive FILE, too"),
    ],
)
def test_mistakes(typed, tmp_path, monkeypatch, arguments, said):
    monkeypatch.chdir(tmp_path)
    answer = typed("textbook", *arguments)
    assert (answer.status, answer.output) == (2, "")
    assert said in answer.errors


@pytest.mark.parametrize(("text", "said"), [("", "no throw in it"), ('l1 = "1 mm"\nl1 = "2 mm"\n', "l1")])
def test_files_that_are_none(typed, written, text, said):
    written(text, "throw.toml")
    answer = typed("textbook", "--throw", "throw.toml")
    assert (answer.status, answer.output) == (2, "")
    assert "throw.toml" in answer.errors
    assert said in answer.errors


def test_problems_stand_at_their_lines(typed, written):
    written(ONE + 'K1 = "3 m"\nl = "102 mm"\n', "throw.toml")
    errors = typed("textbook", "--throw", "throw.toml").errors
    assert re.search(r"throw\.toml:8(:\d+)?  K1 = 3 m", errors)
    assert re.search(r"throw\.toml:9(:\d+)?  l = 102 mm: is no input", errors)


def test_throw_of_a_machine(typed):
    """The engine's own lengths, its rods, the split shaft beside the text, and the same over the cycle."""
    answer = typed("textbook", "--throw", "kamaz_740", "--throw-number", "3", "--at", "420")
    assert (answer.status, answer.errors) == (0, "")
    assert all(len(line) <= 80 for line in answer.output.splitlines())
    assert row(answer.output, "together") == row(answer.output, "split shaft")
    assert row(answer.output, "together") == pytest.approx([4123.2, -2403.9, 3032.1, -4181.5], abs=0.051)
    said = re.sub(r"\s+", " ", answer.output)
    for words in (
        "bearings 3 (L) and 4 (P)",
        "= 155.00 mm",
        "K1, T1: 3L; K2, T2: 3R",
        "Over the cycle, at whole degrees",
    ):
        assert words in said
    asked = ("textbook", "--throw", "kamaz_740", "--throw-number", "3", "--at", "420", "--table")
    on_a_screen, whole = typed(*asked).output, typed(*asked, "--full").output
    assert ("  660°  " in on_a_screen, "  690°  " in on_a_screen, "  690°  " in whole) == (True, False, True)
    assert "  660°  " not in answer.output


def test_loads_over_the_cycle_are_written(typed, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    asked = ("textbook", "--throw", "deltic", "--throw-number", "main.6")
    assert typed(*asked, "-o", "throw.csv").output == "written: throw.csv\n"
    heads, *lines = (tmp_path / "throw.csv").read_text(encoding="utf-8").splitlines()
    assert heads.count('"') == 2 * 9
    assert "(44) (49) (50) R_KP approximate: together [N]" in heads
    assert len(lines) == 360
    assert typed(*asked, "-o", "throw.svg").status == 0
    assert "<svg" in (tmp_path / "throw.svg").read_text(encoding="utf-8")
    again = typed(*asked, "-o", "throw.csv")
    assert (again.status, "--force" in again.errors) == (2, True)


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("kamaz_740", "--throw-number", "9"), "--throw-number = 9: must be the number of a throw: 1, 2, 3, 4"),
        (("kamaz_740", "--crank-masses", "x"), "--crank-masses = x: must be one of: given, sizes"),
        (("kamaz_740", "--at", "1e999"), "'--at': 1e999 must be a number of degrees"),
        (("kamaz_740", "-o", "t.toml"), f"{ENDS_IN}.csv, .json, .xlsx, .nc, .png, .svg, .pdf"),
        (("example", "--at", "3", "--table"), "--table: is for the throw of a machine: name its file"),
        (("kamaz_740", "--set", "K1=3 N"), f"K1 = 3 N: {NOT_A_KEY}"),
        (("kamaz_740", "--forces", "N"), "must be left out beside --throw"),
        (("deltic", "--throw-number", "3"), "must be the number of a throw: main.1"),
        (("two_throw_compressor",), "is one of 2 between bearings 1 and 3"),
        (("mill_engine",), "hangs over"),
        (("great_northern",), "masses: is missing, and [gas] too"),
        (("tilting_table",), "crankshaft: is missing: the loads of the main bearings need it"),
    ],
)
def test_mistakes_with_a_machine(typed, arguments, said):
    wrong = typed("textbook", "--throw", *arguments)
    assert (wrong.status, wrong.output) == (2, "")
    assert said in wrong.errors
    for option, value in (("--throw-number", "3"), ("--crank-masses", "sizes")):
        alone = typed("textbook", "kamaz_740", option, value)
        assert (alone.status, "is for a machine's throw" in alone.errors) == (2, True)
