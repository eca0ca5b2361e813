"""The text on support reactions of a machine: (44) to (53) and what they have no term for, beside the split shaft."""

from functools import cache

import numpy as np
import pytest

import cranktrain as ct
from cranktrain.plans.machine_throw import ThrownMachine
from cranktrain.plans.placement import placed

ONE_THROW_TO_A_SPAN = ("3d12", "vaz_21213", "kamaz_740", "ls3", "deltic")

ALL_LOADS = {
    "gravity.direction": "20 deg",
    "masses.crank.mass": "9 kg",
    "masses.crank.along": "21 mm",
    "masses.crank.across": "4 mm",
    "masses.crank.inertia": "0.03 kg*m^2",
    "masses.crank.pin_share": "0.2",
    "balance.weight": [
        {"mass": "1.2 kg", "radius": "70 mm", "angle": "-190 deg", "z": "-110 mm"},
        {"mass": "0.7 kg", "radius": "60 mm", "angle": "30 deg", "z": "620 mm"},
        {"mass": "0.4 kg", "radius": "50 mm", "angle": "80 deg", "z": "-150 mm"},
        {"mass": "0.9 kg", "radius": "80 mm", "angle": "170 deg", "throw": 2, "z": "135 mm"},
        {"mass": "0.3 kg", "radius": "40 mm", "angle": "10 deg", "z": "225 mm"},
    ],
    "crankshaft.pull.belt": {"z": "-140 mm", "force": "1.1 kN", "direction": "75 deg"},
    "crankshaft.pull.flywheel": {"z": "600 mm", "force": "800 N", "direction": "180 deg"},
    "gear.cam": {"shafts": "main", "z": "-125 mm", "radius": "60 mm", "direction": "100 deg", "helix_angle": "20 deg"},
}
"""Weights on and beyond the webs, a crank that is not symmetric, pulls, and a helical gear beyond the first bearing."""


@cache
def loaded(name):
    if name == "of all sorts":
        return ct.load("kamaz_740", set=ALL_LOADS)
    if name == "with throws that hang over":
        crank = {"mass": "5 kg", "along": "12 mm", "across": "-3 mm", "inertia": "0.01 kg*m^2", "pin_share": "0.3"}
        return ct.load("vaz_21213", set={"crankshaft.bearings": [2, 3, 4], "masses.crank": crank})
    name, _space, running = name.partition(" ")
    return ct.load(name, set={"running": running or "ahead"})


@cache
def bearings(name):
    """Loads of main bearings of the split shaft by name, toward X and Y, shape (2, crank angle); the crank angle."""
    found = ct.run(loaded(name), quantities=("main_bearing_load_x", "main_bearing_load_y"))
    split = found.labels["bearing_method"].index("split")
    load = np.stack([found.main_bearing_load_x[split], found.main_bearing_load_y[split]], axis=1)
    return dict(zip(found.labels["bearing"], load, strict=True)), found.crank_angle


@pytest.mark.parametrize("name", [*ONE_THROW_TO_A_SPAN, "ls3 astern", "of all sorts", "with throws that hang over"])
def test_throws_together_bear_what_the_split_shaft_does(name):
    """Each bearing bears what the throws on both its sides do, by the text and with what has no letter there."""
    exact, degrees = bearings(name)
    of = ThrownMachine(loaded(name))
    sums = {bearing: np.zeros_like(load) for bearing, load in exact.items()}
    for throw in of.throws if name != "with throws that hang over" else ("2", "3"):
        one = of.throw(throw, degrees)
        kp, tp, kl, tl = with_the_rest(one)
        outward, ahead = directions(of, throw, degrees)
        sums[one.bearings[0]] += -kl * outward + tl * ahead
        sums[one.bearings[1]] += -kp * outward + tp * ahead
    largest = max(float(np.max(np.hypot(*load))) for load in exact.values())
    for bearing, load in exact.items():
        np.testing.assert_allclose(sums[bearing], load, rtol=0, atol=1e-12 * largest, err_msg=bearing)


def with_the_rest(one):
    """What a throw's bearings bear by the text, and of loads that have no letter there."""
    return [
        sum((getattr(own.share, side) for own in one.beyond), getattr(one.by_text, side)) for side in one.exact._fields
    ]


@pytest.mark.parametrize("masses", ["given", "sizes"])
@pytest.mark.parametrize("name", ["kamaz_740", "of all sorts", "with throws that hang over"])
def test_text_and_the_rest_are_the_split_span(name, masses):
    """Whosever masses are taken, of a pin that hangs over too."""
    of = ThrownMachine(loaded(name))
    one = of.throw("2", np.arange(0.0, 720.0, 45.0), masses)
    size = max(float(np.max(np.abs(part))) for part in one.exact)
    for own, exact in zip(with_the_rest(one), one.exact, strict=True):
        np.testing.assert_allclose(own, exact, rtol=0, atol=1e-12 * size)


def directions(of, throw, degrees):
    """Where a throw's crank points, by the drawing of a mechanism on it, and 90° ahead of that, shape (2, angle)."""
    shaft, number = of.throws[throw]
    name = of.loaded.shafts.names[of.loaded.each[shaft].layout.declared.shaft]
    place = next(one for one in of.machine.places if (one.shaft, one.throw) == (name, number) and not one.is_far)
    drawn = placed(of.machine, place, np.deg2rad(degrees) + of.loaded.zero[0, 0]).positions
    crank = drawn["A"] - drawn["O"]
    outward = crank / np.hypot(*crank)
    sense = np.sign(crank[0, 0] * crank[1, 1] - crank[1, 0] * crank[0, 1])
    return outward, sense * np.stack([-outward[1], outward[0]])


def test_lengths_and_forces_are_those_of_the_file():
    """KamAZ-740: gaps of 155 mm, a pin of 60 mm, webs of 27 mm, rods 29.5 mm apart, of which 2.4 kg turn at 60 mm."""
    found = ct.textbook.throw("kamaz_740", 3, 420)
    sizes = {one.symbol: one.value for one in found.numbered("fig. 35")}
    in_mm = {"l1": 20.5, "hL": 27, "l2": 15.25, "l3": 14.75, "l4": 14.75, "l5": 15.25, "hP": 27, "l6": 20.5, "l": 155}
    assert {name: 1e3 * sizes[name] for name in in_mm} == pytest.approx(in_mm, rel=1e-12)
    turning = 2.4 * 0.06 * (2 * np.pi * 2600 / 60) ** 2
    assert (sizes["C3"], sizes["C5"]) == pytest.approx((turning, turning), rel=1e-12)
    run = ct.run("kamaz_740", quantities=("crankpin_radial_without_rod", "crankpin_tangential_without_rod"))
    for side, cylinder in (("1", "3L"), ("2", "3R")):
        rod = run.labels["mechanism"].index(cylinder)
        pin = (
            float(getattr(run, name)[rod, 420])
            for name in ("crankpin_radial_without_rod", "crankpin_tangential_without_rod")
        )
        assert (sizes[f"K{side}"], sizes[f"T{side}"]) == pytest.approx(tuple(pin), rel=1e-12)


def test_cranks_by_their_sizes():
    """C4 of a steel pin, Ø 80 × 60 mm; C2 and C6 of webs 130 × 27 mm that reach from the journal's far side to it."""
    found = ct.textbook.throw("kamaz_740", 1, 0, crank_masses="sizes")
    sizes = {one.symbol: one.value for one in found.numbered("fig. 35")}
    square = (2 * np.pi * 2600 / 60) ** 2
    pin = 7850 * np.pi / 4 * 0.08**2 * 0.06
    web = 7850 * 0.13 * 0.027 * (0.06 + (0.095 + 0.08) / 2)
    middle = (0.06 + 0.04 - 0.0475) / 2
    assert sizes["C4"] == pytest.approx(pin * 0.06 * square, rel=1e-12)
    assert (sizes["C2"], sizes["C6"]) == pytest.approx((web * middle * square,) * 2, rel=1e-12)
    for one in found:
        if one.name == "together":
            assert one.value == pytest.approx(one.exact, rel=1e-12, abs=1e-9)


def test_what_has_no_letter_is_listed_with_its_share():
    """A belt 140 mm before the pin of throw 1: on the bearing at −77.5 mm more than its pull, on the next one less."""
    found = ct.textbook.throw(loaded("of all sorts"), 1, 100)
    names = [one.name for one in found if one.verdict == "beyond"]
    assert {"pull belt", "gear cam", "weight of what turns of the rods", "weight of the crank, and loads on it"} <= set(
        names
    )
    shares = {one.symbol: one.value for one in found if one.name == "pull belt"}
    near, far = (1100 * lever / 155 for lever in (77.5 + 140, 77.5 - 140))
    assert np.hypot(shares["R_KL"], shares["R_TL"]) == pytest.approx(near, rel=1e-12)
    assert np.hypot(shares["R_KP"], shares["R_TP"]) == pytest.approx(abs(far), rel=1e-12)


def test_external_counterweights_are_of_the_first_and_the_last_throw():
    """(48) of the largest weight before the first bearing, (49) of that behind the last: mass times radius times ω²."""
    machine = loaded("of all sorts")
    square = (2 * np.pi * 2600 / 60) ** 2
    first, last = (ct.textbook.throw(machine, throw, 0).numbered("fig. 35") for throw in (1, 4))
    of = {one.symbol: one.value for one in first}
    assert np.hypot(of["C10"], of["C11"]) == pytest.approx(1.2 * 0.07 * square, rel=1e-12)
    assert of["lP1"] == pytest.approx(0.110 - 0.0775, rel=1e-12)
    of = {one.symbol: one.value for one in last}
    assert np.hypot(of["C12"], of["C13"]) == pytest.approx(0.7 * 0.06 * square, rel=1e-12)
    assert of["lP2"] == pytest.approx(0.620 - (3 * 0.155 + 0.0775), rel=1e-12)
    assert "(48)" not in {one.equation for one in ct.textbook.throw(machine, 2, 0)}


@pytest.mark.parametrize(
    ("machine", "throw", "said"),
    [
        ("two_throw_compressor", 1, "is one of 2 between bearings 1 and 3"),
        ("mill_engine", 1, "hangs over"),
        ("10d100", 1, "^crankshaft: is missing"),
        ("kamaz_740", 5, "must be the number of a throw: 1, 2, 3, 4"),
    ],
)
def test_throws_of_which_the_text_does_not_speak(machine, throw, said):
    with pytest.raises(ct.InputError, match=said):
        ct.textbook.throw(machine, throw)
