"""Wall time of `cranktrain run 3d12`, beside that of Python alone and of the packages that it has to import.

    python benchmarks/start_up.py

Each is a process of its own, run once to warm the disk's cache and to compile the modules, as an installation does, and
then five times in turn; printed are the medians.
"""

import os
import statistics
import subprocess
import sys
from tempfile import TemporaryDirectory
from time import perf_counter

COMMANDS = {
    "cranktrain run 3d12": ["-m", "cranktrain", "run", "3d12"],
    "import numpy, pydantic": ["-c", "import numpy, pydantic"],
    "pass": ["-c", "pass"],
}
N_REPETITIONS = 5


def wall_time(arguments, environment):
    """Time of one process from start to end. [s]"""
    start = perf_counter()
    subprocess.run([sys.executable, *arguments], stdout=subprocess.DEVNULL, check=True, env=environment)
    return perf_counter() - start


def main():
    with TemporaryDirectory() as folder:
        # Without this an environment that forbids bytecode has every module compiled each time.
        environment = {**os.environ, "PYTHONPYCACHEPREFIX": folder, "PYTHONDONTWRITEBYTECODE": ""}
        for arguments in COMMANDS.values():
            wall_time(arguments, environment)
        times = {name: [] for name in COMMANDS}
        for _ in range(N_REPETITIONS):
            for name, arguments in COMMANDS.items():
                times[name].append(wall_time(arguments, environment))
    for name, measured in times.items():
        print(f"{name:<30}{statistics.median(measured):6.2f} s   {min(measured):.2f}–{max(measured):.2f}")


if __name__ == "__main__":
    main()
