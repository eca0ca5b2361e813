"""The drive that machines declare: motor, gearing and what turns with it, of all designs."""

from collections.abc import Iterator
from typing import ClassVar

import numpy as np

from cranktrain.language import N_, _
from cranktrain.layout.design import Design, Designs
from cranktrain.motion import Array
from cranktrain.questions.drive.clutched.declared import declared_grips
from cranktrain.questions.drive.declared_duty import declared_duty, wanted_flywheel
from cranktrain.questions.drive.motor_tables import DeclaredMotor, declared_motor
from cranktrain.questions.drive.running.gearing import Gearing
from cranktrain.questions.drive.spec import DriveSpec, StartSpec
from cranktrain.questions.evenness.spec import DrivenByMotor
from cranktrain.record import record


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
        Their names, the motor's first, the crank's last.
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


@record
class DeclaredStart:
    """How a run begins and ends, as the table of the first design says."""

    reads: ClassVar[tuple[str, ...]] = ("[drive.start]",)

    spec: StartSpec


def drive_parts(designs: Designs) -> Iterator[object]:
    """Give the parts that [drive] declares."""
    spec = designs.together.table(DriveSpec)
    if spec is None:
        return
    motor = None if spec.motor is None else declared_motor(spec.motor, designs)
    yield _declared_drive(spec, motor, designs)
    yield DeclaredStart(spec.start)
    yield declared_duty(spec.duty, designs, holds_valves_open=spec.start.unloaded_until is not None)
    yield from declared_grips(spec.clutch, spec.brake, spec.stroke, lambda *numbers: designs.by_design(list(numbers)))
    if spec.flywheel is not None:
        yield wanted_flywheel(spec.flywheel, designs)
    if motor is not None:
        yield motor
        yield DrivenByMotor()


def shaft_names(n_stages: int) -> tuple[str, ...]:
    """Names of the shafts of a drive; a motor on the crank has its shaft in common with it."""
    return (_("motor"), *(_("shaft {n}").format(n=n) for n in range(1, n_stages)), _("crank"))[0 if n_stages else 1 :]


def drive_of(design: Design) -> DriveSpec | None:
    """The table of one design."""
    return design.table(DriveSpec)


def _declared_drive(spec: DriveSpec, motor: DeclaredMotor | None, designs: Designs) -> DeclaredDrive:
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
