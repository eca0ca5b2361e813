"""What functions of `cranktrain.textbook` take, and what they say of what they do not."""

import csv
import io

import numpy as np
import pytest

import cranktrain as ct
from cranktrain.cli import main
from cranktrain.errors import InputError

ODD = [np.nan, np.inf, -np.inf, "60 deg", "sixty", None, [60.0, 70.0], {}]


@pytest.mark.parametrize("value", ODD, ids=repr)
@pytest.mark.parametrize("function", [ct.textbook.drive, ct.textbook.throw], ids=lambda one: one.__name__)
def test_an_angle_is_a_finite_number(function, value):
    if function is ct.textbook.throw and value is None:
        return
    machine = {ct.textbook.drive: "tilting_table", ct.textbook.throw: "vaz_21213"}[function]
    with pytest.raises(InputError, match=r"at = .*must be a number of degrees"):
        function(machine, at=value)


@pytest.mark.parametrize("value", [np.nan, np.inf, "1 banana", "", 3.5, True], ids=repr)
def test_other_numbers_are_refused_by_their_names(value):
    with pytest.raises(InputError, match="throw_number"):
        ct.textbook.throw("vaz_21213", value)
    with pytest.raises(InputError, match="stroke"):
        ct.textbook.synthesis(stroke=value)
    with pytest.raises(InputError, match="Q = "):
        ct.textbook.drive("tilting_table", set={"Q": value})
    with pytest.raises(InputError, match="source"):
        ct.textbook.errata(value)


@pytest.mark.parametrize("asked", [{"at": 30}, {"throw_number": 1}, {"crank_masses": "sizes"}])
def test_a_throw_without_a_machine_has_no_angle(asked):
    with pytest.raises(InputError, match="is for the throw of a machine"):
        ct.textbook.throw(**asked)


def test_errata_speak_of_their_own_argument():
    with pytest.raises(InputError) as refused:
        ct.textbook.errata("Z")
    assert [one.path for one in refused.value.problems] == ["source"]


def test_a_number_that_there_is_none_of_is_told_with_those_there_are():
    found = ct.textbook.drive()
    assert found.numbered(14) == found.numbered("(14)")
    with pytest.raises(InputError, match=r"\(99\).*\(1\), .*\(21\)"):
        found.numbered("(99)")


@pytest.mark.parametrize("name", ["errata", "constants", "throw"])
def test_numbers_without_curves_are_a_table_of_their_own(name):
    found = ct.textbook.constants("3d12") if name == "constants" else getattr(ct.textbook, name)()
    rows = list(csv.DictReader(io.StringIO(found.csv())))
    assert [row["name"] for row in rows] == [one.name for one in found]
    for row, one in zip(rows, found, strict=True):
        assert (float(row["value"]) if row["value"] else np.nan) == pytest.approx(one.value, rel=1e-11, nan_ok=True)


@pytest.mark.parametrize("name", ["drive", "throw"])
def test_the_tables_that_the_terminal_writes_are_read(tmp_path, monkeypatch, name):
    monkeypatch.chdir(tmp_path)
    assert main(("textbook", f"--{name}", "example", "-o", "own.toml")) == 0
    function = getattr(ct.textbook, name)
    assert [one.value for one in function("own.toml")] == [one.value for one in function()]
    text = (tmp_path / "own.toml").read_text(encoding="utf-8")
    (tmp_path / "own.toml").write_text(f"{text}\nwrong = 3\n", encoding="utf-8")
    with pytest.raises(InputError, match=rf"own\.toml:{text.count(chr(10)) + 2}:9  wrong"):
        function("own.toml")


def test_what_is_but_rounding_is_at_no_angle():
    """The exact root is off by nothing; the flat line of (21) has no peak."""
    roots = [one for one in ct.textbook.motion("great_northern") if abs(one.value) < 1e-13 and one.symbol[0] == "Δ"]
    assert roots
    assert all(np.isnan(one.crank_angle) for one in roots)
    flat = [
        one
        for one in ct.textbook.drive().numbered(21)
        if one.verdict == "refuted" and one.at in {"advancing", "going back"}
    ]
    assert len(flat) == 2
    assert all(np.isnan(one.crank_angle) for one in flat)


def test_a_throw_is_found_with_its_shaft_where_there_is_but_one():
    by_number, by_shaft = (ct.textbook.throw("kamaz_740", name, 420) for name in ("3", "main.3"))
    assert [one.value for one in by_number] == [one.value for one in by_shaft]
