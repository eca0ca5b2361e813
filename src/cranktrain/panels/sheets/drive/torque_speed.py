"""A motor's torque over its speed, with the way that a machine takes through that."""

from collections.abc import Iterator

import numpy as np

from cranktrain.language import Words, _
from cranktrain.motion import Array
from cranktrain.motors import DeclaredMotor
from cranktrain.panels.shapes import Curve, Mark, Panel, peak
from cranktrain.saying.amounts import UnitLabel

_BEYOND = 1.1
"""Of the motor's top speed; so far its curve is drawn."""


def torque_speed_panel(motor: DeclaredMotor | None, design: int, way: tuple[Array, Array], said: Words) -> Panel:
    """Collect the speeds and torques that a machine goes through, with its motor's curve.

    Parameters
    ----------
    motor : DeclaredMotor or None
        None where it is not known.
    design : int
    way : tuple of Array
        Speed and torque at its shaft. [rad/s, N·m]
    said : Words
        What the way is, for the legend.
    """
    curves = [] if motor is None else list(_motor_curves(motor, design, way[0]))
    curves.append(Curve(way[1], "whole", "T", name=said))
    most = max(peak(curve.values) for curve in curves)
    fastest = max(peak(way[0] if curve.across is None else curve.across) for curve in curves)
    title = _(
        "Torque of the motor over its speed, {unit} over {speed}",
        unit=UnitLabel("N*m", most),
        speed=UnitLabel("rpm", fastest),
    )
    marks = () if motor is None else tuple(_rated(motor, design))
    return Panel(title, "N*m", way[0], tuple(curves), across_unit="rpm", marks=marks)


def _motor_curves(motor: DeclaredMotor, design: int, way: Array) -> Iterator[Curve]:
    """The motor's torques a little beyond the speeds that are reached; of a servo its limits both ways."""
    top = float(motor.top_speed[design])
    end = _BEYOND * max(top if np.isfinite(top) else 0.0, float(np.max(way)))
    speeds = np.linspace(_BEYOND * min(0.0, float(np.min(way))), end, 801)
    if motor.law.is_commanded:
        limit = motor.ceiling(speeds, design)
        yield Curve(limit, "radial", "F", name=_("motor"), across=speeds)
        yield Curve(-limit, "radial", "F", across=speeds)
        return
    torque = motor.torque(np.broadcast_to(speeds, (motor.n_designs, speeds.size)))[design]
    yield Curve(torque, "radial", "F", name=_("motor"), across=speeds)


def _rated(motor: DeclaredMotor, design: int) -> Iterator[Mark]:
    """Where the motor has its rated torque on the curve that is drawn."""
    torque = float(motor.rating.torque[design])
    if np.isfinite(torque):
        # A resistance behind slip rings lets it slip by more than its plate says.
        has_resistance = bool(motor.slip_ratio[design] != 1)
        slipped = float(motor.top_speed[design]) * (1 - motor.rated_slip(design)) if has_resistance else np.nan
        speed = slipped if has_resistance else float(motor.rating.speed[design])
        words = _("○ rated torque, with its resistance") if has_resistance else _("○ rated")
        yield Mark(speed, torque, "ring", words)
