import csv
import io
import json
import math

import numpy as np
import pytest

import cranktrain as ct
from cranktrain.analysis.curve_columns import CurveColumn, curve_columns
from cranktrain.io.machine_file import read_machine
from cranktrain.io.tables import HEADS, csv_text, fact_csv, json_text
from cranktrain.io.workbook import workbook_bytes

SHORT_ROD = {"kind": "slider_crank", "crank_radius": "40 mm", "rod_length": "30 mm"}


@pytest.fixture(scope="module", params=["3d12", "r_1340", "pumping_unit_c57"])
def example(request):
    file = read_machine(request.param)
    return file, ct.run(file.machine, step_degrees=2)


def every_curve(result: ct.Result) -> list[CurveColumn]:
    """All curves, by each method."""
    return list(curve_columns(result, result.catalogue))


def table_of(text: str) -> tuple[list[str], dict[str, list[str]]]:
    """Comment lines, and columns by their heads."""
    lines = text.splitlines(keepends=True)
    comments = [line for line in lines if line.startswith("#")]
    heads, *rows = csv.reader(io.StringIO("".join(lines[len(comments) :])))
    assert len(set(heads)) == len(heads)
    return comments, dict(zip(heads, zip(*rows, strict=True), strict=True))


def test_csv_reads_back_to_the_same_numbers(example):
    _file, result = example
    _comments, columns = table_of("".join(csv_text(result, every_curve(result))))
    np.testing.assert_array_equal([float(number) for number in columns.pop("crank_angle [deg]")], result.crank_angle)
    for name, entry in result.catalogue.items():
        if entry.is_fact:
            continue
        values = getattr(result, name)
        match list(result.labels_of(entry).values()):
            case []:
                found = {f"{name} [{entry.unit}]": values}
            case [members]:
                found = {f"{name}({member}) [{entry.unit}]": values[i] for i, member in enumerate(members)}
            case _:
                continue
        for head, expected in found.items():
            np.testing.assert_array_equal([float(number) for number in columns.pop(head)], expected)
    deeper = {name for name, entry in result.catalogue.items() if len(entry.dimensions) > 2}
    assert {head.partition("(")[0] for head in columns} <= deeper


def test_csv_by_method_names_both(example):
    _file, result = example
    if "displacement_by_method" not in result.catalogue:
        pytest.skip("no textbook form for this machine")
    _comments, columns = table_of("".join(csv_text(result, list(curve_columns(result, ["displacement_by_method"])))))
    methods, pistons = result.labels["motion_method"], result.labels["piston"]
    assert len(columns) == 1 + len(methods) * len(pistons)
    for i, method in enumerate(methods):
        column = columns[f"displacement_by_method({method} {pistons[-1]}) [m]"]
        np.testing.assert_array_equal([float(number) for number in column], result.displacement_by_method[i, -1])


def test_csv_says_how_it_counts():
    file = read_machine("3d12", ['running="astern"'])
    result = ct.run(file.machine, step_degrees=30)
    comments, _columns = table_of("".join(csv_text(result, list(curve_columns(result, ["rod_angle"])))))
    said = "".join(comments)
    assert comments[0] == f"# cranktrain: {ct.__version__}\n"
    assert comments[1].startswith("# machine: 3D12 marine diesel")
    for word in (
        "# rotation: clockwise, seen from the free end",
        "# running: astern",
        "# crank_angle: 0 where the crank of throw 1 points along the axis of bank L",
        "# piston_displacement: from the true top dead centre toward the shaft",
        "# units: SI",
    ):
        assert word in said
    assert "# left out: " in said and "piston_displacement" in comments[-1]


def test_json_reads_back_to_the_same_numbers(example):
    file, result = example
    read = json.loads("".join(json_text(result, file.document.data, result.catalogue)))
    assert list(read) == [
        "cranktrain",
        "machine",
        "conventions",
        "crank_angle",
        "quantities",
        "facts",
        "checks",
        "unused",
        "flags",
        "missing",
    ]
    assert read["machine"] == file.document.data
    np.testing.assert_array_equal(read["crank_angle"]["values"], result.crank_angle)
    assert set(read["quantities"]) | set(read["facts"]) == set(result.catalogue)
    for name, told in (read["quantities"] | read["facts"]).items():
        entry = result.catalogue[name]
        values = np.array(told["values"], dtype=float)  # None becomes NaN
        np.testing.assert_array_equal(values, getattr(result, name))
        assert values.ndim == len(told["dimensions"])
        assert (told["unit"], told["symbol"], told["sentence"]) == (entry.unit, entry.symbol, entry.sentence)
        assert (told["source"], told["equation"]) == (entry.source, entry.equation)
        assert {dimension: tuple(names) for dimension, names in told["labels"].items()} == result.labels_of(entry)
        assert ("line" in told) is bool(entry.line)
    assert read["facts"].get("stroke", {"line": "S = H − h"})["line"] == "S = H − h"
    assert [check["passed"] for check in read["checks"]] == [True] * len(result.checks)
    assert all({"results", "needs"} == set(missing) for missing in read["missing"])


def test_what_is_not_a_number():
    result = ct.run(ct.Machine(mechanism=SHORT_ROD), step_degrees=10, partial=True)
    open_at = np.isnan(result.rod_angle[0])
    assert open_at.any() and not open_at.all()
    _comments, columns = table_of("".join(csv_text(result, list(curve_columns(result, ["rod_angle"])))))
    assert [math.isnan(float(number)) for number in columns["rod_angle(1) [rad]"]] == open_at.tolist()
    text = "".join(json_text(result, {}, ["rod_angle"]))
    assert "NaN" not in text
    assert [value is None for value in json.loads(text)["quantities"]["rod_angle"]["values"][0]] == open_at.tolist()


def test_csv_with_commas_reads_back_to_the_same_numbers(example):
    """As a spreadsheet reads it where a comma divides decimals: by semicolons, the byte-order mark taken off."""
    _file, result = example
    points = "".join(csv_text(result, every_curve(result)))
    commas = "".join(csv_text(result, every_curve(result), comma=True))
    assert commas.startswith("\ufeff#")
    rows = list(csv.reader(io.StringIO(commas.removeprefix("\ufeff")), delimiter=";"))
    expected = list(csv.reader(io.StringIO(points)))
    numbers = [row for row in rows if not row[0].startswith("#")]
    wanted = [row for row in expected if not row[0].startswith("#")]
    assert numbers[0] == wanted[0]
    assert [[cell.replace(",", ".") for cell in row] for row in numbers[1:]] == wanted[1:]
    assert not any("." in cell for row in numbers[1:] for cell in row)


@pytest.mark.parametrize("comma", [False, True])
def test_facts_as_csv(example, comma):
    _file, result = example
    text = "".join(fact_csv(result, result.catalogue, comma=comma))
    assert text.startswith("\ufeff") == comma
    reader = csv.reader(io.StringIO(text.removeprefix("\ufeff")), delimiter=";" if comma else ",")
    heads, *rows = reader
    assert tuple(heads) == HEADS
    found = {
        (name, of): (value.replace(",", ".") if comma else value, unit) for name, of, value, unit, _meaning in rows
    }
    for name, entry in result.catalogue.items():
        if entry.is_fact:
            values = np.asarray(getattr(result, name))
            of = [key for key in found if key[0] == name]
            assert len(of) == values.size
            np.testing.assert_array_equal([float(found[key][0]) for key in of], values.ravel())
            assert {found[key][1] for key in of} <= {entry.unit}


def test_workbook_reads_back_to_the_same_numbers(example):
    openpyxl = pytest.importorskip("openpyxl")
    _file, result = example
    names = ["rod_angle", "stroke", "crank_radius"]
    content = b"".join(workbook_bytes(result, list(curve_columns(result, names)), names))
    sheets = {sheet.title: sheet for sheet in openpyxl.load_workbook(io.BytesIO(content)).worksheets}
    curves, about = (sheets[title] for title in ("curves", "about"))
    heads, *rows = curves.iter_rows(values_only=True)
    _comments, columns = table_of("".join(csv_text(result, list(curve_columns(result, names)))))
    assert list(heads) == list(columns)
    expected = np.transpose([list(map(float, column)) for column in columns.values()])
    np.testing.assert_allclose(np.array(rows, float), expected, rtol=1e-15)  # openpyxl writes 16 digits
    known = [name for name in names if name in result.catalogue and result.catalogue[name].is_fact]
    assert ("facts" in sheets) == bool(known)  # there is no sheet of nothing
    if known:
        assert sheets["facts"]["A1"].value == "quantity"
        assert sheets["facts"].max_row == 1 + sum(np.size(getattr(result, name)) for name in known)
    assert about["A1"].value == "cranktrain"


def test_workbook_has_no_formulas_of_the_users_and_empty_cells_for_no_number():
    openpyxl = pytest.importorskip("openpyxl")
    machine = ct.Machine(mechanism=SHORT_ROD, name="=1+\x07" + 40_000 * "1")
    result = ct.run(machine, partial=True, step_degrees=30)
    content = b"".join(workbook_bytes(result, list(curve_columns(result, ["rod_angle"])), ["rod_angle"]))
    curves, about = openpyxl.load_workbook(io.BytesIO(content)).worksheets
    assert "B2" in curves.freeze_panes
    assert {type(row[1]) for row in curves.iter_rows(min_row=2, values_only=True)} <= {int, float, type(None)}
    named = next(row for row in about.iter_rows() if row[0].value == "machine")[1]
    assert (named.data_type, named.value[:4]) == ("s", "'=1+")
