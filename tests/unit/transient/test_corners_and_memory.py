"""Loads with corners over the crank angle, gas that remembers, and runs that are watched, by closed forms."""

import math

import numpy as np
import pytest

from cranktrain.transient import endings
from cranktrain.transient.corners import corner_ahead, on_the_way
from cranktrain.transient.equation import DriveTrain, Kernels, no_brake, no_heat, no_motor
from cranktrain.transient.gearing import stages
from cranktrain.transient.runs import run, wanted

DIRECT = stages(0.5)
JUMPS = (1.0, 2.5)


def step_load(angle, _speed, _sense, numbers):
    """A torque from 1 rad to 2.5 rad of every turn."""
    inside = JUMPS[0] <= angle % (2 * math.pi) < JUMPS[1]
    return numbers[0], 0.0, numbers[1] if inside else 0.0, 1.0


def tent_load(angle, _speed, _sense, numbers):
    """Straight lines up from 1 rad and down again to 2.5 rad."""
    place = angle % (2 * math.pi)
    share = max(0.0, 1.0 - abs(place - 1.75) / 0.75)
    return numbers[0], 0.0, numbers[1] * share, 1.0


def without_motor(machine):
    return Kernels(machine, no_motor, no_heat, no_brake)


def turned(machine, work, corners, speed=10.0):
    """Speed after something more than two turns, in which the load has taken its work three times."""
    drive = DriveTrain((1.5, work), (), 0.0, DIRECT)
    asked = wanted(1.8, speed=speed, corners=corners, tolerance=1e-12)
    return run(without_motor(machine), drive, asked, is_compiled=False)


@pytest.mark.parametrize(("machine", "corners", "area"), [(step_load, JUMPS, 1.5), (tent_load, (1.0, 1.75, 2.5), 0.75)])
@pytest.mark.parametrize("sense", [1, -1])
def test_energy_over_corners(machine, corners, area, sense):
    """½Jω² falls by what the load takes, torque times angle; astern the same load drives."""
    found, without = turned(machine, 4.0, corners, 10.0 * sense), turned(machine, 4.0, (), 10.0 * sense)
    n_passed = sum(1 for k in range(-9, 9) if min(0, found.end[0]) < corners[0] + 2 * np.pi * k < max(0, found.end[0]))
    energy = 0.5 * 2.0 * 100.0 - sense * n_passed * area * 4.0
    assert found.reason == endings.TIME_OUT
    assert 0.5 * 2.0 * found.end[1] ** 2 == pytest.approx(energy, rel=1e-10)
    assert found.end[3] == pytest.approx(sense * n_passed * area * 4.0, abs=1e-10 * 100)
    assert found.n_steps < 0.7 * without.n_steps


@pytest.mark.parametrize("sense", [1, -1])
def test_start_on_a_corner_takes_the_side_to_which_it_goes(sense):
    """From the jump forward the load is there at once, astern it is not."""
    asked = wanted(0.01, angle=1.0, speed=10.0 * sense, corners=JUMPS, tolerance=1e-10)
    found = run(without_motor(step_load), DriveTrain((1.5, 4.0), (), 0.0, DIRECT), asked, is_compiled=False)
    slower = 4.0 / 2.0 * 0.01 if sense > 0 else 0.0
    assert abs(found.end[1]) == pytest.approx(10.0 - slower, rel=1e-12)


def test_corners_come_again_after_their_period():
    corners = wanted(1.0, corners=(5.0, -1.0, 4 * np.pi - 1.0, 5.0), period=4 * np.pi).corners
    np.testing.assert_allclose(corners, [5.0, 4 * np.pi - 1.0], rtol=1e-15)


SUCTION, DELIVERY, EXPONENT, CLEARANCE, AREA, CRANK = 1e5, 4e5, 1.3, 0.2, 1e-3, 0.05


def volume(angle):
    return AREA * CRANK * (1 + CLEARANCE - math.cos(angle))


def gas_load(angle, _speed, _sense, numbers):
    """Torque that gas takes which keeps p·Vⁿ between its valves' pressures."""
    inertia, memory, spring = numbers
    room = volume(angle)
    pressure = min(max(memory[0] * room**-EXPONENT, SUCTION), DELIVERY)
    torque = -pressure * AREA * CRANK * math.sin(angle)
    return inertia, 0.0, torque + spring * (angle - math.pi / 2), math.sin(angle)


def settle_gas(angle, numbers):
    room = volume(angle) ** EXPONENT
    numbers[1][0] = min(max(numbers[1][0], SUCTION * room), DELIVERY * room)


GAS = Kernels(gas_load, no_motor, no_heat, no_brake, settle_gas)


def test_gas_that_reaches_no_valve_does_no_work():
    """Rocking about mid-stroke on a spring: after some swings the gas has given back all that it took."""
    memory = [2e5 * volume(math.pi / 2) ** EXPONENT]
    drive = DriveTrain((1.5, memory, 200.0), (), 0.0, DIRECT)
    asked = wanted(5.0, angle=math.pi / 2, speed=1.0, most_reversals=4, tolerance=1e-12, corners=(0.0, math.pi))
    found = run(GAS, drive, asked, is_compiled=False)
    swings = found.of_kind(endings.REVERSAL)
    assert swings[2].angle == pytest.approx(swings[0].angle, abs=1e-10)
    assert swings[3].angle == pytest.approx(swings[1].angle, abs=1e-10)
    assert abs(found.residual) < 1e-10 * 0.5 * 2.0
    assert memory == [2e5 * volume(math.pi / 2) ** EXPONENT]


def test_a_full_turn_does_the_work_of_the_cycle():
    """Polytropic compressor: n/(n − 1) p_s (V_1 − V_4) ((p_d/p_s)^((n−1)/n) − 1), from one bottom to the next."""
    drive = DriveTrain((5.0, [SUCTION * volume(math.pi) ** EXPONENT], 0.0), (), 0.0, DIRECT)
    asked = wanted(0.9, angle=math.pi, speed=10.0, corners=(0.0, math.pi), tolerance=1e-12)
    top, bottom = run(GAS, drive, asked, is_compiled=False).of_kind(endings.DEAD_POSITION)[:2]
    assert (top.angle, bottom.angle) == pytest.approx((2 * math.pi, 3 * math.pi), rel=1e-12)
    reexpanded = volume(0.0) * (DELIVERY / SUCTION) ** (1 / EXPONENT)
    ratio = (DELIVERY / SUCTION) ** ((EXPONENT - 1) / EXPONENT)
    work = EXPONENT / (EXPONENT - 1) * SUCTION * (volume(math.pi) - reexpanded) * (ratio - 1)
    assert 0.5 * 5.5 * (10.0**2 - bottom.speed**2) == pytest.approx(work, rel=1e-8)


def test_a_watched_run_gives_the_same():
    drive = DriveTrain((1.5, 4.0), (), 0.0, DIRECT)
    asked = wanted(1.8, speed=10.0, corners=JUMPS)
    told = []
    watched = run(without_motor(step_load), drive, asked, is_compiled=False, progress=lambda *where: told.append(where))
    alone = run(without_motor(step_load), drive, asked, is_compiled=False)
    np.testing.assert_array_equal(watched.end, alone.end)
    assert told[-1] == (1.8, alone.end[0], alone.end[1])


def test_an_interrupted_run_keeps_what_it_has():
    def interrupt(time, _angle, _speed):
        if time > 0.5:
            raise KeyboardInterrupt

    asked = wanted(100.0, speed=10.0, corners=JUMPS, samples=np.linspace(0, 100, 1001))
    drive = DriveTrain((1.5, 0.0), (), 0.0, DIRECT)
    found = run(without_motor(step_load), drive, asked, is_compiled=False, progress=interrupt)
    assert found.reason == endings.STOPPED
    assert 0.5 < found.end_time < 100.0
    assert found.time[-1] <= found.end_time < found.time[-1] + 0.1 + 1e-9
    assert found.end[0] == pytest.approx(10.0 * found.end_time, rel=1e-9)


class Asked(list):
    """Corners that count how often one is looked at."""

    n_looks = 0

    def __getitem__(self, at):
        self.n_looks += 1
        return super().__getitem__(at)


def far_corners(corners, period, angle):
    """All corners of the periods about an angle."""
    turn = math.floor(angle / period)
    return [corner + (turn + more) * period for more in (-2, -1, 0, 1, 2) for corner in corners]


@pytest.mark.parametrize("n", [1, 2, 3, 60])
@pytest.mark.parametrize("period", [2 * math.pi, 4 * math.pi])
@pytest.mark.parametrize("sense", [1.0, -1.0])
def test_the_next_corner_is_the_nearest_of_all(n, period, sense):
    """Anywhere, and on a corner to rounding, where the next one is meant; looked for among all of five periods."""
    chance = np.random.default_rng(n)
    for _ in range(50):
        corners = np.sort(chance.uniform(0, period, n)).tolist()
        anywhere = chance.uniform(-40, 40, 5).tolist()
        standing = [corners[0] + 3 * period, corners[-1] - 2 * period + 1e-14]
        for angle in anywhere + standing:
            each = far_corners(corners, period, angle)
            beyond = min(sense * (at - angle) for at in each if sense * (at - angle) > 1e-12)
            assert sense * (corner_ahead(angle, sense, corners, period) - angle) == pytest.approx(beyond, abs=2e-12)
        for angle in standing:
            assert 0 < sense * (on_the_way(angle, sense, corners, period) - angle) < 1e-12
        assert [on_the_way(angle, sense, corners, period) for angle in anywhere] == anywhere


@pytest.mark.parametrize("sense", [1.0, -1.0])
def test_a_corner_is_found_by_halving(sense):
    """Twice log2 of their number, and a few."""
    corners = Asked(np.linspace(0, 2 * math.pi, 4096, endpoint=False).tolist())
    corner_ahead(17.0, sense, corners, 2 * math.pi)
    on_the_way(17.0, sense, corners, 2 * math.pi)
    assert corners.n_looks <= 2 * 12 + 10


def test_without_corners_nothing_is_ahead():
    assert corner_ahead(1.0, -1.0, (), 2 * math.pi) == -math.inf
    assert on_the_way(1.0, 1.0, (), 2 * math.pi) == 1.0


def rows_load(angle, _speed, _sense, numbers):
    """Straight lines through rows of a torque of two harmonics, evenly round a turn: inertia, number of rows."""
    place = (angle % 6.283185307179586) / 6.283185307179586 * numbers[1]
    row = int(place)
    at = [6.283185307179586 * (row + k) / numbers[1] for k in (0, 1)]
    one, other = (4 * math.sin(x) + 2 * math.sin(3 * x) for x in at)
    return numbers[0], 0.0, one + (place - row) * (other - one), 1.0


@pytest.mark.parametrize("sense", [1, -1])
def test_gentle_rows_limit_steps_and_do_not_end_them(sense):
    """3600 of them in few steps; the energy is that of the straight lines' exact integral."""
    n = 3600
    rows = np.linspace(0, 2 * np.pi, n, endpoint=False)
    drive = DriveTrain((1.5, float(n)), (), 0.0, DIRECT)
    asked = wanted(6.0, angle=0.3, speed=10.0 * sense, rows=rows)
    found = run(without_motor(rows_load), drive, asked, is_compiled=False)
    turns = abs(found.end[0] - 0.3) / (2 * np.pi)
    assert n / 14 * turns < found.n_steps < n / 9 * turns
    ends = np.array([0.3, found.end[0]])
    between = 2 * np.pi / n * np.arange(np.ceil(ends.min() * n / 2 / np.pi), np.floor(ends.max() * n / 2 / np.pi) + 1)
    angles = np.concatenate([[ends.min()], between, [ends.max()]])
    torques = np.array([rows_load(float(angle), 0.0, 1.0, (1.5, float(n)))[2] for angle in angles])
    work = sense * np.trapezoid(torques, angles)
    energy = 0.5 * 2.0 * 100.0 - work
    by_chance = np.sqrt(found.n_steps) * asked.limits.tolerance * 2 * energy  # the error allowed in every step
    assert 0.5 * 2.0 * found.end[1] ** 2 == pytest.approx(energy, abs=by_chance)
