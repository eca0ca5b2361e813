"""Evenness: closed forms, identities that can fail, and step-by-step integration as an independent judge."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import quad, solve_ivp
from tests.excess import excess_work

from cranktrain.numerics.periodic import (
    cycle_grid,
    fourier_curve,
    fourier_integral,
    plus,
    spline_curve,
    spline_integral,
)
from cranktrain.questions.evenness.flywheel_inertia import (
    METHODS,
    exact_flywheel,
    flywheels_by_method,
    mertsalov_inertia,
    textbook_inertia,
)
from cranktrain.questions.evenness.mean_speed import balancing_coefficient, with_load
from cranktrain.questions.evenness.speed_law import Power, TorqueLaw, linear_periodic, speed_under_law
from cranktrain.questions.evenness.speed_over_cycle import steady_speed
from cranktrain.texts.flywheel_diagrams import mertsalov, wittenbauer

FEW = settings(max_examples=40, deadline=None, derandomize=True)

N = 360
TURN = 2 * np.pi
PHI = cycle_grid(N)
R, L, MASS = 0.05, 0.18, 9.0


def driving(phi):
    return 100 + 160 * np.sin(phi) + 90 * np.sin(2 * phi) - 40 * np.cos(phi)


def carried(phi):
    slope = R * np.sin(phi) * (1 + R * np.cos(phi) / np.sqrt(L**2 - (R * np.sin(phi)) ** 2))
    return MASS * slope**2


EXCESS = excess_work(driving(PHI) - 100)
VARIABLE = fourier_curve(carried(PHI))


def constant(inertia):
    return fourier_curve(np.full(N, inertia))


def test_largest_excess_work_of_a_sine():
    # ∫ sin over half a turn is 2; the extremes lie between the nodes of seven points
    found = excess_work(3 + 5 * np.sin(cycle_grid(7) - 0.2))
    assert found.difference == pytest.approx(10, abs=1e-13)
    assert found.mean_excess == pytest.approx(3, abs=1e-14)
    assert found.smallest.angle[0] == pytest.approx(0.2, abs=1e-13)


@pytest.mark.parametrize(("n_points", "lost"), [(36, 0.006), (72, 0.0016)])
def test_coarse_steps_lose_nothing_but_by_the_trapezoid(n_points, lost):
    exact = EXCESS.difference
    phi = cycle_grid(n_points)
    torque = driving(phi) - 100
    assert excess_work(torque).difference == pytest.approx(exact, rel=1e-13)
    sums = np.cumsum((torque + np.roll(torque, -1)) / 2) * (TURN / n_points)
    assert 1 - (sums.max() - sums.min()) / exact == pytest.approx(lost, rel=0.15)


@pytest.mark.parametrize("mean", ["time", "extremes"])
def test_splines_serve_as_well(mean):
    excess = excess_work(driving(PHI) - 100, by=spline_integral)
    variable = spline_curve(carried(PHI))
    found = exact_flywheel(excess, variable, 60.0, 0.04, mean)
    # 1° steps: fourth powers of the step times the fourth derivative
    assert found.inertia == pytest.approx(float(exact_flywheel(EXCESS, VARIABLE, 60.0, 0.04, mean).inertia), rel=1e-8)
    speed = steady_speed(excess, plus(variable, found.inertia), 60.0, mean)
    assert speed.fluctuation(mean) == pytest.approx(0.04, rel=1e-11)


@pytest.mark.parametrize("by", [fourier_integral, spline_integral])
@pytest.mark.parametrize("mean", ["time", "angle", "extremes"])
def test_even_torque_runs_evenly(by, mean):
    still = excess_work(np.full(N, 100.0), by=by)
    assert still.difference == pytest.approx(0, abs=1e-12)
    assert still.mean_excess == pytest.approx(100, rel=1e-15)
    found = steady_speed(still, constant(2.0), 60.0, mean)
    np.testing.assert_allclose(found.speed, 60, rtol=1e-13)
    assert found.fluctuation(mean) == pytest.approx(0, abs=1e-13)


def test_a_cycle_of_two_turns_is_one_cycle():
    # ½ order: 1/k = 2
    cycle = 4 * np.pi
    found = excess_work(5 * np.sin(cycle_grid(16, cycle) / 2), cycle)
    assert found.difference == pytest.approx(20, abs=1e-13)


def test_spline_for_a_torque_with_jumps():
    # ±1 for half a turn each: ΔA = π; the spline rounds the corners by some 0.1 of a step, the series rings
    square = np.where(cycle_grid(720) < np.pi, 1.0, -1.0)
    step = TURN / 720
    assert excess_work(square, by=spline_integral).difference == pytest.approx(np.pi, abs=0.5 * step)


@pytest.mark.parametrize("mean", ["time", "angle", "extremes"])
def test_the_mean_that_was_given_is_met(mean):
    speeds = np.array([20.0, 60.0])
    found = steady_speed(EXCESS, plus(VARIABLE, np.array([3.0, 1.5])), speeds, mean)
    np.testing.assert_allclose(getattr(found.means, mean), speeds, rtol=1e-13)
    assert np.all(found.means.time < found.means.angle)


def test_time_of_a_cycle_by_quadrature():
    found = steady_speed(EXCESS, plus(VARIABLE, 2.0), 60.0)
    start = (carried(0.0) + 2.0) * found.speed[0] ** 2 / 2

    def slowness(phi):
        at = np.array([phi])
        return float(np.sqrt((VARIABLE.value(at) + 2.0) / (2 * (start + EXCESS.work.value(at))))[0])

    assert quad(slowness, 0, TURN, epsabs=1e-13, epsrel=1e-13)[0] == pytest.approx(TURN / 60, rel=1e-12)


def test_energy_balance_of_the_speed():
    found = steady_speed(EXCESS, plus(VARIABLE, 2.0), 60.0)
    energy = 0.5 * (carried(PHI) + 2.0) * found.speed**2
    np.testing.assert_allclose(energy - energy[0], EXCESS.work.value(PHI), atol=1e-10)


def test_too_little_inertia_has_no_steady_speed():
    found = steady_speed(EXCESS, constant(0.01), np.array([5.0, 500.0]))
    assert np.isnan(found.means.time[0])
    assert found.means.time[1] == pytest.approx(500, rel=1e-12)


@pytest.mark.parametrize("mean", ["time", "angle", "extremes"])
@pytest.mark.parametrize("fluctuation", [0.005, 0.04, 0.3])
def test_flywheel_gives_what_was_asked_for(mean, fluctuation):
    found = exact_flywheel(EXCESS, VARIABLE, 60.0, fluctuation, mean)
    speed = steady_speed(EXCESS, plus(VARIABLE, found.inertia), 60.0, mean)
    assert speed.fluctuation(mean) == pytest.approx(fluctuation, rel=1e-11)
    start = (carried(0.0) + found.inertia) * speed.speed[0] ** 2 / 2
    assert start == pytest.approx(found.initial_energy, rel=1e-11)
    assert speed.largest.value[0] == pytest.approx(found.largest_speed, rel=1e-12)
    assert speed.smallest.value[0] == pytest.approx(found.smallest_speed, rel=1e-12)


def test_flywheel_by_stepping_through_time():
    found = exact_flywheel(EXCESS, VARIABLE, 60.0, 0.04)
    start = np.sqrt(2 * found.initial_energy / (found.inertia + carried(0.0)))

    def rates(_, state):
        angle, speed = state
        step = 1e-4
        slope = (carried(angle + step) - carried(angle - step)) / (2 * step)
        return speed, (driving(angle) - 100 - slope * speed**2 / 2) / (found.inertia + carried(angle))

    done = solve_ivp(rates, (0, TURN / 60), (0.0, start), method="DOP853", rtol=1e-12, atol=1e-12, dense_output=True)
    # after the time of one turn at the mean speed: one turn, at the speed of the start
    assert done.y[0, -1] == pytest.approx(TURN, abs=1e-9)
    assert done.y[1, -1] == pytest.approx(start, rel=1e-9)
    speeds = done.sol(np.linspace(0, TURN / 60, 20001))[1]
    assert (speeds.max() - speeds.min()) / 60 == pytest.approx(0.04, rel=1e-6)


def test_textbook_flywheel_is_exact_without_variable_inertia():
    found = exact_flywheel(EXCESS, constant(0.0), 60.0, 0.1, "extremes")
    assert found.inertia == pytest.approx(float(textbook_inertia(EXCESS, 60.0, 0.1)), rel=1e-13)
    assert mertsalov_inertia(EXCESS, constant(0.0), 60.0, 0.1) == pytest.approx(float(found.inertia), rel=1e-13)


def test_constant_inertia_is_taken_off_the_flywheel():
    bare = exact_flywheel(EXCESS, VARIABLE, 60.0, 0.1)
    laden = exact_flywheel(EXCESS, plus(VARIABLE, 0.3), 60.0, 0.1)
    assert bare.inertia - laden.inertia == pytest.approx(0.3, rel=1e-12)


def test_methods_of_several_designs():
    found = flywheels_by_method(EXCESS, VARIABLE, np.array([60.0, 60.0]), np.array([0.04, 0.2]))
    assert found.inertia.shape == (2, len(METHODS))
    np.testing.assert_allclose(found.fluctuation[:, 0], [0.04, 0.2], rtol=1e-11)
    np.testing.assert_allclose(
        found.error[:, 1:], [[0.0011909588, 0.0286993898], [0.0057595425, 0.0333934987]], atol=1e-9
    )


def test_tangents_of_wittenbauers_diagram():
    flywheel = exact_flywheel(EXCESS, VARIABLE, 60.0, 0.1, "extremes")
    found = wittenbauer(EXCESS, VARIABLE, flywheel)
    for tangent, side in ((found.upper, 1), (found.lower, -1)):
        # no point of the curve beyond it, and it touches
        over = found.work - (tangent.slope * found.inertia + tangent.intercept)
        assert np.all(side * over <= 1e-10)
        assert tangent.work == pytest.approx(tangent.slope * tangent.inertia + tangent.intercept, abs=1e-10)
        # both meet where the energy and all inertia vanish
        met = tangent.slope * found.origin_inertia + tangent.intercept
        assert met == pytest.approx(found.origin_work, rel=1e-12)
    assert np.sqrt(2 * np.array([found.lower.slope, found.upper.slope])) == pytest.approx([57, 63], rel=1e-14)


def test_mertsalovs_diagram():
    found = mertsalov(EXCESS, VARIABLE, 60.0)
    np.testing.assert_allclose(found.carried_energy, 1800 * carried(PHI), atol=1e-11)
    np.testing.assert_allclose(found.flywheel_energy, found.work - found.carried_energy, atol=1e-11)
    difference = (found.largest.value - found.smallest.value)[0]
    assert difference / (0.04 * 3600) == pytest.approx(
        float(mertsalov_inertia(EXCESS, VARIABLE, 60.0, 0.04)), rel=1e-14
    )
    assert found.largest.value[0] >= found.flywheel_energy.max()


curves = st.lists(st.floats(-100, 100), min_size=4, max_size=4)


@FEW
@given(curves, curves, st.floats(0.01, 0.5))
def test_flywheel_of_any_curves(torque, inertia, fluctuation):
    samples = np.cos(np.outer(np.arange(1, 5), PHI))
    excess = excess_work(torque @ samples + 7)
    variable = fourier_curve(1 + 0.002 * (inertia @ samples))
    found = exact_flywheel(excess, variable, 50.0, fluctuation, "extremes")
    total = variable.value(PHI) + found.inertia
    if not np.all(total > 0.05):
        return  # the moving parts alone are too even, or too heavy, to be brought to so much
    speed = steady_speed(excess, plus(variable, found.inertia), 50.0, "extremes")
    assert speed.fluctuation("extremes") == pytest.approx(fluctuation, rel=1e-7)


def test_running_the_other_way_mirrors_the_speed():
    # time reversed: the torque of the cycle read backwards, with its sign changed, gives the mirrored speed
    back = excess_work(-(driving(-PHI) - 100))
    there = steady_speed(EXCESS, plus(VARIABLE, 2.0), 60.0)
    mirrored = steady_speed(back, plus(fourier_curve(carried(-PHI)), 2.0), 60.0)
    np.testing.assert_allclose(mirrored.speed, there.speed[-np.arange(N)], rtol=1e-11)


def test_linear_equation_with_constant_decay():
    # y′ + 0.3 y = cos φ has y = (0.3 cos φ + sin φ)/(0.09 + 1)
    found = linear_periodic(np.full(N, 0.3), np.cos(PHI))
    np.testing.assert_allclose(found, (0.3 * np.cos(PHI) + np.sin(PHI)) / 1.09, atol=1e-14)


def test_linear_equation_with_a_chosen_solution():
    cycle = 4 * np.pi
    phi = cycle_grid(241, cycle)
    decay = 0.2 + np.cos(phi / 2) + 0.5 * np.sin(phi)
    solution = 2 + np.sin(1.5 * phi)
    found = linear_periodic(decay, 1.5 * np.cos(1.5 * phi) + decay * solution, cycle)
    np.testing.assert_allclose(found, solution, atol=1e-12)
    assert np.all(np.isnan(linear_periodic(0 * phi, phi, cycle)))


def beside(torque, law):
    return law._replace(free=law.free + torque)


def plus_powers(law, *powers):
    return law._replace(powers=(*law.powers, *powers))


def motor(no_load_speed, stiffness):
    """M = c (ω_s − ω)."""
    return TorqueLaw(stiffness * no_load_speed, (Power(-stiffness, np.array(1.0)),))


def squared(coefficient):
    return Power(np.array(coefficient), np.array(2.0))


def laws():
    return {
        "fan": TorqueLaw(driving(PHI), (squared(-1 / 36),)),
        "motor": beside(-driving(PHI), motor(np.array(62.0), np.array(50.0))),
        "both": plus_powers(beside(driving(PHI) - 130, motor(np.array(61.0), np.array(3.0))), squared(-0.004)),
        "three": TorqueLaw(driving(PHI), (Power(np.array(-0.2), np.array(1.4)), Power(np.array(-3.0), np.array(0.5)))),
    }


@pytest.mark.parametrize("name", laws())
def test_speed_under_a_law_by_stepping_through_the_cycle(name):
    law = laws()[name]
    found = speed_under_law(law, carried(PHI) + 1.2)
    source = fourier_curve(np.broadcast_to(law.free, (N,)))
    powers = [(float(coefficient), float(exponent)) for coefficient, exponent in law.powers]

    def rate(phi, energy):
        speed = np.sqrt(2 * energy / (carried(phi) + 1.2))
        return source.value(np.array([phi]))[0] + sum(c * speed**p for c, p in powers)

    energy = (carried(PHI) + 1.2) * found.speed.speed**2 / 2
    start = energy[0]
    done = solve_ivp(rate, (0, TURN), [start], method="DOP853", rtol=1e-12, atol=1e-9, t_eval=[PHI[90], PHI[200], TURN])
    np.testing.assert_allclose(done.y[0], [energy[90], energy[200], start], rtol=1e-10)
    # a small departure shrinks by the multiplier
    shifted = solve_ivp(rate, (0, TURN), [start * (1 + 1e-5)], method="DOP853", rtol=1e-12, atol=1e-9)
    shrunk = (shifted.y[0, -1] - done.y[0, -1]) / (start * 1e-5)
    assert shrunk == pytest.approx(float(found.multiplier), rel=1e-3)


def test_means_of_law_torques_vanish():
    found = speed_under_law(laws()["both"], carried(PHI) + 1.2)
    assert np.mean(found.torque) == pytest.approx(0, abs=1e-11)


def test_designs_of_laws():
    law = TorqueLaw(driving(PHI), (squared([[-1 / 36], [-1 / 72]]),))
    found = speed_under_law(law, np.array([[1.2], [3.0]]) + carried(PHI))
    for row, (load, inertia) in enumerate(((1 / 36, 1.2), (1 / 72, 3.0))):
        one = speed_under_law(TorqueLaw(driving(PHI), (squared(-load),)), inertia + carried(PHI))
        np.testing.assert_allclose(found.speed.speed[row], one.speed.speed, rtol=1e-13)


def test_no_balance_is_nan():
    braked = TorqueLaw(-driving(PHI), (squared(-0.1),))
    assert np.isnan(speed_under_law(braked, carried(PHI) + 1).speed.means.time)
    free = TorqueLaw(driving(PHI) - 100)
    assert np.isnan(speed_under_law(free, carried(PHI) + 1).speed.means.time)


@pytest.mark.parametrize("mean", ["time", "angle", "extremes"])
def test_load_for_a_mean_speed(mean):
    inertia = carried(PHI) + np.array([[1.2], [4.0]])
    speeds = np.array([60.0, 30.0])
    shape = Power(np.array(1.0), np.array(2.0))
    coefficient = balancing_coefficient(TorqueLaw(driving(PHI)), shape, inertia, speeds, mean=mean)
    law = TorqueLaw(driving(PHI), (squared(-coefficient[:, np.newaxis]),))
    np.testing.assert_allclose(getattr(speed_under_law(law, inertia).speed.means, mean), speeds, rtol=1e-12)


@pytest.mark.parametrize("mean", ["time", "extremes"])
@pytest.mark.parametrize("shape", [None, Power(np.array(1.0), np.array(2.0)), Power(np.array(2.0), np.array(0.7))])
def test_what_balances_beside_a_brake_gives_the_mean_speed(shape, mean):
    """The mean of the whole law over the angle vanishes, however it depends on the speed."""
    law = TorqueLaw(driving(PHI), (Power(np.array(-0.3), np.array(1.0)), squared(-0.001)))
    speeds = np.array([60.0, 30.0])
    coefficient = balancing_coefficient(law, shape, carried(PHI) + np.array([[1.2], [4.0]]), speeds, mean=mean)
    found = speed_under_law(with_load(law, shape, coefficient[:, np.newaxis]), carried(PHI) + np.array([[1.2], [4.0]]))
    np.testing.assert_allclose(getattr(found.speed.means, mean), speeds, rtol=1e-12)
    np.testing.assert_allclose(np.mean(found.torque, axis=-1), 0.0, atol=1e-10)


def test_mean_speed_of_a_motor():
    """The mean of ω over the angle is ω_s − M̄/c: docs/theory/evenness, eq. (17.11)."""
    law = beside(-driving(PHI), motor(np.array(62.0), np.array(20.0)))
    assert speed_under_law(law, carried(PHI) + 1.2).speed.means.angle == pytest.approx(62 - 100 / 20, rel=1e-12)


def test_the_highest_order_is_damped_as_all_others():
    """y′ + gy = cos kφ has y = (g cos kφ + k sin kφ)/(g² + k²), also where the grid sees only the cosine."""
    decay = np.full(12, 0.01)
    for k in (5, 6):
        phi = cycle_grid(12)
        expected = (0.01 * np.cos(k * phi) + k * np.sin(k * phi)) / (0.01**2 + k**2)
        np.testing.assert_allclose(linear_periodic(decay, np.cos(k * phi)), expected, atol=1e-14)


@pytest.mark.parametrize("delta", [1.5, 1.9])
def test_exact_flywheel_where_the_shaft_nearly_stops(delta):
    size = exact_flywheel(EXCESS, VARIABLE, 60.0, delta, "time")
    assert size.smallest_speed > 0
    found = steady_speed(EXCESS, plus(VARIABLE, size.inertia), 60.0)
    assert found.fluctuation() == pytest.approx(delta, rel=1e-9)
