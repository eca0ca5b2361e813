"""The slide valve of a steam engine on one eccentric: cut-off and compression as solved elsewhere.

R = 200, L = 1000 mm, eccentricity 45, eccentric rod 900, steam lap 22, exhaust lap 3 mm, δ = 35°, outside admission.
The angles are closed forms, φ = ±arccos[(s² + r² − l²)/(2 r s)] − 90° − δ with s = l − u, printed to 1e-6 degrees; the
fractions of the stroke are each end's own.
"""

import numpy as np
import pytest

import cranktrain as ct
from cranktrain.numerics import bracketed_roots

LAP, EXHAUST_LAP = 0.022, 0.003
ENGINE = ct.Machine(
    bank={
        "cylinder": {"mechanism": {"kind": "slider_crank", "crank_radius": "200 mm", "rod_length": "1000 mm"}},
        "valve": {
            "mechanism": {
                "kind": "eccentric",
                "eccentricity": "45 mm",
                "rod_length": "900 mm",
                "angle_of_advance": "35 deg",
            }
        },
    }
)
CYLINDER, VALVE = ENGINE.places


@pytest.mark.parametrize(
    ("opening", "near", "angle", "fraction"),
    [
        (LAP, 117, 117.005455, 0.767049),
        (-LAP, 294, 294.505235, 0.665642),
        (-EXHAUST_LAP, 320, 319.751654, 0.139335),
        (EXHAUST_LAP, 143, 142.610386, 0.084233),
    ],
    ids=["head cut-off", "crank cut-off", "head compression", "crank compression"],
)
def test_events(opening, near, angle, fraction):
    """Head: cut-off at u = a, compression at u = −i; the crank end with the other sign; u toward the shaft."""

    def from_edge(phi):
        return 0.9 - VALVE.kind.motion(phi, VALVE.geometry).slider.value - opening

    low, high = np.radians([near - 5.0]), np.radians([near + 5.0])
    found = bracketed_roots(from_edge, low, high)
    assert np.degrees(found[0]) == pytest.approx(angle, abs=5e-7)
    travel = (1.2 - CYLINDER.kind.motion(found, CYLINDER.geometry).slider.value[0]) / 0.4
    from_own_dead_centre = travel if opening in (LAP, EXHAUST_LAP) and near < 143 else 1 - travel
    is_head_compression = near == 320
    assert (1 - from_own_dead_centre if is_head_compression else from_own_dead_centre) == pytest.approx(
        fraction, abs=5e-7
    )
