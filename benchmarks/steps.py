"""Steps of a run apart from it: gas, events and balance of whole examples, against plain NumPy work."""

import by_hand
import numpy as np
from comparison import Comparison

from cranktrain.analysis import STAGES
from cranktrain.analysis.parts import parts_of
from cranktrain.analysis.stages import lacking, run_stages
from cranktrain.io.any_machine import load

STEPS = {
    "gas": ("gas_in_chambers", "gas_pressures"),
    "events": ("gas_events",),
    "balance": ("frame_forces", "running_frame", "shaking_forces", "shaking_couples", "rolling_moment"),
}
LIMITS = {
    ("3d12", "gas"): 10.0,
    ("3d12", "events"): 3.5,
    ("3d12", "balance"): 13.0,
    ("deltic", "gas"): 9.0,
    ("deltic", "events"): 2.0,
    ("deltic", "balance"): 17.0,
}
"""How many times as long as the work by hand; deltic, with 36 pistons on 18 throws, is what threads would spin for."""


def comparisons():
    """Each step against the motion of twelve slider-cranks by hand."""
    angles = np.arange(720) * (4 * np.pi / 720) + np.linspace(0.0, 4 * np.pi, 12)[:, np.newaxis]
    ready = {example: ready_stages(example) for example, _step in LIMITS}

    def motion():
        return by_hand.slider_crank_numpy(angles, 0.04, 0.14, 0.01)

    for (example, step), limit in LIMITS.items():
        stages = [ready[example][name] for name in STEPS[step] if name in ready[example]]
        yield example, Comparison(step, "12 motions", in_turn(stages), motion, nothing, nothing, limit)


def in_turn(stages):
    """Run all of them."""

    def run():
        with np.errstate(all="ignore"):
            for stage in stages:
                stage()

    return run


def ready_stages(example):
    """Stages of an example by name, without arguments: what they need is there."""
    machine = load(example)
    parts = parts_of((machine,), step=np.radians(1.0))
    outcomes = run_stages(STAGES, parts, lacking(STAGES, parts))
    known = {**parts, **outcomes}

    def ready(one):
        given = {name: known.get(need) for name, need in one.needs.items()}
        return lambda: one.function(**given)

    return {one.function.__name__: ready(one) for one in STAGES if one.gives in outcomes}


def nothing(_outcome):
    """No columns: these are two things, and not two ways of one."""
    return []
