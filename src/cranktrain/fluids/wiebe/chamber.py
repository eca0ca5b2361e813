"""Heat by Wiebe's law in the chambers of all designs: the working turn, and the gas exchange between two of them."""

from typing import Any, NamedTuple

import numpy as np

from cranktrain.errors import InputError, Problem
from cranktrain.fluids.fluid import Rooms
from cranktrain.fluids.state import ChamberState
from cranktrain.fluids.wiebe.curve import BurningCurve, Room, Wiebe, burning_curve, burning_edges, burning_pressure
from cranktrain.language import _
from cranktrain.motion import Array, chosen
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

    edges, values, heat_ratio: as `BurningCurve` has them; burns: edges while it burns, in [0, cycle) [rad];
    work, loss: of the working turn [J]; heat: that comes in [J]; inlet, exhaust [Pa].
    """

    edges: Array
    values: Array
    heat_ratio: Array
    burns: Array
    work: Array
    loss: Array
    heat: Array
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
    shape = (*rooms.alike.shape, 1)
    wiebe = Wiebe(*(np.broadcast_to(part, shape) for part in numbers._replace(transfer=transfer)[: len(Wiebe._fields)]))
    area = rooms.area[..., np.newaxis]

    def walls(volume: Array) -> Array:
        return 2 * area + 4 * volume / np.sqrt(4 * area / np.pi)

    room = Room(rooms.bottoms[..., :1], rooms.bottoms[..., 1:], rooms.volume, walls)
    curve = burning_curve(wiebe, room)
    return BurningChambers(
        edges=curve.edges,
        values=curve.values,
        heat_ratio=np.asarray(curve.heat_ratio),
        burns=np.sort(np.mod(burning_edges(wiebe), rooms.cycle), axis=-1),
        work=curve.work[..., np.newaxis],
        loss=curve.loss[..., np.newaxis],
        heat=wiebe.heat * -np.expm1(-wiebe.completeness),
        inlet=np.broadcast_to(numbers.inlet_pressure, shape),
        exhaust=np.broadcast_to(numbers.exhaust_pressure, shape),
    )


def chamber_pressure(state: ChamberState, chambers: BurningChambers) -> Array:
    """Absolute pressure: of the working turn, at its dead centres as just after, and of the gas exchange. [Pa]"""
    # Beyond 90° from the firing the sense tells on which side of the bottom the crank is.
    near = around_zero(state.angle_from_firing, 2 * np.pi)
    side = np.sign(near) * state.sense
    angle = np.where((np.abs(near) > np.pi / 2) & (side < 0), near + 2 * np.pi * state.sense, near)
    curve = BurningCurve(chambers.edges, chambers.values, chambers.heat_ratio, chambers.work, chambers.loss)
    working = burning_pressure(curve, angle, state.volume)
    exchange = chosen(state.sense > 0, chambers.inlet, chambers.exhaust)
    return chosen(state.turn > 0, working, exchange)


def chamber_work(chambers: BurningChambers, rooms: Rooms) -> Array:
    """∮ p dV over the cycle, shape (design, chamber). [J]"""
    exchange = (chambers.inlet - chambers.exhaust) * rooms.swept_volume if rooms.n_turns > 1 else 0.0
    return (chambers.work + exchange)[..., 0]
