"""Chains grow by random clicks of all kinds: each gives a machine that runs, or a sentence; what was there stays."""

import numpy as np
import pytest
from tests.clicked_chains import LIE, Lying, added, machine_of, text_of, turning_pins

import cranktrain as ct
from cranktrain.errors import InputError
from cranktrain.io.machine_source import source_of_text
from cranktrain.panels.additions import drawn_additions
from cranktrain.plans.placement import first_throw

TRIES = 12
TURN = np.arange(0.0, 360.0, 15.0)


def turning_machine(text):
    """Read it; refused where links cannot close all round."""
    return source_of_text(text, {}).with_set().machine


def clicks_of(random, addition, lying):
    """Clicks on what each may take, in the order that this says, at places about the press."""
    clicks = []
    now = 0
    while now < len(addition.clicks):
        targets = addition.clicks[now].targets
        target = targets[random.integers(len(targets))]
        place = lying.at(*random.uniform((-0.1, -0.3), (0.6, 0.5)))
        clicks.append((target.name, tuple(map(float, place))))
        now = target.then
    return clicks


@pytest.mark.parametrize("seed", range(16))
def test_each_part_gives_a_machine_that_runs_or_a_sentence(seed):
    random = np.random.default_rng(seed)
    lie = LIE[seed % len(LIE)]
    text, lying = text_of(*lie), Lying(*lie)
    grown = []
    for _try in range(TRIES):
        machine = machine_of(text)
        additions = drawn_additions(machine, first_throw(machine))
        addition = additions[random.integers(len(additions))]
        before = turning_pins(text, TURN)
        try:
            larger = added(text, addition.name, float(random.uniform(-360, 360)), *clicks_of(random, addition, lying))
            turning_machine(larger)
        except InputError as error:
            (problem, *_more) = error.problems
            assert str(problem.allowed).strip()
            continue
        text = larger
        grown.append(addition.name)
        after = turning_pins(text, TURN)
        for name, pin in before.items():
            if not name.endswith(".end"):
                np.testing.assert_array_equal(after[name], pin, err_msg=name)
        assert all(np.all(np.isfinite(pin)) for pin in after.values())
    assert grown, "of so many clicks some give a part"
    result = ct.run(turning_machine(text), step_degrees=5)
    for check in result.checks:
        assert np.all(check.passed), (grown, check.name, check.residual, check.limit)
