"""What the text on the crank drive states of the velocities of a crank-rocker's pins: (7) and (10), (13), (17)."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from cranktrain.language import _
from cranktrain.layout.places import PlacedMechanism
from cranktrain.motion import Array
from cranktrain.numerics import extremes, turn_grid
from cranktrain.numerics.ties import first_largest
from cranktrain.textbook.alike import alike_places
from cranktrain.textbook.statements import Statement, StatementCurve
from cranktrain.texts.crank_rocker import pin_velocity_ratio, product_of_sines

_SOURCE = "gandzha"
_EQUATIONS = "(7) (10)"
_KIND = "crank_rocker"
_IN_LINE = 1e-6
"""Sine of the angle between rod and rocker below which their quotients are rounding."""


class AlikeRockers(NamedTuple):
    """Crank-rockers of the same size: names, the first one."""

    of: str
    first: PlacedMechanism


class PinVelocities(NamedTuple):
    """v_A/v_B of the motion, by (10), and by the product of sines that the text refutes."""

    exact: Array
    by_sines: Array
    refuted: Array


def alike_rockers(places: Sequence[PlacedMechanism]) -> tuple[AlikeRockers, ...]:
    """Put crank-rockers of the same size together."""
    rockers = [place for place in places if place.kind.name == _KIND]
    return tuple(AlikeRockers(*group) for group in alike_places(rockers, [place.geometry for place in rockers]))


def pin_velocities(place: PlacedMechanism, angle: Array) -> PinVelocities:
    """Give v_A/v_B by the crank's angle α from the line of the fixed pivots. [rad]"""
    motion = place.kind.motion(angle, place.geometry)
    exact = motion.rocker.angle.first * place.geometry.rocker_length / place.geometry.crank_radius
    directions = (angle, motion.rod.angle.value, motion.rocker.angle.value)
    # Where all links lie in line AC/BC is 0/0, and its limit is that of the velocities.
    in_line = np.abs(np.sin(motion.rocker.angle.value - motion.rod.angle.value)) < _IN_LINE
    by_sines = np.where(in_line, exact, pin_velocity_ratio(*directions))
    return PinVelocities(exact, by_sines, product_of_sines(*directions))


def crank_rocker_statements(one: AlikeRockers) -> Iterator[Statement]:
    """Give the range of v_A/v_B, what (10) and the refuted product are off at most, and the radius of (13)."""
    name = _("velocity of the rocker's pin by the crank pin's")
    bounds = extremes(lambda angle: pin_velocities(one.first, angle).exact)
    for at, found in zip(("smallest", "largest"), bounds, strict=True):
        angle, exact = found.angle[0], float(found.value[0])
        own = float(pin_velocities(one.first, np.array([angle])).by_sines[0])
        where = float(np.rad2deg(angle)) % 360.0
        yield Statement(_SOURCE, _EQUATIONS, "v_A/v_B", name, one.of, at, own, "1", "right", exact, where)
    sampled = pin_velocities(one.first, turn_grid())
    off = np.abs(sampled.by_sines - sampled.exact)
    name = _("error of v_A/v_B by AC/BC, from rounding")
    yield Statement(_SOURCE, _EQUATIONS, "Δ", name, one.of, "largest error", float(np.nanmax(off)), "1", "right", 0.0)
    off = np.abs(sampled.refuted - sampled.exact)
    worst = first_largest(off)
    where = float(np.rad2deg(turn_grid()[worst]))
    name = _("error of v_A/v_B by the product of sines, which the text refutes")
    yield Statement(_SOURCE, "(10)", "Δ", name, one.of, "largest error", float(off[worst]), "1", "refuted", 0.0, where)
    radius, rocker = (float(size) for size in (one.first.geometry.crank_radius, one.first.geometry.rocker_length))
    name = _("length by which v_A/v_B is multiplied to give M/Q, printed r₁ for r")
    yield Statement(_SOURCE, "(13)", "r₁", name, one.of, "", rocker, "m", "printed", radius)


def crank_rocker_curves(one: AlikeRockers, angle: Array) -> Iterator[StatementCurve]:
    """Give v_A/v_B, its square, and M/Q by the crank's angle from the line of the fixed pivots. [rad]"""
    exact, by_sines, refuted = pin_velocities(one.first, angle)
    radius = float(one.first.geometry.crank_radius)
    name = _("velocity of the rocker's pin by the crank pin's")
    product = _("the same by the product of sines")
    square, torque = _("weight at B by that at A"), _("torque by load, without losses, with r")
    yield StatementCurve(_SOURCE, "(10)", "v_A/v_B", name, one.of, "1", "right", by_sines, exact)
    yield StatementCurve(_SOURCE, "(10)", "v_A/v_B", product, one.of, "1", "refuted", refuted, exact)
    yield StatementCurve(_SOURCE, "(17)", "G_B/G_A", square, one.of, "1", "right", by_sines**2, exact**2)
    yield StatementCurve(_SOURCE, "(13)", "M/Q", torque, one.of, "m", "right", radius * by_sines, radius * exact)
