"""What the tables of induction motors and of their starters have in common: the speed of the field, its ramp."""

from abc import abstractmethod
from collections.abc import Iterable, Iterator
from typing import Annotated, Literal

import numpy as np
from pydantic import Field

from cranktrain.errors import Problem
from cranktrain.language import N_, Words, _
from cranktrain.motion import Array, single
from cranktrain.motors.declared import UNLIMITED, DeclaredMotor
from cranktrain.motors.induction.ramp import Ramp
from cranktrain.motors.spec import RatedSpec, first, missing_keys, out_of_place
from cranktrain.quantities import (
    Dimension,
    Given,
    PositiveFrequency,
    PositiveSpeed,
    PositiveTime,
    PositiveTorque,
    Quantity,
    shown,
)
from cranktrain.spec import Spec

AboveOne = Annotated[Given, Quantity(Dimension.RATIO, above=1.0)]
AtLeastOne = Annotated[Given, Quantity(Dimension.RATIO, at_least=1.0)]
Part = Annotated[Given, Quantity(Dimension.RATIO, above=0.0, at_most=1.0)]

LINE_FREQUENCY = 50.0
"""Unless the table says another. [Hz]"""
MOST_RATED_SLIP = 0.1
"""Of motors whose synchronous speed is guessed from the rated one; with more, another frequency may be meant."""
_ROUNDING = 1e-9

NonNegativeSpeed = Annotated[Given, Quantity(Dimension.SPEED, at_least=0.0)]


class InductionSpec(RatedSpec, frozen=True):
    """An induction motor: its field turns at a speed that is written, or by frequency and poles, or the nearest one."""

    synchronous_speed: PositiveSpeed | None = Field(
        default=None, description=N_("Of the field; the nearest one above the rated speed at 50 Hz unless given.")
    )
    frequency: PositiveFrequency | None = Field(default=None, description=N_("Of the line; 50 Hz unless given."))
    poles: int | None = Field(default=None, ge=2, le=100, multiple_of=2, description=N_("Number of poles."))

    @property
    def field_speed(self) -> Array:
        """Synchronous speed; NaN where nothing says it. [rad/s]"""
        if self.synchronous_speed is not None:
            return self.synchronous_speed.array
        of_a_pair = 2 * np.pi * (single(LINE_FREQUENCY) if self.frequency is None else self.frequency.array)
        if self.poles is not None:
            return of_a_pair / (self.poles / 2)
        pairs = np.ceil(of_a_pair / self.rating.speed) - 1
        return np.where(pairs > 0, of_a_pair / np.maximum(1, pairs), np.nan)

    def field_problems(self) -> Iterator[Problem]:
        """Find a synchronous speed given twice, none, one that is not above the rated speed, or no clear one."""
        if self.synchronous_speed is not None:
            yield from out_of_place(self, ("frequency", "poles"), _("must not stand beside synchronous_speed"))
        if self.synchronous_speed is None and self.poles is None:
            yield from self._guess_problems()
        elif self.speed is not None and (top := first(self.field_speed)) <= self.speed.si:
            key = "synchronous_speed" if self.poles is None else "poles"
            allowed = _(
                "must give a synchronous speed above speed = {speed}, not {top} rpm: the shaft is behind the field"
            )
            yield Problem(key, None, allowed.format(speed=self.speed.text, top=f"{shown(top, 'rpm'):.6g}"))

    def _guess_problems(self) -> Iterator[Problem]:
        """Find a rated speed that is not a little below a synchronous one."""
        if self.speed is None:
            if not self.has_no_plate:
                return
            yield from missing_keys(self, ("synchronous_speed",))
        elif not 1 - self.speed.si / first(self.field_speed) <= MOST_RATED_SLIP + _ROUNDING:
            allowed = _(
                "is missing; speed = {speed} is not within 10 % below a synchronous speed: give it, or frequency"
            )
            yield Problem("synchronous_speed", None, allowed.format(speed=self.speed.text))

    def field_notes(self) -> Iterator[Words]:
        """Say which synchronous speed was taken, where the table does not."""
        if self.synchronous_speed is None and self.poles is None:
            speed = f"{shown(first(self.field_speed), 'rpm'):.6g} rpm"
            yield _("The synchronous speed is {speed}, the nearest above the rated one.", speed=speed)


class StarterSpec(Spec, frozen=True):
    """What every starter of a machine file declares."""

    kind: str

    @abstractmethod
    def started(self, direct: DeclaredMotor) -> DeclaredMotor:
        """Give the motor with this starter, from that direct on line."""

    def problems_with(self, *, starting_current_is_known: bool) -> Iterable[Problem]:
        """Find what does not suit the motor; paths are relative to the motor's table."""
        return ()


class RampSpec(StarterSpec, frozen=True):
    """What every inverter declares: a ramp of frequency, and a limit of torque."""

    kind: Literal["inverter"] = Field(description=N_("Kind of starter."))
    ramp_time: PositiveTime = Field(description=N_("Time in which the field comes to its last speed."))
    first_speed: NonNegativeSpeed = Field(
        default=Given(0.0, "0 rpm"), description=N_("Synchronous speed with which the ramp begins.")
    )
    last_speed: PositiveSpeed | None = Field(
        default=None, description=N_("Synchronous speed with which it ends; that of rated frequency unless given.")
    )
    torque_limit: PositiveTorque | None = Field(
        default=None, description=N_("To which the inverter limits the torque both ways; not at all unless given.")
    )

    def ramp(self, direct: DeclaredMotor) -> Ramp:
        """Give the ramp of the field's speed."""
        last = direct.top_speed if self.last_speed is None else self.last_speed.array
        return Ramp(self.first_speed.array, last, self.ramp_time.array)

    @property
    def limit(self) -> Array:
        """Limit of torque, infinite where there is none. [N·m]"""
        return UNLIMITED if self.torque_limit is None else self.torque_limit.array
