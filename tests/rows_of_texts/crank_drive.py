"""Rows of the text on the crank drive, of the tilting table.

r = 250, l = 700, r₁ = 500, d = 800 mm, Q = 4 kN at r₁, a gear of 40 with 0.94, the linkage 0.9.
"""

import csv
import re
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from tests.rows_of_texts.kept import CLOSE, EXACT, moved, ran, row, same

import cranktrain as ct
from cranktrain.plans.centres import instant_centres
from cranktrain.plans.placement import placed
from cranktrain.plans.schemes import scheme
from cranktrain.textbook.crank_rocker_statements import alike_rockers, crank_rocker_curves

CRANK, ROCKER, LOAD, GEAR, GEAR_LOSS, LINKAGE_LOSS = 0.25, 0.5, 4000.0, 40.0, 0.94, 0.9
TABLE, UNIT = "tilting_table", "pumping_unit_c57"


@cache
def driven():
    return ct.textbook.drive(TABLE)


def turning(machine=TABLE):
    """dψ/dφ of `run`, at whole degrees."""
    return ran(machine, "rocker_velocity_coefficient").rocker_velocity_coefficient[0]


def ratio(machine=TABLE, radius=CRANK, rocker=ROCKER):
    """v_A/v_B by `run`."""
    return turning(machine) * rocker / radius


def at_60(number, symbol="", verdict="right"):
    return next(
        one.value
        for one in driven()
        if number in one.equation.split() and one.at == "at" and one.verdict == verdict and symbol in ("", one.symbol)
    )


def table_curve(number, words="", verdict="right"):
    return next(
        one.values[:-1]
        for one in driven().over_turn
        if (one.equation, one.verdict) == (number, verdict) and words in one.name
    )


def by_sines():
    """κ = sin(α − β)/sin(α₁ − β) of the pins that are drawn, and the product of both sines."""
    machine = ct.load(TABLE)
    pins = placed(machine, machine.places[0], np.ravel(ran(TABLE, "rocker_angle").grid.angle)).positions
    crank, rod, rocker = pins["A"] - pins["O"], pins["B"] - pins["A"], pins["B"] - pins["C"]
    angles = [np.arctan2(way[1], way[0]) for way in (crank, rod, rocker)]
    sines = np.sin(angles[0] - angles[1]), np.sin(angles[2] - angles[1])
    return sines[0] / sines[1], sines[0] * sines[1]


@row("B", "fig. 1")
def drive_scheme(_command, _typed):
    """Its links are as long as the file says, and the rocker stands at `run`'s angle."""
    found = scheme(ct.load(UNIT), 60.0)
    lengths = {one.letter: one.value for one in found.lengths}
    geometry = ct.load(UNIT).places[0].geometry
    assert (lengths["r"], lengths["r_1"]) == pytest.approx((geometry.crank_radius, geometry.rocker_length), rel=EXACT)
    pins = found.drawing.positions
    way = np.ravel(pins["B"]) - np.ravel(pins["C"])
    before = np.ravel(scheme(ct.load(UNIT), 0.0).drawing.positions["B"]) - np.ravel(pins["C"])
    turned = np.arctan2(before[0] * way[1] - before[1] * way[0], np.dot(before, way))
    angle = ran(UNIT, "rocker_angle").rocker_angle[0]
    assert abs(turned) == pytest.approx(abs(angle[60] - angle[0]), rel=CLOSE)


@row("B", "(1)")
def useful_torque(_command, _typed):
    """It is what the load takes of the crank, by the rocker's angle."""
    taken = ran(TABLE, "load_torque_on_crank").load_torque_on_crank[0]
    assert at_60("(1)") == pytest.approx(abs(taken[60] / turning()[60]), rel=EXACT)


@row("B", "(2)")
def force_in_the_rod(_command, _typed):
    """Its work on the crank is the load's: Q′ r sin(α − β) = Q r₁ dψ/dφ."""
    kappa, product = by_sines()
    across = np.sqrt(np.abs(kappa * product))  # |sin(α − β)|
    assert at_60("(2)") * CRANK * across[60] == pytest.approx(LOAD * ROCKER * abs(turning()[60]), rel=1e-10)


@row("B", "(3)")
def tangential_force(_command, _typed):
    assert at_60("(3)") == pytest.approx(LOAD * abs(ratio()[60]), rel=EXACT)


def curves_of_unit():
    """What is said of the pumping unit at `run`'s angles, and v_A/v_B by `run`."""
    machine = ct.load(UNIT)
    (rockers,) = alike_rockers(machine.places)
    geometry = machine.places[0].geometry
    angle = np.ravel(ran(UNIT, "rocker_angle").grid.angle)
    wanted = ratio(UNIT, float(geometry.crank_radius), float(geometry.rocker_length))
    return crank_rocker_curves(rockers, angle), wanted


def ratio_of_unit(_command, _typed):
    """Of the pumping unit: v_A/v_B, and by equal powers T by load."""
    (found, _product, _square, torque), wanted = curves_of_unit()
    same(found.values, wanted, 1e-11)
    same(found.exact, wanted, 1e-11)
    same(torque.values, float(ct.load(UNIT).places[0].geometry.crank_radius) * wanted, 1e-11)


for _number in ("(4)", "(6)", "(8)", "(9)", "(10)"):
    row("B", _number)(ratio_of_unit)


def centres_of_unit(_command, _typed):
    """C is where crank and rocker meet, and the pins' distances from it are as their velocities by `run`."""
    machine = ct.load(UNIT)
    _curves, wanted = curves_of_unit()
    for degrees in (60.0, 150.0):
        found = instant_centres(machine, degrees)
        numbers = {body.name or body.sort: number for number, body in enumerate(found.bodies, 1)}
        pair = sorted((numbers["frame"], numbers["rod"]))
        centre = next(one.place for one in found.centres if [one.first, one.second] == pair)
        pins = found.drawing.positions
        crank_pin, rocker_pin = (np.hypot(*(np.ravel(pins[pin]) - centre)) for pin in ("A", "B"))
        assert rocker_pin / crank_pin == pytest.approx(abs(wanted[round(degrees)]), rel=CLOSE)


for _number in ("(5)", "(7)"):
    row("B", _number)(centres_of_unit)


@row("B", "(11)")
def proof(_command, _typed):
    """sin ∠BAC by the cosine rule in the triangle of rod, rocker and the line from crank pin to pivot."""
    machine = ct.load(TABLE)
    pins = placed(machine, machine.places[0], np.array([np.radians(60.0)])).positions
    reach = np.hypot(*(np.ravel(pins["A"]) - np.ravel(pins["C"])))
    cosine = (0.7**2 + ROCKER**2 - reach**2) / (2 * 0.7 * ROCKER)
    assert at_60("(11)") == pytest.approx(np.sqrt(1 - cosine**2), rel=1e-10)


def losing(torque, loss):
    """The same friction torque both ways."""
    return np.where(torque > 0, torque / loss, torque * (2 - 1 / loss))


@row("B", "(12)")
def torque_on_the_crank(_command, _typed):
    """By the load's torque of `run`; the motor's static torque is the same behind the gear."""
    useful = LOAD * ROCKER * turning()
    same(table_curve("(12)"), losing(useful, LINKAGE_LOSS))
    same(table_curve("(12)", verdict="printed"), useful / LINKAGE_LOSS)
    found = ran(TABLE, "static_motor_torque").static_motor_torque[0].reshape(-1, 360)[0]
    same(losing(table_curve("(12)"), GEAR_LOSS) / GEAR, found)


@row("B", "(13)")
def printed_torque_on_the_crank(_command, _typed):
    same(table_curve("(13)", verdict="printed"), LOAD * ROCKER * turning() * ROCKER / CRANK / LINKAGE_LOSS)


@row("B", "(14)")
def torque_at_the_motor(_command, _typed):
    found = ran(TABLE, "static_motor_torque", "static_torque")
    same(table_curve("(14)", "by the stages of [drive]"), found.static_torque[0])
    by_rule = found.static_motor_torque.reshape(3, 360)
    same(table_curve("(14)", "the same as forward"), by_rule[1])
    same(table_curve("(14)", verdict="printed"), by_rule[2])


@row("B", "(15)")
def weight_at_the_pin(_command, _typed):
    """GD² = 4J of the rocker's 50 kg·m²."""
    assert at_60("(15)") == pytest.approx(4 * 50 / (2 * ROCKER) ** 2, rel=EXACT)


@row("B", "(16)")
def equal_energies(_command, _typed):
    assert at_60("(16)") == pytest.approx(at_60("(15)") * ratio()[60] ** 2, rel=1e-11)


@row("B", "(17)")
def weight_at_the_crank_pin(_command, _typed):
    (_ratio, _product, square, _torque), wanted = curves_of_unit()
    same(square.values, wanted**2, 1e-11)


@row("B", "(18)")
def moment_at_the_crank(_command, _typed):
    """4 J (dψ/dφ)²; the reduced inertia has the rod's and the crank's with it."""
    same(table_curve("(18)"), 4 * 50 * turning() ** 2, 1e-11)
    assert np.all(4 * ran(TABLE, "reduced_inertia").reduced_inertia > table_curve("(18)"))


@row("B", "(19)")
def printed_moment_at_the_crank(_command, _typed):
    same(table_curve("(19)", verdict="printed"), 4 * 50 * turning() ** 2 / LINKAGE_LOSS, 1e-11)


@row("B", "(20)")
def moment_at_the_motor(_command, _typed):
    """With all masses `run`'s; by the rocker alone over i², which is printed as i η."""
    same(table_curve("(20)", "with their masses"), ran(TABLE, "driven_flywheel_moment").driven_flywheel_moment[0])
    still = 0.08 + 0.62 + 1.3 + 0.4
    rocking = 4 * 50 * turning() ** 2
    same(table_curve("(20)", "no η"), still + rocking / GEAR**2)
    same(table_curve("(20)", verdict="printed"), still + rocking / (GEAR * GEAR_LOSS * LINKAGE_LOSS))


@row("B", "(21)")
def idle_torque(_command, _typed):
    """Of an active Q it is (14); dry friction never drives."""
    same(table_curve("(21)", "active"), ran(TABLE, "static_torque").static_torque[0])
    friction = LOAD * ROCKER * np.abs(turning()) / (GEAR * GEAR_LOSS * LINKAGE_LOSS)
    same(table_curve("(21)", "dry friction"), friction)


@row("B", "fig. 2")
def redrawn(command, typed):
    """The curves that it draws, as they are written, are `run`'s."""
    command[-1] = "curves.csv"
    assert typed(*command[1:]).returncode == 0
    with Path("curves.csv").open(encoding="utf-8", newline="") as file:
        heads, *lines = list(csv.reader(file))
    values = np.array(lines, dtype=float)[:-1].T
    torque = next(i for i, head in enumerate(heads) if head.startswith("(14) M_st right") and "by the stages" in head)
    moment = next(i for i, head in enumerate(heads) if head.startswith("(20) GD² right") and "their masses" in head)
    same(values[torque], ran(TABLE, "static_torque").static_torque[0], 1e-10)
    same(values[moment], ran(TABLE, "driven_flywheel_moment").driven_flywheel_moment[0], 1e-10)


@row("B", "after (20)", 0)
def product_of_sines(_command, _typed):
    """How far it is off at most, by `run`'s ratio."""
    (_ratio, product, _square, _torque), wanted = curves_of_unit()
    (worst,) = (one.value for one in moved(UNIT) if one.verdict == "refuted")
    off = np.max(np.abs(product.values - wanted))
    assert off <= worst * (1 + CLOSE)
    assert off == pytest.approx(worst, rel=1e-3)


@row("B", "after (20)", 1)
def product_in_torque_and_moment(_command, _typed):
    kappa, product = by_sines()
    same(np.abs(kappa), np.abs(ratio()), 1e-10)
    same(np.abs(table_curve("(10)", verdict="refuted")), np.abs(product), 1e-10)
    moment = 2.4 + 4 * CRANK**2 * 200 / GEAR**2 * table_curve("(10)", verdict="refuted")
    same(table_curve("(20)", verdict="refuted"), moment, 1e-10)


@row("B", "after (21)")
def flat_line(_command, _typed):
    """Flat, where `run`'s torque of the load is 0 at the dead positions."""
    assert np.ptp(table_curve("(21)", verdict="refuted")) == pytest.approx(0.0, abs=1e-9)
    torque = ran(TABLE, "static_torque").static_torque[0]
    assert np.min(torque) < 0 < np.max(torque)


@row("B", "purpose", 0)
def start(command, typed):
    """It ends in the running that `run` has as the steady one."""
    assert typed(*command[1:]).returncode == 0
    found = ct.start(TABLE)
    steady = ran(TABLE, "motor_speed").motor_speed
    last = found.run.curves.motor_speed[-1]
    assert np.min(steady) * (1 - 0.01) <= last <= np.max(steady) * (1 + 0.01)


@row("B", "purpose", 1)
def power(command, typed):
    """The motor that is proposed is the one that `run` sizes."""
    said = typed(*command[1:]).stdout
    found = ran(TABLE, "sized_power", "rms_motor_torque", "mean_motor_speed")
    proposed = float(re.search(r"P_n +([\d.]+)  kW", said)[1])
    assert np.any(np.isclose(found.sized_power, 1e3 * proposed))
    assert 1e3 * proposed > found.rms_motor_torque * found.mean_motor_speed


@row("B", "purpose", 2)
def load_diagrams(_command, _typed):
    """What is drawn is the motor's torque over the turn, and its root mean square."""
    result = ct.run(TABLE)
    drawn = [line.get_ydata() for axes in result.sheet("drive").axes for line in axes.get_lines()]
    torque = result.motor_torque
    assert any(np.size(one) == 361 and np.allclose(one[:-1], torque) for one in drawn)
    assert any(np.allclose(one, result.rms_motor_torque) for one in drawn)
