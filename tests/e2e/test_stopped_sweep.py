"""A sweep that is stopped by Ctrl-C at a terminal keeps what was computed so far."""

import csv
import os
import select
import signal
import sys
import time

import pytest
from tests.e2e.conftest import SOON, environment

pty = pytest.importorskip("pty")
ASKED = ("sweep", "vaz_21213", "--vary", "rod_length=110..170 mm:90000", "--wanted", "largest_torque", "--yes")


@pytest.mark.parametrize("processes", ["1", "2"])
def test_ctrl_c_keeps_what_was_computed(tmp_path, processes):
    child, terminal = pty.fork()
    if child == 0:
        asked = (*ASKED, "--processes", processes, "-o", str(tmp_path / "rods.csv"))
        os.execve(sys.executable, [sys.executable, "-c", SOON, *asked], environment())
    said, is_sent, since = b"", False, time.monotonic()
    while time.monotonic() - since < 60:
        try:
            if select.select([terminal], [], [], 0.5)[0]:
                said += os.read(terminal, 65536)
        except OSError:
            break
        if not is_sent and said.count(b"Ctrl-C ends it") > 2:
            os.kill(child, signal.SIGINT)
            is_sent = True
    assert os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) == 0
    assert b"written: " in said
    assert b"Traceback" not in said
    lines = (tmp_path / "rods.csv").read_text(encoding="utf-8").splitlines()
    assert any("of 90000 designs: not computed" in line for line in lines if line.startswith("#"))
    torques = [row["largest_torque [N*m]"] for row in csv.DictReader(line for line in lines if line[0] != "#")]
    assert len(torques) == 90000
    n_known = sum(torque not in ("", "nan") for torque in torques)
    assert 4 <= n_known < 90000
    assert all(torque not in ("", "nan") for torque in torques[:n_known])
