"""`start --vary`: facts of starts over values of the file, typed as `sweep --start` is."""

import pytest

VARY = ("--vary", "drive.stage[0].ratio=10, 40", "--wanted", "start_duration,crank_turns")


def test_starts_over_what_is_varied_are_those_of_a_sweep(typed):
    answer = typed("start", "tilting_table", *VARY)
    assert (answer.status, answer.errors) == (0, "")
    assert answer == typed("sweep", "tilting_table", "--start", *VARY)
    assert "1 of 2 starts: it stands still" in " ".join(answer.output.split())


def test_they_are_written(typed, tmp_path):
    answer = typed("start", "tilting_table", *VARY, "-o", "ratios.csv")
    assert answer.status == 0
    assert "start_duration" in (tmp_path / "ratios.csv").read_text(encoding="utf-8")


@pytest.mark.parametrize("option", [("--at", "0.5"), ("--why", "torque of the motor"), ("--full",)])
def test_options_of_one_start_do_not_go_with_it(typed, option):
    answer = typed("start", "tilting_table", *VARY, *option)
    assert (answer.status, answer.output) == (2, "")
    assert answer.errors.startswith(f"{option[0]}: is of one start")


@pytest.mark.parametrize("option", [("--wanted", "start_duration"), ("--yes",)])
def test_options_of_several_starts_need_what_is_varied(typed, option):
    answer = typed("start", "tilting_table", *option)
    assert answer.status == 2
    assert answer.errors.startswith(f"{option[0]}: needs --vary")
