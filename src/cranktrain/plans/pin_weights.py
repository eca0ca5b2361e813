"""Weights of a driven crank-rocker at its pins, as [gandzha] has them: G_A of what turns with the rocker, G_B at B."""

from typing import NamedTuple

import numpy as np

from cranktrain.machine import Machine
from cranktrain.plans.machine_drive import inertia_about_pivot
from cranktrain.plans.schemes import Scheme
from cranktrain.texts.crank_rocker_drive import Directions, weight_at_crank_pin, weight_at_rocker_pin


class PinWeights(NamedTuple):
    """G_A and G_B. [kg]"""

    rocker_pin: float
    crank_pin: float


def pin_weights(machine: Machine, found: Scheme) -> PinWeights | None:
    """Weights at the pins at the angle of a scheme.

    Parameters
    ----------
    machine : Machine
    found : Scheme

    Returns
    -------
    PinWeights or None
        None without a drive, of another mechanism, or where [masses] has nothing that turns with the rocker.

    Notes
    -----
    docs/theory/crank-rocker-drive, (15) to (17).
    """
    place = next((one for one in machine.places if one.name == found.mechanism), None)
    if machine.drive is None or place is None or place.kind.name != "crank_rocker":
        return None
    inertia = inertia_about_pivot(machine, place, "rocker")
    if inertia == 0:
        return None
    angles = {one.letter: np.array(one.value) for one in found.angles}
    weight = weight_at_rocker_pin(np.array(4 * inertia), np.ravel(place.geometry.rocker_length)[0])
    at = Directions(angles["α"], angles["β"], angles["α_1"])
    return PinWeights(float(weight), float(weight_at_crank_pin(weight, at)))
