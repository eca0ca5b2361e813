"""A small catalogue of generic four-pole cage motors: typical values, nobody's."""

import csv
from functools import cache
from pathlib import Path

import numpy as np

from cranktrain.motion import Array
from cranktrain.motors.cage.law import CAGE, CatalogueValues, catalogue_curve
from cranktrain.motors.declared import DeclaredMotor, Rating
from cranktrain.record import record

_FILE = Path(__file__).with_name("four_pole.csv")
_PER_MINUTE = 2 * np.pi / 60
_SYNCHRONOUS = 1500 * _PER_MINUTE


@record
class MotorRange:
    """Cage motors by rising power, arrays of shape (motor,).

    Attributes
    ----------
    frame : tuple of str
        Shaft height in mm, as makers name sizes.
    power : Array
        At the shaft. [W]
    values : CatalogueValues
        Torques by slip.
    inertia : Array
        Of the rotor. [kg·m²]
    starting_current_ratio : Array
        Line current at standstill over the rated one. [1]
    efficiency, power_factor : Array
        At rated load. [1]
    is_typical : bool
        Whether values are such as motors of a size have, and no maker's.
    """

    frame: tuple[str, ...]
    power: Array
    values: CatalogueValues
    inertia: Array
    starting_current_ratio: Array
    efficiency: Array
    power_factor: Array
    is_typical: bool


@cache
def four_pole_motors() -> MotorRange:
    """Generic four-pole cage motors at 50 Hz, from 0.12 to 355 kW.

    Returns
    -------
    MotorRange, 30 motors
        Typical values, to be replaced by the maker's before a motor is bought.

    Notes
    -----
    The rated torque is power over speed. docs/theory/drive, section The small catalogue.

    Examples
    --------
    >>> motors = four_pole_motors()
    >>> motors.frame[10], round(float(motors.values.rated_torque[10]), 4), motors.is_typical
    ('112M', 26.1625, True)
    """
    lines = _FILE.read_text(encoding="utf-8").splitlines()
    rows = list(csv.DictReader(line for line in lines if not line.startswith("#")))

    def column(name: str) -> Array:
        return np.array([float(row[name]) for row in rows])

    power, speed = 1e3 * column("power_kW"), _PER_MINUTE * column("speed_rpm")
    return MotorRange(
        frame=tuple(row["frame"] for row in rows),
        power=power,
        values=CatalogueValues(
            power / speed,
            speed,
            np.full_like(speed, _SYNCHRONOUS),
            column("breakdown_ratio"),
            column("starting_ratio"),
            column("pull_up_ratio"),
        ),
        inertia=column("inertia_kgm2"),
        starting_current_ratio=column("starting_current_ratio"),
        efficiency=column("efficiency_percent") / 100,
        power_factor=column("power_factor"),
        is_typical=True,
    )


@cache
def typical_motors() -> DeclaredMotor:
    """Motors of the small catalogue, each as one design."""
    motors = four_pole_motors()
    values = motors.values
    rating = Rating(values.rated_torque, values.rated_speed)
    curve = catalogue_curve(values)
    return DeclaredMotor(CAGE, curve, rating, values.synchronous_speed, motors.inertia).over_designs(motors.power.size)
