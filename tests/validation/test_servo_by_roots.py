"""Servo presses against roots of x(φ) = x(t), time by time, with torques written out; in inches and pounds.

Nothing of the program is in it: crank angle by SciPy's brentq, speed and acceleration by the chain rule, losses of both
stages by the sign of what they pass on, integrals by Gauss's rule between the times at which the load has corners.
"""

import math
from itertools import pairwise

import numpy as np
import pytest
from scipy.optimize import brentq, minimize_scalar

import cranktrain as ct

INCH, POUND, POUND_FORCE = 0.0254, 0.45359237, 4.4482216152605
RADIUS, ROD, OFFSET = 2 * INCH, 17 * INCH, 0.5 * INCH
RAM, CRANK, ROTOR, GEAR = 900 * POUND, 1.5, 0.05, 0.4
TOUCH, PRESS, FORCE, DRAG = 2.5 * INCH, 2.9 * INCH, 30000 * POUND_FORCE, 150 * POUND_FORCE
FAR, NEAR = math.asin(OFFSET / (RADIUS + ROD)), math.pi + math.asin(OFFSET / (ROD - RADIUS))
HIGHEST = math.sqrt((ROD - RADIUS) ** 2 - OFFSET**2)
STROKE = math.sqrt((ROD + RADIUS) ** 2 - OFFSET**2) - HIGHEST
LAWS = {"3-4-5": [0, 0, 0, 10, -15, 6], "4-5-6-7": [0, 0, 0, 0, 35, -84, 70, -20]}


def machine(motion, **shaft):
    return {
        "name": "a servo press",
        "rotation": "clockwise",
        "angle": "180 deg",
        "shaft": {"main": {"motion": {"of": "piston", "counts_from": "near", **motion}, **shaft}},
        "mechanism": {"kind": "slider_crank", "crank_radius": "2 in", "rod_length": "17 in", "offset": "0.5 in"},
        "masses": {
            "crank": {"mass": "1 kg", "along": "0 mm", "inertia": f"{CRANK} kg*m^2"},
            "piston": {"mass": "900 lb"},
        },
        "load": {
            "work": {
                "on": "piston",
                "travel": ["0 in", "2.5 in", "2.9 in", "4.2 in"],
                "force": ["0 lbf", "0 lbf", "30000 lbf", "30000 lbf"],
                "force_back": ["150 lbf"] * 4,
            }
        },
        "drive": {
            "stage": [
                {"ratio": 5, "efficiency": 0.96},
                {"ratio": 7, "efficiency": 0.93, "efficiency_back": 0.9},
            ],
            "part": {
                "rotor": {"on": "motor", "inertia": f"{ROTOR} kg*m^2"},
                "gear": {"on": 1, "inertia": f"{GEAR} kg*m^2"},
            },
        },
    }


def ram(angle):
    """Position and its slopes by the crank angle."""
    across, height = RADIUS * math.sin(angle) - OFFSET, RADIUS * math.cos(angle)
    along = math.sqrt(ROD**2 - across**2)
    slope = -RADIUS * math.sin(angle) - across * height / along
    bent = -height - (height**2 - across * RADIUS * math.sin(angle)) / along - (across * height) ** 2 / along**3
    return height + along, slope, bent


def wished(law, time, duration, begin, end):
    """Position from the highest one, velocity, acceleration."""
    y = np.polynomial.Polynomial(LAWS[law])
    s, way = time / duration, end - begin
    return begin + way * y(s), way * y.deriv()(s) / duration, way * y.deriv(2)(s) / duration**2


def at_motor(piece, time, between):
    """Torque and speed of the motor."""
    where, velocity, acceleration = wished(piece[0], time, *piece[1:])
    angle = brentq(lambda at: ram(at)[0] - HIGHEST - where, *between, xtol=1e-15)
    _, slope, bent = ram(angle)
    speed = velocity / slope
    grown = (acceleration - bent * speed**2) / slope
    force = FORCE * min(1.0, max(0.0, (where - TOUCH) / (PRESS - TOUCH))) if velocity > 0 else DRAG
    sense = math.copysign(1.0, speed)
    crank = (CRANK + RAM * slope**2) * grown + RAM * slope * bent * speed**2 + force * abs(slope) * sense
    second = crank / 7 * (1 / 0.93 if crank * sense > 0 else 0.9) + GEAR * 7 * grown
    first = second / 5 * (1 / 0.96 if second * sense > 0 else 2 - 1 / 0.96)
    return first + ROTOR * 35 * grown, speed * 35


def touching(law, duration, begin, end):
    """Times at which the load has corners on the way down."""
    return [
        brentq(lambda time, at=at: wished(law, time, duration, begin, end)[0] - at, 0, duration, xtol=1e-15)
        for at in (TOUCH, PRESS)
    ]


def peak(piece, time, of):
    """Largest value within 3 ms of a time."""
    found = minimize_scalar(lambda at: -of(*at_motor(piece, at, (FAR, NEAR))), bounds=(time - 3e-3, time + 3e-3))
    return -found.fun


def test_rocking_over_corners_of_the_load():
    down, up = ("3-4-5", 0.5, 1.2 * INCH, 3.6 * INCH), ("4-5-6-7", 0.3, 3.6 * INCH, 1.2 * INCH)
    pieces = [{"duration": f"{one[1]} s", "to": f"{one[3] / INCH} in", "law": one[0]} for one in (down, up)]
    found = ct.run(machine({"mode": "rocking", "piece": pieces}, speed="40 rpm"))
    nodes, weights = np.polynomial.legendre.leggauss(8)
    squares, torques, powers = 0.0, [], []
    beside = [at_motor(down, time + step, (FAR, NEAR)) for time in touching(*down) for step in (-1e-11, 1e-11)]
    for piece, ends in ((down, [0, *touching(*down), 0.5]), (up, [0, 0.3])):
        for begin, end in pairwise(ends):
            parts = np.linspace(begin, end, 41)
            for low, high in pairwise(parts.tolist()):
                for node, weight in zip(nodes, weights, strict=True):
                    time = (low + high) / 2 + (high - low) / 2 * node
                    torque, speed = at_motor(piece, time, (FAR, NEAR))
                    squares += torque**2 * weight * (high - low) / 2
                    torques.append((abs(torque), piece, time))
                    powers.append((abs(torque * speed), piece, time))
    torque, power = (
        max(peak(*max(values)[1:], of), *(of(*one) for one in beside))
        for values, of in ((torques, lambda torque, _: abs(torque)), (powers, lambda *both: abs(math.prod(both))))
    )
    assert found.rocking_rms_torque == pytest.approx(math.sqrt(squares / 0.8), rel=1e-7)
    assert found.rocking_peak_torque == pytest.approx(torque, rel=1e-6)
    assert found.rocking_peak_power == pytest.approx(power, rel=1e-6)


def test_the_peak_where_the_load_has_a_corner():
    """Full force is reached while the ram still goes fast: torque and power are largest just there."""
    down = ("4-5-6-7", 0.7, 0.0, STROKE)
    pieces = [{"duration": "0.7 s", "to": f"{STROKE!r} m"}, {"duration": "0.9 s", "to": "0 in"}]
    found = ct.run(machine({"piece": pieces}))
    torque, speed = at_motor(down, touching(*down)[1], (NEAR, FAR + 2 * math.pi))
    assert found.servo_peak_torque == pytest.approx(torque, rel=1e-10)
    assert found.servo_peak_power == pytest.approx(torque * speed, rel=1e-10)
