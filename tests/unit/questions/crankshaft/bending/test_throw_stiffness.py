"""Stiffness from throw to throw: closed forms, what cannot change it, many shafts at once, what is no shaft."""

import numpy as np
import pytest
from tests.crankshaft_i4 import RADIUS, SIZES, N, crankshaft
from tests.crankshafts import drawn_crankshaft

from cranktrain.numerics.nested import mapped
from cranktrain.questions.crankshaft.bending.frame_twist import twist_when_clamped, twist_when_free
from cranktrain.questions.crankshaft.bending.throw_stiffness import THROW_METHODS, ShaftInTorsion
from cranktrain.questions.crankshaft.metal.shaft import Pieces, Webs
from cranktrain.questions.crankshaft.metal.throw_gaps import (
    ThrowSizes,
    carter,
    gaps_of,
    ker_wilson,
    ker_wilson_web,
    like_throws,
    zimanenko,
)

SHEAR = 206e9 / 2.6
RULES = (carter, ker_wilson, zimanenko)
PINS = 2 * np.arange(N) + 1
LIKE = like_throws(0.039, (0.05, 0.028), (0.048, 0.028), (0.076, 0.018))


def solid(diameter, *shape):
    return np.stack([np.full(shape, diameter), np.zeros(shape)], axis=-1)


def sizes(n_designs=1):
    """Of the in-line four."""
    both = (n_designs, N, 2)
    return ThrowSizes(
        np.tile(np.arange(N)[:, np.newaxis] * SIZES["span"] + SIZES["web_mid_planes"], (n_designs, 1, 1)),
        np.full((n_designs, N), RADIUS),
        solid(SIZES["main_diameter"], n_designs, N + 1),
        solid(SIZES["crankpin_diameter"], n_designs, N),
        np.full((n_designs, N), SIZES["crankpin_length"]),
        np.full(both, SIZES["web_width"]),
        np.full(both, SIZES["web_thickness"]),
    )


def in_line_four():
    return ShaftInTorsion(crankshaft(), PINS, gaps_of(sizes()), np.array([SHEAR]))


@pytest.mark.parametrize(
    ("name", "printed"),
    [("frame", 380), ("frame_clamped", 436), ("carter", 429), ("ker_wilson", 409), ("zimanenko", 391)],
)
def test_in_line_four(name, printed):
    """Against numbers made for that engine by another program, in kN·m/rad; the first is rounded to tens."""
    method = next(method for method in THROW_METHODS if method.name == name)
    off = 0.6 if name == "frame" else 0.5
    np.testing.assert_allclose(method.stiffness(in_line_four()) / 1e3, np.full((1, N - 1), printed), rtol=0, atol=off)


def test_frame_is_its_parts_in_a_row():
    """Journal, two webs bent across, pin: l/GJ and r/EI, of sections by hand."""
    length = SIZES["crankpin_length"] + SIZES["web_thickness"]
    polar = np.pi / 32 * np.array([SIZES["main_diameter"], SIZES["crankpin_diameter"]]) ** 4
    across = 206e9 * SIZES["web_thickness"] * SIZES["web_width"] ** 3 / 12
    parts = np.sum(length / (SHEAR * polar)) + 2 * RADIUS / across
    np.testing.assert_allclose(twist_when_free(crankshaft(), PINS), np.full((1, N - 1), parts), rtol=1e-14)


def test_clamped_frame_of_like_throws():
    """1/k − 2 φ²/(A − B): the moments of a throw are opposite by symmetry; A − B from the energy that they take."""
    shaft = crankshaft()
    l, lp, lj = SIZES["span"], 0.046, 0.023
    r, pieces, webs = RADIUS, shaft.pieces, shaft.webs
    gp, gaj, gap = pieces.torsion[0, 1], pieces.shear[0, 0], pieces.shear[0, 1]
    ei, ep = pieces.bending[0, 0], pieces.bending[0, 1]
    across, twisting, sheared = webs.bending_across[0, 0], webs.torsion[0, 0], webs.shear[0, 0]
    slope = (r * lp / gp + r**2 / across) / l
    # Moments ±1 at the ends: m = 1 − 2z/l, S = −2/l; strain energy of both halves, doubled.
    journals = 2 * (l / 6) * (1 - (1 - 2 * lj / l) ** 3) / ei + 2 * lj * (2 / l) ** 2 / gaj
    pin = (l / 3) * (1 - 2 * lj / l) ** 3 / ep + lp * ((2 / l) ** 2 / gap + (2 * r / l) ** 2 / gp)
    web = 2 * (r * (1 - 2 * lj / l) ** 2 / twisting + (2 / l) ** 2 * (r**3 / (3 * across) + r / sheared))
    opposed = (journals + pin + web) / 2
    wanted = twist_when_free(shaft, PINS) - 2 * slope**2 / opposed
    np.testing.assert_allclose(twist_when_clamped(shaft, PINS), wanted, rtol=1e-12)


@pytest.mark.parametrize("rule", RULES)
def test_rules_have_the_dimension_of_a_length(rule):
    """A shaft of twice the size has an eighth of length over the fourth power of diameter."""
    twice = type(LIKE)(*(2 * values for values in LIKE))
    np.testing.assert_allclose(rule(twice), rule(LIKE) / 8, rtol=1e-15)


@pytest.mark.parametrize("name", ["frame", "frame_clamped"])
def test_units(name):
    """In millimetres and kilonewtons numbers are other, and stiffness the same: kN·mm is N·m."""
    method = next(method for method in THROW_METHODS if method.name == name)
    own = in_line_four()
    pieces, webs, supports = own.shaft.pieces, own.shaft.webs, own.shaft.supports
    other = own.shaft._replace(
        pieces=Pieces(
            1e3 * pieces.bounds, 1e3 * pieces.radius, pieces.angle, 1e3 * pieces.bending, 1e3 * pieces.torsion,
            1e-3 * pieces.shear, 1e-3 * pieces.axial,
        ),
        webs=Webs(
            1e3 * webs.bending, 1e3 * webs.bending_across, 1e3 * webs.torsion, 1e-3 * webs.shear, 1e-3 * webs.axial,
            1e3 * webs.rigid,
        ),
        supports=supports._replace(place=1e3 * supports.place),
    )  # fmt: skip
    np.testing.assert_allclose(method.stiffness(own._replace(shaft=other)), method.stiffness(own), rtol=1e-12)


@pytest.mark.parametrize("seed", [0, 3, 5, 7])
def test_from_the_other_end(seed):
    """A shaft looked at from its other end has the same gaps in the other order."""
    shaft, _loads = drawn_crankshaft(seed)
    pieces, webs, supports = shaft.pieces, shaft.webs, shaft.supports
    end = pieces.bounds[:, -1:]
    turned = shaft._replace(
        pieces=Pieces(end - pieces.bounds[:, ::-1], *(values[:, ::-1] for values in pieces[1:])),
        webs=Webs(*(values[:, ::-1] for values in webs[:-1]), rigid=webs.rigid[:, ::-1, ::-1]),
        supports=supports._replace(place=end - supports.place[:, ::-1]),
    )
    pins = np.flatnonzero(pieces.radius[0])
    back = np.flatnonzero(turned.pieces.radius[0])
    for twist in (twist_when_free, twist_when_clamped):
        np.testing.assert_allclose(twist(turned, back), twist(shaft, pins)[:, ::-1], rtol=1e-11)


def test_each_design_alone():
    """Shafts whose webs lie between other bearings, at once: each to the last bit what it gives alone."""
    one = crankshaft()
    moved = one._replace(supports=one.supports._replace(place=one.supports.place + np.array([0, 0.082, 0, 0, 0])))
    thick = one._replace(pieces=one.pieces._replace(bending=1.3 * one.pieces.bending))
    alone = (one, moved, thick)
    together = mapped(lambda _name, value: value, one)
    for name in ("pieces", "webs", "supports", "straight"):
        parts = [getattr(shaft, name) for shaft in alone]
        joined = [
            np.concatenate(values) if isinstance(values[0], np.ndarray) else values[0]
            for values in zip(*parts, strict=True)
        ]
        together = together._replace(**{name: type(parts[0])(*joined)})
    for twist in (twist_when_free, twist_when_clamped):
        wanted = np.concatenate([twist(shaft, PINS) for shaft in alone])
        np.testing.assert_array_equal(twist(together, PINS), wanted)


def test_unlike_throws_and_bores():
    """The journal, the pins and the webs of a gap count, and none beyond it."""
    own = sizes()
    wide = own.web_width.copy()
    wide[:, 0, 0] = wide[:, -1, 1] = 1.0
    for rule in RULES:
        np.testing.assert_array_equal(rule(gaps_of(own._replace(web_width=wide))), rule(gaps_of(own)))
    hollow = own.pin.copy()
    hollow[:, 1, 1] = 0.02
    for rule in RULES:
        softer = rule(gaps_of(own._replace(pin=hollow))) / rule(gaps_of(own))
        assert np.all(softer[:, :2] > 1)
        np.testing.assert_array_equal(softer[:, 2], 1.0)


def test_clamped_journals_are_stiffer():
    for seed in range(8):
        shaft, _loads = drawn_crankshaft(seed)
        ends = np.flatnonzero(shaft.pieces.radius[0])[[0, -1]]
        assert np.all(twist_when_clamped(shaft, ends) <= twist_when_free(shaft, ends) * (1 + 1e-12))


def test_one_throw_has_no_gap():
    shaft, pins = crankshaft(), np.array([3])
    assert twist_when_free(shaft, pins).shape == twist_when_clamped(shaft, pins).shape == (1, 0)


def test_what_is_no_shaft_has_no_stiffness():
    """Webs of no width, journals of no length, and a shaft that rests on a single bearing."""
    own = in_line_four()
    flat = own._replace(gaps=own.gaps._replace(web_width=0 * own.gaps.web_width))
    short = own._replace(gaps=own.gaps._replace(journal_length=0 * own.gaps.journal_length))
    supports = own.shaft.supports
    single = supports._replace(place=supports.place[:, :1], compliance=supports.compliance[:, :1])
    by_name = {method.name: method for method in THROW_METHODS}
    for name in ("carter", "ker_wilson", "zimanenko"):
        assert np.all(np.isnan(by_name[name].stiffness(flat)))
    assert np.all(np.isnan(by_name["zimanenko"].stiffness(short)))
    assert np.all(np.isnan(by_name["frame_clamped"].stiffness(own._replace(shaft=own.shaft._replace(supports=single)))))


def test_where_ker_wilson_leaves_no_web():
    """Radius 19.6 mm is a fifth of 50 mm and 48 mm."""
    np.testing.assert_allclose(ker_wilson_web(LIKE._replace(radius=np.full((1, 1, 2), 0.0196))), 0, atol=1e-17)
