"""Which designs of a sweep have which flags: those that each has alone; on the screen, in files, in datasets."""

import csv

import pytest

import cranktrain as ct

RATIOS = {"cylinder.compression_ratio": "9.3, 30, 22, 31", "bank.line.mechanism.rod_length": "70, 136 mm"}
DIESELS = "is more than any engine has, 24 in diesels"


@pytest.mark.parametrize(
    ("name", "vary", "wanted"),
    [
        ("vaz_21213", RATIOS, ["largest_torque"]),
        (
            "high_slip_press",
            {"drive.part.flywheel.inertia": "2, 10 kg·m²", "drive.stage[0].ratio": "3, 9, 12"},
            ["stroke_speed_drop"],
        ),
    ],
)
def test_each_design_has_the_flags_that_it_has_alone(name, vary, wanted):
    machine = ct.load(name)
    found = ct.sweep(machine, vary, wanted)
    n_flags = 0
    for row, flags in zip(found.designs.rows, found.found.flags, strict=True):
        alone = list(map(str, ct.run(machine, set=row, quantities=wanted).flag_words))
        assert [str(flag) for flag in flags] == [flag for flag in alone if flag in set(map(str, flags))]
        assert all(flag in map(str, flags) for flag in alone if DIESELS in flag or "No stroke" in flag)
        n_flags += len(flags)
    assert n_flags > 2


def test_what_differs_in_numbers_alone_is_said_once():
    found = ct.sweep("vaz_21213", RATIOS, "largest_torque")
    assert sorted(found.flags.values()) == [[0, 2, 4, 6], [2, 3, 6, 7]]
    said = " ".join(str(found).split())
    assert f"flags: A compression ratio of 30 {DIESELS}: is its decimal point right? (4 designs)" in said
    texts = found.dataset.flags
    assert texts.dims == ("rod_length", "compression_ratio")
    assert [DIESELS in text for text in texts.values[1]] == [False, True, False, True]
    assert texts.values[1, 0] == ""


def test_one_design():
    found = ct.sweep("vaz_21213", {"cylinder.compression_ratio": "9, 30"}, "largest_torque")
    assert "(1 design)" in str(found)
    assert "flags" not in ct.sweep("vaz_21213", {"cylinder.compression_ratio": "9, 10"}, "largest_torque").dataset


@pytest.mark.parametrize("decimal", ["point", "comma"])
def test_a_column_of_a_table(tmp_path, monkeypatch, decimal):
    from cranktrain.cli import main

    monkeypatch.chdir(tmp_path)
    vary = ("--vary", "cylinder.compression_ratio=9, 30", "--wanted", "largest_torque", "--decimal", decimal)
    assert main(["sweep", "vaz_21213", *vary, "-o", "a.csv"]) == 0
    lines = (tmp_path / "a.csv").read_text(encoding="utf-8-sig").splitlines()
    assert any(line.startswith("# minded: flags: A compression ratio of 30") for line in lines)
    table = csv.DictReader([line for line in lines if line[0] != "#"], delimiter=";" if decimal == "comma" else ",")
    first, second = table
    assert first["flags"] == ""
    assert DIESELS in second["flags"]
    assert float(second["compression_ratio [1]"].replace(",", ".")) == 30


def test_a_row_of_a_list_of_designs_and_a_sheet(tmp_path, monkeypatch):
    openpyxl = pytest.importorskip("openpyxl")
    from cranktrain.cli import main

    monkeypatch.chdir(tmp_path)
    (tmp_path / "cases.csv").write_text("cylinder.compression_ratio\n9\n30\n")
    asked = ["sweep", "vaz_21213", "--cases", "cases.csv", "--wanted", "largest_torque"]
    assert main([*asked, "-o", "a.csv"]) == 0
    rows = (tmp_path / "a.csv").read_text(encoding="utf-8").splitlines()
    first, second = csv.DictReader([row for row in rows if row[0] != "#"])
    assert (first["flags"], second["case"]) == ("", "2")
    assert DIESELS in second["flags"]
    vary = ["sweep", "vaz_21213", "--vary", "cylinder.compression_ratio=9, 30", "--wanted", "largest_torque"]
    assert main([*vary, "-o", "a.xlsx"]) == 0
    book = openpyxl.load_workbook(tmp_path / "a.xlsx")
    assert book.sheetnames == ["curves", "about"]
    head, _first, second = book["curves"].iter_rows(values_only=True)
    assert DIESELS in second[head.index("flags")]


def test_flags_do_not_hang_on_the_block():
    """Each design is told its own number, whoever stands beside it."""
    texts = []
    for ratios in ("30, 31", "31, 33", "31, 9"):
        found = ct.sweep("vaz_21213", {"cylinder.compression_ratio": ratios}, "largest_torque")
        place = [value.strip() for value in ratios.split(",")].index("31")
        texts.append(list(map(str, found.found.flags[place])))
    assert texts[0] == texts[1] == texts[2]
    assert "ratio of 31 is more" in texts[0][0]
