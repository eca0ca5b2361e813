"""The drive that machines declare: gearing and what turns with its shafts; clutch, brake and stroke; of all designs."""

from collections.abc import Callable, Iterator
from typing import ClassVar

import numpy as np

from cranktrain.language import N_
from cranktrain.layout.design import Designs
from cranktrain.layout.drive.grip_tables import BrakeSpec, ClutchSpec, GripSpec, StrokeSpec
from cranktrain.layout.drive.shafts import shaft_number
from cranktrain.layout.drive.table import DriveSpec
from cranktrain.motion import Array
from cranktrain.motors import DeclaredMotor
from cranktrain.quantities import Given
from cranktrain.record import record
from cranktrain.transient.clutched.courses import Grip
from cranktrain.transient.gearing import Gearing

MINUTE = 60.0
SHAFT_TITLES = {"motor": N_("motor"), "shaft_{n}": N_("shaft {n}"), "crank": N_("crank")}
"""What people call the shafts of a drive."""


@record
class DeclaredDrive:
    """What drives the crank.

    Attributes
    ----------
    motor_inertia : Array, shape (design,)
        Of all that turns with the motor. [kg·m²]
    ratio, forward, backward, drag, inertia : Array, shape (design, stage)
        As in `Gearing`.
    shafts : tuple of str
        Their keys, the motor's first, the crank's last.
    """

    needs: ClassVar[str] = N_("[drive]")

    motor_inertia: Array
    ratio: Array
    forward: Array
    backward: Array
    drag: Array
    inertia: Array
    shafts: tuple[str, ...]

    @property
    def gearings(self) -> tuple[Gearing, ...]:
        """Of each design."""
        stages = (self.ratio, self.forward, self.backward, self.drag, self.inertia)
        each = zip(self.motor_inertia.tolist(), *stages, strict=True)
        return tuple(Gearing(own, *(np.ascontiguousarray(part) for part in parts)) for own, *parts in each)


def shaft_names(n_stages: int) -> tuple[str, ...]:
    """Keys of the shafts of a drive, of `SHAFT_TITLES`; a motor on the crank has its shaft in common with it."""
    return ("motor", *(f"shaft_{n}" for n in range(1, n_stages)), "crank")[0 if n_stages else 1 :]


def declared_drive(spec: DriveSpec, motor: DeclaredMotor | None, designs: Designs) -> DeclaredDrive:
    """Stages of all designs, with what turns with their shafts."""

    def each(*numbers: Array) -> Array:
        return designs.by_design(list(numbers)) if numbers else np.empty((designs.n_designs, 0))

    def turning(on: str | int) -> Array:
        parts = [part.moment for part in spec.part.values() if part.on == on]
        if spec.clutch is not None and spec.clutch.on == on:
            parts.append(spec.clutch.driven_inertia.array)  # locked, both its sides turn with its shaft
        return np.sum(each(*parts), axis=1)

    rotor = np.zeros(designs.n_designs) if motor is None or motor.inertia is None else motor.inertia
    n_stages = len(spec.stage)
    behind = [turning(n) for n in range(1, n_stages + 1)]
    return DeclaredDrive(
        turning("motor") + rotor,
        each(*(stage.ratio.array for stage in spec.stage)),
        each(*(stage.efficiencies[0] for stage in spec.stage)),
        each(*(stage.efficiencies[1] for stage in spec.stage)),
        each(*(stage.drag.array for stage in spec.stage)),
        np.stack(behind, axis=-1) if behind else np.empty((designs.n_designs, 0)),
        shaft_names(n_stages),
    )


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
