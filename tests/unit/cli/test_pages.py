"""What `view` and `web` take and refuse; what is on a page is tested where it is made, and in a browser."""

import socket

import pytest
from tests.sentences import ALREADY_THERE, FOLDER_NOT_THERE, IS_IT_THE_EXAMPLE, NOT_A_KEY

from cranktrain.cli import view as command

OTHER_NAME = "must end in .html: it is a page"


def test_a_page_is_written_whole(typed, tmp_path):
    answer = typed("view", "textbook_78x78", "-o", "page.html", "--set", "name=a test")
    assert answer == (0, "written: page.html; open it in a browser\n", "")
    text = (tmp_path / "page.html").read_text(encoding="utf-8")
    assert text.startswith("<!doctype html>")
    assert "<title>a test</title>" in text
    assert typed("view", "textbook_78x78", "-o", "-").output.startswith("<!doctype html>")


@pytest.mark.parametrize(
    ("typed_in", "said"),
    [
        (("textbook_78x78",), "-o: is missing: the name of the page, which ends in .html; write -o page.html"),
        (("textbook_78x78", "-o", "a.png"), f'-o = a.png: {OTHER_NAME}; write "a.html"'),
        (("textbook_78x78", "-o", "page"), f'-o = page: {OTHER_NAME}; write "page.html"'),
        (("textbook_78x78", "-o", "none/page.html"), f"none/page.html  {FOLDER_NOT_THERE}"),
        (("3d13", "-o", "page.html"), IS_IT_THE_EXAMPLE),
        (("textbook_78x78", "-o", "page.html", "--set", "bore=1 mm"), f"--set  bore = 1 mm: {NOT_A_KEY}"),
    ],
)
def test_what_is_wrong_is_said_and_nothing_written(typed, tmp_path, typed_in, said):
    answer = typed("view", *typed_in)
    assert answer.status == 2
    assert said in answer.errors
    assert list(tmp_path.iterdir()) == []


def test_a_file_that_is_there_is_refused_before_anything_is_computed(typed, tmp_path, monkeypatch):
    (tmp_path / "page.html").write_text("mine")
    monkeypatch.setattr(command, "computed", None)
    answer = typed("view", "textbook_78x78", "-o", "page.html")
    assert answer.status == 2
    assert ALREADY_THERE in answer.errors
    assert (tmp_path / "page.html").read_text() == "mine"


def test_a_port_that_is_taken_is_refused(typed):
    with socket.socket() as other:
        other.bind(("127.0.0.1", 0))
        other.listen()
        port = str(other.getsockname()[1])
        answer = typed("web", "textbook_78x78", "--no-browser", "--port", port)
    assert answer.status == 2
    assert f"--port = {port}: is taken, or may not be used" in answer.errors


def test_a_file_that_is_wrong_is_not_served(typed, written):
    written("[mechanism]\nkind = 'slider_crank'\nstroke = '80 mm'\n")
    answer = typed("web", "machine.toml", "--no-browser")
    assert answer.status == 2
    assert "mechanism.rod_length" in answer.errors
