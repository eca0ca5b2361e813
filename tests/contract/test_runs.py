"""One kind of run: whatever was asked, files, data frames, curves, the screen and `why` come of it without a line more.

Numbers are compared with the arrays of the run itself, read back by other readers: csv, json, openpyxl, SciPy's netCDF.
"""

import csv
import io
import json
import re
from functools import cache

import numpy as np
import pytest
from openpyxl import load_workbook
from rich.console import Console
from scipy.io import netcdf_file
from tests.sentences import ENDS_IN

import cranktrain as ct
from cranktrain.analysis.comparison import compared
from cranktrain.cli.run_files import form_of, write_run
from cranktrain.cli.screen.sections import show_sections
from cranktrain.io.writers import SUFFIXES
from cranktrain.language import _
from cranktrain.record import record
from cranktrain.saying.catalogue import entries, quantity
from cranktrain.saying.run import Axis, Run
from cranktrain.study.start import start
from cranktrain.synthesis.slider_crank import slider_crank_from_stroke
from cranktrain.textbook.motion_statements import motion_statements

_PAGE = "docs/theory/synthesis"


@record
class Cut:
    """What a cutting trial found; a sixth kind of run, which the package has never heard of."""

    force: object = quantity("F", "N", ("tool", "depth"), "Cutting force", _PAGE, "definition")
    work: object = quantity("W", "J", (), "Work of the trial", _PAGE, "definition")
    edge_wear: object = quantity("w", "m", ("tool",), "Wear of the edge", _PAGE, "definition")


@record
class Trial(Run):
    """Two tools at four depths of cut."""

    @property
    def subject(self):
        return _("Trial of {n} tools", n=2)

    @property
    def catalogue(self):
        return {entry.name: entry for entry in entries(Cut)}

    @property
    def labels(self):
        return {"tool": ("steel", "carbide")}

    @property
    def axis(self):
        return Axis("depth", "m", "a", np.array([0.001, 0.002, 0.003, 0.004]))

    force = property(lambda self: np.array([[100.0, 210.0, 330.0, 460.0], [90.0, 190.0, 290.0, 390.0]]))
    work = property(lambda self: np.float64(1234.5))
    edge_wear = property(lambda self: np.array([2e-5, 7e-6]))

    def about(self):
        return (("trial", self.subject),)


@cache
def runs():
    """A run of every kind."""
    return {
        "cycle": ct.run("r_1340"),
        "start": start(ct.load("tilting_table"), at=[0.0, 0.5, 1.0]),
        "comparison": compared((ct.run("3d12"), ct.run("vaz_21213")), ("one", "other"), ("stroke", "mean_torque")),
        "proposal": slider_crank_from_stroke(stroke=0.16, pressure_angle=0.5),
        "statements": motion_statements(ct.load("3d12"), ct.run("3d12")),
        "trial": Trial(),
    }


KINDS = ("cycle", "start", "comparison", "proposal", "statements", "trial")


def written(run, suffix, folder):
    path = folder / f"a{suffix}"
    form = form_of(str(path))
    write_run(run, form, str(path), {}, force=False)
    return path


def facts_of(run):
    """Every fact as it is in an array, by name and by keys of members."""
    for name, entry in run.catalogue.items():
        if run.is_curve(entry):
            continue
        values, labels = np.asarray(getattr(run, name)), list(run.labels_of(entry).values())
        for place in np.ndindex(*values.shape):
            yield (name, " ".join(keys[i] for keys, i in zip(labels, place, strict=True))), float(values[place])


@pytest.mark.parametrize("kind", KINDS)
def test_every_kind_is_a_run(kind):
    run = runs()[kind]
    assert isinstance(run, Run)
    assert str(run.subject)
    for name, entry in run.catalogue.items():
        values = np.asarray(getattr(run, name))
        own = {**{one: len(keys) for one, keys in run.labels.items()}}
        if run.axis is not None:
            own[run.axis.name] = len(run.axis.values)
        assert values.shape == tuple(own[one] for one in entry.dimensions), name


@pytest.mark.parametrize("kind", KINDS)
def test_facts_in_a_csv(kind, tmp_path):
    run = runs()[kind]
    if run.axis is not None:
        table = run.facts_table()
        found = {(row.quantity, row.of): row.value for row in table.itertuples()}
    else:
        lines = [line for line in written(run, ".csv", tmp_path).read_text("utf-8").splitlines() if line[0] != "#"]
        found = {(row["quantity"], row["of"]): float(row["value"]) for row in csv.DictReader(lines)}
    expected = {key: value for key, value in facts_of(run) if run.axis is not None or np.isfinite(value)}
    assert found.keys() == expected.keys()
    np.testing.assert_array_equal([found[key] for key in expected], list(expected.values()))


@pytest.mark.parametrize("kind", ["start", "trial"])
def test_curves_in_a_csv(kind, tmp_path):
    run = runs()[kind]
    text = written(run, ".csv", tmp_path).read_text("utf-8")
    rows = list(csv.reader(line for line in io.StringIO(text) if not line.startswith("#")))
    numbers = np.array(rows[1:], dtype=float)
    assert rows[0][0] == f"{run.axis.name} [{run.axis.unit}]"
    np.testing.assert_array_equal(numbers[:, 0], run.axis.values)
    frame = run.curves()
    np.testing.assert_array_equal(numbers[:, 1:], frame.to_numpy())
    assert list(frame.index) == list(run.axis.values)


@pytest.mark.parametrize("kind", KINDS)
def test_json(kind, tmp_path):
    run = runs()[kind]
    data = json.loads(written(run, ".json", tmp_path).read_text("utf-8"))
    for name, entry in run.catalogue.items():
        found = data["quantities" if run.is_curve(entry) else "facts"][name]
        assert found["dimensions"] == list(entry.dimensions)
        values = np.array(found["values"], dtype=float)
        np.testing.assert_array_equal(values, np.where(np.isfinite(getattr(run, name)), getattr(run, name), np.nan))
    if run.axis is not None:
        np.testing.assert_array_equal(data[run.axis.name]["values"], run.axis.values)


@pytest.mark.parametrize("kind", KINDS)
def test_netcdf(kind, tmp_path):
    run = runs()[kind]
    with netcdf_file(written(run, ".nc", tmp_path), mmap=False) as file:
        for name, entry in run.catalogue.items():
            found = file.variables[name]
            assert found.dimensions == entry.dimensions
            np.testing.assert_array_equal(found[...], getattr(run, name))
            assert found.units.decode() == entry.unit


@pytest.mark.parametrize("kind", KINDS)
def test_workbook(kind, tmp_path):
    run = runs()[kind]
    book = load_workbook(written(run, ".xlsx", tmp_path), read_only=True)
    rows = list(book["facts"].values)[1:] if "facts" in book.sheetnames else []
    found = {(row[0], row[1] or ""): row[2] for row in rows}
    expected = dict(facts_of(run))
    for key, value in found.items():
        assert value is None if not np.isfinite(expected[key]) else value == pytest.approx(expected[key], rel=1e-15)
    assert rows


@pytest.mark.parametrize("kind", KINDS)
def test_every_quantity_says_where_it_is_from(kind):
    run = runs()[kind]
    for name, entry in run.catalogue.items():
        what, where, *_line = map(str, run.why(name))
        assert entry.symbol in what
        assert where.startswith(entry.source)


@pytest.mark.parametrize("kind", KINDS)
def test_a_name_of_none_is_answered(kind):
    with pytest.raises(ct.InputError, match="is no quantity of this run"):
        next(iter(runs()[kind].why("no such thing")))


def test_a_kind_that_nobody_knows_has_a_screen_and_a_picture():
    console = Console(file=io.StringIO(), width=80)
    trial = runs()["trial"]
    show_sections(console, trial.sections())
    said = console.file.getvalue()
    assert "Work of the trial" in said
    assert "1234 J" in said.replace("\xa0", " ")
    assert {"steel", "carbide", "Wear", "0.02000"} <= set(said.split())
    figure = trial.plot("force")
    (axes,) = figure.axes
    lines = [line for line in axes.lines if len(line.get_xdata()) == 4]
    np.testing.assert_allclose(lines[0].get_xdata(), [1.0, 2.0, 3.0, 4.0])  # mm
    np.testing.assert_allclose([line.get_ydata() for line in lines], trial.force)
    assert axes.get_xlabel() == "Depth a, mm"


def test_a_file_of_no_kind_is_refused():
    with pytest.raises(ct.InputError, match=re.escape(f"{ENDS_IN}.csv, .json, .xlsx, .nc")):
        form_of("a.docx")
    assert SUFFIXES == (".csv", ".json", ".xlsx", ".nc")
