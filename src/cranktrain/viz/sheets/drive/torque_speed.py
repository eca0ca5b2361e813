"""A motor's torque over its speed, on paper, with the way that a machine takes through that."""

from typing import Any

import numpy as np

from cranktrain.language import said as _
from cranktrain.motion import Array
from cranktrain.motors import DeclaredMotor
from cranktrain.saying.scales import scale_for
from cranktrain.viz.paper.page import Box, Page
from cranktrain.viz.paper.panels import axes_in
from cranktrain.viz.paper.style import COLOURS, INK, MUTED

_OF_MOTOR: dict[str, Any] = {"color": INK, "linewidth": 0.9, "linestyle": (0, (6.0, 2.0))}
_OF_WAY: dict[str, Any] = {"color": COLOURS["T"], "linewidth": 1.7}
_BEYOND = 1.1
"""Of the motor's top speed; so far its curve is drawn."""


def draw_torque_speed(
    page: Page, motor: DeclaredMotor | None, design: int, way: tuple[Array, Array], room: Box, said: str
) -> float:
    """Draw the speeds and torques that a machine goes through, with its motor's curve; give where it ends. [mm]

    Parameters
    ----------
    page : Page
    motor : DeclaredMotor or None
        None where it is not known.
    design : int
    way : tuple of Array
        Speed and torque at its shaft. [rad/s, N·m]
    room : Box
    said : str
        What the way is, for the legend.
    """
    speeds, torques = (way[0], []) if motor is None else _curves(motor, design, way[0])
    most = float(np.nanmax(np.abs([np.max(np.abs(way[1])), *(np.nanmax(np.abs(one)) for one in torques)])))
    scale, turning = scale_for("N*m", most), scale_for("rpm", float(np.max(np.abs(speeds))))
    page.heading(
        room.left,
        room.bottom + room.height - 5.0,
        _("Torque of the motor over its speed, {unit} over {speed}", unit=scale.label, speed=turning.label),
    )
    axes = axes_in(page, Box(room.left + 13.0, room.bottom + 15.0, room.width - 15.0, room.height - 24.0))
    axes.axhline(0.0, color=MUTED, linewidth=0.6, zorder=1)
    for one in torques:
        axes.plot(turning.of(speeds), scale.of(one), **_OF_MOTOR)
    axes.plot(turning.of(way[0]), scale.of(way[1]), **_OF_WAY)
    samples = [] if motor is None else [(_("motor"), _OF_MOTOR)]
    x, y = room.left, room.bottom + 4.0
    for words, line in (*samples, (said, _OF_WAY)):
        page.sample(x, x + 8.0, y + 0.9, **line)
        _begin, x = page.ends(page.text(x + 9.5, y, words))
        x += 5.0
    if motor is not None and np.isfinite(torque := float(motor.rating.torque[design])):
        point = (float(turning.of(_rated_speed(motor, design))), float(scale.of(torque)))
        axes.plot(*point, "o", ms=4.0, mfc="white", mec=INK, mew=1.0, zorder=5)
        page.text(x, y, _("○ rated torque, with its resistance") if _has_resistance(motor, design) else _("○ rated"))
    return room.bottom


def _curves(motor: DeclaredMotor, design: int, way: Array) -> tuple[Array, list[Array]]:
    """Speeds a little beyond those that are reached, and the motor's torques there; of a servo its limits both ways."""
    top = float(motor.top_speed[design])
    end = _BEYOND * max(top if np.isfinite(top) else 0.0, float(np.max(way)))
    speeds = np.linspace(_BEYOND * min(0.0, float(np.min(way))), end, 801)
    if motor.law.is_commanded:
        limit = motor.ceiling(speeds, design)
        return speeds, [limit, -limit]
    return speeds, [motor.torque(np.broadcast_to(speeds, (motor.n_designs, speeds.size)))[design]]


def _has_resistance(motor: DeclaredMotor, design: int) -> bool:
    """Whether a resistance behind slip rings lets it slip by more than its plate says."""
    return bool(motor.slip_ratio[design] != 1)


def _rated_speed(motor: DeclaredMotor, design: int) -> float:
    """Speed at the rated torque, on the curve that is drawn. [rad/s]"""
    if _has_resistance(motor, design):
        return float(motor.top_speed[design]) * (1 - motor.rated_slip(design))
    return float(motor.rating.speed[design])
