"""Rows of the text on support reactions: throws of the KamAZ and of a ВАЗ."""

import tomllib
from functools import cache

import numpy as np
import pytest
from tests.rows_of_texts.kept import CLOSE, EXACT, argument, ran, row, same

import cranktrain as ct
from cranktrain.plans.pin_loads import pin_loads


@cache
def third():
    return ct.textbook.throw("kamaz_740", 3, 420)


def letters():
    """Lengths and forces of fig. 35."""
    return {one.symbol: one.value for one in third().numbered("fig. 35")}


def of_third(number, symbol):
    (found,) = (one.value for one in third() if (one.equation, one.symbol) == (number, symbol))
    return found


def check_masses(number, symbol, levers):
    """C1, C3, C5 and C7 about the other support."""

    def check(_command, _typed):
        of = letters()
        at = {name: lever(of) for name, lever in levers.items()}
        wanted = (of["C1"] * at["C1"] - of["C3"] * at["C3"] - of["C5"] * at["C5"] + of["C7"] * at["C7"]) / of["l"]
        assert of_third(number, symbol) == pytest.approx(wanted, rel=EXACT)

    return check


FROM_L = {
    "C1": lambda of: of["l1"] + of["hL"] / 2,
    "C3": lambda of: of["l1"] + of["hL"] + of["l2"],
    "C5": lambda of: of["l1"] + of["hL"] + of["l2"] + of["l3"] + of["l4"],
    "C7": lambda of: of["l"] - of["l6"] - of["hP"] / 2,
}
FROM_P = {name: (lambda of, lever=lever: of["l"] - lever(of)) for name, lever in FROM_L.items()}
row("E", "(44)")(check_masses("(44)", "R_KP", FROM_L))
row("E", "(46)")(check_masses("(46)", "R_KL", FROM_P))


def across(_command, _typed):
    """Cranks that are alike on both sides of their plane load nothing across it."""
    assert of_third("(45)", "R_TP") == of_third("(47)", "R_TL") == 0.0


for _number in ("(45)", "(47)"):
    row("E", _number)(across)


def check_rods(number, symbol, levers):
    """Forces of both rods on the pin, of `run`, about the other support."""

    def check(_command, _typed):
        of = letters()
        names = ("crankpin_radial_without_rod", "crankpin_tangential_without_rod")
        found = ran("kamaz_740", *names)
        curve = getattr(found, names["T" in symbol.split("_")[1]])
        one, two = (float(curve[found.labels["mechanism"].index(rod), 420]) for rod in ("3L", "3R"))
        wanted = (one * levers["C3"](of) + two * levers["C5"](of)) / of["l"]
        assert of_third(number, symbol) == pytest.approx(wanted, rel=1e-11)

    return check


row("E", "(50)")(check_rods("(50)", "R_KP", FROM_L))
row("E", "(51)")(check_rods("(51)", "R_TP", FROM_L))
row("E", "(52)")(check_rods("(52)", "R_KL", FROM_P))
row("E", "(53)")(check_rods("(53)", "R_TL", FROM_P))


def split(machine, **more):
    """Resultant loads of the main bearings of the split shaft by `run`, by name and angle."""
    result = ct.run(ct.load(machine, **more), quantities=("main_bearing_load_x", "main_bearing_load_y"))
    method = result.labels["bearing_method"].index("split")
    loads = np.hypot(result.main_bearing_load_x[method], result.main_bearing_load_y[method])
    return dict(zip(result.labels["bearing"], loads, strict=True))


def check_end(machine, throw, side, bearing):
    """The outer bearing bears this throw alone, with the counterweight outside it: what `run` has."""

    def check(command, _typed):
        more = {}
        if "--set" in command:
            more = {"set": {"balance.weight": tomllib.loads(argument(command, "--set"))["balance"]["weight"]}}
        found = ct.textbook.throw(ct.load(machine, **more), throw, 0)
        size = {one.symbol[2:]: np.abs(one.values) for one in found.over_turn}
        wanted = split(machine, **more)[bearing]
        same(np.hypot(size[f"K{side}"], size[f"T{side}"]), wanted, 1e-11)
        number = "(48)" if side == "L" else "(49)"
        assert not more or all(one.value for one in found.numbered(number) if "counterweight" in one.name)

    return check


row("E", "(48)")(check_end("kamaz_740", 1, "L", "1"))
row("E", "(49)")(check_end("kamaz_740", 4, "P", "5"))
row("E", "first throw")(check_end("vaz_21213", 1, "L", "1"))
row("E", "last throw")(check_end("vaz_21213", 4, "P", "5"))


@row("E", "fig. 35")
def figure(_command, _typed):
    """Its chain is as long as `run` has the bearings of the throw apart."""
    found = ran("kamaz_740", "bearing_place")
    places = dict(zip(found.labels["bearing"], np.ravel(found.bearing_place), strict=True))
    assert letters()["l"] == pytest.approx(abs(places["4"] - places["3"]), rel=EXACT)


@row("E", "after (53)")
def balance(_command, _typed):
    """What is left of ΣC is what the bearings of both sides bear of the rotating masses."""
    (left,) = (one.value for one in third().numbered("after (53)") if (one.symbol, one.at) == ("ΣC", "outward"))
    assert -left == pytest.approx(of_third("(44)", "R_KP") + of_third("(46)", "R_KL"), rel=EXACT)


@row("E", "each throw")
def throws_together(_command, _typed):
    """Bearing 3 of the ВАЗ bears throw 2's right side and throw 3's left one, whose cranks stand alike."""
    sums = {}
    for throw, side in ((2, "P"), (3, "L")):
        for one in ct.textbook.throw("vaz_21213", throw).over_turn:
            if one.symbol[-1] == side:
                sums[one.symbol[2]] = sums.get(one.symbol[2], 0.0) + one.values
    same(np.hypot(sums["K"], sums["T"]), split("vaz_21213")["3"], 1e-11)


@row("E", "continuous")
def other_methods(_command, _typed):
    """Each method's bearings together bear what the split shaft's do."""
    found = ran("vaz_21213", "main_bearing_load_x", "main_bearing_load_y")
    for load in (found.main_bearing_load_x, found.main_bearing_load_y):
        together = np.sum(load, axis=1)
        same(together, np.broadcast_to(together[-1], together.shape), 1e-9)
        assert np.ptp(load[:, 2], axis=0).max() > 1.0


@row("E", "polar")
def polar(_command, _typed):
    """The diagram of a crank pin is `run`'s load on it."""
    drawn = pin_loads(ct.load("vaz_21213"))
    found = ran("vaz_21213", "largest_crankpin_load")
    assert drawn.largest == pytest.approx(float(np.ravel(found.largest_crankpin_load)[0]), rel=CLOSE)


@row("E", "wear")
def wear(command, typed):
    """The oil hole that is drawn stands where `run` has the least wear of the pin."""
    found = ran("vaz_21213", "crankpin_wear", "crankpin_oil_hole")
    sheet = ct.run("vaz_21213").sheet("wear")
    assert sheet.axes
    for pin, hole in zip(found.crankpin_wear, found.crankpin_oil_hole, strict=True):
        assert np.argmin(pin) * 360 / pin.size == pytest.approx(np.degrees(float(hole)), abs=2 * 360 / pin.size)
