"""What a wanted motion asks of its motor: curves over the crank angle, the way through torque and speed, facts."""

from collections.abc import Iterator

import numpy as np

from cranktrain.analysis import Result
from cranktrain.language import _
from cranktrain.motion import Array
from cranktrain.numerics.ties import first_largest
from cranktrain.questions.servo.demand import ServoDemand
from cranktrain.questions.servo.rocking import RockingDrive
from cranktrain.questions.servo.stages import ServoDrive
from cranktrain.viz.panel import Curve, OneDesign, Panel, closed


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
