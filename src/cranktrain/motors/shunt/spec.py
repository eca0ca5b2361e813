"""The table of a shunt motor, or one with constant magnets: its line by a point and the speed without load."""

from collections.abc import Iterator
from typing import Literal

from pydantic import Field

from cranktrain.errors import Problem
from cranktrain.language import N_, _
from cranktrain.motors.declared import DeclaredMotor
from cranktrain.motors.law import OfRated
from cranktrain.motors.shunt.law import SHUNT, shunt_motor
from cranktrain.motors.spec import RatedSpec, missing_keys
from cranktrain.quantities import PositiveSpeed


class ShuntSpec(RatedSpec, frozen=True):
    """A motor whose torque falls with the speed in a straight line, by two points of it."""

    kind: Literal["shunt"] = Field(description=N_("Kind of motor."))
    no_load_speed: PositiveSpeed = Field(description=N_("Speed at which the motor gives no torque."))

    def _problems(self) -> Iterator[Problem]:
        """Find a motor without its point, or no slower under load."""
        yield from super()._problems()
        if self.has_no_plate:
            yield from missing_keys(self, ("torque", "speed"))
        if self.speed is not None and self.no_load_speed.si <= self.speed.si:
            allowed = _("must be more than speed = {speed}: a motor slows down under load")
            yield Problem("no_load_speed", None, allowed.format(speed=self.speed.text))

    def declared(self) -> DeclaredMotor:
        """Give the motor in SI."""
        rating, top = self.rating, self.no_load_speed.array
        line = shunt_motor(rating.torque, rating.speed, top)
        return DeclaredMotor(SHUNT, line, rating, top, self.rotor_inertia, OfRated(line, rating.torque))
