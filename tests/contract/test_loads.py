"""A load of every sort on every part of every kind: reactions against virtual work, work of loads against the torque.

The checks of a result are identities between ways of computing that share little; they are proved to be able to fail
where they are made.
"""

import tomllib

import numpy as np
import pytest
from tests.weighed_machines import WEIGHED

import cranktrain as ct
from cranktrain.layout.masses import part_name
from cranktrain.mechanisms import KINDS

SORTS = {
    "a force against the motion": {"force": "900 N", "along": "30 mm", "across": "-12 mm"},
    "a weight": {"force": "700 N", "sense": "active", "direction": "200 deg", "along": "25 mm"},
    "a force along a line": {"force": "800 N", "direction": "35 deg", "along": "0 mm"},
    "a damped point": {"force": "300 N", "at_speed": "1 m/s", "along": "20 mm"},
    "a brake": {"torque": "40 N*m"},
    "a torque": {"torque": "-55 N*m", "sense": "active"},
    "a fan": {"torque": "3 N*m", "at_turning": "10 rad/s", "exponent": 2},
    "a rope": {"force": "650 N", "radius": "90 mm", "sense": "active"},
    "a cam": {
        "torque": ["0 N*m", "80 N*m", "-20 N*m"],
        "crank_angles": ["20 deg", "140 deg", "300 deg"],
        "sense": "active",
    },
}
ON_SLIDERS = {
    "a cut": {"force": "900 N"},
    "a spring": {"force": "-300 N", "sense": "active"},
    "a press": {
        "force": ["0 N", "100 N", "4 kN"],
        "travel": ["0 mm", "30 mm", "2 m"],
        "force_back": ["0 N", "0 N", "9 N"],
    },
    "a damper": {"force": "200 N", "at_speed": "1 m/s", "exponent": 1.5},
}


def loaded(kind, running="ahead"):
    """The kind's example with every sort of load on every part that can bear it."""
    table = tomllib.loads(kind.example)
    places = [place for place in ct.Machine(**table).places if place.kind.name == kind.name]
    load = {}
    for place in places[:1]:
        for part in map(part_name, place.kind.dynamics.moving):
            slides = part in {"piston", *place.kind.sliders} or part == (
                getattr(place.spec, "output", "") if place.kind.output.is_slider else ""
            )
            for n, (name, sort) in enumerate((ON_SLIDERS if slides else SORTS).items()):
                load[f"{name} {n} on {part}".replace(" ", "_")] = {"on": part, **sort}
    machine = WEIGHED[kind.name]
    return ct.Machine(**{**machine.declared, "load": load, "running": running})


@pytest.mark.parametrize("running", ["ahead", "astern"])
@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: kind.name)
def test_reactions_and_work_agree(kind, running):
    result = ct.run(loaded(kind, running))
    found = {check.name: check for check in result.checks}
    assert {"torque", "load_work"} <= found.keys()
    for check in result.checks:
        assert np.all(check.passed), (check.name, check.residual, check.limit)
    senses = {name: load.sense for name, load in result.machines[0].load.items()}
    named = [name.rpartition(".")[2] for name in result.labels["load"]]
    resisting = [i for i, name in enumerate(named) if senses[name] == "resisting"]
    # a load that resists never gives work to the machine over a turn
    assert np.all(result.load_work[resisting] <= 0)
    assert np.min(result.load_work) < 0
