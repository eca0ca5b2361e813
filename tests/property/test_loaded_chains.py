"""Random chains of class III under random loads: reactions in all joints against virtual work, which shares the motion.

A link on three legs, two rods and a block; a ram hangs on it by a rod, and a rocker by another. Nothing has a mass, so
that the torque is that of the loads alone.
"""

import numpy as np
import pytest
from tests.exact.test_chain_triad import STRUCTURE, TURN, drawn

import cranktrain as ct
from cranktrain.mechanisms.chain.gaps import chain_gap
from cranktrain.mechanisms.kind import rows
from cranktrain.numerics.designs import by_design

AT_ONCE = 8
"""Chains tried at once, which takes hardly longer than one: some one in five closes."""
LINKS = ("first", "second", "plate", "push", "pull", "rocker")
SLIDERS = ("block", "ram")


def mm(*lengths):
    return [f"{float(length) * 1e3!r} mm" for length in lengths]


def triad(random):
    """The tables of a chain that closes all round, its link near where it was measured with the crank along x."""
    closes: list[int] = []
    while not closes:
        several = [drawn(random) for _ in range(AT_ONCE)]
        gaps = chain_gap(STRUCTURE, TURN, rows(by_design(several, 1), np.arange(AT_ONCE)))
        closes = np.flatnonzero(np.all(gaps > 0.02, axis=-1)).tolist()
    size = several[closes[0]]
    (step,) = size.steps
    legs = []
    for leg, own in zip(("P", "Q", "block"), step.legs, strict=True):
        joint = own.joint.radius * np.exp(1j * own.joint.angle)
        along, across = mm(float(joint.real), float(joint.imag))
        legs.append({"along": along, "across": across})
        if leg == "block":
            guide = {"through": "B", "direction": f"{float(own.direction)!r} rad", "offset": mm(float(own.offset))[0]}
            legs[-1] |= {"slider": leg, "guide": guide}
        else:
            rod = {"P": ("first", "main.pin"), "Q": ("second", "A")}[leg]
            legs[-1] |= {"joint": leg, "rod": {"name": rod[0], "from": rod[1], "length": mm(float(own.length))[0]}}
    fixed = {name: mm(*map(float, place)) for name, place in zip("AB", size.fixed, strict=True)}
    return mm(float(size.cranks[0].radius))[0], fixed, legs, step.start


def chain(random):
    radius, fixed, legs, start = triad(random)
    place = (float(start.x), float(start.y))
    for leg in legs:
        leg["near"] = mm(*_at(leg, place, float(start.direction)))
    away = 3.0 * np.exp(1j * random.uniform(-np.pi, np.pi))
    fixed["D"] = mm(float(place[0] + away.real), float(place[1] + away.imag))
    return {
        "kind": "chain",
        "output": "ram",
        "fixed": fixed,
        "crank": {"main": {"radius": radius}},
        "part": [
            {"type": "triad", "link": "plate", "leg": legs},
            {"type": "point", "name": "knuckle", "link": "plate", "along": "200 mm", "across": "110 mm"},
            {
                "type": "slide",
                "rod": {"name": "push", "from": "knuckle", "length": "6 m"},
                "slider": "ram",
                "guide": {"through": "A", "direction": f"{random.uniform(-3, 3)!r} rad", "offset": "120 mm"},
            },
            {
                "type": "pin",
                "rod": {"name": "pull", "from": "knuckle", "length": "3.1 m"},
                "rocker": {"name": "rocker", "from": "D", "length": "3.4 m"},
                "joint": "E",
                "side": "left",
            },
        ],
    }


def _at(leg, place, angle):
    """Where a leg's joint is, with the crank along x."""
    along, across = (float(leg[key].removesuffix(" mm")) / 1e3 for key in ("along", "across"))
    joint = complex(*place) + (along + 1j * across) * np.exp(1j * angle)
    return float(joint.real), float(joint.imag)


def load_on(random, part):
    """Any load that the part can bear."""
    force, torque, speed = (f"{random.uniform(10, 900)!r} {unit}" for unit in ("N", "N*m", "mm/s"))
    at = {"along": mm(random.uniform(-0.3, 0.3))[0], "across": mm(random.uniform(-0.3, 0.3))[0]}
    direction = {"direction": f"{random.uniform(-3, 3)!r} rad"}
    radius = {"radius": mm(random.choice([-1, 1]) * random.uniform(0.1, 0.6))[0]}
    sense = {"sense": str(random.choice(["active", "resisting"]))}
    out = {"force": ["10 N", "900 N", "300 N"], "force_back": ["0 N", "50 N", "80 N"]}
    card = {**out, "travel": ["0 mm", "40 mm", "20 m"], "counts": str(random.choice(["with", "against"]))}
    on_any = [
        {"force": force, **direction, **sense},
        {**card, **direction, **sense},
        {"force": force, **direction, "at_speed": speed, "exponent": random.uniform(0.5, 3)},
    ]
    on_slider = [{"force": force, **sense}, {**card, **sense}]
    on_link = [
        {"force": force, **at},
        {"force": force, **at, **direction, **sense},
        {"torque": torque, **sense},
        {"torque": torque, "at_turning": "2 rad/s"},
        {"force": force, **radius, **sense},
        {"force": force, **radius, **direction, **sense},
        {"torque": ["1 N*m", "80 N*m", "30 N*m"], "crank_angles": ["10 deg", "130 deg", "300 deg"], **sense},
    ]
    on_link = [{**one, "along": "0 mm"} for one in on_any] + on_link
    kinds = on_any + on_slider if part in SLIDERS else on_link
    return {"on": part, **kinds[random.integers(len(kinds))]}


@pytest.mark.parametrize("seed", range(24))
def test_reactions_and_virtual_work_agree(seed):
    random = np.random.default_rng(seed)
    parts = [*random.choice(LINKS, 2, replace=False), "rocker", "ram", str(random.choice(SLIDERS))]
    loads = {f"n{n}": load_on(random, str(part)) for n, part in enumerate(parts)}
    speed = {"main": {"speed": f"{random.uniform(5, 300)!r} rpm"}}
    running = str(random.choice(["ahead", "astern"]))
    machine = ct.Machine(mechanism=chain(random), shaft=speed, load=loads, running=running)
    result = ct.run(machine, step_degrees=2)
    by_work = -np.sum(result.load_torque_on_crank, axis=0)
    reach = np.max(np.abs(result.joint_force_x)) + np.max(np.abs(result.joint_force_y))  # times an arm of 1 m
    assert np.max(np.abs(result.driving_torque - by_work)) <= 1e-12 * reach
    for check in result.checks:
        assert np.all(check.passed), (check.name, check.residual, check.limit)
    resists = np.array([load.sense == "resisting" for load in machine.load.values()])
    assert np.all(result.load_work[resists] <= 0)
    assert np.all(result.load_power[resists] <= 0)
