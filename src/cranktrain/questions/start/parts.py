"""How a run begins and ends, as machines declare it."""

from collections.abc import Mapping
from typing import ClassVar

import numpy as np

from cranktrain.layout.drive.table import StartSpec
from cranktrain.quantities import Given
from cranktrain.record import record


@record
class DeclaredStart:
    """How a run begins and ends, as the table of the first design says.

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
    interval : float
        Between times that are shown; infinite where the table does not say it. [s]
    tolerance : float
        Of one step. [1]
    texts : mapping of str to str
        What the table says, by key, as it is written.
    """

    reads: ClassVar[tuple[str, ...]] = ("[drive.start]",)

    angle: float
    speed: float
    duration: float
    until_speed: float
    overspeed: float
    motor_off: float
    motor_reversed: float
    brake_on: float
    unloaded_until: float
    interval: float
    tolerance: float
    texts: Mapping[str, str]


def declared_start(spec: StartSpec) -> DeclaredStart:
    """Take what the table says."""
    given: dict[str, Given | None] = {name: getattr(spec, name) for name in StartSpec.model_fields}
    sizes = {name: np.inf if one is None else one.si for name, one in given.items()}
    if spec.unloaded_until is None:
        sizes["unloaded_until"] = 0.0
    return DeclaredStart(**sizes, texts={name: one.text for name, one in given.items() if one is not None})
