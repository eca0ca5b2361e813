"""The program as a person starts it: another process, a folder of its own."""

import os
import select
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from tests.browser import Watched, browser
from tests.client import installed

import cranktrain as ct
from cranktrain.cli import main
from cranktrain.web.standalone import standalone_page

SOURCE = Path(__file__).parents[2] / "src"
SOON = """
import sys
import cranktrain.cli.how_far as how_far
how_far._LONG, how_far._SEEN, how_far._BETWEEN = 0.02, 0.02, 0.005
from cranktrain.cli import main
sys.exit(main(sys.argv[1:]))
"""
"""The program where work is long, and told, after much less time than it is."""


def environment(**more: str) -> dict[str, str]:
    left_out = ("COLUMNS", "FORCE_COLOR", "LANG", "LC_ALL", "NO_COLOR", "CRANKTRAIN_TRACEBACK")
    plain = {name: value for name, value in os.environ.items() if name not in left_out}
    return plain | {"PYTHONPATH": str(SOURCE), "PYTHONUTF8": "1", "LANGUAGE": "en"} | more


def stopped(asked: tuple[str, ...], times: int) -> tuple[int, bytes]:
    """Start the program at a terminal, and send it Ctrl-C when it has told that often: its status, and what it said."""
    pty = pytest.importorskip("pty")
    child, terminal = pty.fork()
    if child == 0:
        os.execve(sys.executable, [sys.executable, "-c", SOON, *asked], environment())
    said, is_sent, since = b"", False, time.monotonic()
    while time.monotonic() - since < 60:
        try:
            if select.select([terminal], [], [], 0.5)[0]:
                said += os.read(terminal, 65536)
        except OSError:
            break
        if not is_sent and said.count(b"Ctrl-C ends it") >= times:
            os.kill(child, signal.SIGINT)
            is_sent = True
    return os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]), said


@pytest.fixture
def cranktrain(tmp_path):
    """Start the program in an empty folder and wait for its end."""

    def started(*arguments: str, **settings) -> subprocess.CompletedProcess[str]:
        command = [sys.executable, "-m", "cranktrain", *arguments]
        settings = {"cwd": tmp_path, "env": environment(), "stdout": subprocess.PIPE} | settings
        return subprocess.run(command, stderr=subprocess.PIPE, encoding="utf-8", check=False, **settings)

    return started


@pytest.fixture
def typed(capsys, monkeypatch, tmp_path):
    """Run the program in this process, where nothing is asked but what it says and writes."""
    monkeypatch.chdir(tmp_path)

    def answer(*arguments: str) -> subprocess.CompletedProcess[str]:
        capsys.readouterr()
        status = main(arguments)
        return subprocess.CompletedProcess(arguments, status, *capsys.readouterr())

    return answer


@pytest.fixture
def starting(tmp_path):
    """Start the program in an empty folder, and do not wait."""

    def started(*arguments: str) -> subprocess.Popen[str]:
        command = [sys.executable, "-m", "cranktrain", *arguments]
        return subprocess.Popen(
            command, cwd=tmp_path, env=environment(), stdout=subprocess.PIPE, stderr=subprocess.PIPE, encoding="utf-8"
        )

    return started


@pytest.fixture(scope="module")
def chromium():
    """A browser; while it is there nothing else may run in a loop of events, so that each file of tests has its own."""
    with browser() as one:
        yield one


@pytest.fixture(scope="session")
def written(tmp_path_factory):
    """Addresses of pages that stand alone, by example."""
    folder, found = tmp_path_factory.mktemp("pages"), {}

    def address(name):
        if name not in found:
            path = folder / f"{name}.html"
            path.write_text(standalone_page(ct.run(name)), encoding="utf-8")
            found[name] = path.as_uri()
        return found[name]

    return address


@pytest.fixture
def opened(chromium, written):
    """Open such a page at a place; nothing may go wrong on it."""
    contexts = []

    def open_page(name, place="#phi=0", width=1440, height=900, **more):
        contexts.append(chromium.new_context(viewport={"width": width, "height": height}, **more))
        watched = Watched(contexts[-1], written(name) + place)
        found.append(watched)
        return watched.page

    found = []
    yield open_page
    for context in contexts:
        context.close()
    assert [fault for one in found for fault in one.faults] == []


@pytest.fixture(scope="session")
def axe(tmp_path_factory):
    """The program that looks for faults, as the lock file of the client names it."""
    path = installed(tmp_path_factory.mktemp("with_axe")) / "node_modules/axe-core/axe.min.js"
    return path.read_text(encoding="utf-8")
