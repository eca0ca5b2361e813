"""One motor of every kind, with numbers as a file could give them."""

import numpy as np

from cranktrain.motors.cage.inverter import FluxInverter
from cranktrain.motors.cage.law import CageMotor, CatalogueValues, catalogue_curve
from cranktrain.motors.cage.soft_start import SoftStart
from cranktrain.motors.cage.star_delta import StarDelta
from cranktrain.motors.circuit.inverter import Inverter
from cranktrain.motors.circuit.law import Circuit
from cranktrain.motors.induction.ramp import Ramp
from cranktrain.motors.prime_mover.law import PrimeMover
from cranktrain.motors.series.law import SeriesMotor
from cranktrain.motors.servo.law import Servo
from cranktrain.motors.shunt.law import ShuntMotor
from cranktrain.motors.table.law import TableMotor
from cranktrain.motors.wound_rotor.law import WoundRotor
from cranktrain.motors.wound_rotor.rheostat import Rheostat, SteppedRotor, TimedRotor

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
}
