"""The table of a series motor, by its rated point with the current there."""

from collections.abc import Iterator
from typing import Literal

from pydantic import Field

from cranktrain.errors import Problem
from cranktrain.language import N_, _
from cranktrain.motors.declared import UNLIMITED, DeclaredMotor
from cranktrain.motors.law import OfRated
from cranktrain.motors.series.law import SERIES, SeriesMotor
from cranktrain.motors.spec import RatedSpec, missing_keys
from cranktrain.quantities import PositiveCurrent, PositiveVoltage, shown


class SeriesSpec(RatedSpec, frozen=True):
    """A series motor by its plate: voltage and current at the rated point."""

    kind: Literal["series"] = Field(description=N_("Kind of motor."))
    voltage: PositiveVoltage = Field(description=N_("Of the line."))
    rated_current: PositiveCurrent = Field(description=N_("Current at the rated point."))

    def _problems(self) -> Iterator[Problem]:
        """Find a motor without its point, or one that gives more than it takes."""
        yield from super()._problems()
        if self.has_no_plate:
            yield from missing_keys(self, ("power", "speed"))
        elif self.is_rated and (taken := self.voltage.si * self.rated_current.si) <= float(self.rating.power):
            allowed = _("must take more at {voltage} than the shaft has: {taken} kW is not above {power} kW")
            powers = {"taken": taken, "power": float(self.rating.power)}
            told = {name: f"{shown(power, 'kW'):.4g}" for name, power in powers.items()}
            yield Problem("rated_current", None, allowed.format(voltage=self.voltage.text, **told))

    def declared(self) -> DeclaredMotor:
        """Give the motor in SI: M = c I², U = (R + c ω) I."""
        rating, current = self.rating, self.rated_current.array
        constant = rating.torque / (current * current)
        motor = SeriesMotor(self.voltage.array, self.voltage.array / current - constant * rating.speed, constant)
        return DeclaredMotor(SERIES, motor, rating, UNLIMITED, self.rotor_inertia, OfRated(motor, current), current)
