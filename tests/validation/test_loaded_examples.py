"""Examples under their loads against what one finds by hand, by other formulas, or in another program's table.

* Eccentric press: F (L sin β + …)′ of a slider-crank, F R sin(α + β)/cos β, where it is 6 mm before the bottom.
* Toggle press, jaw crusher: links by crossing circles in complex numbers, their extremes by a search.
* Shaper: area of the cut.
* Pumping unit: area of the invented card, peaks of the torque with and without counterbalance, by the API's angles on a
  fine grid.
* Tilting table: κ and the reduced inertia, by virtual work in 50 digits.
"""

import numpy as np
import pytest
from scipy.optimize import brentq, minimize_scalar
from tests.told import texts_of
from tests.validation.test_examples import run

import cranktrain as ct
from cranktrain.analysis import Result

POUND_INCH = 0.0254 * 4.4482216152605
LOADED = ("eccentric_press", "toggle_press", "jaw_crusher", "shaper", "pumping_unit_c57", "tilting_table")


def of(result: Result, quantity: str) -> float:
    return float(np.ravel(getattr(result, quantity))[0])


def needed(result: Result) -> float:
    """Largest torque that the shaft must be given."""
    return -float(result.smallest_torque)


def extreme(curve, angles, sign):
    """Largest (sign 1) or smallest (−1) value of a curve: the best of the angles, then a search beside it."""
    step, best = angles[1] - angles[0], angles[np.argmax(sign * curve(angles))]
    found = minimize_scalar(
        lambda angle: -sign * float(curve(np.array(angle))),
        bounds=(best - step, best + step),
        method="bounded",
        options={"xatol": 1e-13},
    )
    return -sign * found.fun


def across(one, other, first, second, side):
    """Where circles about two points cross."""
    apart = other - one
    along = (np.abs(apart) ** 2 + first**2 - second**2) / (2 * np.abs(apart))
    return one + apart / np.abs(apart) * (along + side * 1j * np.sqrt(first**2 - along**2))


def test_eccentric_press():
    result = run("eccentric_press")
    radius, rod = 0.065, 0.65

    def before_bottom(angle):
        return radius * (1 - np.cos(angle)) + rod * (1 - np.sqrt(1 - (radius * np.sin(angle) / rod) ** 2))

    nominal = brentq(lambda angle: before_bottom(angle) - 6e-3, 0.1, 1.0, xtol=1e-15)
    slope = np.arcsin(radius * np.sin(nominal) / rod)
    torque = 1e6 * radius * np.sin(nominal + slope) / np.cos(slope)
    assert of(result, "load_work") == pytest.approx(-1e6 * (6e-3 + 0.1e-3), rel=1e-12)
    assert needed(result) == pytest.approx(torque, rel=1e-9)
    assert -of(result, "smallest_torque_at") % 360 == pytest.approx(np.degrees(nominal), abs=1e-7)
    assert of(result, "largest_rod_force") == pytest.approx(1e6 / np.cos(slope), rel=1e-9)


def test_toggle_press():
    result = run("toggle_press")

    def ram(angle):
        knee = across(0.05 * np.exp(1j * angle), 0.4 + 0.25j, 0.32, 0.25, -1)
        return knee.imag - np.sqrt(0.25**2 - (knee.real - 0.4) ** 2)

    angles = np.radians(np.arange(0.0, 360.0, 0.5))
    highest, lowest = (extreme(ram, angles, sign) for sign in (1, -1))
    stroke = highest - lowest
    assert of(result, "stroke") == pytest.approx(stroke, rel=1e-12)
    assert of(result, "load_work") == pytest.approx(-630e3 * (stroke - 69.6e-3 + 0.1e-3), rel=1e-9)
    # where the force is reached, 69.6 mm below the highest point, by differences of the circles
    at = brentq(
        lambda angle: float(highest - ram(np.array(angle))) - 69.6e-3, np.radians(300), np.radians(350), xtol=1e-15
    )
    step = 1e-5
    rate = float(ram(np.array(at - step)) - ram(np.array(at + step))) / (2 * step)
    assert needed(result) == pytest.approx(630e3 * rate, rel=1e-7)
    assert of(result, "smallest_torque_at") == pytest.approx(np.degrees(at), abs=1e-6)


def test_jaw_crusher():
    """Its angles count in the sense of rotation from the line that runs from the shaft to the toggle's seat."""
    result = run("jaw_crusher")

    def closing(angle):
        pin = 0.012 * np.exp(1j * angle)
        end = across(pin, 0.816956902 + 0j, 1.085, 0.455, -1)
        point = pin + (end - pin) / 1.085 * 0.7
        return (point * np.exp(1j * np.radians(112.5))).real

    angles = np.radians(np.arange(0.0, 360.0, 0.5))
    whole = extreme(closing, angles, 1) - extreme(closing, angles, -1)
    crushed = whole - 5e-3
    assert of(result, "load_work") == pytest.approx(-500e3 * crushed**2 / (2 * 13.5e-3), rel=1e-9)
    assert of(result, "largest_load_force") == pytest.approx(500e3 * crushed / 13.5e-3, rel=1e-9)
    # the stone falls out where the jaw turns round: the eccentric's largest load is that just before
    assert any("just before 186" in said for said in texts_of(result.flags))


def test_shaper():
    result = run("shaper")
    assert of(result, "load_work") == pytest.approx(-5e3 * (358e-3 + 1e-3), rel=1e-12)
    # on the slow stroke, toward the shaft, and on no other
    cuts = result.load_power[0] < 0
    assert np.all(result.piston_velocity_coefficient[0][cuts] > 0)
    assert np.count_nonzero(cuts) > 160  # degrees of the 227 of that stroke


def test_pumping_unit():
    result = run("pumping_unit_c57")
    works = dict(zip(result.labels["load"], result.load_work / POUND_INCH, strict=True))
    assert works["invented_card"] == pytest.approx(-147334.52434966623, rel=1e-8)
    assert works["unbalance"] == works["counterbalance"] == 0
    turn = np.radians(result.crank_angle)
    for half in (turn < np.pi, turn >= np.pi):
        assert np.max(result.driving_torque[half]) / POUND_INCH == pytest.approx(58708.1716, rel=1e-3)
    assert needed(result) / POUND_INCH == pytest.approx(58708.1716, rel=1e-6)
    assert float(result.largest_torque) / POUND_INCH == pytest.approx(10258.52, rel=1e-6)
    without = {name: table for name, table in ct.load("pumping_unit_c57").declared["load"].items() if name[0] != "c"}
    bare = ct.run("pumping_unit_c57", set={"load": without, "pumping": {"card": "invented_card"}})
    assert needed(bare) / POUND_INCH == pytest.approx(207823.24684163224, rel=2e-7)
    assert float(bare.largest_torque) / POUND_INCH == pytest.approx(118526.30174259713, rel=2e-7)


SWING = np.radians(60.14176317846605)


def test_tilting_table():
    result = run("tilting_table")
    assert result.swing[0] == pytest.approx(SWING, rel=1e-13)
    assert of(result, "load_work") == 0  # a weight gives back what it takes
    # Q r κ on the crank, at its two peaks: the larger one, and the torque on the grid beside the other
    speed = 37.5 * 2 * np.pi / 60
    assert of(result, "largest_load_power") / speed == pytest.approx(1000 * 1.200800637799636, rel=1e-12)
    assert of(result, "largest_load_power_at") == pytest.approx(334.4143024842942, abs=1e-6)
    fine = ct.run("tilting_table", step_degrees=0.1).load_torque_on_crank[0]
    assert np.min(fine) == pytest.approx(-1000 * 1.010454998136134, rel=1e-6)
    inertia = ct.run("tilting_table", step_degrees=0.05).reduced_inertia
    half = len(inertia) // 2
    assert np.max(inertia[:half]) == pytest.approx(18.52948923, rel=1e-6)
    assert np.max(inertia[half:]) == pytest.approx(24.37013606, rel=1e-6)


def test_tilting_table_with_friction():
    """Twice the torque times the swing a turn; a torque on the crank that never changes its sign."""
    result = ct.run("tilting_table", set={"load.table.sense": "resisting"})
    assert of(result, "load_work") == pytest.approx(-2 * 2000 * SWING, rel=1e-12)
    assert np.all(result.load_torque_on_crank <= 0)
    assert of(result, "largest_load_power_at") == pytest.approx(334.4143024842942, abs=1e-6)
    assert any("just after 31.75" in said for said in texts_of(result.flags))


@pytest.mark.parametrize("name", LOADED)
def test_a_load_that_resists_never_gives_power(name):
    result = run(name)
    resists = [load.sense == "resisting" for load in result.machines[0].load.values()]
    assert np.all(result.load_power[resists] <= 0)
    torque = next(check for check in result.checks if check.name == "torque")
    assert np.all(torque.residual <= 1e-12)
