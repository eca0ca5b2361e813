"""Steady cycles that run over the corners and jumps of the motor's own law, against an integration that is cut there.

The machine is a slider-crank with a force on its piston, behind one stage without loss. What it takes at the crank
besides goes with a power of the speed, so that it balances at any corner, on the rising part of a curve too. The
integration is of the eighth order, with 1e-12, in steps of a degree at most, since a corner is found between its steps
by a polynomial of less order, and stops at every corner that the motor says it has: that there are no others is tested
of the laws, in `tests/contract/test_motors.py`.
"""

import math
from typing import NamedTuple

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import cranktrain as ct
from cranktrain.motors import motor_of
from cranktrain.motors.declared import DeclaredMotor

RADIUS, ROD, PISTON, CRANK, RATIO, ROTOR = 0.06, 0.24, 12.0, 0.15, 6.0, 0.004
PLATE = {"power": "5 kW", "speed": "1440 rpm", "synchronous_speed": "1500 rpm"}
CAGE = {"kind": "cage", **PLATE, "breakdown_ratio": 2.8, "starting_ratio": 2.2, "pull_up_ratio": 1.7}
CIRCUIT = {
    "kind": "circuit", "phase_voltage": "230 V", "stator_resistance": "0.9 ohm", "rotor_resistance": "0.7 ohm",
    "reactance": "2.6 ohm", "synchronous_speed": "1500 rpm",
}  # fmt: skip
RINGS = {"kind": "wound_rotor", **PLATE, "breakdown_ratio": 2.8}
INVERTER = {"kind": "inverter", "ramp_time": "2 s", "torque_limit": "45 N*m"}
FULL_LOAD = {"speeds": ["20 rad/s", "60 rad/s", "90 rad/s"], "torques": ["20 N*m", "36 N*m", "30 N*m"]}
MOTORS = {
    "cage": CAGE,
    "circuit": CIRCUIT,
    "star_delta": {**CAGE, "starter": {"kind": "star_delta", "change_time": "2 s"}},
    "soft_start": {**CAGE, "starting_current_ratio": 6, "starter": {"kind": "soft_start", "current_limit": "3"}},
    "inverter": {**CIRCUIT, "starter": INVERTER},
    "flux_inverter": {**CAGE, "starter": INVERTER},
    "wound_rotor": RINGS,
    "stepped_rotor": {**RINGS, "rheostat": {"steps": 3, "peak_ratio": 2}},
    "timed_rotor": {**RINGS, "rheostat": {"steps": 3, "peak_ratio": 2, "interval": "1 s"}},
    "shunt": {"kind": "shunt", "no_load_speed": "105 rad/s", "speed": "95 rad/s", "torque": "25 N*m"},
    "series": {"kind": "series", "power": "3 kW", "speed": "100 rad/s", "voltage": "220 V", "rated_current": "17 A"},
    "servo": {"kind": "servo", "peak_torque": "60 N*m", "peak_power": "5 kW", "command": "50 N*m"},
    "table": {
        "kind": "table",
        "speeds": ["0 rad/s", "60 rad/s", "100 rad/s", "105 rad/s", "150 rad/s"],
        "torques": ["40 N*m", "40 N*m", "30 N*m", "0 N*m", "-200 N*m"],
    },
    "prime_mover": {
        "kind": "prime_mover", "no_load_speed": "105 rad/s", "speed": "100 rad/s", "torque": "25 N*m",
        "full_load": FULL_LOAD,
    },
}  # fmt: skip
CORNERS = {
    "cage": 2,
    "star_delta": 2,
    "soft_start": 4,
    "inverter": 3,
    "flux_inverter": 4,
    "stepped_rotor": 3,
    "servo": 1,
    "table": 4,
    "prime_mover": 5,
}
"""How many a turning shaft may pass; the others' laws are smooth. A brake's only one is standstill."""
EXPONENT = 6.0
SWINGS = {"stepped_rotor": 1.0, "table": 1.0}
"""Torque of the piston's force in parts of what is taken: as much as carries it over jumps and steep lines."""
SMOOTH = 100.0
"""Speed about which a motor without corners runs. [rad/s]"""
LONGEST_STEP = np.radians(1.0)
AGREES = 1e-9


class Loads(NamedTuple):
    """What acts: on the piston [N]; at the crank what drives it, and what it takes at a speed of the motor [N·m]."""

    force: float
    driving: float
    taken: float
    speed: float


def balanced_at(name, motor, corner):
    """Loads about which the machine runs at a corner: driven there, where the motor brakes."""
    torque = RATIO * float(np.mean(motor.torque(corner * np.array([0.9999, 1.0001]))[0]))
    taken = max(torque, 60.0, -6 * torque)
    return Loads(SWINGS.get(name, 0.25) * taken / RADIUS, taken - torque, taken, corner)


UNLOADED = Loads(1.0, 0.0, 1.0, SMOOTH)


def machine(name, loads=UNLOADED):
    return ct.Machine(
        rotation="anticlockwise",
        angle="-90 deg",
        shaft={"main": {"speed": f"{loads.speed / RATIO!r} rad/s"}},
        mechanism={"kind": "slider_crank", "crank_radius": f"{RADIUS} m", "rod_length": f"{ROD} m"},
        masses={
            "piston": {"mass": f"{PISTON} kg"},
            "crank": {"mass": "1 kg", "along": "0 m", "inertia": f"{CRANK} kg*m^2"},
        },
        load={
            "gas": {"on": "piston", "sense": "active", "direction": "0 deg", "force": f"{-loads.force!r} N"},
            "work": {
                "on": "main", "torque": f"{loads.taken!r} N*m", "at_turning": f"{loads.speed / RATIO!r} rad/s",
                "exponent": EXPONENT,
            },
            "drop": {"on": "main", "sense": "active", "torque": f"{loads.driving!r} N*m"},
        },
        drive={"motor": {**MOTORS[name], "inertia": f"{ROTOR} kg*m^2"}, "stage": [{"ratio": RATIO}]},
    )  # fmt: skip


def piston_rate(angle, functions=math):
    """dx/dφ of the piston, at an angle by `math`, at many by NumPy. [m/rad]"""
    sine, cosine = functions.sin(angle), functions.cos(angle)
    return -RADIUS * sine - RADIUS**2 * sine * cosine / functions.sqrt(ROD**2 - (RADIUS * sine) ** 2)


def inertia(angle, functions=math):
    return CRANK + RATIO**2 * ROTOR + PISTON * piston_rate(angle, functions) ** 2


class Turn(NamedTuple):
    """A turn integrated from a speed on: pieces between corners, and what adds up over it."""

    pieces: list
    energy: float
    time: float
    work: float
    squares: float
    passed: set

    def speed(self, angle):
        """Of the crank, at ascending angles, shape (n,). [rad/s]"""
        of_piece = np.searchsorted([start for start, _, _ in self.pieces], angle, side="right") - 1
        energies = [self.pieces[n][2](angle[of_piece == n])[0] for n in np.unique(of_piece)]
        return np.sqrt(2 * np.concatenate(energies) / inertia(angle, np))


def integrated(motor, loads, first):
    """One turn from a first speed of the crank on, cut at every corner: up to it by the law on its near side."""
    numbers = motor.row(0)
    corners = np.array([0.0, *motor.corner_speeds(0)[motor.corner_speeds(0) > 0], np.inf])

    def motor_speed(angle, energy):
        return RATIO * math.sqrt(2 * energy / inertia(angle))

    def slopes(angle, state, low, high):
        turning = motor_speed(angle, float(state[0]))
        inside = min(max(turning, low * (1 + 1e-15)), high * (1 - 1e-15))
        torque, crank = motor.law.torque(inside, math.inf, numbers), turning / RATIO
        taken = loads.taken * (turning / loads.speed) ** EXPONENT - loads.driving
        gained = RATIO * torque - taken - loads.force * piston_rate(angle)
        return [gained, 1 / crank, RATIO * torque, torque**2 / crank]

    def reaching(corner, sign):
        def event(angle, state, _low, _high):
            return motor_speed(angle, float(state[0])) - corner if np.isfinite(corner) else -1.0

        event.terminal, event.direction = True, sign
        return event

    angle, state, pieces, passed = 0.0, [0.5 * inertia(0.0) * first**2, 0.0, 0.0, 0.0], [], set()
    place = int(np.searchsorted(corners, RATIO * first, side="right"))
    while angle < 2 * np.pi:
        low, high = corners[place - 1 : place + 1].tolist()
        found = solve_ivp(
            slopes, (angle, 2 * np.pi), state, method="DOP853", rtol=1e-12, atol=1e-12, dense_output=True,
            events=(reaching(low, -1.0), reaching(high, 1.0)), args=(low, high), first_step=1e-6, max_step=LONGEST_STEP,
        )  # fmt: skip
        assert found.success
        pieces.append((angle, float(found.t[-1]), found.sol))
        angle, state = float(found.t[-1]), found.y[:, -1].tolist()
        if found.status == 1:
            step = -1 if len(found.t_events[0]) else 1
            passed.add(low if step < 0 else high)
            place += step
    return Turn(pieces, *state, passed)


def corner_cases():
    """Every corner of every motor; of those whose law is smooth a cycle about a speed of their own."""
    return [(name, which) for name in MOTORS for which in (range(CORNERS[name]) if name in CORNERS else (None,))]


def test_every_motor_is_here_and_has_the_corners_that_are_crossed():
    for name in MOTORS:
        motor = motor_of(machine(name).drive.motor)
        assert motor.law.name == name
        assert np.count_nonzero(motor.corner_speeds(0) > 0) == CORNERS.get(name, 0), name


@pytest.mark.parametrize(("name", "which"), corner_cases())
def test_a_cycle_over_a_corner(name, which):
    motor = motor_of(machine(name).drive.motor)
    above = motor.corner_speeds(0)[motor.corner_speeds(0) > 0].tolist()
    corner = SMOOTH if which is None else above[which]
    loads = balanced_at(name, motor, corner)
    found = ct.run(machine(name, loads))
    speeds = np.ravel(found.drive_speed)
    turn = integrated(motor, loads, speeds[0])
    assert corner in turn.passed or which is None
    own = turn.speed(np.radians(np.arange(360.0)))
    torques = motor.torque(RATIO * own)[0]
    worst = np.max(np.abs(torques))
    assert np.max(np.abs(speeds / own - 1)) < AGREES
    assert np.max(np.abs(np.ravel(found.motor_torque) - torques)) < AGREES * worst
    assert np.sqrt(turn.energy / (0.5 * inertia(0.0))) == pytest.approx(speeds[0], rel=AGREES)
    assert float(found.cycle_time) == pytest.approx(turn.time, rel=AGREES)
    assert float(found.motor_power) == pytest.approx(turn.work / turn.time, rel=AGREES)
    assert float(found.rms_motor_torque) == pytest.approx(np.sqrt(turn.squares / turn.time), rel=AGREES)
    fine = np.linspace(0.0, 2 * np.pi, 7201)
    shown = motor.torque(RATIO * turn.speed(fine))[0]
    jumps = motor.torque(np.outer(sorted(turn.passed), [1 - 1e-12, 1 + 1e-12]).ravel())[0]
    assert float(found.largest_motor_torque) == pytest.approx(max([*shown, *jumps]), abs=1e-6 * worst)
    assert all(np.all(check.passed) for check in found.checks)


@pytest.mark.parametrize(("name", "corner"), [("table", 100.0), ("prime_mover", 105.0), ("servo", 100.0)])
def test_the_check_between_the_points_finds_a_corner_that_is_not_cut(name, corner, monkeypatch):
    """The energy over the cycle cannot: it holds at Gauss's points whatever lies between them."""
    monkeypatch.setattr(DeclaredMotor, "corner_speeds", lambda _motor, _design: np.empty(0))
    monkeypatch.setattr("cranktrain.questions.drive.settling._MOST_PIECES", 0)
    found = ct.run(machine(name, balanced_at(name, motor_of(machine(name).drive.motor), corner)))
    holds = {check.name: bool(np.all(check.passed)) for check in found.checks if check.name.startswith("drive")}
    assert holds == {"drive_energy": True, "drive_motion": False}
