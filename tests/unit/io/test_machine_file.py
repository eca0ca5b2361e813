import tomllib
from importlib.resources import files

import pytest

import cranktrain as ct
from cranktrain.io.examples import example_called, example_names
from cranktrain.io.machine_file import inputs_of, read_machine
from cranktrain.io.machine_source import source_of_text
from cranktrain.paths import quantity_path

MACHINE = '[mechanism]\nkind = "slider_crank"\nstroke = "80 mm"\nrod_length = "136 mm"\n'


@pytest.mark.parametrize("name", ["3d12", "3D12", "3D12-Quoted_Rods"])
def test_example_by_any_spelling(name):
    assert "3D12" in ct.load(name).name
    assert example_called(name) == name.lower().replace("-", "_")


def test_a_file_goes_before_an_example(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "3d12").write_text(MACHINE, encoding="utf-8")
    assert ct.load("3d12").mechanism.stroke.si == 0.08
    (tmp_path / "3d12").unlink()
    (tmp_path / "3d12").mkdir()
    assert ct.load("3d12").name.startswith("3D12")


def test_path_objects(tmp_path):
    path = tmp_path / "m.toml"
    path.write_text(MACHINE, encoding="utf-8")
    assert ct.load(path) == ct.load(str(path))


def test_settings_are_in_machine_and_document():
    file = read_machine("3d12", ["shaft.main.speed=1800 rpm", "bank.R.mechanism.offset = 1mm"])
    assert file.machine.main_shaft.speed.text == "1800 rpm"
    assert file.document.data["bank"]["R"]["mechanism"]["offset"] == "1mm"


def test_every_problem_of_settings_at_once():
    with pytest.raises(ct.InputError) as caught:
        read_machine("3d12", ["nonsense", "a..b=1"])
    assert [str(problem.position) for problem in caught.value.problems] == ["--set", "--set"]


@pytest.mark.parametrize("name", example_names())
def test_inputs_are_those_of_the_file(name):
    """Every path leads to the text that stands there, and every text with a digit and a unit is found."""
    file = read_machine(name)
    data = tomllib.loads(files("cranktrain.examples").joinpath(f"{name}.toml").read_text(encoding="utf-8"))
    inputs = inputs_of(file)
    for path, given in inputs:
        found = data
        for part in quantity_path(path):
            found = found[part]
        table = found if isinstance(found, dict) else {"value": found}
        assert str(table["value"]) == given.text
        assert (table.get("status"), table.get("note"), table.get("source")) == (given.status, given.note, given.source)
    assert len({path for path, _given in inputs}) == len(inputs)
    assert sum(one.given.status is not None for one in inputs) == statuses(data)


def statuses(data: object) -> int:
    """How many tables of a file have a status."""
    if isinstance(data, dict):
        return ("status" in data) + sum(map(statuses, data.values()))
    return sum(map(statuses, data)) if isinstance(data, list) else 0


def test_a_machine_of_a_text_is_that_of_its_file(tmp_path):
    path = tmp_path / "m.toml"
    path.write_text(MACHINE, encoding="utf-8")
    settings = ["mechanism.rod_length=140 mm"]
    of_file, of_text = read_machine(path, settings), source_of_text(MACHINE, {}).with_set(settings)
    assert of_text.machine == of_file.machine
    assert of_text.document.text == of_file.document.text


@pytest.mark.parametrize("text", ["3d12", "/etc/passwd", "", "m.toml", "mechanism = 3\n"])
def test_a_text_is_never_the_name_of_a_file(text, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "m.toml").write_text(MACHINE, encoding="utf-8")
    with pytest.raises(ct.InputError) as caught:
        source_of_text(text, {}).with_set()
    assert all(problem.position.file == "machine.toml" for problem in caught.value.problems)


@pytest.mark.parametrize("text", ["", "# nothing yet\n"])
def test_settings_make_no_machine_of_an_empty_file(text, tmp_path):
    path = tmp_path / "empty.toml"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(ct.InputError, match="no machine in it"):
        read_machine(path, ["cylinder.bore=81 mm"])
