import tomllib
from math import nextafter

import pytest

from cranktrain.quantities import Dimension, read
from cranktrain.synthesis.proposal import (
    Number,
    Proposal,
    ProposedTable,
    found,
    listed_in_lines,
    quantity_text,
    shaft_table,
    wanted,
)


@pytest.mark.parametrize(
    ("value", "unit", "text"),
    [
        (0.08, "mm", "80 mm"),
        (nextafter(0.16, 1), "mm", "160 mm"),  # one rounding is no reason for sixteen digits
        (-0.0125, "mm", "-12.5 mm"),
        (1234.5, "mm", "1234500 mm"),
        (0.5235987755982988, "deg", "30 deg"),
        (123.70021073509814, "rpm", "1181.25 rpm"),
    ],
)
def test_quantity_text_is_short(value, unit, text):
    assert quantity_text(value, unit) == text


@pytest.mark.parametrize("value", [0.1 / 3, 2 / 7e4, 12345.678901234567 / 9])
def test_quantity_text_reads_back(value):
    assert read(quantity_text(value, "mm"), Dimension.LENGTH) == pytest.approx(value, rel=5e-16)


def test_machine_file_is_toml_with_status_and_note():
    tables = (
        *shaft_table(1.0, 'by a "rule"'),
        ProposedTable("mechanism", {"rod_length": found(0.1, "mm", "how"), "crank_radius": wanted(0.05, "mm")}),
        ProposedTable("bank.S", {"angle": listed_in_lines(['"1 deg"', '"2 deg"'])}),
    )
    remark = "a remark " * 30
    text = Proposal("A “title”", (), (), (remark,), tables).machine_file()
    assert max(map(len, text.splitlines())) <= 120
    assert tomllib.loads(text) == {
        "name": "A “title”",
        "shaft": {"main": {"speed": {"value": "9.54929658551372 rpm", "status": "derived", "note": 'by a "rule"'}}},
        "mechanism": {
            "rod_length": {"value": "100 mm", "status": "derived", "note": "how"},
            "crank_radius": {"value": "50 mm", "note": "as wanted"},
        },
        "bank": {"S": {"angle": ["1 deg", "2 deg"]}},
    }


def test_number_by_name():
    number = Number("crank_radius", "R", 0.08, "mm", "Crank radius")
    assert Proposal("", (number,), (), (), ()).value("crank_radius") == 0.08


def test_number_of_a_member():
    """Its name and its symbol are those of all members, whatever brackets they have."""
    each = tuple(
        Number("width(inner)", "b(i)", size, "mm", "Inner width", member) for size, member in ((1.0, "1"), (2.0, "b"))
    )
    proposal = Proposal("", each, (), (), ())
    assert [proposal.value(f"width(inner)({member})") for member in ("1", "b")] == [1.0, 2.0]


def test_no_speed_no_shaft():
    assert shaft_table(None) == ()
