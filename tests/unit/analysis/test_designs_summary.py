"""Many designs in sentences: between which values they are, and who has them."""

import pytest
from tests.machines import V12, slider

import cranktrain as ct

SPEEDS = (1500, 1800, 1200)


@pytest.fixture(scope="module")
def result():
    machine = ct.Machine(name="small", mechanism=slider(), shaft={"main": {"speed": "1500 rpm"}})
    return ct.run([machine.with_({"shaft.main.speed": f"{speed} rpm"}) for speed in SPEEDS])


def test_ranges_and_who_has_them(result):
    lines = result.summary().splitlines()
    assert "3 designs of small" in lines
    assert "stroke: 100.0 mm" in lines  # of a crank of 50 mm
    assert "mean piston speed: 4.000 m/s (design 3) to 6.000 m/s (design 2)" in lines  # 2 S n


def test_one_design_is_told_as_alone(result):
    alone = ct.run(result.machines[1])
    assert result.summary(1) == alone.summary()


def test_only_what_was_asked_for(result):
    asked = ct.run(result.machines, quantities="mean_piston_speed").summary()
    assert asked.splitlines()[1:] == ["mean piston speed: 4.000 m/s (design 3) to 6.000 m/s (design 2)"]


def test_members_that_differ_in_every_design_alike():
    engine = ct.Machine(**V12)
    lines = ct.run([engine, engine.with_({"shaft.main.speed": "1600 rpm"})]).summary().splitlines()
    stroke = next(line for line in lines if line.startswith("stroke"))
    assert stroke.startswith("stroke: 180.0 mm to 18")
    assert stroke.endswith("in each")
    speed = next(line for line in lines if line.startswith("mean piston speed"))
    # 2 S n of the left bank at 25 Hz, which has the shorter stroke
    assert speed.startswith("mean piston speed: 9.000 m/s (design 1, L) to ")
    assert speed.endswith("(design 2, R)")


def test_what_one_design_has_not():
    short = {"mechanism.rod_length": "45 mm", "mechanism.offset": "0 mm"}
    machine = ct.Machine(mechanism=slider(), shaft={"main": {"speed": "60 rpm"}})
    lines = ct.run([machine, machine.with_(short)], partial=True).summary().splitlines()
    assert any("none in design 2" in line for line in lines)
