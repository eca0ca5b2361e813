"""What an answer rests on, in a line: what the way to its quantities reads, counted in the words of the terminal."""

import re
from functools import cache

import pytest

import cranktrain as ct
from cranktrain.analysis.answer import rows_that_say_most, rows_under
from cranktrain.analysis.behind import tables_behind
from cranktrain.cli import main
from cranktrain.io.examples import example_names
from cranktrain.io.input_sections import inputs_behind
from cranktrain.io.machine_file import computed, inputs_of, inputs_of_machine
from cranktrain.io.machine_source import source_called
from cranktrain.io.rests_on import rests_on
from cranktrain.saying.amounts import KEPT
from cranktrain.web.page import tab_names


@cache
def known(name):
    file = source_called(name).with_set((), partial=True)
    return file, computed(file, partial=True)


def said(name, title, **machine):
    result = known(name)[1] if not machine else ct.run(ct.load(name).with_(machine))
    return rests_on(result, title, rows_that_say_most(result, title, rows_under(result, title))).replace(KEPT, " ")


@pytest.mark.parametrize("name", example_names())
def test_a_machine_has_the_numbers_of_its_file(name):
    file, result = known(name)
    assert inputs_of_machine(result.machines[0]) == inputs_of(file)


@pytest.mark.parametrize("name", example_names())
def test_tables_behind_headlines_are_those_of_the_whole_way(name):
    _file, result = known(name)
    machine = result.machines[0]
    headlines = [one for question in machine.questions for one in question.headline if one in result.catalogue]
    for quantity in headlines[::3]:
        assert tables_behind(machine, result.computed.kinds, [quantity]) == result.behind(quantity).tables, quantity


def test_inputs_are_those_that_whence_names():
    file, result = known("3d12")
    ways = [result.behind(name) for name in ("stroke", "mean_piston_speed")]
    behind = {one.path: one.given.status for way in ways for one in inputs_behind(file, way)}
    statuses = list(behind.values())
    counted = f"{len(behind)} inputs, of which {statuses.count('assumed')} assumed, {statuses.count('fitted')} fitted"
    assert said("3d12", "Motion").startswith(f"Rests on {counted} · docs/theory/slider-crank, eqs. (2.7), (2.13) · ")


def test_it_says_what_the_foot_of_the_terminal_says(capsys):
    assert main(["run", "vaz_21213"]) in (0, None)
    foot = capsys.readouterr().out
    book = re.search(r"Textbook forms: .* off", foot)[0]
    assert f" · {book}" in said("vaz_21213", "Motion")


def test_a_number_that_is_set_anew_has_no_status():
    file, result = known("two_throw_compressor")
    behind = inputs_behind(file, result.behind("stroke"))
    (assumed,) = [one for one in behind if one.given.status == "assumed"]
    assert "of which 1 assumed" in said("two_throw_compressor", "Motion")
    assert "assumed" not in said("two_throw_compressor", "Motion", **{assumed.path: assumed.given.text})


@pytest.mark.parametrize("name", example_names())
def test_each_equation_is_cited_once(name):
    _file, result = known(name)
    for title in tab_names(result):
        cited = re.findall(r"\(\d+\.\d+\)", said(name, title))
        assert len(cited) == len(set(cited)), (title, cited)


def test_nothing_is_said_of_nothing():
    assert rests_on(known("3d12")[1], "Motion", ()) == ""
