"""Time of the reference start (a crank-rocker of 3 s) beside SciPy's `solve_ivp` with a right-hand side in Python.

    python benchmarks/starts.py

Both in processor time, in turn in one process, at the same error against a run of a thousandth of the tolerance; a
thousand starts on two threads by the wall, bare and of a machine file as `ct.start` gives them; a turn at steady speed
of machines from their files, one with gas; and of a start with a card of many rows.
"""

import json
import sys
from pathlib import Path
from time import perf_counter, process_time

import numpy as np
from scipy.integrate import solve_ivp
from timing import interleaved_ratio

ROOT = Path(__file__).parents[1]
sys.path.insert(0, str(ROOT))

from tests.starts import kernels, kloss, reference_drive  # noqa: E402 - found on the path set above
from tests.validation.test_start import reference  # noqa: E402 - found on the path set above

# the project is imported below the path that the tests need
import cranktrain as ct  # noqa: E402 - below the path
from cranktrain.questions.start.asked import StartAsked  # noqa: E402 - below the path
from cranktrain.questions.start.case import StartCases  # noqa: E402 - below the path
from cranktrain.questions.start.starting import run_start  # noqa: E402 - below the path
from cranktrain.study.start import over_time  # noqa: E402 - below the path
from cranktrain.transient.equation import DriveTrain, Kernels, no_brake, untimed  # noqa: E402 - below the path
from cranktrain.transient.reduced import (  # noqa: E402 - below the path
    filled_at,
    in_one_row,
    reduced_machine,
    settle,
)
from cranktrain.transient.runs import run, run_all, wanted  # noqa: E402 - below the path

LEAST_RATIO = 20.0
MOST_TIME, MOST_TIME_OF_ALL = 0.5e-3, 0.3
N_STARTS = 1000
TURNS = {"compressor_start": 120e-6, "jaw_crusher": 60e-6, "tilting_table": 60e-6}
"""Machines from their files, and how long a turn is to take, with gas and without. [s]"""
N_TURNS = 50
ROWS, MOST_TIME_OF_ROWS, MOST_OF_FEW = (360, 3600), 0.1, 12.0
"""Of a card; how long a turn of a start with the longer one may take, and in parts of the shorter. [s]"""


def by_hand(machine):
    """Right-hand side as one writes it: floats and formulas of the crank-rocker, nothing of the package."""
    from math import cos, sin, sqrt

    r, l, r1, d = (machine[f"{part}_length_m"] for part in ("crank", "coupler", "rocker", "ground"))
    mass, (along, across) = machine["coupler_mass_kg"], machine["coupler_com_m"]
    crank_mass, (ca, cb) = machine["crank_mass_kg"], machine["crank_com_m"]
    rocker_mass, (ra, rb) = machine["rocker_mass_kg"], machine["rocker_com_m"]
    own = machine["coupler_inertia_about_com_kgm2"]
    crank = machine["crank_inertia_about_com_kgm2"] + crank_mass * (ca * ca + cb * cb)
    rocker = machine["rocker_inertia_about_com_kgm2"] + rocker_mass * (ra * ra + rb * rb)
    ratio = machine["gear_ratio"]
    motor_inertia = machine["motor_rotor_inertia_kgm2"] * ratio * ratio
    motor = (machine["breakdown_torque_Nm"], machine["breakdown_slip"], machine["synchronous_speed_rad_s"])
    load, viscous, fall = machine["rocker_load_torque_Nm"], machine["rocker_viscous_Nms_per_rad"], 9.80665

    def rate(_time, state):
        phi, omega = state
        s, c = sin(phi), cos(phi)
        x, y = d - r * c, -r * s
        w = x * x + y * y
        k = (w + l * l - r1 * r1) / (2 * w)
        h = sqrt(l * l / w - k * k)
        px, py = k * x - h * y, k * y + h * x
        qx, qy = px - x, py - y
        area = px * qy - py * qx
        turn = r * (c * qy - s * qx) * -1 / area
        swing = r * (c * py - s * px) * -1 / area
        ux, uy = -r * c + 0 - turn * turn * px + swing * swing * qx, -r * s - turn * turn * py + swing * swing * qy
        turning = (ux * qx + uy * qy) / area * -1
        swinging = (ux * px + uy * py) / area * -1
        gx, gy = (along * px - across * py) / l, (along * py + across * px) / l
        vx, vy = -r * s - turn * gy, r * c + turn * gx
        ax = -r * c - turning * gy - turn * turn * gx
        ay = -r * s + turning * gx - turn * turn * gy
        inertia = crank + mass * (vx * vx + vy * vy) + own * turn * turn + rocker * swing * swing
        first = 2 * (mass * (vx * ax + vy * ay) + own * turn * turning + rocker * swing * swinging)
        weights = crank_mass * (ca * c - cb * s) + mass * vy + rocker_mass * (ra * qx - rb * qy) / r1 * swing
        given = (load - viscous * swing * omega) * swing - fall * weights
        driving = ratio * float(kloss(ratio * omega, motor))
        return [omega, (driving + given - 0.5 * first * omega * omega) / (motor_inertia + inertia)]

    return rate


def main():
    case = json.loads((ROOT / "tests/golden/startup_crank_rocker/case.json").read_text(encoding="utf-8"))
    drive, rate = reference_drive(case["machine"]), by_hand(case["machine"])
    asked = wanted(3.0, angle=0.3)
    exact = run(kernels(), drive, wanted(3.0, angle=0.3, tolerance=1e-12)).end[:2]
    ours = np.max(np.abs(run(kernels(), drive, asked).end[:2] - exact))
    missed = []
    print(f"{'':<10}{'ours':>10}{'theirs':>10}{'ratio':>8}{'our error':>12}{'theirs':>12}")
    for method in ("RK45", "DOP853", "LSODA"):
        tolerance = 1e-4
        while True:  # the coarsest tolerance that is as good as ours
            theirs = solve_ivp(rate, (0.0, 3.0), [0.3, 0.0], rtol=tolerance, atol=tolerance, method=method)
            error = np.max(np.abs(theirs.y[:, -1] - exact))
            if error <= ours or tolerance < 1e-12:
                break
            tolerance *= 0.7

        def other(method=method, tolerance=tolerance):
            return solve_ivp(rate, (0.0, 3.0), [0.3, 0.0], rtol=tolerance, atol=tolerance, method=method)

        timed = interleaved_ratio(lambda: run(kernels(), drive, asked), other, n_repetitions=11)
        print(
            f"{method:<10}{timed.ours * 1e3:7.3f} ms{timed.theirs * 1e3:7.1f} ms"
            f"{1 / timed.median:8.0f}{ours:12.1e}{error:12.1e}"
        )
        if 1 / timed.median < LEAST_RATIO or timed.ours > MOST_TIME:
            missed.append(method)
    times = []
    for _ in range(5):
        start = perf_counter()
        run_all(kernels(), [(drive, asked)] * N_STARTS)
        times.append(perf_counter() - start)
    print(f"{N_STARTS} starts on two threads: {min(times):.3f} s; by ct.start: {time_by_name():.3f} s")
    too_long = list[str]()
    for place, card in CARDS.items():
        few, many = (time_with_a_card(place, card(n)) for n in ROWS)
        too_long += [place] if many > MOST_TIME_OF_ROWS or many > MOST_OF_FEW * few else []
    too_long += [name for name, most in TURNS.items() if time_of_a_turn(name) > most]
    return len(missed) + (min(times) > MOST_TIME_OF_ALL) + len(too_long)


def time_by_name():
    """Of starts of the same machine from its file, with other rotors: what is declared is read, facts are taken. [s]"""
    machine, times = reference(), list[float]()
    inertias = np.linspace(0.010, 0.014, N_STARTS).tolist()
    for _ in range(4):  # the first of which compiles
        designs = [machine.with_({"drive.motor.inertia": f"{inertia!r} kg*m^2"}) for inertia in inertias]
        start = perf_counter()
        ct.start(designs)
        times.append(perf_counter() - start)
    return min(times)


def time_of_a_turn(name):
    """Of an example at its steady speed, on its reduced machine. [s]"""
    case = over_time(ct.load(name), [StartCases])[StartCases].each[0]
    motor = case.motor.law.kernel
    numbers = in_one_row(case.machine)
    filled_at(case.zero, numbers)
    kernels = Kernels(reduced_machine, untimed(motor), case.motor.heat, no_brake, settle)
    drive = DriveTrain(numbers, case.motor.row(0), 0.0, case.gearing)
    asked = wanted(
        N_TURNS * case.cycle_time,
        angle=case.zero, speed=case.steady_speed, corners=case.corners, period=case.cycle,
    )  # fmt: skip
    done = run(kernels, drive, asked)
    turns = (done.end[0] - case.zero) / (2 * np.pi)
    times = []
    for _ in range(11):
        start = process_time()
        run(kernels, drive, asked)
        times.append((process_time() - start) / turns)
    print(f"a turn of {name}: {min(times) * 1e6:.0f} µs, {done.n_steps / turns:.0f} steps")
    return min(times)


def card_over_angle(n):
    """Load on the shaft of so many rows."""
    angles = 360 * np.arange(n) / n
    torques = 20 + 15 * np.sin(np.radians(angles)) + 6 * np.sin(np.radians(3 * angles))
    return {
        "on": "main",
        "crank_angles": [f"{at:.6g} deg" for at in angles],
        "torque": [f"{m!r} N*m" for m in torques.tolist()],
    }


def card_over_travel(n):
    """Load on the piston of so many rows, there and back."""
    part = np.linspace(0, 1, n)
    out = 2000 + 1500 * np.sin(np.pi * part) + 300 * np.sin(3 * np.pi * part)
    return {
        "on": "piston",
        "sense": "resisting",
        "travel": [f"{s!r} mm" for s in (80 * part).tolist()],
        "force": [f"{f!r} N" for f in out.tolist()],
        "force_back": [f"{f!r} N" for f in (500 + 100 * np.sin(np.pi * part)).tolist()],
    }


CARDS = {"shaft": card_over_angle, "travel": card_over_travel}


def time_with_a_card(place, card):
    """A turn of a start, in plain Python as the command runs it, with a load of many rows. [s]"""
    n = len(card.get("crank_angles", card.get("travel")))
    machine = ct.Machine(
        shaft={"main": {"speed": "1440 rpm"}},
        mechanism={"kind": "slider_crank", "crank_radius": "40 mm", "rod_length": "150 mm"},
        masses={"piston": {"mass": "1 kg"}},
        load={"card": card},
        drive={
            "motor": {"kind": "cage", "size": "15 kW"},
            "part": {"wheel": {"on": "motor", "inertia": "0.5 kg*m^2"}},
        },
    )
    case = over_time(machine, [StartCases])[StartCases].each[0]
    start = process_time()
    found = run_start(case, StartAsked())
    turns = float(np.ptp(found.whole.crank_angle_turned)) / (2 * np.pi)
    taken = (process_time() - start) / turns
    print(
        f"a turn of a start with a card of {n} rows, {place}: {taken * 1e3:.1f} ms, {found.n_steps / turns:.0f} steps"
    )
    return taken


if __name__ == "__main__":
    sys.exit(main())
