"""Processes of a service find what its tests ask them."""

from pathlib import Path

import pytest

ROOT = Path(__file__).parents[3]


@pytest.fixture(autouse=True)
def _found_by_processes(monkeypatch):
    """They find what this process finds; its own way to the tests is none of Python's."""
    monkeypatch.syspath_prepend(ROOT)
