"""Many designs of an example, each a little different."""

import tomllib

import numpy as np

from cranktrain import Machine
from cranktrain.io.examples import EXAMPLES_FOLDER


def varied(example, n):
    """Designs of an example: bore, speed and the first rod are each up to two percent longer or shorter."""
    factors = 1 + 0.02 * np.random.default_rng(1).uniform(-1.0, 1.0, (n, 3))
    text = (EXAMPLES_FOLDER / f"{example}.toml").read_text(encoding="utf-8")
    return [design(text, *row) for row in factors.tolist()]


def design(text, bore, speed, rod_length):
    """One design: its file with three numbers changed."""
    data = tomllib.loads(text)
    table = next(iter(data["bank"].values()))["mechanism"]
    for of, name, factor in (
        (data["cylinder"], "bore", bore),
        (data["shaft"]["main"], "speed", speed),
        (table, "rod_length", rod_length),
    ):
        number, unit = of[name]["value"].split(" ", 1)
        of[name]["value"] = f"{float(number) * factor!r} {unit}"
    return Machine(**data)
