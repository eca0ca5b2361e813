"""One moment with a speed and an angular acceleration: x″ω² + x′ε, M = Jε + ½J′ω² and the power balance."""

import numpy as np
import pytest
from tests.gas_engines import DUAL_CYCLE
from tests.machines import RADIUS, ROD, slider

import cranktrain as ct
from cranktrain.analysis import speed_over_cycle

OMEGA, EPSILON = 120.0, -340.0
MASS, INERTIA, BALLAST = 2.5, 0.03, {"crank": {"mass": "1 kg", "along": "0 mm", "inertia": "0.03 kg·m²"}}
PHI = np.radians(np.arange(360.0))


def travel(phi):
    """Pin from the shaft, by R and L, and its first three derivatives by the crank angle, as power series would do."""
    sin, cos = RADIUS * np.sin(phi), RADIUS * np.cos(phi)
    root = np.sqrt(ROD**2 - sin**2)
    first = -sin - sin * cos / root
    second = -cos - (cos**2 - sin**2) / root - (sin * cos) ** 2 / root**3
    return cos + root, first, second


def at_moment(speed=OMEGA, acceleration=EPSILON, **tables):
    shaft = {"main": {"speed": f"{speed!r} rad/s", "acceleration": f"{acceleration!r} rad/s²"}}
    return ct.Machine(
        shaft=shaft,
        **{"mechanism": slider(), "masses": {"piston": {"mass": f"{MASS} kg"}, **BALLAST}, **tables},
    )


@pytest.mark.parametrize("acceleration", [EPSILON, 0.0, 5000.0])
def test_motion_and_torque_of_a_slider_crank(acceleration):
    result = ct.run(at_moment(acceleration=acceleration))
    _x, first, second = travel(PHI)
    outward = second * OMEGA**2 + first * acceleration
    scale = np.max(np.abs(outward))
    np.testing.assert_allclose(result.piston_velocity[0], -first * OMEGA, atol=1e-12)
    np.testing.assert_allclose(result.piston_acceleration[0], -outward, atol=1e-13 * scale)
    torque = MASS * first * outward + INERTIA * acceleration
    np.testing.assert_allclose(result.driving_torque, torque, atol=1e-12 * np.max(np.abs(torque)))
    np.testing.assert_allclose(result.shaking_force_y[0], -MASS * outward, atol=1e-10 * MASS * scale)
    assert result.largest_piston_acceleration[0] >= np.max(-outward) - 1e-9
    assert all(np.all(check.passed) for check in result.checks)


def test_power_is_what_the_kinetic_energy_gains():
    """A rod with any centroid: M ω = d(½ J ω²)/dt = J ω ε + ½ J′ ω³, J by a run at constant speed."""
    rod = {"mass": "1.2 kg", "along": "60 mm", "across": "8 mm", "inertia": "0.006 kg·m²"}
    masses = {"piston": {"mass": "2.5 kg"}, "rod": rod, **BALLAST}
    steady = ct.run(ct.Machine(shaft={"main": {"speed": "1 rad/s"}}, mechanism=slider(), masses=masses))
    inertia = steady.reduced_inertia
    series = np.fft.rfft(inertia)
    slope = np.fft.irfft(series * 1j * np.arange(series.size), inertia.size)
    power = inertia * OMEGA * EPSILON + slope * OMEGA**3 / 2
    result = ct.run(at_moment(masses=masses))
    np.testing.assert_allclose(result.driving_torque * OMEGA, power, atol=1e-10 * np.max(np.abs(power)))


def test_astern_it_gains_speed_in_the_sense_of_running():
    ahead, astern = (ct.run(at_moment(running=running)) for running in ("ahead", "astern"))
    np.testing.assert_allclose(astern.driving_torque, ahead.driving_torque, rtol=1e-12, atol=1e-9)


def test_without_acceleration_it_is_constant_speed():
    moment = ct.run(at_moment(acceleration=0.0))
    steady = ct.run(
        ct.Machine(
            shaft={"main": {"speed": f"{OMEGA!r} rad/s"}},
            mechanism=slider(),
            masses={"piston": {"mass": f"{MASS} kg"}, **BALLAST},
        )
    )
    for name in ("driving_torque", "piston_acceleration", "shaking_force_y", "joint_force_x", "largest_torque"):
        expected = getattr(steady, name)
        np.testing.assert_allclose(getattr(moment, name), expected, atol=1e-10 * np.nanmax(np.abs(expected)))


def test_what_only_steady_running_has_is_left_out_and_said():
    machine = at_moment(evenness={"flywheel": "0.5 kg·m²", "coefficient": 0.02})
    result = ct.run(machine)
    assert "crank_speed" not in result.catalogue
    assert "excess_work" not in result.catalogue
    assert "flywheel_inertia" not in result.catalogue
    needs = {str(need) for missing in result.missing if "crank_speed" in missing.results for need in missing.needs}
    assert needs == {"steady running, without [shaft.main] acceleration,"}
    assert "What only steady running has is left out." in result.summary()


@pytest.mark.parametrize("gas", ["dual", "indicator"])
def test_the_work_of_the_gas_is_that_of_the_torque_and_what_the_inertia_gained(gas):
    cylinder = {"bore": "100 mm", "compression_ratio": 14, "cycle": "two-stroke"}
    trace = "\n".join(
        ["angle [deg];p abs [bar]", *(f"{k};{30 + 25 * np.cos(np.radians(k - 8)):.12f}" for k in range(360))]
    )
    table = DUAL_CYCLE if gas == "dual" else {"kind": "indicator", "file": "a.csv", "text": trace}
    result = ct.run(at_moment(gas=table, cylinder=cylinder))
    (check,) = [check for check in result.checks if check.name == "work"]
    assert np.all(check.passed)
    _x, first, _second = travel(PHI)
    gained = EPSILON * 2 * np.pi * np.mean(MASS * first**2 + INERTIA)
    given = 2 * np.pi * np.mean(result.machine_torque)
    assert given == pytest.approx(result.gas_work - gained, abs=1e-3 * abs(result.gas_work))
    assert abs(gained) > 0.02 * abs(result.gas_work)


def test_plans_are_of_the_moment_too():
    drive = speed_over_cycle(at_moment(), "constant").drive(np.array([0.3, 2.0]))
    np.testing.assert_allclose(np.ravel(drive.speed), OMEGA, rtol=1e-15)
    np.testing.assert_allclose(np.ravel(drive.acceleration), EPSILON, rtol=1e-15)


def test_designs_have_moments_of_their_own():
    both = ct.run([at_moment(), at_moment(speed=80.0, acceleration=200.0)])
    for design, (speed, acceleration) in enumerate([(OMEGA, EPSILON), (80.0, 200.0)]):
        alone = ct.run(at_moment(speed=speed, acceleration=acceleration))
        np.testing.assert_allclose(both.driving_torque[design], alone.driving_torque, rtol=1e-13, atol=1e-11)


@pytest.mark.parametrize(
    ("shafts", "path", "said"),
    [
        ({"main": {"acceleration": "5 rad/s²"}}, "shaft.main.speed", "a moment has a speed and an acceleration"),
        (
            {"main": {"speed": "9 rpm", "acceleration": "5 rpm"}},
            "shaft.main.acceleration",
            "an angular acceleration in",
        ),
    ],
)
def test_moments_that_cannot_be(shafts, path, said):
    with pytest.raises(ct.InputError) as caught:
        ct.run(ct.Machine(shaft=shafts, mechanism=slider()))
    (problem,) = caught.value.problems
    assert problem.path == path
    assert said in str(problem.allowed)


def test_an_acceleration_stands_at_the_main_shaft():
    banks = {"A": {"mechanism": slider(), "shaft": "other"}}
    with pytest.raises(ct.InputError, match=r"shaft\.other\.acceleration = 5 rad/s²: must stand in \[shaft.main\]"):
        ct.Machine(shaft={"other": {"speed": "9 rpm", "acceleration": "5 rad/s²"}}, bank=banks)


@pytest.mark.parametrize("speed", ["running", np.full(360, 100.0)])
def test_a_moment_has_no_other_speed(speed):
    with pytest.raises(ct.InputError, match="acceleration says how the shaft turns, at one moment"):
        ct.run(at_moment(), speed=speed)
