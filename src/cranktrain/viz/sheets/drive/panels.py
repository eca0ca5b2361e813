"""Curves of a drive over the crank angle: torque, inertia, how it runs, what a wanted motion asks; facts of that."""

from collections.abc import Iterator

import numpy as np

from cranktrain.analysis import Result
from cranktrain.language import said as _
from cranktrain.motion import Array
from cranktrain.numerics.ties import first_largest
from cranktrain.questions.servo.demand import ServoDemand
from cranktrain.questions.servo.rocking import RockingDrive
from cranktrain.questions.servo.stages import ServoDrive
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


def demand_of(result: Result, design: int) -> ServoDemand | None:
    """What a wanted motion asks of the motor, of a crank that turns or rocks; None without one."""
    turning, rocking = result.get(ServoDrive), result.get(RockingDrive)
    found = turning or rocking
    return None if found is None else found.demands[design]


def demand_panels(shown: OneDesign, demand: ServoDemand) -> Iterator[Panel]:
    """Torque and speed of the motor over the crank angle, of a crank that turns."""
    if not shown.has("servo_torque"):
        return
    torque = closed(shown("servo_torque"))
    effective = np.full(torque.shape, demand.rms)
    yield Panel(
        _("Torque of the motor for the wanted motion"),
        "N*m",
        shown.cycle,
        (Curve(torque, "whole", "T", "M_s"), Curve(effective, "mean", "F", "M_{eff}")),
    )
    fastest = first_largest(np.abs(demand.crank.speed))
    ratio = demand.motor_speed[fastest] / demand.crank.speed[fastest]
    speed = Curve(closed(ratio * shown("wanted_crank_speed")), "first", "v", "n_m")
    yield Panel(_("Speed of the motor"), "rpm", shown.cycle, (speed,), "n_m")


def way_of(demand: ServoDemand) -> tuple[Array, Array]:
    """Speeds and torques of the motor in the order of time, a period round. [rad/s, N·m]"""
    return closed(demand.along(demand.motor_speed)), closed(demand.along(demand.motor_torque))


def demand_facts(demand: ServoDemand) -> Iterator[tuple[str, float, str]]:
    """What the motor must do: words, value in SI and its unit."""
    yield _("effective torque of the motor"), demand.rms, "N*m"
    yield _("largest torque of the motor"), demand.peak_torque, "N*m"
    yield _("largest speed of the motor"), demand.top_speed, "rpm"
    yield _("largest power of the motor"), demand.peak_power, "W"
    yield _("mean power of the motor"), demand.mean(demand.power), "W"
    yield _("energy taken back in a period"), demand.returned, "J"
