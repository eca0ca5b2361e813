"""Pistons of a machine in their order of firing, and where the throws stand on which they are."""

from collections.abc import Sequence

import numpy as np

from cranktrain.analysis import Result
from cranktrain.grouping import grouped
from cranktrain.language import Words
from cranktrain.layout.frames import in_machine_axes
from cranktrain.layout.places import PlacedMechanism
from cranktrain.machine import Machine
from cranktrain.plans.placement import frame
from cranktrain.questions.cylinders.firing import Firing
from cranktrain.record import record


@record
class PagePiston:
    """A piston whose throw and curves may be shown.

    Attributes
    ----------
    name : str
    number : str
        The maker's of its cylinder, by which the firing order names it; none where the file gives none.
    firing : Words
        When it fires; nothing of one that does not.
    shaft : str
    throw : int
    """

    name: str
    number: str
    firing: Words
    shaft: str
    throw: int


@record
class PageThrow:
    """A throw of a shaft.

    Attributes
    ----------
    shaft : str
    number : int
        Which of the shaft's, from 1.
    direction : float
        Of its crank from X, anticlockwise, where the shown crank angle is 0. [rad]
    """

    shaft: str
    number: int
    direction: float


def page_pistons(result: Result) -> tuple[PagePiston, ...]:
    """Give the pistons of a machine in the order in which they fire, or in that of the file; none of one alone."""
    places, firing = result.machines[0].design.pistons, result.get(Firing)
    if len(places) < 2:
        return ()
    angles = (
        {} if firing is None else dict(zip(result.labels["cylinder"], firing.firing_angle[0].tolist(), strict=True))
    )
    numbers = (
        {}
        if firing is None
        else dict(zip((result.labels["cylinder"][place] for place in firing.order), firing.numbers, strict=False))
    )
    in_order = sorted(places, key=lambda place: angles.get(place.cylinder, 0.0))
    return tuple(
        PagePiston(
            place.name,
            numbers.get(place.cylinder, ""),
            _degrees(angles.get(place.cylinder)),
            place.shaft,
            place.throw + 1,
        )
        for place in in_order
    )


def page_throws(machine: Machine) -> tuple[PageThrow, ...]:
    """Give the throws that bear pistons of a machine, of each shaft that has several."""
    throws = grouped(((place.shaft, place.throw), place) for place in machine.design.pistons)
    shafts = grouped(
        (shaft, PageThrow(shaft, throw + 1, _direction(machine, own))) for (shaft, throw), own in throws.items()
    )
    return tuple(throw for of_shaft in shafts.values() if len(of_shaft) > 1 for throw in of_shaft)


def _direction(machine: Machine, places: Sequence[PlacedMechanism]) -> float:
    """Direction of the crank of some places, by the first that is no slave: those count from their master's axis."""
    place = next((one for one in places if not one.kind.is_slave), places[0])
    angle = np.float64(machine.zero + place.phase)
    x, y = in_machine_axes(np.cos(angle), np.sin(angle), frame(machine, place))
    return float(np.arctan2(y, x))


def _degrees(angle: float | None) -> str:
    """Write when a piston fires, of which the texts give whole degrees."""
    return "" if angle is None or not np.isfinite(angle) else f"{round(float(np.degrees(angle)), 2):g}°"
