"""Clutch, brake and stroke that machines declare, of all designs."""

from collections.abc import Callable, Iterator
from typing import ClassVar

import numpy as np

from cranktrain.language import N_
from cranktrain.layout.drive.grip_tables import BrakeSpec, ClutchSpec, GripSpec, StrokeSpec
from cranktrain.layout.drive.shafts import shaft_number
from cranktrain.motion import Array
from cranktrain.quantities import Given
from cranktrain.record import record
from cranktrain.transient.clutched.courses import Grip
from cranktrain.transient.gearing import Gearing

MINUTE = 60.0


@record
class DeclaredGrip:
    """A clutch or a brake.

    Attributes
    ----------
    numbers : Array, shape (design, 6)
        As the fields of `Grip`. [N·m, s]
    mean_power : Array, shape (design,)
        Heat that it may take up in the mean; infinite where nothing is said. [W]
    """

    numbers: Array
    mean_power: Array

    def of(self, design: int) -> Grip:
        """Give that of one design."""
        return Grip(*self.numbers[design].tolist())


@record
class DeclaredClutch(DeclaredGrip):
    """A clutch: with how many stages before it, and the inertia of its driven side alone, (design,) [kg·m²]."""

    needs: ClassVar[str] = N_("[drive.clutch]")

    n_before: int
    driven_inertia: Array


@record
class DeclaredBrake(DeclaredGrip):
    """A brake, and on whose shaft it sits: "motor", "clutch" or "crank"."""

    needs: ClassVar[str] = N_("[drive.brake]")

    on: str


@record
class DeclaredStroke:
    """A single stroke; angles as shown, NaN where nothing is said.

    Attributes
    ----------
    start_angle, command_angle : Array, shape (design,)
        [rad]
    period : Array, shape (design,)
        From stroke to stroke as required. [s]
    """

    needs: ClassVar[str] = N_("[drive.stroke]")

    start_angle: Array
    command_angle: Array
    period: Array


Columns = Callable[..., Array]
"""Numbers of fields → (design, field)."""


def declared_grips(
    clutch: ClutchSpec | None, brake: BrakeSpec | None, stroke: StrokeSpec | None, each: Columns
) -> Iterator[object]:
    """Give the parts that these tables declare."""
    if clutch is not None:
        n_before = shaft_number(clutch.on)
        driven = each(clutch.driven_inertia.array)[:, 0]
        yield DeclaredClutch(_grip(clutch, each), _or(clutch.mean_power, np.inf, each), n_before, driven)
    if brake is not None:
        yield DeclaredBrake(_grip(brake, each), _or(brake.mean_power, np.inf, each), brake.on)
    if stroke is not None:
        required = _or(stroke.strokes_per_minute, np.nan, each)
        command = _or(stroke.command_angle, np.nan, each)
        yield DeclaredStroke(_or(stroke.start_angle, np.nan, each), command, MINUTE / required)


def _grip(table: GripSpec, each: Columns) -> Array:
    """Numbers of a clutch or brake, shape (design, 6)."""
    static = table.torque if table.static_torque is None else table.static_torque
    numbers = (table.torque, static, table.delay, table.rise_time, table.release_delay, table.fall_time)
    return each(*(one.array for one in numbers))


def _or(given: Given | None, otherwise: float, each: Columns) -> Array:
    """What is given, or something else, shape (design,)."""
    return each(np.full(1, otherwise) if given is None else given.array)[:, 0]


def before_clutch(gearing: Gearing, clutch: DeclaredClutch, design: int) -> Gearing:
    """Stages before the clutch, with what turns with its driving side alone."""
    n, driven = clutch.n_before, float(clutch.driven_inertia[design])
    inertia = gearing.inertia[:n].copy()
    if n:
        inertia[n - 1] -= driven
    motor_inertia = gearing.motor_inertia - (0.0 if n else driven)
    return Gearing(
        motor_inertia, gearing.ratio[:n], gearing.forward[:n], gearing.backward[:n], gearing.drag[:n], inertia
    )
