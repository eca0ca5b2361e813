"""Code blocks of README and docs are tests: Python runs, and what `$ cranktrain` prints is compared."""

import contextlib
import doctest
import os
import re
import shlex
import subprocess
import sys

import pytest
from sybil import Example, Sybil
from sybil.parsers.myst import CodeBlockParser, PythonCodeBlockParser, SkipParser

TYPED = re.compile(r"^\$ (?P<command>(?:.*\\\n)*.*)\n?(?P<output>(?:(?!\$ ).*\n?)*)", re.MULTILINE)


def run_console(example: Example) -> str | None:
    """Type the commands of a `console` block that begins with `$ cranktrain`; say how the output differs."""
    if not example.parsed.startswith("$ cranktrain"):
        return None
    for typed in TYPED.finditer(example.parsed):
        got, status = typed_output(typed["command"])
        if status not in (0, 2):
            return f"$ {typed['command']}\nended with status {status}:\n{got}"
        expected = unpadded(typed["output"])
        if not doctest.OutputChecker().check_output(expected, got, doctest.ELLIPSIS):
            return f"$ {typed['command']}\n--- printed in the document\n{expected}--- printed now\n{got}"
    return None


def typed_output(command: str) -> tuple[str, int]:
    """Run a command line in which `cranktrain` is the package that these tests import; its output and status."""
    program = f'cranktrain() {{ {shlex.quote(sys.executable)} -m cranktrain "$@"; }}\n'
    plain = {name: value for name, value in os.environ.items() if name not in ("COLUMNS", "LC_ALL", "LANG")}
    done = subprocess.run(
        ["sh", "-c", program + command],
        env=plain | {"PYTHONPATH": os.pathsep.join(sys.path), "PYTHONUTF8": "1", "LANGUAGE": "en", "NO_COLOR": "1"},
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        encoding="utf-8",
        check=False,
    )
    return unpadded(done.stdout), done.returncode


def unpadded(text: str) -> str:
    """Text without blanks at line ends and without empty lines at its own end."""
    lines = [line.rstrip() for line in text.splitlines()]
    return "\n".join(lines).rstrip("\n") + "\n"


@pytest.fixture(scope="module")
def document_folder(tmp_path_factory: pytest.TempPathFactory):
    """An empty folder in which all blocks of one document run, so that files they write stay among themselves."""
    with contextlib.chdir(tmp_path_factory.mktemp("document")):
        yield


pytest_collect_file = Sybil(
    parsers=[PythonCodeBlockParser(), CodeBlockParser("console", run_console), SkipParser()],
    patterns=["README.md", "docs/**/*.md", "docs/*.md"],
    fixtures=["document_folder"],
).pytest()
