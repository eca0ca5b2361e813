"""The file of `new KIND --full` without its comment marks: each flag of a run explained in it, and it starts."""

import re
import tomllib
from functools import cache

import pytest
from tests.smallest_files import tables_of, without_marks

import cranktrain as ct
from cranktrain.cli.screen.answer import minded
from cranktrain.io.starting import starting_file
from cranktrain.mechanisms import KINDS

EXPLAINED = {
    "Values at a jump are those": "forces jump",
    "The flywheel wanted is for a load that does not depend on the speed": "a smaller flywheel does",
    "The net torque falls to": "the crank drives near its dead positions",
    "The gearbox torque is that of loads and the weight of the crank's body alone": "no other mass",
}
"""How a flag begins that may be left, and what the comment says that stands beside the line behind it."""

every_kind = pytest.mark.parametrize("name", KINDS.names)


@cache
def full_file(name):
    return without_marks(starting_file(KINDS.named(name), full=True))


def marked(text):
    """What `run` marks by `!`."""
    return minded(ct.run(tomllib.loads(text)))


def without_tables(text, comment):
    """The file without the tables in which a comment stands, and those below these."""
    gone = [name for name, part in tables_of(text) if comment in part]
    return "".join(part for name, part in tables_of(text) if not any(f"{name}.".startswith(f"{one}.") for one in gone))


@every_kind
def test_every_flag_is_explained_beside_its_line(name):
    """Both ways: no flag without a comment beside a key, no such comment without its flag."""
    text = full_file(name)
    found = marked(text)
    begun = {start for start in EXPLAINED for one in found if one.startswith(start)}
    assert [one for one in found if not one.startswith(tuple(EXPLAINED))] == []
    beside = {
        start for start, said in EXPLAINED.items() if re.search(rf"^\w+ = .*# .*{said}", text, flags=re.MULTILINE)
    }
    assert beside == begun


@every_kind
def test_what_explains_a_flag_stands_at_its_cause(name):
    """Without the table in which the comment stands, the flag is gone."""
    text = full_file(name)
    for start, said in EXPLAINED.items():
        if said in text:
            left = [one for one in marked(without_tables(text, said)) if one.startswith(start)]
            assert left == [], said


@every_kind
def test_its_start_runs(name):
    """Energy is kept, to a thousand steps of 1e-8 in parts of what was given; a press makes its stroke instead."""
    found = ct.start(tomllib.loads(full_file(name)))
    assert abs(found.energy_left_over) < 1e-5
    assert found.crank_turns > 0.5
