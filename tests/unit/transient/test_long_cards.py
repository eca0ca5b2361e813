"""Loads of many rows: those that bend as a smooth curve does limit the steps of a start and do not end them."""

import math
from dataclasses import replace

import numpy as np
import pytest
from tests.machines import ROCKER

import cranktrain as ct
from cranktrain.layout.load_laws import ByAngle, ByTravel
from cranktrain.questions.start.asked import StartAsked
from cranktrain.questions.start.case import StartCases
from cranktrain.questions.start.gentle_rows import corners_and_rows
from cranktrain.questions.start.starting import run_start
from cranktrain.study.start import over_time

TURN = 2 * math.pi
CAGE = {"kind": "cage", "size": "15 kW"}
SHUNT = {"kind": "shunt", "torque": "200 N*m", "speed": "57 rpm", "no_load_speed": "60 rpm"}
"""Far quicker than its machine: a start goes by an implicit method."""


def sines(n, amplitude=4.0):
    """Rows of a torque of 20 N·m and a sine, evenly round a turn."""
    at = np.linspace(0, TURN, n, endpoint=False)
    return ByAngle(at[np.newaxis], (20 + amplitude * np.sin(at + 0.05))[np.newaxis])


def parted(law, more=(), tolerance=1e-8):
    """Corners and rows of a load, and of what else happens."""
    angles = np.concatenate([law.kinks(TURN)[0] + 0.2, more])
    return corners_and_rows(angles, np.append(law.misses(TURN)[0], np.full(len(more), np.inf)), TURN, tolerance)


def test_rows_of_a_fine_card_end_no_steps():
    """Of a sine's 3600 none is a corner; all of 36 are, and all of a run with hardly a tolerance."""
    assert parted(sines(3600))[0].size == 0
    for law, tolerance in ((sines(36), 1e-8), (sines(3600), 1e-14)):
        corners, rows = parted(law, tolerance=tolerance)
        np.testing.assert_allclose(np.sort(np.mod(corners, TURN)), np.sort(np.mod(law.angles[0] + 0.2, TURN)))
        assert rows.size == 0


def test_a_row_that_is_another_corner_too_is_one():
    law = sines(3600)
    both = law.angles[0, 5] + 0.2
    corners, _rows = parted(law, [both + TURN, 1.0, np.nan])
    np.testing.assert_allclose(corners, [both, 1.0], rtol=1e-12)
    first = int(np.argmax(law.angles[0] > 1.0))
    jumps = law._replace(values=law.values + 5.0 * (law.angles > 1.0))
    np.testing.assert_allclose(corners_and_rows(law.angles[0], jumps.misses(TURN)[0], TURN, 1e-8)[0],
                               law.angles[0, [0, first - 1, first, 3599]])  # fmt: skip


@pytest.mark.parametrize("n", [3600, 7200, 14400])
def test_finer_cards_count_as_many_rows(n):
    """Rows h apart miss a/(20 + a) |sin| h²/8, and count √(miss/2.5e-6): ∫√|sin| over a turn is 2 B(3/4, 1/2)."""
    whole = 2 * math.gamma(0.75) * math.gamma(0.5) / math.gamma(1.25)
    assert parted(sines(n))[1].size == pytest.approx(whole * math.sqrt(4 / 24 / 8 / 2.5e-6), abs=1.5)


def test_misses_of_rows_over_a_travel():
    """Of s² every h apart: h²/4 of the largest; at the ends, beyond which it stays, by the slope of one side."""
    places = np.linspace(0.0, 2.0, 41)
    h = places[1]
    law = ByTravel(places[np.newaxis], 7.0 * places[np.newaxis] ** 2, np.zeros((1, 41)))
    expected = np.full(41, h * h / 4)
    expected[[0, -1]] = h * h / 8, (4 - h) * h / 8
    np.testing.assert_allclose(law.misses[0], expected / 4.0, rtol=1e-10)
    there = law._replace(out=law.back, back=law.out)
    np.testing.assert_array_equal(there.misses, law.misses)
    assert not np.any(law._replace(out=law.back).misses)


def card(places, unit, out, back):
    """Sizes there and back, in a unit, over places."""
    return [f"{x!r} {unit}" for x in places.tolist()], *([f"{x!r}" for x in size.tolist()] for size in (out, back))


def yoke(n, motor=CAGE, speed="1440 rpm", **start):
    """A yoke of 80 mm stroke against a smooth force of n rows over its travel."""
    part = np.linspace(0, 1, n)
    out = 2000 + 1500 * np.sin(np.pi * part) + 300 * np.sin(3 * np.pi * part)
    travel, there, back = card(0.08 * part, "m", out, 500 + 100 * np.sin(np.pi * part))
    load = {"travel": travel, "force": [f"{x} N" for x in there], "force_back": [f"{x} N" for x in back]}
    return ct.Machine(
        shaft={"main": {"speed": speed}},
        mechanism={"kind": "scotch_yoke", "crank_radius": "40 mm"},
        masses={"piston": {"mass": "1 kg"}},
        load={"card": {"on": "piston", "sense": "resisting", **load}},
        drive={
            "motor": motor,
            "part": {"wheel": {"on": "motor", "inertia": "0.5 kg*m^2"}},
            "start": {"angle": "10 deg", **start},
        },
    )


def rocker(n, **start):
    """A crank-rocker against a smooth torque over its swing."""
    machine = ct.Machine(shaft={"main": {"speed": "60 rpm"}}, mechanism=ROCKER)
    longest, shortest = (math.acos((0.4**2 + 0.28**2 - reach**2) / (2 * 0.4 * 0.28)) for reach in (0.46, 0.26))
    swing = longest - shortest
    part = np.linspace(0, 1, n)
    places, there, back = card(swing * part, "rad", 60 + 30 * np.sin(np.pi * part), 10 + 5 * np.sin(np.pi * part))
    load = {"swing": places, "torque": [f"{x} N*m" for x in there], "torque_back": [f"{x} N*m" for x in back]}
    return machine.with_(
        {
            "masses": {"rocker": {"mass": "3 kg", "along": "50 mm", "inertia": "0.1 kg*m^2"}},
            "load": {"card": {"on": "rocker", "sense": "resisting", **load}},
            "drive": {
                "motor": {"kind": "shunt", "torque": "60 N*m", "speed": "50 rpm", "no_load_speed": "60 rpm"},
                "part": {"wheel": {"on": "motor", "inertia": "2 kg*m^2"}},
                "start": start,
            },
        }
    )


@pytest.mark.parametrize("machine", [yoke(3600), rocker(3600, duration="3 s")], ids=["travel", "swing"])
def test_rows_over_travel_and_swing_limit_steps(machine):
    """Two dead centres with the ends of the card beside them, and no row between."""
    case = over_time(machine, [StartCases])[StartCases].each[0]
    assert case.corners.size <= 6
    found = run_start(case, StartAsked())
    assert found.method == "tsit5"
    assert found.n_steps < 250 * np.ptp(found.whole.crank_angle_turned) / TURN


@pytest.mark.parametrize(("motor", "speed", "method"), [(CAGE, "1440 rpm", "tsit5"), (SHUNT, "60 rpm", "LSODA")])
def test_as_one_that_ends_at_every_row(motor, speed, method, monkeypatch):
    """The same start with all rows of a yoke as corners, at arccos(1 − 2s) on the way out, and back."""
    n, duration = 3600, "80 ms" if method == "tsit5" else "200 ms"
    case = over_time(yoke(n, motor, speed, duration=duration), [StartCases])[StartCases].each[0]
    found = run_start(case, StartAsked())
    out = np.arccos(1 - 2 * np.linspace(0, 1, n)) + case.zero
    case = replace(case, corners=np.concatenate([out, TURN - out]), rows=np.empty(0))
    monkeypatch.setattr("cranktrain.questions.start.method.is_stiff", lambda *_given: False)
    exact = run_start(case, StartAsked())
    assert (found.method, exact.method) == (method, "tsit5")
    assert found.n_steps < 0.5 * exact.n_steps
    allowed = np.sqrt(found.n_steps) * found.tolerance  # by chance of the error allowed in every step
    for name, size in (
        ("crank_speed", np.max(exact.curves.crank_speed)),
        ("load_work", exact.supplied),
        ("motor_work", exact.supplied),
    ):
        np.testing.assert_allclose(
            getattr(found.curves, name), getattr(exact.curves, name), rtol=0, atol=allowed * size, err_msg=name
        )
    assert [event.sort for event in found.events] == [event.sort for event in exact.events]
    for one, other in zip(found.events, exact.events, strict=True):
        assert one.time == pytest.approx(other.time, abs=allowed * exact.time[-1])
