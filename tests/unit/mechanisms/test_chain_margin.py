"""Closing margins of chains with triads: a crank-rocker's closed form, and walks round the turn beside a margin."""

import numpy as np
import pytest
from tests.machines import scaled
from tests.walks import comes_back

import cranktrain as ct
from cranktrain.io.machine_file import read_machine
from cranktrain.linkage import triad_walk
from cranktrain.mechanisms.chain.gaps import followed
from cranktrain.mechanisms.chain.kinematics import chain_made, triad_branch
from cranktrain.mechanisms.chain.triads import triad_at, triad_ends, triad_legs
from cranktrain.mechanisms.chain.walks import start_at
from cranktrain.mechanisms.closing import Way, changed, closing_margin
from cranktrain.mechanisms.kind import rows
from cranktrain.numerics.designs import by_design

N_DESIGNS = 6
N_STEPS = 50


def test_two_legs_on_one_point_are_a_crank_rocker():
    """The third leg is long and reaches all the time: what opens first is the crank-rocker, docs/theory (5.3)."""
    legs = [
        {"rod": {"name": "rod", "from": "main.pin", "length": "200 mm"}, "joint": "B", "along": "0 mm"},
        {"rod": {"name": "rocker", "from": "C", "length": "150 mm"}, "joint": "B2", "along": "0 mm"},
        {"rod": {"name": "third", "from": "D", "length": "1000 mm"}, "joint": "E", "along": "1000 mm"},
    ]
    legs[0]["near"] = ["150 mm", "130 mm"]
    legs[2]["near"] = ["-700 mm", "650 mm"]
    chain = {
        "kind": "chain",
        "output": "rocker",
        "fixed": {"C": ["220 mm", "0 mm"], "D": ["150 mm", "1130 mm"]},
        "crank": {"main": {"radius": "50 mm"}},
        "part": [{"type": "triad", "link": "link", "leg": legs}],
    }
    result = ct.run(ct.Machine(mechanism=chain), quantities="closing_margin")
    assert result.closing_margin[0] == pytest.approx(80 / 220, rel=1e-9)


def drawn(example, seed):
    """The valve gear of an example with all its lengths changed at random."""
    place = next(place for place in read_machine(example, ()).machine.places if place.kind.openings is not None)
    random = np.random.default_rng(seed)
    geometry = rows(by_design([place.geometry], 1), np.zeros(N_DESIGNS, dtype=int))
    for name in place.kind.lengths:
        geometry = scaled(geometry, name, random.uniform(0.9, 1.1, (N_DESIGNS, 1)))
    return place.kind, geometry


def turns(kind, geometry, way, change):
    """Whether the link goes round and comes back: the length is changed slowly at φ = 0, then the crank turned."""
    structure, lengths, size_of = kind.openings.args
    (place,) = (i for i, step in enumerate(structure.steps) if hasattr(step, "legs"))
    pose = start_at(triad_branch(structure, place, size_of(geometry)), np.zeros(1))
    size = size_of(geometry)
    for share in np.linspace(0, 1, N_STEPS):
        size = size_of(changed(lengths, geometry, way, share * change))
        pose = followed(structure, np.zeros(1), size, {place: pose})[1][place]
    step, own = triad_at(structure, place, size)
    above, upper = structure._replace(steps=structure.steps[:place]), size._replace(steps=size.steps[:place])

    def ends(angle):
        return triad_ends(step, own, chain_made(above, angle + np.zeros((len(change), 1)), upper))

    return comes_back(triad_walk(ends, triad_legs(own), pose), triad_legs(own))[:, 0]


def test_walks_open_just_beyond_the_margin():
    """Stephenson's link passes at a millionth less than the margin both ways, and at a millionth more not one way."""
    kind, geometry = drawn("traction_engine", 3)
    found = closing_margin(kind, geometry)
    closes = np.flatnonzero(np.isfinite(found.margin[:, 0]))
    assert len(closes) >= N_DESIGNS // 2
    geometry, margin, length = rows(geometry, closes), found.margin[closes], found.length[closes]
    with np.errstate(all="ignore"):
        below, beyond = (
            [turns(kind, geometry, Way(length, sign), margin * (1 + part)) for sign in (-1.0, 1.0)]
            for part in (-1e-6, 1e-6)
        )
    np.testing.assert_array_equal(below, True)
    np.testing.assert_array_equal(np.logical_xor(*beyond), True)
