"""A notebook is told how far long work is, in one line that is written anew; anybody else is told nothing."""

import sys
from types import SimpleNamespace

import pytest
from tests.swept import MACHINE

import cranktrain as ct
from cranktrain.io import notebook_line
from cranktrain.study.sweep import computed

VARY = {"rod_length": "130..150 mm:40"}


@pytest.fixture(autouse=True)
def soon(monkeypatch):
    monkeypatch.setattr(notebook_line, "_SEEN", 0.0)
    monkeypatch.setattr(notebook_line, "_BETWEEN", 0.0)
    monkeypatch.setattr(computed, "_designs_of_block", lambda *_known: 10)
    monkeypatch.setattr(computed, "_MEASURED", 0.0)


@pytest.mark.parametrize("kernel", [object(), None])
def test_one_line_that_is_gone_at_the_end(monkeypatch, capsys, kernel):
    monkeypatch.setitem(sys.modules, "IPython", SimpleNamespace(get_ipython=lambda: SimpleNamespace(kernel=kernel)))
    ct.sweep(MACHINE, VARY, "stroke")
    said = capsys.readouterr().out
    if kernel is None:
        assert said == ""
        return
    lines = [line.strip() for line in said.split("\r")]
    assert any(line.startswith("10 of 40 designs, ") and "s left" in line for line in lines)
    assert lines[-1] == lines[-2] == ""
    assert "\n" not in said


def test_a_script_is_told_nothing(capsys):
    ct.sweep(MACHINE, VARY, "stroke")
    assert capsys.readouterr().out == ""
