"""How a run begins and ends, as machines declare it."""

from collections.abc import Mapping
from typing import ClassVar, NamedTuple

import numpy as np

from cranktrain.layout.design import Designs
from cranktrain.layout.drive.declared import DeclaredStroke
from cranktrain.layout.drive.table import StartSpec
from cranktrain.motion import Array
from cranktrain.quantities import Given
from cranktrain.record import record


class StartOrders(NamedTuple):
    """How a run begins and ends, of one design; or arrays of shape (design,).

    Attributes
    ----------
    angle, speed : float
        Of the crank at the beginning, as shown. [rad, rad/s]
    duration : float
        The most that is computed; infinite where the table does not say it. [s]
    until_speed, overspeed : float
        Of the crank, at which it ends; infinite for none. [rad/s]
    motor_off, motor_reversed, brake_on : float
        When each is commanded; infinite for never. [s]
    unloaded_until : float
        Until when suction valves are held open; 0 where they are not. [s]
    gas_pressure : float
        In a compressor's chambers at the beginning; NaN for that of suction. [Pa]
    interval : float
        Between times that are shown; infinite where the table does not say it. [s]
    tolerance : float
        Of one step. [1]
    """

    angle: float
    speed: float
    duration: float
    until_speed: float
    overspeed: float
    motor_off: float
    motor_reversed: float
    brake_on: float
    unloaded_until: float
    gas_pressure: float
    interval: float
    tolerance: float

    @property
    def are_to_settle(self) -> bool:
        """Whether a run ends where it turns as it will, as nothing else is asked for."""
        return bool(np.all(np.isinf((self.duration, self.until_speed, self.motor_off, self.brake_on))))


@record
class DeclaredStart:
    """How runs begin and end.

    Attributes
    ----------
    orders : Array, shape (design, order)
        Those of `StartOrders`.
    texts : mapping of str to str
        What the table of the first design says, by key, as it is written.
    """

    reads: ClassVar[tuple[str, ...]] = ("[drive.start]",)

    orders: Array
    texts: Mapping[str, str]

    def of(self, design: int) -> StartOrders:
        """Of one design."""
        return StartOrders(*self.orders[design].tolist())


def declared_start(spec: StartSpec, designs: Designs) -> DeclaredStart:
    """Take what the table says."""
    given: dict[str, Given | None] = {name: getattr(spec, name) for name in StartOrders._fields}
    unsaid = dict.fromkeys(given, np.inf) | {"unloaded_until": 0.0, "gas_pressure": np.nan}
    orders = [unsaid[name] if one is None else one.array for name, one in given.items()]
    return DeclaredStart(designs.by_design(orders), {name: one.text for name, one in given.items() if one is not None})


def are_strokes_wanted(stroke: DeclaredStroke | None) -> bool:
    """Whether single strokes of a press are asked for; then a start is one."""
    return stroke is not None
