"""Heat by Wiebe's law: the closed cycle of Heywood's § 9.2 with constant γ, by quadrature in 40 digits elsewhere."""

import numpy as np
import pytest
from scipy.optimize import brentq, minimize_scalar
from tests.gas_engines import FOUR_STROKE, TWO_STROKE, Engine

from cranktrain.fluids import chamber_state
from cranktrain.fluids.wiebe import WiebeSpec
from cranktrain.fluids.wiebe.curve import Wiebe, burnt
from cranktrain.numerics.nested import mapped
from cranktrain.spec import validated

ENGINE = Engine(0.045, 0.15, 0.08, 10.0)
CASE = {
    "kind": "wiebe",
    "start_pressure": "1 bar",
    "heat": "1000 J",
    "heat_start": "-15 deg",
    "heat_duration": "50 deg",
    "form_factor": 2,
    "heat_capacity_ratio": 1.33,
}
LOSS = {"heat_transfer": "600 W/m²/K", "start_temperature": "340 K", "wall_temperature": "450 K"}
SPEED = 350.0
"""rad/s; the losses go by it."""


def filled(cycle=TWO_STROKE, **more):
    return ENGINE.filled(validated(WiebeSpec, CASE | more), cycle, SPEED)


def pressure(fluid, ready, degrees, cycle=TWO_STROKE):
    angle = np.radians(np.atleast_1d(degrees))
    state = chamber_state(ENGINE.volume(angle), ENGINE.limits, angle, cycle)
    return fluid.pressure(state, of_chamber(ready))


def of_chamber(ready):
    return mapped(lambda _name, part: part[0, 0], ready)


def test_the_pressure_does_not_rise_at_its_peak_and_rises_by_the_polytrope_before_it_burns():
    """p′ = −γ p V′/V before; at the largest pressure (Q x_b′ (γ − 1) = γ p V′) it is 0."""
    fluid, ready = filled()
    angle = np.radians([15.620204125350852, -60.0])
    volume = ENGINE.volume(angle)
    state = chamber_state(volume, ENGINE.limits, angle, TWO_STROKE)
    own = of_chamber(ready)
    at_peak, before = fluid.slope(state, fluid.pressure(state, own), volume.first, own)
    compressed = 1e5 * (ENGINE.limits.largest / volume.value[1]) ** 1.33
    assert before == pytest.approx(-1.33 * compressed * volume.first[1] / volume.value[1], rel=1e-13)
    assert abs(at_peak) < 1e-7 * before


def peak(fluid, ready):
    found = minimize_scalar(
        lambda at: -float(pressure(fluid, ready, at)[0]), bounds=(5, 30), method="bounded", options={"xatol": 1e-9}
    )
    return found.x, -found.fun


def test_the_closed_cycle():
    fluid, ready = filled()
    assert fluid.work(ready, ENGINE.rooms(TWO_STROKE))[0, 0] / ENGINE.swept == pytest.approx(
        1136379.6708802977, rel=1e-13
    )
    assert float(pressure(fluid, ready, 15.620204125350852)[0]) == pytest.approx(5756056.478724107, rel=1e-13)
    at, largest = peak(fluid, ready)
    assert at == pytest.approx(15.620204125350852, abs=1e-5)
    assert largest == pytest.approx(5756056.478724107, rel=1e-13)
    # Just before the bottom; at it the next compression begins.
    before_bottom, bottom = pressure(fluid, ready, [180 - 1e-6, 180])
    assert before_bottom == pytest.approx(418352.8638623658, rel=1e-12)
    assert bottom == pytest.approx(1e5, rel=1e-13)


def test_half_of_the_heat_has_come_in():
    numbers = (1e5, 1000.0, np.radians(-15), np.radians(50), 2.0, np.log(1000), 1.33, 0.0, 1.0, 1.0)
    half = brentq(lambda at: float(burnt(Wiebe(*numbers), np.radians(at))) - 0.5, -15, 35, xtol=1e-13)
    assert half == pytest.approx(8.234473920447973, abs=1e-11)


def test_with_losses_to_the_walls():
    fluid, ready = filled(**LOSS)
    assert fluid.work(ready, ENGINE.rooms(TWO_STROKE))[0, 0] / ENGINE.swept == pytest.approx(1070346.18, abs=5e-3)
    assert peak(fluid, ready)[1] == pytest.approx(5762394.38, abs=5e-3)
    assert float(ready.curve.loss[0, 0]) == pytest.approx(142.55427, abs=5e-6)


def test_energy_is_kept():
    """Heat that came in less what the walls took is work and what the gas has more at the end: (p₂ − p₁)V₁/(γ − 1)."""
    fluid, ready = filled(**LOSS, efficiency_factor=5, form_factor=0.3)
    end = float(pressure(fluid, ready, 180 - 1e-6)[0])
    inner = (end - 1e5) * ENGINE.limits.largest / 0.33
    came = 1000 * -np.expm1(-5.0)
    assert float(ready.curve.work[0, 0]) + inner == pytest.approx(came - float(ready.curve.loss[0, 0]), rel=1e-8)


def test_gas_exchange_of_a_four_stroke():
    fluid, ready = filled(FOUR_STROKE, inlet_pressure="0.95 bar", exhaust_pressure="1.08 bar")
    assert pressure(fluid, ready, [200, 300, 361, 500], FOUR_STROKE) == pytest.approx([1.08e5, 1.08e5, 0.95e5, 0.95e5])
    net = fluid.work(ready, ENGINE.rooms(FOUR_STROKE))[0, 0] / ENGINE.swept
    assert net == pytest.approx(1136379.6708802977 - 0.13e5, rel=1e-13)
