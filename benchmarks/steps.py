"""Stages of an example's run, each ready to be done apart from the others."""

import numpy as np

from cranktrain.analysis import every_stage
from cranktrain.analysis.outcomes import run_stages
from cranktrain.analysis.parts import parts_of
from cranktrain.analysis.stages import lacking
from cranktrain.io.any_machine import load


def ready_stages(example):
    """Stages of an example by name, without arguments: what they need is there."""
    machine = load(example)
    parts = parts_of((machine,), step=np.radians(1.0))
    outcomes = run_stages(every_stage(), parts, lacking(every_stage(), parts))
    known = {**parts, **outcomes}

    def ready(one):
        given = {name: known.get(need) for name, need in one.needs.items()}
        return lambda: one.function(**given)

    return {one.function.__name__: ready(one) for one in every_stage() if one.gives in outcomes}
