"""Slips of a new user: each is answered with what is wrong and what to type, and nothing is written."""

import pytest
from tests.sentences import ENDS_IN, NO_FILE

SLIPS = (
    (("textbook", "eratta"), f"eratta  {NO_FILE}; did you mean errata?"),
    (("run", "slider-crank"), "is written by: cranktrain new slider_crank -o mine.toml"),
    (("new", "slider_crank", "-o", "n.csv"), '-o = n.csv: must end in .toml: it is a machine file; write "n.toml"'),
    (
        ("synthesise", "slider-crank", "--stroke", "160 mm", "--pressure-angle", "30 deg", "-o", "press.txt"),
        f"-o = press.txt: {ENDS_IN}.csv, .json, .xlsx, .nc, .toml, .png, .svg, .pdf",
    ),
    (("synthesise", "quick-return", "--stroke", "300 mm"), "--time-ratio: is missing; must be a number without a unit"),
    (("synthesise", "quick-return", "--stroke", "300 mm", "--time-ratio", "x"), "such as 1.2"),
    (("synthesise", "radial", "--compression-ratio", "x"), "such as 9.5"),
    (
        ("compare", "3d12", "kamaz_740", "--quantities", "gas_pressure", "-o", "both.csv"),
        "gas_pressure: is a curve, and a file of two machines has facts; write the curves of one, or draw both",
    ),
    (
        ("compare", "3d12", "kamaz_740", "--quantities", "firing_angle", "-o", "both.png"),
        "quantities = firing_angle: has one value for the whole cycle, and no curve",
    ),
    (("plot", "3d12", "--plan", "positions", "--at", "", "-o", "a.png"), '--at = "": must be crank angles in degrees'),
)


@pytest.mark.parametrize(("arguments", "said"), SLIPS, ids=lambda one: " ".join(one) if isinstance(one, tuple) else "")
def test_a_slip_is_answered(typed, tmp_path, arguments, said):
    answer = typed(*arguments)
    assert (answer.status, answer.output) == (2, "")
    assert said in answer.errors
    assert "bug of cranktrain" not in answer.errors
    assert list(tmp_path.iterdir()) == []


def test_a_machine_file_may_have_any_name_without_an_ending(typed, tmp_path):
    assert typed("new", "slider_crank", "-o", "engine").status == 0
    assert typed("run", "engine", "--step", "30").status == 0
    assert [path.name for path in tmp_path.iterdir()] == ["engine"]
