"""A pole of the pressure beside the real axis, where the volume is next to nothing as it is least."""

from itertools import pairwise

import numpy as np
import pytest
from scipy.integrate import quad

import cranktrain as ct

RADIUS, ROD, BORE = 0.05, 0.18, 0.09
START, EXHAUST, AMBIENT = 1.2e5, 1.4e5, 101325.0
COMPRESSION, EXPANSION, RAISE, CUT_OFF = 1.36, 1.25, 1.4, 1.5
AREA = np.pi / 4 * BORE**2
SWEPT = 2 * RADIUS * AREA


def volume(angle, ratio):
    across = RADIUS * np.sin(angle)
    return SWEPT / (ratio - 1) + AREA * (RADIUS + ROD - RADIUS * np.cos(angle) - np.sqrt(ROD**2 - across**2))


def load(angle, ratio):
    """What a rod without mass hands on to its pin."""
    least, now = SWEPT / (ratio - 1), volume(angle, ratio)
    most, peak = least + SWEPT, RAISE * START * ratio**COMPRESSION
    if angle < np.pi:
        pressure = min(peak, peak * (CUT_OFF * least / now) ** EXPANSION)
    elif angle < 2 * np.pi:
        pressure = EXHAUST
    else:
        pressure = START if angle < 3 * np.pi else START * (most / now) ** COMPRESSION
    return (pressure - AMBIENT) * AREA / np.sqrt(1 - (RADIUS / ROD * np.sin(angle)) ** 2)


@pytest.mark.parametrize("ratio", [12.0, 60.0, 250.0, 2000.0])
def test_the_mean_load_of_a_pin_is_that_of_quadrature(ratio):
    gas = {"start_pressure": "1.2 bar", "exhaust_pressure": "1.4 bar", "compression_exponent": COMPRESSION}
    engine = ct.Machine(
        mechanism={"kind": "slider_crank", "crank_radius": "50 mm", "rod_length": "180 mm"},
        cylinder={"bore": "90 mm", "compression_ratio": ratio, "cycle": "four-stroke"},
        gas={"kind": "dual", **gas, "expansion_exponent": EXPANSION, "pressure_ratio": RAISE, "cut_off_ratio": CUT_OFF},
        masses={"piston": {"mass": "0 kg"}},
        shaft={"main": {"speed": "1500 rpm"}},
    )
    low, high = 0.0, 1.0
    for _step in range(100):
        middle = (low + high) / 2
        low, high = (middle, high) if volume(middle, ratio) < CUT_OFF * SWEPT / (ratio - 1) else (low, middle)
    away = np.sqrt(4 / ((ratio - 1) * (1 + RADIUS / ROD)))
    near = [place * away for place in (1, 3, 9) if low < place * away < np.pi]
    edges = [0, low, *near, np.pi, 2 * np.pi, 3 * np.pi, *(4 * np.pi - np.array(near[::-1])), 4 * np.pi]
    mean = sum(quad(load, *pair, args=(ratio,), epsabs=0, epsrel=1e-13)[0] for pair in pairwise(edges)) / (4 * np.pi)
    assert ct.run(engine).mean_crankpin_load[0] == pytest.approx(mean, rel=1e-11)
