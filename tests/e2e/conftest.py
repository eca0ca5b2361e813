"""The program as a person starts it: another process, a folder of its own."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

SOURCE = Path(__file__).parents[2] / "src"


def environment(**more: str) -> dict[str, str]:
    left_out = ("COLUMNS", "FORCE_COLOR", "LANG", "LC_ALL", "NO_COLOR", "CRANKTRAIN_TRACEBACK")
    plain = {name: value for name, value in os.environ.items() if name not in left_out}
    return plain | {"PYTHONPATH": str(SOURCE), "PYTHONUTF8": "1", "LANGUAGE": "en"} | more


@pytest.fixture
def cranktrain(tmp_path):
    """Start the program in an empty folder and wait for its end."""

    def started(*arguments: str, **settings) -> subprocess.CompletedProcess[str]:
        command = [sys.executable, "-m", "cranktrain", *arguments]
        settings = {"cwd": tmp_path, "env": environment(), "stdout": subprocess.PIPE} | settings
        return subprocess.run(command, stderr=subprocess.PIPE, encoding="utf-8", check=False, **settings)

    return started


@pytest.fixture
def starting(tmp_path):
    """Start the program in an empty folder, and do not wait."""

    def started(*arguments: str) -> subprocess.Popen[str]:
        command = [sys.executable, "-m", "cranktrain", *arguments]
        return subprocess.Popen(
            command, cwd=tmp_path, env=environment(), stdout=subprocess.PIPE, stderr=subprocess.PIPE, encoding="utf-8"
        )

    return started
