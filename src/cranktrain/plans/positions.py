"""Plans of positions as data: pins in drawing millimetres, in machine axes, X right and Y up; the scale of any plan.

One drawing millimetre is μ_l metres; docs/pictures says how the plans are drawn.
"""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from cranktrain.errors import InputError, Problem
from cranktrain.language import _
from cranktrain.layout.places import PlacedMechanism
from cranktrain.machine import Machine
from cranktrain.mechanisms.drawing import Drawing
from cranktrain.motion import Array
from cranktrain.plans.lettering import lettered
from cranktrain.plans.placement import plain_crank_called
from cranktrain.plans.together import placed_together, places_called, together_name
from cranktrain.record import record
from cranktrain.texts.plain_cranks import own_angle, plain_crank

ROOM = (80.0, 80.0)
"""Width and height for which a scale is chosen, unless given. [mm]"""

_DIGITS = 9
"""Of a crank angle in degrees, so that 30 stays 30."""

_ROUNDING = 1e-9

DRAWING_STEPS = (1.0, 2.0, 2.5, 4.0, 5.0, 10.0)
"""Scale factors of a drawing within a power of ten."""


@record
class PositionPlan:
    """A mechanism in several positions.

    Attributes
    ----------
    mechanism : str
    angles : Array, shape (n,)
        Crank angles as the machine shows them. [deg]
    scale : float
        μ_l: what one drawing millimetre is. [m]
    drawing : Drawing
        Pins from the shaft centre, shape (n,). [drawing mm]
    """

    mechanism: str
    angles: Array
    scale: float
    drawing: Drawing


def position_plan(
    machine: Machine,
    angles: int | Sequence[float] = 12,
    *,
    mechanism: str | None = None,
    room: tuple[float, float] = ROOM,
    is_lettered: bool = False,
    beside: Array | None = None,
) -> PositionPlan:
    """Plan of a mechanism in several positions.

    Parameters
    ----------
    machine : Machine
    angles : int or sequence of float
        How many, evenly over a turn from the shown angle 0, or which. [deg]
    mechanism : str, optional
        Its name, such as `1R`; unless given, the first slave of throw 1, or the first mechanism. Of a cylinder with
        opposed pistons, by its name or unnamed, both: pins of the second have its number, `A2`.
    room : (width, height)
        For which the scale factor must suffice. [mm]
    is_lettered : bool
        Call pins with long names by letters.
    beside : Array, shape (2, m), optional
        Points for which there must be room too. [m]

    Returns
    -------
    PositionPlan

    Examples
    --------
    >>> pump = Machine(mechanism={"kind": "slider_crank", "stroke": "160 mm", "rod_length": "160 mm"})
    >>> plan = position_plan(pump)
    >>> plan.scale, [round(float(part[0]), 6) for part in plan.drawing.positions["B"]]
    (0.004, [0.0, 60.0])
    """
    places = places_called(machine, mechanism)
    shown = closed_angles(machine, places, angles)
    drawing = placed_together(machine, places, np.deg2rad(shown) + machine.zero)
    points = [*drawing.positions.values(), *([] if beside is None else [beside])]
    scale = fitting([np.concatenate(points, axis=1)], room)
    named = lettered(drawing) if is_lettered else drawing
    return PositionPlan(together_name(places), shown, scale, named.scaled(1.0 / scale))


def single_plans(
    machine: Machine,
    angles: Sequence[float],
    *,
    mechanism: str | None,
    room: tuple[float, float],
    beside: Array | None = None,
) -> list[PositionPlan]:
    """Plans of a mechanism in one position each, with letters, all to one scale; parameters as of `position_plan`."""
    plans = [
        position_plan(machine, [angle], mechanism=mechanism, room=room, is_lettered=True, beside=beside)
        for angle in angles
    ]
    scale = max(plan.scale for plan in plans)
    return [rescaled(plan, scale) for plan in plans]


def track(machine: Machine, scale: float, *, mechanism: str | None = None) -> Drawing:
    """Give a mechanism over a whole turn, for its paths: NaN where it cannot close. [drawing mm]"""
    phi = np.linspace(0.0, 2 * np.pi, 361) + machine.zero
    return placed_together(machine, places_called(machine, mechanism), phi).scaled(1.0 / scale)


def closed_angles(machine: Machine, places: Sequence[PlacedMechanism], angles: int | Sequence[float]) -> Array:
    """Give the crank angles that are asked for; of a number spread over the turn, those at which the links close.

    Raises
    ------
    InputError
        If the links cannot close at an angle that is listed, or at none.
    """
    shown = plan_angles(angles)
    drawing = placed_together(machine, places, np.deg2rad(shown) + machine.zero)
    closed = np.all(np.isfinite(list(drawing.positions.values())), axis=(0, 1))
    if np.all(closed) or (isinstance(angles, int) and np.any(closed)):
        return shown[closed]
    there = ", ".join(f"φ = {angle:g}°" for angle in shown[~closed])
    raise InputError([Problem("", there, _("the links of {name} cannot close there", name=together_name(places)))])


def rescaled(plan: PositionPlan, scale: float) -> PositionPlan:
    """Give the same plan to another scale. [m for 1 mm]"""
    return replace(plan, scale=scale, drawing=plan.drawing.scaled(plan.scale / scale))


def plan_angles(angles: int | Sequence[float]) -> Array:
    """Give that many angles, spread evenly over a turn, or those that are listed. [deg]"""
    n = angles if isinstance(angles, int) else len(angles)
    if n < 1:
        allowed = _("there must be at least one")
        raise InputError([Problem("", _("{n} crank angles", n=n), allowed)])
    return (
        np.arange(n, dtype=np.float64) * (360.0 / n)
        if isinstance(angles, int)
        else np.asarray(angles, dtype=np.float64)
    )


def source_angles(
    machine: Machine, *, mechanism: str | None = None, is_shown: bool = True, permissible: float | None = None
) -> tuple[float, ...]:
    """Twelve crank angles at which [slider-crank-synthesis] draws a slider-crank.

    The crank along the line of stroke and across it, at the permissible pressure angle and half a turn after it, and
    six between: one after the pressure angle and two after the right angle, and half a turn after these.

    Parameters
    ----------
    machine : Machine
    mechanism : str, optional
        A slider-crank's or an eccentric's name; the first slider-crank unless given, or else the first eccentric.
    is_shown : bool
        Count as the machine shows crank angles; else from where the crank points along the cylinder.
    permissible : float, optional
        The pressure angle that was permitted; unless given, what the machine says is, else the largest that the
        mechanism has. [deg]

    Returns
    -------
    tuple of float
        In the order in which they come after the crank points along the cylinder. [deg]

    Examples
    --------
    The source's permissible pressure angle of 30°, and a rod twice the crank: steps of 30°.

    >>> pump = Machine(mechanism={"kind": "slider_crank", "stroke": "160 mm", "rod_length": "160 mm"})
    >>> [round(angle) for angle in source_angles(pump)]
    [0, 30, 60, 90, 120, 150, 180, 210, 240, 270, 300, 330]
    """
    place = plain_crank_called(machine, mechanism)
    geometry = plain_crank(place.geometry)
    largest = np.arcsin((geometry.crank_radius + abs(geometry.offset)) / geometry.rod_length)
    declared = place.spec.pressure_angle_limit
    pressure = np.rad2deg(largest if declared is None else declared.si) if permissible is None else permissible
    half = np.array([0.0, pressure, (pressure + 90.0) / 2, 90.0, 120.0, 150.0])
    start = np.rad2deg(-own_angle(place.phase, place.geometry) - machine.zero) if is_shown else 0.0
    turn = (np.concatenate([half, half + 180.0]) + start) % 360.0
    return tuple(round(float(angle), _DIGITS) % 360.0 for angle in turn)


def fitting(
    outlines: Sequence[Array],
    room: tuple[float, float],
    steps: Sequence[float] = DRAWING_STEPS,
    one: float = 1.0,
) -> float:
    """Choose the scale factor at which each of several outlines, shape (2, n), fits a room. [unit for 1 mm]

    It is round in a unit of which `one` is so many of the outlines'.
    """
    spans = [np.nanmax(outline, axis=1) - np.nanmin(outline, axis=1) for outline in outlines]
    return rounded_scale(float(np.max(np.stack(spans) / np.asarray(room))), steps, one)


def chosen_scale(least: float, asked: float | None) -> float:
    """Give the scale factor that is asked for, as millimetres of metal in one of paper, if that fits; else the least.

    Raises
    ------
    InputError
        If it is smaller than the least, for which there is room. [m for 1 mm]
    """
    if asked is None:
        return least
    if 1e-3 * asked < least * (1 - 1e-9):
        allowed = _("is too large for the paper: at most {scale}", scale=scale_words(1e3 * least))
        raise InputError([Problem("scale", scale_words(asked), allowed)])
    return 1e-3 * asked


def scale_words(scale: float) -> str:
    """Write a scale as drawings do: 1:2.5, or 2:1; of millimetres of metal in one of paper."""
    return f"1:{scale:g}" if scale >= 1 else f"{1 / scale:g}:1"


def rounded_scale(least: float, steps: Sequence[float] = DRAWING_STEPS, one: float = 1.0) -> float:
    """Give the next scale factor up that a draughtsman would take: a step times a power of ten, of a unit or of one.

    Examples
    --------
    >>> rounded_scale(0.0021), round(rounded_scale(0.21, one=0.3048), 4)
    (0.0025, 0.3048)
    """
    if least == 0.0:  # of nothing, which fits at any scale
        return one
    tens = float(np.log10(one))
    if abs(tens - round(tens)) > _ROUNDING:  # what is round in kN is round in N
        return one * rounded_scale(least / one, steps)
    power = 10.0 ** float(np.floor(np.log10(least)))
    step = next(step for step in steps if step * power >= least * (1 - 1e-9))
    return float(f"{step * power:.6g}")  # 0.0025, not 0.0025000000000000001
