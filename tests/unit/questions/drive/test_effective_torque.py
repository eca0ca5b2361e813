"""Effective torque of a run, from samples at steps of any length."""

import numpy as np
import pytest

from cranktrain.questions.start.facts import effective_torque


@pytest.mark.parametrize("pause", [0.0, 10.0, 1e10])
@pytest.mark.parametrize("idling", [0.0, 5.0])
def test_a_pause_after_a_decay(pause, idling):
    """Torque 40 exp(−2t) + c, all but over after 20 s: the integral of its square in closed form."""
    decay = np.linspace(0.0, 20.0, 10001)
    time = np.concatenate((decay, 20.0 + pause * np.arange(1, 101) / 100)) if pause else decay
    torque = 40.0 * np.exp(-2.0 * time) + idling
    whole = 1600 / 4 + 2 * 40 * idling / 2 + idling**2 * (20.0 + pause)
    assert effective_torque(torque, time) == pytest.approx(np.sqrt(whole / (20.0 + pause)), rel=1e-7)


def test_times_that_rounding_parts_are_one():
    """A jump that rounding has spread over a step of 3e-18 s has no slope."""
    time = np.concatenate((np.linspace(0.0, 0.03, 301), [np.nextafter(0.03, 1.0)], np.linspace(0.031, 1.0, 1001)))
    torque = np.where(time <= 0.03, 0.0, 50.0)
    assert effective_torque(torque, time) == pytest.approx(50.0 * np.sqrt(0.97), rel=1e-3)
