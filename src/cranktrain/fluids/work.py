"""Work of the gas, mean pressures and powers."""

from typing import NamedTuple

from cranktrain.motion import Array, chosen


class MeanPressures(NamedTuple):
    """Indicated mean effective pressures: of compression and expansion, of the gas exchange, and of both. [Pa]"""

    gross: Array
    pumping: Array
    net: Array


def indicated_power(work: Array, cycle: Array, speed: Array) -> Array:
    """Power of the gas on the pistons.

    Parameters
    ----------
    work : Array
        Of one cycle. [J]
    cycle : Array, broadcastable
        2π of a two-stroke, 4π of a four-stroke. [rad]
    speed : Array, broadcastable
        ω [rad/s]

    Returns
    -------
    Array, of the broadcast shape. [W]

    Examples
    --------
    A four-stroke cylinder that gives 1 kJ a cycle at 3000 rpm:

    >>> from math import pi
    >>> round(indicated_power(1000.0, 4 * pi, 3000 * pi / 30), 6)
    25000.0
    """
    return work / cycle * speed


def friction_power(friction_mean_pressure: Array, swept_volume: Array, cycle: Array, speed: Array) -> Array:
    """Power that friction takes, from a constant friction mean effective pressure.

    Parameters
    ----------
    friction_mean_pressure : Array
        Work that friction takes in a cycle, per swept volume. [Pa]
    swept_volume : Array, broadcastable
        [m³]
    cycle, speed : Array, broadcastable
        [rad, rad/s]

    Returns
    -------
    Array, of the broadcast shape. [W]
    """
    return indicated_power(friction_mean_pressure * swept_volume, cycle, speed)


def friction_power_by_efficiency(indicated: Array, mechanical_efficiency: Array) -> Array:
    """Power that friction takes, from the mechanical efficiency.

    Parameters
    ----------
    indicated : Array
        Power of the gas on the pistons: what an engine gets, or what a driven machine gives, then negative. [W]
    mechanical_efficiency : Array, broadcastable
        η, more than 0 and at most 1. [1]

    Returns
    -------
    Array, of the broadcast shape
        Never negative: (1 − η)P of an engine, (1/η − 1)|P| of a driven machine. [W]

    Examples
    --------
    >>> [round(float(friction_power_by_efficiency(power, 0.8)), 6) for power in (100.0, -100.0)]
    [20.0, 25.0]
    """
    return chosen(indicated > 0, 1 - mechanical_efficiency, 1 - 1 / mechanical_efficiency) * indicated
