"""Linkages in power series of the crank angle, with 50 digits: positions and derivatives without a formula of ours.

Each joint is put where two circles, or a circle and a line, cross. All numbers are truncated power series
q(φ + ε) = q + q′ε + ½q″ε² (python-flint's `arb_series`, ball arithmetic), so the derivatives come out with the
position and nothing is differentiated by hand; every coefficient carries a rigorous bound of its own error. Doubles
enter exactly.

Everything is computed in the axes of the crank; only the last step looks from a cylinder's own axes.
"""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import NamedTuple

import numpy as np
from flint import arb, arb_mat, arb_series, ctx
from numpy.typing import ArrayLike

from cranktrain.motion import Coefficient

Vector = tuple[arb_series, arb_series]
Motion = dict[str, arb_series]

DIGITS = 50
ORDER = 3  # value, first and second derivative
AHEAD = 1.0
CHORD_STEPS = 8  # each gains the digits of a double, and one order of the series


@contextmanager
def series_arithmetic() -> Iterator[None]:
    """Set the digits and the order of every series made inside."""
    cap = ctx.cap
    ctx.cap = ORDER
    try:
        with ctx.workdps(DIGITS):
            yield
    finally:
        ctx.cap = cap


def crank_pin(angle: float, radius: arb) -> Vector:
    sin, cos = arb_series([angle, 1]).sin_cos()
    return radius * cos, radius * sin


def constant(value: float | arb) -> arb_series:
    return arb_series([value])


def unit(angle: arb) -> Vector:
    sin, cos = angle.sin_cos()
    return constant(cos), constant(sin)


def along(start: Vector, direction: Vector, length: arb | arb_series) -> Vector:
    return start[0] + length * direction[0], start[1] + length * direction[1]


def difference(end: Vector, start: Vector) -> Vector:
    return end[0] - start[0], end[1] - start[1]


def dot(one: Vector, other: Vector) -> arb_series:
    return one[0] * other[0] + one[1] * other[1]


def left_of(vector: Vector) -> Vector:
    return -vector[1], vector[0]


def multiple(vector: Vector, factor: arb | arb_series) -> Vector:
    return factor * vector[0], factor * vector[1]


def turned(vector: Vector, angle: arb) -> Vector:
    """The vector in axes turned by `angle`."""
    axis = unit(angle)
    return dot(vector, axis), dot(vector, left_of(axis))


def circle_meets_line(centre: Vector, radius: arb, through: Vector, direction: Vector, side: float) -> Vector:
    """Crossing of a circle with a line: of the two roots the farther along `direction` for side = +1."""
    start = difference(through, centre)
    half = dot(start, direction)
    root = (half * half - dot(start, start) + radius * radius).sqrt()
    return along(through, direction, root - half if side > 0 else -root - half)


def circle_meets_circle(one: Vector, radius: arb, other: Vector, other_radius: arb, side: float) -> Vector:
    """Crossing of two circles, by their radical line: left of the line from `one` to `other` for side = +1."""
    centres = difference(other, one)
    squared = dot(centres, centres)
    foot = along(one, centres, (squared + radius * radius - other_radius * other_radius) / (2 * squared))
    return circle_meets_line(one, radius, foot, multiple(left_of(centres), squared.rsqrt()), side)


def direction_angle(vector: Vector) -> arb_series:
    """Direction of a moving vector: where it points now, and how far it has turned from there."""
    x, y = vector
    now_x, now_y = x[0], y[0]
    turn = (now_x * y - now_y * x) / (now_x * x + now_y * y)
    return constant(arb.atan2(now_y, now_x)) + turn.atan()


def _link(name: str, start: Vector, end: Vector, length: arb) -> Motion:
    cos, sin = multiple(difference(end, start), 1 / length)
    return {f"{name}.angle": direction_angle((cos, sin)), f"{name}.cos": cos, f"{name}.sin": sin}


def _point(name: str, point: Vector) -> Motion:
    return {f"{name}.x": point[0], f"{name}.y": point[1]}


def slider_crank(angle: float, crank_radius: float, rod_length: float, offset: float, side: float = AHEAD) -> Motion:
    rod = arb(rod_length)
    pin = crank_pin(angle, arb(crank_radius))
    slider = circle_meets_line(pin, rod, (constant(0), constant(offset)), unit(arb(0)), side)
    return {"slider": slider[0]} | _point("pin", pin) | _link("rod", pin, slider, rod)


def crank_rocker(
    angle: float,
    crank_radius: float,
    rod_length: float,
    rocker_length: float,
    ground_length: float,
    side: float,
    point_radius: float,
    point_angle: float,
) -> Motion:
    """With a coupler point at `point_radius` from the crank pin, `point_angle` from the rod."""
    rod, rocker = arb(rod_length), arb(rocker_length)
    pin, pivot = crank_pin(angle, arb(crank_radius)), (constant(ground_length), constant(0))
    joint = circle_meets_circle(pin, rod, pivot, rocker, side)
    coupler_point = along(pin, turned(multiple(difference(joint, pin), 1 / rod), -arb(point_angle)), arb(point_radius))
    return (
        _point("pin", pin)
        | _point("joint", joint)
        | _point("coupler_point", coupler_point)
        | _link("rod", pin, joint, rod)
        | _link("rocker", pivot, joint, rocker)
    )


def articulated_rod(
    angle: float,
    crank_radius: float,
    master_rod_length: float,
    master_offset: float,
    knuckle_radius: float,
    articulation_angle: float,
    bank_angle: float,
    rod_length: float,
    offset: float,
) -> Motion:
    """Closed in the master cylinder's axes; knuckle, slider and rod then seen from the slave cylinder's."""
    master_rod, rod, bank = arb(master_rod_length), arb(rod_length), arb(bank_angle)
    pin = crank_pin(angle, arb(crank_radius))
    master = circle_meets_line(pin, master_rod, (constant(0), constant(master_offset)), unit(arb(0)), AHEAD)
    master_direction = multiple(difference(master, pin), 1 / master_rod)
    knuckle = along(pin, turned(master_direction, -arb(articulation_angle)), arb(knuckle_radius))
    axis = unit(bank)
    slider = circle_meets_line(knuckle, rod, multiple(left_of(axis), arb(offset)), axis, AHEAD)
    slave_knuckle, slave_slider = turned(knuckle, bank), turned(slider, bank)
    return (
        {"slider": slave_slider[0]}
        | _point("pin", pin)
        | _point("knuckle", slave_knuckle)
        | _link("master_rod", pin, master, master_rod)
        | _link("rod", slave_knuckle, slave_slider, rod)
    )


def swivel_on_line(pin: Vector, pivot: Vector, offset: arb, side: float) -> tuple[arb_series, Vector]:
    """Slider's distance along a guide, and the guide's direction: by the right angle at the foot of the pivot."""
    apart = difference(pin, pivot)
    slider = side * (dot(apart, apart) - offset * offset).sqrt()
    along_apart, across_apart = slider / dot(apart, apart), offset / dot(apart, apart)
    direction = difference(multiple(apart, along_apart), multiple(left_of(apart), across_apart))
    return slider, direction


def swivel_crank(
    angle: float, crank_radius: float, ground_length: float, offset: float, side: float, frame_turns: float = 0.0
) -> Motion:
    """Guide about a pivot on x, driven by a crank; the whole turned about the shaft as often as `frame_turns` says."""
    frame = arb(frame_turns) * arb_series([angle, 1])
    sin, cos = (frame + arb_series([angle, 1])).sin_cos()
    sin_frame, cos_frame = frame.sin_cos()
    pin = crank_radius * cos, crank_radius * sin
    pivot = ground_length * cos_frame, ground_length * sin_frame
    slider, direction = swivel_on_line(pin, pivot, arb(offset), side)
    return {
        "slider": slider,
        "guide.angle": direction_angle(direction),
        "guide.cos": direction[0],
        "guide.sin": direction[1],
    }


def yoke_crank(angle: float, crank_radius: float, offset: float, slot_angle: float) -> Motion:
    x, y = crank_pin(angle, arb(crank_radius))
    sin, cos = arb(slot_angle).sin_cos()
    block = (y - offset) / sin
    return {"slider": x - block * cos, "block": block}


def oscillating_cylinder(angle: float, crank_radius: float, ground_length: float, offset: float) -> Motion:
    """The swivel's guide is the cylinder; the slider counts toward its head."""
    motion = swivel_crank(angle, crank_radius, ground_length, offset, AHEAD)
    cylinder = {name.replace("guide", "cylinder"): series for name, series in motion.items() if name != "slider"}
    pin = crank_pin(angle, arb(crank_radius))
    return {"slider": ground_length - motion["slider"]} | cylinder | _point("pin", pin)


def crank_driven_lever(angle: float, crank_radius: float, ground_length: float, offset: float) -> Motion:
    """The swivel's guide is the output."""
    motion = swivel_crank(angle, crank_radius, ground_length, offset, AHEAD)
    return {name.replace("guide", "rocker").replace("slider", "block"): series for name, series in motion.items()}


def _slot_meets_guide(origin: Vector, direction: Vector, offset: float, shift: float) -> Motion:
    """Crossing of a moving link's line with the guide y = offset."""
    start = along(origin, left_of(direction), arb(shift))
    block = (offset - start[1]) / direction[1]
    return {"slider": along(start, direction, block)[0], "block": block}


def slotted_lever(
    angle: float, crank_radius: float, ground_length: float, lever_offset: float, offset: float, shift: float
) -> Motion:
    """Lever about a pivot below the shaft, rocked by a crank in its guide; its slot drives a slider along x."""
    pin, pivot = crank_pin(angle, arb(crank_radius)), (constant(0), constant(-ground_length))
    _, direction = swivel_on_line(pin, pivot, arb(lever_offset), AHEAD)
    return _slot_meets_guide(pivot, direction, offset, shift)


def slotted_rod(
    angle: float,
    crank_radius: float,
    rod_length: float,
    rod_offset: float,
    guide_angle: float,
    offset: float,
    shift: float,
) -> Motion:
    """Slider-crank whose rod is slotted and drives a second slider, on a guide at `guide_angle`."""
    rod, guide = arb(rod_length), arb(guide_angle)
    pin = crank_pin(angle, arb(crank_radius))
    slider = circle_meets_line(pin, rod, (constant(0), constant(rod_offset)), unit(arb(0)), AHEAD)
    direction = multiple(difference(slider, pin), 1 / rod)
    return _slot_meets_guide(turned(pin, guide), turned(direction, guide), offset, shift)


class LegNumbers(NamedTuple):
    """A triad's leg: its end goes round (x, y), its guide swings; its point on the link; length or shift, kind."""

    x: float
    y: float
    end_radius: float
    end_ahead: float
    direction: float
    swing: float
    swing_ahead: float
    radius: float
    angle: float
    length: float
    is_guide: float


def leg_vectors(angle: arb_series, leg: LegNumbers) -> tuple[Vector, Vector]:
    """End of a leg and direction of its guide."""
    sin, cos = (angle + arb(leg.end_ahead)).sin_cos()
    swing = arb(leg.swing) * (angle + arb(leg.swing_ahead)).sin()
    sin_guide, cos_guide = (swing + arb(leg.direction)).sin_cos()
    return (leg.x + leg.end_radius * cos, leg.y + leg.end_radius * sin), (cos_guide, sin_guide)


def triad_openings(
    pose: list[arb_series], legs: list[LegNumbers], vectors: list[tuple[Vector, Vector]]
) -> list[arb_series]:
    """How far a pose is from holding each leg, whose end and guide are given: zero where it closes."""
    x, y, turn = pose
    openings: list[arb_series] = []
    for leg, (end, guide) in zip(legs, vectors, strict=True):
        sin, cos = (turn + arb(leg.angle)).sin_cos()
        vector = difference((x + leg.radius * cos, y + leg.radius * sin), end)
        is_guide = leg.is_guide == 1.0
        openings.append(
            dot(left_of(guide), vector) - leg.length if is_guide else dot(vector, vector) - arb(leg.length) ** 2
        )
    return openings


def triad(angle: float, x: float, y: float, turn: float, *numbers: float) -> Motion:
    """Link on three legs near a pose: Newton's steps with the matrix of the first, itself from series."""
    n_fields = len(LegNumbers._fields)
    legs = [LegNumbers(*numbers[at : at + n_fields]) for at in range(0, 3 * n_fields, n_fields)]
    pose = [constant(value) for value in (x, y, turn)]
    still, moving = ([leg_vectors(at, leg) for leg in legs] for at in (constant(angle), arb_series([angle, 1])))
    columns = [triad_openings([pose[j] + arb_series([0, i == j]) for j in range(3)], legs, still) for i in range(3)]
    inverse = arb_mat(3, 3, [columns[j][i][1] for i in range(3) for j in range(3)]).inv()
    for _ in range(CHORD_STEPS):
        openings = triad_openings(pose, legs, moving)
        pose = [pose[i] - sum((inverse[i, j] * openings[j] for j in range(3)), constant(0)) for i in range(3)]
    sin, cos = pose[2].sin_cos()
    return {"link.origin.x": pose[0], "link.origin.y": pose[1], "link.angle": pose[2], "link.cos": cos, "link.sin": sin}


def coefficients(mechanism: Callable[..., Motion], angle: ArrayLike, *geometry: ArrayLike) -> dict[str, Coefficient]:
    """Exact coefficients, rounded to doubles, for angles and geometry that broadcast together.

    Returns
    -------
    dict of Coefficient, by the name the quantity has in the kernel's result ("rod.angle")
    """
    arguments = np.broadcast_arrays(*(np.asarray(column, dtype=float) for column in (angle, *geometry)))
    shape = arguments[0].shape
    names: list[str] = []
    rows: list[list[float]] = []
    with series_arithmetic():
        for numbers in zip(*(column.ravel().tolist() for column in arguments), strict=True):
            motion = mechanism(*numbers)
            names = list(motion)
            rows.append([float(series[order]) for series in motion.values() for order in range(ORDER)])
    table = np.array(rows).reshape(*shape, len(names), ORDER)
    # A series holds q″/2!.
    return {
        name: Coefficient(table[..., i, 0], table[..., i, 1], 2.0 * table[..., i, 2]) for i, name in enumerate(names)
    }
