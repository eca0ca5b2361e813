"""What balances a machine and its loads, and stands nowhere in the file, is said where it is much."""

import math

import pytest

import cranktrain as ct

RADIUS, FORCE = 0.05, 1000.0
MEAN = 4 * RADIUS * FORCE / (2 * math.pi)
"""Torque that a force against the motion of a piston takes on the mean: twice the stroke in a turn. [N·m]"""


def pump(on_shaft, scale=1.0, **tables):
    """A pump that takes 31.83 N·m on the mean, with a torque that drives its shaft; all of it larger by a scale."""
    return ct.Machine(
        shaft={"main": {"speed": "60 rpm"}},
        mechanism={"kind": "slider_crank", "crank_radius": f"{RADIUS} m", "rod_length": "0.2 m"},
        masses={"piston": {"mass": f"{scale} kg"}},
        load={
            "water": {"on": "piston", "force": f"{scale * FORCE} N"},
            "belt": {"on": "main", "sense": "active", "torque": f"{scale * on_shaft!r} N*m"},
        },
        evenness={"flywheel": f"{20 * scale} kg*m^2"},
        **tables,
    )


def said(machine):
    """Words and number of the row; none without one."""
    rows = [row for _title, rows in ct.run(machine).rows() for row in rows if str(row.name) == "balanced by"]
    return [(str(row.words), row.words.pieces["rest"].value) for row in rows]


@pytest.mark.parametrize("scale", [1e-3, 1.0, 1e3])
@pytest.mark.parametrize(
    ("share", "verb"),
    [
        (0.05, "drives"),
        (0.5, "drives"),
        (0.89, "drives"),
        (0.91, ""),
        (1.0, ""),
        (1.09, ""),
        (1.2, "loads"),
        (15, "loads"),
    ],
)
def test_it_is_said_where_it_is_more_than_a_tenth(share, verb, scale):
    """Of the machine's mean torque, however large the machine is."""
    load = ct.run(pump(share * MEAN, scale))
    assert float(load.remaining_torque) == pytest.approx((share - 1) * MEAN * scale, abs=1e-9 * MEAN * scale)
    found = said(pump(share * MEAN, scale))
    if not verb:
        assert found == []
        return
    ((words, rest),) = found
    assert f"{verb} the shaft, which stands nowhere in the file" in words
    assert rest == pytest.approx(abs(share - 1) * MEAN * scale, rel=1e-9)


def test_a_load_far_beyond_its_engine():
    """32 N·m of an engine against 500 N·m on its shaft: 468 N·m come from somewhere."""
    declared = pump(32.0 + MEAN).declared
    push = 32.0 * 2 * math.pi / (2 * RADIUS)  # on the way out alone, whose work is that of the torque over a turn
    engine = {"on": "piston", "sense": "active", "travel": ["0 mm", "200 mm"], "force": [f"{push!r} N"] * 2}
    engine["force_back"] = ["0 N", "0 N"]
    declared["load"] = {"gas": engine, "brake": {"on": "main", "torque": "500 N*m"}}
    ((words, rest),) = said(ct.Machine(**declared))
    assert "drives the shaft" in words
    assert rest == pytest.approx(468.0, rel=1e-9)


def test_a_motor_takes_what_is_left():
    assert said(pump(0.5 * MEAN, drive={"motor": {"kind": "cage", "size": "1.5 kW"}})) == []


@pytest.mark.parametrize(("share", "verb"), [(0.5, "drives"), (1.0, ""), (15, "loads")])
def test_it_is_said_of_machines_whose_evenness_nobody_asks_for(share, verb):
    """The same words and the same torque as with `[evenness]`."""
    declared = pump(share * MEAN).declared
    assert said(ct.Machine(**{key: table for key, table in declared.items() if key != "evenness"})) == said(
        ct.Machine(**declared)
    )
    assert bool(said(ct.Machine(**declared))) == bool(verb)


def test_at_one_moment_what_is_left_accelerates_the_machine():
    declared = pump(0.5 * MEAN).declared
    declared["shaft"]["main"]["acceleration"] = "3 rad/s^2"
    del declared["evenness"]
    assert said(ct.Machine(**declared)) == []
