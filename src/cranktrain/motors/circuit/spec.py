"""The table of an induction motor by its circuit, direct on line or on an inverter."""

from collections.abc import Iterator
from dataclasses import replace
from typing import Annotated, Literal

from pydantic import Field

from cranktrain.errors import Problem
from cranktrain.language import N_
from cranktrain.motion import Array
from cranktrain.motors.circuit.inverter import INVERTER, Inverter
from cranktrain.motors.circuit.law import CIRCUIT, Circuit, CircuitCurrent, circuit_current, kloss_of_circuit
from cranktrain.motors.declared import DeclaredMotor
from cranktrain.motors.induction.spec import InductionSpec, RampSpec
from cranktrain.quantities import Dimension, Given, PositiveResistance, PositiveVoltage, Quantity

Boost = Annotated[Given, Quantity(Dimension.RATIO, at_least=0.0, at_most=1.0)]
NonNegativeResistance = Annotated[Given, Quantity(Dimension.RESISTANCE, at_least=0.0)]


class CircuitInverterSpec(RampSpec, frozen=True):
    """An inverter with voltage in proportion to frequency: a ramp, a boost, and a limit of torque."""

    boost: Boost = Field(default=Given(0.0, "0"), description=N_("Voltage at frequency 0, in parts of the rated one."))

    def started(self, direct: DeclaredMotor) -> DeclaredMotor:
        """Give the motor on this inverter."""
        ramp = self.ramp(direct)
        return replace(
            direct,
            law=INVERTER,
            numbers=Inverter(direct.numbers, ramp, self.boost.array, self.limit),
            top_speed=ramp.last_speed,
            current_numbers=None,
            is_heat_known=self.torque_limit is None,
        )


class CircuitSpec(InductionSpec, frozen=True):
    """An induction motor by resistances and reactance of a phase, rotor quantities referred to the stator."""

    kind: Literal["circuit"] = Field(description=N_("Kind of motor."))
    phase_voltage: PositiveVoltage = Field(
        description=N_("Voltage of a winding: that of the line in delta, by √3 in star.")
    )
    stator_resistance: NonNegativeResistance = Field(description=N_("Of a winding of the stator."))
    rotor_resistance: PositiveResistance = Field(description=N_("Of a phase of the rotor, referred to the stator."))
    reactance: PositiveResistance = Field(
        description=N_("Of stator and rotor together, at the frequency of the synchronous speed.")
    )
    starter: CircuitInverterSpec | None = Field(
        default=None, description=N_("Inverter that it runs on; direct on line without it.")
    )

    def _problems(self) -> Iterator[Problem]:
        """Find what does not go together, and a motor of no synchronous speed."""
        yield from super()._problems()
        yield from self.field_problems()

    @property
    def largest_torque(self) -> Array:
        """Breakdown torque, direct on line. [N·m]"""
        return kloss_of_circuit(self._circuit).breakdown_torque

    @property
    def _circuit(self) -> Circuit:
        """Numbers of the circuit."""
        return Circuit(
            self.phase_voltage.array,
            self.stator_resistance.array,
            self.rotor_resistance.array,
            self.reactance.array,
            self.field_speed,
        )

    def declared(self) -> DeclaredMotor:
        """Give the motor in SI."""
        circuit = self._circuit
        rating = self.rating
        rated = circuit_current(circuit.synchronous_speed - rating.speed, circuit)
        direct = DeclaredMotor(
            CIRCUIT,
            circuit,
            rating,
            circuit.synchronous_speed,
            self.rotor_inertia,
            CircuitCurrent(circuit, rated) if self.is_rated else None,
            notes=tuple(self.field_notes()),
        )
        return direct if self.starter is None else self.starter.started(direct)
