"""A page from Python: what it is, where it is kept, of what there is none."""

import pytest

import cranktrain as ct


def test_a_view_says_what_it_is_and_is_kept_as_a_file(tmp_path):
    view = ct.run("textbook_78x78").view()
    assert repr(view).startswith("<page, ")
    view.save(tmp_path / "page.html")
    assert (tmp_path / "page.html").read_text(encoding="utf-8") == view.html
    with pytest.raises(ct.InputError, match="already"):
        view.save(tmp_path / "page.html")


def test_a_notebook_shows_it_in_a_frame_that_reaches_nothing():
    shown = ct.run("textbook_78x78").view()._repr_html_()
    assert shown.startswith('<iframe srcdoc="&lt;!doctype html&gt;')
    assert 'sandbox="allow-scripts"' in shown


def test_there_is_none_of_some_quantities_or_of_several_designs():
    with pytest.raises(ct.InputError, match="run the machine without"):
        ct.run("textbook_78x78", quantities=["stroke"]).view()
    machine = ct.load("textbook_78x78")
    with pytest.raises(ct.InputError, match="several designs"):
        ct.run([machine, machine]).view()
