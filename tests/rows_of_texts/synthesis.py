"""Rows of the slider-crank synthesis: the mill engine, 12 in on a rod of 30 in at 180 rpm."""

import re
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from tests.rows_of_texts.kept import CLOSE, EXACT, PHI, curve_of, moved, ran, row, same

import cranktrain as ct
from cranktrain.plans.positions import position_plan

MILL, STROKE, ROD, SPEED = "mill_engine", 12 * 0.0254, 30 * 0.0254, 180 * 2 * np.pi / 60


@cache
def steps():
    return ct.textbook.synthesis(stroke="12 in", rod_length="30 in", mean_speed="1.8288 m/s", pressure_angle="12 deg")


def said_of_proposal(command, typed, symbol):
    """A number of the screen with its symbol."""
    shown = typed(*command[1:]).stdout
    return float(re.search(rf" {re.escape(symbol)} +(-?[\d.]+)(  |$)", shown, re.MULTILINE)[1])


@row("C", "r = S/2")
def crank_radius(command, typed):
    stroke = float(ran(MILL, "stroke").stroke[0])
    assert said_of_proposal(command, typed, "R") == pytest.approx(1e3 * stroke / 2, abs=0.005)


@row("C", "l = r/tg [α]")
def rod_of_a_pressure_angle(command, typed):
    """The angle that a rod of 30 in leaves is `run`'s, at 90°: sin α = r/l, which r/tg α is not."""
    largest = float(ran(MILL, "largest_pressure_angle").largest_pressure_angle[0])
    assert said_of_proposal(command, typed, "β_w") == pytest.approx(np.degrees(largest), abs=0.005)
    assert STROKE / 2 / np.sin(largest) == pytest.approx(ROD, rel=CLOSE)
    assert STROKE / 2 / np.tan(largest) < 0.99 * ROD


@row("C", "plans", 0)
def twelve_positions(_command, _typed):
    """Of vaz_21213, whose plan at the text's angles has the piston where `run` has it."""
    machine = ct.load("vaz_21213")
    plan = position_plan(machine, 12)
    pins = plan.drawing.positions["B"] * plan.scale
    along = np.hypot(*pins)
    travel = ran("vaz_21213", "piston_displacement").piston_displacement[0][:360:30]
    offset = float(machine.places[0].geometry.offset)
    slid = np.sqrt(along**2 - offset**2)
    same(np.max(slid) - slid, travel - np.min(travel), 1e-6)


@row("C", "Tц = 2S/v")
def period(command, typed):
    """Of 2S/v `run`'s mean speed is made."""
    mean = float(ran(MILL, "mean_piston_speed").mean_piston_speed[0])
    assert said_of_proposal(command, typed, "c_m") == pytest.approx(mean, abs=0.005)
    assert 2 * STROKE / mean == pytest.approx(60 / 180, rel=EXACT)


@row("C", "ω = 2π/Tц")
def angular_speed(command, typed):
    assert said_of_proposal(command, typed, "n") == pytest.approx(180, abs=0.05)


@row("C", "x = r cos φ + [l² − (r sin φ)²]")
def position(_command, _typed):
    """With its root it is where `run` has the piston."""
    x = STROKE / 2 * np.cos(PHI) + np.sqrt(ROD**2 - (STROKE / 2 * np.sin(PHI)) ** 2)
    found = ran(MILL, "piston_displacement").piston_displacement[0]
    same(STROKE / 2 + ROD - x, found)
    shown = [one.exact for one in steps() if (one.symbol, one.at) == ("x", "at")]
    same(STROKE / 2 + ROD - np.array(shown), found[::30])


def velocity(_command, _typed):
    """With sin φ for φ it is (336), and `run`'s velocity but for λ³."""
    ratio = STROKE / 2 / ROD
    form = STROKE / 2 * SPEED * (np.sin(PHI) + ratio / 2 * np.sin(2 * PHI))
    same(SPEED * curve_of(moved(MILL), "(336)", "1", "c/ω").values[:-1], form)
    shown = [one for one in steps() if (one.symbol, one.at) == ("v", "at")]
    same([one.value for one in shown], form[::30])
    same([one.exact for one in shown], ran(MILL, "piston_velocity").piston_velocity[0][::30])
    found = ran(MILL, "piston_velocity").piston_velocity[0]
    (largest,) = (one.value for one in moved(MILL).numbered("(336)") if one.at == "largest")
    assert np.max(np.abs(form - found)) / np.max(np.abs(found)) == pytest.approx(largest, rel=1e-3)


for _number in ("v = rω[φ + (r/2l) sin 2φ]", "table"):
    row("C", _number)(velocity)


@row("C", "plans", 1)
def own_plan(command, typed):
    """The plan that is written has the mill engine's stroke, at its scale."""
    assert typed(*command[1:]).returncode == 0
    assert "<svg" in Path(command[-1]).read_text(encoding="utf-8")
    machine = ct.Machine(mechanism={"kind": "slider_crank", "stroke": "12 in", "rod_length": "30 in"})
    plan = position_plan(machine, 12)
    along = plan.drawing.positions["B"]
    travel = plan.scale * np.hypot(*(along - along[:, :1]))
    same(travel, ran(MILL, "piston_displacement").piston_displacement[0][::30], CLOSE)


@row("C", "guide")
def guide(command, typed):
    """N/P = tan β, with friction on the guide tan β/(1 − μ tan β), β `run`'s."""
    slope = np.tan(float(ran(MILL, "largest_pressure_angle").largest_pressure_angle[0]))
    assert said_of_proposal(command, typed, "N/P") == pytest.approx(slope, abs=5e-4)
    assert said_of_proposal(command, typed, "N_μ/P") == pytest.approx(slope / (1 - 0.1 * slope), abs=5e-4)
