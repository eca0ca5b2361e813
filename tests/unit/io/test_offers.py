"""Tables that are offered to a machine: right in its file, of its size, marked as assumed; none that it has."""

import tomllib

import pytest

import cranktrain as ct
from cranktrain.io.examples import example_names
from cranktrain.io.machine_file import read_machine
from cranktrain.io.machine_source import source_of_text
from cranktrain.io.offers import offered_tables, with_table

RADIUS = 0.04
"""Of the crank of a new slider-crank. [m]"""


@pytest.mark.parametrize("name", example_names())
def test_what_is_offered_is_right_in_the_file_and_new_to_it(name):
    file = read_machine(name, partial=True)
    offered = offered_tables(file)
    assert offered
    for table in offered:
        assert table.key not in file.document.data
        assert list(tomllib.loads(table.text)) == [table.key]
        text = with_table(file, table.key)
        assert text.startswith(file.document.text.rstrip())
        if not any("file" in one for one in file.document.data.get("gas", {})):
            ct.run(source_of_text(text, {}).with_set(partial=True).machine, partial=True)


def numbers_of(text, radius):
    """What is offered to a slider-crank of some size, by path. [as typed]"""
    file = source_of_text(text.format(radius=f"{1e3 * radius:g} mm", rod=f"{3.4e3 * radius:g} mm"), {}).with_set()
    tables = {table.key: tomllib.loads(table.text)[table.key] for table in offered_tables(file)}
    return tables, lambda value: (float(value["value"].split()[0]), value["value"].split(" ", 1)[1])


MACHINE = '[mechanism]\nkind = "slider_crank"\ncrank_radius = "{radius}"\nrod_length = "{rod}"\n'


@pytest.mark.parametrize("times", [0.25, 2.0, 5.0])
def test_sizes_go_with_the_crank_as_those_of_a_similar_machine(times):
    own, read = numbers_of(MACHINE, RADIUS)
    other, _read = numbers_of(MACHINE, RADIUS * times)
    for path, power in (
        (("crankshaft", "journal_diameter"), 1),
        (("crankshaft", "bearing_stiffness"), 1),
        (("masses", "rod", "big_end"), 3),
        (("masses", "rod", "inertia"), 5),
        (("drive", "motor", "speed"), -1),
        (("drive", "motor", "torque"), 3),
    ):
        one, large = own, other
        for key in path:
            one, large = one[key], large[key]
        assert large["status"] == one["status"] == "assumed"
        assert read(large)[1] == read(one)[1]
        assert read(large)[0] == pytest.approx(read(one)[0] * times**power, rel=0.06)


def test_a_size_that_is_nearly_the_same_changes_nothing():
    assert numbers_of(MACHINE, RADIUS)[0] == numbers_of(MACHINE, 1.1 * RADIUS)[0]


def test_what_is_not_offered_is_no_key():
    with pytest.raises(KeyError):
        with_table(read_machine("3d12"), "gas")
