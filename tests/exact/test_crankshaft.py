"""Bearing loads by moment equations against finite elements in 40 digits, on crankshafts of any shape."""

import numpy as np
import pytest
from tests.crankshafts import drawn_crankshaft
from tests.frame_elements import beam_loads, frame_loads, frame_torques

from cranktrain.questions.crankshaft.bending.torque_along import torque_along
from cranktrain.questions.crankshaft.methods import BEARING_METHODS

METHODS = {method.name: method for method in BEARING_METHODS}
LIMIT = 1e-11
"""Of the largest load, beside 1e-9 that is asked for; settled bearings have loads of their own."""


def agree(method, reference, seed, *, gives, is_isotropic):
    shaft, loads = drawn_crankshaft(seed, n_angles=1, is_isotropic=is_isotropic)
    found = METHODS[method].loads(shaft, loads)
    for angle in range(loads.turned.shape[-1]):
        borne, moved = reference(shaft, loads, 0, angle, gives=gives)
        scale = max(np.max(np.abs(loads.force)), np.max(np.abs(borne)))
        np.testing.assert_allclose(found.load[0, :, :, angle], borne, rtol=0, atol=LIMIT * scale)
        np.testing.assert_allclose(
            found.displacement[0, :, :, angle], moved, rtol=0, atol=LIMIT * np.max(np.abs(moved))
        )


@pytest.mark.parametrize("seed", range(12))
def test_three_moments(seed):
    agree("three_moment", beam_loads, seed, gives=False, is_isotropic=True)


@pytest.mark.parametrize("is_isotropic", [True, False])
@pytest.mark.parametrize("seed", range(8))
def test_five_moments(seed, is_isotropic):
    agree("five_moment", beam_loads, seed, gives=True, is_isotropic=is_isotropic)


@pytest.mark.parametrize("seed", range(8))
def test_frame_on_rigid_bearings(seed):
    agree("frame_rigid", frame_loads, seed, gives=False, is_isotropic=True)


@pytest.mark.parametrize("is_isotropic", [True, False])
@pytest.mark.parametrize("seed", range(6))
def test_frame_on_elastic_bearings(seed, is_isotropic):
    agree("frame_elastic", frame_loads, seed, gives=True, is_isotropic=is_isotropic)


@pytest.mark.parametrize("seed", range(6))
def test_torque_along_the_shaft(seed):
    """With several throws between two bearings, thrust and torques on the way."""
    shaft, loads = drawn_crankshaft(seed, n_angles=1)
    found = torque_along(shaft, loads, METHODS["frame_elastic"].loads(shaft, loads).load)
    wanted = frame_torques(shaft, loads, 0, 0)
    for values, torques in zip(found, wanted, strict=True):
        np.testing.assert_allclose(values[0, :, 0], torques, rtol=0, atol=1e-11 * np.max(np.abs(wanted)))
