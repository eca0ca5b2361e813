"""The table of a cage motor: by a catalogue's values, by its size, or by Kloss's formula."""

from collections.abc import Iterator

import numpy as np

from cranktrain.errors import Problem
from cranktrain.motion import Array
from cranktrain.motors.cage.keys import CageKeys
from cranktrain.motors.cage.numbers import cage_curve, declared_cage, of_size
from cranktrain.motors.cage.problems import cage_problems
from cranktrain.motors.declared import UNKNOWN, DeclaredMotor
from cranktrain.motors.spec import DrivingMotorSpec, RatedSlip, first

HIGH_SLIP_BREAKDOWN = 2.75
"""Breakdown torque over the rated one of cage motors with high slip, NEMA design D; typical."""


class CageSpec(CageKeys, frozen=True):
    """A cage motor: rated point and ratios of a catalogue, a size, or Kloss's formula."""

    def _problems(self) -> Iterator[Problem]:
        """Find what does not go together."""
        yield from super()._problems() if self.size is None else DrivingMotorSpec._problems(self)
        yield from cage_problems(self)
        if self.starter is not None:
            yield from self.starter.problems_with(starting_current_is_known=self._starting_current_is_known)

    @property
    def _starting_current_is_known(self) -> bool:
        return self.starting_current_ratio is not None or self.size is not None

    @property
    def rotor_inertia(self) -> Array | None:
        """Moment of inertia of the rotor: as given, or as its size has it. [kg·m²]"""
        own = super().rotor_inertia
        return of_size(self).inertia if own is None and self.size is not None else own

    @property
    def largest_torque(self) -> Array:
        """Breakdown torque at the voltage that is there. [N·m]"""
        return cage_curve(self).breakdown_torque

    @property
    def slip_at_rating(self) -> RatedSlip:
        """Slip at the rated torque: of the plate, or by Kloss's formula from a typical one of motors with high slip.

        docs/theory/drive, eq. (25.4): s_b (m − √(m² − 1)), with m the breakdown torque over the rated one.
        """
        motor = self.declared()
        slip, torque = 1 - motor.rating.speed / motor.top_speed, motor.rating.torque
        if not self.is_rated and self.size is None and self.breakdown_slip is not None:
            slip = self.breakdown_slip.array * (HIGH_SLIP_BREAKDOWN - np.sqrt(HIGH_SLIP_BREAKDOWN**2 - 1))
            torque = UNKNOWN if self.breakdown_torque is None else self.breakdown_torque.array / HIGH_SLIP_BREAKDOWN
        return RatedSlip(first(slip), first(torque * motor.top_speed * (1 - slip)))

    def declared(self) -> DeclaredMotor:
        """Give the motor in SI."""
        return declared_cage(self)
