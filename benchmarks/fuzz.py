"""Random machine files through the commands: whatever a file says, a user gets an answer or a sentence.

    nice python benchmarks/fuzz.py --files 30000 --keep found
    nice python benchmarks/fuzz.py --smallest

Each file is made from its number, so that a finding comes again with `--first NUMBER --files 1`. What is no answer (a
status other than 0 and 2, a warning of Python or NumPy, a NaN shown, a command that does not end in its time or takes
more memory than any should) is told
once for each place, with a file that shows it made shorter, which is kept. Ends with status 1 if there is any. With
`--smallest` the files are each table alone and each example without one of its parts, and every command is typed.
"""

import argparse
import contextlib
import gc
import os
import re
import resource
import sys
import tempfile
import time
from collections import Counter
from functools import cache
from pathlib import Path
from unittest import mock

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
ROOT = Path(__file__).parents[1]
sys.path[:0] = [str(ROOT), str(ROOT / "src")]

import random  # noqa: E402 - below the path

from random_machines import machine, mended, without  # noqa: E402 - below the path
from tests import smallest_files as every  # noqa: E402 - below the path
from tests.answers import answered  # noqa: E402 - below the path
from tests.machine_text import toml  # noqa: E402 - below the path
from tests.smallest_files import examples_taken_apart, smallest_files  # noqa: E402 - below the path
from typer.main import get_command  # noqa: E402 - below the path

from cranktrain.errors import InputError  # noqa: E402 - below the path
from cranktrain.io.machine_file import read_machine  # noqa: E402 - below the path
from cranktrain.viz import PICTURES  # noqa: E402 - below the path

SHEETS = [one.name for one in PICTURES if one.kind == "sheet"]
PLANS = [one.name for one in PICTURES if one.kind == "plan"]
LONGEST = 60.0
"""A command ends within this; a stroke of the most steps takes half of it. [s]"""
MOST_MENDS = 15
MOST_MEMORY = 4 * 1024**3
"""No command takes as much. [byte]"""
FILES_A_LINE = 1000
"""After so many files it is said how far it is."""
MOST_STEPS = 1000
"""Of a start."""


def commands(seed: int, path: str, tables: dict) -> list[list[str]]:
    """What is typed of one file: `run` or `check`, which both compute all that the file allows, and others of some."""
    any_ = random.Random(seed + 1)
    out = str(Path(path).with_suffix(""))
    asked = []
    if any_.random() < 0.35:
        asked.append(["check", path])
    else:
        extra = any_.choice(
            ([], [], ["--full"], ["--inputs"], ["--missing"], ["--partial"], ["--running-speed"], ["--step", "30"])
        )
        suffix = any_.choice(("csv", "json", "json"))
        extra = extra + (["-o", f"{out}.{suffix}", "--force"] if any_.random() < 0.15 else [])
        asked.append(["run", path, *extra])
    if "drive" in tables and any_.random() < 0.35:
        asked.append(["start", path, *any_.choice(([], ["--full"], ["-o", f"{out}.json", "--force"]))])
    if any_.random() < 0.03:
        what = any_.choice((["--sheet", any_.choice(SHEETS)], ["--plan", any_.choice(PLANS)]))
        asked.append(["plot", path, "-o", f"{out}.svg", "--force", *what])
    if any_.random() < 0.06:
        what = any_.choice(([], ["--table"], ["--forces", "N"], ["--forces", "bar"], ["--harmonics"]))
        asked.append(["textbook", path, *what])
        if "crankshaft" in tables:
            asked.append(["textbook", "--throw", path])
        if tables.get("mechanism", {}).get("kind") == "crank_rocker":
            asked.append(["textbook", "--drive", path])
    return asked


def shrunk(tables: dict, still, until: float) -> dict:
    """Leave out of a file, key by key, what the finding does not need."""
    is_less = True
    while is_less:
        is_less = False
        for path in _places(tables):
            if time.monotonic() > until:
                return tables
            trial = without(tables, path)
            if still(trial):
                tables, is_less = trial, True
                break
    return tables


def _places(table, path=()):
    """Paths of all that may be left out, the large before the small."""
    items = table.items() if isinstance(table, dict) else enumerate(table) if isinstance(table, list) else ()
    items = list(items)
    for key, _value in items:
        yield (*path, key)
    for key, value in items:
        yield from _places(value, (*path, key))


def possible(tables: dict, path: Path) -> dict:
    """The file without what its messages call wrong, as far as that goes."""
    for _ in range(MOST_MENDS):
        path.write_text(toml(tables), encoding="utf-8")
        try:
            read_machine(str(path))
        except InputError as error:
            less = mended(tables, [one.path for one in error.problems])
            if less is None:
                return tables
            tables = less
        except Exception:  # whatever it is, the commands will tell of it
            return tables
        else:
            return tables
    return tables


@contextlib.contextmanager
def many_commands():
    """What pays for thousands of commands: Typer makes its tree of what may be typed once, and starts end sooner.

    A start of the most steps takes as long as a hundred others, and shows no more.
    """
    gc.collect()
    gc.freeze()
    with (
        mock.patch("typer.main.get_command", cache(get_command)),
        mock.patch("cranktrain.questions.start.starting.MOST_STEPS", MOST_STEPS),
    ):
        yield


def signature(fault: str, command: str) -> str:
    """A fault without its numbers, by which like ones are known; of a wait with its command."""
    kind = fault.partition(": shows")[0]
    if fault.startswith("not done"):
        return f"{command}: {kind}"
    return re.sub(r"[-+\d.e]+(?=\b)", "#", kind) if fault.startswith("shows") else kind


def every_command() -> int:
    """Type every command on every smallest file, and ask every example without a part for all results."""
    found = Counter()
    whole = ("run", "FILE", "--step", "30", "-o", "out.json", "--force")
    asked = [(name, text, one) for name, text in smallest_files().items() for one in every.commands().values()]
    asked += [(name, toml(tables), whole) for name, tables in examples_taken_apart()]
    with tempfile.TemporaryDirectory() as folder, contextlib.chdir(folder), many_commands():
        for name, text, command in asked:
            Path("machine.toml").write_text(text, encoding="utf-8")
            arguments = ["machine.toml" if one == "FILE" else one for one in command]
            fault = answered(arguments, longest=LONGEST).fault
            if fault:
                kind = signature(fault, arguments[0])
                found[kind] += 1
                if found[kind] == 1:
                    print(f"{name}: {' '.join(arguments)}\n  {fault}", flush=True)
    print(f"{len(asked)} commands, {sum(found.values())} findings")
    return 1 if found else 0


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--files", type=int, default=1000)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--minutes", type=float, default=float("inf"), help="end after so many, if files are left")
    parser.add_argument("--keep", type=Path, default=None, help="folder for files with findings")
    parser.add_argument("--shrink", type=float, default=20.0, help="seconds for making a file shorter")
    parser.add_argument("--smallest", action="store_true", help="every command on every smallest file instead")
    parser.add_argument("--show", action="store_true", help="say what each command answers")
    asked = parser.parse_args()
    resource.setrlimit(resource.RLIMIT_AS, (MOST_MEMORY, MOST_MEMORY))
    if asked.smallest:
        return every_command()
    found, statuses = Counter(), Counter()
    began = time.monotonic()
    with tempfile.TemporaryDirectory() as folder, many_commands():
        path = Path(folder) / "machine.toml"
        n_files = 0
        for seed in range(asked.first, asked.first + asked.files):
            if time.monotonic() - began > 60 * asked.minutes:
                break
            if n_files and n_files % FILES_A_LINE == 0:
                print(f"{n_files} files, {sum(found.values())} findings so far", flush=True)
            n_files += 1
            raw = machine(seed)
            tables = possible(raw, path)
            typed = [(tables, arguments) for arguments in commands(seed, str(path), tables)]
            if tables is not raw:  # what is refused is told soon
                typed.insert(0, (raw, ["check", str(path)]))
            for tables, arguments in typed:
                path.write_text(toml(tables), encoding="utf-8")
                begun = time.monotonic()
                answer = answered(arguments, longest=LONGEST)
                statuses[arguments[0], answer.status] += 1
                if asked.show:
                    print(*arguments[:1], *arguments[2:], "→", answer.status, f"{time.monotonic() - begun:.2f} s")
                    print(answer.output, answer.errors, sep="\n")
                if not answer.fault:
                    continue
                name = signature(answer.fault, arguments[0])
                found[name] += 1
                if found[name] > 1:
                    continue

                def still(trial, arguments=arguments, name=name):
                    path.write_text(toml(trial), encoding="utf-8")
                    return signature(answered(arguments, longest=LONGEST).fault, arguments[0]) == name

                less = shrunk(tables, still, time.monotonic() + asked.shrink)
                said = " ".join(part.replace(folder, "").lstrip("/") for part in arguments)
                print(f"{seed}: {said}\n  {answer.fault}", flush=True)
                if asked.keep is not None:
                    asked.keep.mkdir(parents=True, exist_ok=True)
                    kept = asked.keep / f"{seed}.toml"
                    kept.write_text(f"# cranktrain {said}\n# {answer.fault}\n{toml(less)}", encoding="utf-8")
    for name, count in found.most_common():
        print(f"{count:6d}  {name}")
    said = ", ".join(f"{command} {status}: {count}" for (command, status), count in sorted(statuses.items()))
    print(f"{n_files} files, {sum(found.values())} findings, {time.process_time():.0f} s of the processor; {said}")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
