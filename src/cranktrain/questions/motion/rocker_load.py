"""The load of a rocker, carried at a radius about its pivot: travel and torque factor."""

from typing import ClassVar

import numpy as np

from cranktrain.language import N_
from cranktrain.layout.design import Designs
from cranktrain.layout.mechanisms import Rockers
from cranktrain.motion import Array, Coefficient
from cranktrain.numerics import extremes
from cranktrain.questions.motion.rockers import DeadPositions, RockerMotion, RockerTurn, rocker_angle
from cranktrain.record import record
from cranktrain.references import THEORY_OF_PUMPING_UNITS as _THEORY
from cranktrain.saying.catalogue import coefficients, quantity

_ROCKER = ("rocker",)


@record
class LoadRadius:
    """Radius about each rocker's pivot at which its load is carried, shape (design, rocker, 1). [m]

    Negative where the load's travel counts against the rocker's angle.
    """

    needs: ClassVar[str] = N_("[mechanism] load_radius")

    value: Array


def load_radius_of(designs: Designs) -> LoadRadius | None:
    """Collect the load radius of every rocker, NaN for one that carries no load; None where there is none at all."""
    rockers = designs.together.driving("rocker")
    arms = [(place.sense, place.spec.load_arm) for place in rockers]
    value = designs.by_design([np.nan if arm is None else sense * arm for sense, arm in arms])[..., np.newaxis]
    return None if np.all(np.isnan(value)) else LoadRadius(value)


@record
class LoadMotion:
    """Travel of a load that hangs at the load radius of each rocker."""

    load_displacement: Coefficient = coefficients(
        "x_Q",
        "m",
        ("rocker", "crank_angle"),
        N_("Travel of the load from the dead position at which it is least"),
        N_("Load velocity for each rad/s of the crank: the torque factor of a pumping unit"),
        N_("Load acceleration for each (rad/s)² of the crank"),
        _THEORY,
        "28.1, 28.2",
    )
    load_stroke: Array = quantity("S_Q", "m", _ROCKER, N_("Stroke of the load"), _THEORY, "28.1")
    largest_torque_factor: Array = quantity(
        "TF_max",
        "m",
        _ROCKER,
        N_("Largest torque factor, crank torque for each newton of load"),
        _THEORY,
        "28.2",
        worst="largest",
    )
    smallest_torque_factor: Array = quantity(
        "TF_min", "m", _ROCKER, N_("Smallest (largest negative) torque factor"), _THEORY, "28.2", worst="smallest"
    )


def load_motion(
    rockers: Rockers, turn: RockerTurn, motion: RockerMotion, dead: DeadPositions, load_radius: LoadRadius
) -> LoadMotion:
    """Arc that the load travels at its radius, and the torque factor's extremes."""
    radius = load_radius.value
    start = np.where(radius[..., 0] > 0, dead.smallest_rocker_angle.value, dead.largest_rocker_angle.value)
    angle = motion.rocker_angle
    least, most = extremes(
        lambda phi: rocker_angle(rockers, phi).first,
        lambda phi: rocker_angle(rockers, phi).second,
        samples=turn.samples.first,
    )
    return LoadMotion(
        load_displacement=Coefficient(
            radius * (angle.value - start[..., np.newaxis]), radius * angle.first, radius * angle.second
        ),
        load_stroke=np.abs(radius[..., 0]) * dead.swing,
        largest_torque_factor=np.maximum(radius * most.value, radius * least.value)[..., 0],
        smallest_torque_factor=np.minimum(radius * most.value, radius * least.value)[..., 0],
    )
