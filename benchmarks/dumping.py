"""Every quantity of many machines, and all that is printed of them, in one file.

Only the library's public names are used and the terminal's commands, so that other commits can be asked the same.
"""

import itertools
import json
import os
import subprocess
from importlib.resources import files
from pathlib import Path
from typing import NamedTuple

import numpy as np
from printed import printed

import cranktrain as ct

WEIGHED = Path(__file__).parent / "weighed"
SENSES = list(itertools.product(("ahead", "astern"), ("clockwise", "anticlockwise")))
STEPS = (1.0, 7.5)
"""That at which facts are found, and a wider one that is no multiple of it. [deg]"""

DESIGNS = {
    "everything.toml": ("bank.L.mechanism.rod_length", ["178 mm", "180 mm", "183 mm"]),
    "vaz_21213": ("bank.line.mechanism.offset", ["-1.2 mm", "0 mm", "2 mm"]),
    "stephenson.toml": ("mechanism.notch", [1, 0.4, -0.7]),
}
"""Of which machines several designs are run at once, and by what they differ."""

OPEN = {"crank_rocker.toml": ("mechanism.crank_radius", "330 mm"), "chain.toml": ("mechanism.crank.main.radius", "1 m")}
"""Machines that do not close all round with another length."""

OWN_SPEED = ("vaz_21213", "slider_crank.toml")
"""Machines that are run at speeds of one's own."""


class Run(NamedTuple):
    """One call of `run`: its name, and what it is called with."""

    name: str
    machine: object
    options: dict


def written(path):
    """Write a dump; say in a sentence what is in it."""
    os.chdir(WEIGHED)  # what is printed names the files as they are typed
    names = examples() + sorted(file.name for file in WEIGHED.glob("*.toml"))
    arrays, entries, texts = {}, {}, {}
    for run in itertools.chain.from_iterable(runs_of(name) for name in names):
        try:
            result = ct.run(run.machine, **run.options)
        except ct.InputError as error:
            texts[f"{run.name}, refused"] = str(error)
            continue
        entries[run.name] = {name: [entry.unit, *entry.dimensions] for name, entry in result.catalogue.items()}
        arrays |= {f"{run.name}|{name}": np.asarray(getattr(result, name)) for name in result.catalogue}
        texts |= {f"{run.name}, {what}": text for what, text in said(result).items()}
    texts |= printed(names)
    about = {"commit": commit(), "entries": entries, "texts": texts}
    np.savez_compressed(path, about=json.dumps(about, ensure_ascii=False), **arrays)
    n_numbers = sum(array.size for array in arrays.values())
    return (
        f"{about['commit']}: {len(names)} machines, {len(entries)} runs, {len(arrays)} quantities, {n_numbers} numbers,"
        f" {len(texts)} texts"
    )


def examples():
    """Names of the examples."""
    return sorted(
        path.name.removesuffix(".toml")
        for path in files("cranktrain.examples").iterdir()
        if path.name.endswith(".toml")
    )


def runs_of(name):
    """Go through all runs of a machine."""
    machine = ct.load(name)
    for (running, rotation), step in itertools.product(SENSES, STEPS):
        other = machine.with_({"running": running, "rotation": rotation})
        yield Run(f"{name}, {running}, {rotation}, {step:g}°", other, {"step_degrees": step})
    if machine.evenness is not None:
        for running in ("ahead", "astern"):
            yield Run(f"{name}, {running}, running speed", machine.with_({"running": running}), {"speed": "running"})
    if name in DESIGNS:
        path, values = DESIGNS[name]
        yield Run(f"{name}, designs", [machine.with_({path: value}) for value in values], {})
    if name in OPEN:
        path, value = OPEN[name]
        yield Run(f"{name}, open", machine.with_({path: value}), {"partial": True})
        yield Run(f"{name}, open and refused", machine.with_({path: value}), {})
    if name in OWN_SPEED:
        speed = 200 + 3 * np.cos(np.arange(0, 4 * np.pi, np.radians(7.5)))
        yield Run(f"{name}, own speed", machine, {"speed": speed, "step_degrees": 7.5})
        yield Run(f"{name}, some quantities", machine, {"quantities": ["stroke", "largest_torque"]})


def said(result):
    """What a result says in words, by what it speaks of."""
    n_designs = len(result.machines)
    used = {one for entry in result.catalogue.values() for one in entry.dimensions} - {"crank_angle"}
    return {
        "labels": lines(f"{one}: {', '.join(map(str, result.labels[one]))}" for one in sorted(used)),
        "answers": lines(result.summary(design) for design in range(n_designs)),
        "checks": lines(f"{c.name}: {c.sentence}: {[c.verdict(d) for d in range(n_designs)]}" for c in result.checks),
        "flags": lines(map(str, result.flags)),
        "missing": lines(f"{', '.join(map(str, one.needs))}: {', '.join(one.results)}" for one in result.missing),
    }


def lines(texts):
    return "\n".join(texts)


def commit():
    """Name of the commit whose code is run."""
    command = ["git", "-C", str(Path(ct.__file__).parent), "describe", "--always", "--dirty"]
    told = subprocess.run(command, check=False, capture_output=True, text=True)
    return told.stdout.strip() or f"version {ct.__version__}"
