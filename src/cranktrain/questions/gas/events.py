"""Events of the gas: dead centres and kinks of its pressure, between which all torques are smooth."""

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from cranktrain.fluids import Kink
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.motion import Array, Coefficient
from cranktrain.questions.cylinders.travel import CylinderTravel
from cranktrain.questions.gas.chambers import GasInChambers
from cranktrain.record import record

_MOST_STEPS, _SETTLED = 30, 1e-5
"""A step of Halley's method, which takes the curvature too, after which the next one is less than rounding. [rad]"""
_NEAR_POLE = np.pi / 18
"""How near to a firing a pole of the pressure is of which pieces between events know nothing. [rad]"""


@record
class GasEvents:
    """Between what all torques are smooth.

    Attributes
    ----------
    angle : Array, shape (design, chamber, event)
        φ of each chamber's dead centres, kinks and ends of pieces of a measured card in a cycle of the machine, which
        may be two of the gas, and of places beside a firing at which the volume is next to nothing; NaN for none. [rad]
    least : Coefficient, shape (design, distinct, 1)
        Volume of the gas's distinct chambers at their firing. [m³, m³/rad, m³/rad²]
    named : mapping of str to Array, shape (design, chamber)
        φ of those kinks that are called something, in the working turn. [rad]
    """

    angle: Array
    least: Coefficient
    named: Mapping[str, Array]


def gas_events(gas: GasInChambers, travel: CylinderTravel, crank_angle: CrankAngle) -> GasEvents:
    """Find dead centres and kinks of all chambers; docs/theory/forces, eq. (13.40)."""
    firing, opposite = gas.dead_centres(travel)
    turns = 2 * np.pi * np.arange(round(gas.cycle / (2 * np.pi)))
    least = _volume_at(gas, firing[:, gas.distinct, np.newaxis], gas.distinct)
    kinks = _kinks(gas, firing, least)
    centres = firing[..., np.newaxis] + turns
    design = np.arange(len(firing))[:, np.newaxis]
    beside = [centres + away[design, gas.among_distinct] for away in _beside_poles(least)]
    once = [centres, opposite[..., np.newaxis] + turns, kinks, gas.firing + _breaks(gas), *beside]
    cycles = gas.cycle * np.arange(round(crank_angle.cycle / gas.cycle))
    return GasEvents(
        np.concatenate([angle + cycle for cycle in cycles for angle in once], axis=-1), least, _named(gas, kinks)
    )


def _beside_poles(least: Coefficient) -> list[Array]:
    """From a firing: where pieces have to end as the pressure has a pole near it, shapes (design, distinct, 1). [rad]

    Near its least value V = V_c + ½V″φ², which is 0 at an imaginary φ: a piece reaches half as far as that, the next
    one twice as far, and so on, so that few points show the pressure itself. None where all poles are farther than
    pieces are wide.
    """
    with np.errstate(all="ignore"):
        away = np.sqrt(2 * least.value / least.second)
    reach = np.where((away > 0) & (away < _NEAR_POLE), away / 2, np.nan)
    found: list[Array] = []
    while np.any(reach < 2 * _NEAR_POLE):
        found += [-reach, reach]
        reach = np.where(reach < _NEAR_POLE, 2 * reach, np.nan)
    return found


def _named(gas: GasInChambers, kinks: Array) -> dict[str, Array]:
    """φ of the kinks that are called something, by the names: NaN of chambers whose gas has none so called."""
    found: dict[str, Array] = {}
    for number, (places, kink) in enumerate(_each_kink(gas)):
        if kink.called and kink.turn > 0:
            whole = found.setdefault(kink.called, np.full(kinks.shape[:2], np.nan))
            whole[:, places] = kinks[:, places, number]
    return found


def _each_kink(gas: GasInChambers) -> list[tuple[NDArray[np.intp], Kink]]:
    """Kinks of all fluids, each with the chambers that have it."""
    return [(one.places, kink) for one in gas.fillings for kink in one.fluid.kinks(one.ready, one.rooms.limits)]


def _volume_at(gas: GasInChambers, angle: Array, places: Sequence[int]) -> Coefficient:
    """Volume of some chambers, each at its own φ, shape (design, place, k)."""
    return Coefficient(*gas.at_own(angle, places, lambda own: np.stack(gas.volume(own))))


def _kinks(gas: GasInChambers, firing: Array, least: Coefficient) -> Array:
    """φ of the kinks of all chambers, by Halley's method from the dead centre, shape (design, chamber, kink). [rad]"""
    kinks = _kinks_of_fluids(gas)
    places = [place for place in gas.distinct for _kink in range(kinks.shape[-1])]
    volume, sense, turn = kinks.reshape(3, len(firing), -1)[..., np.newaxis]
    if volume.size == 0:
        return np.empty((*firing.shape, 0))
    centre = firing[:, places, np.newaxis]
    # Near the dead centre the volume is a parabola.
    smallest, curvature = (np.repeat(part, kinks.shape[-1], axis=1) for part in (least.value, least.second))
    away = np.minimum(np.sqrt(2 * (volume - smallest) / curvature), 0.75 * np.pi)
    for _step in range(_MOST_STEPS):
        found = _volume_at(gas, centre + sense * away, places)
        excess = found.value - volume
        move = excess / (found.first - excess * found.second / (2 * found.first))
        before, away = away, np.clip(away - sense * move, away / 4, np.pi)
        if not np.any(np.abs(away - before) > _SETTLED):
            break
    after = np.where(turn > 0, 0.0, 2 * np.pi) + sense * away
    each = after.reshape(len(firing), len(gas.distinct), -1)
    design = np.arange(len(firing))[:, np.newaxis]
    return firing[..., np.newaxis] + each[design, gas.among_distinct]


def _breaks(gas: GasInChambers) -> Array:
    """Where the pieces of measured cards meet, from nominal firing, shape (design, chamber, break): NaN fills up."""
    each = [(one.places, one.fluid.breaks(one.ready)) for one in gas.fillings if one.fluid.breaks is not None]
    filled = np.full((*gas.firing.shape[:2], max((own.shape[-1] for _places, own in each), default=0)), np.nan)
    for places, own in each:
        filled[:, places, : own.shape[-1]] = own
    return filled


def _kinks_of_fluids(gas: GasInChambers) -> Array:
    """Volume, sense and turn of the kinks of the distinct chambers, (3, design, distinct, kink): NaN fills up."""
    each = _each_kink(gas)
    filled = np.full((3, *gas.firing.shape[:2], len(each)), np.nan)
    for number, (places, kink) in enumerate(each):
        for part, value in zip(filled, (kink.volume[..., 0], kink.sense, kink.turn), strict=True):
            part[:, places, number] = value
    return filled[:, :, gas.distinct]
