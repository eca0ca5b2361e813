"""A stroke of the eccentric press against SciPy's solve_ivp, one mode after the other, written from the balances."""

import math

import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import brentq
from tests.presses import GRAVITY, IDLE, KERNELS, PRESS, PRESSING, RAM, high_slip, slope

from cranktrain.transient.clutched.equation import ANGLE, BRAKE_HEAT, CLUTCH_HEAT, MOTOR_WORK, SPEED, WHEEL
from cranktrain.transient.clutched.runs import AT_STAND, COMMAND, LOCKED, LOOSE, OFF, PressPlan
from cranktrain.transient.clutched.stroke import single_stroke

CRANK, FRICTION, WHEEL_INERTIA, DRIVEN = 14.0, 150.0, 24.0, 0.4
RATIO, FORWARD, BACKWARD = 5.0, 0.96, 0.95
COMMAND_ANGLE = math.radians(300.0)


def clutch(time, command):
    """Part of its torque: on from 0.03 s within 0.06 s, off from 0.02 s behind the command within 0.03 s."""
    rise = min(max((time - 0.03) / 0.06, 0.0), 1.0)
    return rise * (1 - min(max((time - command - 0.02) / 0.03, 0.0), 1.0))


def brake(time, command):
    """Part of its torque: off from 0.01 s within 0.02 s, on from 0.04 s behind the command within 0.05 s."""
    return max(1 - min(max((time - 0.01) / 0.02, 0.0), 1.0), min(max((time - command - 0.04) / 0.05, 0.0), 1.0))


def motor(wheel):
    return 3.3 * high_slip(3.3 * wheel, 0.0, PRESS.motor)


def accelerated(torque, inertia, angle, speed, force, braking):
    """Crank's acceleration by a torque on the shaft before the gear, `inertia` on which it acts there first."""
    first, second = slope(angle)
    resisting = (force - RAM * GRAVITY) * first + RAM * first * second * speed**2 + FRICTION + braking
    moved = CRANK + RAM * first**2
    for efficiency in (1 / FORWARD, BACKWARD):
        grown = (torque - resisting * efficiency / RATIO) / (inertia * RATIO + moved * efficiency / RATIO)
        if (moved * grown + resisting >= 0) == (efficiency > 1):
            return grown
    raise AssertionError


class Modes:
    """The stroke as a chain of smooth pieces, each to its own event."""

    def __init__(self):
        self.time, self.state, self.command, self.force = 0.0, [IDLE, 0.0, 0.0, 0.0, 0.0, 0.0], math.inf, 0.0

    def go(self, mode, stop=None, until=5.0):
        def slopes(time, state):
            wheel, angle, speed = state[:3]
            grip = PRESS.clutch.torque * clutch(time, self.command) if mode == "slips" else 0.0
            grip *= self.way if mode == "slips" else 1.0
            drag = PRESS.brake.torque * brake(time, self.command)
            if mode == "held":
                grip = PRESS.clutch.torque * clutch(time, self.command)
                return [(motor(wheel) - grip) / WHEEL_INERTIA, 0.0, 0.0, grip * wheel, 0.0, motor(wheel) * wheel]
            if mode == "locked":
                grown = accelerated(motor(wheel), DRIVEN + WHEEL_INERTIA, angle, speed, self.force, drag)
                return [RATIO * grown, speed, grown, 0.0, drag * speed, motor(wheel) * wheel]
            grown = accelerated(grip, DRIVEN, angle, speed, self.force, drag)
            heat = grip * (wheel - RATIO * speed)
            return [(motor(wheel) - grip) / WHEEL_INERTIA, speed, grown, heat, drag * speed, motor(wheel) * wheel]

        self.slopes = slopes
        if stop is not None:
            stop.terminal = True
        found = solve_ivp(slopes, (self.time, until), self.state, "DOP853", rtol=1e-12, atol=1e-13, events=stop)
        assert stop is None or found.status == 1
        self.time, self.state = float(found.t[-1]), list(found.y[:, -1])

    way = 1.0

    def handed_on(self, time, state):
        return motor(state[0]) - WHEEL_INERTIA * self.slopes(time, state)[0]


def strokes():
    """Times and states at all events."""
    modes, marks = Modes(), {}
    modes.go("held", until=brentq(lambda time: 4800.0 * clutch(time, math.inf) * 5 * 0.96 - 150.0, 0.03, 0.04))
    marks[OFF] = (modes.time, modes.state)
    modes.go("slips", lambda _time, state: state[0] - RATIO * state[2], until=0.09)
    marks[LOCKED] = (modes.time, modes.state)
    for angle, force in ((PRESSING[0], 0.0), (PRESSING[1], 600e3), (COMMAND_ANGLE, 0.0)):
        modes.force = force
        modes.go("locked", lambda _time, state, angle=angle: state[1] - angle)
    marks[COMMAND] = (modes.time, modes.state)
    modes.command, modes.force = modes.time, 0.0
    modes.go("locked", until=modes.command + 0.02)
    modes.go("locked", until=modes.command + 0.04)
    torque = PRESS.clutch.static_torque
    modes.go("locked", lambda time, state: torque * clutch(time, modes.command) - abs(modes.handed_on(time, state)))
    marks[LOOSE] = (modes.time, modes.state)
    modes.way = math.copysign(1.0, modes.handed_on(modes.time, modes.state))
    for part in (0.05, 0.09):
        modes.go("slips", until=modes.command + part)
    modes.go("slips", lambda _time, state: state[2])
    marks[AT_STAND] = (modes.time, modes.state)
    return marks


def test_stroke():
    marks = strokes()
    plan = PressPlan(5.0, command_angle=COMMAND_ANGLE, jumps=PRESSING, tolerance=1e-12)
    found = single_stroke(KERNELS, PRESS, plan, wheel_speed=IDLE)
    assert [event.kind for event in found.run.events] == list(marks)
    for event in found.run.events:
        time, state = marks[event.kind]
        own = event.moment.state[[WHEEL, ANGLE, SPEED, CLUTCH_HEAT, BRAKE_HEAT, MOTOR_WORK]]
        assert event.moment.time == pytest.approx(time, abs=1e-9)
        assert own[:3] == pytest.approx(state[:3], rel=1e-8, abs=1e-8)
        assert own[3:] == pytest.approx(state[3:], abs=1e-8 * found.run.supplied)
    assert abs(found.run.residual) < 1e-8 * found.run.supplied
