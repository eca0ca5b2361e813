from importlib.resources import files

import pytest

from cranktrain.mechanisms import KINDS

EXAMPLES = sorted(path.name for path in files("cranktrain.examples").iterdir() if path.name.endswith(".toml"))


def test_examples(typed):
    answer = typed("list")
    assert answer == typed("list", "examples")
    assert [f"{line.split()[0]}.toml" for line in answer.output.splitlines()] == EXAMPLES
    line = next(line for line in answer.output.splitlines() if line.startswith("3d12 "))
    assert "3D12 marine diesel" in line and line.endswith("(slider_crank, articulated_rod)")


def test_kinds(typed):
    assert [line.split()[0] for line in typed("list", "kinds").output.splitlines()] == [kind.name for kind in KINDS]


def test_results_are_found_by_grep(typed):
    lines = typed("list", "results").output.splitlines()
    found = [line for line in lines if line.startswith("piston_acceleration ")]
    assert len(found) == 1
    assert "m/s^2" in found[0] and "j(φ)" in found[0]


def test_unknown_list(typed):
    answer = typed("list", "result")
    assert answer.status == 2
    assert answer.errors == 'list = result: must be one of: examples, kinds, results; write "results"\n'


@pytest.mark.parametrize("name", [path.removesuffix(".toml") for path in EXAMPLES])
def test_every_example_runs(typed, name):
    answer = typed("run", name, "--step", "10")
    assert (answer.status, answer.errors) == (0, "")
    assert all(len(line) <= 80 for line in answer.output.splitlines())
    assert "nan" not in answer.output
    assert "✗" not in answer.output
