"""Sheets of main bearings and of wear by methods that are named: one diagram for each, to one scale."""

import re

import matplotlib as mpl
import numpy as np
import pytest
from tests.words_on_paper import assert_words_are_readable

import cranktrain as ct
from cranktrain.panels.parts import Polars, Table, WearCircles
from cranktrain.panels.sheets.crankshaft.bearings import sheet_crankshaft
from cranktrain.panels.sheets.wear.sheet import sheet_wear
from cranktrain.viz.paper.style import INK

mpl.use("Agg")
METHODS = ("frame_elastic", "frame_rigid", "five_moment", "three_moment", "split")


@pytest.fixture(scope="module")
def result():
    return ct.run("vaz_21213")


def part_of(sheet, kind):
    return next((part for part in sheet.columns[0].parts if isinstance(part, kind)), None)


@pytest.mark.parametrize(
    ("asked", "names"), [("split", ["split"]), (" Split ,three_moment", ["split", "three_moment"]), ("all", METHODS)]
)
def test_each_bearing_has_a_diagram_for_each_method(result, asked, names):
    assert result.labels["bearing_method"] == METHODS
    polars = part_of(sheet_crankshaft(result, method=asked), Polars)
    bearings = result.labels["bearing"]
    assert len(polars.diagrams) == len(bearings) * len(names)
    assert polars.n_beside == (len(names) if len(names) > 1 else None)
    diagrams = iter(polars.diagrams)
    for bearing in range(len(bearings)):
        for name in names:
            place = METHODS.index(name)
            one = next(diagrams)
            (curve,) = one.curves
            size = np.hypot(result.main_bearing_load_x[place, bearing], result.main_bearing_load_y[place, bearing])
            assert np.hypot(*curve.points)[:-1] == pytest.approx(size, rel=1e-12)
            assert one.largest_at == result.largest_bearing_load_at[place, bearing]


def test_without_a_method_all_are_in_one_diagram(result):
    polars = part_of(sheet_crankshaft(result), Polars)
    assert {len(one.curves) for one in polars.diagrams} == {len(METHODS)}
    assert part_of(sheet_crankshaft(result), Table) is not None


def test_wear_is_that_of_the_method(result):
    for name in METHODS:
        rows = part_of(sheet_wear(result, method=name), WearCircles).rows
        place = METHODS.index(name)
        journals, bearings = rows[-2:]
        for bearing, (journal, shell) in enumerate(zip(journals, bearings, strict=True)):
            assert journal.size == pytest.approx(result.journal_wear[place, bearing], rel=1e-15)
            assert shell.size == pytest.approx(result.bearing_wear[place, bearing], rel=1e-15)
    both = part_of(sheet_wear(result, method="frame_elastic,split"), WearCircles).rows
    assert [str(row[0].title) for row in both] == [
        "Journal 1\nframe, elastic",
        "Journal 1\nsplit shaft",
        "Bearing 1\nframe, elastic",
        "Bearing 1\nsplit shaft",
    ]


@pytest.mark.parametrize("asked", ["splitt", "", ",", "elastic", "clearance", "split shaft"])
@pytest.mark.parametrize("draw", [sheet_crankshaft, sheet_wear])
def test_what_is_no_method_is_refused_with_those_that_there_are(result, draw, asked):
    with pytest.raises(ct.InputError) as refused:
        draw(result, method=asked)
    assert all(
        "must be one of: frame_elastic, frame_rigid, five_moment, three_moment, split, all" in str(one)
        for one in refused.value.problems
    )


@pytest.mark.parametrize("asked", ["all,split", "split, ALL", "all,splitt", "split,all,five_moment"])
@pytest.mark.parametrize("draw", [sheet_crankshaft, sheet_wear])
def test_all_stands_by_itself(result, draw, asked):
    with pytest.raises(ct.InputError) as refused:
        draw(result, method=asked)
    (problem,) = map(str, refused.value.problems)
    assert problem.endswith(
        "must be `all` by itself, which is every method, or without it: "
        "frame_elastic, frame_rigid, five_moment, three_moment, split"
    )
    assert "write" not in problem


def test_a_machine_without_main_bearings_has_no_method():
    single = ct.Machine(
        mechanism={"kind": "slider_crank", "crank_radius": "50 mm", "rod_length": "200 mm"},
        shaft={"main": {"speed": "600 rpm"}},
        masses={"piston": {"mass": "2 kg"}},
    )
    with pytest.raises(ct.InputError, match="must be left out: there are no loads of main bearings"):
        sheet_wear(ct.run(single), method="split")


@pytest.mark.parametrize("size", ["A4", "A3"])
@pytest.mark.parametrize("asked", ["split", "all", "split,frame_rigid"])
def test_they_are_readable(result, asked, size):
    for draw in (ct.viz.sheet_crankshaft, ct.viz.sheet_wear):
        assert_words_are_readable(draw(result, method=asked, size=size))


def drawn_polars(figure):
    """Extent of each method's curve on paper, beside its title, in the order in which they are drawn. [mm]"""
    (axes,) = figure.axes
    return [
        np.ptp(line.get_xydata(), axis=0)
        for line in axes.lines
        if line.get_color() == INK and len(line.get_xdata()) > 361
    ]


def sheets_of(figure):
    width, height = figure.get_size_inches()
    return height / (width / np.sqrt(2))


@pytest.mark.parametrize(("name", "n_sheets"), [("vaz_21213", 2), ("3d12", 3), ("kamaz_740", 2)])
def test_methods_side_by_side_are_told_apart_on_as_many_sheets_as_that_takes(name, n_sheets):
    figure = ct.viz.sheet_crankshaft(ct.run(name), method="all")
    assert sheets_of(figure) == pytest.approx(n_sheets, rel=1e-3)
    assert max(map(np.max, drawn_polars(figure))) >= 0.75 * 40.0  # of 40 mm that there is room for, rounded to a scale
    assert_words_are_readable(figure)


def test_no_diagram_lies_over_the_cut_between_two_sheets():
    (axes,) = ct.viz.sheet_crankshaft(ct.run("3d12"), method="all").axes
    heights = np.concatenate([line.get_ydata() for line in axes.lines])
    heights = heights[np.isfinite(heights)]
    for cut in (0.0, -210.0):
        assert np.min(np.abs(heights - cut)) > 5.0


def test_a_pdf_has_a_page_of_the_paper_for_each_sheet(tmp_path):
    figure = ct.viz.sheet_crankshaft(ct.run("vaz_21213"), method="all")
    for number in range(2):
        ct.viz.save(figure, tmp_path / f"{number}.pdf")
    first, second = ((tmp_path / f"{number}.pdf").read_bytes() for number in range(2))
    assert first == second
    pages = re.findall(rb"/MediaBox \[ 0 0 ([\d.]+) ([\d.]+) \]", first)
    assert [[float(side) / 72 * 25.4 for side in page] for page in pages] == [pytest.approx([297.0, 210.0])] * 2
