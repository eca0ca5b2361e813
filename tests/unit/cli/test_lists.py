from importlib.resources import files

import pytest
from tests.sentences import NO_FILE

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


def test_what_stands_behind_a_result(typed):
    answer = typed("list", "results", "--behind", "largest_bearing_load", "--of", "3d12")
    assert (answer.status, answer.errors) == (0, "")
    lines = answer.output.splitlines()
    assert all(len(line) <= 80 for line in lines)
    heads = [lines.index(head) for head in ("What the machine file declares", "Stages, in the order in which they run")]
    assert heads == sorted(heads)
    stages = [line.split()[1] for line in lines[heads[1] + 1 :] if line[2:3].isdigit()]
    assert stages[0] == "grid_motion" and stages[-1] == "main_bearing_loads"
    assert "      reads [gas]" in answer.output and "a calculator" in answer.output


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("results", "--behind", "strok"), "did you mean stroke?"),
        (("results", "--behind", "largest_bearing_load", "--of", "tilting_table"), "it needs [crankshaft]"),
        (("results", "--behind", "stroke", "--of", "nothing.toml"), NO_FILE),
        (("results", "--of", "3d12"), "--of = 3d12: goes with list results --behind NAME"),
        (("kinds", "--behind", "stroke"), "--behind = stroke: goes with list results --behind NAME"),
    ],
)
def test_mistakes_about_what_stands_behind(typed, arguments, said):
    answer = typed("list", *arguments)
    assert (answer.status, answer.output) == (2, "")
    assert said in answer.errors


@pytest.mark.parametrize("name", [path.removesuffix(".toml") for path in EXAMPLES])
def test_every_example_runs(typed, name):
    answer = typed("run", name, "--step", "10")
    assert (answer.status, answer.errors) == (0, "")
    assert all(len(line) <= 80 for line in answer.output.splitlines())
    assert "nan" not in answer.output
    assert "✗" not in answer.output
