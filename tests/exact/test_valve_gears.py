"""Valve gears against Newton's method in 40 digits, from the lengths of the file: nothing of the chain is used.

Each joint's equations are written out in the axes of the valve's line, with the words of the file; derivatives are
differences of solutions 1e-8 rad apart, which are good to 1e-15.
"""

import itertools
import tomllib

import mpmath as mp
import numpy as np
import pytest

import cranktrain as ct
from cranktrain.mechanisms import KINDS

ANGLES = (0.0, 0.7, 2.1, 3.9, 5.6)
STEP = mp.mpf("1e-8")
RIGHT = mp.pi / 2


@pytest.fixture(autouse=True)
def digits():
    with mp.workdps(40):
        yield


def length(text):
    return mp.mpf(text.removesuffix(" mm")) / 1000


def degrees(text):
    return mp.radians(mp.mpf(text.removesuffix(" deg")))


def toward(angle):
    """Direction in the plane, as a complex number."""
    return mp.mpc(mp.cos(angle), mp.sin(angle))


def metres(table):
    """Lengths, angles and numbers of a table of the file, in metres and radians."""
    found = {}
    for name, value in table.items():
        if isinstance(value, str) and value.endswith(" mm"):
            found[name] = length(value)
        elif isinstance(value, str) and value.endswith(" deg"):
            found[name] = degrees(value)
        else:
            found[name] = mp.mpf(str(value)) if isinstance(value, int | float) else value
    return found


def place_of(data, name=None):
    places = ct.Machine(**data).places
    return next(place for place in places if name is None or place.bank == name)


def assert_exact(place, solved, size):
    """Value to 1e-14 of the largest length, derivatives to 1e-12 of their peaks, at angles of the main crank."""
    with np.errstate(all="ignore"):
        motion = place.kind.motion(np.array(ANGLES), place.geometry).slider
        turn = place.kind.motion(np.arange(360) * (np.pi / 180), place.geometry).slider
    for i, angle in enumerate(ANGLES):
        before, here, after = (solved(mp.mpf(angle) + k * STEP, float(motion.value[i])) for k in (-1, 0, 1))
        assert abs(motion.value[i] - here) <= 1e-14 * size
        first, second = (after - before) / (2 * STEP), (after - 2 * here + before) / STEP**2
        assert abs(motion.first[i] - first) <= 1e-12 * np.max(np.abs(turn.first))
        assert abs(motion.second[i] - second) <= 1e-12 * np.max(np.abs(turn.second))


STEPHENSON = tomllib.loads(KINDS.named("stephenson").example)["mechanism"] | {
    "pin_setback": "75 mm",
    "saddle_setback": "20 mm",
    "offset": "15 mm",
}


def lead_angle(table):
    """Of an eccentric that runs ahead."""
    return RIGHT if table["admission"] == "outside" else -RIGHT


def stephenson(table, angle, near):
    """Valve on its line, by four unknowns: the middle of the slot, the link's turn, the valve."""
    given = metres(table)
    ahead = lead_angle(table) + given["angle_of_advance"]
    ecc, rod, half = given["eccentricity"], given["eccentric_rod_length"], given["pin_spacing"] / 2
    arm = given["lifting_arm_angle"] + given["notch"] * given["lifting_arm_swing"]
    end_x = given["reverse_shaft_x"] + given["lifting_arm_length"] * mp.cos(arm)
    end_y = given["reverse_shaft_y"] + given["lifting_arm_length"] * mp.sin(arm)
    pins = [(ecc * mp.cos(angle + one), ecc * mp.sin(angle + one)) for one in (ahead, -ahead)]
    way = -1 if table["rods"] == "open" else 1

    def openings(x, y, turn, valve):
        """(x, y) the slot's middle; turn from where the link stands across the valve's line."""
        up = (way * -mp.sin(turn), way * mp.cos(turn))  # toward the ahead rod's joint
        back = (-mp.cos(turn), -mp.sin(turn))  # toward the shaft
        joints = [
            tuple(
                at + sign * half * one + given["pin_setback"] * other
                for at, one, other in zip((x, y), up, back, strict=True)
            )
            for sign in (1, -1)
        ]
        saddle = tuple(at + given["saddle_setback"] * other for at, other in zip((x, y), back, strict=True))
        held = [mp.hypot(joint[0] - pin[0], joint[1] - pin[1]) - rod for joint, pin in zip(joints, pins, strict=True)]
        hung = mp.hypot(saddle[0] - end_x, saddle[1] - end_y) - given["lifting_link_length"]
        if "link_radius" in table:
            centre = tuple(at + given["link_radius"] * other for at, other in zip((x, y), back, strict=True))
            slot = mp.hypot(valve - centre[0], given["offset"] - centre[1]) - given["link_radius"]
        else:
            slot = (valve - x) * back[0] + (given["offset"] - y) * back[1]
        return [*held, hung, slot]

    down = end_y + mp.sign(given["offset"] - end_y) * given["lifting_link_length"]
    start = (near, down, mp.mpf(0), near)
    found = mp.findroot(openings, start, tol=mp.mpf("1e-70"), maxsteps=60)
    assert abs(found[2]) < 0.6
    return found[3]


@pytest.mark.parametrize(
    ("notch", "rods", "admission", "straight"),
    [
        (1, "open", "outside", False),
        (0.4, "crossed", "inside", False),
        (0, "open", "inside", True),
        (-1, "crossed", "outside", True),
        (-0.7, "open", "outside", False),
    ],
)
def test_stephenson(notch, rods, admission, straight):
    table = STEPHENSON | {"notch": notch, "rods": rods, "admission": admission}
    if straight:
        del table["link_radius"]
    place = place_of({"mechanism": table})
    assert_exact(place, lambda angle, near: stephenson(table, angle, near), 2.0)


def walschaerts(data, bank_angle, angle, near):
    """Valve on its line, by five unknowns: the link's turn, the lever's pin and turn, the valve."""
    gear, engine = metres(data["bank"]["valve"]["mechanism"]), metres(data["bank"]["cylinder"]["mechanism"])
    crank = angle - bank_angle
    radius, rod, height = engine["crank_radius"], engine["rod_length"], engine["offset"]
    along = radius * mp.cos(angle) + mp.sqrt(rod**2 - (radius * mp.sin(angle) - height) ** 2)
    drop = toward(-bank_angle) * (along + gear["drop_x"] + 1j * (height + gear["drop_y"]))
    ahead = lead_angle(gear) + gear["eccentric_advance"]
    pin = gear["eccentricity"] * toward(crank + ahead)
    trunnion = gear["trunnion_x"] + 1j * gear["trunnion_y"]
    way = -mp.sign(gear["trunnion_y"])
    block = gear["notch"] * gear["full_gear_die"]
    arc = gear["radius_rod_length"]
    to_valve = gear["valve_pin_distance"] * (1 if gear["admission"] == "inside" else -1)

    def openings(swing, x, y, lean, valve):
        """The link turned by `swing` from across the valve's line, the lever by `lean`."""
        link = toward(swing)
        foot = trunnion + link * (1j * way * gear["foot_distance"] - gear["foot_setback"])
        centre = trunnion + link * arc
        die = centre - link * arc * toward(-way * mp.asin(block / arc))
        lever = 1j * toward(lean)
        radius_pin = x + 1j * y
        union_pin, spindle = radius_pin + gear["lever_length"] * lever, radius_pin + to_valve * lever
        return [
            abs(foot - pin) - gear["eccentric_rod_length"],
            abs(radius_pin - die) - arc,
            abs(union_pin - drop) - gear["union_link_length"],
            spindle.imag - gear["offset"],
            spindle.real - valve,
        ]

    start = (mp.mpf(0), near, gear["offset"] - to_valve, mp.mpf(0), near)
    found = mp.findroot(openings, start, tol=mp.mpf("1e-70"), maxsteps=60)
    assert abs(found[0]) < 0.7
    assert abs(found[3]) < 0.7
    return found[4]


@pytest.mark.parametrize(
    ("notch", "admission", "bank", "offset"),
    [
        (1, "inside", 0, 0),
        (0.35, "outside", 3, 10),
        (0, "inside", 0, 0),
        (-1, "inside", -4, 5),
        (-0.6, "outside", 0, 0),
    ],
)
def test_walschaerts(notch, admission, bank, offset):
    data = tomllib.loads(KINDS.named("walschaerts").example)
    data["bank"]["valve"]["angle"] = f"{90 + bank} deg"
    data["bank"]["cylinder"]["mechanism"]["offset"] = f"{offset} mm"
    data["bank"]["valve"]["mechanism"] |= {"notch": notch, "admission": admission, "drop_x": "12 mm"}
    place = place_of(data, "valve")
    bank_angle = mp.mpf(float(np.radians(90.0 + bank)) - float(np.radians(90.0)))
    assert_exact(place, lambda angle, near: walschaerts(data, bank_angle, angle, near), 4.0)


@pytest.mark.parametrize(("admission", "offset"), list(itertools.product(("outside", "inside"), ("0 mm", "12 mm"))))
def test_eccentric(admission, offset):
    table = {
        "kind": "eccentric",
        "eccentricity": "45 mm",
        "rod_length": "900 mm",
        "angle_of_advance": "35 deg",
        "admission": admission,
        "offset": offset,
    }
    given = metres(table)

    def solved(angle, near):
        ahead = angle + lead_angle(table) + given["angle_of_advance"]
        x, y = given["eccentricity"] * mp.cos(ahead), given["eccentricity"] * mp.sin(ahead)
        return mp.findroot(lambda s: mp.hypot(s - x, given["offset"] - y) - given["rod_length"], mp.mpf(near))

    assert_exact(place_of({"mechanism": table}), solved, 1.0)
