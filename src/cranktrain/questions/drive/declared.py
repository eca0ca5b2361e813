"""The drive that machines declare: motor, gearing and what turns with it, of all designs."""

from collections.abc import Iterator
from typing import ClassVar

import numpy as np

from cranktrain.language import N_, _
from cranktrain.layout.design import Design, Designs
from cranktrain.motion import Array
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
    gearings : tuple of Gearing
        Of each design.
    shafts : tuple of str
        Their names, the motor's first, the crank's last.
    """

    needs: ClassVar[str] = N_("[drive]")

    gearings: tuple[Gearing, ...]
    shafts: tuple[str, ...]


@record
class DeclaredStart:
    """How a run begins and ends, as the table of the first design says."""

    spec: StartSpec


def drive_parts(designs: Designs) -> Iterator[object]:
    """Give the parts that [drive] declares."""
    spec = designs.together.table(DriveSpec)
    if spec is None:
        return
    motor = None if spec.motor is None else declared_motor(spec.motor, designs)
    yield DeclaredDrive(tuple(_gearings(spec, motor, designs)), shaft_names(len(spec.stage)))
    yield DeclaredStart(spec.start)
    if motor is not None:
        yield motor
        yield DrivenByMotor()


def shaft_names(n_stages: int) -> tuple[str, ...]:
    """Names of the shafts of a drive; a motor on the crank has its shaft in common with it."""
    return (_("motor"), *(_("shaft {n}").format(n=n) for n in range(1, n_stages)), _("crank"))[0 if n_stages else 1 :]


def drive_of(design: Design) -> DriveSpec | None:
    """The table of one design."""
    return design.table(DriveSpec)


def _gearings(spec: DriveSpec, motor: DeclaredMotor | None, designs: Designs) -> Iterator[Gearing]:
    """Gearing of each design, with what turns with its shafts."""

    def each(*numbers: Array) -> Array:
        return designs.by_design(list(numbers)) if numbers else np.empty((designs.n_designs, 0))

    def turning(on: str | int) -> Array:
        parts = [part.moment for part in spec.part.values() if part.on == on]
        return np.sum(each(*parts), axis=1)

    rotor = np.zeros(designs.n_designs) if motor is None or motor.inertia is None else motor.inertia
    at_motor = turning("motor") + rotor
    behind = np.stack([turning(n) for n in range(1, len(spec.stage) + 1)], axis=-1) if spec.stage else None
    ratio = each(*(stage.ratio.array for stage in spec.stage))
    forward, backward = (each(*(stage.efficiencies[way] for stage in spec.stage)) for way in range(2))
    drag = each(*(stage.drag.array for stage in spec.stage))
    inertia = np.zeros_like(ratio) if behind is None else behind
    for own in zip(at_motor.tolist(), ratio, forward, backward, drag, inertia, strict=True):
        yield Gearing(own[0], *(np.ascontiguousarray(part) for part in own[1:]))
