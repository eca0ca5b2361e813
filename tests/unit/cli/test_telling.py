"""What a terminal is told while a start runs: nothing of one that is soon over, as those of notebooks are."""

import io
import time

import pytest

from cranktrain.cli import main, start


class Terminal(io.StringIO):
    def isatty(self):
        return True


@pytest.mark.parametrize(("patience", "is_told"), [(3600.0, False), (0.0, True)])
def test_a_short_run(monkeypatch, capsys, patience, is_told):
    monkeypatch.setattr(start, "_PATIENCE", patience)
    terminal = Terminal()
    monkeypatch.setattr("sys.stderr", terminal)
    assert main(["start", "jaw_crusher", "--set", "drive.start.duration=0.3 s"]) == 0
    assert ("Ctrl-C ends it" in terminal.getvalue()) == is_told
    assert terminal.getvalue().rpartition("\r")[0].endswith(" " * 60) == is_told
    assert "Start" in capsys.readouterr().out


def test_a_run_that_lasts_is_told_after_a_second():
    assert start._PATIENCE < 5.0
    told = start._Told(time.monotonic() - 2.0)
    told.clear()
    assert not told.is_line_there
