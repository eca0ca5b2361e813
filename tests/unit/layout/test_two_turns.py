"""Loads and speeds over two turns, beside gas too: two equal turns are one, and closed forms."""

import numpy as np
import pytest
from tests.validation.test_crankshaft_arrangements import SECTIONS

import cranktrain as ct

ONE = {"torque": ["10 N·m", "40 N·m", "5 N·m"], "crank_angles": ["0 deg", "90 deg", "200 deg"]}
TWO = {"torque": ONE["torque"] * 2, "crank_angles": [f"{angle} deg" for angle in (0, 90, 200, 360, 450, 560)]}
FEED = {"on": "main", "sense": "resisting"}
PULSE = {"torque": ["0 N·m", "0 N·m", "80 N·m", "0 N·m"], "crank_angles": ["0 deg", "360 deg", "540 deg", "720 deg"]}
"""Nothing in the first turn, a triangle in the second."""

OF_A_CYCLE = {"load_work", "half_period_length", "half_period_work", "cycle_time", "side_changes"}
"""What there is twice of in two turns."""
BY_ROUNDING = {"torque_order_phase", "shaking_force_direction"}
"""Directions of what is hardly there."""


def alone(load, mass="3 kg", mean="time", **more):
    """A slider-crank with a crankshaft and a flywheel wanted, which no cylinder says how to count."""
    return ct.Machine(
        mechanism={"kind": "slider_crank", "crank_radius": "50 mm", "rod_length": "220 mm"},
        shaft={"main": {"speed": "300 rpm"}},
        masses={"piston": {"mass": mass}},
        evenness={"coefficient": 0.02, "mean": mean},
        load={"feed": {**FEED, **load}},
        **more,
    )


def facts_of(result):
    return [name for name, entry in result.catalogue.items() if not result.is_curve(entry)]


@pytest.mark.parametrize(
    "name",
    [
        *("", "jaw_crusher", "eccentric_press", "shears", "pumping_unit_c57", "toggle_press", "shaper"),
        *("gas_compressor", "mill_engine", "two_throw_compressor", "40d", "deltic"),
    ],
)
def test_two_equal_turns_are_one(name):
    """All facts, but for what is of a whole cycle, twice as much in two turns."""
    if name:
        once, twice = (ct.run(name, set={"load.feed": {**FEED, **load}}) for load in (ONE, TWO))
    else:
        crankshaft = {**SECTIONS, "bearing_distance": "130 mm"}
        once, twice = (ct.run(alone(load, crankshaft=crankshaft)) for load in (ONE, TWO))
    assert twice.crank_angle.size == 2 * once.crank_angle.size
    assert facts_of(once) == facts_of(twice)
    for fact in set(facts_of(once)) - BY_ROUNDING:
        wanted, found = once.dataset[fact], twice.dataset[fact]
        if "order" in wanted.dims:
            found = found.sel(order=wanted.order)
        wanted, found = np.asarray(wanted.values, float), np.asarray(found.values, float)
        if fact == "side_change_at":
            found = np.where(np.isfinite(wanted), found, np.nan)
        if fact in OF_A_CYCLE:
            wanted = 2 * wanted
        size = np.max(np.abs(wanted[np.isfinite(wanted)]), initial=0.0)
        if fact.endswith("_at"):
            found = wanted + np.remainder(found - wanted + 180, 360) - 180
            size = 360.0
        np.testing.assert_allclose(found, wanted, rtol=0, atol=2e-12 * size, err_msg=fact)


def test_a_triangle_in_the_second_turn():
    """By its area."""
    found = ct.run(alone(PULSE)).dataset
    work = 0.5 * 80 * 2 * np.pi
    np.testing.assert_allclose(found.load_work, -work, rtol=1e-13)
    np.testing.assert_allclose(found.mean_load_power, -work / (4 * np.pi) * 10 * np.pi, rtol=1e-13)
    np.testing.assert_allclose(found.largest_load_torque, 80.0, rtol=1e-13)


def test_the_flywheel_of_a_triangle():
    """Of the mean 20 N·m; from 405° to 675° a triangle of 60 N·m stands above it: ΔE, and J = ΔE/δω² with the mean of
    the extremes."""
    found = ct.run(alone(PULSE, "1e-9 kg", mean="extremes"))
    excess = 0.5 * 60 * np.radians(270)
    assert found.largest_excess_work == pytest.approx(excess, rel=1e-8)
    exact = np.ravel(found.flywheel_inertia)[0]
    assert exact == pytest.approx(excess / (0.02 * (10 * np.pi) ** 2), rel=1e-8)


def test_bearings_over_two_turns():
    """A pull of the same triangle by the lever, its largest in the second turn; the file may say so alone."""
    text = "angle [deg];force [N]\n0;0\n360;0\n540;800\n720;0\n"
    machine = ct.Machine(
        mechanism={"kind": "slider_crank", "crank_radius": "50 mm", "rod_length": "220 mm"},
        shaft={"main": {"speed": "0.0001 rpm"}},
        masses={"piston": {"mass": "1 g"}},
        crankshaft={
            **SECTIONS,
            "bearing_distance": "130 mm",
            "pull": {"belt": {"z": "-260 mm", "direction": "75 deg", "file": "pull.csv", "text": text}},
        },
    )
    found = ct.run(machine).dataset.isel(bearing_method=0)
    np.testing.assert_allclose(found.largest_bearing_load, [1200.0, 400.0], rtol=1e-9)
    np.testing.assert_allclose(found.largest_bearing_load_at, [540.0, 540.0], rtol=1e-9)
    np.testing.assert_allclose(found.mean_bearing_load, [300.0, 100.0], rtol=1e-9)


@pytest.mark.parametrize("name", ["gas_compressor", "mill_engine"])
def test_gas_of_one_turn_beside_a_load_of_two(name):
    """The torque of the machine without the load, twice, and the triangle; of the gas's orders between none is there.

    The triangle's harmonic of order ½ is H/2 (sin ¼π / ¼π)², its half width being a half turn.
    """
    without = ct.run(name)
    found = ct.run(name, set={"load.feed": {**FEED, **PULSE, "on": "crank"}})
    assert found.crank_angle.size == 720
    triangle = np.interp(np.arange(720.0), [0, 360, 540, 720], [0, 0, 80, 0])
    gas = np.tile(without.driving_torque, 2)
    np.testing.assert_allclose(found.driving_torque, gas + triangle, rtol=0, atol=2e-12 * np.max(np.abs(gas)))
    half = 80 / 2 * (np.sin(np.pi / 4) / (np.pi / 4)) ** 2
    amplitude = found.dataset.torque_order_amplitude.sel(order="0.5")
    np.testing.assert_allclose(amplitude, half, rtol=1e-10)
    np.testing.assert_allclose(found.indicated_work, without.indicated_work, rtol=1e-13)
    assert found.indicated_power == pytest.approx(without.indicated_power, rel=1e-13)
    assert found.mean_torque == pytest.approx(without.mean_torque - 20.0, rel=1e-12)
    assert all(check.passed for check in found.checks)


def test_cylinders_of_one_turn_have_no_orders_between():
    """Their star has no sum there, whatever the load of two turns has."""
    whole = ct.run("40d")
    found = ct.run("40d", set={"load.feed": {**FEED, **PULSE}})
    sums = found.dataset.phase_star_sum
    np.testing.assert_array_equal(sums[0::2], 0.0)
    np.testing.assert_allclose(sums[1::2], whole.phase_star_sum, rtol=0, atol=1e-12)


def test_a_speed_of_two_equal_turns():
    """Without cylinders, and beside the gas of one turn."""
    once = [(0, 1000), (90, 1040), (210, 980)]
    rows = [(turn * 360 + angle, speed) for turn in (0, 1) for angle, speed in once]
    one, two = (
        "\n".join(["angle [deg];speed [rpm]", *(f"{angle};{speed}" for angle, speed in [*some, (end, 1000)])])
        for some, end in ((once, 360), (rows, 720))
    )
    for name in ("shaper", "gas_compressor"):
        each = [
            ct.run(name, set={"shaft.main.speed_curve": {"file": "speed.csv", "text": text}}) for text in (one, two)
        ]
        short, long = each
        assert [run.crank_angle.size for run in each] == [360, 720]
        same = np.tile(short.driving_torque, 2)
        np.testing.assert_allclose(long.driving_torque, same, rtol=0, atol=2e-12 * np.max(np.abs(same)))
        for fact in ("largest_torque", "smallest_torque", "mean_torque"):
            assert getattr(long, fact) == pytest.approx(getattr(short, fact), rel=1e-11)


def test_a_start_beside_gas_of_one_turn():
    """A run over the time has nothing of a cycle."""
    once, twice = (ct.start("compressor_start", set={"load.feed": {**FEED, **load}}) for load in (ONE, TWO))
    assert twice.start_duration == pytest.approx(once.start_duration, rel=1e-6)
    assert twice.motor_work[-1] == pytest.approx(once.motor_work[-1], rel=1e-6)


def test_no_load_is_over_more():
    over = {"torque": ["1 N·m", "2 N·m"], "crank_angles": ["0 deg", "721 deg"]}
    with pytest.raises(ct.InputError, match=r"load\.feed\.crank_angles: must reach over two turns at most, 720°"):
        alone(over)


def test_designs_of_one_cycle():
    """Files may differ in their turns only all together."""
    one, two = "angle [deg];torque [N·m]\n0;1\n360;1\n", "angle [deg];torque [N·m]\n0;1\n720;1\n"
    machines = [alone({"file": "load.csv", "text": text}) for text in (one, two)]
    with pytest.raises(ct.InputError, match="must go on over one turn in all designs, or over two in all"):
        ct.run(machines)


@pytest.mark.parametrize(("load", "said"), [(ONE, False), (TWO, True)])
def test_heads_of_files_and_sheets_say_how_many_turns_a_cycle_has(load, said):
    """As the screen does: the angles alone, to 360° or 720°, leave a reader to guess."""
    result = ct.run(alone(load))
    assert ("two turns a cycle" in str(dict(result.about()))) is said
    figure = result.sheet("machine")
    assert (
        any("two turns a cycle" in text.get_text() for text in figure.findobj(lambda one: hasattr(one, "get_text")))
        is said
    )
