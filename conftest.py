"""Code blocks of README and docs are tests: Python runs, and what `$ cranktrain` prints is compared."""

import contextlib
import doctest
import gc
import importlib
import io
import os
import re
import shlex
import subprocess
import sys
from unittest import mock

import pytest
from sybil import Example, Sybil
from sybil.parsers.myst import CodeBlockParser, PythonCodeBlockParser, SkipParser

# Two workers share the processors, and threads of linear algebra that wait for each other spin.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

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
    plain = {name: value for name, value in os.environ.items() if name not in ("COLUMNS", "LC_ALL", "LANG")}
    environment = plain | {"LANGUAGE": "en", "NO_COLOR": "1"}
    program, *arguments = shlex.split(command.replace("\\\n", ""))
    if program == "cranktrain" and not re.search(r"[|&;<>$`*?~]", command):
        return output_here(arguments, environment)
    return output_of_shell(command, environment)


def output_here(arguments: list[str], environment: dict[str, str]) -> tuple[str, int]:
    """Run the program in this process, which has loaded already what it needs."""
    main = importlib.import_module("cranktrain.cli").main
    stream = io.TextIOWrapper(io.BytesIO(), encoding="utf-8", write_through=True)
    with (
        mock.patch.dict(os.environ, environment, clear=True),
        contextlib.redirect_stdout(stream),
        contextlib.redirect_stderr(stream),
    ):
        status = main(arguments)
    return unpadded(stream.buffer.getvalue().decode()), status


def output_of_shell(command: str, environment: dict[str, str]) -> tuple[str, int]:
    """Run what a shell has to read: a pipe, another program."""
    program = f'cranktrain() {{ {shlex.quote(sys.executable)} -m cranktrain "$@"; }}\n'
    done = subprocess.run(
        ["sh", "-c", program + command],
        env=environment | {"PYTHONPATH": os.pathsep.join(sys.path), "PYTHONUTF8": "1"},
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


def pytest_collection_finish():
    """Look for garbage seldom, and never among the tests, which stay: looking takes a tenth of the time."""
    gc.freeze()
    gc.set_threshold(50_000, 20, 20)


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
