"""Random machines whose crank can turn, with their closing margins, found without the kernels.

The closing margin is the smallest relative change of one length after which the crank cannot turn. Margins are spread
evenly over their logarithm, so that one machine in three or four hardly closes.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.linkage import GUIDE, ROD, Leg, LinkPoint, Pose, Triad
from cranktrain.mechanisms.articulated_rod.kinematics import ArticulatedRod
from cranktrain.mechanisms.crank_rocker.kinematics import CrankRocker
from cranktrain.mechanisms.slider_crank.kinematics import SliderCrank

Array = NDArray[np.float64]

LEAST_MARGIN = 1e-3
GREATEST_MARGIN = 0.9


class SwivelCrank(NamedTuple):
    """A crank, the pivot of a guide on x, the guide's offset from the pivot; columns (n, 1)."""

    crank_radius: Array
    ground_length: Array
    offset: Array
    side: Array


class Machines(NamedTuple):
    """Geometry as columns (n, 1); margin and the crank angle where the links are nearest to opening, (n, 1)."""

    geometry: SliderCrank | CrankRocker | ArticulatedRod | SwivelCrank
    margin: Array
    opening_angle: Array

    def tested_angles(self, random: np.random.Generator) -> Array:
        """Three angles a machine, (n, 3): nearest to opening, beside it by as much as the peaks there are wide, any."""
        shape = self.margin.shape
        beside = self.opening_angle + random.normal(size=shape) * np.sqrt(self.margin)
        anywhere = random.uniform(-2 * np.pi, 4 * np.pi, size=(shape[0], 1))
        return np.concatenate([self.opening_angle, beside, anywhere], axis=-1)


def _log_uniform(random: np.random.Generator, low: float, high: Array | float, n: int) -> Array:
    return np.exp(random.uniform(np.log(low), np.log(high), size=(n, 1)))


def _offset(random: np.random.Generator, crank_radius: Array) -> Array:
    """Offset of either sign, up to thrice the crank radius; none for every fifth machine."""
    n = len(crank_radius)
    sign = random.choice([-1.0, -1.0, 0.0, 1.0, 1.0], size=(n, 1))
    return sign * crank_radius * _log_uniform(random, 1e-3, 3.0, n)


def _side(random: np.random.Generator, n: int) -> Array:
    return random.choice([-1.0, 1.0], size=(n, 1))


def slider_crank_margin(geometry: SliderCrank) -> Array:
    """The crank turns where R + |e| ≤ l, and the rod is the longest."""
    return (geometry.rod_length - geometry.crank_radius - np.abs(geometry.offset)) / geometry.rod_length


def slider_cranks(n: int, seed: int) -> Machines:
    """Rods of 1.001 to 8 crank radii."""
    random = np.random.default_rng(seed)
    crank_radius = _log_uniform(random, 1e-3, 2.0, n)
    offset = _offset(random, crank_radius)
    shortest = crank_radius + np.abs(offset)
    margin = _log_uniform(random, LEAST_MARGIN, 1 - shortest / (8 * crank_radius), n)
    geometry = SliderCrank(crank_radius, shortest / (1 - margin), offset)
    opening_angle = np.where(offset > 0, -np.pi / 2, np.pi / 2)
    return Machines(geometry, slider_crank_margin(geometry), opening_angle)


def crank_rocker_gaps(geometry: CrankRocker) -> tuple[Array, Array]:
    """By how much rod and rocker can meet with the pins nearest (crank at 0) and farthest apart (crank at π)."""
    radius, rod, rocker, ground = geometry[:4]
    return np.abs(ground - radius) - np.abs(rod - rocker), rod + rocker - (ground + radius)


def crank_rocker_margin(geometry: CrankRocker) -> Array:
    """Each length enters both gaps with a factor ±1, so the longest needs the smallest relative change."""
    return np.minimum(*crank_rocker_gaps(geometry)) / np.maximum.reduce(geometry[:4])


def crank_rockers(n: int, seed: int) -> Machines:
    """Crank-rockers and double cranks (ground shorter than the crank), on both sides."""
    random = np.random.default_rng(seed)
    drawn = _crank_rockers(random, 2 * n)
    margin = crank_rocker_margin(drawn)[:, 0]
    kept = np.flatnonzero((margin > LEAST_MARGIN) & (margin < GREATEST_MARGIN))[:n]
    geometry = CrankRocker(*(column[kept] for column in drawn))
    near, far = crank_rocker_gaps(geometry)
    return Machines(geometry, crank_rocker_margin(geometry), np.where(near < far, 0.0, np.pi))


def _crank_rockers(random: np.random.Generator, n: int) -> CrankRocker:
    """Crank and ground first, then rod and rocker from their sum and difference, one of the two gaps given.

    The ground is no shorter than a fiftieth of the crank: as it vanishes the linkage turns as one body, and the little
    that is left of the angles' second derivatives is lost in the rounding of the crank pin itself.
    """
    longer = _log_uniform(random, 1e-2, 5.0, n)
    gap = longer * _log_uniform(random, LEAST_MARGIN, GREATEST_MARGIN, n)
    shorter = random.uniform(0.02 * longer, 0.98 * (longer - gap))
    most = longer - shorter - gap  # of the difference of rod and rocker
    least = longer + shorter + gap  # of their sum
    opens_near = random.random(size=(n, 1)) < 0.5
    difference = _side(random, n) * np.where(opens_near, most, most * random.random(size=(n, 1)))
    total = np.where(opens_near, least * _log_uniform(random, 1.0001, 3.0, n), least)
    is_crank_longer = random.random(size=(n, 1)) < 0.4
    return CrankRocker(
        np.where(is_crank_longer, longer, shorter),
        (total + difference) / 2,
        (total - difference) / 2,
        np.where(is_crank_longer, shorter, longer),
        _side(random, n),
    )


class Reach(NamedTuple):
    """The farthest that the knuckle pin goes from the slave's line of stroke, and at which crank angle."""

    distance: Array
    angle: Array


def knuckle_distance(angle: Array, geometry: ArticulatedRod) -> Array:
    """Distance of the knuckle pin from the slave's line of stroke; NaN where the master cannot close."""
    radius, rod, offset = geometry.master
    master_direction = np.arcsin((offset - radius * np.sin(angle)) / rod)
    return np.abs(
        radius * np.sin(angle - geometry.bank_angle)
        + geometry.knuckle_radius * np.sin(master_direction + geometry.articulation_angle - geometry.bank_angle)
        - geometry.offset
    )


def knuckle_reach(geometry: ArticulatedRod) -> Reach:
    """Best of 180 angles, then golden section between its neighbours; NaN where the master cannot turn."""
    step = 2 * np.pi / 180
    with np.errstate(invalid="ignore"):
        best = np.argmax(knuckle_distance(np.arange(180) * step, geometry), axis=-1, keepdims=True) * step
        low, high = best - step, best + step
        golden = (np.sqrt(5) - 1) / 2
        for _ in range(25):
            left, right = high - golden * (high - low), low + golden * (high - low)
            is_left = knuckle_distance(left, geometry) > knuckle_distance(right, geometry)
            low, high = np.where(is_left, low, left), np.where(is_left, right, high)
        angle = (low + high) / 2
        distance = knuckle_distance(angle, geometry)
    return Reach(np.where(slider_crank_margin(geometry.master) >= 0, distance, np.nan), angle)


def _scaled(geometry: ArticulatedRod, length: str, factor: Array) -> ArticulatedRod:
    if length in SliderCrank._fields:
        master = geometry.master._replace(**{length: getattr(geometry.master, length) * factor})
        return geometry._replace(master=master)
    name = length.removeprefix("slave_")
    return geometry._replace(**{name: getattr(geometry, name) * factor})


def _rows(geometry: ArticulatedRod, rows: NDArray[np.bool_]) -> ArticulatedRod:
    master = SliderCrank(*(column[rows] for column in geometry.master))
    return ArticulatedRod(master, *(column[rows] for column in geometry[1:]))


def can_turn(geometry: ArticulatedRod) -> NDArray[np.bool_]:
    """Whether both rods reach their cylinders at every crank angle, (n, 1)."""
    return knuckle_reach(geometry).distance <= geometry.rod_length


def articulated_rod_margin(geometry: ArticulatedRod) -> Array:
    """Closing margin to one per cent.

    Slave rod and slave offset enter linearly, and so do the master's lengths into the master's own condition: these
    give a bound. Whether a change of a length that also moves the knuckle pin opens the links sooner is tried at the
    bound, both ways; where it does, the change is found by bisection.
    """
    slave_gap = geometry.rod_length - knuckle_reach(geometry).distance
    slave = slave_gap / np.maximum(geometry.rod_length, np.abs(geometry.offset))
    margin = np.minimum(slider_crank_margin(geometry.master), slave)
    for length in ("crank_radius", "rod_length", "offset", "knuckle_radius"):
        for sign in (-1.0, 1.0):
            sooner = ~can_turn(_scaled(geometry, length, 1 + sign * 0.99 * margin))[:, 0]
            margin[sooner] = _bisected(_rows(geometry, sooner), length, sign, margin[sooner])
    return margin


def _bisected(geometry: ArticulatedRod, length: str, sign: float, bound: Array) -> Array:
    """Relative change of a length at which the crank just turns: less than `bound`."""
    low, high = np.zeros_like(bound), bound
    for _ in range(9):
        middle = (low + high) / 2
        turns = can_turn(_scaled(geometry, length, 1 + sign * middle))
        low, high = np.where(turns, middle, low), np.where(turns, high, middle)
    return high


def articulated_rods(n: int, seed: int) -> Machines:
    """Knuckle radii of 0.3 to 1.2 crank radii within 25° of the slave's axis, banks all round, offsets on both."""
    random = np.random.default_rng(seed)
    crank_radius = _log_uniform(random, 1e-3, 2.0, n)
    master_offset, offset = (_offset(random, crank_radius) * scale for scale in (1.0, 0.3))
    shortest = crank_radius + np.abs(master_offset)
    master_rod = shortest / (1 - _log_uniform(random, LEAST_MARGIN, 1 - shortest / (8 * crank_radius), n))
    bank_angle = random.uniform(-np.pi, np.pi, size=(n, 1))
    geometry = ArticulatedRod(
        SliderCrank(crank_radius, master_rod, master_offset),
        crank_radius * random.uniform(0.3, 1.2, size=(n, 1)),
        bank_angle + np.deg2rad(random.uniform(-25.0, 25.0, size=(n, 1))),
        bank_angle,
        np.full((n, 1), np.inf),
        offset,
    )
    reach = knuckle_reach(geometry)
    rod_length = reach.distance / (1 - _log_uniform(random, LEAST_MARGIN, GREATEST_MARGIN, n))
    geometry = geometry._replace(rod_length=rod_length)
    is_master_nearer = slider_crank_margin(geometry.master) < 1 - reach.distance / rod_length
    master_opening = np.where(master_offset > 0, -np.pi / 2, np.pi / 2)
    opening_angle = np.where(is_master_nearer, master_opening, reach.angle)
    return Machines(geometry, articulated_rod_margin(geometry), opening_angle)


def swivel_crank_margin(geometry: SwivelCrank) -> Array:
    """The pin comes as near to the pivot as |g − R|, which must be more than |e|; the longer of g and R is longest."""
    nearest = np.abs(geometry.ground_length - geometry.crank_radius)
    return (nearest - np.abs(geometry.offset)) / np.maximum(geometry.ground_length, geometry.crank_radius)


def swivel_cranks(n: int, seed: int, *, is_crank_longer: bool | None = None, shortest: float = 0.02) -> Machines:
    """Oscillating cylinders and slotted levers, Whitworth drives (a longer crank); of the longer length the shorter is
    `shortest` or more, as for the crank-rockers, and 0.98 or less: the pin would pass the pivot faster than peaks are
    looked for. Every fifth guide goes through its pivot.
    """
    random = np.random.default_rng(seed)
    longer = _log_uniform(random, 1e-2, 5.0, n)
    margin = _log_uniform(random, LEAST_MARGIN, 1 - shortest - 0.05, n)
    shorter = longer * random.uniform(shortest, np.minimum(1 - margin, 0.98))
    is_through_pivot = random.random(size=(n, 1)) < 0.2
    offset = np.where(is_through_pivot, 0.0, _side(random, n) * (longer - shorter - margin * longer))
    is_longer = random.random(size=(n, 1)) < 0.5 if is_crank_longer is None else np.full((n, 1), is_crank_longer)
    geometry = SwivelCrank(
        np.where(is_longer, longer, shorter), np.where(is_longer, shorter, longer), offset, _side(random, n)
    )
    return Machines(geometry, swivel_crank_margin(geometry), np.zeros((n, 1)))


class CrankedEnd(NamedTuple):
    """A leg's outer end, which goes round (x, y) with the crank, and the direction of its guide, which swings."""

    x: Array
    y: Array
    radius: Array
    ahead: Array
    direction: Array
    swing: Array
    swing_ahead: Array


class CrankedTriad(NamedTuple):
    """A link on three legs with their ends; columns (n, 1)."""

    ends: tuple[CrankedEnd, CrankedEnd, CrankedEnd]
    legs: Triad


class PosedTriads(NamedTuple):
    """Triads, and a pose at crank angle 0 for which their legs were measured."""

    geometry: CrankedTriad
    pose: Pose


def _leg_to(
    random: np.random.Generator, point: LinkPoint, x: Array, y: Array, is_driven: bool
) -> tuple[CrankedEnd, Leg]:
    """A rod or a guide from anywhere to the link's point at (x, y).

    One in three is a guide, one in three of these swings; besides a driven end, one in three is on a crank.
    """
    n = len(x)
    kind = np.where(random.random(size=(n, 1)) < 0.35, GUIDE, ROD)
    length, direction = random.uniform(0.4, 2.5, size=(n, 1)), random.uniform(-np.pi, np.pi, size=(n, 1))
    end_radius = random.uniform(0.05, 0.4, size=(n, 1)) * (is_driven | (random.random(size=(n, 1)) < 0.3))
    swing = random.uniform(0.05, 0.3, size=(n, 1)) * kind * (random.random(size=(n, 1)) < 0.3)
    ahead, guide, swing_ahead = random.uniform(-np.pi, np.pi, size=(3, n, 1))
    end = CrankedEnd(
        x - length * np.cos(direction) - end_radius * np.cos(ahead),
        y - length * np.sin(direction) - end_radius * np.sin(ahead),
        end_radius,
        ahead,
        guide,
        swing,
        swing_ahead,
    )
    shift = length * np.sin(direction - guide - swing * np.sin(swing_ahead))
    return end, Leg(point, np.where(kind == GUIDE, shift, length), kind)


def triads(n: int, seed: int) -> PosedTriads:
    """Any triads of a metre's size; the crank of two in three cannot turn."""
    random = np.random.default_rng(seed)
    pose = Pose(*random.uniform(-1.0, 1.0, size=(2, n, 1)), random.uniform(-np.pi, np.pi, size=(n, 1)))
    parts: list[tuple[CrankedEnd, Leg]] = []
    for i in range(3):
        point = LinkPoint(random.uniform(0.2, 1.0, size=(n, 1)), random.uniform(-np.pi, np.pi, size=(n, 1)))
        x = pose.x + point.radius * np.cos(pose.angle + point.angle)
        y = pose.y + point.radius * np.sin(pose.angle + point.angle)
        parts.append(_leg_to(random, point, x, y, is_driven=i == 0))
    ends, legs = zip(*parts, strict=True)
    return PosedTriads(CrankedTriad(ends, Triad(*legs)), pose)
