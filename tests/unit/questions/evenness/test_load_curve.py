"""A load that is given as a curve: speed and flywheel in closed form or step by step, and what files may hold."""

from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from scipy.integrate import quad, solve_ivp
from tests.gas_engines import DUAL_CYCLE
from tests.sentences import AS_AT_THE_START, DESIGNS_ALIKE, FOUR_COLUMNS, NO_FILE, NO_NUMBERS, NO_UNIT
from tests.told import line_of, lines_of, texts_of

import cranktrain as ct
from cranktrain.errors import InputError
from cranktrain.io.machine_file import read_machine

INERTIA, SPEED = 5.0, 2 * np.pi * 5
DISC: dict[str, Any] = {
    "shaft": {"main": {"speed": "300 rpm"}},
    "mechanism": {"kind": "slider_crank", "crank_radius": "50 mm", "rod_length": "200 mm"},
    "masses": {"crank": {"mass": "1 kg", "along": "0 mm", "inertia": "1 kg·m²"}},
}
"""A crank alone: J is constant, and nothing drives it."""
FLYWHEEL = "4 kg·m²"

PEAK, START, END, RAMP = 400.0, 150.3, 169.7, 0.9
"""A pulse whose corners lie between the points of the grid. [N·m, deg]"""
PULSE = f"angle;load [N·m]\n0;0\n{START};0\n{START + RAMP};{PEAK}\n{END};{PEAK}\n{END + RAMP};0\n360;0\n"
MEAN = PEAK * (END - START) / 360


def run(text=PULSE, *, machine=DISC, scale="given", step=1.0, load=None, drive=None, **evenness):
    loads = {"saw": {"on": "main", "file": "load.csv", "text": text, "scale": scale}, **(load or {})}
    return ct.run(ct.Machine(**machine, load=loads, evenness=evenness, drive=drive), step_degrees=step)


def pulse(phi):
    corners = np.radians([0, START, START + RAMP, END, END + RAMP, 360])
    return np.interp(np.mod(phi, 2 * np.pi), corners, [0, 0, PEAK, PEAK, 0, 0])


def over_the_mean():
    """ΔA: what the pulse takes beyond the mean, a trapezoid."""
    height = PEAK - MEAN
    return height * np.radians(END - START - RAMP + RAMP * height / PEAK)


def test_a_pulse_on_a_disc_in_closed_form():
    """ω_M² − ω_m² = 2ΔA/J, so with the mean of the extremes δ = ΔA/(Jω²), whatever the grid."""
    for step in (1.0, 5.0):
        found = run(flywheel=FLYWHEEL, mean="extremes", step=step)
        assert found.largest_excess_work == pytest.approx(over_the_mean(), rel=1e-13)
        assert found.coefficient_of_fluctuation == pytest.approx(over_the_mean() / INERTIA / SPEED**2, rel=1e-12)
        assert found.largest_crank_speed_at == pytest.approx(START + RAMP * MEAN / PEAK, abs=1e-9)
        assert found.smallest_crank_speed_at == pytest.approx(END + RAMP * (1 - MEAN / PEAK), abs=1e-9)
        assert found.remaining_torque == pytest.approx(-MEAN, rel=1e-13)
        assert found.load_factor == 1
        said = f"a further {MEAN:.2f} N·m drives the shaft, which stands nowhere in the file"
        assert line_of(found, "Evenness", "balanced by") == said


def test_the_speed_of_a_disc_under_a_pulse_in_closed_form():
    found = run(flywheel=FLYWHEEL)
    start = float(found.crank_speed[0])

    def speed(phi):
        work = MEAN * phi - quad(pulse, 0, phi, points=np.radians([START, START + RAMP, END, END + RAMP]))[0]
        return np.sqrt(start**2 + 2 * work / INERTIA)

    angles = np.radians(found.crank_angle)
    np.testing.assert_allclose(found.crank_speed, [speed(phi) for phi in angles], rtol=1e-11)
    np.testing.assert_allclose(found.crank_acceleration, (MEAN - pulse(angles)) / INERTIA, rtol=0, atol=1e-10)
    time = quad(lambda phi: 1 / speed(phi), 0, 2 * np.pi, points=np.radians([START, END + RAMP]), limit=200)[0]
    assert 2 * np.pi / time == pytest.approx(SPEED, rel=1e-7)


def test_a_cosine_on_a_disc():
    """M_r = M₀(1 + a cos φ) gives Jω² = 2(E₀ − M₀ a sin φ); the sum over straight lines has (h/2)/tan(h/2) of it."""
    half = np.radians(0.5)
    text = "\n".join(f"{angle} {50 * (1 + 0.8 * np.cos(np.radians(angle))):.17g}" for angle in range(361))
    text = f"angle torque_Nm\n{text}"
    found = run(text, flywheel=FLYWHEEL, mean="extremes", coefficient=0.1)
    work = 2 * 50 * 0.8 * half / np.tan(half)
    assert found.largest_excess_work == pytest.approx(work, rel=1e-12)
    assert found.coefficient_of_fluctuation == pytest.approx(work / INERTIA / SPEED**2, rel=1e-12)
    # J = ΔA/(δω²), of which the disc has 1 kg·m², that both approximations leave out
    needed = work / 0.1 / SPEED**2
    np.testing.assert_allclose(found.flywheel_inertia, [needed - 1, needed, needed], rtol=1e-12)
    np.testing.assert_allclose(found.flywheel_fluctuation[0], 0.1, rtol=1e-12)


def integrated(start, torque):
    """Speed at whole degrees from a speed at 0, by steps along J ω ω′ = torque(φ, ω)."""
    at, speeds, state = np.radians(np.arange(361.0)), np.empty(361), start
    corners = np.radians([0, START, START + RAMP, END, END + RAMP, 360])
    for low, high in pairwise(corners):
        own = (at >= low - 1e-9) & (at <= high + 1e-9)
        found = solve_ivp(
            lambda phi, speed: torque(phi, speed) / INERTIA / speed,
            (low, high), [state], "DOP853", dense_output=True, rtol=1e-12, atol=1e-12,
        )  # fmt: skip
        speeds[own], state = found.sol(at[own])[0], found.y[0, -1]
    return speeds


def test_a_motor_drives_a_press():
    motor = {"kind": "shunt", "torque": "50 N·m", "speed": "280 rpm", "no_load_speed": "300 rpm"}
    found = run(flywheel=FLYWHEEL, drive={"motor": motor})
    stiffness = 50 / (2 * np.pi * 20 / 60)
    speeds = integrated(float(found.crank_speed[0]), lambda phi, speed: stiffness * (SPEED - speed) - pulse(phi))
    assert speeds[-1] == pytest.approx(speeds[0], abs=1e-4 * np.ptp(speeds))
    np.testing.assert_allclose(found.crank_speed, speeds[:-1], rtol=0, atol=1e-4 * np.ptp(speeds))
    # the mean over the angle balances exactly
    assert found.mean_speed_over_angle == pytest.approx(SPEED - MEAN / stiffness, rel=1e-4)
    assert not any(line.startswith("balanced by: ") for line in lines_of(found, "Evenness"))


ENGINE: dict[str, Any] = {
    "shaft": {"main": {"speed": "900 rpm"}},
    "mechanism": {"kind": "slider_crank", "crank_radius": "50 mm", "rod_length": "180 mm"},
    "cylinder": {"bore": "85 mm", "compression_ratio": 16, "cycle": "four-stroke", "firing_order": "1"},
    "masses": {"piston": {"mass": "1.2 kg"}, "rod": {"mass": "1.6 kg", "along": "60 mm", "inertia": "0.008 kg·m²"}},
    "gas": DUAL_CYCLE,
}
EVEN = "angle;load [N·m]\n0;7\n360;7\n"


@pytest.mark.parametrize("scale", ["given", "balanced"])
def test_an_even_curve_is_a_constant_load(scale):
    """On a four-stroke engine the curve of one turn counts for both."""
    plain = ct.run(ct.Machine(**ENGINE, evenness={"flywheel": "2 kg·m²", "coefficient": 0.02}))
    found = run(EVEN, machine=ENGINE, scale=scale, flywheel="2 kg·m²", coefficient=0.02)
    for name in ("crank_speed", "crank_acceleration", "flywheel_inertia", "largest_excess_work"):
        np.testing.assert_allclose(getattr(found, name), getattr(plain, name), rtol=1e-11, atol=1e-9, err_msg=name)
    factor = plain.mean_torque / 7 if scale == "balanced" else 1
    assert found.load_torque == pytest.approx(7 * factor, rel=1e-9)
    assert found.load_factor == pytest.approx(factor, rel=1e-9)
    assert found.remaining_torque == pytest.approx(plain.mean_torque - 7 * factor, rel=1e-9, abs=1e-9)
    if scale == "given":
        said = f"a further {plain.mean_torque - 7:.2f} N·m loads the shaft, which stands nowhere in the file"
        assert line_of(found, "Evenness", "balanced by") == said
    else:
        said = line_of(found, "Evenness", "load, on the mean")
        assert said.startswith(f"{plain.mean_torque:.2f} N·m, at most ")
        assert said.endswith(f": the given one times {factor:.3f}")


def test_what_a_curve_leaves_may_rise_with_the_speed():
    rising = {"screw": {"on": "main", "scale": "balanced", "exponent": 2}}
    plain = ct.run(ct.Machine(**ENGINE, load=rising, evenness={"flywheel": "2 kg·m²"}))
    found = run("angle;load [N·m]\n0;0\n360;0", machine=ENGINE, flywheel="2 kg·m²", load=rising, scale="given")
    np.testing.assert_allclose(found.crank_speed, plain.crank_speed, rtol=1e-12)


def test_an_engine_that_drives_its_own_torque_curve_runs_evenly_but_for_its_masses():
    """Against its own M_d the energy is constant: Jω² is, with J of flywheel and moving parts."""
    plain = ct.run(ct.Machine(**ENGINE, evenness={"flywheel": "2 kg·m²"}), step_degrees=0.5)
    rows = zip(plain.crank_angle, plain.applied_torque, strict=True)
    text = "\n".join(f"{angle} {torque:.17g}" for angle, torque in rows)
    found = run("angle  torque_Nm\n" + text, machine=ENGINE, flywheel="2 kg·m²", step=0.5, scale="balanced")
    energy = (found.flywheel_moment / 4 + 2) * found.crank_speed**2
    assert found.largest_excess_work < 2e-4 * plain.largest_excess_work
    np.testing.assert_allclose(energy, np.mean(energy), rtol=1e-5)
    # Straight lines between samples at equal steps have the samples' own mean.
    assert found.load_factor == pytest.approx(plain.mean_torque / np.mean(plain.applied_torque), rel=1e-12)


def test_the_curve_counts_from_the_crank_zero():
    """A zero that is 40° later takes the curve along."""
    plain = run(flywheel=FLYWHEEL)
    moved = run(machine={**DISC, "crank_zero": "40 deg"}, flywheel=FLYWHEEL)
    np.testing.assert_allclose(moved.crank_speed, plain.crank_speed, rtol=1e-13)


def test_units_and_columns():
    """Radians, kgf·m, decimal commas, columns as told; in equal steps without the last point."""
    angles = np.radians(np.arange(0, 360, 30))
    rows = "\n".join(f"x;{5 + np.cos(one):.15f};{one:.15f}".replace(".", ",")[2:] for one in angles)
    text = "Момент, кгс·м;угол, рад\n" + rows
    saw = {"on": "main", "file": "load.csv", "text": text, "columns": [2, 1]}
    found = ct.run(ct.Machine(**DISC, load={"saw": saw}, evenness={"flywheel": FLYWHEEL}), step_degrees=30)
    np.testing.assert_allclose(found.load_torque, 9.80665 * (5 + np.cos(angles)), rtol=1e-13)


def test_a_load_that_cannot_be_scaled_is_told():
    found = run(scale="balanced", flywheel=FLYWHEEL)
    assert np.all(np.isnan(found.crank_speed))
    assert any("is for a machine that gives work" in flag for flag in texts_of(found.flags))
    assert lines_of(found, "Evenness") == []


HEAD = "angle [deg];torque [N·m]\n"


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (HEAD + "0;1\n90;2\n90;3\n80;1\n360;1", [
            "load.csv:4:1  load.saw = 90: must be more than the angle in line 3, 90;"
            " for a jump, give two angles a little apart",
            "load.csv:5:1  load.saw = 80: must be more than the angle in line 4, 90",
        ]),
        (HEAD + "0;1\n90;2\n300;1", [
            "load.csv:4:1  load.saw.file = load.csv: reaches from 0° to 300°;"
            " it must go on over one turn, 360°, or over two, 720°;"
            " give the torque at both ends, or in equal steps all round"
        ]),
        (HEAD + "0;1\n3.14159265;2\n6.28318531;1", ["if these are radians, write so in the header: angle [rad]"]),
        (HEAD + "0;1\n90;2\n360;9", [
            f"load.csv:4:1  load.saw = 9: {AS_AT_THE_START}, 1, as it begins again there"
        ]),
        (HEAD + "0;1\n90;\n180;two\n360;1", [
            "load.csv:3  load.saw = 1 values: must have 2 values, as the first line of numbers has",
            "load.csv:4:5  load.saw = two: must be a number",
        ]),
        ("angle;torque\n0;1\n360;1", [
            f"load.saw.file = load.csv: {NO_UNIT} force or torque, in the head “torque”;"
            " write it in the head: force [kN]"
        ]),
        ("0;1\n360;1", [f"{NO_UNIT} travel or angle", f"{NO_UNIT} force or torque"]),
        ("nothing", [f"load.csv: {NO_NUMBERS}"]),
        ("0;1;2;3\n360;1;2;3", [f"load.saw.columns: {FOUR_COLUMNS}"]),
        ("0\n360", ["load.csv:1  load.saw: has one column; a load needs two"]),
    ],
)  # fmt: skip
def test_refused(text, said):
    with pytest.raises(InputError) as caught:
        run(text)
    problems = [str(problem) for problem in caught.value.problems]
    assert len(problems) == len(said), problems
    for problem, words in zip(problems, said, strict=True):
        assert words in problem


def test_many_wrong_angles_are_counted():
    with pytest.raises(InputError) as caught:
        run(HEAD + "\n".join(f"{-angle};1" for angle in range(15)))
    assert len(caught.value.problems) == 11
    assert "4 more angles like these" in str(caught.value)


@pytest.mark.parametrize(
    ("curve", "beside", "paths"),
    [
        ({"columns": [1, 4]}, {}, ["saw.columns"]),
        ({"scale": "balanced", "text": HEAD + "0;-1\n360;-1"}, {}, ["saw.torque"]),
        ({"scale": "balanced"}, {"fan": {"on": "main", "scale": "balanced", "exponent": 2}}, ["fan.scale"]),
        ({"torque": "5 N·m"}, {}, ["saw.torque"]),
        ({"scale": "balanced", "sense": "active"}, {}, ["saw.sense"]),
        ({"scale": "balanced", "on": "piston"}, {}, ["saw.scale"]),
        ({}, {"fan": {"on": "main", "torque": "1 N·m", "scale": "balanced"}}, ["fan.torque"]),
        ({}, {"fan": {"on": "main", "force": "1 N"}}, ["fan.on"]),
        ({}, {"fan": {"on": "mian", "torque": "1 N·m"}}, ["fan.on"]),
        ({}, {"fan": {"on": "main", "torque": ["1 N·m", "2 N·m"], "swing": ["0 deg", "90 deg"]}}, ["fan.swing"]),
    ],
)
def test_tables_refused(curve, beside, paths):
    with pytest.raises(InputError) as caught:
        run_load({"saw": {"on": "main", "file": "load.csv", "text": PULSE, **curve}, **beside})
    assert [problem.path for problem in caught.value.problems] == [f"load.{path}" for path in paths]


def run_load(load):
    return ct.run(ct.Machine(**DISC, load=load, evenness={"flywheel": FLYWHEEL}))


def test_a_load_that_is_to_balance_stands_beside_no_motor():
    motor = {"kind": "shunt", "torque": "5 N·m", "speed": "290 rpm", "no_load_speed": "300 rpm"}
    machine = ct.Machine(**DISC, load={"fan": {"on": "main", "scale": "balanced"}}, drive={"motor": motor})
    with pytest.raises(InputError) as caught:
        ct.run(machine)
    assert [problem.path for problem in caught.value.problems] == ["load.fan.scale"]


def test_a_shaft_load_of_two_parts_adds_up():
    """Constant, by the speed and over the angle: their work is that in closed form, and the shaft is driven besides."""
    load = {
        "fan": {"on": "main", "torque": "6 N·m", "at_turning": "150 rpm", "exponent": 2},
        "pump": {"on": "main", "torque": "11 N·m"},
        "saw": {"on": "main", "torque": ["0 N·m", "90 N·m", "0 N·m"], "crank_angles": ["30 deg", "40 deg", "60 deg"]},
        "starter": {"on": "main", "torque": "2 N·m", "sense": "active"},
    }
    found = run_load(load)
    turn = 2 * np.pi
    works = [-6 * 4 * turn, -11 * turn, -90 * np.radians(30) / 2, 2 * turn]
    np.testing.assert_allclose(found.load_work, works, rtol=1e-12)
    mean = -sum(works) / turn
    assert found.remaining_torque == pytest.approx(-mean, rel=1e-12)
    assert np.mean(found.driving_torque) == pytest.approx(mean, rel=1e-3)
    assert found.largest_load_torque == pytest.approx(24 + 11 + 90 - 2, rel=1e-12)
    np.testing.assert_allclose(found.load_power[2], -found.load_torque[2] * 0 + found.load_torque_on_crank[2] * SPEED)


def test_against_a_brake_by_the_speed_the_shaft_runs_as_integrated():
    """A disc driven by a constant torque against a pulse and a brake that goes with the speed to the power 1.5."""
    brake = {"on": "main", "torque": "30 N·m", "at_turning": "300 rpm", "exponent": 1.5}
    found = run(load={"brake": brake}, flywheel=FLYWHEEL)
    driving = float(np.mean(30 * (found.crank_speed / SPEED) ** 1.5)) + MEAN

    def torque(phi, speed):
        return driving - 30 * (speed / SPEED) ** 1.5 - pulse(phi)

    speeds = integrated(float(found.crank_speed[0]), torque)
    assert speeds[-1] == pytest.approx(speeds[0], abs=1e-4 * np.ptp(speeds))
    np.testing.assert_allclose(found.crank_speed, speeds[:-1], rtol=0, atol=1e-4 * np.ptp(speeds))
    assert found.mean_speed_over_time == pytest.approx(SPEED, rel=1e-10)


def test_a_constant_over_two_turns_is_one():
    two_stroke = {**DISC, "cylinder": {"cycle": "two-stroke"}}
    assert np.ptp(run(HEAD + "0;1\n720;1", flywheel=FLYWHEEL, machine=two_stroke).load_torque) == 0
    assert np.ptp(run(HEAD + "0;1\n720;1", flywheel=FLYWHEEL).load_torque) == 0
    assert np.ptp(run(HEAD + "0;1\n720;1", machine=ENGINE).load_torque) == 0


MACHINE = """
[shaft.main]
speed = "300 rpm"
[mechanism]
kind = "slider_crank"
crank_radius = "50 mm"
rod_length = "200 mm"
[masses.piston]
mass = "2 kg"
[evenness]
flywheel = "4 kg·m²"
[load.saw]
on = "main"
file = "shears.csv"
"""


def test_the_file_stands_beside_the_machine_file(tmp_path):
    (tmp_path / "machine.toml").write_text(MACHINE, encoding="utf-8")
    with pytest.raises(InputError) as caught:
        read_machine(tmp_path / "machine.toml")
    assert f"machine.toml:14:8  load.saw.file = shears.csv: {NO_FILE}" in str(caught.value)
    (tmp_path / "shears.csv").write_text(PULSE.replace(".", ","), encoding="utf-8")
    found = ct.run(read_machine(tmp_path / "machine.toml").machine)
    assert found.largest_load_torque == pytest.approx(PEAK, rel=1e-13)
    assert line_of(found, "Evenness", "load, on the mean") == "21.56 N·m, at most 400.0 N·m"


def pulse_of(peak, start, unit="N·m"):
    return f"angle;load [{unit}]\n0;0\n{start};0\n{start + 1};{peak}\n{start + 30};{peak}\n{start + 31};0\n360;0\n"


CURVES = (
    {"text": PULSE},
    {"text": pulse_of(90, 200, "kgf·m")},
    {"text": pulse_of(250, 20)},
)
MOTOR = {"motor": {"kind": "shunt", "torque": "60 N·m", "speed": "290 rpm", "no_load_speed": "300 rpm"}}
BALANCES = [(DISC, "given", {}), (ENGINE, "given", {}), (ENGINE, "balanced", {}), (DISC, "given", {"drive": MOTOR})]


@pytest.mark.parametrize(("machine", "scale", "balance"), BALANCES, ids=["disc", "engine", "balanced", "motor"])
def test_designs_may_have_curves_of_their_own(machine, scale, balance):
    """Each is as if it were alone, in its first and in its second run."""
    machines = [
        ct.Machine(
            **machine,
            load={"saw": {"on": "main", "file": f"{n}.csv", "scale": scale, **curve}},
            evenness={"flywheel": f"{4 + n} kg·m²", "coefficient": 0.03},
            **balance,
        )
        for n, curve in enumerate(CURVES)
    ]
    for speed in ("constant", "running"):
        together = ct.run(machines, speed=speed)
        for design, one in enumerate(machines):
            alone = ct.run(one, speed=speed)
            assert together.summary(design) == alone.summary()
            for name in alone.catalogue:
                several, single = getattr(together, name)[design], getattr(alone, name)
                scale_of = np.fmax.reduce(np.abs(single), axis=None, initial=0.0)
                # Of a disc alone nothing rolls the frame: what is left there is rounding of torques of 100 N·m.
                rounding = 1e-12 * (scale_of + (alone.catalogue[name].unit == "deg") + (name == "rolling_moment"))
                np.testing.assert_allclose(several, single, rtol=0, atol=rounding, err_msg=name)
    assert np.all(np.ptp(together.largest_load_torque) > 1.0)


def test_designs_with_a_curve_and_without_are_refused():
    saw = {"on": "main", "file": "load.csv", "text": PULSE}
    machines = [ct.Machine(**DISC, load=load, evenness={"flywheel": FLYWHEEL}) for load in ({"saw": saw}, {})]
    with pytest.raises(InputError, match=DESIGNS_ALIKE):
        ct.run(machines)
    scaled = ct.Machine(**DISC, load={"saw": {**saw, "scale": "balanced"}}, evenness={"flywheel": FLYWHEEL})
    with pytest.raises(InputError, match=rf"load\.saw\.scale: {DESIGNS_ALIKE}"):
        ct.run([machines[0], scaled])
