"""Time of `cranktrain run 3d12` and of shorter commands, beside that of Python alone and of packages it has to import.

    python benchmarks/start_up.py

Each is a process of its own, run once to warm the disk's cache and to compile the modules, as an installation does, and
then eleven times in turn; printed are the medians of the wall's time and of the processors', which a busy machine
swings less.
"""

import os
import resource
import statistics
import subprocess
import sys
from tempfile import TemporaryDirectory
from time import perf_counter

COMMANDS = {
    "cranktrain run 3d12": ["-m", "cranktrain", "run", "3d12"],
    "cranktrain check 3d12": ["-m", "cranktrain", "check", "3d12"],
    "cranktrain list kinds": ["-m", "cranktrain", "list", "kinds"],
    "cranktrain --help": ["-m", "cranktrain", "--help"],
    "import numpy, pydantic": ["-c", "import numpy, pydantic"],
    "pass": ["-c", "pass"],
}
N_REPETITIONS = 11


def times_of(arguments, environment):
    """Times of one process from start to end, by the wall and of the processors. [s]"""
    start, used = perf_counter(), processor_time()
    subprocess.run([sys.executable, *arguments], stdout=subprocess.DEVNULL, check=True, env=environment)
    return perf_counter() - start, processor_time() - used


def processor_time():
    """What all processes that have ended took of the processors. [s]"""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def main():
    with TemporaryDirectory() as folder:
        # Without this an environment that forbids bytecode has every module compiled each time.
        environment = {**os.environ, "PYTHONPYCACHEPREFIX": folder, "PYTHONDONTWRITEBYTECODE": ""}
        for arguments in COMMANDS.values():
            times_of(arguments, environment)
        times = {name: [] for name in COMMANDS}
        for _ in range(N_REPETITIONS):
            for name, arguments in COMMANDS.items():
                times[name].append(times_of(arguments, environment))
    print(f"{'':<30}{'wall':>8}{'min–max':>15}{'processor':>13}")
    for name, measured in times.items():
        wall, processor = zip(*measured, strict=True)
        spread = f"{min(wall):.2f}–{max(wall):.2f}"
        print(f"{name:<30}{statistics.median(wall):6.2f} s{spread:>15}{statistics.median(processor):11.2f} s")


if __name__ == "__main__":
    main()
