"""The straight beam that stands for a span: its stiffness by sums over pieces and webs, its loads by beam elements."""

import numpy as np
import pytest
from tests.frame_elements import beam_loads
from tests.validation.test_crankshaft_arrangements import loaded_shafts, machine

from cranktrain.questions.crankshaft.metal.shaft import StraightSpans
from cranktrain.questions.crankshaft.methods import BEARING_METHODS

METHODS = {method.name: method for method in BEARING_METHODS}
V12 = [f"{angle} deg" for angle in (0, 120, 240, 240, 120, 0)]
GIVES = {"bearing_stiffness": "400 kN/mm"}


def principal_stiffness(shaft, span):
    """EI in both principal planes: a moment alike all along turns what it goes through, piece by piece, web by web."""
    left, right = shaft.supports.place[0, span : span + 2]
    bounds, radius, angle = shaft.pieces.bounds[0], shaft.pieces.radius[0], shaft.pieces.angle[0]
    corner = radius * np.exp(1j * angle)
    turns = np.zeros((2, 2))
    for piece, bending in enumerate(shaft.pieces.bending[0]):
        turns += np.eye(2) * max(min(bounds[piece + 1], right) - max(bounds[piece], left), 0.0) / bending
    for web, z in enumerate(bounds[1:-1]):
        way = corner[web + 1] - corner[web]
        if left < z < right and way != 0:
            along = np.array([way.real, way.imag]) / abs(way)
            across = np.array([-along[1], along[0]])
            gives = abs(way) - np.sum(shaft.webs.rigid[0, web])
            turns += gives * np.outer(along, along) / shaft.webs.bending[0, web]
            turns += gives * np.outer(across, across) / shaft.webs.torsion[0, web]
    return (right - left) / np.linalg.eigvalsh(turns)


def of_spans(shaft):
    return np.array([[np.mean(principal_stiffness(shaft, span)) for span in range(shaft.straight.bending.shape[1])]])


def loaded(**crankshaft):
    return loaded_shafts(machine(V12, angles=("-30 deg", "30 deg"), crankshaft=crankshaft))


@pytest.mark.parametrize("bearings", [[1, 2, 3, 4, 5, 6, 7], [1, 3, 5, 7], [1, 4, 7], [1, 2, 7]])
def test_stiffness(bearings):
    """Like throws in whatever direction have one; so has a span with several of them."""
    shaft = loaded(bearings=bearings).each[0].metal
    np.testing.assert_allclose(shaft.straight.bending, of_spans(shaft), rtol=1e-13)


def test_like_throws_are_alike():
    bending = loaded(bearing_distance="75 mm").each[0].metal.straight.bending
    np.testing.assert_allclose(bending, np.broadcast_to(bending[:, :1], bending.shape), rtol=1e-14)


@pytest.mark.parametrize(("method", "gives"), [("three_moment", False), ("five_moment", True)])
@pytest.mark.parametrize("bearings", [[1, 2, 3, 4, 5, 6, 7], [1, 3, 5, 7]])
def test_v12_against_beam_elements(method, gives, bearings):
    whole = loaded(bearings=bearings, **GIVES)
    (spanned,), shaft = whole.loads(np.radians([[10.0, 77.0, 301.0]])), whole.each[0].metal
    found, acting = METHODS[method].of(shaft.supports, spanned).load, spanned.loads
    beam = shaft._replace(straight=StraightSpans(of_spans(shaft), shaft.straight.shear))
    for angle in range(3):
        borne, _moved = beam_loads(beam, acting, 0, angle, gives=gives)
        np.testing.assert_allclose(found[0, :, :, angle], borne, rtol=0, atol=1e-11 * np.max(np.abs(borne)))
