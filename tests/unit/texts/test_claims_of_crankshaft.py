"""What the page of the text on a crankshaft's supports says, by a beam on two supports, and by typing its commands."""

import re
import shlex
from functools import partial

import numpy as np
import pytest
from tests.texts_said import sentence

import cranktrain as ct
from cranktrain.cli import main
from cranktrain.errors import InputError

SIZES = {"l1": 30, "l2": 20, "l3": 7, "l4": 9, "l5": 22, "l6": 31, "hL": 24, "hP": 26, "lP1": 40, "lP2": 50}
LENGTH = sum(SIZES.values()) - 90
"""Between the supports. [mm]"""


said = partial(sentence, "crankshaft-reactions")


def reactions(**forces):
    """R_KP, R_TP, R_KL, R_TL of all together, of forces in newtons."""
    nothing = {f"C{number}": "0 N" for number in range(1, 16)} | {
        f"{letter}{n}": "0 N" for letter in "KT" for n in (1, 2)
    }
    lengths = {name: f"{size} mm" for name, size in SIZES.items()}
    found = ct.textbook.throw(set=lengths | nothing | {name: f"{force} N" for name, force in forces.items()})
    return {one.symbol: one.value for one in found if one.name == "together" and one.symbol.startswith("R_")}


def by_levers(z, force):
    """Loads on the bearings P and L of a force at z from L."""
    return {"P": force * z / LENGTH, "L": force * (LENGTH - z) / LENGTH}


@pytest.mark.parametrize(
    ("symbol", "z", "sign", "words"),
    [
        ("C10", -SIZES["lP1"], 1, "C10 is with the rotation"),
        ("C12", LENGTH + SIZES["lP2"], -1, "C12 is against the rotation"),
        ("C8", SIZES["l1"] + SIZES["hL"] / 2, -1, "x, left open, is against the rotation"),
        ("C9", LENGTH - SIZES["l6"] - SIZES["hP"] / 2, -1, "x, left open, is against the rotation"),
        ("T1", SIZES["l1"] + SIZES["hL"] + SIZES["l2"], 1, "only so may it be added to (51), (53)"),
    ],
)
def test_senses_across_the_cranks_plane(symbol, z, sign, words):
    """T is with the rotation on the page; a force that is against it has the opposite loads of the same levers."""
    said(words)
    found = reactions(**{symbol: 1000})
    by_hand = by_levers(z, sign * 1000)
    assert (found["R_TP"], found["R_TL"]) == pytest.approx((by_hand["P"], by_hand["L"]), rel=1e-12)
    assert (found["R_KP"], found["R_KL"]) == pytest.approx((0, 0), abs=1e-9)


def test_only_sums_of_transverse_forces_occur():
    said("only sums of C8 + C14 occur")
    assert reactions(C8=700, C9=50) == pytest.approx(reactions(C14=700, C15=50), rel=1e-14)


def test_l7_is_in_no_formula_and_l_is_no_input():
    said("l7, which it has, occurs in no formula")
    said("l is no input but the sum of the chain")
    symbols = {one.symbol for one in ct.textbook.throw().numbered("fig. 35")}
    assert {"l1", "l6", "l"} <= symbols
    assert "l7" not in symbols
    for symbol in ("l7", "l"):
        with pytest.raises(InputError) as refused:
            ct.textbook.throw(set={symbol: "10 mm"})
        assert refused.value.problems[0].path == symbol
    found = ct.textbook.throw(set={"l1": "45 mm"})
    sizes = {one.symbol: one.value for one in found.numbered("fig. 35")}
    chain = ("l1", "hL", "l2", "l3", "l4", "l5", "hP", "l6")
    assert sizes["l"] == pytest.approx(sum(sizes[one] for one in chain), rel=1e-14)


def test_external_counterweights_are_end_moments_of_the_shaft():
    """A force at the overhang is the force at the bearing with its moment over the span: both would count it twice."""
    said("(48) and (49), or end moments of the continuous beam: both count the counterweights twice")
    found = reactions(C11=1000)  # inward
    moment = 1000 * SIZES["lP1"]
    assert found["R_KL"] == pytest.approx(1000 + moment / LENGTH, rel=1e-12)
    assert found["R_KP"] == pytest.approx(-moment / LENGTH, rel=1e-12)


@pytest.mark.parametrize("name", ["vaz_21213", "kamaz_740"])
def test_its_commands_take_the_example_and_an_engines_file(capsys, tmp_path, monkeypatch, name):
    monkeypatch.chdir(tmp_path)
    words = said("crankshafts with their supports, a throw at a time")
    commands = re.findall(r"`cranktrain ([^`]+)`", words)
    assert [one.rpartition(" ")[2] for one in commands] == ["example", "kamaz_740"]
    for command in commands:
        assert main(tuple(shlex.split(command.replace("kamaz_740", name)))) == 0
        assert "[crankshaft-reactions]" in capsys.readouterr().out


def test_k_must_not_hold_what_turns_of_the_rods():
    """What the pin of vaz_21213 bears inward is K1 − C3."""
    assert said("C3 and C5 hold what turns of the rods, so K must not", "(44)")
    own = {one.symbol: one.value for one in ct.textbook.throw("vaz_21213", 1, 400).numbered("fig. 35")}
    found = ct.run("vaz_21213")
    at = int(np.argmin(np.abs(found.crank_angle - 400)))
    assert own["K1"] - own["C3"] == pytest.approx(found.crankpin_load_radial[0, at], rel=1e-9)
    assert own["C3"] > 1000
