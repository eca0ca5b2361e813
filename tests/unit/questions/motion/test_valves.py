"""Valves of a valve gear are no pistons: they have no cylinder, and no place in a firing order."""

import tomllib

import pytest
from tests.told import lines_of

import cranktrain as ct
from cranktrain.io.description import layout_words
from cranktrain.io.machine_file import read_machine
from cranktrain.mechanisms import KINDS


def test_valves_are_counted_apart():
    assert (
        layout_words(read_machine("lms_class5", ()).machine) == "2 pistons, 2 valves, 2 throws, banks cylinder, valve"
    )
    assert layout_words(read_machine("traction_engine", ()).machine).startswith("1 piston, 1 valve, 1 throw")


def test_a_firing_order_names_the_cylinders_alone():
    settings = ("cylinder.cycle=four-stroke", "cylinder.firing_order=1cylinder 2cylinder")
    result = ct.run(read_machine("lms_class5", settings).machine, quantities="firing_interval")
    assert result.labels["cylinder"] == ("1cylinder", "2cylinder")
    # The second crank is a quarter turn behind: its cylinder fires that much later, evenly in the other turn.
    assert result.firing_interval.tolist() == pytest.approx([450, 270], abs=1e-9)


def test_answers_part_valves_from_pistons():
    """Strokes, dead centres and speeds are of pistons; a valve travels, and is farthest and nearest; all in inches."""
    result = ct.run(ct.load("great_northern"))
    of_piston, of_valve = ("valve" in name for name in result.labels["piston"])
    assert (of_piston, of_valve) == (False, True)
    assert result.top_shift == pytest.approx([0, -109.84], abs=5e-3)
    assert result.mean_piston_speed == pytest.approx([6.10, 1.42], abs=5e-3)
    said = lines_of(result, "Motion")
    assert said[:3] == ["stroke: 30.00 in", "mean piston speed: 6.096 m/s", "largest piston speed: 9.649 m/s"]
    assert said[5:] == [
        "valve travel: 7.000 in",
        "farthest from the shaft: −109.84° after the crank on its line",
        "largest valve speed: 2.234 m/s",
    ]


@pytest.mark.parametrize("kind", ["eccentric", "stephenson"])
def test_of_a_valve_alone_no_piston_is_spoken_of(kind):
    machine = ct.Machine(**tomllib.loads(KINDS.named(kind).example), shaft={"main": {"speed": "100 rpm"}})
    said = ct.run(machine).summary()
    assert "  valve travel: " in said and "  largest valve speed: " in said
    assert "iston" not in said and "dead centre" not in said and "stroke" not in said
