"""The table of a motor by measured points: torques at speeds."""

from collections.abc import Iterator
from itertools import pairwise
from typing import Annotated, Literal

import numpy as np
from pydantic import Field

from cranktrain.errors import Problem
from cranktrain.language import N_, _
from cranktrain.motion import Array
from cranktrain.quantities import Dimension, Given, Quantity, Speed
from cranktrain.questions.drive.motor_tables.declared import DeclaredMotor
from cranktrain.questions.drive.motor_tables.spec import RatedSpec
from cranktrain.questions.drive.motors.table import TABLE, TableMotor
from cranktrain.wording import number

Torque = Annotated[Given, Quantity(Dimension.TORQUE)]

_ROUNDING = 1e-9


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


def beyond_table(motor: DeclaredMotor, design: int, speed: Array) -> Iterator[str]:
    """Say that a motor by a table runs at speeds beyond it; nothing of another motor. [rad/s]"""
    if motor.motor is not TABLE:
        return
    ends = motor.numbers.speeds[[0, -1]]
    least, most = np.broadcast_to(ends, (2, motor.n_designs))[:, design].tolist()
    if np.max(speed) > most * (1 + _ROUNDING) or np.min(speed) < least - _ROUNDING * most:
        said = _("The motor runs beyond its table, {least} to {most}: there it has the torque of the last point.")
        yield said.format(least=number(least, "rpm"), most=number(most, "rpm"))


def points(listed: tuple[Given, ...]) -> Array:
    """Numbers of a list, shape (point, design), of one design (point, 1)."""
    return np.stack(np.broadcast_arrays(*(np.atleast_1d(one.array) for one in listed)))


def curve_problems(speeds: tuple[Given, ...], torques: tuple[Given, ...], path: str = "") -> Iterator[Problem]:
    """Find speeds that do not rise, torques that are not as many, and a motor that never drives."""
    if len(torques) != len(speeds):
        allowed = _("must be as many as speeds, {n}").format(n=len(speeds))
        yield Problem(f"{path}torques", None, allowed)
    if all(torque.si <= 0 for torque in torques):
        yield Problem(f"{path}torques", None, _("must be more than 0 at one speed or more, or it never drives"))
    for place, (one, other) in enumerate(pairwise(speeds), 1):
        if other.si <= one.si:
            allowed = _(
                "must be more than the speed before it, {speed}: one torque for each speed, or it is no function"
            )
            yield Problem(f"{path}speeds[{place}]", other.text, allowed.format(speed=one.text))


def _top_speed(curve: TableMotor) -> Array:
    """Where the torque last falls through 0; infinite where the last torque still drives."""
    speeds, torques = curve
    top = np.where(torques[-1] > 0, np.inf, np.nan)
    for low, high, first, last in zip(speeds[:-1], speeds[1:], torques[:-1], torques[1:], strict=True):
        crosses = (first > 0) & (last <= 0)
        along = first / np.where(crosses, first - last, 1.0)
        top = np.where(crosses, low + along * (high - low), top)
    return np.where(np.isnan(top), speeds[0], top)
