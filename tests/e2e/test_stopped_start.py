"""A start that is stopped by Ctrl-C at a terminal shows what was computed so far."""

from tests.e2e.conftest import stopped

ASKED = ("start", "tilting_table", "--set", "drive.start.duration=10000 s")


def test_ctrl_c_shows_what_was_computed():
    status, said = stopped(ASKED, times=6)
    assert status == 0
    assert b"it was stopped" in said
