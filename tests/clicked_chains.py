"""A toggle press that lies in several ways, and parts that are added to it by clicks."""

from math import radians

import numpy as np

import cranktrain as ct
from cranktrain.io.added_tables import with_part
from cranktrain.io.machine_source import source_of_text
from cranktrain.mechanisms.by_hand import Clicked
from cranktrain.panels.additions import added_table

RADIUS, PIVOT = 0.05, (0.4, 0.25)
METRES = {"mm": 1e-3, "in": 0.0254, "cm": 1e-2}
STEPS = {"mm": 1e-3, "in": 0.05 * 0.0254, "cm": 1e-3}
"""Of typed lengths, in a machine that reaches 0.47 m: some 300 of them. [m]"""
ANGLES = (0.0, 73.0, 215.0, -40.0)
LIE = (
    ("anticlockwise", "-90 deg", "ahead", "mm"),
    ("clockwise", "33 deg", "ahead", "mm"),
    ("clockwise", "-90 deg", "astern", "in"),
    ("anticlockwise", "200 deg", "astern", "cm"),
)


def text_of(rotation="anticlockwise", angle="-90 deg", running="ahead", unit="mm"):
    """A toggle press, and comments; its crank pin moves the knee between the pivot and the ram."""

    def typed(length):
        return f'"{length / METRES[unit]:.9g} {unit}"'

    return f"""\
# mine
rotation = "{rotation}"  # as I see it
angle = "{angle}"
running = "{running}"

[mechanism]
kind = "chain"
output = "ram"

[mechanism.fixed]
C = [{typed(PIVOT[0])}, {typed(PIVOT[1])}] # the frame

[mechanism.crank.main]
radius = {typed(RADIUS)}

[[mechanism.part]]
type = "pin"
rod = {{ name = "pitman", from = "main.pin", length = {typed(0.32)} }}
rocker = {{ name = "upper", from = "C", length = {typed(0.25)} }}
joint = "knee"
side = "right" # or the other way

[[mechanism.part]]
type = "slide"
rod = {{ name = "lower", from = "knee", length = {typed(0.25)} }}
slider = "ram"
guide = {{ through = "C", direction = "-90 deg" }} # down

# at last
[shaft.main]
speed = "40 rpm"
"""


class Lying:
    """How the axes of the file lie in the drawing, from the machine's rotation and angle alone."""

    def __init__(self, rotation, angle, running, unit):
        normal = 1.0 if rotation == "clockwise" else -1.0
        direction = normal * radians(float(angle.split()[0]))
        self.x = np.array([np.sin(direction), np.cos(direction)])
        self.y = normal * np.array([np.cos(direction), -np.sin(direction)])
        self.turning = -1.0 if running == "astern" else 1.0
        self.unit, self.step = METRES[unit], STEPS[unit]

    def at(self, x, y):
        return x * self.x + y * self.y

    def own(self, place):
        """A place of the drawing in the axes of the file."""
        return np.array([place @ self.x, place @ self.y])

    def phi(self, degrees):
        """Angle of the crank in the axes of the file. [rad]"""
        return self.turning * radians(degrees)

    def crank(self, degrees):
        phi = self.phi(degrees)
        return self.at(RADIUS * np.cos(phi), RADIUS * np.sin(phi))


def machine_of(text):
    """Read it, whether it turns all round or not."""
    return source_of_text(text, {}).with_set(partial=True).machine


def added(text, name, angle, *clicks):
    machine = machine_of(text)
    return with_part(text, *added_table(machine, "1", name, angle, [Clicked(own, *at) for own, at in clicks]))


def pins_of(text, angle):
    return {name: pin[:, 0] for name, pin in turning_pins(text, [angle]).items()}


def turning_pins(text, angles):
    """Where each pin is at crank angles, shape (2, n). [m]"""
    return ct.drawing(machine_of(text), angles).mechanisms[0].pins


def length_of(text):
    """A typed length. [m]"""
    number, unit = text.split()
    return float(number) * METRES[unit]


def away(one, other):
    return float(np.hypot(*(np.asarray(one) - np.asarray(other))))
