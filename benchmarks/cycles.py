"""The compiled cycle against a program by hand in C++, in turn, in processor time.

    python benchmarks/cycles.py [--designs 20000] [--pairs 7]

`cycle_720.cpp` has the same cylinder on 720 equal angles, unrefined: its largest torque is off by 3e-4. It is
compiled with g++, where there is one. See README.md beside this file.
"""

import argparse
import statistics
import subprocess
import tempfile
from pathlib import Path
from time import process_time

import numpy as np

import cranktrain as ct
from cranktrain.columns import in_columns
from cranktrain.study.cycle import road
from cranktrain.study.cycle.road import facts_of_cycles, way_to

SINGLE = ct.Machine(
    mechanism={"kind": "slider_crank", "crank_radius": "45 mm", "rod_length": "150 mm"},
    shaft={"main": {"speed": "350 rad/s"}},
    cylinder={"bore": "80 mm", "compression_ratio": 10.0, "cycle": "four-stroke", "firing_order": "1"},
    masses={"piston": {"mass": "0.5 kg"}, "rod": {"big_end": "0.4 kg", "small_end": "0.2 kg"}},
    gas={
        "kind": "dual",
        "start_pressure": "1 bar",
        "compression_exponent": 1.36,
        "expansion_exponent": 1.25,
        "pressure_ratio": 1.5,
        "cut_off_ratio": 1.3,
    },
    evenness={"flywheel": "1 kg*m^2", "coefficient": 0.01},
)
V12 = ct.load("3d12")
CASES = (
    ("single, torque", SINGLE, ("largest_torque", "smallest_torque"), 1),
    ("single, flywheel", SINGLE, ("largest_torque", "flywheel_inertia", "coefficient_of_fluctuation"), 1),
    ("V12, torque", V12, ("largest_torque", "smallest_torque"), 10),
)
"""Machine, facts, and of how many fewer designs."""


def by_hand(folder: Path) -> Path | None:
    """Compile the program by hand; None without a compiler."""
    program, source = folder / "cycle_720", Path(__file__).with_name("cycle_720.cpp")
    try:
        line = ["g++", "-O3", "-march=native", "-ffast-math", "-o", str(program), str(source)]
        subprocess.run(line, check=True)
    except FileNotFoundError:
        return None
    return program


def ours(machine, facts, n_designs):
    """Give a function that tells how long a design takes: in the loop, and in all. [µs]"""
    rods = [machine.with_({}) for _each in range(2)]
    together = in_columns((rods * ((n_designs + 1) // 2))[:n_designs])
    way, inside = way_to(machine, facts), []
    whole = road.loaded_loops

    def timed(written):
        module = whole(written)

        class Timed:
            def __getattr__(self, name):
                def called(*given):
                    start = process_time()
                    getattr(module, name)(*given)
                    inside.append(process_time() - start)

                return called

        return Timed()

    def measured():
        inside.clear()
        road.loaded_loops = timed
        start = process_time()
        facts_of_cycles(together, n_designs, way)
        both = sum(inside), process_time() - start
        road.loaded_loops = whole
        return [1e6 * seconds / n_designs for seconds in both]

    measured()
    return measured


def main() -> None:
    """Measure in turn and print."""
    options = argparse.ArgumentParser()
    options.add_argument("--designs", type=int, default=20_000)
    options.add_argument("--pairs", type=int, default=7)
    asked = options.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        program = by_hand(Path(folder))
        each = [(name, ours(machine, facts, asked.designs // fewer)) for name, machine, facts, fewer in CASES]
        rows: dict[str, list[list[float]]] = {name: [] for name, _measured in each}
        hands: list[float] = []
        for _pair in range(asked.pairs):
            if program is not None:
                said = subprocess.run([str(program), "100000"], check=True, capture_output=True, text=True).stdout
                hands.append(float(said.split()[0]))
            for name, measured in each:
                rows[name].append(measured())
    hand = statistics.median(hands) if hands else float("nan")
    print(f"{'by hand, 720 angles':22} {hand:8.2f} µs")
    for name, found in rows.items():
        loop, whole = np.median(np.array(found), axis=0)
        print(f"{name:22} {loop:8.2f} µs, {loop / hand:5.2f} of it; with its stages {whole:8.2f} µs")


if __name__ == "__main__":
    main()
