"""Curves of a drive over the crank angle: torque, inertia, how it runs, what a wanted motion asks; facts of that."""

from collections.abc import Iterator

import numpy as np

from cranktrain.analysis import Result
from cranktrain.language import Message, _
from cranktrain.motion import Array
from cranktrain.numerics.ties import first_largest
from cranktrain.panels.design import OneDesign, closed
from cranktrain.panels.shapes import Curve, Mark, Panel
from cranktrain.questions.servo.demand import ServoDemand
from cranktrain.questions.servo.rocking import RockingDrive
from cranktrain.questions.servo.stages import ServoDrive
from cranktrain.saying.amounts import Amount

_SEEN = 0.01
"""Of the largest static torque: a curve that is nearer to it is not seen beside it."""


def drive_panels(shown: OneDesign) -> Iterator[Panel]:
    """Collect the curves: static torque by where losses go, with its half-periods, and inertia."""
    angle = shown.cycle
    right, _same_back, dividing = (closed(values) for values in shown("static_motor_torque"))
    curves = [Curve(right, "whole", "T", "M_{st}")]
    if not np.allclose(right, dividing):
        curves.append(Curve(dividing, "formula", "F", r"M_{st}^{1/\eta}"))
    title = _("Static torque at the motor's shaft")
    if shown.has("constant_speed_torque"):
        turned = closed(shown("constant_speed_torque")[0])
        if not np.allclose(right, turned, rtol=0.0, atol=_SEEN * np.max(np.abs(right))):
            title = _("Static and constant-speed torque")
            curves.append(Curve(turned, "second", "T", r"M_\omega"))
    start, length = shown("half_period_start"), shown("half_period_length")
    start, length = start[np.isfinite(start)], length[np.isfinite(length)]
    changes = list(zip(start.tolist(), length.tolist(), strict=True)) if len(start) > 1 else []
    yield Panel(
        title,
        "N*m",
        angle,
        tuple(curves),
        marks=tuple(Mark(at, 0.0, "change", Amount(abs(at), "deg")) for at, _length in changes),
        below=tuple(
            (_middle(at, wide, float(angle[-1])), _("Δφ = {angle}", angle=Amount(wide, "deg"))) for at, wide in changes
        ),
    )
    own = np.full(angle.size, float(shown("gear_flywheel_moment")[0]) / 4)
    inertia = closed(shown("driven_inertia")[0])
    yield Panel(
        _("Inertia J at the motor's shaft, GD² = 4 J"),
        "kg*m^2",
        angle,
        (Curve(inertia, "whole", "s", "J"), Curve(own, "mean", "F", "J_0")),
    )


def _middle(start: float, length: float, end: float) -> float:
    """Middle of the larger part of a half-period on the sheet, where it may be cut in two. [deg]"""
    first, rest = min(length, end - start), max(0.0, start + length - end)
    return start + first / 2 if first >= rest else rest / 2


def steady_panels(shown: OneDesign) -> Iterator[Panel]:
    """Torque and speed of the motor in steady running, if there is such a motor."""
    if runs(shown):
        torque, speed = (closed(shown(f"motor_{name}")) for name in ("torque", "speed"))
        title = _("Torque of the motor in steady running")
        yield from _motor_panels(shown, title, Curve(torque, "whole", "T", "M_m"), shown("rms_motor_torque"), speed)


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
    if shown.has("servo_torque"):
        fastest = first_largest(np.abs(demand.crank.speed))
        ratio = demand.motor_speed[fastest] / demand.crank.speed[fastest]
        torque, speed = closed(shown("servo_torque")), closed(ratio * shown("wanted_crank_speed"))
        title = _("Torque of the motor for the wanted motion")
        yield from _motor_panels(shown, title, Curve(torque, "whole", "T", "M_s"), demand.rms, speed)


def _motor_panels(
    shown: OneDesign, title: Message, torque: Curve, effective: Array | float, speed: Array
) -> Iterator[Panel]:
    """Torque of a motor with its effective one, and its speed."""
    mean = Curve(np.full(torque.values.shape, float(effective)), "mean", "F", "M_{eff}")
    yield Panel(title, "N*m", shown.cycle, (torque, mean))
    yield Panel(_("Speed of the motor"), "rpm", shown.cycle, (Curve(speed, "first", "v", "n_m"),), "n_m")


def way_of(demand: ServoDemand) -> tuple[Array, Array]:
    """Speeds and torques of the motor in the order of time, a period round. [rad/s, N·m]"""
    return closed(demand.along(demand.motor_speed)), closed(demand.along(demand.motor_torque))


def demand_facts(demand: ServoDemand) -> Iterator[tuple[Message, Amount]]:
    """What the motor must do."""
    yield _("effective torque of the motor"), Amount(demand.rms, "N*m")
    yield _("largest torque of the motor"), Amount(demand.peak_torque, "N*m")
    yield _("largest speed of the motor"), Amount(demand.top_speed, "rpm")
    yield _("largest power of the motor"), Amount(demand.peak_power, "W")
    yield _("mean power of the motor"), Amount(demand.mean(demand.power), "W")
    yield _("energy taken back in a period"), Amount(demand.returned, "J")
