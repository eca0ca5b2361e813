"""Which tests are quick is read off what they took."""

import pytest
from tests import times

CHEAP, DEAR, LESSON = "a.py::test_cheap[{}]", "a.py::test_dear[{}]", "README.md::line:{},column:1"


@pytest.fixture
def table(monkeypatch, tmp_path):
    path = tmp_path / "times.txt"
    path.touch()
    monkeypatch.setattr(times, "TABLE", path)
    return path


def quick(*cases):
    known = times.read_times()
    return [case for case in cases if times.is_quick(case, known)]


def test_all_cases_of_a_cheap_function_and_the_quickest_of_a_dear_one(table):
    measured = {CHEAP.format(1): 0.04, CHEAP.format(2): 0.05, DEAR.format(1): 3.0, DEAR.format(2): 0.09}
    times.write_times(measured, {}, {})
    assert quick(*measured) == [CHEAP.format(1), CHEAP.format(2), DEAR.format(2)]
    assert quick("a.py::test_new") == ["a.py::test_new"]
    assert len(table.read_text(encoding="utf-8").splitlines()) == 1


def test_blocks_of_a_document_go_together(table):
    measured = {LESSON.format(1): 0.01, LESSON.format(9): 0.5}
    times.write_times(measured, {}, {})
    assert quick(*measured) == []
    times.write_times({LESSON.format(1): 0.01, LESSON.format(9): 0.02}, {}, {})
    assert quick(*measured) == list(measured)


def test_what_takes_long_alone_is_not_quick(table):
    """Another case made what they share: once it is measured alone, it is seen, and stays seen."""
    times.write_times({DEAR.format(1): 3.0, DEAR.format(2): 0.01}, {}, {})
    times.write_times({DEAR.format(2): 2.9}, {}, times.read_times())
    assert quick(DEAR.format(1), DEAR.format(2)) == []
    assert times.read_times()["a.py::test_dear"].together == 3.01


def test_what_one_case_is_prepared_for_others_may_need(table):
    times.write_times({CHEAP.format(1): 0.01, DEAR.format(1): 60.0}, {"a.py": 59.0}, {})
    assert quick(CHEAP.format(1), DEAR.format(1), "b.py::test_other") == ["b.py::test_other"]
