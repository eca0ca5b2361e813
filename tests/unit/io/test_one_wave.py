"""All that is wrong with a file is told at once: what is wrong with one table hides nothing of another."""

import itertools
import random
import tomllib

import pytest

import cranktrain as ct
from cranktrain.io.examples import example_names, example_text
from cranktrain.io.half_read import problems_of_the_rest

GOOD = """
[shaft.main]
speed = "600 rpm"
[mechanism]
kind = "slider_crank"
stroke = "100 mm"
rod_length = "200 mm"
[cylinder]
bore = "80 mm"
compression_ratio = 9
cycle = "four-stroke"
[masses.piston]
mass = "2 kg"
[masses.rod]
mass = "3 kg"
along = "60 mm"
[load.tool]
on = "piston"
force = "5 N"
[gas]
kind = "otto"
start_pressure = "1 bar"
compression_exponent = 1.3
expansion_exponent = 1.3
pressure_ratio = 3
[balance]
counterweights = "rotating"
"""
FAULTS = {
    "rod_length": ('rod_length = "200 mm"', 'rod_length = "40 mm"'),
    "cylinder": ('bore = "80 mm"', 'bore = "80 kg"'),
    "masses": ('along = "60 mm"', ""),
    "load": ('on = "piston"', 'on = "pistn"'),
    "gas": ("pressure_ratio = 3", "pressure_ratio = -3"),
    "balance": ('counterweights = "rotating"', "share = 0.5"),
    "speed": ('speed = "600 rpm"', 'speed = "600 rmp"'),
    "unknown": ("[cylinder]", "[bogus]\nx = 1\n[cylinder]"),
}
"""Faults that are found when a table is read, and such as only tables together show."""


def problems(text, folder):
    path = folder / "machine.toml"
    path.write_text(text)
    try:
        ct.load(path)
    except ct.InputError as error:
        return {(problem.path, str(problem.allowed)) for problem in error.problems}
    return set()


def with_faults(names):
    text = GOOD
    for name in names:
        old, new = FAULTS[name]
        assert old in text
        text = text.replace(old, new)
    return text


def test_the_file_is_right_without_them(tmp_path):
    assert problems(GOOD, tmp_path) == set()


@pytest.mark.parametrize("pair", list(itertools.combinations(FAULTS, 2)), ids="-".join)
def test_two_faults_give_what_each_gives_alone(pair, tmp_path):
    one, other = (problems(with_faults([name]), tmp_path) for name in pair)
    assert one
    assert other
    both = problems(with_faults(pair), tmp_path)
    assert one & other <= both
    missing = (one | other) - both
    # What a table that cannot be read has to do with another is not judged.
    assert not missing or {path.partition(".")[0] for path, _allowed in missing} & {"gas", "cylinder"}


def test_one_of_each_gives_all(tmp_path):
    paths = {path for path, _allowed in problems(with_faults(FAULTS), tmp_path)}
    assert {
        "mechanism.rod_length",
        "cylinder.bore",
        "masses.rod.along",
        "load.tool.on",
        "gas.pressure_ratio",
        "balance.share",
        "shaft.main.speed",
        "bogus",
    } <= paths


@pytest.mark.parametrize("name", example_names())
def test_no_fault_makes_another_up(name):
    """A table that cannot be read is all that is wrong with an example: the others are right, and stay so."""
    data = tomllib.loads(example_text(name))
    chosen = random.Random(name).choice([key for key, value in data.items() if isinstance(value, dict)])
    data[chosen] = {**data[chosen], "no_such_key": 1} if chosen != "units" else {"pressure": "no unit"}
    with pytest.raises(ct.InputError) as caught:
        ct.Machine(**data)
    alone = {problem.path for problem in caught.value.problems}
    assert {problem.path for problem in problems_of_the_rest(data, caught.value.problems)} <= alone
