"""One motor of every kind, with numbers as a file could give them."""

import numpy as np

from cranktrain.questions.drive.motors.brake import Brake
from cranktrain.questions.drive.motors.cage import CageMotor, CatalogueValues, catalogue_curve
from cranktrain.questions.drive.motors.circuit import Circuit
from cranktrain.questions.drive.motors.direct_current import SeriesMotor, ShuntMotor
from cranktrain.questions.drive.motors.inverter import FluxInverter, Inverter, Ramp
from cranktrain.questions.drive.motors.prime_mover import PrimeMover
from cranktrain.questions.drive.motors.rheostat import Rheostat, SteppedRotor, TimedRotor
from cranktrain.questions.drive.motors.servo import Servo
from cranktrain.questions.drive.motors.soft_start import SoftStart
from cranktrain.questions.drive.motors.star_delta import StarDelta
from cranktrain.questions.drive.motors.table import TableMotor
from cranktrain.questions.drive.motors.wound_rotor import WoundRotor

SYNCHRONOUS = 50 * np.pi
CATALOGUE = CatalogueValues(7500 / (1465 * np.pi / 30), 1465 * np.pi / 30, SYNCHRONOUS, 3.0, 2.3, 1.8)
"""7.5 kW, as in the reference."""
CAGE = CageMotor(*(float(number) for number in catalogue_curve(CATALOGUE, 0.8)))
CIRCUIT = Circuit(230.0, 0.9, 0.7, 2.6, SYNCHRONOUS)
RAMP = Ramp(0.0, SYNCHRONOUS, 2.0)
ROTOR = WoundRotor(SYNCHRONOUS, 95.0, 0.2, 1.0)
FULL_LOAD = TableMotor(np.array([60.0, 90.0, 130.0, 190.0]), np.array([0.0, 700.0, 800.0, 650.0]))

EXAMPLES = {
    "cage": CAGE,
    "circuit": CIRCUIT,
    "star_delta": StarDelta(CAGE, 1.0, 0.1),
    "soft_start": SoftStart(CAGE, 0.4, 2.0, 7.2, 3.0),
    "inverter": Inverter(CIRCUIT, RAMP, 0.1, 90.0),
    "flux_inverter": FluxInverter(SYNCHRONOUS, 95.0, 0.2, RAMP, 90.0),
    "wound_rotor": ROTOR,
    "stepped_rotor": SteppedRotor(ROTOR, Rheostat(2.5, 3.0)),
    "timed_rotor": TimedRotor(ROTOR, Rheostat(2.5, 3.0), 0.5),
    "shunt": ShuntMotor(400.0, 160.0),
    "series": SeriesMotor(220.0, 1.0, 0.05),
    "servo": Servo(20.0, 2000.0, 30.0),
    "table": FULL_LOAD,
    "prime_mover": PrimeMover(196.0, 188.0, 655.0, FULL_LOAD),
    "brake": Brake(50.0, 0.2),
}
