"""Heat by Wiebe's law in the chambers of all designs: the working turn, and the gas exchange between two of them."""

from functools import partial
from typing import Any, NamedTuple

import numpy as np

from cranktrain.errors import InputError, Problem
from cranktrain.fluids.fluid import Rooms
from cranktrain.fluids.state import ChamberState
from cranktrain.fluids.wiebe.curve import (
    BurningCurve,
    Room,
    Wiebe,
    burning_curve,
    burning_edges,
    burning_pressure,
    burning_slope,
)
from cranktrain.language import _
from cranktrain.motion import Array, Coefficient, chosen
from cranktrain.numerics import around_zero


class WiebeNumbers(NamedTuple):
    """What a machine file's table says: as `Wiebe`, but for the coefficient h itself [W/(m²·K)], and pressures [Pa]."""

    start_pressure: Any
    heat: Any
    start: Any
    duration: Any
    shape: Any
    completeness: Any
    heat_ratio: Any
    transfer: Any
    start_temperature: Any
    wall_temperature: Any
    inlet_pressure: Any
    exhaust_pressure: Any


class BurningChambers(NamedTuple):
    """The curve of every chamber, and the pressures of its gas exchange, shape (design, chamber, …).

    burns: edges while it burns, in [0, cycle) [rad]; heat: that comes in [J]; area: of one end of the chamber [m²];
    inlet, exhaust [Pa].
    """

    curve: BurningCurve
    burns: Array
    heat: Array
    area: Array
    inlet: Array
    exhaust: Array


def burning_chambers(numbers: WiebeNumbers, rooms: Rooms) -> BurningChambers:
    """Integrate the energy balance of every chamber over its working turn.

    Parameters
    ----------
    numbers : WiebeNumbers, fields of shape (design, 1, 1)
    rooms : Rooms

    Returns
    -------
    BurningChambers

    Raises
    ------
    InputError
        If heat goes to the walls and the machine has no speed.
    """
    transfer = np.zeros_like(numbers.transfer)
    if np.any(numbers.transfer):
        if rooms.speed is None:
            allowed = _("needs [shaft.main] speed: what the walls take goes by time")
            raise InputError([Problem(f"{rooms.path}.heat_transfer", None, allowed)])
        transfer = numbers.transfer / rooms.speed
    shape = (*rooms.bottoms.shape[:2], 1)
    wiebe = Wiebe(*(np.broadcast_to(part, shape) for part in numbers._replace(transfer=transfer)[: len(Wiebe._fields)]))
    around = partial(walls, rooms.area[..., np.newaxis])
    return BurningChambers(
        curve=burning_curve(wiebe, Room(rooms.bottoms[..., :1], rooms.bottoms[..., 1:], rooms.volume, around)),
        burns=np.sort(np.mod(burning_edges(wiebe), rooms.cycle), axis=-1),
        area=rooms.area,
        heat=(wiebe.heat * -np.expm1(-wiebe.completeness))[..., 0],
        inlet=np.broadcast_to(numbers.inlet_pressure, shape),
        exhaust=np.broadcast_to(numbers.exhaust_pressure, shape),
    )


def walls(area: Array, volume: Array) -> Array:
    """Area of the walls about a volume in a cylinder that is closed at both ends. [m²]"""
    return 2 * area + 4 * volume / np.sqrt(4 * area / np.pi)


def chamber_pressure(state: ChamberState, chambers: BurningChambers) -> Array:
    """Absolute pressure: of the working turn, at its dead centres as just after, and of the gas exchange. [Pa]"""
    working = burning_pressure(chambers.curve, _angle(state), state.volume)
    exchange = chosen(state.sense > 0, chambers.inlet, chambers.exhaust)
    return chosen(state.turn > 0, working, exchange)


def chamber_slope(state: ChamberState, pressure: Array, volume_slope: Array, chambers: BurningChambers) -> Array:
    """Derivative of `chamber_pressure` by the crank angle, for that of the volume. [Pa/rad]"""
    volume = Coefficient(state.volume, volume_slope, np.zeros_like(volume_slope))
    wall = walls(chambers.area, state.volume)
    return chosen(state.turn > 0, burning_slope(chambers.curve, _angle(state), volume, pressure, wall), 0.0)


def _angle(state: ChamberState) -> Array:
    """Angle from the firing of the same working turn. [rad]"""
    # Beyond 90° from the firing the sense tells on which side of the bottom the crank is.
    near = around_zero(state.angle_from_firing, 2 * np.pi)
    side = np.sign(near) * state.sense
    return np.where((np.abs(near) > np.pi / 2) & (side < 0), near + 2 * np.pi * state.sense, near)


def chamber_work(chambers: BurningChambers, rooms: Rooms) -> Array:
    """∮ p dV over the cycle, shape (design, chamber). [J]"""
    work = chambers.curve.work
    if rooms.n_turns > 1:
        work = work + ((chambers.inlet - chambers.exhaust) * rooms.swept_volume)[..., 0]
    return work
