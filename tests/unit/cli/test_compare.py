"""`compare`: two machines side by side, and mistakes of who compares."""

import pytest
from PIL import Image
from tests.sentences import ENDS_IN, NO_FILE, NOT_A_KEY

SMALL = (
    '[shaft.main]\nspeed = "1500 rpm"\n[mechanism]\nkind = "slider_crank"\nstroke = "80 mm"\nrod_length = "136 mm"\n'
)


@pytest.fixture
def machines(written):
    written(SMALL, "small.toml")
    written(SMALL.replace("80 mm", "100 mm"), "large.toml")
    return "small.toml", "large.toml"


def test_rows_with_their_difference(typed, machines):
    answer = typed("compare", *machines)
    assert (answer.status, answer.errors) == (0, "")
    lines = answer.output.splitlines()
    assert lines[0].startswith("small.toml: ")
    assert ["stroke", "80.00", "100.0", "mm", "+20.0", "+25.0", "%"] in [line.split() for line in lines]
    assert "Motion" in lines


def test_a_screen_is_enough(typed):
    for machines in (("3d12", "kamaz_740"), ("r_1340", "pumping_unit_c57"), ("deltic", "traction_engine")):
        lines = typed("compare", *machines).output.splitlines()
        assert len(lines) <= 60
        assert max(map(len, lines)) <= 80


def test_itself_with_other_values(typed, machines):
    answer = typed("compare", machines[0], "--set", "shaft.main.speed=3000 rpm", "--quantities", "mean_piston_speed")
    row = next(line.split() for line in answer.output.splitlines() if line.startswith("  mean piston speed"))
    assert row[3:5] == ["4.000", "8.000"]  # 2 S n
    assert "changed: shaft.main.speed=3000 rpm" in answer.output.splitlines()


def test_a_value_goes_for_both(typed, machines):
    answer = typed("compare", *machines, "--set", "shaft.main.speed=3000 rpm", "--quantities", "mean_piston_speed")
    row = next(line.split() for line in answer.output.splitlines() if line.startswith("  mean piston speed"))
    assert row[3:5] == ["8.000", "10.00"]


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["small.toml"], "must be compared with something: another machine, or itself with --set"),
        (["small.toml", "small.toml"], "is named twice"),
        (["3d12", "3D12"], "is named twice"),
        (["3d12", ""], "must be the name of a machine file"),
        (["small.toml", "./small.toml"], "is named twice"),
        (["small.toml", "smal.toml"], NO_FILE),
        (["smal.toml", "larg.toml"], "larg.toml"),
        (["small.toml", "large.toml", "3d12"], "unexpected extra argument"),
        (["small.toml", "--set", "shaft.main.sped=3 rpm"], NOT_A_KEY),
        (["small.toml", "large.toml", "-o", "both.txt"], ENDS_IN),
        (["small.toml", "large.toml", "--quantities", ","], "must be names of results"),
        (["small.toml", "large.toml", "--quantities", "strok"], "did you mean stroke?"),
        (["small.toml", "large.toml", "--quantities", "swing"], "is a result of neither machine"),
    ],
)
def test_mistakes(typed, machines, arguments, said):
    answer = typed("compare", *arguments)
    assert (answer.status, answer.output) == (2, "")
    assert said in answer.errors


def test_what_is_wrong_with_either_is_told(typed, machines):
    answer = typed("compare", "smal.toml", "larg.toml")
    assert answer.errors.count(NO_FILE) == 2


def test_picture(typed, machines, tmp_path):
    answer = typed("compare", *machines, "-o", "both.png")
    assert (answer.status, answer.output) == (0, "written: both.png\n")
    with Image.open(tmp_path / "both.png") as picture:
        assert picture.width > 800
    assert "both.png  is there already" in typed("compare", *machines, "-o", "both.png").errors
    assert typed("compare", *machines, "-o", "both.png", "--force").status == 0


def test_what_is_not_used_is_said(typed, written, machines):
    written(SMALL + "[evenness]\ncoefficient = 0.01\n", "unused.toml")
    answer = typed("compare", machines[0], "unused.toml")
    assert "! unused.toml: [evenness] is not used" in answer.output.replace("\n", " ")
