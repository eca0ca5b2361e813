"""The chain from motor to crank beside a scheme: each part once with its number, and nothing of it without a drive."""

import math

import pytest
from tests.unit.viz.test_pictures import assert_words_are_readable, words_of

import cranktrain as ct
from cranktrain.plans.drive_scheme import drive_chain
from cranktrain.viz import plan_scheme

LONG = {
    "motor": {"kind": "cage", "size": "4 kW"},
    "stage": [{"ratio": 2}, {"ratio": 3, "efficiency": 0.9}, {"ratio": 0.5}, {"ratio": 12.5, "drag": "1 N*m"}],
    "part": {f"part_{n}": {"on": "motor" if n == 0 else n, "inertia": f"{n + 1} kg*m^2"} for n in range(5)},
    "clutch": {"on": 1, "torque": "40 N*m"},
    "brake": {"on": "crank", "torque": "90 N*m"},
}


def words_beside(machine):
    drawn = plan_scheme(machine)
    assert_words_are_readable(drawn)
    return [text for text, _box in words_of(drawn)]


@pytest.mark.parametrize("name", ["tilting_table", "jaw_crusher", "shears", "shaking_conveyor", "compressor_start"])
def test_every_part_stands_once(name):
    machine = ct.load(name)
    words = words_beside(machine)
    elements = [one for shaft in drive_chain(machine) for one in shaft.elements]
    assert [one.symbol for one in elements].count("stage") == len(machine.drive.stage)
    assert {one.words for one in elements if one.symbol == "disc"} == {
        part.replace("_", " ") for part in machine.drive.part
    }
    for number, one in enumerate(elements, start=1):
        assert words.count(f"{number}  {one.words}") == 1
        assert words.count(str(number)) == 1
    assert [one.symbol for one in elements][-1] == "crank"


def test_speeds_by_the_ratios():
    chain = drive_chain(ct.load("tilting_table"))
    motor, crank = chain[0].elements[0], chain[-1].elements[-1]
    assert crank.value == pytest.approx(37.5 * math.pi / 30, rel=1e-12)
    assert motor.value == pytest.approx(1500 * math.pi / 30, rel=1e-12)
    assert [shaft.elements[-1].value for shaft in chain[:-1]] == [40, 1]


def test_press_has_its_clutch_and_brake():
    words = words_beside(ct.load("high_slip_press"))
    assert {"4  clutch", "4800 N·m", "6  brake", "2600 N·m", "i = 5, η = 0.96"} <= set(words)


@pytest.mark.parametrize("size", ["A4", "A3"])
def test_a_long_chain_has_room(size):
    machine = ct.load("tilting_table").with_({"drive": LONG})
    drawn = plan_scheme(machine, size=size)
    assert_words_are_readable(drawn)
    symbols = [one.symbol for shaft in drive_chain(machine) for one in shaft.elements]
    assert len(symbols) == 13
    assert symbols.count("clutch") == symbols.count("brake") == symbols.count("motor") == 1


def test_without_a_drive_there_is_none():
    assert drive_chain(ct.load("pumping_unit_c57")) == ()
    assert not any(text.startswith("Drive") for text in words_beside(ct.load("pumping_unit_c57")))


def test_without_a_shaft_there_is_no_speed():
    mechanism = {"kind": "slider_crank", "stroke": "100 mm", "rod_length": "200 mm"}
    machine = ct.Machine(name="w", mechanism=mechanism, drive={"stage": [{"ratio": 2}]})
    crank = drive_chain(machine)[-1].elements[-1]
    assert math.isnan(crank.value)
    assert "i = 2" in words_beside(machine)
