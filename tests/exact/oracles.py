"""Linkages in power series of the crank angle, with 50 digits: positions and derivatives without a formula of ours.

Each joint is put where two circles, or a circle and a line, cross. All numbers are truncated power series
q(φ + ε) = q + q′ε + ½q″ε² (python-flint's `arb_series`, ball arithmetic), so the derivatives come out with the
position and nothing is differentiated by hand; every coefficient carries a rigorous bound of its own error. Doubles
enter exactly.

Everything is computed in the axes of the crank; only the last step looks from a cylinder's own axes.
"""

from collections.abc import Callable, Iterator
from contextlib import contextmanager

import numpy as np
from flint import arb, arb_series, ctx
from numpy.typing import ArrayLike

from cranktrain.motion import Coefficient

Vector = tuple[arb_series, arb_series]
Motion = dict[str, arb_series]

DIGITS = 50
ORDER = 3  # value, first and second derivative
AHEAD = 1.0


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
