"""All that is wrong with a file is told at once: what is wrong with one table hides nothing of another."""

import functools
import itertools
import random
import tomllib

import pytest

import cranktrain as ct
from cranktrain.io.curve_files import beside, with_curves
from cranktrain.io.examples import EXAMPLES_FOLDER, example_names, example_text
from cranktrain.io.half_read import problems_of_the_rest
from cranktrain.machine import machine_problems

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
    assert one | other <= problems(with_faults(pair), tmp_path)


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


CANNOT_SPEAK = {
    # Where the pins stand is read of the shaft: what stands on it, and how it turns, rests on that.
    "shaft": {"bank", "crankshaft", "cylinder", "drive", "load", "masses", "mechanism", "torsion"},
    # Which parts there are, how they move and at which crank angles, is read of the mechanism.
    "mechanism": {
        "load",
        "masses",
        "friction",
        "guide",
        "gravity",
        "drive",
        "pumping",
        "shaft",
        "rod_load",
        "cylinder",
    },
    "bank": {"masses", "crankshaft", "cylinder", "gas", "load", "shaft", "torsion", "guide", "friction"},
    "angle": {"mechanism", "load", "shaft"},
    # A table of sizes says what another table's number is too large for.
    "crankshaft": {"torsion", "shaft"},
    "cylinder": {"gas", "shaft"},
    "masses": {"torsion", "crankshaft", "balance", "gravity"},
    "load": {"drive", "pumping", "mechanism"},
}
"""Tables of which a rule asks, that cannot speak where the first cannot be read: it has no subject."""
CHANGED = {"unit": "1 furlong", "word": "nobody", "less": "-1 mm"}


def tables_of(value, path=()):
    """Paths of all tables, in lists too."""
    items = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    if path and isinstance(value, dict) and "value" not in value:
        yield path
    for key, inner in items:
        yield from tables_of(inner, (*path, key))


def put(data, path, value):
    if not path:
        return value
    first, *rest = path
    old = data[first] if not isinstance(data, dict) or first in data else None
    new = put(old, rest, value)
    return {**data, first: new} if isinstance(data, dict) else [*data[:first], new, *data[first + 1 :]]


def faults_of(data):
    """A key that no table has in each of the tables; and values that cannot be, one of each kind in each of them."""
    for path in tables_of(data):
        yield (*path, "no_such_key"), 1
        table = functools.reduce(lambda inner, key: inner[key], path, data)
        keys = [key for key, value in table.items() if isinstance(value, str) and key != "kind"]
        yield from (((*path, key), value) for key, value in zip(keys, itertools.cycle(CHANGED.values()), strict=False))


def told(data):
    filled, unread = with_curves(data, beside(EXAMPLES_FOLDER))
    try:
        found = machine_problems(ct.Machine(**filled))
    except ct.InputError as error:
        found = (*error.problems, *problems_of_the_rest(filled, error.problems))
    return {(problem.path, str(problem.allowed)) for problem in (*unread, *found)}


@pytest.mark.parametrize("name", example_names())
def test_a_fault_of_any_table_hides_none_of_another(name):
    data = tomllib.loads(example_text(name))
    each = [(path, value, found) for path, value in faults_of(data) if (found := told(put(data, path, value)))]
    pairs = list(itertools.permutations(each, 2))
    for (path, value, first), (other, changed, second) in random.Random(name).sample(pairs, min(len(pairs), 60)):
        if path[0] == other[0]:
            continue
        both = {where for where, _allowed in told(put(put(data, path, value), other, changed))}
        hidden = {where for where, _allowed in first | second} - both
        assert not hidden or other[0] in CANNOT_SPEAK.get(path[0], ()) or path[0] in CANNOT_SPEAK.get(other[0], ()), (
            path,
            other,
            hidden,
        )


def test_a_disc_beside_no_throw_is_told_beside_a_rod_that_cannot_be_read():
    data = tomllib.loads(example_text("inline_six"))
    disc = next(iter(data["torsion"]["disc"]))
    wrong = put(
        put(data, ("torsion", "disc", disc, "beside"), 99), ("bank", "line", "mechanism", "stroke"), "1 furlong"
    )
    assert {f"torsion.disc.{disc}.beside", "bank.line.mechanism.stroke"} == {path for path, _allowed in told(wrong)}


def test_what_one_item_of_a_list_shows_together_is_told_beside_a_key_that_it_does_not_have():
    data = tomllib.loads(example_text("kamaz_740"))
    del data["masses"]["rod"]["big_end"]
    wrong = put(data, ("masses", "rod", "no_such_key"), 1)
    assert {"masses.rod.no_such_key", "masses.rod.big_end"} <= {path for path, _allowed in told(wrong)}


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
