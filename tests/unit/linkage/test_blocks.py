import numpy as np
import pytest

from cranktrain.linkage.blocks import BLOCK, in_blocks
from cranktrain.mechanisms.articulated_rod import ArticulatedRod, articulated_rod
from cranktrain.mechanisms.crank_rocker import CrankRocker, crank_rocker
from cranktrain.mechanisms.slider_crank import SliderCrank

DESIGNS = np.array([[[0.9]], [[1.0]], [[1.1]]])


def flat(motion):
    return [array for part in motion for array in (flat(part) if isinstance(part, tuple) else [part])]


@pytest.mark.parametrize("n_angles", [7, BLOCK, BLOCK + 1, 2 * BLOCK + 17])
@pytest.mark.parametrize(
    ("kernel", "geometry"),
    [
        (crank_rocker, CrankRocker(0.1 * DESIGNS, 0.36, 0.28, 0.4 * DESIGNS, 1.0)),
        (articulated_rod, ArticulatedRod(SliderCrank(0.09, 0.32, 0.0), 0.085 * DESIGNS, 1.17, 1.05, 0.235, 0.001)),
    ],
)
def test_blocks_give_what_one_call_gives(kernel, geometry, n_angles):
    angle = np.linspace(0.0, 4 * np.pi, n_angles)
    blocks, whole = in_blocks(kernel, angle, geometry), kernel(angle, geometry)
    assert type(blocks) is type(whole)
    for found, expected in zip(flat(blocks), flat(whole), strict=True):
        # NumPy's loops may round the last digit otherwise at another place in an array
        np.testing.assert_allclose(*np.broadcast_arrays(found, expected), rtol=4e-16, atol=4e-16)
