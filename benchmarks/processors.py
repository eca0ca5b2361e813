"""What the terminal prints under the arithmetic of other processors, compared line by line.

    python benchmarks/processors.py                          # every example, some minutes
    python benchmarks/processors.py 3d12 shears              # these machines
    python benchmarks/processors.py --cores Haswell --threads 2

NumPy's linear algebra adds up in another order on each kind of processor, and another one with several threads:
numbers differ in their last digits. What is printed must not: a tie has one owner everywhere, and what is nothing but
rounding is 0. The residual of a check alone is left out: it measures the rounding itself, and what is compared is
whether the check holds. Ends with status 1 where a line differs, and shows it.
"""

import argparse
import json
import os
import re
import subprocess
import sys
from difflib import unified_diff
from importlib.resources import files
from itertools import product
from pathlib import Path
from typing import NamedTuple

CORES = ("SkylakeX", "Haswell", "Zen", "Prescott", "Sandybridge")
THREADS = (1, 2)
COMMANDS = ("run {}", "run {} --full", "textbook {}")
RESIDUAL = re.compile(r"residual [0-9.]+e[-+][0-9]+")


class Setting(NamedTuple):
    """A kind of processor by the name that OpenBLAS has for it, none for this one; and how many threads it takes."""

    core: str
    threads: int

    def __str__(self):
        return f"{self.core or 'this one'}, {self.threads} thread{'s' if self.threads > 1 else ''}"


def every_example():
    return sorted(
        file.name.removesuffix(".toml") for file in files("cranktrain.examples").iterdir() if ".toml" in file.name
    )


def texts_of(setting, names, commands=COMMANDS):
    """All that is printed of machines, by command, in a process of its own: which kind it is, BLAS asks once."""
    environment = os.environ | {
        "OPENBLAS_CORETYPE": setting.core,
        "OPENBLAS_NUM_THREADS": str(setting.threads),
        "LANGUAGE": "en",
        "COLUMNS": "160",
        "NO_COLOR": "1",
    }
    typed = [command.format(name) for name in names for command in commands]
    done = subprocess.run(
        [sys.executable, str(Path(__file__).with_name("printed.py"))],
        env=environment,
        input=json.dumps(typed),
        capture_output=True,
        text=True,
        check=True,
    )
    return json.loads(done.stdout)


def differences(texts, other, setting, other_setting):
    """Lines that differ, with the command above them."""
    for command, text in texts.items():
        lines, others = (RESIDUAL.sub("residual …", each).splitlines() for each in (text, other[command]))
        found = unified_diff(lines, others, str(setting), str(other_setting), n=0, lineterm="")
        changed = [line for line in found if not line.startswith("@@")]
        if changed:
            yield "\n".join([f"$ cranktrain {command}", *changed])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="*", help="examples or files of machines; every example")
    parser.add_argument("--cores", nargs="+", default=CORES, help="names that OpenBLAS has for kinds of processors")
    parser.add_argument("--threads", nargs="+", type=int, default=THREADS)
    given = parser.parse_args()
    names = given.names or every_example()
    first, *others = (Setting(*each) for each in product(given.cores, given.threads))
    texts, n_found = texts_of(first, names), 0
    for other in others:
        found = list(differences(texts, texts_of(other, names), first, other))
        print(f"{other}: {len(found) or 'no'} of {len(texts)} texts differ from {first}", flush=True)
        print("".join(f"{one}\n" for one in found), end="")
        n_found += len(found)
    return int(n_found > 0)


if __name__ == "__main__":
    sys.exit(main())
