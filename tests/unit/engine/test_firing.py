"""When pistons fire: even and uneven engines, and orders that cannot be."""

import numpy as np
import pytest
from tests.machines import V12, banks, slave, slider, throws

import cranktrain as ct
from cranktrain.engine.firing import firing_angles, within_turn


def fired(shaft, bank, **cylinder):
    result = ct.run(ct.Machine(shaft=shaft, bank=bank, cylinder=cylinder))
    return (
        dict(zip(result.labels["piston"], result.firing_angle, strict=True)),
        dict(zip(result.labels["piston"], result.firing_interval, strict=True)),
        result,
    )


def refused(shaft, bank, **cylinder):
    with pytest.raises(ct.InputError) as caught:
        ct.run(ct.Machine(shaft=shaft, bank=bank, cylinder=cylinder))
    (problem,) = caught.value.problems
    return problem


@pytest.mark.parametrize(
    ("tops", "turns", "expected"),
    [
        ([0, 180, 180, 0], 2, [0, 180, 540, 720 - 360]),
        ([0, 45], 2, [0, 405]),  # a 45° V-twin: 405 and 315, not 45 and 675
        ([0, 0], 2, [0, 360]),  # pins together: a turn apart
        ([0, 180], 2, [0, 180]),  # a flat twin on one pin: 180 and 540, whichever turn it is
        ([0, 180], 1, [0, 180]),
        ([0, 0], 1, [0, 0]),  # two-stroke, pins together: at the same time
        ([300, 60], 1, [300, 420]),
        ([300, 60], 2, [300, 780]),  # 480 and 240, not 120 and 600
        ([0, 120, 240], 2, [0, 120 + 360 * 0, 240 + 360 * 1]),
        ([0, 240, 120], 1, None),
        ([0, 240, 120], 2, [0, 240, 480]),
        ([10], 2, [10]),
    ],
)
def test_firing_angles(tops, turns, expected):
    found = firing_angles(np.radians(tops), 2 * np.pi * turns)
    if expected == [0, 180, 540, 360]:
        assert found is None  # the last would fire before the third
    elif expected is None:
        assert found is None
    elif expected == [0, 120, 600]:
        # 120, 120, 480 cost more than 120, 480, 120: one of the two evener choices is taken
        squares = np.sum(np.diff(np.degrees([*found, found[0] + 4 * np.pi])) ** 2)
        assert squares == pytest.approx(120**2 + 120**2 + 480**2)
    else:
        np.testing.assert_allclose(np.degrees(found), expected)
