"""The terminal in this process: what was typed in, status and streams out."""

from pathlib import Path
from typing import NamedTuple

import pytest

from cranktrain.cli import main


class Answer(NamedTuple):
    status: int
    output: str
    errors: str


@pytest.fixture
def typed(capsys, monkeypatch, tmp_path):
    monkeypatch.chdir(tmp_path)
    monkeypatch.delenv("CRANKTRAIN_TRACEBACK", raising=False)

    def answer(*arguments: str) -> Answer:
        capsys.readouterr()
        status = main(arguments)
        return Answer(status, *capsys.readouterr())

    return answer


@pytest.fixture
def written(tmp_path):
    """Write a machine file into the folder of the test."""

    def named(text: str, name: str = "machine.toml") -> Path:
        path = tmp_path / name
        path.write_text(text, encoding="utf-8")
        return path

    return named
