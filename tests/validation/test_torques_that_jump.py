"""Torques that jump inside a step of the grid: whatever is an integral or an extreme over the cycle, by closed forms.

A punch meets its sheet at 200 depths, and a pulse on the shaft begins and ends anywhere; roots and integrals are found
here by bisection and Gauss's rule, energies under a fan by exponentials. The first depth is a problem of a textbook.
"""

from typing import Any

import numpy as np
import pytest

import cranktrain as ct

R, L, FORCE, RAMP = 0.05, 0.5, 753982.24, 1e-7
SPEED, WANTED = 4 * np.pi / 30, 0.105263158


def reached(phi: Any) -> Any:
    """Travel from the end near the shaft."""
    return R * (1 + np.cos(phi)) - L + np.sqrt(L**2 - (R * np.sin(phi)) ** 2)


def rate(phi: Any) -> Any:
    return -R * np.sin(phi) * (1 + R * np.cos(phi) / np.sqrt(L**2 - (R * np.sin(phi)) ** 2))


def root(curve: Any, low: Any, high: Any) -> Any:
    for _ in range(100):
        middle = (low + high) / 2
        is_low = np.sign(curve(middle)) == np.sign(curve(low))
        low, high = np.where(is_low, middle, low), np.where(is_low, high, middle)
    return (low + high) / 2


def punch(depth: float, **tables: Any) -> ct.Machine:
    return ct.Machine(
        angle="180 deg",
        shaft={"main": {"speed": "4 rpm"}},
        mechanism={"kind": "slider_crank", "stroke": "100 mm", "rod_length": "500 mm"},
        load={
            "punch": {
                "on": "piston",
                "travel": ["0 mm", f"{depth!r} mm", f"{depth + 1e3 * RAMP!r} mm", "101 mm"],
                "force": ["0 N", "0 N", f"{FORCE} N", f"{FORCE} N"],
                "force_back": ["0 N", "0 N", "0 N", "0 N"],
            }
        },
        **tables,
    )


@pytest.fixture(scope="module")
def depths() -> Any:
    return np.concatenate([[75.0], np.random.default_rng(16).uniform(20.0, 95.0, 199)])


@pytest.fixture(scope="module")
def punched(depths: Any) -> ct.Result:
    evenness = {"coefficient": WANTED, "mean": "extremes"}
    return ct.run([punch(float(depth), evenness=evenness) for depth in depths])


@pytest.fixture(scope="module")
def angles(depths: Any) -> tuple[Any, Any]:
    """Where the sheet is met, and where the whole force is reached."""
    return tuple(
        root(lambda phi, to=to: reached(phi) - to, np.full(depths.shape, np.pi), np.full(depths.shape, 2 * np.pi))
        for to in (depths / 1e3, depths / 1e3 + RAMP)
    )


def test_the_work_that_a_flywheel_gives_a_punch(punched, depths, angles):
    """∫(T − mean) from where the torque rises through the mean to where it falls through it."""
    met, full = depths / 1e3, angles[1]
    mean = FORCE * (2 * R - met - RAMP / 2) / (2 * np.pi)
    rises = root(lambda phi: FORCE * (reached(phi) - met) / RAMP * rate(phi) - mean, *angles)
    peak = np.full(depths.shape, root(lambda phi: rate(phi + 1e-6) - rate(phi - 1e-6), np.array(4.0), np.array(5.5)))
    falls = root(lambda phi: FORCE * rate(phi) - mean, np.maximum(full, peak), np.full(depths.shape, 2 * np.pi))
    begun = reached(rises) - met
    work = FORCE * (RAMP - begun**2 / RAMP) / 2 + FORCE * (reached(falls) - met - RAMP)
    expected = work - mean * (falls - rises)
    np.testing.assert_allclose(punched.largest_excess_work, expected, rtol=1e-9)
    assert punched.largest_excess_work[0] == pytest.approx(15941.7705, abs=1e-4)
    np.testing.assert_allclose(punched.mean_torque, -mean, rtol=1e-12)
    # Nothing else turns: by every method that is the flywheel.
    flywheel = np.broadcast_to((expected / (WANTED * SPEED**2))[:, np.newaxis], punched.flywheel_inertia.shape)
    np.testing.assert_allclose(punched.flywheel_inertia, flywheel, rtol=1e-9)
    np.testing.assert_allclose(punched.flywheel_fluctuation, WANTED, rtol=1e-9)
    from_top = np.degrees(np.array([rises[0], falls[0]])) - 180
    np.testing.assert_allclose(from_top, [122.392, 175.850], atol=1e-3)


def test_extremes_on_one_side_of_the_jump(punched, angles):
    """The greatest resistance is just after the whole force is reached, or where the pin goes fastest.

    Travel is rounded to 1e-17 m, which of the ramp is 1e-10, and there 1e-9 of the torque.
    """
    peak = float(root(lambda phi: rate(phi + 1e-6) - rate(phi - 1e-6), np.array(4.0), np.array(5.5)))
    np.testing.assert_allclose(punched.smallest_torque, -FORCE * rate(np.maximum(angles[1], peak)), rtol=1e-8)
    np.testing.assert_allclose(punched.largest_torque, 0.0, atol=1e-8 * FORCE * R)


def test_orders_of_the_jump(punched, depths, angles):
    node, weight = np.polynomial.legendre.leggauss(60)
    start = angles[1][:, np.newaxis]
    half = (2 * np.pi - start) / 2
    phi = start + half * (1 + node)
    met = (angles[0] + angles[1])[:, np.newaxis] / 2
    for k, order in enumerate(punched.labels["order"][:8]):
        waves = np.exp(-1j * float(order) * phi)
        whole = np.sum(half * weight * FORCE * rate(phi) * waves, axis=-1) / np.pi
        ramp = FORCE * RAMP / 2 * np.exp(-1j * float(order) * met[:, 0]) / np.pi
        np.testing.assert_allclose(punched.torque_order_amplitude[:, k], np.abs(whole + ramp), rtol=1e-9)


J, PULSE, FAN, MEAN = 2.0, 400.0, 300.0, 60.0
JUMP = 1e-6
"""Of the pulse's edges. [deg]"""


def pulsed(begins: float, ends: float, mean: str, fan: dict[str, Any]) -> ct.Machine:
    """A shaft and its pulse, which a constant torque, and maybe a fan, balance."""
    return ct.Machine(
        shaft={"main": {"speed": f"{MEAN} rad/s"}},
        mechanism={"kind": "slider_crank", "crank_radius": "50 mm", "rod_length": "180 mm"},
        masses={"crank": {"mass": "1 kg", "along": "0 mm", "inertia": f"{J} kg·m²"}},
        load={
            "pulse": {
                "on": "main",
                "sense": "active",
                "torque": ["0 N·m", "0 N·m", f"{PULSE} N·m", f"{PULSE} N·m", "0 N·m"],
                "crank_angles": [
                    f"{angle!r} deg" for angle in (0.0, begins - JUMP, begins + JUMP, ends - JUMP, ends + JUMP)
                ],
            },
            **fan,
        },
        evenness={"flywheel": "0 kg·m²", "mean": mean},
    )


def under_fan(rest: Any, wide: Any, fan: float) -> tuple[Any, Any, Any]:
    """Speed at the pulse's start and end, and its mean over time, where a constant torque helps a fan."""
    decay = 2 * fan / MEAN**2 / J
    long = 2 * np.pi - wide
    settle = (PULSE + rest) / decay, rest / decay
    kept = np.exp(-decay * wide), np.exp(-decay * long)
    start = (settle[1] * (1 - kept[1]) + settle[0] * (1 - kept[0]) * kept[1]) / (1 - kept[0] * kept[1])
    end = settle[0] + (start - settle[0]) * kept[0]
    node, weight = np.polynomial.legendre.leggauss(60)
    time = 0.0
    for begin, to, width in ((start, settle[0], wide), (end, settle[1], long)):
        phi = width[..., np.newaxis] * (1 + node) / 2
        energy = to[..., np.newaxis] + (begin - to)[..., np.newaxis] * np.exp(-decay * phi)
        time = time + np.sum(weight * width[..., np.newaxis] / 2 / np.sqrt(2 * energy / J), axis=-1)
    return np.sqrt(2 * start / J), np.sqrt(2 * end / J), 2 * np.pi / time


@pytest.mark.parametrize("fan", [0.0, FAN])
@pytest.mark.parametrize("mean", ["time", "extremes"])
def test_the_speed_under_a_pulse(mean, fan):
    """By the energy alone, and with a fan that rises with the square of the speed: T′ = p + m − 2kT/J."""
    rng = np.random.default_rng(4)
    begins, ends = rng.uniform(10, 170, 25), rng.uniform(180, 350, 25)
    table = {"fan": {"on": "main", "torque": f"{FAN} N·m", "at_turning": f"{MEAN} rad/s", "exponent": 2}}
    machines = [pulsed(*map(float, one), mean, table if fan else {}) for one in zip(begins, ends, strict=True)]
    found = ct.run(machines)
    wide = np.radians(ends - begins)
    if fan:

        def off(rest: Any) -> Any:
            start, end, time = under_fan(rest, wide, fan)
            return (time if mean == "time" else (start + end) / 2) - MEAN

        middle = fan - PULSE * wide / (2 * np.pi)
        start, end, time = under_fan(root(off, middle - 0.2 * fan, middle + 0.2 * fan), wide, fan)
    else:
        work = PULSE * wide * (1 - wide / (2 * np.pi))
        np.testing.assert_allclose(found.largest_excess_work, work, rtol=1e-7)

        def speeds(energy: Any) -> tuple[Any, Any, Any]:
            start, end = np.sqrt(2 * energy / J), np.sqrt(2 * (energy + work) / J)
            return start, end, (start + end) / 2  # ω² is straight over the angle both ways: so is its time's mean

        start, end, time = speeds(root(lambda energy: speeds(energy)[2] - MEAN, np.full(25, 1.0), np.full(25, 1e5)))
    np.testing.assert_allclose(found.smallest_crank_speed, start, rtol=1e-9)
    np.testing.assert_allclose(found.largest_crank_speed, end, rtol=1e-9)
    np.testing.assert_allclose(found.mean_speed_over_time, time, rtol=1e-9)
    np.testing.assert_allclose(found.largest_crank_speed_at, ends, atol=2 * JUMP)
    np.testing.assert_allclose(found.smallest_crank_speed_at, begins, atol=2 * JUMP)
