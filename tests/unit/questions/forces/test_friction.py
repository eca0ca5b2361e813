"""Friction in slots and in a triad's guides, from the file's words: the shaft gives just what it takes."""

import numpy as np
import pytest
from tests.sentences import EDGES_ONLY

import cranktrain as ct

YOKE = {
    "mechanism": {"kind": "scotch_yoke", "crank_radius": "50 mm", "slot_angle": "80 deg"},
    "masses": {"piston": {"mass": "4 kg"}, "block": {"mass": "1 kg", "along": "0 mm", "inertia": "1e-3 kg·m²"}},
}
CHAIN = {
    "mechanism": {
        "kind": "chain",
        "output": "valve",
        "fixed": {"A": ["150 mm", "0 mm"], "B": ["0 mm", "-90 mm"], "C": ["30 mm", "160 mm"]},
        "crank": {"main": {"radius": "20 mm"}},
        "part": [
            {"type": "yoke", "pin": "main.pin", "slider": "ram", "guide": {"through": "O", "direction": "10 deg"}},
            {
                "type": "pin",
                "rod": {"name": "rod", "from": "main.pin", "length": "150 mm"},
                "rocker": {"name": "lever", "from": "C", "length": "120 mm"},
                "joint": "J",
                "side": "right",
            },
            {
                "type": "trammel",
                "link": "lever",
                "slider": "die",
                "guide": {"through": "C", "direction": "5 deg", "offset": "-60 mm"},
            },
            {
                "type": "triad",
                "link": "plate",
                "leg": [
                    {
                        "joint": "K",
                        "rod": {"name": "bar", "from": "main.pin", "length": "150 mm"},
                        "near": ["170 mm", "0 mm"],
                    },
                    {
                        "along": "80 mm",
                        "slider": "shoe",
                        "guide": {"through": "A", "direction": "0 deg", "offset": "10 mm"},
                        "near": ["250 mm", "10 mm"],
                    },
                    {
                        "along": "30 mm",
                        "across": "60 mm",
                        "slider": "valve",
                        "guide": {"through": "A", "direction": "40 deg"},
                        "near": ["200 mm", "60 mm"],
                    },
                ],
            },
        ],
    },
    "masses": {
        name: {"mass": "2 kg", "along": "10 mm", "inertia": "2e-3 kg·m²"}
        for name in ("ram", "rod", "lever", "die", "plate", "bar", "shoe", "valve")
    },
}


def run(machine, friction, **tables):
    speed = {"main": {"speed": "900 rpm"}}
    return ct.run(ct.Machine(shaft=speed, friction=friction, **machine, **tables), step_degrees=0.5)


@pytest.mark.parametrize(
    ("machine", "friction"),
    [
        (YOKE, {"block": 0.1}),
        (YOKE, {"piston": 0.15, "block": 0.1}),
        (CHAIN, {"ram.slot": 0.1}),
        (CHAIN, {"die.slot": 0.1, "die": 0.05}),
        (CHAIN, {"shoe": 0.1, "valve": 0.05}),
        (CHAIN, dict.fromkeys(("ram", "ram.slot", "die", "die.slot", "shoe", "valve"), 0.08)),
    ],
    ids=str,
)
def test_reactions_and_work_agree_and_friction_takes_power(machine, friction):
    result = run(machine, friction, gravity=True)
    (torque,) = (check for check in result.checks if check.name == "torque")
    assert torque.residual[0] <= 1e-12
    assert np.all(np.isfinite(result.driving_torque))
    without = run(machine, {}, gravity=True)
    assert np.abs(np.mean(without.driving_torque)) < 1e-9
    assert np.mean(result.driving_torque) > 1e-3


def test_the_shaft_gives_what_a_block_takes():
    """μ|N||t′| of block and slot, of the joint's own force, over a turn: t = R sin φ / sin β."""
    result = run(YOKE, {"block": 0.1})
    joints, phi = result.labels["joint"].index("1.slot"), np.radians(result.crank_angle)
    normal = np.array([-np.sin(np.radians(80)), np.cos(np.radians(80))])
    along = np.array([normal[1], -normal[0]])
    force = np.array([result.joint_force_x[joints], result.joint_force_y[joints]])
    rate = 0.05 * np.cos(phi) / np.sin(np.radians(80))
    # The block presses the slider, and drags it along with itself.
    moving = np.abs(rate) > 1e-9
    np.testing.assert_allclose(
        (along @ force)[moving], (0.1 * np.abs(normal @ force) * np.sign(rate))[moving], rtol=0, atol=1e-9
    )
    assert np.mean(result.driving_torque) == pytest.approx(
        np.mean(0.1 * np.abs(normal @ force) * np.abs(rate)), rel=1e-12
    )


def test_the_shaft_gives_what_guides_of_a_triad_and_a_yoke_take():
    """Friction in each guide is μ|N| against the slider's motion; all together they take what the shaft gives."""
    directions = {"ram": np.radians(10), "shoe": 0.0}
    result = run(CHAIN, dict.fromkeys(directions, 0.08))
    lost = np.zeros(result.crank_angle.size)
    for name, angle in directions.items():
        at, slider = result.labels["joint"].index(f"1.guide/{name}"), result.labels["slider"].index(f"1.{name}")
        force = np.array([result.joint_force_x[at], result.joint_force_y[at]])
        rate = result.slider_velocity_coefficient[slider]
        drag = np.array([np.cos(angle), np.sin(angle)]) @ force
        normal = np.abs(np.array([-np.sin(angle), np.cos(angle)]) @ force)
        moving = np.abs(rate) > 1e-9
        np.testing.assert_allclose(drag[moving], (-0.08 * normal * np.sign(rate))[moving], rtol=0, atol=1e-9)
        lost += 0.08 * normal * np.abs(rate)
    assert np.mean(result.driving_torque) == pytest.approx(np.mean(lost), rel=1e-11)


def test_what_may_have_friction_is_said():
    with pytest.raises(ct.InputError) as refused:
        run(CHAIN, {"rod": 0.1, "slot": 0.2})
    listed = f"{EDGES_ONLY} or a slot: ram, ram.slot, die, die.slot, shoe, valve"
    assert [(one.path, str(one.allowed)) for one in refused.value.problems] == [
        ("friction.rod", listed),
        ("friction.slot", listed),
    ]


def test_a_triad_that_wedges_has_no_forces():
    assert np.all(np.isnan(run(CHAIN, {"shoe": 0.9, "valve": 0.9}).driving_torque))
