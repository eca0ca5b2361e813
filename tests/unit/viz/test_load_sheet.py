"""The sheet of loads: curves with their jumps, by closed forms; what its table says; words that can be read."""

import numpy as np
import pytest
from tests.loaded_machines import LOADED
from tests.words_on_paper import assert_words_are_readable, words_of

import cranktrain as ct
from cranktrain.panels.design import OneDesign
from cranktrain.panels.sheets.loads.panels import load_curves, load_panels, travel_panels
from cranktrain.plans.positions import position_plan
from cranktrain.plans.shown_loads import shown_loads
from cranktrain.quantities import shown_by, units_by_dimension
from cranktrain.viz import plan_accelerations, plan_forces, plan_positions, plan_zhukovsky, sheet, sheet_loads
from cranktrain.viz.paper.load_arrows import load_words
from cranktrain.viz.plans.sketches import positions_sketch


@pytest.fixture(scope="module")
def results():
    return {name: ct.run(machine) for name, machine in LOADED.items()}


@pytest.mark.parametrize("name", LOADED)
def test_pictures_are_readable(results, name):
    machine, result = LOADED[name], results[name]
    for figure in (
        sheet_loads(result),
        sheet(result, at=150.0),
        plan_positions(machine, 12),
        plan_accelerations(machine, 8),
        plan_forces(machine, [150.0]),
        plan_zhukovsky(machine, [150.0]),
    ):
        assert_words_are_readable(figure)


def test_a_load_that_turns_round_jumps_straight_up(results):
    """A constant force against the motion of the ram has two values, and no third between them."""
    curves = load_curves(OneDesign(results["shaper"], 0))
    slideway = next(one for one in curves.each if one.name == "slideway")
    assert set(np.round(slideway.size, 9)) == {-600.0, 600.0}
    jumps = np.flatnonzero(np.diff(slideway.size))
    assert len(jumps) == 2
    assert curves.angle[jumps] == pytest.approx(curves.angle[jumps + 1], abs=1e-12)
    result = results["shaper"]
    dead = [float(getattr(result, f"{end}_dead_centre")[0]) for end in ("top", "bottom")]
    assert sorted(curves.angle[jumps]) == pytest.approx(sorted(one % 360.0 for one in dead), abs=1e-6)


def test_a_press_that_turns_at_the_end_of_its_work(results):
    """Force at its largest to the outer dead centre, φ = 0, and nothing after that: the cycle begins with a jump."""
    curves = load_curves(OneDesign(results["press"], 0))
    force = curves.each[0]
    assert (curves.angle[0], curves.angle[-1]) == (0.0, 360.0)
    assert force.size[0] == pytest.approx(0.0, abs=1e-6)
    assert force.size[-1] == pytest.approx(-1e6, rel=1e-9)
    # 122.5 mm of travel remain 7.5 mm of 715: x = r cos φ + √(l² − r² sin² φ)
    ends = curves.angle[np.flatnonzero(np.abs(force.size + 1e6) < 1e-3)]
    angle = np.linspace(-0.5, 0.0, 500001)
    x = 0.065 * np.cos(angle) + np.sqrt(0.65**2 - (0.065 * np.sin(angle)) ** 2)
    at = 360.0 + np.rad2deg(np.interp(0.585 + 0.1225, x, angle))
    assert ends[0] == pytest.approx(at, abs=1e-4)


@pytest.mark.parametrize("name", LOADED)
def test_panels_are_the_results_curves(results, name):
    """Torque on the crank and power at the angles of the grid, where nothing jumps, are the result's own."""
    result = results[name]
    shown = OneDesign(result, 0)
    curves = load_curves(shown)
    kept = np.flatnonzero(np.isin(curves.angle, result.crank_angle))
    at = [result.crank_angle.tolist().index(angle) for angle in curves.angle[kept]]
    assert len(kept) > 300
    jumps = np.isin(curves.angle[kept], curves.angle[:-1][np.diff(curves.angle) == 0.0])
    for i, one in enumerate(curves.each):
        torque, power = result.load_torque_on_crank[i, at], result.load_power[i, at]
        scale = np.max(np.abs(torque))
        assert one.on_crank[kept][~jumps] == pytest.approx(torque[~jumps], abs=1e-6 * scale)
        assert one.power[kept][~jumps] == pytest.approx(power[~jumps], abs=1e-6 * np.max(np.abs(power)))
    panels = list(load_panels(shown, curves))
    assert [panel.unit for panel in panels][-2:] == ["N*m", "W"]
    assert {curve.name for panel in panels for curve in panel.curves if curve.name} == set(result.labels["load"])


def test_the_card_of_a_pumping_unit_is_closed(results):
    """Over the travel the card of the file comes out: its area is the work of a stroke."""
    curves = load_curves(OneDesign(results["pumping_unit"], 0))
    (card,) = travel_panels(curves)
    metres, newtons = curves.each[0].travel, curves.each[0].size
    area = np.sum(0.5 * (newtons + np.roll(newtons, -1)) * (np.roll(metres, -1) - metres))
    assert abs(area) == pytest.approx(abs(float(results["pumping_unit"].load_work[0])), rel=1e-4)
    assert card.across[0] == card.across[-1]


def test_the_table_says_work_and_largest_power(results):
    words = [text for text, _box in words_of(sheet_loads(results["table"]))]
    assert {"1 drive", "rocker", "1200 N·m", "load", "work, J"} <= set(words)


def test_sizes_are_in_the_chosen_unit():
    press = LOADED["press"]
    (force, balancer) = shown_loads(press, press.places).at(np.array([150.0]))
    assert load_words(balancer) == "balancer 60.00 kN"
    with shown_by(units_by_dimension(["kgf"])):
        assert load_words(balancer) == "balancer 6118 kgf"
        assert load_words(force) == "nominal force 0 kgf"


def test_no_load_is_a_dashed_line_in_one_position_and_nothing_in_several():
    press = LOADED["press"]
    loads = shown_loads(press, press.places)

    def of_loads(angles, habit):
        sketch = positions_sketch(position_plan(press, angles), loads=loads)
        return [line for line in sketch.lines if line.layer == "LOADS" and line.habit == habit]

    assert len(of_loads([150.0], "part")) == 1
    assert len(of_loads([150.0], "arrow")) == 1
    assert of_loads([150.0, 240.0], "part") == []
    assert len(of_loads([150.0, 240.0], "arrow")) == 2


def test_a_torque_on_the_shaft_has_its_curve_with_its_kinks():
    """Straight lines from crank angle to crank angle, also where these lie between those of the grid."""
    fan = {
        "on": "main",
        "torque": ["10 N*m", "30 N*m", "30 N*m", "10 N*m"],
        "crank_angles": ["0 deg", "90.5 deg", "180 deg", "180.01 deg"],
    }
    machine = LOADED["press"].with_({"load.fan": fan})
    result = ct.run(machine)
    curves = load_curves(OneDesign(result, 0))
    assert [one.name for one in curves.each] == ["nominal_force", "balancer", "fan"]
    own = curves.each[2]
    expected = -np.interp(curves.angle, [0.0, 90.5, 180.0, 180.01, 360.0], [10.0, 30.0, 30.0, 10.0, 10.0])
    assert own.size == pytest.approx(expected, abs=2.1e-3)  # 20 N·m in 0.01°, looked at 1e-6° aside
    assert own.power == pytest.approx(own.size * 1.5 * 2 * np.pi, rel=1e-12)
    assert_words_are_readable(sheet_loads(result))
