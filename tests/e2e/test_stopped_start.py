"""A start that is stopped by Ctrl-C at a terminal shows what was computed so far."""

import os
import select
import signal
import sys
import time

import pytest
from tests.e2e.conftest import SOON, environment

pty = pytest.importorskip("pty")
ASKED = ("start", "tilting_table", "--set", "drive.start.duration=10000 s")


def test_ctrl_c_shows_what_was_computed():
    child, terminal = pty.fork()
    if child == 0:
        os.execve(sys.executable, [sys.executable, "-c", SOON, *ASKED], environment())
    said, is_sent, since = b"", False, time.monotonic()
    while time.monotonic() - since < 60:
        try:
            if select.select([terminal], [], [], 0.5)[0]:
                said += os.read(terminal, 65536)
        except OSError:
            break
        if not is_sent and said.count(b"Ctrl-C ends it") > 5:
            os.kill(child, signal.SIGINT)
            is_sent = True
    assert os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) == 0
    assert b"it was stopped" in said
