"""Paths of points over a turn: how far they go, how long they are, how fast, and for how long they stay near an end."""

from collections.abc import Callable
from dataclasses import field
from functools import partial
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from cranktrain.language import N_
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.mechanisms import Mechanisms
from cranktrain.layout.speed import Speed, rates
from cranktrain.motion import Array, Coefficient
from cranktrain.numerics import Extreme, bracketed_roots, extremes, in_slots, largest, subintervals, turn_grid
from cranktrain.numerics.harmonics import TURN
from cranktrain.numerics.size_integral import integral_of_size
from cranktrain.numerics.subintervals import shows
from cranktrain.questions.motion.grid_motion import GridMotion
from cranktrain.questions.motion.points import LinkPoints, point_motion
from cranktrain.record import record
from cranktrain.references import THEORY_OF_GROUPS as _THEORY
from cranktrain.saying.catalogue import extreme, quantity

_POINT = ("point",)
_WIDEST, _NARROWEST = TURN / 24, TURN / 1000
"""Panels in which a path's derivatives are looked at, at first and at last. [rad]"""


_Place: TypeAlias = tuple[Coefficient, Coefficient]
"""x and y of all points, shape (design, point, k)."""


@record
class PointTurn:
    """One turn of the points, whatever the machine's own grid: x and y on `turn_grid()`, shape (design, point, 720)."""

    place: _Place


def point_turn(points: LinkPoints, mechanisms: Mechanisms) -> PointTurn:
    """Sample a turn of the points: where extremes are looked for first."""
    return PointTurn(_place_at(points, mechanisms, turn_grid()))


@record
class PointPaths:
    """How far points go over a turn, and how long their paths are.

    Attributes
    ----------
    is_joint : tuple of bool
        Whether each point has its name of the mechanism, and not of the file.
    """

    smallest_point_x: Extreme = extreme(
        "x_min",
        "m",
        _POINT,
        N_("Smallest x of the point"),
        N_("Crank angle of the smallest x"),
        _THEORY,
        "1.2, 1.3",
        of="point_x",
    )
    largest_point_x: Extreme = extreme(
        "x_max",
        "m",
        _POINT,
        N_("Largest x of the point"),
        N_("Crank angle of the largest x"),
        _THEORY,
        "1.2, 1.3",
        of="point_x",
    )
    smallest_point_y: Extreme = extreme(
        "y_min",
        "m",
        _POINT,
        N_("Smallest y of the point"),
        N_("Crank angle of the smallest y"),
        _THEORY,
        "1.2, 1.3",
        of="point_y",
    )
    largest_point_y: Extreme = extreme(
        "y_max",
        "m",
        _POINT,
        N_("Largest y of the point"),
        N_("Crank angle of the largest y"),
        _THEORY,
        "1.2, 1.3",
        of="point_y",
    )
    point_path_length: Array = quantity(
        "l_P", "m", _POINT, N_("Length of the point's path over a turn"), _THEORY, "1.18"
    )
    point_band_share: Array = quantity(
        "τ_P", "1", _POINT, N_("Share of the turn within the band at the end of the point's path"), _THEORY, "1.19"
    )
    is_joint: tuple[bool, ...] = field(kw_only=True)


def point_paths(points: LinkPoints, turn: PointTurn, mechanisms: Mechanisms, crank_angle: CrankAngle) -> PointPaths:
    """Extents as roots of the derivatives, lengths as integrals; docs/theory/groups, eqs. (1.18) and (1.19)."""
    place = partial(_place_at, points, mechanisms)

    def both(order: int, angle: Array) -> Array:
        """X and y, or their derivatives, each at angles of its own, (2, design, point, k)."""
        apart = np.moveaxis(angle, 0, -2)
        found = place(apart.reshape(*apart.shape[:2], -1))
        return np.stack([one[order].reshape(apart.shape)[..., axis, :] for axis, one in enumerate(found)])

    ends = extremes(partial(both, 0), partial(both, 1), samples=np.stack([one.value for one in turn.place]))
    x, y = (
        [Extreme(crank_angle.counted(one.angle[axis])[..., 0], one.value[axis, ..., 0]) for one in ends]
        for axis in range(2)
    )
    return PointPaths(
        *x,
        *y,
        point_path_length=_lengths(place),
        point_band_share=_shares(points, turn, place),
        is_joint=points.is_joint,
    )


@record
class PointSpeeds:
    """Largest speeds and accelerations of points, of whatever direction."""

    largest_point_speed: Extreme = extreme(
        "v_P",
        "m/s",
        _POINT,
        N_("Largest speed of the point"),
        N_("Crank angle of the point's largest speed"),
        _THEORY,
        "1.20",
        worst="largest",
    )
    largest_point_acceleration: Extreme = extreme(
        "a_P",
        "m/s^2",
        _POINT,
        N_("Largest acceleration of the point"),
        N_("Crank angle of the point's largest acceleration"),
        _THEORY,
        "1.20",
        worst="largest",
    )


def point_speeds(
    points: LinkPoints, turn: PointTurn, mechanisms: Mechanisms, speed: Speed, crank_angle: CrankAngle
) -> PointSpeeds:
    """Largest sizes of r′ω and r″ω² + r′ε over a turn, or at a speed that varies over the cycle. (1.20)"""
    is_constant = speed.curve is None
    grid = turn_grid() if is_constant else crank_angle.shown
    zero = 0.0 if is_constant else crank_angle.zero

    def sizes(phi: Array, place: _Place) -> list[Array]:
        x, y = (rates(one, speed.drive(phi)) for one in place)
        return [np.hypot(*parts) for parts in zip(x, y, strict=True)]

    def size(order: int, shown: Array) -> Array:
        phi = shown + zero
        return sizes(phi, _place_at(points, mechanisms, phi))[order]

    phi = grid + zero
    samples = sizes(phi, turn.place if is_constant else _place_at(points, mechanisms, phi))
    found = [largest(partial(size, order), grid=grid, samples=own) for order, own in enumerate(samples)]
    period = TURN if is_constant else crank_angle.cycle
    return PointSpeeds(
        *(Extreme(crank_angle.counted(one.angle + zero, period)[..., 0], one.value[..., 0]) for one in found)
    )


def _place_at(points: LinkPoints, mechanisms: Mechanisms, angle: Array) -> _Place:
    """Places of points at φ, the same for all, (k,) or (design, 1, k), or one's own, (design, point, k)."""
    if angle.ndim < 3 or angle.shape[1] == 1:
        return _place_of_all(points, mechanisms, angle)
    n_designs, n_points, n_angles = angle.shape
    # What points of one mechanism ask stands side by side; all of these are found at all of it.
    n_mechanisms = len(mechanisms.names)
    own: NDArray[np.intp] = np.arange(n_points, dtype=np.intp)
    laid, slot = in_slots(points.mechanism, np.moveaxis(angle, 1, 0).reshape(n_points, -1), n_mechanisms)
    by_design = np.moveaxis(laid.reshape(n_mechanisms, -1, n_designs, n_angles), 2, 0)
    asked = by_design.reshape(n_designs, n_mechanisms, -1)

    def each(curve: Coefficient) -> Coefficient:
        return Coefficient(*(part.reshape(n_designs, n_points, -1, n_angles)[:, own, slot] for part in curve))

    x, y = _place_of_all(points, mechanisms, asked)
    return each(x), each(y)


def _place_of_all(points: LinkPoints, mechanisms: Mechanisms, angle: Array) -> _Place:
    """Places of points at the angles of their mechanisms."""
    found = point_motion(points, GridMotion(mechanisms, mechanisms.motions(angle), angle.shape[-1]))
    return found.point_x, found.point_y


def _lengths(place: Callable[[Array], _Place]) -> Array:
    """Length of each path over a turn, shape (design, point). [m]"""
    widest = _WIDEST
    while True:
        cut = subintervals(np.zeros(1), widest, TURN)
        x, y = place(cut.angle)
        parts = [part.reshape(-1, cut.angle.size) for part in (x.first, y.first)]
        if widest < _NARROWEST or all(shows(cut, part) for part in parts if np.all(np.isfinite(part))):
            break
        widest /= 2
    return integral_of_size(cut, parts).reshape(x.first.shape[:-1])


def _shares(points: LinkPoints, turn: PointTurn, place: Callable[[Array], _Place]) -> Array:
    """Share of the turn in which each point is within its band, shape (design, point); NaN of one without a band."""
    shares = np.full(points.band.shape, np.nan)
    if np.all(np.isnan(points.band)):
        return shares
    cos, sin = np.cos(points.toward)[..., np.newaxis], np.sin(points.toward)[..., np.newaxis]

    def ahead(order: int, at: _Place) -> Array:
        x, y = at
        return x[order] * cos + y[order] * sin

    samples = ahead(0, turn.place)
    farthest = extremes(
        lambda phi: ahead(0, place(phi)), lambda phi: ahead(1, place(phi)), samples=samples
    ).largest.value
    level = farthest - points.band[..., np.newaxis]
    grid, inside = turn_grid(), samples - level
    for design, point in zip(*np.nonzero(np.isfinite(level[..., 0])), strict=True):
        own = inside[design, point]
        changes = np.flatnonzero((own > 0) != (np.roll(own, -1) > 0))

        def beyond(phi: Array, design: int = int(design), point: int = int(point)) -> Array:
            return ahead(0, place(phi))[design, point] - level[design, point, 0]

        roots = bracketed_roots(beyond, grid[changes], grid[changes] + grid[1])
        lengths = np.diff(np.append(roots, roots[:1] + TURN))
        enters = own[changes] <= 0
        shares[design, point] = np.sum(lengths[enters]) / TURN if roots.size else float(own[0] > 0)
    return shares
