"""Klein's construction for the slider-crank, and the instant centre of its rod, as points of the plan."""

from collections.abc import Mapping

import numpy as np

from cranktrain.errors import InputError, Problem
from cranktrain.language import _
from cranktrain.machine import Machine
from cranktrain.motion import Array
from cranktrain.plans.placement import frame, placed, slider_crank_called
from cranktrain.plans.positions import closed_angles
from cranktrain.plans.vectors import turned_left
from cranktrain.record import record


@record
class Klein:
    """Klein's construction at one crank angle: points (X, Y) by their letters, from the shaft centre O. [m]

    A crank pin, B piston pin; C where the rod's line meets the perpendicular to the line of stroke through O; K, L
    where the circle about A through C meets the circle on AB as diameter; D where the chord KL meets the rod; N where
    it meets the parallel to the line of stroke through O; centre: the rod's instant centre; stroke: direction of the
    line of stroke. NaN where lines are parallel, or circles do not meet.

    Turned by 90° in the sense of running, OAC is the polygon of velocities: v_A = ω OA, v_BA = ω AC, v_B = ω OC. Turned
    by 180°, OADN is that of accelerations: a_A = ω² OA, normal part of a_BA = ω² AD, tangential part = ω² DN,
    a_B = ω² ON.
    """

    mechanism: str
    angle: float
    points: Mapping[str, Array]
    centre: Array
    stroke: Array


def klein(machine: Machine, angle: float, *, mechanism: str | None = None) -> Klein:
    """Klein's construction.

    Parameters
    ----------
    machine : Machine
    angle : float
        Crank angle as the machine shows it. [deg]
    mechanism : str, optional
        A slider-crank's name; the first one unless given.

    Returns
    -------
    Klein

    Raises
    ------
    InputError
        If the mechanism is no slider-crank, or the file has its crank turn unevenly.

    Notes
    -----
    C lies where the rod's line crosses x = 0 of the cylinder's axes. By similar triangles AD = AC²/AB, which is where
    the chord crosses the rod. Exact for an offset line of stroke too.
    """
    place = slider_crank_called(machine, mechanism)
    if machine.main_shaft.turns_unevenly:
        allowed = _("must turn evenly for Klein's construction; ask for accelerations")
        raise InputError([Problem("shaft.main", None, allowed)])
    closed_angles(machine, [place], [angle])
    axes = frame(machine, place)
    pins = placed(machine, place, np.array([np.deg2rad(angle) + machine.zero])).positions
    stroke = np.array([np.sin(axes.direction), np.cos(axes.direction)])
    across = turned_left(stroke)
    pin, piston = (pins[name][:, 0] for name in "AB")
    rod = piston - pin
    length = float(np.hypot(*rod))
    crossing = pin - np.dot(pin, stroke) / np.dot(rod, stroke) * rod
    foot = float(np.sum((crossing - pin) ** 2)) / length
    chord = turned_left(rod) / length
    half = np.sqrt(foot * (length - foot)) if foot <= length else np.nan
    middle = pin + foot / length * rod
    reach = -np.dot(middle, across) / np.dot(chord, across)
    radius = np.dot(pin, stroke)
    centre = pin * (np.dot(piston, stroke) / radius) if abs(radius) > 1e-12 * length else np.full(2, np.nan)
    points = {
        "A": pin,
        "B": piston,
        "C": crossing,
        "D": middle,
        "K": middle + half * chord,
        "L": middle - half * chord,
        "N": middle + reach * chord,
        "O": np.zeros(2),
    }
    return Klein(place.name, angle, points, centre, stroke)
