"""A machine with a clutch and a brake, ready for single strokes: its numbers, and what is asked of a stroke."""

import math
from functools import cached_property

import numpy as np

from cranktrain.language import Words, _
from cranktrain.layout.drive.declared import DeclaredBrake, DeclaredClutch, DeclaredStroke, before_clutch
from cranktrain.motion import Array
from cranktrain.motors import DeclaredMotor
from cranktrain.numerics.harmonics import TURN
from cranktrain.numerics.roots import bracketed_roots
from cranktrain.questions.reduction.at_angles import has_inertia
from cranktrain.questions.reduction.machines import ReducedMachines
from cranktrain.questions.start.case import Switching, start_kernels
from cranktrain.questions.start.curves import numbers_from
from cranktrain.record import record
from cranktrain.transient.clutched.equation import Press, firm_acceleration, press_of
from cranktrain.transient.clutched.runs import PressPlan
from cranktrain.transient.equation import Kernels
from cranktrain.transient.gearing import Gearing, turning_inertia

_SAME = 1e-9
"""So near to each other two corners of loads are one. [rad]"""
_HALF = 0.5
_LONG_SINCE = 1e9
"""That the motor was switched on, so that no starter matters any more; finite, as times are added to it. [s]"""


@record
class PressCase:
    """One design.

    Attributes
    ----------
    motor : DeclaredMotor
    press : Press
    plan : PressPlan
        With the command angle, infinite where it is asked for.
    idle_speed : float
        Of the flywheel without strokes. [rad/s]
    start_angle : float
        φ at which the crank rests. [rad]
    zero : float
        φ where the shown crank angle is 0. [rad]
    period : float
        NaN where no pace is asked for. [s]
    """

    motor: DeclaredMotor
    press: Press
    plan: PressPlan
    idle_speed: float
    start_angle: float
    zero: float
    period: float

    @cached_property
    def kernels(self) -> Kernels:
        """Kernels of its strokes."""
        return start_kernels(self.motor)

    def __getstate__(self) -> dict[str, object]:
        """Send its numbers; kernels are made again."""
        return {name: held for name, held in vars(self).items() if name != "kernels"}


@record
class PressParts:
    """What strokes are made of, of all designs."""

    gearings: tuple[Gearing, ...]
    motor: DeclaredMotor
    machines: ReducedMachines
    clutch: DeclaredClutch
    brake: DeclaredBrake
    stroke: DeclaredStroke
    zero: Array
    tolerance: float


def hindrance(parts: PressParts, design: int) -> Words:
    """Why a machine makes no single strokes, a sentence; empty where it does."""
    if not math.isclose(parts.machines.cycle, TURN):
        return _("No strokes: the machine's cycle takes two turns, and a stroke is one.")
    if len(parts.machines.each[design].chambers):
        return _("No strokes: what a compressor's gas remembers is not followed through a clutch.")
    before = before_clutch(parts.gearings[design], parts.clutch, design)
    if before.motor_inertia <= 0 and not np.any(before.inertia > 0):
        return _("No strokes: nothing turns before the clutch; [drive.part.NAME] declares a flywheel.")
    if not has_inertia(parts.machines.each[design], turning_inertia(_behind_clutch(parts, design))):
        return _(
            "No strokes: nothing behind the clutch has inertia; [masses], or driven_inertia of [drive.clutch],"
            " declares some."
        )
    return ""


def _behind_clutch(parts: PressParts, design: int) -> Gearing:
    """Gearing from the clutch's driven half to the crank."""
    gearing, n_before = parts.gearings[design], parts.clutch.n_before
    return Gearing(float(parts.clutch.driven_inertia[design]), *(part[n_before:] for part in gearing[1:]))


def press_case(parts: PressParts, design: int) -> PressCase | None:
    """Put a design together; None where its motor has no speed without load."""
    kernels, own = start_kernels(parts.motor), parts.stroke
    zero = float(parts.zero[min(design, len(parts.zero) - 1)])
    start_angle, command = float(own.start_angle[design]) + zero, float(own.command_angle[design]) + zero
    press = press_of(
        numbers_from(parts.machines.each[design], start_angle),
        Switching(parts.motor.row(design), math.inf, math.inf, _LONG_SINCE),
        before_clutch(parts.gearings[design], parts.clutch, design),
        _behind_clutch(parts, design),
        parts.clutch.of(design),
        parts.brake.of(design),
        brake_on_crank=parts.brake.on == "crank",
    )
    plan = PressPlan(
        end_time=math.inf,
        command_angle=command if math.isfinite(command) else math.inf,
        jumps=_jumps(parts.machines.corners[design]),
        tolerance=parts.tolerance,
    )
    idle = _idle_speed(kernels, press, float(parts.motor.top_speed[design]))
    if math.isnan(idle):
        return None
    return PressCase(parts.motor, press, plan, idle, start_angle, zero, float(own.period[design]))


def _jumps(corners: Array) -> tuple[float, ...]:
    """Where loads have jumps or corners within a turn, each once. [rad]"""
    found = np.sort(np.mod(corners[np.isfinite(corners)], TURN))
    found = np.where(TURN - found < _SAME, 0.0, found)
    found = np.unique(found)
    return tuple(found[np.diff(found, prepend=-1.0) > _SAME].tolist())


def _idle_speed(kernels: Kernels, press: Press, top_speed: float) -> float:
    """Speed of the flywheel at which the motor gives no more than the stages before the clutch take. [rad/s]"""
    if not math.isfinite(top_speed):
        return math.nan

    def grown(speed: float) -> float:
        torque = kernels.motor(speed * press.motor_ratio, 0.0, press.motor)
        return firm_acceleration(torque, 1.0, 0.0, 0.0, press.before)[0]

    high = top_speed / press.motor_ratio
    if grown(high) == 0:
        return high
    each = np.vectorize(grown, otypes=[float])
    return float(bracketed_roots(each, np.array([_HALF * high]), np.array([high]))[0])
