"""Values of a sweep as they are typed, and which places of the file they are of."""

import numpy as np
import pytest
from tests.machines import slider

import cranktrain as ct
from cranktrain.study.sweep import varied
from cranktrain.study.sweep.typed import n_values_typed, values_typed
from cranktrain.study.sweep.varied import combined_designs, names_of, path_meant

MACHINE = ct.Machine(mechanism=slider(), shaft={"main": {"speed": "1500 rpm"}})


@pytest.mark.parametrize(
    ("text", "values"),
    [
        ("130..136 mm:4", ("130 mm", "132 mm", "134 mm", "136 mm")),
        ("130 mm..136 mm:3", ("130 mm", "133 mm", "136 mm")),
        ("0.1..0.3:3", (0.1, 0.2, 0.3)),
        ("1..0 m:2", ("1 m", "0 m")),
        ("-2..2 deg:3", ("-2 deg", "0 deg", "2 deg")),
        ("1000, 1500 rpm", ("1000 rpm", "1500 rpm")),
        ("1 in, 30, 40 mm", ("1 in", "30 mm", "40 mm")),
        ("1 1/2 in, 2 in", ("1 1/2 in", "2 in")),
        ("cage, shunt", ("cage", "shunt")),
        ("4, 6", (4, 6)),
        ("true, false", (True, False)),
        ('["0 deg", "90 deg"]', ("0 deg", "90 deg")),
        ('[["0 deg", "90 deg"], ["0 deg", "180 deg"]]', (["0 deg", "90 deg"], ["0 deg", "180 deg"])),
        ("80, 100..120 mm:3", ("80 mm", "100 mm", "110 mm", "120 mm")),
        ("110,5; 120,25 mm", ("110.5 mm", "120.25 mm")),
        ("-0,3..-0,1 mm:3; 2,5 mm", ("-0.3 mm", "-0.2 mm", "-0.1 mm", "2.5 mm")),
        ("cage; shunt", ("cage", "shunt")),
        ("10,20,30 mm", ("10 mm", "20 mm", "30 mm")),  # three of them are no pairs
        ("110.5,120 mm", ("110.5 mm", "120 mm")),
        ("1/2,3/4 in", ("1/2 in", "3/4 in")),
        ("1-3,4-2", ("1-3", "4-2")),
        ("-0.3..0.3 mm:7", ("-0.3 mm", "-0.2 mm", "-0.1 mm", "0 mm", "0.1 mm", "0.2 mm", "0.3 mm")),
    ],
)
def test_values(text, values):
    assert values_typed("path", text) == values


def test_a_range_is_even_to_the_last_bit():
    """Its values are the nearest doubles of the exact fractions: 0.1 + k · 0.2/3 in decimals."""
    from fractions import Fraction

    exact = [float(Fraction(1, 10) + Fraction(1, 5) * k / 7) for k in range(8)]
    assert values_typed("path", "0.1..0.3:8") == tuple(exact)


@pytest.mark.parametrize(
    ("text", "point", "several"),
    [
        ("110,5 mm", "110.5 mm", "110, 5 mm"),
        ("110,5, 120,5 mm", "110.5, 120.5 mm", "110, 5, 120, 5 mm"),
        ("110,5,120,5 mm", "110.5, 120.5 mm", "110, 5, 120, 5 mm"),
        ("110,5..120,5 mm:3", "110.5..120.5 mm:3", "110, 5..120, 5 mm:3"),
        ("-0,5", "-0.5", "-0, 5"),
    ],
)
def test_a_comma_between_digits_is_refused(text, point, several):
    with pytest.raises(ct.InputError) as caught:
        values_typed("path", text)
    assert str(caught.value) == (
        f"path = {text}: has a comma between digits, which may divide decimals or values;"
        f' write "{point}", or "{several}" for several values'
    )


@pytest.mark.parametrize(
    ("text", "n_values"),
    [
        ("1, 2 mm", 2),
        ("1;2;3", 3),
        ("1..2:5, 7", 6),
        ("1..2", 21),
        ("0..1:1000000", 1000000),
        (f"0..1:{10**18}", 1),
        ("[1, 2]", 1),
        ("", 1),
    ],
)
def test_values_are_counted_unread(text, n_values):
    assert n_values_typed(text) == n_values


def test_more_designs_than_there_may_be_are_refused_unmade(monkeypatch):
    """Ranges of a million values each: none of them is made for it."""
    monkeypatch.setattr(varied, "values_typed", None)
    vary = {"rod_length": "130..140 mm:1000000", "speed": "1..2 rpm:1000000", "offset": np.zeros(3)}
    with pytest.raises(ct.InputError, match=r"vary: is 3000000000000 designs, and may be 10000000; ask for fewer"):
        ct.sweep(MACHINE, vary, "stroke")


@pytest.mark.parametrize("steps", [np.arange(-0.3, 0.35, 0.1), np.arange(-3, 4) * 0.1 + 1e-17, [0.3, 0.15, 1e-17]])
def test_even_steps_have_no_residue_of_rounding(steps):
    (one,) = combined_designs(MACHINE, {"shaft.main.unit": steps}).varied
    assert [value for value in one.values if abs(value) < 1e-3] == [0.0]
    np.testing.assert_allclose(one.values, steps, atol=1e-15)


@pytest.mark.parametrize("numbers", [[1e-17, 1.0, 3.0], [1e-17, 1.0], [1e-17, 2e-17, 3e-17]])
def test_small_numbers_that_are_meant_stay(numbers):
    (one,) = combined_designs(MACHINE, {"shaft.main.unit": numbers}).varied
    assert list(one.values) == numbers


def test_a_range_without_a_count_has_21_values():
    assert len(values_typed("path", "100..200 mm")) == 21


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", "must be values with commas between"),
        ("1,,2", "must be values with commas between"),
        ("130..mm:3", "must be FROM..TO:N"),
        ("..160 mm:3", "must be FROM..TO:N"),
        ("130..160 mm:x", "must be FROM..TO:N"),
        ("130..160 mm:1", "at least 2 values"),
        ("130..130 mm:4", "ends that differ"),
        ("130 in..160 mm:4", "must have one unit"),
        ("130..160 mm:" + 100 * "9", "must be FROM..TO:N"),
        ("130..160 mm:9999999", "has more values than any range may have, 1000000"),
        ("[1, 2", "must be a list of TOML"),
        ("[]", "must be a list of TOML"),
    ],
)
def test_what_is_no_values(text, said):
    with pytest.raises(ct.InputError) as caught:
        values_typed("path", text)
    assert said in str(caught.value.problems[0])


def test_the_last_name_is_enough_where_it_is_one():
    assert path_meant(MACHINE, "rod_length") == "mechanism.rod_length"
    assert path_meant(MACHINE, "mechanism.offset") == "mechanism.offset"
    with pytest.raises(ct.InputError, match=r"stands 2 times in this file; write one of: bank.L.masses.rod.big_end"):
        path_meant(ct.load("3d12"), "big_end")
    with pytest.raises(ct.InputError, match="did you mean rod_length"):
        path_meant(MACHINE, "rod_lenght")


def test_names_of_dimensions():
    paths = ["bank.L.mechanism.rod_length", "shaft.main.speed", 'cylinder."1.crank".clearance']
    assert names_of(paths) == ["rod_length", "speed", "clearance"]
    two = ["bank.L.mechanism.rod_length", "bank.R.mechanism.rod_length", "shaft.main.throws[2]"]
    assert names_of(two) == ["bank_L_mechanism_rod_length", "bank_R_mechanism_rod_length", "throws_2"]
    assert names_of(["shaft.main.throws[1]", "shaft.side.throws[1]"]) == ["shaft_main_throws_1", "shaft_side_throws_1"]


def test_an_item_of_a_list_is_called_by_its_list():
    """`throws[1]` stands at the head of its column and along its axis, where `1` stood."""
    machine = ct.load("vaz_21213")
    vary = {"throws[1]": "144..216 deg:3", "bank.line.mechanism.stroke": "70, 80 mm"}
    swept = ct.sweep(machine, vary, wanted=["largest_torque"])
    assert [one.path for one in swept.designs.varied] == ["shaft.main.throws[1]", "bank.line.mechanism.stroke"]
    assert [one.name for one in swept.designs.varied] == ["throws_1", "stroke"]
    assert str(swept.subject).endswith(", over throws[1] × stroke")
    with pytest.raises(ct.InputError, match=r"^throw\[1\]: is no key of this machine's file; did you mean throws\?"):
        ct.sweep(machine, {"throw[1]": "144..216 deg:3"})
    with pytest.raises(ct.InputError, match=r"throws\[9\]: shaft\.main\.throws is a list of 4"):
        ct.sweep(machine, {"throws[9]": "144..216 deg:3"})


def test_all_that_is_wrong_is_told_at_once():
    vary = {"rod_lenght": "1 mm", "shaft.main.speed": "1..1 rpm:3", "mechanism.offset": "1 mm, 1 mm"}
    with pytest.raises(ct.InputError) as caught:
        combined_designs(MACHINE, vary)
    assert len(caught.value.problems) == 3
    assert "stands twice" in str(caught.value.problems[2])


def test_rows_of_a_grid_and_of_a_list():
    grid = combined_designs(MACHINE, {"rod_length": np.array([0.13, 0.14]), "speed": ["1000 rpm", "2000 rpm"]})
    rows = list(grid.rows)
    assert len(grid) == len(rows) == 4
    assert rows[1] == {"mechanism.rod_length": 0.13, "shaft.main.speed": "2000 rpm"}


@pytest.mark.parametrize(
    ("path", "text", "numbers", "unit"),
    [
        ("mechanism.rod_length", "130 mm, 0.14 m, 6 in", [130, 140, 152.4], "mm"),
        ("shaft.main.speed", "1500 rpm, 100 rad/s", [1500, 954.92965855137201461330258], "rpm"),
        ("mechanism.rod_length", ["0.13 m", "140 mm"], [0.13, 0.14], "m"),
    ],
)
def test_units_may_differ(path, text, numbers, unit):
    """Numbers are in the unit of the first; each design has what was typed."""
    (one,) = combined_designs(MACHINE, {path: text}).varied
    np.testing.assert_array_equal(one.numbers, numbers)
    assert one.unit == unit


def test_one_length_in_two_units_stands_twice():
    with pytest.raises(ct.InputError, match="stands twice among its values"):
        combined_designs(MACHINE, {"rod_length": "130 mm, 0.13 m"})


def test_what_is_varied_has_the_name_of_no_fact():
    """A stroke that is varied, and found, is a coordinate beside a variable."""
    found = ct.sweep("vaz_21213", {"stroke": "70, 80 mm"}, "stroke")
    dataset = found.dataset
    np.testing.assert_array_equal(dataset.bank_line_mechanism_stroke, [70, 80])
    np.testing.assert_allclose(dataset.stroke, np.broadcast_to([0.07, 0.08], dataset.stroke.shape), rtol=1e-3)


def test_what_is_set_is_not_varied():
    with pytest.raises(ct.InputError, match=r"mechanism\.rod_length: is set and varied: what is set would have no"):
        ct.sweep(MACHINE, {"rod_length": "130, 140 mm"}, set={"mechanism.rod_length": "150 mm"})
    cases = [{"rod_length": "130 mm"}, {"speed": "2000 rpm"}]
    found = ct.sweep(MACHINE, cases, "closing_margin", set={"mechanism.rod_length": "150 mm"})
    alone = ct.run(MACHINE, set={"mechanism.rod_length": "150 mm"}).closing_margin
    assert found.closing_margin[1] == alone
