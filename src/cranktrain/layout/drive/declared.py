"""The drive that machines declare: gearing and what turns with its shafts, of all designs."""

from typing import ClassVar

import numpy as np

from cranktrain.language import N_, _
from cranktrain.layout.design import Designs
from cranktrain.layout.drive.table import DriveSpec
from cranktrain.motion import Array
from cranktrain.motors import DeclaredMotor
from cranktrain.record import record
from cranktrain.transient.gearing import Gearing


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


def shaft_names(n_stages: int) -> tuple[str, ...]:
    """Names of the shafts of a drive; a motor on the crank has its shaft in common with it."""
    return (_("motor"), *(_("shaft {n}").format(n=n) for n in range(1, n_stages)), _("crank"))[0 if n_stages else 1 :]


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
