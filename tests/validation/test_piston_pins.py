"""P, S, K and T with weights: what each of them holds, by closed forms, at any bank angle; without gravity as before.

Positions are found by Pythagoras, their derivatives by the Fourier series of a turn. The steam engine is a problem of a
mailing list, its forces by hand.
"""

from typing import Any

import numpy as np
import pytest
from tests.machines import slave, slave_position, slider, slider_position, throws

import cranktrain as ct

GRAVITY = 9.80665
EXACT, TEXTBOOK, TWO_HARMONICS = range(3)
SPEED = 60.0  # rad/s
ROD = {"mass": "1.2 kg", "along": "60 mm", "inertia": "0.00864 kg·m²"}  # of two masses
SHARE = 0.4
PISTON = 0.9
MASSES = {"piston": {"mass": f"{PISTON} kg"}, "rod": ROD}
PUSH = {"spring": {"on": "piston", "force": "-75 N", "sense": "active"}}
GAS: dict[str, Any] = {
    "cylinder": {"bore": "60 mm", "compression_ratio": 9, "cycle": "two-stroke"},
    "gas": {"kind": "otto", "start_pressure": "95 kPa", "exhaust_pressure": "106 kPa"}
    | {"compression_exponent": 1.36, "expansion_exponent": 1.25, "pressure_ratio": 2.4},
}


def second(values: np.ndarray) -> np.ndarray:
    """Second derivative by the crank angle of what repeats every turn; its harmonics beyond the 24th are none."""
    series = np.fft.rfft(values)[:25]
    return np.fft.irfft(-series * np.arange(series.size) ** 2, values.size)


def at_bank(angle: float, **tables: Any) -> ct.Machine:
    return ct.Machine(
        angle=f"{angle} deg",
        shaft={"main": {"speed": f"{SPEED} rad/s"}},
        mechanism=slider(),
        masses=MASSES,
        **tables,
    )


def close(found: Any, expected: Any, part: float = 1e-12) -> None:
    np.testing.assert_allclose(found, expected, rtol=0, atol=part * np.max(np.abs(expected)))


def holds(result: ct.Result, name: str = "piston_pins") -> bool:
    return all(bool(np.all(check.passed)) for check in result.checks if check.name == name)


def test_a_vertical_steam_engine():
    """350 kPa over 45 kg at 360 rpm: W and −mRω²(…) with what both sides press; at the top their sum, 4191 N."""
    result = ct.run(
        ct.Machine(
            gravity=True,
            shaft={"main": {"speed": "360 rpm"}},
            mechanism={"kind": "slider_crank", "stroke": "300 mm", "rod_length": "600 mm"},
            masses={"piston": {"mass": "45 kg"}},
            load={
                "cover_side": {"on": "piston", "force": "-17180.58 N", "sense": "active"},
                "crank_side": {"on": "piston", "force": "1439.49 N", "sense": "active"},
            },
        )
    )
    phi = np.radians(result.crank_angle)
    moved = -second(slider_position(phi, 0.15, 0.6))
    force = 17180.58 - 1439.49 + 45 * GRAVITY - 45 * moved * (12 * np.pi) ** 2
    for method in (EXACT, TEXTBOOK):
        close(result.piston_force[method, 0], force)
    beta = np.arcsin(0.25 * np.sin(phi))
    close(result.rod_force_at_piston_pin[EXACT, 0], force / np.cos(beta))
    close(result.machine_torque, force * 0.15 * np.sin(phi + beta) / np.cos(beta))
    assert round(result.piston_force[EXACT, 0, 120]) == 22177
    assert round(result.machine_torque[120], 2) == 2512.03
    assert round(result.piston_force[EXACT, 0, 0]) == round(result.rod_force_at_piston_pin[EXACT, 0, 0]) == 4191
    assert result.side_force_formula_error[TEXTBOOK, 0] < 1e-13
    assert result.tangential_force_formula_error[TEXTBOOK, 0] < 1e-13
    assert holds(result)


@pytest.mark.parametrize("lean", [0.0, -35.0])
@pytest.mark.parametrize("angle", [0.0, 30.0, -90.0, 180.0, 137.0])
def test_the_weight_along_a_cylinder(angle, lean):
    """Of the piston and the rod's share m a/L, in P of every method; across it nothing."""
    weight = (PISTON + SHARE) * GRAVITY * np.cos(np.radians(angle - lean))
    tables = {"load": PUSH, **GAS}
    heavy = ct.run(at_bank(angle, gravity={"direction": f"{lean} deg"}, **tables))
    light = ct.run(at_bank(angle, **tables))
    phi = np.radians(light.crank_angle)
    inertia = (PISTON + SHARE) * SPEED**2 * second(slider_position(phi))
    close(light.piston_force[EXACT, 0], light.gas_force[0] + 75 + inertia)
    close(heavy.piston_force[:, 0], light.piston_force[:, 0] + weight)
    assert holds(heavy)
    assert holds(light)


def test_without_gravity_no_force_moves():
    """P is the sum of gas and inertia, bit by bit."""
    result = ct.run(at_bank(30.0, **GAS))
    np.testing.assert_array_equal(result.piston_force, result.gas_force + result.inertia_force)


def test_a_vertical_engine_is_compared_like_with_like():
    """A rod of two masses has the textbook's P, N, S, K and T when it weighs something, too."""
    result = ct.run(at_bank(0.0, gravity=True, **GAS))
    for name in ("piston_force", "side_force", "rod_force_at_piston_pin", "radial_force", "tangential_force"):
        exact, textbook = getattr(result, name)[:TWO_HARMONICS]
        close(textbook, exact, 1e-13)
    close(result.rod_force_at_crank_pin[EXACT], result.rod_force_at_piston_pin[EXACT], 1e-13)


@pytest.mark.parametrize("angle", [0.0, 65.0])
def test_what_the_pin_bears_besides(angle):
    """K and T lack inertia and weight of the rod's share at the pin, m b/L."""
    result = ct.run(at_bank(angle, gravity=True))
    stands = np.radians(result.crank_angle + angle)
    share = 1.2 - SHARE
    lacks = result.radial_force[EXACT] - result.crankpin_load_radial
    close(lacks[0], share * (0.05 * SPEED**2 - GRAVITY * np.cos(stands)))
    lacks = result.tangential_force[EXACT] - result.crankpin_load_tangential
    np.testing.assert_allclose(lacks[0], -share * GRAVITY * np.sin(stands), rtol=0, atol=1e-11)


def test_a_slave_and_its_master():
    """Each in its own axes; a slave's share of its rod is what its piston pin weighs."""
    bank = {
        "L": {"angle": "-40 deg", "mechanism": slider()},
        "R": {"angle": "25 deg", "mechanism": slave("L")},
    }
    shaft = throws(0, speed=f"{SPEED} rad/s")
    heavy = ct.run(ct.Machine(shaft=shaft, bank=bank, masses=MASSES, gravity=True))
    phi = np.radians(heavy.crank_angle)
    for name, angle, position in (
        ("1L", -40, slider_position(phi)),
        ("1R", 25, slave_position(phi, bank_angle=np.radians(65), articulation_angle=np.radians(60))),
    ):
        mass = PISTON + (SHARE if name == "1L" else 1.2 * 60 / 135)
        force = mass * (GRAVITY * np.cos(np.radians(angle)) + SPEED**2 * second(position))
        close(heavy.piston_force[EXACT, heavy.labels["piston"].index(name)], force)
    assert holds(heavy)
    assert holds(heavy, "rod_forces")


def test_opposed_pistons():
    """With side rods both stand above the one shaft."""
    own = {"throws": [1], "mechanism": slider(crank_radius="40 mm")}
    bank = {"A": {"exhaust": {**own, "throws": [2]}, "scavenge": {**own, "side_rods": True, "throws": [1]}}}
    machine = {
        "shaft": throws(0, 180, speed=f"{SPEED} rad/s"),
        "bank": bank,
        "cylinder": {"bore": "60 mm", "cycle": "two-stroke"},
        "masses": {"piston": {"mass": "2 kg"}},
    }
    heavy, light = (ct.run(ct.Machine(**machine, gravity=gravity)) for gravity in (True, False))
    weights = heavy.piston_force[EXACT] - light.piston_force[EXACT]
    np.testing.assert_allclose(weights, 2 * GRAVITY, rtol=0, atol=1e-10)
    assert holds(heavy)


def test_the_pin_bears_what_acts_on_its_piston():
    """Random banks and fields, friction, loads across, two designs; rods without mass: S² = P² + (N + Y)²."""
    rng = np.random.default_rng(30)
    for _ in range(12):
        angle, lean, push, friction = rng.uniform([-180, -180, 0, 0], [180, 180, 300, 0.2])
        machines = [
            ct.Machine(
                angle=f"{angle} deg",
                shaft={"main": {"speed": f"{SPEED} rad/s"}},
                mechanism=slider(offset=f"{offset} mm"),
                masses={"piston": {"mass": f"{PISTON} kg"}},
                friction={"piston": f"{friction}"},
                gravity={"direction": f"{lean} deg"},
                load={"push": {"on": "piston", "force": "200 N", "direction": f"{push} deg", "sense": "active"}},
            )
            for offset in (0, 12)
        ]
        result = ct.run(machines)
        assert holds(result)
        field, pushed = (np.exp(1j * np.radians(one)) for one in (180 + lean - angle, push))
        acts = PISTON * GRAVITY * field
        x, y = (result.joint_force_x, result.joint_force_y)
        pin = result.labels["joint"].index("1.wrist_pin")
        np.testing.assert_allclose(
            np.abs(result.rod_force_at_piston_pin[:, EXACT, 0]), np.hypot(x[:, pin], y[:, pin]), rtol=1e-12
        )
        moving = np.sign(-result.piston_velocity[:, 0])
        across = result.side_force[:, EXACT, 0] + acts.imag + 200 * pushed.imag
        along = result.piston_force[:, EXACT, 0] + moving * friction * np.abs(result.side_force[:, EXACT, 0])
        turns = moving == 0
        force = result.rod_force_at_piston_pin[:, EXACT, 0]
        close(np.where(turns, 0, force**2), np.where(turns, 0, along**2 + across**2))
