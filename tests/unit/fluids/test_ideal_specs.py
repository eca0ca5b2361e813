"""Tables of the ideal cycles: what stands there unless given, what is refused and what is doubted."""

import numpy as np
import pytest
from tests.gas_engines import Engine
from tests.sentences import NOT_A_KEY, NOT_POSITIVE
from tests.told import texts_of

from cranktrain.errors import InputError
from cranktrain.fluids import KINDS, ChamberState
from cranktrain.fluids.dual import ideal_mean_pressures, ideal_pressure
from cranktrain.spec import validated

DUAL = {
    "kind": "dual",
    "start_pressure": "1.2 bar",
    "compression_exponent": 1.36,
    "expansion_exponent": 1.25,
    "pressure_ratio": 1.55,
    "cut_off_ratio": 1.45,
}
ENGINE = Engine(0.045, 0.15, 0.08, 16.0)


def model_of(**more):
    spec = validated(KINDS.named("dual").spec, DUAL | more)
    fluid, cycle = ENGINE.filled(spec)
    return cycle, texts_of(fluid.flags(spec))


def test_exchange_pressures_unless_given():
    model, flags = model_of()
    assert model.inlet_pressure == model.exhaust_pressure == model.start_pressure == 1.2e5
    assert model_of(inlet_pressure="1.3 bar")[0].exhaust_pressure == 1.3e5
    assert flags == ()


def test_gauge_units_count_from_the_atmosphere():
    assert model_of(start_pressure="0.2 barg")[0].start_pressure == pytest.approx(0.2e5 + 101325)


def test_a_pressure_that_looks_like_gauge_is_doubted():
    _, flags = model_of(start_pressure="0.2 bar", exhaust_pressure="5 kPa")
    assert [flag.split(" = ")[0] for flag in flags] == ["start_pressure", "exhaust_pressure"]
    assert "20 kPa absolute" in flags[0]


@pytest.mark.parametrize(
    ("more", "message"),
    [
        ({"cut_off_ratio": 17}, r"cut_off_ratio = 17: must be at most the compression ratio, 16"),
        ({"cut_off_ratio": 0.9}, r"cut_off_ratio = 0.9: must be at least 1"),
        ({"pressure_ratio": 0.5}, r"pressure_ratio = 0.5: must be at least 1"),
        ({"start_pressure": "0 bar"}, rf"start_pressure = 0 bar: {NOT_POSITIVE}"),
        ({"compression_exponent": "1.3 bar"}, r"compression_exponent = 1.3 bar"),
        ({"clearance": 1}, rf"clearance = 1: {NOT_A_KEY}"),
    ],
)
def test_refused(more, message):
    with pytest.raises(InputError, match=message):
        model_of(**more)


def test_heat_beyond_the_bottom_dead_centre_is_no_number():
    """For sweeps, where nothing is refused."""
    model = model_of()[0]._replace(cut_off_ratio=np.array([1.45, 17.0]))
    net = ideal_mean_pressures(model, np.array(16.0)).net
    assert np.isnan(net).ravel().tolist() == [False, True]
    angle = np.radians(np.array([10.0]))
    state = ChamberState(ENGINE.volume(angle).value, *ENGINE.limits, np.array(1.0), np.array(1.0), angle)
    assert np.isnan(ideal_pressure(state, model)).ravel().tolist() == [False, True]


def test_an_exponent_that_no_gas_has_is_doubted():
    _, flags = model_of(expansion_exponent=0.5)
    assert flags == ("expansion_exponent = 0.5 is no polytrope of an engine; 1.2 to 1.4 are usual.",)
