"""Valves of a valve gear are no pistons: they have no cylinder, and no place in a firing order."""

import pytest

import cranktrain as ct
from cranktrain.io.description import layout_words
from cranktrain.io.machine_file import read_machine


def test_valves_are_counted_apart():
    assert (
        layout_words(read_machine("lms_class5", ()).machine) == "2 pistons, 2 valves, 2 throws, banks cylinder, valve"
    )
    assert layout_words(read_machine("traction_engine", ()).machine).startswith("1 piston, 1 valve, 1 throw")


def test_a_firing_order_names_the_cylinders_alone():
    settings = ("cylinder.cycle=four-stroke", "cylinder.firing_order=1cylinder 2cylinder")
    result = ct.run(read_machine("lms_class5", settings).machine, quantities="firing_interval")
    assert result.labels["cylinder"] == ("1cylinder", "2cylinder")
    # The second crank is a quarter turn ahead: its cylinder fires that much sooner in the other turn.
    assert result.firing_interval.tolist() == pytest.approx([270, 450], abs=1e-9)
