"""Work that takes long says on the standard error how far it is; what is short says nothing."""

import os
import subprocess
import sys

import pytest
from tests.e2e.conftest import SOON, environment

from cranktrain.how_far import listened_to, say_how_far, within

RUN = ("run", "pumping_unit_c57")
ASKED = [
    (RUN, " s  "),
    (("compare", "3d12", "kamaz_740"), " of "),
    (("start", "tilting_table", "--set", "drive.start.duration=20 s"), "turns, "),
    (("synthesise", "counterweights", "vaz_21213"), " of "),
]


@pytest.mark.parametrize(("arguments", "said"), ASKED, ids=lambda part: part[0] if isinstance(part, tuple) else "")
def test_long_work_says_how_far_it_is(typed, arguments, said):
    """Lines of their own where no terminal is; the answer is the same as where nothing is said, which is caught."""
    command = [sys.executable, "-c", SOON, *arguments]
    done = subprocess.run(command, env=environment(), capture_output=True, encoding="utf-8", check=False)
    quiet = typed(*arguments)
    assert quiet.stderr == ""
    assert done.returncode == 0
    assert said in done.stderr
    assert "\r" not in done.stderr
    assert done.stdout == quiet.stdout


def test_a_terminal_has_one_line_that_is_gone_before_the_answer():
    pty = pytest.importorskip("pty")
    child, terminal = pty.fork()
    if child == 0:
        os.execve(sys.executable, [sys.executable, "-c", SOON, *RUN], environment())
    said = b""
    while True:
        try:
            more = os.read(terminal, 65536)
        except OSError:
            break
        if not more:
            break
        said += more
    assert os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) == 0
    progress, _gap, answer = said.rpartition(b"\r" + b" " * 78 + b"\r")
    assert b" s  " in progress
    assert b"Motion" not in progress
    assert b"Motion" in answer


def test_short_work_says_nothing(cranktrain):
    done = cranktrain("run", "vaz_21213")
    assert (done.returncode, done.stderr) == (0, "")


def test_pieces_of_pieces_are_said_together():
    heard = []
    say_how_far(lambda: "nobody listens")
    with listened_to(heard.append), within(lambda: "design 3"):
        say_how_far(lambda: "forces")
        with within(lambda: "turn 2"):
            say_how_far(lambda: "bearing 1")
        say_how_far(lambda: "torque")
    assert [[words() for words in one] for one in heard] == [
        ["design 3", "forces"],
        ["design 3", "turn 2", "bearing 1"],
        ["design 3", "torque"],
    ]
