"""The table beside a plan: what the output and each followed point do in every position, as `run` gives it."""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from cranktrain.layout.places import PlacedMechanism
from cranktrain.layout.speed import SpeedCurve, rates
from cranktrain.machine import Machine
from cranktrain.motion import Array
from cranktrain.numerics.extremes import largest
from cranktrain.plans.link_points import with_points
from cranktrain.plans.placement import output_motion
from cranktrain.plans.turning import turning


class PositionColumn(NamedTuple):
    """A column: symbol, unit in SI (rad for angles), values of shape (n,)."""

    symbol: str
    unit: str
    values: Array


def output_columns(
    machine: Machine, place: PlacedMechanism, angles: Array, curve: SpeedCurve | None = None
) -> tuple[PositionColumn, ...]:
    """Motion of a place's output in each position.

    Parameters
    ----------
    machine : Machine
    place : PlacedMechanism
    angles : Array, shape (n,)
        Crank angles as the machine shows them. [deg]
    curve : SpeedCurve, optional
        How fast the crank turns; evenly unless given.

    Returns
    -------
    tuple of PositionColumn
        Of a slider x from the shaft along the line of stroke, s from its true top toward the shaft, and the velocity
        and acceleration of s, as results have them; of a rocker its angle and that one's rates. Without a speed,
        derivatives by the crank angle.

    Examples
    --------
    >>> pump = Machine(mechanism={"kind": "slider_crank", "stroke": "160 mm", "rod_length": "160 mm"})
    >>> [(one.symbol, one.unit, round(float(one.values[0]), 6)) for one in output_columns(pump, pump.places[0], [90.0])]
    [('x', 'm', 0.138564), ('s', 'm', 0.101436), ('s′', 'm/rad', 0.08), ('s″', 'm/rad^2', -0.046188)]
    """
    angle = np.deg2rad(np.asarray(angles, dtype=np.float64))
    motion = output_motion(machine, place, angle)
    first, second = rates(motion, turning(machine, curve, angle + machine.zero))
    has_speed = machine.main_shaft.speed is not None or curve is not None
    if not place.kind.output.is_slider:
        symbols = ("ω₃", "ε₃") if has_speed else ("θ′", "θ″")
        units = ("rad/s", "rad/s^2") if has_speed else ("rad/rad", "rad/rad^2")
        return (
            PositionColumn("θ", "rad", motion.value),
            *(PositionColumn(*parts) for parts in zip(symbols, units, (first, second), strict=True)),
        )
    top = largest(lambda at: output_motion(machine, place, at).value).value
    symbols, units = (("v", "a"), ("m/s", "m/s^2")) if has_speed else (("s′", "s″"), ("m/rad", "m/rad^2"))
    return (
        PositionColumn("x", "m", motion.value),
        PositionColumn("s", "m", top - motion.value),
        *(PositionColumn(*parts) for parts in zip(symbols, units, (0.0 - first, 0.0 - second), strict=True)),
    )


def point_columns(
    machine: Machine, place: PlacedMechanism, angles: Array, curve: SpeedCurve | None = None
) -> Iterator[tuple[str, tuple[PositionColumn, ...]]]:
    """Path, speed and size of the acceleration of every point that is followed, by its name; x, y as results have them.

    Parameters as of `output_columns`.
    """
    shown = np.deg2rad(np.asarray(angles, dtype=np.float64))
    angle = shown + machine.zero
    drive = turning(machine, curve, angle)
    has_speed = machine.main_shaft.speed is not None or curve is not None
    units = ("m/s", "m/s^2") if has_speed else ("m/rad", "m/rad^2")
    turned = angle + place.phase
    with np.errstate(all="ignore"):
        drawing = with_points(place.kind.drawing(turned, place.geometry), place, turned)
    for name in drawing.points:
        pin = drawing.pins[name]
        along, across = (rates(part, drive) for part in pin)
        sizes = [np.hypot(one, other) for one, other in zip(along, across, strict=True)]
        rest = zip(("v", "a") if has_speed else ("r′", "r″"), units, sizes, strict=True)
        yield (
            name,
            (
                PositionColumn("x", "m", pin.x.value),
                PositionColumn("y", "m", pin.y.value),
                *(PositionColumn(*parts) for parts in rest),
            ),
        )
