"""Evenness of whole machines: against the equation of motion step by step in closed form, and what files may say."""

import re
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from scipy.integrate import quad, solve_ivp
from tests.gas_engines import DUAL_CYCLE
from tests.machines import slider
from tests.told import line_of, lines_of, problems_told, texts_of

import cranktrain as ct
from cranktrain.errors import InputError
from cranktrain.questions.evenness.shaft_work import ShaftWork

RADIUS, ROD, BORE, RATIO = 0.05, 0.18, 0.085, 16.0
PISTON, ROD_MASS, CENTROID, ROD_INERTIA, CRANK_INERTIA = 1.2, 1.6, 0.06, 0.008, 0.02
START, COMPRESSION, EXPANSION, RISE, CUT_OFF, AMBIENT = 1e5, 1.36, 1.25, 1.55, 1.45, 101325.0
AREA = np.pi / 4 * BORE**2
CLEARANCE = AREA * 2 * RADIUS / (RATIO - 1)
SPEED, FLYWHEEL = 2 * np.pi * 15, 2.0
CYCLE = 4 * np.pi

ENGINE: dict[str, Any] = {
    "shaft": {"main": {"speed": "900 rpm"}},
    "mechanism": {"kind": "slider_crank", "crank_radius": "50 mm", "rod_length": "180 mm"},
    "cylinder": {"bore": "85 mm", "compression_ratio": 16, "cycle": "four-stroke", "firing_order": "1"},
    "masses": {
        "piston": {"mass": "1.2 kg"},
        "rod": {"mass": "1.6 kg", "along": "60 mm", "inertia": "0.008 kg·m²"},
        "crank": {"mass": "5 kg", "along": "0 mm", "inertia": "0.02 kg·m²"},
    },
    "gas": DUAL_CYCLE,
}
"""One cylinder of a four-stroke diesel."""


RISING = {"screw": {"on": "main", "scale": "balanced", "exponent": 2}}
"""A load that rises with the speed squared."""


def run(step=1.0, machine=ENGINE, load=None, motor=None, **evenness):
    drive = {} if motor is None else {"drive": {"motor": {"kind": "shunt", **motor}}}
    return ct.run(ct.Machine(**machine, load=load or {}, evenness=evenness, **drive), step_degrees=step)


def names_of(result):
    """What the answer says of evenness, by name."""
    return [line.partition(":")[0] for line in lines_of(result, "Evenness")]


def rod(phi):
    """Angle of the rod from the line of stroke, and its first two derivatives."""
    sine, cosine, ratio = np.sin(phi), np.cos(phi), RADIUS / ROD
    root = np.sqrt(1 - (ratio * sine) ** 2)
    first = -ratio * cosine / root
    return -np.arcsin(ratio * sine), first, ratio * sine / root + first * ratio**2 * sine * cosine / root**2


def inertia(phi):
    """J and J′ by hand: crank pin, rod's centroid on the line between its pins, piston."""
    angle, first, second = rod(phi)
    pin = RADIUS * np.exp(1j * (phi + np.array([0, np.pi / 2, np.pi])))
    link = np.exp(1j * angle) * np.array([1.0, 1j * first, 1j * second - first**2])
    value, slope = CRANK_INERTIA, 0.0
    for mass, along in ((ROD_MASS, CENTROID), (PISTON, ROD)):
        point = pin + along * link
        value += mass * abs(point[1]) ** 2
        slope += 2 * mass * (point[1] * np.conj(point[2])).real
    return value + ROD_INERTIA * first**2, slope + 2 * ROD_INERTIA * first * second


def gas_torque(phi):
    """Torque of the dual cycle that fires at 0, with gas exchange at the starting pressure."""
    angle, first, _second = rod(phi)
    x = RADIUS * np.cos(phi) + ROD * np.cos(angle)
    slope = -RADIUS * np.sin(phi) - ROD * np.sin(angle) * first
    volume = CLEARANCE + AREA * (RADIUS + ROD - x)
    quarter = int(phi % CYCLE // np.pi)
    peak = RISE * START * RATIO**COMPRESSION
    pressure = (
        peak * min(1.0, CUT_OFF * CLEARANCE / volume) ** EXPANSION,
        START,
        START,
        START * (RATIO * CLEARANCE / volume) ** COMPRESSION,
    )[quarter]
    return -(pressure - AMBIENT) * AREA * slope


def cut_off():
    """Crank angle at which the heat ends."""
    x = RADIUS + ROD - (CUT_OFF - 1) * CLEARANCE / AREA
    return float(np.arccos((x**2 + RADIUS**2 - ROD**2) / (2 * x * RADIUS)))


CORNERS = (0.0, cut_off(), np.pi, 2 * np.pi, 3 * np.pi, CYCLE)
"""Between them the torque is smooth."""
WORK = sum(
    quad(gas_torque, low + 1e-12, high - 1e-12, epsabs=1e-11, epsrel=1e-12)[0] for low, high in pairwise(CORNERS)
)


def integrated(start, load, flywheel=FLYWHEEL):
    """Speeds and times at whole degrees over a cycle from a speed at 0, by steps along the equation of motion."""

    def slope(phi, state):
        value, change = inertia(phi)
        speed = state[0]
        return [
            (gas_torque(min(max(phi, low + 1e-12), high - 1e-12)) - load(speed) - change * speed**2 / 2)
            / ((value + flywheel) * speed),
            1 / speed,
        ]

    at = np.radians(np.arange(721.0))
    speeds, state = np.empty(721), [start, 0.0]
    for low, high in pairwise(CORNERS):
        own = (at >= low - 1e-9) & (at <= high + 1e-9)
        found = solve_ivp(slope, (low, high), state, "DOP853", dense_output=True, rtol=1e-11, atol=1e-11, max_step=0.1)
        speeds[own] = found.sol(at[own])[0]
        state = found.y[:, -1]
    return speeds, state[1]


@pytest.fixture(scope="module")
def engine():
    return run(flywheel="2 kg·m²", coefficient=0.02, rim={"mean_diameter": "500 mm"})


def test_mean_torque_is_the_work_of_the_gas(engine):
    # a kink between the grid's points costs its height times the square of the step
    assert engine.mean_torque == pytest.approx(WORK / CYCLE, rel=1e-4)
    assert engine.mean_torque * CYCLE == pytest.approx(float(engine.indicated_work[0]), rel=1e-13)


def test_reduced_inertia_and_its_moment(engine):
    expected = [inertia(phi)[0] for phi in np.radians(engine.crank_angle)]
    np.testing.assert_allclose(engine.flywheel_moment, 4 * np.array(expected), rtol=1e-13)


def test_constant_load_against_the_equation_of_motion(engine):
    speeds, time = integrated(float(engine.crank_speed[0]), lambda _speed: WORK / CYCLE)
    spread = np.ptp(speeds)
    assert speeds[-1] == pytest.approx(speeds[0], abs=1e-10 * spread)
    np.testing.assert_allclose(engine.crank_speed, speeds[:-1], rtol=0, atol=1e-4 * spread)
    assert CYCLE / time == pytest.approx(SPEED, rel=1e-6)
    assert engine.mean_speed_over_time == pytest.approx(SPEED, rel=1e-12)
    assert engine.coefficient_of_fluctuation == pytest.approx(spread / SPEED, rel=2e-4)


def test_acceleration_is_the_slope_of_the_speed(engine):
    speed = engine.crank_speed
    slope = (np.roll(speed, -1) - np.roll(speed, 1)) / np.radians(2)
    away = np.min(np.abs(engine.crank_angle - np.degrees(CORNERS)[:, np.newaxis]), axis=0) > 2
    scale = np.max(np.abs(engine.crank_acceleration))
    # the parabola of the neighbours: a sixth of the third derivative times the square of the step
    np.testing.assert_allclose(engine.crank_acceleration[away], (speed * slope)[away], atol=5e-3 * scale)


def test_quadratic_load_against_the_equation_of_motion():
    found = run(load=RISING, flywheel_moment="8 kg·m²")
    assert found.mean_speed_over_time == pytest.approx(SPEED, rel=1e-10)
    # the mean of ω² over the angle is work over kΦ
    factor = WORK / CYCLE / float(np.mean(found.crank_speed**2))
    speeds, time = integrated(float(found.crank_speed[0]), lambda speed: factor * speed**2)
    spread = np.ptp(speeds)
    assert speeds[-1] == pytest.approx(speeds[0], abs=1e-4 * spread)
    np.testing.assert_allclose(found.crank_speed, speeds[:-1], rtol=0, atol=1e-4 * spread)
    assert CYCLE / time == pytest.approx(SPEED, rel=1e-6)


def test_motor_against_the_equation_of_motion():
    """An engine that drives a motor beyond its no-load speed brakes itself on it."""
    found = run(motor={"torque": "50 N·m", "speed": "890 rpm", "no_load_speed": "900 rpm"}, flywheel="2 kg·m²")
    stiffness = 50 / (2 * np.pi / 6)
    speeds, time = integrated(float(found.crank_speed[0]), lambda speed: stiffness * (speed - SPEED))
    spread = np.ptp(speeds)
    assert speeds[-1] == pytest.approx(speeds[0], abs=1e-4 * spread)
    np.testing.assert_allclose(found.crank_speed, speeds[:-1], rtol=0, atol=1e-4 * spread)
    assert found.mean_speed_over_time == pytest.approx(CYCLE / time, rel=1e-6)
    # the mean over the angle balances exactly
    assert found.mean_speed_over_angle == pytest.approx(SPEED + WORK / CYCLE / stiffness, rel=1e-6)


@pytest.mark.parametrize("mean", ["time", "extremes"])
@pytest.mark.parametrize("coefficient", [0.001, 0.02, 0.5, 1.9])
def test_the_flywheel_wanted_gives_what_is_wanted(coefficient, mean):
    size = run(coefficient=coefficient, mean=mean)
    assert size.labels["flywheel_method"] == ("exact", "mertsalov", "textbook")
    assert size.flywheel_fluctuation[0] == pytest.approx(coefficient, rel=1e-9)
    np.testing.assert_array_equal(size.wanted_flywheel_moment, 4 * size.flywheel_inertia)
    found = run(flywheel=f"{float(size.flywheel_inertia[0])!r} kg·m²", mean=mean)
    assert found.coefficient_of_fluctuation == pytest.approx(coefficient, rel=1e-9)
    mean_speed = found.mean_speed_over_time if mean == "time" else found.mean_speed_of_extremes
    assert mean_speed == pytest.approx(SPEED, rel=1e-11)
    assert found.mean_speed_over_time <= found.mean_speed_over_angle


def test_textbook_is_the_excess_work_over_the_square_of_the_speed(engine):
    assert engine.flywheel_inertia[2] == pytest.approx(engine.largest_excess_work / (0.02 * SPEED**2), rel=1e-12)
    np.testing.assert_allclose(
        engine.flywheel_inertia_error, engine.flywheel_inertia / engine.flywheel_inertia[0] - 1, atol=1e-14
    )


def test_rim(engine):
    size, largest = float(engine.flywheel_inertia[0]), SPEED * 1.01
    assert 0.25 * engine.rim_mass * (0.5**2 + engine.rim_height**2) == pytest.approx(size, rel=1e-12)
    assert engine.rim_mass == pytest.approx(7200 * np.pi * 0.5 * engine.rim_height * engine.rim_width, rel=1e-12)
    assert engine.rim_mass_by_mean_diameter == pytest.approx(4 * size / 0.25, rel=1e-12)
    assert engine.rim_speed == pytest.approx(largest * (0.25 + engine.rim_height / 2), rel=1e-2)
    assert not [flag for flag in texts_of(engine.flags) if "rim" in flag]


def test_answer_says_against_what_the_shaft_runs():
    assert names_of(run(flywheel="2 kg·m²")) == ["excess work", "speed"]
    quadratic = run(flywheel="2 kg·m²", load=RISING)
    assert names_of(quadratic) == ["excess work", "speed", "load, on the mean"]
    assert line_of(quadratic, "Evenness", "load, on the mean").startswith(f"{WORK / CYCLE:.2f} N·m, ")


def test_flywheel_that_leaves_the_speed_at_large_is_doubted():
    assert any("is the flywheel right?" in flag for flag in texts_of(run(flywheel="0.01 kg·m²").flags))
    assert not any("is the flywheel right?" in flag for flag in texts_of(run(flywheel="2 kg·m²").flags))


def test_rim_of_the_flywheel_that_there_is_and_too_fast_for_it():
    found = run(flywheel="2 kg·m²", rim={"mean_diameter": "800 mm", "density": "7.2 g/cm³", "other_share": 0.1})
    assert 0.25 * found.rim_mass * (0.8**2 + found.rim_height**2) == pytest.approx(1.8, rel=1e-12)
    assert found.rim_speed == pytest.approx(found.largest_crank_speed * found.rim_outer_diameter / 2, rel=1e-12)
    assert any(re.search(r"too fast: at \d+\.\d+ m/s, and it bears 30\.00 m/s", flag) for flag in texts_of(found.flags))


def test_rim_without_room():
    found = run(flywheel="2 kg·m²", rim={"mean_diameter": "40 mm"})
    assert np.isnan(found.rim_height)
    assert any("too small" in flag for flag in texts_of(found.flags))
    assert names_of(found) == ["excess work", "speed"]


MASSES_ALONE: dict[str, Any] = {
    "shaft": {"main": {"speed": "300 rpm"}},
    "mechanism": {"kind": "scotch_yoke", "crank_radius": "100 mm"},
    "masses": {"piston": {"mass": "2 kg"}},
}


def test_masses_alone_to_rounding():
    """A yoke of mass m has J = m R² sin²φ: ω is between √(E/J_f) and √(E/(J_f + m R²)); no torque but inertia."""
    found = run(machine=MASSES_ALONE, flywheel="0.06 kg·m²", mean="extremes")
    ratio = np.sqrt(0.06 / 0.08)
    speed = 10 * np.pi
    assert found.coefficient_of_fluctuation == pytest.approx(2 * (1 - ratio) / (1 + ratio), rel=1e-13)
    assert found.largest_crank_speed == pytest.approx(2 * speed / (1 + ratio), rel=1e-13)
    assert found.smallest_crank_speed_at % 180 == pytest.approx(90, abs=1e-6)
    assert found.largest_excess_work == pytest.approx(0, abs=1e-12)
    exact = run(machine=MASSES_ALONE, coefficient=2 * (1 - ratio) / (1 + ratio), mean="extremes")
    assert exact.flywheel_inertia[0] == pytest.approx(0.06, rel=1e-12)


def test_gravity_is_a_torque():
    """The yoke's weight of m g works along Y: M_d = m g R sin φ, ΔA = 2 m g R, and no mean."""
    found = run(machine={**MASSES_ALONE, "gravity": True}, flywheel="1 kg·m²")
    assert found.largest_excess_work == pytest.approx(4 * 9.80665 * 0.1, rel=1e-12)
    assert found.mean_torque == pytest.approx(0, abs=1e-12)


def test_a_cycle_counts_from_the_crank_zero():
    shifted = run(machine={**ENGINE, "crank_zero": "90 deg"}, flywheel="2 kg·m²", coefficient=0.02)
    plain = run(flywheel="2 kg·m²", coefficient=0.02)
    np.testing.assert_allclose(shifted.crank_speed, np.roll(plain.crank_speed, -90), rtol=1e-9)
    assert (plain.largest_crank_speed_at - shifted.largest_crank_speed_at) % 720 == pytest.approx(90, abs=1e-6)
    np.testing.assert_allclose(shifted.flywheel_inertia, plain.flywheel_inertia, rtol=1e-9)


def test_answers(engine):
    assert line_of(engine, "Evenness", "excess work") == "615.3 J within a cycle"
    size = float(engine.flywheel_inertia[0])
    said = line_of(engine, "Evenness", "flywheel for δ 0.02")
    assert re.fullmatch(rf"{size:.3f} kg·m², Mertsalov [+−]\S+ %, textbooks [+−]\S+ %", said)
    least, most = engine.smallest_crank_speed, engine.largest_crank_speed
    rpm = np.array([least, most]) * 30 / np.pi
    said = f"{rpm[0]:.1f} to {rpm[1]:.1f} rpm, δ = {engine.coefficient_of_fluctuation:.5f}"
    assert line_of(engine, "Evenness", "speed") == said
    assert engine.mean_speed_over_time == pytest.approx(SPEED, rel=1e-9)
    assert engine.mean_speed_of_extremes == pytest.approx((least + most) / 2, rel=1e-12)


def test_links_that_do_not_close_give_nothing():
    short = {**ENGINE, "mechanism": {**ENGINE["mechanism"], "offset": "150 mm"}}
    table = {"flywheel": "2 kg·m²", "coefficient": 0.02, "rim": {"mean_diameter": "1 m"}}
    for load in ({}, RISING):
        found = ct.run(ct.Machine(**short, load=load, evenness=table), partial=True, step_degrees=2)
        for name in ("largest_excess_work", "coefficient_of_fluctuation", "rim_height"):
            assert np.isnan(getattr(found, name)), name
        assert np.all(np.isnan(found.flywheel_inertia))
        assert not [flag for flag in texts_of(found.flags) if "steady" in flag or "rim" in flag]


def test_designs():
    """Each of several designs is as if alone."""
    tables: list[dict[str, Any]] = [
        {"flywheel": "2 kg·m²", "coefficient": 0.02, "rim": {"mean_diameter": "500 mm"}},
        {"flywheel": "9 kg·m²", "coefficient": 0.3, "rim": {"mean_diameter": "300 mm"}},
    ]
    machines = [ct.Machine(**ENGINE, evenness=table) for table in tables]
    both = ct.run(machines, step_degrees=2)
    for design, machine in enumerate(machines):
        alone = ct.run(machine, step_degrees=2)
        for name in ("crank_speed", "coefficient_of_fluctuation", "flywheel_inertia", "rim_height", "excess_work"):
            np.testing.assert_allclose(getattr(both, name)[design], getattr(alone, name), rtol=1e-10, atol=1e-10)
        assert alone.summary() in both.summary(design)


@pytest.mark.parametrize("step", [1, 2, 10])
@pytest.mark.parametrize(
    "evenness",
    [
        {"flywheel": "2 kg·m²"},
        {"flywheel": "0.05 kg·m²"},
        {"flywheel": "2 kg·m²", "load": RISING},
    ],
)
def test_equation_of_motion_holds(step, evenness):
    (check,) = (check for check in run(step, **evenness).checks if check.name == "motion")
    assert np.all(check.passed), check.residual


def test_too_light_a_shaft_is_told():
    found = run(flywheel="0 kg·m²", mean="extremes")
    assert np.all(np.isnan(found.crank_speed))
    assert any("too light" in flag for flag in texts_of(found.flags))
    assert names_of(found) == ["excess work"]


def test_a_load_that_nothing_drives_is_told():
    rubbing = {**MASSES_ALONE, "mechanism": slider(), "friction": {"piston": 0.1}, "gravity": True}
    found = run(machine=rubbing, load=RISING, flywheel="1 kg·m²")
    assert np.all(np.isnan(found.crank_speed))
    assert any("gives work" in flag for flag in texts_of(found.flags))
    (check,) = [check for check in found.checks if check.name == "motion"]
    assert str(check.verdict()) == "needs steady running"


@pytest.mark.parametrize("mean", ["time", "extremes"])
@pytest.mark.parametrize("more", [{}, {"gravity": True}, {"friction": {"piston": 0.1}}])
def test_a_mean_that_nothing_fixes_is_kept(more, mean):
    """Masses alone give no mean torque: k = 0 of a load kω² fixes no speed, and E₀ is free as under no load at all."""
    machine = {**MASSES_ALONE, **more}
    found = run(machine=machine, load=RISING, flywheel="1 kg·m²", mean=mean)
    declared = found.mean_speed_over_time if mean == "time" else found.mean_speed_of_extremes
    np.testing.assert_allclose(declared, found.machines[0].main_shaft.speed.si, rtol=1e-12)
    even = run(machine=machine, flywheel="1 kg·m²", mean=mean)
    np.testing.assert_array_equal(found.crank_speed, even.crank_speed)
    assert any("nothing fixes the mean speed, and the declared one is kept" in flag for flag in texts_of(found.flags))
    assert names_of(found) == ["excess work", "speed"], "no load on the shaft"
    assert all(check.passed[0] for check in found.checks)


def test_the_second_run_keeps_it_too():
    machine = ct.Machine(**MASSES_ALONE, load=RISING, evenness={"flywheel": "1 kg·m²"})
    found = ct.run(machine, speed="running")
    np.testing.assert_allclose(found.mean_speed_over_time, machine.main_shaft.speed.si, rtol=1e-9)


def test_a_mean_that_nothing_fixes_in_one_of_two_designs():
    """Side by side with a design whose friction takes work, each says what it says alone."""
    rubbing = {**MASSES_ALONE, "mechanism": slider()}
    designs = [{**rubbing, "friction": {"piston": coefficient}} for coefficient in (0.0, 0.1)]
    table = {"flywheel": "1 kg·m²"}
    both = ct.run([ct.Machine(**design, load=RISING, evenness=table) for design in designs])
    np.testing.assert_allclose(both.mean_speed_over_time[0], both.machines[0].main_shaft.speed.si, rtol=1e-12)
    assert np.isnan(both.mean_speed_over_time[1])
    assert any("declared one is kept" in flag for flag in texts_of(both.flags))
    assert any("gives work" in flag for flag in texts_of(both.flags))


def test_a_motor_of_hardly_any_torque_turns_masses_alone_at_its_free_speed():
    """Without a mean torque there is no slip, however soft the motor."""
    motor = {"torque": "0.001 N·m", "speed": "900 rpm", "no_load_speed": "1000 rpm"}
    found = run(machine=MASSES_ALONE, motor=motor, flywheel="1 kg·m²")
    np.testing.assert_allclose(found.mean_speed_over_angle, 1000 * np.pi / 30, rtol=1e-9)


@pytest.mark.parametrize(
    ("machine", "verdict"),
    [
        (MASSES_ALONE, "holds"),
        (
            {**MASSES_ALONE, "masses": {"crank": {"mass": "1 kg", "along": "0 mm", "inertia": "1 kg·m²"}}},
            "has nothing to compare: the work of a cycle is rounding beside the energy",
        ),
    ],
)
def test_the_check_of_motion_blames_no_grid_for_work_that_there_is_not(machine, verdict):
    found = run(machine=machine, flywheel="1 kg·m²")
    (check,) = [check for check in found.checks if check.name == "motion"]
    assert str(check.verdict()) == verdict


def test_no_flywheel_needed_is_told():
    heavy = {"crank": {"mass": "50 kg", "along": "0 mm", "inertia": "5 kg·m²"}}
    found = run(machine={**ENGINE, "masses": heavy}, coefficient=0.1)
    assert found.flywheel_inertia[0] < 0
    assert not any("flywheel" in flag for flag in texts_of(found.flags))
    assert line_of(found, "Evenness", "flywheel for δ 0.1") == "none: the moving parts alone suffice"


def test_kinks_are_nodes_of_curves_and_smooth_curves_are_series(engine):
    between = engine[ShaftWork].excess.work.between
    for corner in CORNERS:
        assert np.min(np.abs(between.start - np.mod(corner, CYCLE))) < 1e-9
    assert run(machine=MASSES_ALONE, flywheel="1 kg·m²")[ShaftWork].excess.work.between is None


def test_without_a_load_it_is_said_what_is_missing():
    result = ct.run(ct.Machine(**ENGINE))
    missing = {name: texts_of(found.needs) for found in result.missing for name in found.results}
    assert missing["excess_work"] == ("[evenness]",)
    assert missing["crank_speed"] == ("[evenness]", "[evenness] flywheel or flywheel_moment")
    assert missing["flywheel_inertia"] == ("[evenness]", "[evenness] coefficient")
    assert "flywheel_moment" in result.catalogue


@pytest.mark.parametrize(
    ("table", "path", "words"),
    [
        ({"flywheel": "-1 kg·m²"}, "evenness.flywheel", "at least 0"),
        ({"flywheel": "2 kg"}, "evenness.flywheel", "a moment of inertia"),
        ({"coefficient": 2}, "evenness.coefficient", "less than 2"),
        ({"coefficient": 0}, "evenness.coefficient", "more than 0"),
        ({"flywheel": "1 kg·m²", "flywheel_moment": "4 kg·m²"}, "evenness.flywheel_moment", "must not stand beside"),
        ({"flywheel": "1 kg·m²", "rim": {}}, "evenness.rim.mean_diameter", "is missing"),
        ({"rim": {"mean_diameter": "1 m"}}, "evenness.rim", "needs a flywheel"),
        ({"mean": "angle"}, "evenness.mean", "must be one of"),
    ],
)
def test_refused(table, path, words):
    with pytest.raises(InputError) as caught:
        ct.Machine(**ENGINE, evenness=table)
    (problem,) = problems_told(caught.value.problems)
    assert problem.path == path
    assert words in problem.allowed


def test_gd2_in_technical_units():
    """8 kgf·m² is J = 2 kg·m², and so is 8·9.80665 N·m²."""
    one = run(10, flywheel_moment="8 kgf·m²")
    for table in ({"flywheel": "2 kg·m²"}, {"flywheel_moment": "78.4532 N·m²"}):
        np.testing.assert_allclose(run(10, **table).crank_speed, one.crank_speed, rtol=1e-14)


def test_headlines_and_comparisons_say_the_inertia_of_the_flywheel():
    """In both J is first; a GD² that is asked for is called so."""
    result = run(coefficient=0.01)
    assert "flywheel_inertia" in result.headline
    assert "wanted_flywheel_moment" not in result.headline
    compared = str(ct.compare(result, run(coefficient=0.02), quantities=["wanted_flywheel_moment", "flywheel_inertia"]))
    assert "flywheel inertia" in compared
    assert "wanted flywheel moment GD²" in compared
