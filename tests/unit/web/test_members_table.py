"""Tables of pins and links: their names, units and decimals."""

import numpy as np
import pytest
from tests.machines import RADIUS, ROD, slider

import cranktrain as ct
from cranktrain.plans.placement import first_throw
from cranktrain.quantities import shown_by, units_by_dimension
from cranktrain.web.members_table import page_members

ANGLES = np.linspace(0.0, 360.0, 181)


def found(run):
    return page_members(run, first_throw(run.machines[0]), ANGLES)


def heads(table):
    return [str(column.head).replace("\ue000", "") for column in table.columns]


def test_a_column_has_as_many_decimals_as_four_figures_of_its_largest_take():
    pins, links = found(ct.run(ct.Machine(mechanism=slider(), shaft={"main": {"speed": "600 rpm"}}))).tables
    assert heads(pins) == ["X, mm", "Y, mm", "v, m/s", "a, m/s²"]
    assert heads(links) == ["direction, °", r"\omega, rad/s", r"\varepsilon, rad/s²"]
    assert 0.1 <= RADIUS + ROD < 1.0  # three figures of millimetres, and one decimal
    assert [column.step for column in pins.columns[:2]] == [0.1, 0.1]
    assert [(one.step, one.around) for one in links.columns[:1]] == [(0.01, 360.0)]
    omega = 2 * np.pi * 10
    np.testing.assert_allclose(np.hypot(pins.values[1, 2], pins.values[1, 3]), RADIUS * omega, rtol=1e-12)
    np.testing.assert_allclose(np.hypot(pins.values[1, 4], pins.values[1, 5]), RADIUS * omega**2, rtol=1e-12)
    for column, first in zip(pins.columns, (0, 1, 2, 4), strict=True):
        parts = pins.values[:, first : first + column.n_parts]
        largest = np.max(np.hypot(parts[:, 0], parts[:, -1]) if column.n_parts == 2 else np.abs(pins.values[:, :2]))
        figures = len(f"{largest:.{max(0, -round(np.log10(column.step)))}f}".replace(".", "").lstrip("0"))
        assert figures == 4


def test_units_are_those_that_are_chosen():
    with shown_by(units_by_dimension(["in"])):
        pins, _links = found(ct.run("textbook_78x78")).tables
        assert heads(pins)[:2] == ["X, in", "Y, in"]
    np.testing.assert_allclose(np.max(np.hypot(*pins.values[1, :2])), 39.0 / 25.4, rtol=1e-9)


@pytest.mark.parametrize(
    ("name", "pins", "links"),
    [
        ("toggle_press", {"O", "C", "main", "knee", "ram"}, {"crank O–main", "pitman main–knee", "lower knee–ram"}),
        ("3d12", {"1L A", "1R D"}, {"1L crank O–A", "1R rod C–D"}),
        ("jaw_crusher", {"B, jaw end"}, {"rocker C–B"}),
    ],
)
def test_names_are_those_of_the_file_with_their_mechanism_where_there_are_several(name, pins, links):
    of_pins, of_links = found(ct.run(name)).tables
    assert pins <= set(map(str, of_pins.names))
    assert links <= set(map(str, of_links.names))


def test_where_nothing_is_drawn_there_is_none():
    run = ct.run("textbook_78x78")
    assert page_members(run, (), ANGLES).tables == ()
