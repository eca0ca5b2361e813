"""Motor with a wound rotor: a constant resistance in its circuit."""

from typing import NamedTuple

import numpy as np

from cranktrain.language import N_
from cranktrain.motion import ZERO, Array
from cranktrain.motors.declared import curve_limits
from cranktrain.motors.induction.current import rotor_heat
from cranktrain.motors.induction.kloss import kloss_torque, slip_of
from cranktrain.motors.law import MotorLaw


class WoundRotor(NamedTuple):
    """A motor with slip rings.

    Attributes
    ----------
    synchronous_speed : Array
        [rad/s]
    breakdown_torque, breakdown_slip : Array
        With the rings shorted. [N·m, 1]
    resistance : Array
        All of the rotor's circuit, in parts of the rotor's own: 1 with the rings shorted. [1]
    """

    synchronous_speed: Array
    breakdown_torque: Array
    breakdown_slip: Array
    resistance: Array


def wound_rotor_torque(speed: Array, rotor: WoundRotor) -> Array:
    """Torque with a constant resistance in the rotor's circuit. [N·m]

    Parameters
    ----------
    speed : Array, shape (..., n)
        [rad/s]
    rotor : WoundRotor, fields broadcastable to (..., 1)

    Notes
    -----
    docs/theory/drive, eq. (25.16).
    """
    slip = slip_of(speed, rotor.synchronous_speed)
    torque = kloss_torque(slip, rotor.breakdown_torque, rotor.breakdown_slip * rotor.resistance, ZERO)
    return np.sign(rotor.synchronous_speed) * torque


def wound_rotor_heat(speed: Array, _time: Array, rotor: WoundRotor) -> Array:
    """Power that turns to heat in the rotor itself; the rest of it does in the resistance. [W]

    docs/theory/drive, eqs. (25.9) and (25.16).
    """
    return rotor_heat(wound_rotor_torque(speed, rotor), speed, rotor.synchronous_speed) / rotor.resistance


WOUND_ROTOR = MotorLaw(
    "wound_rotor",
    N_("motor with slip rings and a resistance"),
    wound_rotor_torque,
    WoundRotor,
    "docs/theory/drive, eq. (25.16)",
    N_("simplified Kloss: no stator resistance, no deep bars, which wound rotors do not have"),
    limits=curve_limits,
    heat=wound_rotor_heat,
    is_on_line=True,
)
