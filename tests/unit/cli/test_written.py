"""Files of numbers as `run` writes them: in which form, and what there is no place for."""

import sys

import pytest
from tests.sentences import ALREADY_THERE, ENDS_IN, FOLDER_NOT_THERE

CURVES = ("--quantities", "piston_displacement", "--step", "90")


def test_decimal_comma_for_spreadsheets(typed, tmp_path):
    answer = typed("run", "3d12", "-o", "a.csv", "--decimal", "comma", *CURVES)
    assert (answer.status, answer.errors) == (0, "")
    content = (tmp_path / "a.csv").read_bytes()
    assert content.startswith(b"\xef\xbb\xbf# ")
    head, *rows = [line for line in content.decode("utf-8-sig").splitlines() if not line.startswith("#")]
    assert head.startswith("crank_angle [deg];piston_displacement(1L) [m];")
    assert rows[1].startswith("90,0;0,")
    assert not any("." in row for row in rows)


def test_facts_to_csv(typed, tmp_path):
    answer = typed("run", "3d12", "-o", "facts.csv", "--facts", "--quantities", "stroke,compression_ratio")
    assert (answer.status, answer.errors) == (0, "")
    head, *rows = (tmp_path / "facts.csv").read_text(encoding="utf-8").splitlines()
    assert head == "quantity,of,value,unit,meaning"
    assert rows[0].startswith("stroke,1L,0.18")
    assert len(rows) == 24


def test_facts_of_all(typed, tmp_path):
    assert typed("run", "vaz_21213", "-o", "facts.csv", "--facts", "--decimal", "comma").status == 0
    text = (tmp_path / "facts.csv").read_text(encoding="utf-8")
    assert text.startswith("\ufeffquantity;of;value;unit;meaning\n")
    assert "\ndisplacement;;0,0016" in text


def test_workbook(typed, tmp_path):
    openpyxl = pytest.importorskip("openpyxl")
    answer = typed("run", "vaz_21213", "-o", "a.xlsx", "--step", "30")
    assert (answer.status, answer.errors) == (0, "")
    assert openpyxl.load_workbook(tmp_path / "a.xlsx").sheetnames == ["curves", "facts", "about"]
    assert ALREADY_THERE in typed("run", "vaz_21213", "-o", "a.xlsx").errors


def test_workbook_without_its_package(typed, tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "openpyxl", None)
    answer = typed("run", "vaz_21213", "-o", "a.xlsx", "--step", "30")
    assert answer.status == 2
    assert answer.errors.startswith("-o  .xlsx: needs the package openpyxl; pip install 'cranktrain[xlsx]'")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    ("options", "said"),
    [
        (["--decimal", "comma"], "--decimal: is for a file: name one with -o"),
        (["--facts"], "--facts: is for a file: name one with -o, such as -o facts.csv"),
        (["-o", "a.csv", "--decimal", "komma"], '--decimal = komma: must be one of: point, comma; write "comma"'),
        (["-o", "a.csv", "--decimal", ","], "--decimal = ,: must be one of: point, comma"),
        (["-o", "a.json", "--decimal", "comma"], "--decimal = comma: is for a .csv; .json has numbers"),
        (["-o", "a.xlsx", "--decimal", "comma"], "--decimal = comma: is for a .csv; .xlsx has numbers"),
        (["-o", "a.json", "--facts"], "--facts: is for a .csv; .json has facts and curves; leave --facts out"),
        (["-o", "a.xlsx", "--facts"], "--facts: is for a .csv; .xlsx has facts and curves"),
        (["-o", "a.xls"], f"-o = a.xls: {ENDS_IN}.csv, .json, .xlsx"),
        (["-o", "a.csv", "--facts", "--quantities", "rod_angle"], "quantities = rod_angle: is a curve, and --facts"),
        (["-o", "a.csv", "--quantities", "stroke"], "quantities = stroke: has one value for the whole cycle, and a"),
        (["-o", "no/a.csv", "--facts"], FOLDER_NOT_THERE),
    ],
)
def test_what_no_file_has_a_place_for(typed, tmp_path, options, said):
    answer = typed("run", "3d12", *options)
    assert answer.status == 2
    assert said in answer.errors
    assert "Traceback" not in answer.errors
    assert list(tmp_path.iterdir()) == []
