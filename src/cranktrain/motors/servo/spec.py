"""The table of a servo motor: what it may give for long, at its peak, and how fast it may turn."""

from collections.abc import Iterator
from typing import Annotated, ClassVar, Literal

from pydantic import Field

from cranktrain.errors import Problem
from cranktrain.language import N_, _
from cranktrain.motion import Array
from cranktrain.motors.declared import UNLIMITED, DeclaredMotor
from cranktrain.motors.law import OfRated
from cranktrain.motors.servo.law import SERVO, Servo
from cranktrain.motors.spec import RatedSpec
from cranktrain.quantities import Dimension, Given, PositivePower, PositiveSpeed, PositiveTorque, Quantity
from cranktrain.saying.wording import as_limit

AnyTorque = Annotated[Given, Quantity(Dimension.TORQUE)]


class ServoSpec(RatedSpec, frozen=True):
    """A servo motor: any torque up to its peak, by power at speed; and a rated one for long."""

    symbol_of_largest: ClassVar[str] = "M_pk"

    kind: Literal["servo"] = Field(description=N_("Kind of motor."))
    peak_torque: PositiveTorque = Field(description=N_("Largest torque for a short time."))
    peak_power: PositivePower | None = Field(
        default=None, description=N_("Largest power for a short time; without it the torque alone is limited.")
    )
    top_speed: PositiveSpeed | None = Field(default=None, description=N_("Largest speed that is allowed."))
    command: AnyTorque | None = Field(
        default=None, description=N_("Torque that is asked of it; its peak unless given, or a wanted motion says it.")
    )

    def _problems(self) -> Iterator[Problem]:
        """Find peaks below the rated point, and a speed that is above the largest."""
        yield from super()._problems()
        if self.is_rated and self.peak_torque.si < float(self.rating.torque):
            allowed = _("must not be below the rated torque, {rated}")
            rated = as_limit(float(self.rating.torque), "N·m")
            yield Problem("peak_torque", self.peak_torque.text, allowed.format(rated=rated))
        if self.is_rated and self.peak_power is not None and self.peak_power.si < float(self.rating.power):
            allowed = _("must not be below the rated power, {rated}")
            rated = as_limit(float(self.rating.power), "kW")
            yield Problem("peak_power", self.peak_power.text, allowed.format(rated=rated))
        if self.speed is not None and self.top_speed is not None and self.top_speed.si < self.speed.si:
            allowed = _("must not be below speed = {speed}")
            yield Problem("top_speed", None, allowed.format(speed=self.speed.text))

    @property
    def largest_torque(self) -> Array:
        """Largest torque for a short time. [N·m]"""
        return self.peak_torque.array

    def declared(self) -> DeclaredMotor:
        """Give the motor in SI."""
        peak = self.peak_torque.array
        power = UNLIMITED if self.peak_power is None else self.peak_power.array
        motor = Servo(peak, power, peak if self.command is None else self.command.array)
        top = UNLIMITED if self.top_speed is None else self.top_speed.array
        current = OfRated(motor, self.rating.torque) if self.is_rated else None
        return DeclaredMotor(SERVO, motor, self.rating, top, self.rotor_inertia, current)
