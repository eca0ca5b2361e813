"""The compiled cycle against two programs by hand in C++, in turn, in processor time.

    python benchmarks/cycles.py [--designs 20000] [--pairs 7]

`cycle_720.cpp` has the same cylinder on 720 equal angles, unrefined; `cycle_panels.cpp` on panels, its tops refined.
Both are compiled with g++; without it there is nothing to compare with, and the times stand alone. See README.md beside
this file.
"""

import argparse
import statistics
import subprocess
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path
from time import process_time
from typing import NamedTuple

import cranktrain as ct
from cranktrain.columns import in_columns
from cranktrain.study.cycle import road
from cranktrain.study.cycle.road import CompiledWay, facts_of_cycles, way_to

SINGLE = ct.load(str(Path(__file__).with_name("single.toml")))
V12 = ct.load("3d12")
CASES = (
    ("single, torque", SINGLE, ("largest_torque", "smallest_torque"), 1),
    ("single, flywheel", SINGLE, ("largest_torque", "flywheel_inertia", "coefficient_of_fluctuation"), 1),
    ("V12, torque", V12, ("largest_torque", "smallest_torque"), 10),
)
"""Machine, facts, and of how many fewer designs."""
PROGRAMS = {"cycle_720": 1e-3, "cycle_panels": 1e-9}
"""By hand, and by what part their largest torque may be off."""
LIMITS = (
    ("single, torque", "cycle_720", 1.75),
    ("single, torque", "cycle_panels", 1.3),
    ("V12, torque", "single, torque", 10.0),
)
"""Loops, in parts of what else is timed."""
N_BY_HAND = 100_000


class Measured(NamedTuple):
    """Processor time of a design, in the loop and in all. [µs]"""

    loop: float
    whole: float


class ByHand(NamedTuple):
    """What a program by hand prints: processor time of a design [µs], largest torque of the first one [N·m]."""

    time: float
    largest_torque: float


def compiled_by_hand(name: str, folder: Path) -> Path | None:
    """Compile a program by hand; None without a compiler."""
    program, source = folder / name, Path(__file__).with_name(f"{name}.cpp")
    try:
        line = ["g++", "-O3", "-march=native", "-ffast-math", "-o", str(program), str(source)]
        subprocess.run(line, check=True)
    except FileNotFoundError:
        return None
    return program


def by_hand(program: Path) -> ByHand:
    """Run a program by hand."""
    line = [str(program), str(N_BY_HAND)]
    said = subprocess.run(line, check=True, capture_output=True, text=True).stdout.split()
    return ByHand(float(said[0]), float(said[1]))


def ours(machine: ct.Machine, facts: tuple[str, ...], n_designs: int) -> Callable[[], Measured]:
    """Give a function that tells how long a design takes."""
    rods = [machine.with_({}) for _each in range(2)]
    together = in_columns((rods * ((n_designs + 1) // 2))[:n_designs])
    way, inside = way_to(machine, facts), []
    assert isinstance(way, CompiledWay)
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

    def measured() -> Measured:
        inside.clear()
        road.loaded_loops = timed
        start = process_time()
        facts_of_cycles(together, n_designs, way)
        both = sum(inside), process_time() - start
        road.loaded_loops = whole
        return Measured(*(1e6 * seconds / n_designs for seconds in both))

    measured()
    return measured


def check(programs: dict[str, Path]) -> None:
    """See that what is compared gives the same."""
    exact = float(ct.run(SINGLE, quantities=["largest_torque"]).largest_torque)
    for name, program in programs.items():
        apart = abs(by_hand(program).largest_torque - exact) / exact
        if not apart <= PROGRAMS[name]:
            raise ArithmeticError(f"{name}: its largest torque is {apart:.1e} off")
        print(f"{name:18} largest torque off by {apart:.0e}")


def are_kept(times: dict[str, list[float]]) -> bool:
    """Print ratios, the medians of all turns, with what is asked of them; say whether all are kept."""
    all_kept = True
    for one, other, limit in LIMITS:
        if other not in times:
            continue
        ratio = statistics.median(a / b for a, b in zip(times[one], times[other], strict=True))
        good = ratio <= limit
        all_kept &= good
        print(f"{one:18} over {other:18} {ratio:6.2f}, at most {limit:5.2f}: {'ok' if good else 'MISSED'}")
    return all_kept


def main() -> int:
    """Measure in turn and print; 1 where a limit is missed."""
    options = argparse.ArgumentParser()
    options.add_argument("--designs", type=int, default=20_000)
    options.add_argument("--pairs", type=int, default=7)
    asked = options.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        compiled = {name: compiled_by_hand(name, Path(folder)) for name in PROGRAMS}
        programs = {name: program for name, program in compiled.items() if program is not None}
        check(programs)
        each = {name: ours(machine, facts, asked.designs // fewer) for name, machine, facts, fewer in CASES}
        times: dict[str, list[float]] = {name: [] for name in (*programs, *each)}
        wholes: dict[str, list[float]] = {name: [] for name in each}
        for _turn in range(asked.pairs):
            for name, program in programs.items():
                times[name].append(by_hand(program).time)
            for name, measured in each.items():
                found = measured()
                times[name].append(found.loop)
                wholes[name].append(found.whole)
    for name, found in times.items():
        stages = f"; with its stages {statistics.median(wholes[name]):8.2f} µs" if name in wholes else ""
        print(f"{name:18} {statistics.median(found):8.2f} µs{stages}")
    return 0 if are_kept(times) else 1


if __name__ == "__main__":
    sys.exit(main())
