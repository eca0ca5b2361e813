"""Pictures at the running speed: they say so, their curves are the results', and nothing lies on anything."""

import numpy as np
import pytest
from tests.property.test_running_speed import SLIDER_CRANK, varying
from tests.sentences import STEADY_RUNNING
from tests.words_on_paper import assert_words_are_readable, words_of

import cranktrain as ct
from cranktrain.panels.sheets.motion.panels import panels
from cranktrain.viz import (
    dxf,
    plan_accelerations,
    plan_forces,
    plan_polar,
    plan_positions,
    plan_velocities,
    plan_zhukovsky,
    sheet,
    sheet_forces,
)

ENGINE = ct.load("vaz_21213")
SAID = f"All of this is {STEADY_RUNNING}, 5172.8 rpm to 5224.7 rpm over the cycle, 5200.0 rpm over time."
PLANS = (plan_positions, plan_velocities, plan_accelerations, plan_forces, plan_zhukovsky, plan_polar)


@pytest.fixture(scope="module")
def result():
    return ct.run(ENGINE, speed="running")


@pytest.mark.parametrize("draw", [sheet, sheet_forces])
@pytest.mark.parametrize("size", ["A4", "A3"])
def test_sheet_says_its_speed(result, draw, size):
    figure = draw(result, size=size)
    assert_words_are_readable(figure)
    assert SAID in [text for text, _box in words_of(figure)]


@pytest.mark.parametrize("draw", PLANS)
def test_plan_says_its_speed(draw):
    figure = draw(ENGINE, speed="running")
    assert_words_are_readable(figure)
    assert SAID in [text for text, _box in words_of(figure)]
    assert not [text for text, _box in words_of(draw(ENGINE)) if text.startswith("All of this")]


@pytest.mark.parametrize("name", ["r_1340", "deltic"])
@pytest.mark.parametrize("draw", PLANS)
def test_plan_of_other_machines_is_readable(name, draw):
    assert_words_are_readable(draw(ct.load(name), speed="running"))


def test_curves_are_the_results(result):
    """Over one turn of a four-stroke, whose next turn begins at another speed."""
    travel, velocity, acceleration, _error = panels(result)
    for panel, values in ((velocity, result.piston_velocity), (acceleration, result.piston_acceleration)):
        scale = np.max(np.abs(values))
        np.testing.assert_allclose(panel.curves[0].values, values[0, :361], rtol=0, atol=1e-12 * scale)
    np.testing.assert_allclose(travel.curves[0].values, result.piston_displacement[0, :361], atol=1e-15)
    three = ct.run(ENGINE, speed=varying(np.radians(result.crank_angle / 2), 500.0))
    assert panels(three)[1].curves[0].values[360] == pytest.approx(three.piston_velocity[0, 360], rel=1e-12)


def test_textbook_beside_the_exact_turns_alike(result):
    """Of two harmonics, by the same ω and ε: x″ω² + x′ε with x′ = R(sin φ + λ/2 sin 2φ), x″ its derivative."""
    exact, textbook = panels(result)[2].curves
    crank = ENGINE.places[0].geometry  # its radius is a little less than half of the stroke, for the pin's offset
    radius, phi, ratio = crank.crank_radius, np.radians(np.arange(361.0)), crank.crank_radius / crank.rod_length
    speed, turning = (np.asarray(values)[:361] for values in (result.crank_speed, result.crank_acceleration))
    first = radius * (np.sin(phi) + ratio / 2 * np.sin(2 * phi))
    second = radius * (np.cos(phi) + ratio * np.cos(2 * phi))
    np.testing.assert_allclose(textbook.values, second * speed**2 + first * turning, rtol=1e-9, atol=1e-5)
    assert np.max(np.abs(textbook.values - exact.values)) > 100


def test_rocker_turns_with_the_crank():
    unit = ct.load("pumping_unit_c57")
    speed = varying(np.radians(np.arange(360.0)), 1.0)
    found = ct.run(unit, speed=speed)
    velocity = panels(found)[1].curves[0].values
    np.testing.assert_allclose(velocity[:360], found.rocker_velocity_coefficient[0] * speed, rtol=1e-12)


def test_table_of_positions_is_of_the_speed():
    """The piston's velocity where the crank stands across: Rω for any rod, as the rod's end moves with the pin."""
    pump = ct.Machine(**SLIDER_CRANK)
    speed = varying(np.radians(np.arange(360.0)))
    words = [text for text, _box in words_of(plan_positions(pump, [90.0], speed=speed))]
    assert f"{0.05 * speed[90]:.4g}" in words


def test_dxf_says_its_speed(tmp_path):
    ezdxf = pytest.importorskip("ezdxf")
    for speed in ("running", "constant"):
        dxf(ENGINE, [30.0], tmp_path / "a.dxf", speed=speed, force=True)
        words = [text.dxf.text for text in ezdxf.readfile(tmp_path / "a.dxf").modelspace().query("TEXT")]
        assert (SAID in words) is (speed == "running")
