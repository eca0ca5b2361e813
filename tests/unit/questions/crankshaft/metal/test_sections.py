"""Stiffness of sections against other sums, integrals and limits."""

import mpmath as mp
import numpy as np
import pytest

from cranktrain.questions.crankshaft.metal.pieces_of_throws import (
    WEB_RULES,
    ThrowGeometry,
    pieces_of_throws,
    webs_of_throws,
)
from cranktrain.questions.crankshaft.metal.sections import (
    Material,
    rectangle_in_torsion,
    round_in_shear,
    round_section,
    web_section,
)
from cranktrain.questions.crankshaft.metal.shaft import bearing_compliance

STEEL = Material(np.array(206e9), np.array(206e9 / 2.6))


@pytest.mark.parametrize("ratio", [1.0, 0.8, 0.5, 18 / 76, 0.1, 1e-3])
def test_torsion_of_a_rectangle_against_its_series_in_30_digits(ratio):
    with mp.workdps(30):
        long, short = mp.mpf(1), mp.mpf(ratio)
        terms = mp.nsum(lambda n: mp.tanh((2 * n + 1) * mp.pi * long / (2 * short)) / (2 * n + 1) ** 5, [0, mp.inf])
        wanted = long * short**3 * (mp.mpf(1) / 3 - 64 * short / long / mp.pi**5 * terms)
    for sides in ((1.0, ratio), (ratio, 1.0)):
        assert float(rectangle_in_torsion(*map(np.array, sides))) == pytest.approx(float(wanted), rel=1e-14)


def test_round_section():
    """Against integrals over the ring."""
    section = round_section(np.array(0.05), np.array(0.02), STEEL)
    second, _error = mp.quad(lambda r: mp.pi * r**3, [0.01, 0.025], error=True)
    area = mp.quad(lambda r: 2 * mp.pi * r, [0.01, 0.025])
    assert float(section.bending) == pytest.approx(206e9 * float(second), rel=1e-14)
    assert float(section.torsion) == pytest.approx(206e9 / 2.6 * 2 * float(second), rel=1e-14)
    assert float(section.axial) == pytest.approx(206e9 * float(area), rel=1e-14)


@pytest.mark.parametrize(("bore", "factor"), [(0.0, 7.8 / 8.8), (1.0, 2 * 1.3 / (4 + 3 * 0.3))])
def test_cowper_for_solid_sections_and_thin_tubes(bore, factor):
    """6(1 + ν)/(7 + 6ν) and 2(1 + ν)/(4 + 3ν), ν = 0.3."""
    assert float(round_in_shear(np.array(bore), STEEL)) == pytest.approx(factor, rel=1e-14)


def test_web():
    web = web_section(np.array(0.08), np.array(0.02), STEEL)
    assert float(web.bending) == pytest.approx(206e9 * 0.08 * 0.02**3 / 12)
    assert float(web.bending_across / web.bending) == pytest.approx(16)
    assert float(web.shear / web.axial) == pytest.approx(5 / 6 / 2.6)


def test_throws_in_line():
    throws = ThrowGeometry(
        np.array([[0.0, 0.4]]),
        np.array([[[0.1, 0.15], [0.25, 0.3]]]),
        np.array([[0.04, 0.05]]),
        np.array([[0.3, -2.0]]),
    )
    journal, pin = np.array([[0.06, 0.07, 0.08]]), np.array([[0.05, 0.055]])
    pieces = pieces_of_throws(throws, round_section(journal, 0 * journal, STEEL), round_section(pin, 0 * pin, STEEL))
    np.testing.assert_array_equal(pieces.bounds, [[0.0, 0.1, 0.15, 0.25, 0.3, 0.4]])
    np.testing.assert_array_equal(pieces.radius, [[0.0, 0.04, 0.0, 0.05, 0.0]])
    np.testing.assert_array_equal(pieces.angle, [[0.0, 0.3, 0.0, -2.0, 0.0]])
    assert pieces.axial[0, 1] == pytest.approx(206e9 * np.pi / 4 * 0.05**2)
    width = np.array([[[0.1, 0.11], [0.12, 0.13]]])
    webs = webs_of_throws(throws, web_section(width, 0.2 * width, STEEL), journal, pin, WEB_RULES[1])
    np.testing.assert_allclose(webs.axial, 206e9 * 0.2 * width.reshape(1, 4) ** 2)
    ends = [[0.06, 0.05], [0.05, 0.07], [0.07, 0.055], [0.055, 0.08]]
    np.testing.assert_allclose(webs.rigid, 0.2 * np.array([ends]), rtol=1e-15)


def test_compliance_of_bearings():
    stiffness = np.array([[[3e8, 1e8], [1e8, 5e8]], [[4e8, 0.0], [0.0, 4e8]]])
    np.testing.assert_allclose(bearing_compliance(stiffness), np.linalg.inv(stiffness), rtol=1e-14)
    rigid = np.array([[np.inf, 0.0], [0.0, np.inf]])
    np.testing.assert_array_equal(bearing_compliance(rigid), np.zeros((2, 2)))
