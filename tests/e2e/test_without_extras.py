"""A plain install: what goes without any package of an extra, and what is refused before it begins."""

import os
import subprocess
import sys

import pytest
from tests.unit.cli.conftest import Answer

import cranktrain as ct
from cranktrain.cli import main
from cranktrain.extras import EXTRAS
from cranktrain.io.examples import example_names
from cranktrain.viz import curves

PACKAGES = sorted({package for packages in EXTRAS.values() for package in packages})
NEEDS_MATPLOTLIB = "needs the package matplotlib; pip install 'cranktrain[plot]'"

ALL_SCREENS = """
import contextlib, io, sys
sys.modules.update(dict.fromkeys({packages!r}))  # as if none were installed
from cranktrain.cli import main
for arguments in {typed!r}:
    errors = io.StringIO()
    with contextlib.redirect_stdout(io.StringIO()) as output, contextlib.redirect_stderr(errors):
        status = main(arguments)
    if status or errors.getvalue() or not (output.getvalue() or "-o" in arguments):
        print(arguments, status, errors.getvalue())
"""
OTHERS = [
    ["check", "3d12"],
    ["list"],
    ["list", "results"],
    ["new", "slider_crank"],
    ["compare", "3d12", "vaz_21213"],
    ["start", "high_slip_press"],
    ["start", "high_slip_press", "-o", "start.csv"],
    ["textbook", "3d12"],
    ["textbook", "--drive", "example"],
    ["synthesise", "drive", "servo_press"],
    ["run", "tilting_table", "--set", "drive.flywheel.fluctuation=0.02"],
    ["view", "3d12", "-o", "page.html"],
    ["run", "burning_cylinder", "-o", "run.csv"],
    ["run", "burning_cylinder", "-o", "run.json"],
    ["sweep", "burning_cylinder", "--vary", "rod_length=140..150 mm:2", "--wanted", "stroke", "-o", "sweep.csv"],
    ["sweep", "burning_cylinder", "--vary", "rod_length=140..150 mm:2", "--processes", "1"],
]


def test_screens_and_files_of_numbers_take_no_extra(tmp_path):
    typed = [*(["run", name] for name in example_names()), *OTHERS]
    code = ALL_SCREENS.format(packages=PACKAGES, typed=typed)
    surroundings = {**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, sys.path)), "LANGUAGE": "en"}
    done = subprocess.run(
        [sys.executable, "-c", code],
        cwd=tmp_path,
        env=surroundings,
        check=False,
        capture_output=True,
        encoding="utf-8",
    )
    assert (done.stdout, done.stderr) == ("", "")
    assert {path.name for path in tmp_path.iterdir()} == {"start.csv", "page.html", "run.csv", "run.json", "sweep.csv"}


@pytest.fixture
def plain(monkeypatch, tmp_path):
    """As if no package of an extra were installed."""
    monkeypatch.chdir(tmp_path)
    for package in PACKAGES:
        monkeypatch.setitem(sys.modules, package, None)


NOBODY = "no_such_machine"
"""Is not read: what cannot be written is refused before."""


@pytest.mark.parametrize(
    ("typed", "said"),
    [
        (["plot", NOBODY, "-o", "a.png"], "-o  .png: needs the package matplotlib; pip install 'cranktrain[plot]'"),
        (["plot", NOBODY, "-o", "a.gif"], f"-o  .gif: {NEEDS_MATPLOTLIB}"),
        (["plot", NOBODY, "-o", "a.dxf"], "-o  .dxf: needs the package ezdxf; pip install 'cranktrain[cad]'"),
        (["run", NOBODY, "--table", "motion", "-o", "a.pdf"], f"-o  .pdf: {NEEDS_MATPLOTLIB}"),
        (
            ["run", NOBODY, "-o", "a.nc"],
            "-o  .nc: needs the package xarray; pip install 'cranktrain[dataset]', or write a .csv or .json",
        ),
        (
            ["run", NOBODY, "-o", "a.xlsx"],
            "-o  .xlsx: needs the package openpyxl; pip install 'cranktrain[xlsx]', or write a .csv, with --decimal"
            " comma where spreadsheets have one",
        ),
        (["compare", NOBODY, NOBODY, "-o", "a.svg"], f"-o  .svg: {NEEDS_MATPLOTLIB}"),
        (["start", NOBODY, "-o", "a.svg"], f"-o  .svg: {NEEDS_MATPLOTLIB}"),
        (["sweep", NOBODY, "--vary", "rod_length=1..2 m:3", "-o", "a.svg"], f"-o  .svg: {NEEDS_MATPLOTLIB}"),
        (
            ["sweep", NOBODY, "--vary", "rod_length=1..2 m:3", "-o", "a.zarr"],
            "-o  .zarr: needs the package zarr; pip install 'cranktrain[store]', or write a .csv or .json",
        ),
        (["textbook", "--drive", NOBODY, "-o", "a.svg"], f"-o  .svg: {NEEDS_MATPLOTLIB}"),
        (["textbook", "--throw", NOBODY, "-o", "a.svg"], f"-o  .svg: {NEEDS_MATPLOTLIB}"),
        (["synthesise", "slider-crank", "-o", "a.svg"], f"-o  .svg: {NEEDS_MATPLOTLIB}"),
    ],
    ids=lambda given: " ".join(given[:3] + given[-1:]) if isinstance(given, list) else "",
)
def test_what_cannot_be_written_is_refused_first(plain, typed, said, capsys, tmp_path):
    answer = Answer(main(typed), *capsys.readouterr())
    assert answer == (2, "", said + "\n")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    ("ask", "said"),
    [
        (lambda: curves.plot_run(None), "plot"),
        (lambda: curves.plot_sweep(None), "plot"),
        (lambda: curves.plot_comparison(None), "plot"),
        (lambda: curves.sheet_called(None), "sheet"),
        (lambda: ct.viz.sheet_forces(None), "sheet_forces"),
        (lambda: ct.viz.plan_positions(None), "plan_positions"),
        (lambda: ct.viz.save(lambda: None, "a.svg"), "-o  .svg"),
        (lambda: ct.viz.save_animation(None, "a.gif"), "-o  .gif"),
    ],
)
def test_pictures_in_python_say_what_to_install(plain, ask, said, tmp_path):
    """Of nothing: the sentence comes before the thing is looked at."""
    with pytest.raises(ct.InputError) as found:
        ask()
    assert str(found.value) == f"{said}: {NEEDS_MATPLOTLIB}"
    assert list(tmp_path.iterdir()) == []


def test_results_show_themselves_without_pictures(plain):
    """A notebook shows a result as a table, which asks for no package."""
    result = ct.run("burning_cylinder")
    assert "stroke" in result._repr_html_()
    with pytest.raises(ct.InputError, match="plot: needs the package matplotlib"):
        result.plot()
    with pytest.raises(ct.InputError, match="facts_table: needs the package pandas"):
        result.facts_table()
