"""Many designs: what one of two hundred takes in a run of all, against one of fifty."""

import tomllib

import numpy as np
from comparison import Comparison
from steps import nothing

from cranktrain import Machine, run
from cranktrain.io.examples import EXAMPLES_FOLDER

FEW, TIMES, N_REPETITIONS = 50, 4, 3
STEP = 30.0
N_ANGLES = FEW * TIMES * 24
"""Of all designs together, of a four-stroke cycle."""
LIMIT = 1.3
EXAMPLES = ("vaz_21213", "3d12")


def comparisons():
    """All designs in one run against a quarter of them in each of four."""
    for example in EXAMPLES:
        many = varied(example, FEW * TIMES)
        parts = [many[i * FEW : (i + 1) * FEW] for i in range(TIMES)]
        yield (
            example,
            Comparison(
                f"{FEW * TIMES}",
                f"{TIMES} × {FEW}",
                lambda many=many: run(many, step_degrees=STEP),
                lambda parts=parts: [run(part, step_degrees=STEP) for part in parts],
                nothing,
                nothing,
                LIMIT,
            ),
        )


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
