"""Sections are data: numbers are written, and words said, when somebody reads them; nothing of a screen is in them."""

import ast
import inspect

import numpy as np
import pytest
from tests.pseudo_locale import PSEUDO, is_marked, pseudo

import cranktrain as ct
from cranktrain import language
from cranktrain.cli.screen.sections import show_page
from cranktrain.saying import section_texts, sections
from cranktrain.saying.section_texts import written_column
from cranktrain.saying.sections import Column, Command, Decimals, Grid, Rows, ShownSection, Unfolded, section

__all__ = ["pseudo"]

STROKE = Column(language._("exact"), (0.1, 0.0254, ""), "mm")


def shown(*found, head="Head"):
    show_page(head, found)


@pytest.mark.parametrize(
    ("column", "texts", "unit"),
    [
        (STROKE, ("100.00", "25.40", ""), "mm"),
        (Column("v", (0.05, float("nan")), "mm/rad"), ("50.00", "–"), "mm/rad"),
        (Column("Δx", (0.0254, -6.3e-5), "%", "percent"), ("2.54", "-0.0063"), "%"),
        (Column("K", (-0.00001, 1.23456), "", Decimals(3)), ("0.000", "1.235"), ""),
        (Column("P", (-0.00001, 0.0), "kN", Decimals(3, 1e-9)), ("-0.00001", "0.000"), "kN"),
        (Column("N", (657.7, 66.6e3), "N", "amounts"), ("0.6577", "66.60"), "kN"),
        (Column("λ", (0.25,), "1"), ("0.250",), ""),
    ],
)
def test_how_numbers_are_written(column, texts, unit):
    made = written_column(column)
    assert (made.values, made.unit) == (texts, unit)


def test_numbers_are_in_the_units_of_who_reads():
    """A heading over inches says inches."""
    with ct.units("in"):
        made = written_column(STROKE)
        slope = written_column(Column("v", (0.0254,), "mm/rad"))
    assert (made.values[:2], made.unit) == (("3.937", "1.000"), "in")
    assert (slope.values, slope.unit) == (("1.000",), "in/rad")


@pytest.mark.usefixtures("pseudo")
def test_words_are_said_in_the_language_of_who_reads(capsys):
    found = ShownSection(language._("Sources"), (Rows([(language._("exact"), "1")]), Grid([STROKE], ["a", "b", "c"])))
    shown(found, head="1")
    assert not is_marked(capsys.readouterr().out)
    with language.in_language(PSEUDO):
        shown(found, head="1")
    said = capsys.readouterr().out.splitlines()
    assert [is_marked(line) for line in said] == [False, False, True, True, True, *4 * [False]]


def test_a_page(capsys):
    """By hand: headings alone and above, columns with labels, rows with heads, a line apart, an empty one."""
    shown(
        ShownSection("Only a heading"),
        ShownSection("Numbers", ("They are:", "", Grid([Column("S", (0.18, 0.0), "mm")], ["0°", "180°"]))),
        ShownSection("Words", (Rows([("a", "1"), ("bcd", "10")], ("", "n"), right=(1,)), Unfolded("cranktrain list"))),
        "Alone.",
        ShownSection("", ("Below it.",)),
    )
    assert capsys.readouterr().out.splitlines() == [
        "Head",
        "",
        "Only a heading",
        "",
        "Numbers",
        "  They are:",
        "",
        "             S",
        "            mm",
        "  0°    180.00",
        "  180°    0.00",
        "",
        "Words",
        "        n",
        "  a     1",
        "  bcd  10",
        "  cranktrain list",
        "",
        "Alone.",
        "  Below it.",
    ]


def test_what_has_no_room(capsys):
    """Of 80 columns 78 are there: columns go below, a name is cut, a command gives way, what is to be copied stays."""
    columns = [Column(f"column {i}", (1.0, 2.0), how=Decimals(1)) for i in range(9)]
    long = "word " * 30
    shown(
        ShownSection("Columns", (Grid(columns, ["1", "2"], names_quantities=False),)),
        ShownSection("Cut", (Rows([("1.", long, "5")], ("", "", "n"), right=(0, 2), cut=1),)),
        ShownSection("Commands", (Command("cranktrain " + "x" * 70, "all", "the same"), Unfolded("y" * 90))),
    )
    lines = capsys.readouterr().out.splitlines()
    assert [line.split() for line in lines if "column" in line] == [
        [word for i in part for word in ("column", str(i))] for part in (range(7), range(7, 9))
    ]
    (cut,) = (line for line in lines if " …" in line)
    assert len(cut) <= 80
    assert cut.endswith("5")
    assert lines[-2:] == ["  the same: all", "  " + "y" * 90]


def test_words_of_rows_stand_behind_or_below(capsys):
    column = Column("R", (0.08, 0.09), "mm")
    shown(ShownSection("a", (Grid([column], words=["first", "second"]),)))
    assert [line.split() for line in capsys.readouterr().out.splitlines()[-2:]] == [
        ["80.00", "first"],
        ["90.00", "second"],
    ]
    shown(ShownSection("a", (Grid([column], ["1", "2"], "φ", ["first", "second"]),)))
    lines = capsys.readouterr().out.splitlines()
    assert [line.split() for line in lines[-3:]] == [["first"], ["2", "90.00"], ["second"]]


def test_nothing_makes_no_section():
    assert list(section("Mind", ())) == []
    assert [one.parts for one in section("Mind", ["all"])] == [("all",)]


@pytest.mark.parametrize("module", [sections, section_texts])
def test_nothing_of_a_screen_is_in_them(module):
    nodes = list(ast.walk(ast.parse(inspect.getsource(module))))
    imported = {node.module or "" for node in nodes if isinstance(node, ast.ImportFrom)}
    imported |= {name.name for node in nodes if isinstance(node, ast.Import) for name in node.names}
    assert not any(name.startswith(("rich", "cranktrain.cli")) for name in imported)


def test_values_may_be_arrays_of_numpy():
    assert written_column(Column("S", np.array([0.1, 0.2]).tolist(), "mm")).values == ("100.00", "200.00")
