"""`new`: a file of a kind, or a copy of an example."""

import pytest

from cranktrain.io.examples import example_text


def test_an_example_is_copied_as_it_is(typed, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert typed("new", "3D12", "-o", "mine.toml").status == 0
    assert (tmp_path / "mine.toml").read_text(encoding="utf-8") == example_text("3d12")
    assert typed("new", "r-1340").output == example_text("r_1340")


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["new", "3d13"], "did you mean the example 3d12?"),
        (["new", "slidr_crank"], 'write "slider_crank"'),
        (["new", "3d12", "--full"], "--full: must be left out: example 3d12 is copied as it is"),
    ],
)
def test_what_is_neither_is_refused(typed, arguments, said):
    answer = typed(*arguments)
    assert (answer.status, answer.output) == (2, "")
    assert said in answer.errors
