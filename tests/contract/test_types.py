"""Types are strict, says the type checker, which `tests/conftest.py` starts beside the tests."""

from tests.beside import type_checker_outcome


def test_type_checker_finds_nothing():
    status, words = type_checker_outcome()
    assert status == 0, words
