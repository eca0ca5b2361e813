"""Random designs of all examples that the compiled cycle knows: how far its facts are from those of `run`.

    python benchmarks/random_cycles.py [--designs 1000] [--examples vaz_21213 3d12] [--spread 0.04] [--all]

Then designs whose two highest tops are nearly alike, and ten thousand that cannot be. Designs are drawn as
`tests/validation/test_compiled_cycle.py` draws twenty of each. Ends with status 1 where a fact is beyond what is
promised; `--all` prints every fact, and not the three that are farthest from `run` in parts of what they may be.
"""

import argparse
import math
import random
import sys
from pathlib import Path

import numpy as np

ROOT = Path(__file__).parents[1]
sys.path.insert(0, str(ROOT))

from tests.random_designs import (  # noqa: E402 - found on the path set above
    EXAMPLES,
    designs,
    facts_by_run,
    facts_of_both,
    most_apart,
    parts_apart,
)

# the project is imported below the path that the tests need
import cranktrain as ct  # noqa: E402 - below the path
from cranktrain.columns import in_columns  # noqa: E402 - below the path
from cranktrain.errors import InputError  # noqa: E402 - below the path
from cranktrain.study.cycle.road import CompiledWay, facts_of_cycles, way_to  # noqa: E402 - below the path

AT_ONCE = 50
"""Designs of one run."""
SHOWN = 3
GAPS = (1e-12, 1e-11, 1e-10, 1e-9, 1e-8, 1e-6, 1e-4)
"""By what part compression ratios of two cylinders differ; by what angle throws do. [1, rad]"""
N_ODD = 10_000
ODD = (*(1.0, 1.0, 1.0, 1.1, 0.7, 0.3, -1.0, 0.0), *(math.nan, math.inf, 1e-300, 1e-12, 1e3, 1e12, 1e300))
"""By what numbers are multiplied."""
ODD_NUMBERS = (
    ("mechanism.rod_length", (150.0, "mm")),
    ("mechanism.crank_radius", (45.0, "mm")),
    ("mechanism.offset", (3.0, "mm")),
    ("cylinder.bore", (80.0, "mm")),
    ("cylinder.compression_ratio", (10.0, "")),
    ("gas.cut_off_ratio", (1.3, "")),
    ("gas.pressure_ratio", (1.5, "")),
    ("gas.start_pressure", (1.0, "bar")),
    ("gas.expansion_exponent", (1.25, "")),
    ("shaft.main.speed", (3000.0, "rpm")),
    ("masses.piston.mass", (0.5, "kg")),
    ("evenness.coefficient", (0.01, "")),
)
"""Numbers of the single cylinder, as they are usually."""


def of_example(name: str, n_designs: int, spread: float, shows_all: bool) -> bool:
    """Compare random designs of an example; say whether all facts are as near as promised."""
    machines = designs(name, n_designs, spread)
    return compared(name, machines, facts_of_both(machines[0]), shows_all)


def compared(name: str, machines: list[ct.Machine], wanted: list[str], shows_all: bool, borne: float = 1.0) -> bool:
    """Compare designs of one machine and print how far the facts are apart."""
    way = way_to(machines[0], wanted)
    assert isinstance(way, CompiledWay)
    blocks = [machines[first : first + AT_ONCE] for first in range(0, len(machines), AT_ONCE)]
    found = [facts_of_cycles(in_columns(block * 2), 2 * len(block), way) for block in blocks]
    by_run = [facts_by_run(block, wanted) for block in blocks]
    known = np.concatenate([one.is_known[: len(block)] for one, block in zip(found, blocks, strict=True)])
    rows = []
    for fact in wanted:
        if found[0].entries[fact].unit == "deg":  # tops that are alike stand where rounding has them
            continue
        each = [
            parts_apart(fact, one.values[fact][: len(exact[fact])], exact)
            for one, exact in zip(found, by_run, strict=True)
        ]
        apart = np.where(known, np.concatenate(each), 0.0)
        place = int(np.flatnonzero(apart == np.max(apart))[0]) if np.all(np.isfinite(apart)) else -1
        rows.append((float(np.max(apart)) / most_apart(fact), float(np.max(apart)), fact, place))
    rows.sort(reverse=True, key=lambda row: row[0])
    print(f"{name}: {len(machines)} designs, {np.sum(~known)} left to run, {len(rows)} facts", flush=True)
    for share, apart, fact, place in rows if shows_all else rows[:SHOWN]:
        print(f"    {fact:44} {apart:8.1e}  design {place:4}  {'ok' if share <= borne else 'MISSED'}", flush=True)
    return all(share <= borne for share, *_row in rows)


def nearly_alike() -> bool:
    """Compare designs of which two tops are nearly alike, by their throws and by their cylinders.

    Of tops that differ by less than 1e-9 of the torque's largest size `run` gives the first, and not the highest: the
    smallest torque, which is a part of that size, may be farther apart.
    """
    alike = {f"cylinder.{one}.compression_ratio": 9.3 for one in "1234"}
    machine, facts = ct.load("vaz_21213").with_(alike), ["largest_torque", "smallest_torque", "largest_side_force"]
    rows = [
        row
        for gap in (0.0, *GAPS)
        for row in (
            {"shaft.main.throws": ["0 deg", "180 deg", "180 deg", f"{math.degrees(gap)!r} deg"]},
            *({f"cylinder.{one}.compression_ratio": 9.3 * (1.0 + gap)} for one in "14"),
        )
    ]
    machines = [machine.with_(row) for row in rows]
    return compared("tops that are nearly alike", machines, facts, shows_all=True, borne=2.0)


def cannot_be() -> bool:
    """Sweep numbers that are none, or beyond anything, among others; see that what `run` refuses has no fact."""
    chance, facts = random.Random("cannot be"), ["largest_torque", "peak_pressure", "flywheel_inertia", "swept_volume"]
    rows = [
        {path: written(chance.choice(ODD) * usual, unit) for path, (usual, unit) in chance.sample(ODD_NUMBERS, 3)}
        for _row in range(N_ODD)
    ]
    machine = ct.load(str(Path(__file__).with_name("single.toml")))
    found = ct.sweep(machine, rows, facts).found.values
    n_refused, wrong = 0, []
    for place, row in enumerate(rows):
        values = np.concatenate([np.ravel(found[fact][place]) for fact in facts])
        try:
            alone = ct.run(machine, set=row, quantities=facts)
            exact = np.concatenate([np.ravel(getattr(alone, fact)) for fact in facts])
        except InputError:
            n_refused += 1
            exact = np.full(len(values), np.nan)
        if not np.array_equal(np.isfinite(values), np.isfinite(exact)):
            wrong.append((row, values, exact))
    print(f"numbers that are none: {N_ODD} designs, {n_refused} refused by run, {len(wrong)} otherwise by the sweep")
    for row, values, exact in wrong[:SHOWN]:
        print(f"    {row}: {values}, by run {exact}")
    return not wrong


def written(number: float, unit: str) -> object:
    """A number as one types it."""
    return f"{number!r} {unit}" if unit else number


def main() -> int:
    """Compare and print; 1 where something is beyond what is promised."""
    options = argparse.ArgumentParser()
    options.add_argument("--designs", type=int, default=1000)
    options.add_argument("--examples", nargs="*", default=EXAMPLES)
    options.add_argument("--spread", type=float, default=0.04)
    options.add_argument("--all", action="store_true")
    asked = options.parse_args()
    kept = [of_example(name, asked.designs, asked.spread, asked.all) for name in asked.examples]
    kept += [nearly_alike(), cannot_be()]
    return 0 if all(kept) else 1


if __name__ == "__main__":
    sys.exit(main())
