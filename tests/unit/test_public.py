"""What Python users call: whatever one has of a machine is run, and mistakes are named where they were made."""

import inspect
import pydoc
import subprocess
import sys
import tomllib

import numpy as np
import pytest
from tests.machines import slider
from tests.sentences import A_ROD, LOOKED_FOR, NO_FILE, NOT_A_KEY, SET_TWICE

import cranktrain as ct
from cranktrain.plans.centres import instant_centres
from cranktrain.plans.constructions import construction
from cranktrain.plans.force_polygons import force_polygons
from cranktrain.plans.force_table import force_table
from cranktrain.plans.klein import klein
from cranktrain.plans.pin_loads import pin_loads
from cranktrain.plans.polygons import velocity_polygons
from cranktrain.plans.positions import position_plan
from cranktrain.plans.schemes import scheme
from cranktrain.plans.zhukovsky import zhukovsky_lever
from cranktrain.saying.catalogue import entries
from cranktrain.synthesis.slider_crank import slider_crank_from_stroke

TABLES = {"name": "small", "mechanism": slider(), "shaft": {"main": {"speed": "1500 rpm"}}}
FILE = """
name = "carded"
[mechanism]
kind = "slider_crank"
crank_radius = "50 mm"
rod_length = "180 mm"
[cylinder]
bore = "80 mm"
compression_ratio = 10
cycle = "two-stroke"
[gas]
kind = "indicator"
file = "card.csv"
"""
SMOOTH = np.cos(np.deg2rad(np.arange(-180, 180)))
PEAKS = {"card.csv": 20.0, "other.csv": 35.0}
"""Largest pressure of each card. [bar]"""


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """A folder with a machine file and two cards, and another one in which one works."""
    home = tmp_path / "home"
    home.mkdir()
    (home / "carded.toml").write_text(FILE, encoding="utf-8")
    for name, peak in PEAKS.items():
        pressures = 1.0 + (peak - 1.0) * (1.0 + SMOOTH) / 2.0
        rows = (f"{angle};{pressure:.9f}" for angle, pressure in zip(range(-180, 180), pressures, strict=True))
        (home / name).write_text("angle, deg;p, bar\n" + "\n".join(rows), encoding="utf-8")
    (tmp_path / "work").mkdir()
    monkeypatch.chdir(tmp_path / "work")
    return home


def peak(machine, **options):
    return float(ct.run(machine, quantities="peak_pressure", **options).peak_pressure[0]) / 1e5


def problems(action):
    with pytest.raises(ct.InputError) as caught:
        action()
    return caught.value.problems


class TestRun:
    @pytest.mark.parametrize("machine", [TABLES, ct.Machine(**TABLES)], ids=["dict", "Machine"])
    def test_tables_and_machines(self, machine):
        np.testing.assert_allclose(ct.run(machine).stroke, [0.1], rtol=1e-12)  # twice the crank of 50 mm

    def test_names_and_files(self, tmp_path):
        path = tmp_path / "m.toml"
        path.write_text('[mechanism]\nkind="slider_crank"\nstroke="80 mm"\nrod_length="136 mm"\n', encoding="utf-8")
        for source in (path, str(path)):
            np.testing.assert_allclose(ct.run(source, quantities="stroke").stroke, [0.08], rtol=1e-12)
        assert ct.run("3D12", quantities="stroke").machines[0].name.startswith("3D12")

    def test_several_give_designs(self):
        longer = ct.Machine(**TABLES).with_({"mechanism.crank_radius": "60 mm"})
        result = ct.run([TABLES, longer], quantities="stroke")
        np.testing.assert_allclose(result.stroke, [[0.1], [0.12]], rtol=1e-12)
        np.testing.assert_allclose(ct.run((one for one in [TABLES]), quantities="stroke").stroke, [[0.1]], rtol=1e-12)

    def test_other_values(self):
        set_to = {"mechanism.crank_radius": "60 mm"}
        for machine in (TABLES, ct.Machine(**TABLES)):
            np.testing.assert_allclose(ct.run(machine, set=set_to).stroke, [0.12], rtol=1e-12)
        assert TABLES["mechanism"]["crank_radius"] == "50 mm"

    @pytest.mark.parametrize("machine", [3, None, [["3d12"]]])
    def test_what_is_no_machine(self, machine):
        (problem,) = problems(lambda: ct.run(machine))
        assert "a machine file, the name of an example, or the tables" in str(problem.allowed)

    def test_text_of_a_file_is_no_name(self):
        (problem,) = problems(lambda: ct.run(FILE))
        assert "is the text of a machine file" in str(problem.allowed)
        assert "tomllib.loads" in str(problem.repair)

    def test_misspelt_example(self):
        (problem,) = problems(lambda: ct.run("kamaz740x"))
        assert str(problem.allowed) == NO_FILE
        assert "kamaz_740" in str(problem.repair)

    def test_quantities_must_be_some(self):
        (problem,) = problems(lambda: ct.run(TABLES, quantities=[]))
        assert problem.path == "quantities"

    @pytest.mark.parametrize("given", [["stroke", 3], [None], 5])
    def test_quantities_must_be_texts(self, given):
        for ask in (lambda: ct.run(TABLES, quantities=given), lambda: ct.compare("3d12", "deltic", quantities=given)):
            (problem,) = problems(ask)
            assert problem.path == "quantities"

    def test_units_must_be_texts(self):
        (problem,) = problems(lambda: ct.units("in", None).__enter__())
        assert (problem.path, problem.given) == ("units", "None")

    def test_names_that_are_no_text(self):
        (problem,) = problems(lambda: ct.run({1: 2}))
        assert problem.given == "1"


class TestSet:
    @pytest.mark.parametrize("use", [ct.load, ct.run])
    @pytest.mark.parametrize(
        ("values", "path", "said"),
        [
            ({"bank.L.mechanism.rod_length": 320}, "bank.L.mechanism.rod_length", A_ROD),
            ({"bank.L.mechanism.rod_lenght": "320 mm"}, "bank.L.mechanism.rod_lenght", NOT_A_KEY),
            ({"shaft.main": {}, "shaft.main.speed": "1 rpm"}, "shaft.main.speed", SET_TWICE),
        ],
    )
    def test_what_is_wrong_stands_at_set(self, use, values, path, said):
        found = problems(lambda: use("3d12", set=values))
        assert [(str(problem.position), problem.path) for problem in found] == [("set", path)]
        assert said in str(found[0].allowed)

    def test_what_was_meant_stands_deeper(self):
        found = problems(lambda: ct.load("3d12", set={"mechanism.rod_length": "320 mm"}))
        assert "bank.L.mechanism.rod_length" in str(found[-1].repair)

    def test_what_is_wrong_in_the_file_keeps_its_line(self, tmp_path):
        path = tmp_path / "m.toml"
        path.write_text('[mechanism]\nkind="slider_crank"\nstroke="80 kg"\nrod_length="136 mm"\n', encoding="utf-8")
        first, _second = problems(lambda: ct.load(path, set={"name": "x"}))
        assert (first.position.line, first.path) == (3, "mechanism.stroke")

    def test_values_and_tables(self):
        machine = ct.load(
            "vaz_21213",
            set={"shaft.main.speed": "3000 rpm", "cylinder.compression_ratio": 9, "balance": None, "gravity": True},
        )
        assert (machine.main_shaft.speed.text, machine.cylinder.compression_ratio.si) == ("3000 rpm", 9.0)
        assert machine.gravity is True

    def test_no_mapping(self):
        (problem,) = problems(lambda: ct.run("3d12", set="shaft.main.speed=3 rpm"))
        assert (problem.path, str(problem.repair)[:9]) == ("set", "write set")


class TestCards:
    """Files that a machine's tables name are read wherever the machine is changed."""

    def test_relative_to_the_machine_file(self, folder):
        machine = ct.load(folder / "carded.toml")
        assert peak(machine) == pytest.approx(20.0, rel=1e-9)
        assert peak(machine.with_({"shaft.main.speed": "1000 rpm"})) == pytest.approx(20.0, rel=1e-9)
        assert peak(machine.with_({"gas.file": "other.csv"})) == pytest.approx(35.0, rel=1e-9)
        assert peak(machine.with_({"name": "x"}).with_({"gas.file": "other.csv"})) == pytest.approx(35.0, rel=1e-9)
        assert peak(machine.with_({"gas": {"kind": "indicator", "file": "other.csv"}})) == pytest.approx(35.0, rel=1e-9)
        assert peak(folder / "carded.toml", set={"gas.file": "other.csv"}) == pytest.approx(35.0, rel=1e-9)

    def test_relative_to_where_one_works(self, folder, monkeypatch):
        tables = tomllib.loads(FILE)
        (problem,) = problems(lambda: ct.run(tables))
        assert (problem.path, str(problem.allowed)) == ("gas.file", NO_FILE)
        monkeypatch.chdir(folder)
        assert peak(tables) == pytest.approx(20.0, rel=1e-9)
        assert peak(ct.Machine(**tables)) == pytest.approx(20.0, rel=1e-9)
        assert peak(ct.Machine(**tables), set={"gas.file": "other.csv"}) == pytest.approx(35.0, rel=1e-9)

    def test_one_that_is_not_there(self, folder):
        machine = ct.load(folder / "carded.toml")
        (problem,) = problems(lambda: machine.with_({"gas.file": "othr.csv"}))
        assert (problem.path, str(problem.repair)) == (
            "gas.file",
            f"is it other.csv? It {LOOKED_FOR} {folder.resolve()}",
        )
        (problem,) = problems(lambda: ct.load(folder / "carded.toml", set={"gas.file": "othr.csv"}))
        assert (str(problem.position), problem.path) == ("set", "gas.file")


class TestModule:
    def test_nearest_name(self):
        with pytest.raises(AttributeError, match=r"no laod; did you mean load\?"):
            _ = ct.laod
        with pytest.raises(AttributeError, match=r"no plan_position; did you mean plan_positions\?"):
            _ = ct.viz.plan_position
        with pytest.raises(AttributeError, match=r"cranktrain has no quux$"):
            _ = ct.quux

    def test_completion(self):
        public = {name for name in dir(ct) if not name.startswith("_")}
        assert public == set(ct.__all__) - {"__version__"}
        pictures = {name for name in dir(ct.viz) if not name.startswith("_")}
        assert {"plan_positions", "sheet_forces", "save"} <= pictures
        assert all(getattr(ct.viz, name) is not None for name in pictures)
        assert "import_module" not in pictures

    def test_import_loads_nothing_heavy(self):
        code = (
            "import sys, cranktrain as ct; dir(ct)\n"
            "light = ('numpy', 'pydantic', 'matplotlib', 'xarray', 'scipy', 'numba')\n"
            "assert not set(light) & set(sys.modules)\n"
            "r = ct.run('3d12'); repr(r); r._repr_html_(); str(ct.compare('3d12', 'kamaz_740')); ct.viz\n"
            "assert not {'matplotlib', 'xarray', 'scipy', 'numba'} & set(sys.modules)\n"
        )
        subprocess.run([sys.executable, "-c", code], env={"PYTHONPATH": ":".join(sys.path)}, check=True)

    def test_help_shows_what_a_user_needs(self):
        shown = pydoc.plain(pydoc.render_doc(ct)).partition("PACKAGE CONTENTS")[0]
        needed = {*ct.__all__} - {"Comparison", "Machine", "Problem", "Result", "Start", "Sweep", "__version__"}
        assert [name for name in needed if f"ct.{name}" not in shown] == []
        of_results = (
            "stroke",
            "catalogue",
            "facts",
            "summary",
            "checks",
            "flags",
            "needs_of",
            "dataset",
            "plot",
            "sheet",
        )
        assert [name for name in of_results if f"result.{name}" not in shown and f").{name}" not in shown] == []
        assert len(shown.splitlines()) < 100

    def test_help_shows_nothing_of_the_libraries_behind(self):
        """Below its first page, too, and in what completion offers of a machine and of its tables."""
        shown = pydoc.plain(pydoc.render_doc(ct))
        assert [line for line in shown.splitlines() if "model_" in line or "__pydantic" in line] == []
        assert "with_(self, values" in shown
        machine = ct.load("3d12")
        for spec in (machine, machine.bank["L"], machine.bank["L"].mechanism[0]):
            fields = type(spec).model_fields
            assert set(fields) <= set(dir(spec))
            assert not {"copy", "dict", "json", "schema", "model_fields", "model_dump"} & set(dir(spec))
        assert {"with_", "places", "shafts", "cycle"} <= set(dir(machine)) & set(dir(ct.Machine))
        assert not {"arranged", "declared", "design", "table_problems"} & set(dir(machine))

    @pytest.mark.parametrize(
        "shown",
        [ct.run, ct.load, ct.compare, ct.Machine, ct.Machine.with_, ct.Result.plot, ct.Result.sheet, ct.Result.summary],
        ids=lambda one: one.__qualname__,
    )
    def test_signatures_fit_a_tooltip(self, shown):
        assert len(str(inspect.signature(shown))) < 340

    def test_examples_are_loaded_by_name(self):
        assert "3d12" in ct.example_names()
        assert ct.load(ct.example_names()[0]).name


@pytest.fixture(scope="module")
def result():
    return ct.run("3d12")


class TestLines:
    """Everything that a user may type shows itself in a line."""

    def test_machine_and_result_say_which(self, result):
        assert "3D12 marine diesel" in repr(result)
        assert "3D12 marine diesel" in repr(result.machines[0])
        assert "12 pistons, 6 throws" in repr(result.machines[0])
        assert "stroke" in repr(ct.run("3d12", quantities="stroke"))
        assert "2 designs" in repr(ct.run([TABLES, TABLES]))

    def test_everything_is_short(self, result):
        machine = result.machines[0]
        held = [
            *(result, machine, result.grid, result.checks[0], result.missing[0], ct.compare("3d12", "kamaz_740")),
            *(machine.bank["L"], machine.main_shaft, machine.cylinder, machine.places[0], machine.design),
            *(machine.bank["L"].mechanism[0], machine.bank["L"].mechanism[0].rod_length),
            *result.outcomes,
            *result.facts.values(),
            *result.catalogue.values(),
        ]
        long = [type(one).__name__ for one in held if len(repr(one)) > 200 or "\n" in repr(one)]
        assert long == []
        assert len(str(machine)) < 200

    def test_plans_and_proposals_are_short(self):
        masses = {"piston": {"mass": "0.4 kg"}, "rod": {"big_end": "0.5 kg", "small_end": "0.2 kg"}}
        machine = ct.load("vaz_21213", set={"masses": masses})
        proposal = slider_crank_from_stroke(0.16, 0.5)
        made = (
            *(position_plan(machine), scheme(machine), instant_centres(machine, 30.0), klein(machine, 30.0)),
            *(*velocity_polygons(machine, [30.0]), *force_polygons(machine, [30.0]), zhukovsky_lever(machine, 30.0)),
            *(construction(machine, "brix"), pin_loads(machine), (table := force_table(machine)), *table.columns),
            *(proposal, *proposal.alternatives, *proposal.numbers),
        )
        long = [type(one).__name__ for one in made if len(repr(one)) > 200 or "\n" in repr(one)]
        assert long == []
        assert repr(proposal) == "<Proposal: Slider-crank of 160.00 mm stroke: 8 numbers, alternatives: 1>"

    def test_given_numbers_are_their_text(self):
        machine = ct.Machine(mechanism=slider(rod_length={"value": "180 mm", "status": "published"}))
        assert repr(machine.mechanism.rod_length) == "<180 mm, published>"
        shown = repr(machine.mechanism)
        assert shown.startswith("SliderCrankSpec(kind='slider_crank', crank_radius=<50 mm>, rod_length=<180 mm, publ")

    def test_of_a_machine_that_is_wrong(self):
        shaft = {"main": {"throws": ["0 deg", "180 deg"]}}
        wrong = ct.Machine(bank={"A": {"mechanism": slider(), "throws": [3]}}, shaft=shaft)
        assert repr(wrong).startswith("<Machine without a name")

    def test_html_has_the_answer(self, result):
        page = result._repr_html_()
        assert "3D12 marine diesel" in page
        assert "<td>180.0</td>" in page  # the stroke that the engine's name plate has
        assert "<img" not in page
        assert "<script" not in ct.run(TABLES | {"name": "<script>"})._repr_html_()
        assert "12 pistons" in result.machines[0]._repr_html_()
        assert "2 designs" in ct.run([TABLES, TABLES])._repr_html_()

    def test_arrays_are_shown_by_their_sizes(self, result):
        shown = next(repr(one) for one in result.outcomes if any(e.name == "stroke" for e in entries(type(one))))
        assert "<1 × 12>" in shown
