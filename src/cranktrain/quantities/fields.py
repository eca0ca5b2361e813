"""The annotations of quantities in specs; each field holds a `Given`.

A field with a range of its own is annotated `Annotated[Given, Quantity(Dimension.ANGLE, above=0.0, below=pi)]`.
"""

from typing import Annotated, TypeAlias

from cranktrain.quantities.dimensions import Dimension
from cranktrain.quantities.given import Given, Quantity

Ratio: TypeAlias = Annotated[Given, Quantity(Dimension.RATIO)]
PositiveRatio: TypeAlias = Annotated[Given, Quantity(Dimension.RATIO, above=0.0)]
ShareBetween: TypeAlias = Annotated[Given, Quantity(Dimension.RATIO, above=0.0, below=1.0)]
ShareFromZero: TypeAlias = Annotated[Given, Quantity(Dimension.RATIO, at_least=0.0, below=1.0)]
ShareToOne: TypeAlias = Annotated[Given, Quantity(Dimension.RATIO, above=0.0, at_most=1.0)]
ShareFromZeroToOne: TypeAlias = Annotated[Given, Quantity(Dimension.RATIO, at_least=0.0, at_most=1.0)]
PositiveForce: TypeAlias = Annotated[Given, Quantity(Dimension.FORCE, above=0.0)]
Length: TypeAlias = Annotated[Given, Quantity(Dimension.LENGTH)]
PositiveLength: TypeAlias = Annotated[Given, Quantity(Dimension.LENGTH, above=0.0)]
NonNegativeLength: TypeAlias = Annotated[Given, Quantity(Dimension.LENGTH, at_least=0.0)]
Angle: TypeAlias = Annotated[Given, Quantity(Dimension.ANGLE, is_direction=True)]
TurnedAngle: TypeAlias = Annotated[Given, Quantity(Dimension.ANGLE)]  # through which something turns, or over turns
Speed: TypeAlias = Annotated[Given, Quantity(Dimension.SPEED)]
PositiveSpeed: TypeAlias = Annotated[Given, Quantity(Dimension.SPEED, above=0.0)]
AngularAcceleration: TypeAlias = Annotated[Given, Quantity(Dimension.ANGULAR_ACCELERATION)]
Velocity: TypeAlias = Annotated[Given, Quantity(Dimension.VELOCITY)]
PositiveVelocity: TypeAlias = Annotated[Given, Quantity(Dimension.VELOCITY, above=0.0)]
Force: TypeAlias = Annotated[Given, Quantity(Dimension.FORCE)]
PositiveTorque: TypeAlias = Annotated[Given, Quantity(Dimension.TORQUE, above=0.0)]
Pressure: TypeAlias = Annotated[Given, Quantity(Dimension.PRESSURE, at_least=0.0)]  # absolute
PositivePressure: TypeAlias = Annotated[Given, Quantity(Dimension.PRESSURE, above=0.0)]  # absolute
PositiveMass: TypeAlias = Annotated[Given, Quantity(Dimension.MASS, above=0.0)]
PositiveInertia: TypeAlias = Annotated[Given, Quantity(Dimension.INERTIA, above=0.0)]
NonNegativeInertia: TypeAlias = Annotated[Given, Quantity(Dimension.INERTIA, at_least=0.0)]
FlywheelMoment: TypeAlias = Annotated[Given, Quantity(Dimension.FLYWHEEL_MOMENT)]
PositiveEnergy: TypeAlias = Annotated[Given, Quantity(Dimension.ENERGY, above=0.0)]
HeatTransfer: TypeAlias = Annotated[Given, Quantity(Dimension.HEAT_TRANSFER, at_least=0.0)]
PositiveDensity: TypeAlias = Annotated[Given, Quantity(Dimension.DENSITY, above=0.0)]
PositiveBendingStiffness: TypeAlias = Annotated[Given, Quantity(Dimension.BENDING_STIFFNESS, above=0.0)]
PositiveTorsionalStiffness: TypeAlias = Annotated[Given, Quantity(Dimension.TORSIONAL_STIFFNESS, above=0.0)]
PositiveMolarMass: TypeAlias = Annotated[Given, Quantity(Dimension.MOLAR_MASS, above=0.0)]
Temperature: TypeAlias = Annotated[Given, Quantity(Dimension.TEMPERATURE, above=0.0)]
PositivePower: TypeAlias = Annotated[Given, Quantity(Dimension.POWER, above=0.0)]
PositiveTime: TypeAlias = Annotated[Given, Quantity(Dimension.TIME, above=0.0)]
NonNegativeTime: TypeAlias = Annotated[Given, Quantity(Dimension.TIME, at_least=0.0)]
PositiveFrequency: TypeAlias = Annotated[Given, Quantity(Dimension.FREQUENCY, above=0.0)]
VibrationFrequency: TypeAlias = Annotated[Given, Quantity(Dimension.FREQUENCY, above=0.0, is_of_vibration=True)]
PositiveVoltage: TypeAlias = Annotated[Given, Quantity(Dimension.VOLTAGE, above=0.0)]
PositiveCurrent: TypeAlias = Annotated[Given, Quantity(Dimension.CURRENT, above=0.0)]
PositiveResistance: TypeAlias = Annotated[Given, Quantity(Dimension.RESISTANCE, above=0.0)]
