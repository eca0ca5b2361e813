"""Chains against 50 digits: circles and lines crossed in the file's own axes, none of which is turned."""

from functools import partial

import numpy as np
from flint import arb
from tests.exact import oracles
from tests.exact.agreement import assert_exact, rows
from tests.exact.oracles import (
    along,
    circle_meets_circle,
    circle_meets_line,
    constant,
    crank_pin,
    difference,
    direction_angle,
    left_of,
    multiple,
    swivel_on_line,
    unit,
)

from cranktrain.linkage import LinkPoint, Pin
from cranktrain.mechanisms.chain.gaps import chain_gap
from cranktrain.mechanisms.chain.kinematics import chain_made
from cranktrain.mechanisms.chain.steps import (
    ChainSize,
    Coordinates,
    CrankSize,
    PinStep,
    PointStep,
    SlideSize,
    SlideStep,
    Structure,
    SwivelSize,
    SwivelStep,
    YokeSize,
    YokeStep,
)

N = 300


def flat(structure, names, angle, size):
    """A chain's parts by plain names, as the comparison asks for them."""
    made = chain_made(structure, angle, size)
    return Parts(names, made)


class Parts:
    """Named parts of a chain, like a motion: what the comparison takes apart."""

    def __init__(self, names, made):
        self.parts = {name.replace(".", "_"): made[name] for name in names}

    def _asdict(self):
        return self.parts


def toggle(angle, radius, ahead, eccentric, rod, rocker, x, y, link, direction, offset):
    """Crank, knee on a rocker, ram on a guide in any direction; an eccentric with a yoke across the same guide."""
    pin, pivot = crank_pin(angle, arb(radius)), (constant(x), constant(y))
    knee = circle_meets_circle(pin, arb(rod), pivot, arb(rocker), 1.0)
    axis = unit(arb(direction))
    through = along(pivot, left_of(axis), arb(offset))
    ram = circle_meets_line(knee, arb(link), through, axis, 1.0)
    second = oracles.turned(crank_pin(angle, arb(eccentric)), -arb(ahead))
    return {
        "knee.x": knee[0],
        "knee.y": knee[1],
        "ram": oracles.dot(ram, axis),
        "ram_pin.x": ram[0],
        "ram_pin.y": ram[1],
        "link.angle": direction_angle(multiple(difference(ram, knee), 1 / arb(link))),
        "valve": oracles.dot(second, axis),
    }


def test_toggle_with_an_eccentric():
    random = np.random.default_rng(3)
    radius = random.uniform(0.05, 0.15, (N, 1))
    rod, rocker, link = (random.uniform(0.7, 1.0, (N, 1)) for _ in range(3))
    x, y = random.uniform(0.6, 0.9, (N, 1)), random.uniform(-0.4, 0.4, (N, 1))
    direction, ahead = random.uniform(-np.pi, np.pi, (2, N, 1))
    eccentric, offset = random.uniform(0.02, 0.1, (N, 1)), random.uniform(-0.1, 0.1, (N, 1))
    structure = Structure(
        ("main", "second"),
        ("C",),
        (
            PinStep("main.pin", "C", "rod", "rocker", "knee"),
            SlideStep("knee", "link", "ram", "C"),
            YokeStep("second.pin", "valve", "O"),
        ),
        "ram",
    )
    one = np.ones((N, 1))
    size = ChainSize(
        (CrankSize(radius, 0.0 * radius), CrankSize(eccentric, ahead)),
        (Coordinates(x, y),),
        (
            Pin(rod, rocker, one),
            SlideSize(link, one, direction, offset),
            YokeSize(np.pi / 2 * one, direction, 0.0 * one),
        ),
    )
    # What hardly closes is for the groups' own tests.
    reach = np.array([len(_closed(structure, size, i)) == 0 for i in range(N)])
    size = rows(size, ~reach)
    kept = [column[~reach] for column in (radius, ahead, eccentric, rod, rocker, x, y, link, direction, offset)]
    angle = random.uniform(0, 2 * np.pi, (len(kept[0]), 4))
    assert len(kept[0]) > 50
    exact = oracles.coefficients(toggle, angle, *kept)
    names = ("knee", "ram", "ram.pin", "link", "valve")
    assert_exact(partial(flat, structure, names), size, angle, exact, np.full((len(kept[0]), 1), 1.0))


def _closed(structure, size, row):
    """Crank angles all round, if this machine closes with 0.08 m to spare; none otherwise."""
    with np.errstate(all="ignore"):
        gap = chain_gap(structure, np.arange(72) * (2 * np.pi / 72), rows(size, slice(row, row + 1)))
    return gap if np.all(gap > 0.08) else ()


def shaper(angle, radius, ground, length, link, height):
    pin, pivot = crank_pin(angle, arb(radius)), (constant(0), constant(-arb(ground)))
    block, direction = swivel_on_line(pin, pivot, arb(0), 1.0)
    end = along(pivot, direction, arb(length))
    ram = circle_meets_line(end, arb(link), (constant(0), constant(height)), unit(arb(0)), 1.0)
    return {"ram": ram[0], "block": block, "D.x": end[0], "D.y": end[1], "lever.angle": direction_angle(direction)}


def test_shaper():
    random = np.random.default_rng(4)
    radius = random.uniform(0.05, 0.12, (N, 1))
    ground, length, link = 0.25 + 0.0 * radius, random.uniform(0.45, 0.55, (N, 1)), random.uniform(0.2, 0.4, (N, 1))
    height = length - 0.25 - 0.03
    structure = Structure(
        ("main",),
        ("C",),
        (
            SwivelStep("main.pin", "C", "lever", "block"),
            PointStep("lever", "D"),
            SlideStep("D", "rod", "ram", "O"),
        ),
        "ram",
    )
    zero = 0.0 * radius
    size = ChainSize(
        (CrankSize(radius, zero),),
        (Coordinates(zero, -ground),),
        (SwivelSize(zero, zero + 1, zero + 1), LinkPoint(length, zero), SlideSize(link, zero + 1, zero, height)),
    )
    angle = random.uniform(0, 2 * np.pi, (N, 4))
    exact = oracles.coefficients(shaper, angle, radius, ground, length, link, height)
    assert_exact(partial(flat, structure, ("ram", "block", "D", "lever")), size, angle, exact, np.full((N, 1), 1.0))
