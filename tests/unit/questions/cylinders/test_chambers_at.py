"""Whose a chamber is, says the cylinder in which a piston works; not the chamber's name."""

from tests.machines import slider

import cranktrain as ct
from cranktrain.questions.cylinders.parts import chambers_at

CYLINDERS = {"bore": "80 mm", "compression_ratio": 9}


def test_double_acting_beside_single_acting():
    """Each piston has chambers of its own, all six of them together."""
    bank = {name: {"mechanism": slider()} for name in "AB"}
    own = CYLINDERS | {"A": {"chambers": ["head", "crank"]}, "chambers": ["head"]}
    engine = ct.Machine(bank=bank, shaft={"main": {"throws": ["0 deg", "180 deg"]}}, cylinder=own)
    found = {piston.name: chambers_at(engine.design, piston.name) for piston in engine.design.pistons}
    assert {name: tuple(sides.values()) for name, sides in found.items()} == {
        "1A": ("head", "crank"),
        "2A": ("head", "crank"),
        "1B": ("head",),
        "2B": ("head",),
    }
    assert sorted(place for places in found.values() for place in places) == list(range(6))


def test_opposed_pistons_share_one():
    shafts = {"main": {"throws": ["0 deg"]}, "upper": {"throws": ["0 deg"], "ratio": -1, "place": ["0 mm", "600 mm"]}}
    pair = {"exhaust": {"mechanism": slider()}, "scavenge": {"mechanism": slider(), "shaft": "upper"}}
    engine = ct.Machine(bank={"O": pair}, shaft=shafts, cylinder=CYLINDERS)
    names = [piston.name for piston in engine.design.pistons]
    assert [chambers_at(engine.design, name) for name in names] == [{0: "head"}] * 2
