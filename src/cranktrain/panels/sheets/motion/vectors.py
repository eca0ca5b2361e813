"""Velocities of pins as vectors, exact at every crank angle."""

from collections.abc import Iterator, Sequence

import numpy as np

from cranktrain.analysis import Result
from cranktrain.language import _
from cranktrain.layout.places import PlacedMechanism
from cranktrain.layout.speed import SpeedCurve, rates
from cranktrain.motion import Array
from cranktrain.panels.vectors import PinVector, VectorsToScale, to_one_scale
from cranktrain.plans.placement import placed
from cranktrain.plans.turning import turning
from cranktrain.plans.vectors import spoken_name

_ALIKE = 1e-9
"""Pins that are never farther apart are one. [m]"""


def velocities(result: Result, places: Sequence[PlacedMechanism], angles: Array) -> Iterator[VectorsToScale]:
    """Give the velocities of all that moves, of pins that mechanisms share once; none where no speed is known.

    Parameters
    ----------
    result : Result
        Of one machine.
    places : sequence of PlacedMechanism
        What is drawn.
    angles : Array, shape (n,)
        Crank angles as the machine shows them. [deg]

    Yields
    ------
    VectorsToScale
        v = r′ω. [m/s]
    """
    if result.machines[0].main_shaft.speed is not None or result.get(SpeedCurve) is not None:
        yield from to_one_scale("m/s", [(_("Velocities"), _velocities(result, places, angles))])


def _velocities(result: Result, places: Sequence[PlacedMechanism], angles: Array) -> Iterator[PinVector]:
    """Give them pin by pin."""
    machine = result.machines[0]
    phi = np.ravel(np.deg2rad(angles) + machine.zero)
    drive = turning(machine, result.get(SpeedCurve), phi)
    reached: list[Array] = []
    for place in places:
        drawing = placed(machine, place, phi)
        for name, at in drawing.positions.items():
            is_known = any(np.array_equal(np.isnan(at), np.isnan(one)) and _apart(at, one) < _ALIKE for one in reached)
            if is_known or name in (*drawing.fixed, *drawing.ends):
                continue
            reached.append(at)
            value = np.stack([rates(part, drive)[0] for part in drawing.pins[name]])
            yield PinVector(place.name, name, "v", f"v_{{{_index(name)}}}", value)


def _apart(one: Array, other: Array) -> float:
    """How far two pins come apart. [m]"""
    return float(np.nanmax(np.abs(one - other), initial=0.0))


def _index(pin: str) -> str:
    """Name of a pin as an index: a letter is one of mathematics, a word is not."""
    name = spoken_name(pin).replace("_", " ")
    return name if len(name) == 1 else rf"\mathrm{{{name}}}"
