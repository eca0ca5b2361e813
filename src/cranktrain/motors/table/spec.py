"""The table of a motor by measured points: torques at speeds."""

from collections.abc import Iterator
from typing import Annotated, Literal

import numpy as np
from pydantic import Field

from cranktrain.errors import Problem
from cranktrain.language import N_
from cranktrain.motion import Array
from cranktrain.motors.declared import DeclaredMotor
from cranktrain.motors.spec import RatedSpec, curve_problems, points
from cranktrain.motors.table.law import TABLE, TableMotor
from cranktrain.quantities import Dimension, Given, Quantity, Speed

Torque = Annotated[Given, Quantity(Dimension.TORQUE)]


class TableSpec(RatedSpec, frozen=True):
    """A motor by a table: torques at speeds that rise, on straight lines between them."""

    kind: Literal["table"] = Field(description=N_("Kind of motor."))
    speeds: tuple[Speed, ...] = Field(min_length=2, description=N_("Speeds, each above the one before."))
    torques: tuple[Torque, ...] = Field(min_length=2, description=N_("Torque at each of them."))

    def _problems(self) -> Iterator[Problem]:
        """Find a table that is no function of the speed, or lists that do not go together."""
        yield from super()._problems()
        yield from curve_problems(self.speeds, self.torques)

    def declared(self) -> DeclaredMotor:
        """Give the motor in SI."""
        curve = TableMotor(points(self.speeds), points(self.torques))
        return DeclaredMotor(TABLE, curve, self.rating, _top_speed(curve), self.rotor_inertia)


def _top_speed(curve: TableMotor) -> Array:
    """Where the torque last falls through 0; infinite where the last torque still drives."""
    speeds, torques = curve
    top = np.where(torques[-1] > 0, np.inf, np.nan)
    for low, high, first, last in zip(speeds[:-1], speeds[1:], torques[:-1], torques[1:], strict=True):
        crosses = (first > 0) & (last <= 0)
        along = first / np.where(crosses, first - last, 1.0)
        top = np.where(crosses, low + along * (high - low), top)
    return np.where(np.isnan(top), speeds[0], top)
