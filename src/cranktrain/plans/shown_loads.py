"""Loads of the machine file for a picture: on some mechanisms at any crank angle, and the largest of the cycle."""

from collections.abc import Iterator, Sequence
from functools import cached_property

import numpy as np

from cranktrain.analysis import Result, SpeedWanted
from cranktrain.layout.places import PlacedMechanism
from cranktrain.machine import Machine
from cranktrain.motion import Array
from cranktrain.plans.acting import made_ready, ready_in
from cranktrain.plans.acting_loads import ActingLoad, acting_loads, loads_on_shafts
from cranktrain.plans.placement import shaft_places
from cranktrain.quantities import shown
from cranktrain.questions.forces.loaded_machine import LoadedMachine
from cranktrain.record import record

_STEP = 2.0
"""Of crank angles at which the largest load is looked for. [deg]"""


@record
class ShownLoads:
    """Loads on mechanisms that stand together.

    Attributes
    ----------
    machine : Machine
    loaded : LoadedMachine
    places : tuple of PlacedMechanism
    origin : Array, shape (2,)
        From where they are drawn, from the main shaft. [m]
    """

    machine: Machine
    loaded: LoadedMachine
    places: tuple[PlacedMechanism, ...]
    origin: Array

    def at(self, angles: Array) -> tuple[ActingLoad, ...]:
        """Loads at crank angles as the machine shows them [deg]; their places count from the origin."""
        return self._over_cycle[0] if np.array_equal(angles, self._angles) else tuple(self._at(angles))

    def _at(self, angles: Array) -> Iterator[ActingLoad]:
        """Loads of each mechanism in turn, where its shaft stands."""
        phi = np.deg2rad(angles) + self.machine.zero
        centres = shaft_places(self.machine).centres
        for place in self.places:
            away = (centres.get(place.shaft, np.zeros(2)) - self.origin).reshape(2, 1)
            for load in acting_loads(self.machine, self.loaded, place, phi):
                yield load.moved(away)

    def on_shafts_at(self, angles: Array) -> tuple[ActingLoad, ...]:
        """Torques on the shafts of the mechanisms at crank angles as the machine shows them [deg], about the shafts."""
        return self._over_cycle[1] if np.array_equal(angles, self._angles) else tuple(self._on_shafts_at(angles))

    def _on_shafts_at(self, angles: Array) -> Iterator[ActingLoad]:
        """Torque on each shaft in turn."""
        phi = np.deg2rad(angles) + self.machine.zero
        centres = shaft_places(self.machine).centres
        for load in loads_on_shafts(self.machine, self.loaded, self.places, phi):
            yield load.moved((centres.get(load.link, np.zeros(2)) - self.origin).reshape(2, 1))

    @cached_property
    def _angles(self) -> Array:
        """Over the cycle with both ends, at which a page draws them, too. [deg]"""
        return np.arange(0.0, shown(self.machine.cycle, "deg") + _STEP / 2, _STEP)

    @cached_property
    def _over_cycle(self) -> tuple[tuple[ActingLoad, ...], tuple[ActingLoad, ...]]:
        """Loads there, and torques on the shafts."""
        return tuple(self._at(self._angles)), tuple(self._on_shafts_at(self._angles))

    @cached_property
    def outline(self) -> Array:
        """Where forces act over the cycle, shape (2, n); empty where there is none. [m]"""
        places = [load.place[:, :-1] for each in self._over_cycle for load in each if not load.is_torque]
        return np.concatenate(places, axis=1) if places else np.empty((2, 0))

    @cached_property
    def largest(self) -> dict[bool, float]:
        """Largest size over the cycle, of torques and of forces: by whether it is a torque. [N·m or N]"""
        found = {True: 0.0, False: 0.0}
        for load in (one for each in self._over_cycle for one in each):
            largest = float(np.nanmax(np.abs(load.size[:-1]), initial=0.0))  # the last angle is the first again
            found[load.is_torque] = max(found[load.is_torque], largest)
        return found


def shown_loads(
    machine: Machine,
    places: Sequence[PlacedMechanism],
    speed: SpeedWanted = "constant",
    origin: Array | None = None,
    result: Result | None = None,
) -> ShownLoads | None:
    """Loads of the file on mechanisms that a picture shows.

    Parameters
    ----------
    machine : Machine
    places : sequence of PlacedMechanism
    speed : SpeedWanted
        As `cranktrain.run` takes it.
    origin : Array, shape (2,), optional
        From where they are drawn, from the main shaft; the first one's shaft unless given. [m]
    result : Result, optional
        Of the machine at this speed, where there is one: what it has is not found again.

    Returns
    -------
    ShownLoads or None
        None where the file has no loads, says no speed, or its links cannot close all round: then there are no forces.
    """
    main = machine.main_shaft
    if not machine.loads or (main.speed is None and main.speed_curve is None) or machine.closing_problems:
        return None
    centre = shaft_places(machine).centres.get(places[0].shaft, np.zeros(2))
    ready = made_ready(machine, speed) if result is None else ready_in(result)
    return ShownLoads(machine, ready, tuple(places), centre if origin is None else origin)
