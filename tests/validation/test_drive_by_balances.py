"""An offset press in inches and pounds behind a belt and two gears: its cycle and its start by balances of power.

Nothing of the program is in it: positions from the right triangle of rod and offset, slopes by complex steps, the
inertia from the kinetic energy, losses by trying all eight ways in which three stages may pass power on, over the
angle and over the time by SciPy's DOP853. Sizing in S6 by the temperature of one body that comes again.
"""

import itertools
import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

import cranktrain as ct

INCH, POUND, POUND_FORCE, HORSE, RPM = 0.0254, 0.45359237, 4.4482216152605, 745.69987158227022, math.pi / 30
ROUND = POUND * (12 * INCH) ** 2  # lb·ft²
RADIUS, ROD, OFFSET = 3 * INCH, 19 * INCH, 0.75 * INCH
RAM, ROD_MASS, CRANK_MASS = 1150 * POUND, 160 * POUND, 410 * POUND
IDLE, PRESSING = 200 * POUND_FORCE, 60000 * POUND_FORCE
FIELD, RATED = 1800 * RPM, 20 * HORSE / (1740 * RPM)
SLIP = (2.4 + math.sqrt(2.4**2 - 1)) / 30
DRAG = 0.6 * POUND_FORCE * 12 * INCH
ROTOR = (2.1 + 90 / 4) * ROUND
STAGES = (  # ratio, efficiency, efficiency back, drag at the input, inertia behind
    (2.6, 0.95, 2 - 1 / 0.95, 0.0, 30 * ROUND),
    (4.2, 0.97, 0.96, 0.0, 0.0),
    (3.7, 0.965, 2 - 1 / 0.965, DRAG, 900 * ROUND),
)
RATIO = math.prod(stage[0] for stage in STAGES)
FAR, NEAR = math.asin(OFFSET / (RADIUS + ROD)), math.pi + math.asin(OFFSET / (ROD - RADIUS))
HIGHEST = math.sqrt((ROD - RADIUS) ** 2 - OFFSET**2)


def table(**start):
    return {
        "name": "an offset press",
        "rotation": "clockwise",
        "angle": "180 deg",
        "gravity": True,
        "shaft": {"main": {"speed": "44 rpm"}},
        "mechanism": {"kind": "slider_crank", "crank_radius": "3 in", "rod_length": "19 in", "offset": "0.75 in"},
        "masses": {
            "crank": {"mass": "410 lb", "along": "0.5 in", "inertia": "95 lb*ft^2"},
            "rod": {"mass": "160 lb", "along": "6 in", "across": "0.4 in", "inertia": "70 lb*ft^2"},
            "piston": {"mass": "1150 lb"},
        },
        "load": {
            "forming": {
                "on": "piston",
                "travel": ["0 in", "4.5 in", "5.5 in", "7 in"],
                "force": ["200 lbf", "200 lbf", "60000 lbf", "60000 lbf"],
                "force_back": ["200 lbf"] * 4,
            }
        },
        "drive": {
            "motor": {
                "kind": "cage",
                "power": "20 hp",
                "speed": "1740 rpm",
                "synchronous_speed": "1800 rpm",
                "breakdown_ratio": 2.4,
                "starting_ratio": 1.9,
                "pull_up_ratio": 1.6,
                "inertia": "2.1 lb*ft^2",
            },
            "stage": [
                {"kind": "belt", "ratio": 2.6, "efficiency": 0.95},
                {"kind": "gear", "ratio": 4.2, "efficiency": 0.97, "efficiency_back": 0.96},
                {"kind": "gear", "ratio": 3.7, "efficiency": 0.965, "drag": "0.6 lbf*ft"},
            ],
            "part": {
                "flywheel": {"on": "motor", "flywheel_moment": "90 lb*ft^2"},
                "sheave": {"on": 1, "inertia": "30 lb*ft^2"},
                "bull": {"on": 3, "inertia": "900 lb*ft^2"},
            },
            "duty": {
                "kind": "S6",
                "duty_factor": "25 %",
                "cycle_time": "8 min",
                "thermal_time_constant": "22 min",
                "constant_losses": 0.3,
                "lowest_voltage": 0.92,
            },
            "start": start,
        },
    }


def places(angle):
    """Along and across the stroke: centroids of crank and rod, and the ram; the rod's direction. Takes complex φ."""
    sin, cos = np.sin(angle), np.cos(angle)
    x, y = RADIUS * cos, RADIUS * sin
    run = np.sqrt(ROD**2 - (y - OFFSET) ** 2)
    u, v = run / ROD, (OFFSET - y) / ROD
    rod = (x + 6 * INCH * u - 0.4 * INCH * v, y + 6 * INCH * v + 0.4 * INCH * u)
    return np.array([0.5 * INCH * cos, 0.5 * INCH * sin, *rod, x + run]), u, v


def slopes(angle):
    """Of the places, and of the rod's direction; x′ and θ′ by complex steps."""
    step = 1e-30
    there, u, v = places(angle + 1j * step)
    return there.imag / step, (v.imag * u.real - u.imag * v.real) / step, there.real[-1]


def machine(angle):
    """Inertia and torque of load and weight at the crank as it turns forward."""
    (cx, cy, rx, ry, ram), turn, place = slopes(angle)
    inertia = CRANK_MASS * (cx**2 + cy**2) + ROD_MASS * (rx**2 + ry**2) + RAM * ram**2 + (95 + 70 * turn**2) * ROUND
    weight = 9.80665 * (CRANK_MASS * cx + ROD_MASS * rx + RAM * ram)  # x points downward
    way = (place - HIGHEST) / INCH
    force = IDLE + (PRESSING - IDLE) * min(1.0, max(0.0, way - 4.5)) if ram > 0 else IDLE
    return inertia, force * abs(ram) - weight


def inertia_slope(angle, width=1e-4):
    """J′ by central differences of two widths, Richardson's way."""
    one, two = ((machine(angle + h)[0] - machine(angle - h)[0]) / (2 * h) for h in (width, 2 * width))
    return (4 * one - two) / 3


def motor(speed):
    slip = 1 - speed / FIELD
    if slip <= SLIP:
        return 2.4 * RATED * 2 * slip * SLIP / (slip**2 + SLIP**2)
    if slip < 0.8:
        x = (slip - SLIP) / (0.8 - SLIP)
        return RATED * (2.4 - 0.8 * x * x * (3 - 2 * x))
    x = (slip - 0.8) / 0.2
    return RATED * (1.6 + 0.3 * x * x * (1.5 - 0.5 * x))


def turned(angle, speed):
    """Acceleration of the crank, and what stages lose by the crank's angle: the way that suits itself."""
    inertia, load = machine(angle)
    load += 0.5 * inertia_slope(angle) * speed**2
    for forward in itertools.product((True, False), repeat=len(STAGES)):
        a, b, fast, passed = inertia, load, 1.0, []
        for (ratio, eta, back, drag, own), is_forward in zip(STAGES[::-1], forward, strict=True):
            a += own * fast
            share = 1 / eta if is_forward else back
            passed.append((a, b, share, fast, is_forward))
            a, b, fast = a * share / ratio, b * share / ratio + drag, fast * ratio
        grown = (motor(speed * RATIO) - b) / (a + ROTOR * RATIO)
        if all((a * grown + b >= 0) == is_forward for a, b, _, _, is_forward in passed):
            lost = sum((a * grown + b) * (share - 1) * fast for a, b, share, fast, _ in passed)
            return grown, lost + DRAG * STAGES[2][0]
    raise AssertionError


def corners():
    """Of the load: dead centres, and where the blank is met and in full press."""
    met = [
        brentq(lambda at, way=way: places(at)[0][-1] - HIGHEST - way * INCH, NEAR, FAR + 2 * math.pi)
        for way in (4.5, 5.5)
    ]
    return [FAR, NEAR, *met, FAR + 2 * math.pi]


@pytest.fixture(scope="module")
def found():
    return ct.run(table())


def test_a_cycle(found):
    """From the program's speed at the far dead centre the cycle comes back to it; its means and extremes."""

    def rates(angle, y):
        speed = math.sqrt(2 * y[0])
        grown, lost = turned(angle, speed)
        torque = motor(speed * RATIO)
        return [grown, 1 / speed, torque**2 / speed, torque * RATIO, lost]

    # the speed at the far dead centre, by going there from the grid's first angle
    state = np.array([0.5 * float(found.drive_speed[0]) ** 2, 0, 0, 0, 0])
    begin, kept = 1e-13, []
    for end in [*corners()[:-1], 2 * math.pi]:
        piece = solve_ivp(
            rates, (begin, end - 1e-13), state, method="DOP853", rtol=1e-11, atol=1e-12, dense_output=True
        )
        kept.append(piece.sol(np.linspace(begin, end - 1e-13, 4001))[0])
        begin, state = end + 1e-13, piece.y[:, -1]
    half, period, squares, work, lost = state
    speeds = np.sqrt(2 * np.concatenate(kept))
    torques = [motor(float(one)) for one in (RATIO * speeds.min(), RATIO * speeds.max())]
    assert math.sqrt(2 * half) == pytest.approx(found.drive_speed[0], rel=1e-9)
    assert found.cycle_time == pytest.approx(period, rel=1e-9)
    assert found.rms_motor_torque == pytest.approx(math.sqrt(squares / period), rel=1e-9)
    assert found.motor_power == pytest.approx(work / period, rel=1e-9)
    assert found.lost_power == pytest.approx(lost / period, rel=1e-9)
    assert found.drive_fluctuation == pytest.approx(np.ptp(speeds) * period / (2 * math.pi), rel=1e-7)
    assert (found.largest_motor_torque, found.smallest_motor_torque) == pytest.approx(torques, abs=1e-7 * torques[0])


def test_sizing_in_s6(found):
    """A body that comes to the same temperature every eight minutes, at most to that of rated load for ever."""
    load, rest = math.exp(-2 / 22), math.exp(-6 / 22)

    def hottest(factor):
        heating = 0.3 + 0.7 * factor**2
        return (heating * (1 - load) + load * 0.3 * (1 - rest)) / (1 - load * rest)

    factor = brentq(lambda factor: hottest(factor) - 1, 1, 5)
    effective, largest = found.sizing_share[0, :2]
    assert effective == pytest.approx(float(found.rms_motor_torque) / (factor * RATED), rel=1e-9)
    assert largest == pytest.approx(float(found.largest_motor_torque) / (0.92**2 * 2.4 * RATED), rel=1e-9)


def test_a_start():
    """Through the first stroke, from rest behind the lower dead centre: dead position, energies and end."""
    begin = FAR + math.radians(20)
    run = ct.start(table(angle=f"{begin!r} rad", duration="2 s", interval="0.1 s", tolerance=1e-11))

    def rates(_time, y):
        grown, lost = turned(y[0], y[1])
        torque = motor(y[1] * RATIO) * RATIO
        return [y[1], grown, torque * y[1], lost * y[1]]

    def reached(_time, y):
        return y[0] - NEAR

    reached.terminal, reached.direction = True, 1
    how = {"method": "DOP853", "rtol": 1e-11, "atol": 1e-12}
    first = solve_ivp(rates, (0, 2.0), [begin, 0, 0, 0], events=reached, **how)
    last = solve_ivp(rates, (first.t[-1], 2.0), first.y[:, -1] + np.array([1e-13, 0, 0, 0]), **how)
    dead = next(event.time for event in run.events if str(event.name) == "dead position")
    assert dead == pytest.approx(first.t[-1], abs=1e-8)
    ends = (run.crank_angle_turned, run.crank_speed, run.motor_work, run.lost_work)
    # losses have kinks where stages turn round, which both step over as closely as their tolerances ask
    for curve, own, close in zip(ends, last.y[:, -1], (1e-8, 1e-8, 1e-8, 1e-7), strict=True):
        assert curve[-1] == pytest.approx(own, rel=close)
