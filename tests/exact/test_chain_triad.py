"""Triads of chains against 50 digits, round the turn, each in the mode in which its file puts it together."""

from typing import NamedTuple

import numpy as np
import pytest
from tests.exact import oracles
from tests.exact.agreement import quantities
from tests.machines import scaled

from cranktrain.linkage import LinkPoint
from cranktrain.mechanisms.chain.assembly import assembled
from cranktrain.mechanisms.chain.gaps import chain_gap
from cranktrain.mechanisms.chain.kinematics import chain_made
from cranktrain.mechanisms.chain.steps import (
    ChainSize,
    Coordinates,
    CrankSize,
    GuideLegSize,
    GuideLegStep,
    RodLegSize,
    RodLegStep,
    StartSize,
    Structure,
    TriadSize,
    TriadStep,
)
from cranktrain.mechanisms.kind import rows
from cranktrain.numerics.designs import by_design
from cranktrain.numerics.nested import filled, leaves

N = 40
TURN = np.arange(360) * (np.pi / 180)
LEAST_MARGIN = 0.01
LENGTHS = (
    "cranks.0.radius",
    *(f"fixed.{i}.{axis}" for i in (0, 1) for axis in "xy"),
    *(f"steps.0.legs.{leg}.joint.radius" for leg in range(3)),
    *(f"steps.0.legs.{leg}.length" for leg in (0, 1)),
    "steps.0.legs.2.offset",
)
STRUCTURE = Structure(
    ("main",),
    ("A", "B"),
    (
        TriadStep(
            "plate", (RodLegStep("main.pin", "first", "P"), RodLegStep("A", "second", "Q"), GuideLegStep("block", "B"))
        ),
    ),
    "block",
)


class Turning(NamedTuple):
    """Chains whose crank still turns with any one length one per cent longer or shorter, columns (n, 1)."""

    size: ChainSize


def drawn(random: np.random.Generator) -> ChainSize:
    """A chain of a metre's size: the link anywhere, its legs to measure, near where they were measured."""
    centre = random.uniform(-1, 1) + 1j * random.uniform(-1, 1)
    direction = random.uniform(-np.pi, np.pi)
    points = random.uniform(0.2, 1.0, 3) * np.exp(1j * random.uniform(-np.pi, np.pi, 3))
    at = centre + points * np.exp(1j * direction)
    radius, guide = random.uniform(0.05, 0.3), random.uniform(-np.pi, np.pi)
    second = at[1] + random.uniform(0.4, 2.0) * np.exp(1j * random.uniform(-np.pi, np.pi))
    through = at[2] + random.uniform(0.1, 1.0) * np.exp(1j * random.uniform(-np.pi, np.pi))
    joints = [LinkPoint(float(abs(point)), float(np.angle(point))) for point in points]
    legs = (
        RodLegSize(joints[0], float(abs(at[0] - radius))),
        RodLegSize(joints[1], float(abs(at[1] - second))),
        GuideLegSize(joints[2], guide, float(((at[2] - through) * np.exp(-1j * guide)).imag)),
    )
    size = ChainSize(
        (CrankSize(radius, 0.0),),
        (Coordinates(second.real, second.imag), Coordinates(through.real, through.imag)),
        (TriadSize(legs, StartSize(0.0, 0.0, 0.0, 0.0, 1.0)),),
    )
    return assembled(STRUCTURE, size, {"plate": np.array([[point.real, point.imag] for point in at])})


@pytest.fixture(scope="module")
def turning() -> Turning:
    random = np.random.default_rng(11)
    size = rows(by_design([drawn(random) for _ in range(8 * N)], 1), np.arange(8 * N))
    keeps = np.min(chain_gap(STRUCTURE, TURN[::5], size), axis=-1) > 0
    size = rows(size, np.flatnonzero(keeps))
    factors = np.array([1 - LEAST_MARGIN, 1 + LEAST_MARGIN])
    every = [scaled(size, name, factor) for name in LENGTHS for factor in factors]
    least = np.min(chain_gap(STRUCTURE, TURN[::5], one_after_another(every)), axis=-1)
    keeps = np.all(least.reshape(len(every), -1) > 0, axis=0)
    return Turning(rows(size, np.flatnonzero(keeps)[:N]))


def one_after_another(sizes: list[ChainSize]) -> ChainSize:
    """Chains of several columns in one: what is done to many at once takes hardly longer than to a few."""
    columns = zip(*map(leaves, sizes), strict=True)
    return filled(sizes[0], (np.concatenate(column) for column in columns))


def numbers(size: ChainSize) -> list[np.ndarray]:
    """As the oracle takes them: each leg's end, guide, point on the link, length or shift, and kind."""
    zero = 0.0 * size.cranks[0].radius
    first, second, third = size.steps[0].legs
    ends = [(zero, zero, size.cranks[0].radius), (*size.fixed[0], zero), (*size.fixed[1], zero)]
    guides = [(zero, zero), (zero, zero), (third.direction, zero + 1)]
    lengths = [first.length, second.length, third.offset]
    return [
        column
        for (x, y, radius), (guide, is_guide), leg, length in zip(
            ends, guides, (first, second, third), lengths, strict=True
        )
        for column in (x, y, radius, zero, guide, zero, zero, *leg.joint, length, is_guide)
    ]


class Motion(NamedTuple):
    link: object


def test_triads_of_chains_are_exact(turning):
    """To 1e-12 of the peaks: at angles anywhere, one at a time or many, of other turns too."""
    size = turning.size
    angle = np.random.default_rng(12).uniform(-2 * np.pi, 4 * np.pi, (N, 5))
    link = chain_made(STRUCTURE, angle, size)["plate"]
    pose = (link.origin.x.value, link.origin.y.value, link.angle.value)
    exact = oracles.coefficients(oracles.triad, angle, *pose, *numbers(size))
    given = quantities(Motion(link), set(exact))
    cycle = quantities(Motion(chain_made(STRUCTURE, TURN, size)["plate"]), set(exact))
    assert len(given) == 3 * 3 + 2
    for name, values in given.items():
        quantity, order = name.rsplit(".", 1)
        peak = np.max(np.abs(cycle[name]), axis=-1, keepdims=True)
        assert np.all(np.abs(values - getattr(exact[quantity], order)) <= 1e-12 * peak), name
    alone = np.concatenate([chain_made(STRUCTURE, angle[:, i : i + 1], size)["block"].value for i in range(5)], axis=-1)
    np.testing.assert_array_equal(alone, chain_made(STRUCTURE, angle, size)["block"].value)


def test_legs_are_held_all_round(turning):
    size = turning.size
    made = chain_made(STRUCTURE, TURN, size)
    for joint, start, leg in (("P", "main.pin", 0), ("Q", "A", 1)):
        one, other = made[joint], made[start]
        opening = np.hypot(one.x.value - other.x.value, one.y.value - other.y.value) - size.steps[0].legs[leg].length
        assert np.max(np.abs(opening)) <= 1e-14 * 3.0
    guide, pin, through = size.steps[0].legs[2], made["block.pin"], made["B"]
    across = np.cos(guide.direction) * (pin.y.value - through.y.value)
    across -= np.sin(guide.direction) * (pin.x.value - through.x.value)
    assert np.max(np.abs(across - guide.offset)) <= 1e-14 * 3.0


def test_no_jump_from_branch_to_branch(turning):
    """At a thousand angles, round to where it began, each pose follows from the one before by its own derivatives."""
    angle = np.linspace(0.0, 2 * np.pi, 1001)
    made = chain_made(STRUCTURE, angle, turning.size)
    link = made["plate"]
    for coefficient in (link.origin.x, link.origin.y, link.angle, made["block"]):
        value, first, second = (order[:, :-1] for order in coefficient)
        jump = value + angle[1] * (first + 0.5 * angle[1] * second) - coefficient.value[:, 1:]
        if coefficient is link.angle:
            jump -= 2 * np.pi * np.round(jump / (2 * np.pi))
        assert np.max(np.abs(jump)) < 1e-3
    np.testing.assert_allclose(made["block"].value[:, 0], made["block"].value[:, -1], atol=1e-13)
