"""Curves of the pistons that are not chosen: those of the result, whose they are, in the unit of the panel."""

from functools import cache

import numpy as np
import pytest

import cranktrain as ct
from cranktrain.io.examples import example_names
from cranktrain.web.other_pistons import other_pistons
from cranktrain.web.page import machine_page, tab_content, tab_names
from cranktrain.web.parts import PageCurves
from cranktrain.web.standalone import standalone_page

SEEN = 2.0**-12
"""Of the largest of a panel: as near as values are rounded."""


@cache
def result(name):
    return ct.run(name)


def panels(name, tab, piston=""):
    """Panels of a tab as they are shown, each with the curves of the others."""
    content = tab_content(result(name), tab, piston=piston)
    assert content.has_others
    parts = [part for sheet in content.sheets for column in sheet.columns for part in column]
    shown = [part.panels for part in parts if isinstance(part, PageCurves)]
    found = other_pistons(result(name), tab, piston=piston).parts
    return [pair for one, others in zip(shown, found, strict=True) for pair in zip(one, others, strict=True)]


def whose(others):
    return {name for one in others for name in one.names}


@pytest.mark.parametrize("chosen", ["1L", "4R"])
def test_travel_is_that_of_each_piston_of_another_throw(chosen):
    found = result("3d12")
    panel, others = panels("3d12", "Motion", chosen)[0]
    pistons = found.labels["piston"]
    assert whose(others) == {name for name in pistons if name[0] != chosen[0]}
    for one in others:
        for name in one.names:
            exact = 1e3 * found.piston_displacement[pistons.index(name)][:360]
            np.testing.assert_allclose(one.values[:360], exact, atol=SEEN * panel.size)


def test_forces_have_the_symbol_of_the_curve_that_they_are_beside():
    found = result("inline_six")
    pistons = found.labels["piston"]
    by_symbol = {"P": "piston_force", "S": "rod_force_at_piston_pin", "N": "side_force"}
    panel, others = next(
        pair for pair in panels("inline_six", "Largest forces", "3") if "Forces at piston" in str(pair[0].title)
    )
    assert {one.symbol for one in others} <= set(by_symbol)
    assert whose(others) == set(pistons) - {"3"}
    for one in others:
        for name in one.names:
            exact = getattr(found, by_symbol[one.symbol])[0, pistons.index(name)]
            unit = np.max(np.abs(one.values)) / np.max(np.abs(exact))
            np.testing.assert_allclose(one.values[: exact.size], unit * exact, atol=2 * SEEN * panel.size)


def test_what_is_the_machines_has_none():
    assert [
        others for panel, others in panels("3d12", "Largest forces") if "Torque on the shaft" in str(panel.title)
    ] == [()]


def test_a_slaves_share_is_beside_those_of_slaves_alone():
    (others,) = [others for panel, others in panels("3d12", "Largest forces", "2R") if "share" in str(panel.title)]
    assert whose(others) == {"1R", "3R", "4R", "5R", "6R"}


@pytest.mark.parametrize("name", example_names())
def test_a_tab_that_says_so_has_some_and_no_other(name):
    for tab in tab_names(result(name)):
        if tab in {"Start", "Textbook"}:
            continue
        content = tab_content(result(name), tab)
        some = any(others for part in other_pistons(result(name), tab).parts for others in part)
        assert content.has_others == some, tab


def test_a_page_that_would_be_too_large_has_none(monkeypatch):
    whole = len(standalone_page(result("two_throw_compressor")))
    monkeypatch.setattr("cranktrain.web.standalone._MOST", whole - 1)
    assert len(standalone_page(result("two_throw_compressor"))) < whole


def test_a_page_of_a_service_has_none_until_they_are_asked_for():
    assert all(tab.content.others is None for tab in machine_page(result("two_throw_compressor")).tabs)
