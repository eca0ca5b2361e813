"""Every example is read and run, and every number in it says where it is from."""

import re
import tomllib
from collections.abc import Iterator
from importlib.resources import files
from pathlib import Path

import numpy as np
import pytest

import cranktrain as ct
from cranktrain.quantities import Given

EXAMPLES = sorted(path.name for path in files("cranktrain.examples").iterdir() if path.name.endswith(".toml"))
PAGE = Path(__file__).parents[2] / "docs/examples.md"

LAYOUT = ("throws", "angle", "direction")
"""Keys whose angles are how the machine is laid out; they may stand without a status."""


def text_of(name: str) -> str:
    return files("cranktrain.examples").joinpath(name).read_text(encoding="utf-8")


def machine_of(name: str) -> ct.Machine:
    return ct.Machine(**tomllib.loads(text_of(name)))


def given_numbers(part: object, path: str = "") -> Iterator[tuple[str, Given]]:
    """What a file gives as numbers, with their paths; what it leaves to be assumed is not among them."""
    if isinstance(part, Given):
        yield path, part
    elif isinstance(part, tuple):
        for i, item in enumerate(part):
            yield from given_numbers(item, f"{path}[{i}]")
    elif isinstance(part, dict):
        for name, item in part.items():
            yield from given_numbers(item, f"{path}.{name}")
    elif hasattr(part, "model_fields_set"):
        for name in sorted(part.model_fields_set):
            yield from given_numbers(getattr(part, name), f"{path}.{name}")


def key_of(path: str) -> str:
    return path.rpartition(".")[2].partition("[")[0]


@pytest.mark.parametrize("name", EXAMPLES)
def test_runs_and_all_its_checks_pass(name):
    result = ct.run(machine_of(name))
    assert result.summary()
    assert result.checks
    assert [check.name for check in result.checks if not np.all(check.passed)] == []


@pytest.mark.parametrize("name", EXAMPLES)
def test_every_number_says_where_it_is_from(name):
    numbers = dict(given_numbers(machine_of(name)))
    assert len(numbers) >= 5
    assert [path for path, given in numbers.items() if not given.status and key_of(path) not in LAYOUT] == []


@pytest.mark.parametrize("name", EXAMPLES)
def test_published_numbers_have_a_source_and_the_others_a_reason(name):
    for path, given in given_numbers(machine_of(name)):
        if given.status == "published":
            assert given.source, path
        elif given.status:
            assert given.note, path


@pytest.mark.parametrize("name", EXAMPLES)
def test_sources_and_notes_are_words(name):
    for path, given in given_numbers(machine_of(name)):
        for words in (given.source, given.note):
            assert words is None or (words.strip() and not re.search(r"\[\w+\]", words)), path


@pytest.mark.parametrize("name", EXAMPLES)
def test_begins_by_saying_what_it_is(name):
    text = text_of(name)
    head = text[: text.index("\nname = ")]
    assert all(line.startswith("#") for line in head.splitlines() if line)
    assert "# Look at: " in head
    assert "# Not known: " in head


@pytest.mark.parametrize("name", EXAMPLES)
def test_is_on_the_page_of_examples(name):
    assert f"`{name.removesuffix('.toml')}`" in PAGE.read_text(encoding="utf-8")


def test_names_differ():
    names = [machine_of(name).name for name in EXAMPLES]
    assert all(names)
    assert len(set(names)) == len(names)
