"""Motors and sizing in 40 digits, by other ways than their formulas: phasors, marching over periods, quadrature."""

import mpmath as mp
import numpy as np
import pytest
from flint import acb, arb, ctx
from tests.motors import CAGE, CATALOGUE, CIRCUIT, SYNCHRONOUS

from cranktrain.motors.cage.catalogue import four_pole_motors
from cranktrain.motors.cage.law import CatalogueValues, cage_torque, catalogue_curve, kloss_curve
from cranktrain.motors.circuit.inverter import Inverter, inverter_torque
from cranktrain.motors.circuit.law import circuit_torque
from cranktrain.motors.induction.breakdown_slip import full_fit, slip_from_rated, slip_from_start
from cranktrain.motors.induction.ramp import Ramp
from cranktrain.motors.wound_rotor.rheostat import resistance_steps
from cranktrain.questions.sizing.duty import (
    intermittent_factor,
    mean_torque,
    no_load_factor,
    rms_torque,
    short_time_factor,
)
from cranktrain.questions.sizing.peaky_load import PeakyLoad, SlipLine, periodic_inertia, periodic_torques
from cranktrain.questions.sizing.starting import loaded_start, unloaded_start

DIGITS = 40
CLOSE = 1e-12
SLIPS = [-2.0, -0.7, -0.2, -0.01, 0.01, 0.05, 0.136, 0.3, 0.8, 1.0, 1.9]


def near(found, expected, within=CLOSE):
    """Relative to what is expected, where that is not 0."""
    assert abs(mp.mpf(float(found)) - expected) <= within * abs(expected)


def circuit_power(voltage, stator, rotor, reactance, slip, synchronous):
    """Torque by currents and the power that crosses the gap."""
    current = voltage / mp.mpc(stator + rotor / slip, reactance)
    return 3 * abs(current) ** 2 * (rotor / slip) / synchronous


@pytest.mark.parametrize("slip", SLIPS)
def test_circuit_by_phasors(slip):
    with mp.workdps(DIGITS):
        speed = SYNCHRONOUS * (1 - slip)
        exact = 1 - mp.mpf(speed) / mp.mpf(SYNCHRONOUS)
        numbers = [mp.mpf(one) for one in CIRCUIT[:4]]
        # The speed field over shaft is known to its own rounding.
        near(circuit_torque(speed, CIRCUIT), circuit_power(*numbers, exact, mp.mpf(SYNCHRONOUS)), 1e-13)


@pytest.mark.parametrize("slip", SLIPS)
@pytest.mark.parametrize("part", [0.1, 0.5, 1.0, 1.6])
def test_inverter_by_phasors(slip, part):
    with mp.workdps(DIGITS):
        synchronous = part * SYNCHRONOUS
        speed = synchronous * (1 - slip)
        exact = 1 - mp.mpf(speed) / mp.mpf(synchronous)
        voltage, stator, rotor, reactance = (mp.mpf(one) for one in CIRCUIT[:4])
        frequency = mp.mpf(synchronous) / mp.mpf(SYNCHRONOUS)
        voltage *= min(1, mp.mpf(0.1) + (1 - mp.mpf(0.1)) * frequency)
        expected = circuit_power(voltage, stator, rotor, reactance * frequency, exact, mp.mpf(synchronous))
        near(inverter_torque(speed, 5.0, Inverter(CIRCUIT, Ramp(0.0, synchronous, 2.0), 0.1, np.inf)), expected)


@pytest.mark.parametrize("place", range(0, 30, 3))
def test_fits_pass_through_their_points(place):
    motors = four_pole_motors()
    speed, breakdown, start = (float(one[place]) for one in (*motors.values[1:2], *motors.values[3:5]))
    rated = 1 - speed / SYNCHRONOUS
    with mp.workdps(DIGITS):

        def torque(slip, breakdown_slip, asymmetry):
            s, b, e = mp.mpf(slip), mp.mpf(float(breakdown_slip)), mp.mpf(float(asymmetry))
            return breakdown * (2 + e) * s * b / (s * s + b * b + e * s * b)

        near(1.0, torque(rated, slip_from_rated(rated, breakdown), 0.0))
        near(start, torque(1, slip_from_start(start, breakdown), 0.0))
        full = full_fit(rated, breakdown, start)
        if not np.isnan(full.breakdown_slip):
            near(1.0, torque(rated, *full), 1e-11)
            near(start, torque(1, *full), 1e-11)
            assert full.breakdown_slip > rated
    assert slip_from_rated(rated, breakdown) > rated


def test_some_catalogue_has_both_fits():
    values = four_pole_motors().values
    full = full_fit(1 - values.rated_speed / SYNCHRONOUS, values.breakdown_ratio, values.starting_ratio)
    assert np.sum(~np.isnan(full.asymmetry)) > 10


@pytest.mark.parametrize("slip", [0.2, 0.4, 0.7, 0.8, 0.85, 0.97])
def test_catalogue_curve_by_hermite(slip):
    """The two cubics from values and slopes at their ends, as a linear system gives them."""
    with mp.workdps(DIGITS):
        breakdown, pull_up, start = (mp.mpf(one) * CATALOGUE.rated_torque for one in (3.0, 1.8, 2.3))
        first, middle = mp.mpf(float(CAGE.breakdown_slip)), mp.mpf(0.8)
        slope = mp.mpf(1.5) * (start - pull_up) / (1 - middle)
        low, high, values = (
            (first, middle, [breakdown, pull_up, 0, 0])
            if slip < 0.8
            else (middle, mp.mpf(1), [pull_up, start, 0, slope])
        )
        rows = [[end**k for k in range(4)] for end in (low, high)]
        rows += [[k * end ** max(k - 1, 0) for k in range(4)] for end in (low, high)]
        powers = mp.lu_solve(mp.matrix(rows), mp.matrix(values))
        speed = SYNCHRONOUS * (1 - slip)
        exact = 1 - mp.mpf(speed) / mp.mpf(SYNCHRONOUS)
        near(cage_torque(speed, CAGE), sum(powers[k] * exact**k for k in range(4)))


def test_no_catalogue_curve_where_breakdown_is_not_first():
    """High-slip motors: their breakdown slip by the rated point is beyond the pull-up."""
    high_slip = CatalogueValues(50.0, 0.87 * SYNCHRONOUS, SYNCHRONOUS, 4.0, 3.5, 3.5)
    below_rated = CATALOGUE._replace(breakdown_ratio=0.9)
    with np.errstate(invalid="ignore"):
        for values in (high_slip, below_rated):
            assert np.all(np.isnan(cage_torque(np.array([0.0, 50.0, 150.0]), catalogue_curve(values))))


@pytest.mark.parametrize("load", [0.0, 20.0, 30.0])
def test_loaded_start_by_quadrature(load):
    """Kloss's curve is a rational function: `flint` encloses both integrals."""
    motor = kloss_curve(SYNCHRONOUS, 95.0, 0.2)
    speeds = SYNCHRONOUS * np.array([0.0, 0.9])
    found = loaded_start(lambda w: cage_torque(w, motor), lambda w: 0 * w + load, 0.2, SYNCHRONOUS, speeds)
    before, ctx.dps = ctx.dps, DIGITS
    try:
        field, inertia = acb(SYNCHRONOUS), acb(0.2)

        def torque(slip):
            return 2 * acb(95.0) * slip * acb(0.2) / (slip * slip + acb(0.2) ** 2)

        def pace(slip, _analytic):
            return inertia * field / (torque(slip) - load)

        ends = (1 - acb(float(speeds[1])) / field, acb(1))
        time = acb.integral(pace, *ends)
        heat = acb.integral(lambda s, a: pace(s, a) * torque(s) * s * field, *ends)
        for value, exact in zip(found, (time, heat), strict=True):
            assert abs(arb(float(value)) - exact.real) < CLOSE * exact.real
    finally:
        ctx.dps = before


def test_a_start_that_gets_stuck():
    motor = kloss_curve(SYNCHRONOUS, 95.0, 0.2)
    speeds = SYNCHRONOUS * np.array([0.0, 0.9])
    stuck = loaded_start(lambda w: cage_torque(w, motor), lambda w: 0 * w + 40.0, 0.2, SYNCHRONOUS, speeds)
    assert np.all(np.isnan(stuck))


@pytest.mark.parametrize(("first", "last"), [(1.0, 0.05), (2.0, 1.0), (2.0, 0.03), (1.7, 0.3)])
def test_unloaded_start_by_quadrature(first, last):
    with mp.workdps(DIGITS):
        field = mp.mpf(SYNCHRONOUS)

        def torque(slip):
            return 2 * mp.mpf(95.0) * slip * mp.mpf(0.2) / (slip**2 + mp.mpf(0.2) ** 2)

        time = mp.quad(lambda s: mp.mpf(0.2) * field / torque(s), [mp.mpf(last), mp.mpf(first)])
        heat = mp.quad(lambda s: mp.mpf(0.2) * field**2 * s, [mp.mpf(last), mp.mpf(first)])
        found = unloaded_start(0.2, SYNCHRONOUS, 95.0, 0.2, last, first)
        near(found.time, time)
        near(found.rotor_heat, heat)


def test_plugging_heats_three_times_as_much():
    start, plugging = (unloaded_start(0.2, SYNCHRONOUS, 95.0, 0.2, *ends) for ends in ((1e-9, 1.0), (1.0, 2.0)))
    assert plugging.rotor_heat == pytest.approx(3 * start.rotor_heat, rel=1e-12)


@pytest.mark.parametrize(("on", "off", "cooling", "share"), [
    (4.0, 6.0, 0.5, 0.0), (1.5, 8.5, 0.25, 0.3), (6.0, 4.0, 1.0, 0.2), (0.001, 0.002, 0.4, 0.0), (50.0, 80.0, 0.5, 0.1),
])  # fmt: skip
def test_duty_by_marching(on, off, cooling, share):
    """Temperature period after period, with the factor's losses: the hottest moment is that of rated load."""
    constant = 30.0
    for factor, way, rest in (
        (intermittent_factor(on, off, constant, cooling=cooling, constant_share=share), cooling, 0.0),
        (no_load_factor(on, off, constant, constant_share=share), 1.0, share),
    ):
        with mp.workdps(DIGITS):
            losses = share + (1 - mp.mpf(share)) * mp.mpf(float(factor)) ** 2
            decay = [mp.exp(-mp.mpf(on) / constant), mp.exp(-mp.mpf(off) * way / constant)]
            warm = mp.mpf(0)
            if on + off > 1:
                for _ in range(400):
                    hot = losses + (warm - losses) * decay[0]
                    warm = rest / mp.mpf(way) + (hot - rest / mp.mpf(way)) * decay[1]
                assert abs(hot - 1) < 1e-13
            else:  # so many short periods that the mean losses are those of rated load
                assert abs(losses * on / (on + off * (1 if rest else way)) - 1) < 1e-3 + share


def test_short_time_by_marching():
    factor = short_time_factor(10.0, 30.0, constant_share=0.2)
    with mp.workdps(DIGITS):
        losses = mp.mpf(0.2) + mp.mpf(1 - 0.2) * mp.mpf(float(factor)) ** 2
        assert abs(losses * (1 - mp.exp(-mp.mpf(10) / 30)) - 1) < 1e-14
    assert short_time_factor(1e9, 30.0) == 1.0


@pytest.mark.parametrize(("times", "constant"), [((0.6, 3.4), 1.2), ((0.6, 3.4), 0.05), ((2.0, 0.3), 4.0)])
def test_peaky_load_by_marching(times, constant):
    load = PeakyLoad(260.0, times[0], 25.0, times[1])
    found = periodic_torques(load, constant)
    with mp.workdps(DIGITS):
        tau, low = mp.mpf(constant), mp.mpf(25)
        for _ in range(600):
            high = 260 - (260 - low) * mp.exp(-mp.mpf(times[0]) / tau)
            low = 25 + (high - 25) * mp.exp(-mp.mpf(times[1]) / tau)
        near(found.high, high)
        near(found.low, low)
        heat = mp.quad(lambda t: (260 - (260 - low) * mp.exp(-t / tau)) ** 2, [0, mp.mpf(times[0])])
        heat += mp.quad(lambda t: (25 + (high - 25) * mp.exp(-t / tau)) ** 2, mp.linspace(0, mp.mpf(times[1]), 20))
        near(found.rms, mp.sqrt(heat / (mp.mpf(times[0]) + mp.mpf(times[1]))))


@pytest.mark.parametrize("allowed", [61.0, 70.0, 120.0, 200.0, 259.0])
def test_periodic_inertia_by_marching(allowed):
    line = SlipLine(70.0, 0.08, SYNCHRONOUS)
    load = PeakyLoad(260.0, 0.6, 25.0, 3.4)
    inertia = periodic_inertia(load, line, allowed)
    with mp.workdps(DIGITS):
        tau = mp.mpf(float(inertia)) * mp.mpf(SYNCHRONOUS) * mp.mpf(0.08) / 70
        peak, pause = mp.exp(-mp.mpf(0.6) / tau), mp.exp(-mp.mpf(3.4) / tau)
        near(allowed, (260 * (1 - peak) + 25 * (1 - pause) * peak) / (1 - peak * pause))


def test_no_flywheel_where_the_mean_is_above_and_none_needed_where_the_peak_is_within():
    line, load = SlipLine(70.0, 0.08, SYNCHRONOUS), PeakyLoad(260.0, 0.6, 25.0, 3.4)
    found = periodic_inertia(load, line, np.array([25.0, 60.0, 300.0]))
    np.testing.assert_array_equal(found, [np.nan, np.nan, 0.0])


def test_rms_by_fractions():
    """∫(a + (b − a)x)² over pieces of unequal length."""
    draw = np.random.default_rng(5)
    torque, time = draw.uniform(-50, 80, 12), np.cumsum(draw.uniform(0.1, 2, 12))
    with mp.workdps(DIGITS):
        whole = mp.mpf(time[-1]) - mp.mpf(time[0])
        pieces = list(zip(*(map(mp.mpf, one) for one in (torque[:-1], torque[1:], time[:-1], time[1:])), strict=True))
        heat = sum(mp.quad(lambda x, a=a, b=b: (a + (b - a) * x) ** 2, [0, 1]) * (e - s) for a, b, s, e in pieces)
        area = sum(mp.quad(lambda x, a=a, b=b: a + (b - a) * x, [0, 1]) * (e - s) for a, b, s, e in pieces)
        near(rms_torque(torque, time), mp.sqrt(heat / whole))
        near(mean_torque(torque, time), area / whole)


@pytest.mark.parametrize(("n_steps", "peak", "rated"), [(1, 2.0, 0.05), (3, 2.0, 0.03), (5, 1.6, 0.02)])
def test_every_step_goes_from_peak_to_switching_torque(n_steps, peak, rated):
    """On straight lines M = s/(s_n R), and the last one, without resistance, begins at the peak, too."""
    steps = resistance_steps(n_steps, peak, rated)
    with mp.workdps(DIGITS):
        slips = [mp.mpf(1), *(mp.mpf(float(slip)) for slip in steps.slip)]
        resistances = [*(mp.mpf(float(one)) for one in steps.resistance), mp.mpf(1)]
        for slip, resistance in zip(slips, resistances, strict=True):
            near(peak, slip / (mp.mpf(rated) * resistance))
        for slip, resistance in zip(slips[1:], resistances[:-1], strict=True):
            near(steps.switching_torque, slip / (mp.mpf(rated) * resistance))
