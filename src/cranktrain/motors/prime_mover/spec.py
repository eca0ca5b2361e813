"""The table of an engine with a governor: its droop by two points, and the most that it gives by speed."""

from collections.abc import Iterator
from typing import Annotated, Literal

from pydantic import Field

from cranktrain.errors import Problem
from cranktrain.language import N_, _
from cranktrain.motors.declared import DeclaredMotor
from cranktrain.motors.prime_mover.law import PRIME_MOVER, PrimeMover
from cranktrain.motors.spec import RatedSpec, curve_problems, missing_keys, points
from cranktrain.motors.table.law import TableMotor, table_torque
from cranktrain.quantities import Dimension, Given, PositiveSpeed, Quantity
from cranktrain.spec import Spec

NonNegativeSpeed = Annotated[Given, Quantity(Dimension.SPEED, at_least=0.0)]
NonNegativeTorque = Annotated[Given, Quantity(Dimension.TORQUE, at_least=0.0)]
_ROUNDING = 1e-9


class FullLoadSpec(Spec, frozen=True):
    """The most that an engine gives: torques at speeds that rise, on straight lines between them."""

    speeds: tuple[NonNegativeSpeed, ...] = Field(min_length=2, description=N_("Speeds, each above the one before."))
    torques: tuple[NonNegativeTorque, ...] = Field(
        min_length=2, description=N_("Torque at each of them; 0 below the speed at which it runs by itself.")
    )

    def _problems(self) -> Iterator[Problem]:
        """Find a table that is no function of the speed."""
        yield from curve_problems(self.speeds, self.torques)


class PrimeMoverSpec(RatedSpec, frozen=True):
    """An engine with a governor: no torque at one speed, the rated one at a lower, up to full load."""

    kind: Literal["prime_mover"] = Field(description=N_("Kind of motor."))
    no_load_speed: PositiveSpeed = Field(description=N_("Speed at which the governor gives no torque."))
    full_load: FullLoadSpec = Field(description=N_("The most that the engine gives, by speed."))

    def _problems(self) -> Iterator[Problem]:
        """Find an engine without its rated point, no slower under load, or rated above its full load."""
        yield from super()._problems()
        if self.has_no_plate:
            yield from missing_keys(self, ("power", "speed"))
        if self.speed is not None and self.no_load_speed.si <= self.speed.si:
            allowed = _("must be more than speed = {speed}: the governor's droop")
            yield Problem("no_load_speed", None, allowed.format(speed=self.speed.text))
        if self.is_rated:
            most = float(table_torque(self.rating.speed, self._full_load)[0])
            if float(self.rating.torque) > most * (1 + _ROUNDING):
                allowed = _("must reach the rated torque at speed; it has {most} N·m there, for {rated} N·m")
                told = {"most": f"{most:.4g}", "rated": f"{float(self.rating.torque):.4g}"}
                yield Problem("full_load.torques", None, allowed.format(**told))

    @property
    def _full_load(self) -> TableMotor:
        return TableMotor(points(self.full_load.speeds), points(self.full_load.torques))

    def declared(self) -> DeclaredMotor:
        """Give the engine in SI."""
        rating, top = self.rating, self.no_load_speed.array
        engine = PrimeMover(top, rating.speed, rating.torque, self._full_load)
        return DeclaredMotor(PRIME_MOVER, engine, rating, top, self.rotor_inertia)
