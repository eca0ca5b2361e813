"""What a changed machine keeps of the one that it is like: it is the machine of its tables, or as wrong as they are."""

import pickle
import re

import numpy as np
import pytest
from tests.told import texts_of

import cranktrain as ct
from cranktrain.errors import refuse
from cranktrain.io.examples import example_names
from cranktrain.layout.load_tables import in_place_of_lists
from cranktrain.machine import machine_problems
from cranktrain.paths import path_text, with_values
from cranktrain.quantities import shown_by, units_by_dimension
from cranktrain.saying.catalogue import entries, values

every_example = pytest.mark.parametrize("name", example_names())
WRONG = ("1.7 mm", "-3", 0, 1, True, None, "", [], {}, ["1 mm", "2 mm"], {"value": "2 mm"}, {"kind": "none"})
"""Texts, numbers, lists and tables; hardly any suits where it is put."""


def leaves(data, above=()):
    """Paths of all that the tables of a machine hold, of tables and lists too, with what stands there."""
    for key, value in data.items() if isinstance(data, dict) else enumerate(data):
        yield (*above, key), value
        if isinstance(value, dict | tuple):
            yield from leaves(value, (*above, key))


def afresh(machine, path, value):
    """A machine of the tables as they are with another value, of which nothing was read before."""
    data, paths = with_values(machine.declared, {path: value})
    data, found = machine.typed_in.files_read(in_place_of_lists(data, paths))
    refuse(found)
    return ct.Machine(**data)


def told(make):
    """A machine with all that it knows of its tables, and what is wrong with these together; or all that is wrong."""
    try:
        machine = make()
    except ct.InputError as error:
        return error.problems
    return (
        machine,
        machine.declared,
        [parts for parts, _value in leaves(machine.declared)],
        given(machine),
        machine_problems(machine),
    )


def given(spec):
    """Classes of specs, which of their fields were given, and their values, in the order in which they stand."""
    if isinstance(spec, tuple):
        return [given(one) for one in spec]
    if isinstance(spec, dict):
        return [(name, given(one)) for name, one in spec.items()]
    if not hasattr(type(spec), "model_fields"):
        return spec
    return type(spec), spec.model_fields_set, [given(getattr(spec, name)) for name in type(spec).model_fields]


def assert_is_that_of_its_tables(machine, path, value):
    assert told(lambda: machine.with_({path: value})) == told(lambda: afresh(machine, path, value)), (path, value)


@every_example
def test_wrong_values_beside_right_ones_are_told_as_of_a_new_machine(name):
    machine = ct.load(name)
    for place, (parts, _value) in enumerate(leaves(machine.declared)):
        assert_is_that_of_its_tables(machine, path_text(parts), WRONG[place % len(WRONG)])


def more(value):
    """A little more of a quantity, or the same again as a new object; nothing of what may say something else then."""
    number = re.match(r"\d+(?:\.\d+)?", value) if isinstance(value, str) else None
    if number is not None:
        return f"{1.01 * float(number[0]):.9g}{value[number.end() :]}"
    if isinstance(value, dict):
        return {key: one if key == "file" else again(one) for key, one in value.items()}
    return again(value)


def again(value):
    if isinstance(value, dict):
        return {key: again(one) for key, one in value.items()}
    return [again(one) for one in value] if isinstance(value, tuple) else value


@every_example
def test_a_changed_machine_is_the_one_of_its_tables(name):
    machine = ct.load(name)
    for parts, value in leaves(machine.declared):
        assert_is_that_of_its_tables(machine, path_text(parts), more(value))


def with_one_more(machine):
    """Machines with a little more of one quantity, one of each table of the file, with the path of that."""
    seen = set()
    for parts, value in leaves(machine.declared):
        if parts[0] not in seen and isinstance(value, str) and more(value) != value:
            try:
                changed = machine.with_({path_text(parts): more(value)})
            except ct.InputError:
                continue
            if not machine_problems(changed):
                seen.add(parts[0])
                yield path_text(parts), changed, afresh(machine, path_text(parts), more(value))


@pytest.mark.parametrize("name", ["3d12", "burning_cylinder", "deltic", "pumping_unit_c57", "high_slip_press"])
def test_it_gives_the_same_results_to_the_last_bit(name):
    machine = ct.load(name)
    ct.run(machine).find_all()  # which is of that machine alone
    for path, changed, fresh in with_one_more(machine):
        one, other = ct.run(changed, step_degrees=5), ct.run(fresh, step_degrees=5)
        assert (one.missing, one.unused) == (other.missing, other.unused), path
        for kind in one.computed.kinds:
            for entry in entries(kind):
                found, wanted = values(one.computed[kind], entry), values(other.computed[kind], entry)
                np.testing.assert_array_equal(found, wanted, err_msg=f"{path}: {entry.name}")
        assert texts_of(one.flags) == texts_of(other.flags), path


def test_what_stands_as_it_stood_is_the_same_object():
    machine = ct.load("3d12")
    changed = machine.with_({"bank.L.mechanism.rod_length": "321 mm"})
    assert changed.bank["R"] is machine.bank["R"]
    assert changed.crankshaft is machine.crankshaft
    assert changed.cylinder is machine.cylinder
    assert changed.bank["L"] != machine.bank["L"]
    assert changed.typed_in is machine.typed_in
    assert pickle.loads(pickle.dumps(changed)) == changed


def test_what_was_found_of_the_same_tables_is_not_found_again():
    machine = ct.load("3d12")
    places = machine.places
    assert machine.with_({"gas.cut_off_ratio": "1.4"}).places is places
    for changed in ({"speed": "1600 rpm"}, {"speed": "1 rpm", "acceleration": "1 rpm/s"}):
        assert machine.with_({f"shaft.main.{key}": value for key, value in changed.items()}).places is places
    for path, value in {"shaft.main.throws[1]": "120 deg", "running": "astern", "bank.R.stagger": "1 mm"}.items():
        assert "arranged" not in vars(machine.with_({path: value})), path
    zeroed = machine.with_({"crank_zero": "Y"})
    assert zeroed.places is places
    assert "closing_problems" in vars(machine)
    assert "closing_problems" not in vars(zeroed)


def test_what_is_wrong_is_told_again_in_the_units_of_its_time():
    short = ct.Machine(mechanism={"kind": "slider_crank", "crank_radius": "50 mm", "rod_length": "45 mm"})
    assert "mm" in str(short.closing_problems[0])
    with shown_by(units_by_dimension(["in"])):
        told = short.with_({"name": "short"}).closing_problems
        assert told == ct.Machine(**short.declared).closing_problems


def test_what_a_caller_changes_later_is_no_matter():
    weights = [{"throw": 1, "mass": "1 kg", "radius": "10 mm", "angle": "0 deg"}]
    machine = ct.load("3d12").with_({"balance": {"weight": weights}})
    weights[0]["mass"] = "2 kg"
    assert machine.declared["balance"]["weight"][0]["mass"] == "1 kg"
    assert machine.with_({"name": "same"}).balance.weight[0].mass.text == "1 kg"
