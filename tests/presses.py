"""An eccentric press of 1000 kN with a motor of high slip, a flywheel, a clutch and a brake; and a mere wheel."""

import math

import numpy as np

from cranktrain.transient.clutched.courses import Grip
from cranktrain.transient.clutched.equation import press_of
from cranktrain.transient.equation import Kernels, no_brake, no_heat, no_motor
from cranktrain.transient.gearing import stages

RADIUS, ROD, RAM = 0.065, 0.65, 900.0
GRAVITY = 9.80665
PRESSING = (math.radians(156.3), math.pi)
"""The blank is met some 5 mm before the bottom and pressed to there; angles count from the upper dead centre."""
FORCE = 600e3
SYNCHRONOUS = 50 * math.pi
IDLE = SYNCHRONOUS / 3.3


def slope(angle):
    """Travel of the ram by the crank angle, and its derivative. [m/rad, m/rad²]"""
    sin, cos = np.sin(angle), np.cos(angle)
    root = np.sqrt(ROD * ROD - RADIUS * RADIUS * sin * sin)
    first = RADIUS * sin + RADIUS * RADIUS * sin * cos / root
    second = RADIUS * cos + RADIUS * RADIUS * (cos * cos - sin * sin) / root
    return first, second + (RADIUS * RADIUS * sin * cos) ** 2 / root**3


def ram(angle, _speed, sense, numbers):
    """Crank, ram with its weight, dry friction at the shaft, and the pressing force: inertia, mass, force, friction."""
    sin, cos = np.sin(angle), np.cos(angle)
    root = np.sqrt(0.65 * 0.65 - 0.065 * 0.065 * sin * sin)
    first = 0.065 * sin + 0.065 * 0.065 * sin * cos / root
    second = 0.065 * cos + 0.065 * 0.065 * (cos * cos - sin * sin) / root + (0.065 * 0.065 * sin * cos) ** 2 / root**3
    turned = angle % 6.283185307179586
    pressing = numbers[2] if turned >= numbers[4] and turned <= numbers[5] and sense > 0 else 0.0
    load = (pressing - numbers[1] * 9.80665) * first + numbers[3] * sense
    return numbers[0] + numbers[1] * first * first, 2 * numbers[1] * first * second, load, first


def high_slip(speed, _time, motor):
    """Simplified Kloss formula: breakdown torque, breakdown slip, synchronous speed."""
    slip = 1 - speed / motor[2]
    return 2 * motor[0] * slip * motor[1] / (slip * slip + motor[1] * motor[1])


def wheel(_angle, _speed, sense, numbers):
    """A machine of constant inertia: inertia, active load, dry friction."""
    return numbers[0], 0.0, numbers[1] + numbers[2] * sense, 1.0


KERNELS = Kernels(ram, high_slip, no_heat, no_brake)
BARE = Kernels(wheel, no_motor, no_heat, no_brake)
NUMBERS = {
    "machine": (14.0, RAM, FORCE, 150.0, *PRESSING),
    "motor": (190.0, 0.45, SYNCHRONOUS),
    "motor_ratio": 3.3,
    "wheel_inertia": 24.0,
    "driven_inertia": 0.4,
    "ratio": 5.0,
    "forward": 0.96,
    "backward": 0.95,
    "clutch": Grip(4800.0, 6000.0, 0.03, 0.06, 0.02, 0.03),
    "brake": Grip(2600.0, 2800.0, 0.04, 0.05, 0.01, 0.02),
    "brake_on_crank": True,
}


def press_with(**changes):
    """The eccentric press, or one that differs: a belt without loss, flywheel, clutch, one gear, crank."""
    own = {**NUMBERS, **changes}
    before = stages(0.0, (own["motor_ratio"], 1.0, 1.0, 0.0, own["wheel_inertia"]))
    behind = stages(own["driven_inertia"], (own["ratio"], own["forward"], own["backward"], 0.0, 0.0))
    return press_of(
        own["machine"], own["motor"], before, behind, own["clutch"], own["brake"], brake_on_crank=own["brake_on_crank"]
    )


PRESS = press_with()


def bare_press(clutch, brake=None, load=150.0, dry=0.0):
    """Flywheel of 40 kg·m² and a wheel of 6, without motor and gear."""
    off = Grip(1.0, 1.0) if brake is None else brake
    return press_of((6.0, load, dry), (), stages(40.0), stages(0.0), clutch, off, brake_on_crank=True)
