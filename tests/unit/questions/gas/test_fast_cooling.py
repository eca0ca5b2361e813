"""Gas that is as warm as its walls at once: asked about, as its pressure has few digits; a start has none to go by."""

import numpy as np
import pytest
from tests.told import texts_of

import cranktrain as ct

BORE, STROKE, RATIO, GAMMA, H, T = 0.1, 0.1, 8.0, 1.3, 300.0, 350.0


def engine(rpm, **tables):
    return ct.Machine(
        mechanism={"kind": "slider_crank", "stroke": "100 mm", "rod_length": "180 mm"},
        shaft={"main": {"speed": f"{rpm!r} rpm"}},
        cylinder={"bore": "100 mm", "compression_ratio": RATIO, "cycle": "four-stroke", "firing_order": "1"},
        gas={
            "kind": "wiebe",
            "start_pressure": "95 kPa",
            "heat": "1500 J",
            "heat_start": "-15 deg",
            "heat_duration": "60 deg",
            "form_factor": 2.0,
            "heat_capacity_ratio": GAMMA,
            "heat_transfer": f"{H} W/m²/K",
            "start_temperature": f"{T} K",
            "wall_temperature": "400 K",
        },
        **tables,
    )


def within(rpm):
    """1/K at the bottom, K = (γ − 1) h A T/(p V ω), of a cylinder closed at both ends. [rad]"""
    volume = np.pi / 4 * BORE**2 * STROKE * RATIO / (RATIO - 1)
    area = np.pi / 2 * BORE**2 + 4 * volume / BORE
    return 95e3 * volume * rpm * np.pi / 30 / ((GAMMA - 1) * H * area * T)


def asked(rpm):
    return [one for one in texts_of(ct.run(engine(rpm)).unlikely) if "as warm as its walls" in one]


def test_it_is_asked_about_at_two_degrees():
    at_limit = float(np.deg2rad(2.0) / within(1.0))
    assert not asked(1.01 * at_limit) and not asked(600.0)
    (said,) = asked(0.5 * at_limit)
    assert "gas in 1 becomes" in said and "within 1 deg" in said.replace("1°", "1 deg")


def test_a_start_without_digits_is_refused():
    with pytest.raises(ct.InputError, match="no number here"):
        ct.start(engine(1e-3, drive={"part": {"wheel": {"inertia": "1 kg*m^2"}}}))
