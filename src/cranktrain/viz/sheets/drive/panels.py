"""Curves of a drive over the crank angle: torque and inertia at the motor, how it runs."""

from collections.abc import Iterator

import numpy as np

from cranktrain.language import _
from cranktrain.viz.panel import Curve, OneDesign, Panel, closed


def drive_panels(shown: OneDesign) -> Iterator[Panel]:
    """Collect the curves: static torque by where losses go, and inertia."""
    angle = shown.cycle
    right, _same_back, dividing = (closed(values) for values in shown("static_motor_torque"))
    curves = [Curve(right, "whole", "T", "M_{st}")]
    if not np.allclose(right, dividing):
        curves.append(Curve(dividing, "formula", "F", r"M_{st}^{1/\eta}"))
    yield Panel(_("Static torque at the motor's shaft"), "N*m", angle, tuple(curves))
    own = np.full(angle.size, float(shown("gear_flywheel_moment")[0]) / 4)
    inertia = closed(shown("driven_inertia")[0])
    yield Panel(
        _("Inertia J at the motor's shaft, GD² = 4 J"),
        "kg*m^2",
        angle,
        (Curve(inertia, "whole", "s", "J"), Curve(own, "mean", "F", "J_0")),
    )


def steady_panels(shown: OneDesign) -> Iterator[Panel]:
    """Torque and speed of the motor in steady running, if there is such a motor."""
    if not runs(shown):
        return
    torque = closed(shown("motor_torque"))
    effective = np.full(torque.shape, float(shown("rms_motor_torque")))
    yield Panel(
        _("Torque of the motor in steady running"),
        "N*m",
        shown.cycle,
        (Curve(torque, "whole", "T", "M_m"), Curve(effective, "mean", "F", "M_{eff}")),
    )
    speed = Curve(closed(shown("motor_speed")), "first", "v", "n_m")
    yield Panel(_("Speed of the motor"), "rpm", shown.cycle, (speed,), "n_m")


def runs(shown: OneDesign) -> bool:
    """Whether there is a motor with which the machine runs."""
    return shown.has("motor_torque") and bool(np.all(np.isfinite(shown("motor_torque"))))
