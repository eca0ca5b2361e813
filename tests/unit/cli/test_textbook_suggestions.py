"""Commands that a first screen of `textbook` suggests: each of them answers as it stands, and fits the screen."""

import re
import shlex

import pytest

from cranktrain.io.examples import example_names
from cranktrain.texts.contents import TEXTS

SCREENS = [
    *(("textbook", name) for name in example_names()),
    *(("textbook", name, "--table") for name in ("3d12", "10d100", "mill_engine", "tilting_table")),
    *(("textbook", "10d100", "--source", text.letter) for text in TEXTS),
    *(("textbook", "tilting_table", "--source", text.letter) for text in TEXTS),
    *(("textbook", "--source", text.letter) for text in TEXTS),
    ("textbook", "--source"),
    ("textbook", "errata"),
    ("textbook", "3d12", "--errata"),
    ("textbook", "3d12", "--forces", "kN", "--set", "shaft.main.speed=1000 rpm"),
    ("textbook", "3d12", "--harmonics"),
    ("textbook", "--drive", "example", "--at", "30"),
    ("textbook", "--drive", "tilting_table", "--set", "load.table.sense=resisting"),
    ("textbook", "--throw", "example"),
    ("textbook", "--throw", "kamaz_740", "--throw-number", "3", "--at", "420"),
]
PLACEHOLDERS = {"FILE", "NAME", "NUMBER", "UNIT"}


def commands(output):
    """Every command of a screen, as a shell would take it."""
    whole = re.sub(r"\s+", " ", re.sub(r" \\\n +", " ", output))
    return re.findall(r"`(cranktrain [^`]+)`", whole)


@pytest.mark.parametrize("kind", ["crank_rocker", "slider_crank"])
def test_new_machines_suggest_what_answers(typed, kind):
    typed("new", kind, "-o", "own.toml")
    for command in commands(typed("textbook", "own.toml").output):
        assert typed(*shlex.split(command)[1:]).status == 0, command


def test_every_suggested_command_answers(typed):
    suggested = {}
    for screen in SCREENS:
        answer = typed(*screen)
        assert (answer.status, answer.errors) == (0, ""), screen
        for command in commands(answer.output):
            words = shlex.split(command)[1:]
            if PLACEHOLDERS.isdisjoint(words):
                suggested[tuple(words)] = screen
            else:
                assert not {*screen} & {*example_names()}, (screen, command)
    assert len(suggested) > len(example_names())
    failed = {words: screen for words, screen in suggested.items() if typed(*words).status}
    assert failed == {}
