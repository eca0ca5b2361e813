"""A start that is stopped by Ctrl-C at a terminal shows what was computed so far."""

from tests.e2e.conftest import stopped

ASKED = ("start", "tilting_table", "--set", "drive.start.duration=10000 s")


def test_ctrl_c_shows_what_was_computed():
    status, said = stopped(ASKED, times=6)
    assert status == 0
    assert b"it was stopped" in said


def test_a_page_of_it_says_how_far_it_is_and_ctrl_c_leaves_none(tmp_path):
    page = tmp_path / "page.html"
    asked = ("view", *ASKED[1:], "-o", str(page))
    status, said = stopped(asked, times=6)
    assert status == 130
    assert b" turns, " in said
    assert not page.exists()
