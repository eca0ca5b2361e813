"""More designs than are run at once give what each gives alone, and no more is kept of them than was asked for."""

import numpy as np
import pytest
from tests.machines import V12
from tests.told import texts_of

import cranktrain as ct
from cranktrain.analysis.blocks import MOST_AT_ONCE, block_sizes
from cranktrain.errors import InputError
from cranktrain.saying.checks import Flag

N = 2 * MOST_AT_ONCE
"""Blocks of one size would not tell the design axis from any other."""


def design(i):
    engine = {**V12["cylinder"], "bore": f"{150 + 0.1 * i!r} mm"}
    return ct.Machine(**(V12 | {"cylinder": engine}))


@pytest.mark.parametrize("n", [1, MOST_AT_ONCE, MOST_AT_ONCE + 1, N, 3 * MOST_AT_ONCE, 1000])
def test_sizes_of_blocks(n):
    sizes = block_sizes(n)
    assert sum(sizes) == n
    assert max(sizes) <= MOST_AT_ONCE + 1
    assert len(sizes) == 1 or len(set(sizes)) > 1


@pytest.fixture(scope="module")
def several():
    return ct.run([design(i) for i in range(N)], step_degrees=30.0)


@pytest.mark.parametrize("i", [0, MOST_AT_ONCE, MOST_AT_ONCE + 1, N - 1])
def test_each_design_is_as_if_alone(several, i):
    alone = ct.run(design(i), step_degrees=30.0)
    assert list(several.catalogue) == list(alone.catalogue)
    for name in alone.catalogue:
        values = getattr(several, name)
        assert len(values) == N, name
        np.testing.assert_array_equal(values[i], getattr(alone, name), err_msg=name)
    assert several.summary(i) == alone.summary()
    assert texts_of(check.verdict(i) for check in several.checks) == texts_of(check.verdict() for check in alone.checks)
    assert set(texts_of(alone.flags)) <= set(texts_of(several.flags))
    assert several.missing == alone.missing
    assert several.labels["design"][i] == str(i + 1)
    assert several.dataset.stroke.sizes == {"design": N, "piston": 12}


def test_flags_of_later_blocks_are_told_with_their_designs():
    """Speeds that nobody ever ran stand in the last block alone; no block before it has any flag."""
    fast = [N - 3, N - 1]
    machines = [design(i) for i in range(N)]
    for i in fast:
        machines[i] = machines[i].with_({"shaft.main.speed": f"{2e5 + i} rpm"})
    several = ct.run(machines, step_degrees=30.0)
    flags = [flag for flag in several.flag_words if isinstance(flag, Flag)]
    assert {i for flag in flags for i in flag.own} == set(fast)
    for i in fast:
        alone = [str(flag) for flag in ct.run(machines[i], step_degrees=30.0).flag_words]
        own = [str(flag.own[i]) for flag in flags if i in flag.own]
        assert own
        assert set(own) <= set(alone)


def test_what_is_asked_for_is_kept():
    result = ct.run([design(i) for i in range(N)], quantities=["displacement"])
    assert result.displacement.shape == (N,)
    assert [type(outcome).__name__ for outcome in result.outcomes] == ["SweptVolumes"]


def test_all_errors_of_all_blocks_at_once():
    machines = [design(i) for i in range(N)]
    for i, length in ((1, "10 mm"), (N - 1, "11 mm")):
        machines[i] = machines[i].with_({"bank.L.mechanism.rod_length": length})
    with pytest.raises(InputError) as refusal:
        ct.run(machines)
    assert {problem.given for problem in refusal.value.problems} >= {"10 mm", "11 mm"}


def test_a_speed_of_its_own_for_each_design():
    angle = np.radians(np.arange(0, 720, 30.0))
    speeds = 100 + np.arange(N)[:, np.newaxis] + np.sin(angle)
    result = ct.run([design(i) for i in range(N)], speed=speeds, step_degrees=30.0, quantities="piston_velocity")
    alone = ct.run(design(N - 1), speed=speeds[-1], step_degrees=30.0, quantities="piston_velocity")
    np.testing.assert_allclose(result.piston_velocity[-1], alone.piston_velocity, rtol=1e-12, atol=1e-12)
