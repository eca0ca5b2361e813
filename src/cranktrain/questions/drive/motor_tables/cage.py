"""The table of a cage motor: by a catalogue's values, by its size, or by Kloss's formula."""

from collections.abc import Iterator

from cranktrain.errors import Problem
from cranktrain.motion import Array
from cranktrain.questions.drive.motor_tables import cage_numbers, cage_problems
from cranktrain.questions.drive.motor_tables.cage_keys import CageKeys
from cranktrain.questions.drive.motor_tables.declared import DeclaredMotor
from cranktrain.questions.drive.motor_tables.spec import DrivingMotorSpec


class CageSpec(CageKeys, frozen=True):
    """A cage motor: rated point and ratios of a catalogue, a size, or Kloss's formula."""

    def _problems(self) -> Iterator[Problem]:
        """Find what does not go together."""
        yield from super()._problems() if self.size is None else DrivingMotorSpec._problems(self)
        yield from cage_problems.cage_problems(self)
        if self.starter is not None:
            yield from self.starter.problems_with(starting_current_is_known=self._starting_current_is_known)

    @property
    def _starting_current_is_known(self) -> bool:
        return self.starting_current_ratio is not None or self.size is not None

    @property
    def rotor_inertia(self) -> Array | None:
        """Moment of inertia of the rotor: as given, or as its size has it. [kg·m²]"""
        own = super().rotor_inertia
        return cage_numbers.of_size(self).inertia if own is None and self.size is not None else own

    @property
    def largest_torque(self) -> Array:
        """Breakdown torque at the voltage that is there. [N·m]"""
        return cage_numbers.cage_curve(self).breakdown_torque

    def declared(self) -> DeclaredMotor:
        """Give the motor in SI."""
        return cage_numbers.declared_cage(self)
