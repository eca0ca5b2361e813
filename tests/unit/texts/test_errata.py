"""Errors of the steam engine's text and of Bolotin's, in numbers that come from 40-digit arithmetic or closed forms."""

import mpmath as mp
import pytest

from cranktrain.texts.bolotin_errata import bolotin_errata
from cranktrain.texts.contents import text_called
from cranktrain.texts.errata import ERRATA
from cranktrain.texts.steam_engine_errata import steam_errata
from cranktrain.texts.throw_errata import throw_errata

BOLOTIN = {step.step: step for step in bolotin_errata()}
STEAM = {step.step.partition(",")[0]: step for step in steam_errata()}
LEAD = mp.pi / 15
TYPOGRAPHY = ("С9", "… + / + …")
"""Slips of print that no number follows from."""


def distance(alpha, ratio):
    """From the inner dead centre, of R = 1."""
    return 1 - mp.cos(alpha) + (1 - mp.sqrt(1 - (ratio * mp.sin(alpha)) ** 2)) / ratio


@pytest.mark.parametrize(("place", "near"), [("inner", 0.1), ("outer", mp.pi + 0.1)])
def test_half_the_lead_is_no_dead_centre_of_unequal_rods(place, near):
    """λ = 0.20 and 0.30: +0.24° inside and −0.40° outside, says the digest; here the root in 30 digits."""
    step = BOLOTIN[f"{place} volumetric dead centre"]
    with mp.workdps(30):
        both = lambda alpha: distance(alpha, mp.mpf("0.2")) + distance(alpha - LEAD, mp.mpf("0.3"))  # noqa: E731
        root = mp.findroot(lambda alpha: mp.diff(both, alpha), mp.mpf(near))
    assert step.right == pytest.approx(float(root), abs=1e-12)
    assert step.got == pytest.approx(float(LEAD / 2 + (mp.pi if place == "outer" else 0)), rel=1e-15)
    off = {"inner": 0.24, "outer": -0.40}[place]
    assert round(float(mp.degrees(root)) - float(mp.degrees(step.got)), 2) == off


def stroke(zeta):
    """Slave's stroke with the rods often quoted, in mm, by the exact distance in 30 digits."""
    with mp.workdps(30):
        R, L, r, l, gamma = map(mp.mpf, ("90", "320", "85", "235", mp.pi / 3))
        zeta = mp.radians(mp.mpf(zeta))

        def s(alpha):
            w = zeta - gamma - mp.asin(R / L * mp.sin(alpha))
            across = R * mp.sin(alpha - gamma) + r * mp.sin(w)
            return R * mp.cos(alpha - gamma) + r * mp.cos(w) + mp.sqrt(l**2 - across**2)

        ends = [mp.findroot(lambda alpha: mp.diff(s, alpha), gamma + start) for start in (0, mp.pi)]
        return float(s(ends[0]) - s(ends[1]))


def test_larger_stroke_is_no_law():
    """The digest: with the rods often quoted 187.07 mm at 67°, 186.70 at 66.63°, 180 at 59.8°."""
    smaller = next(step for name, step in BOLOTIN.items() if "larger" in name)
    assert smaller.got is None
    assert smaller.right == pytest.approx(stroke(55), abs=1e-9)
    assert smaller.right < 180.0
    assert round(stroke(59.8), 1) == 180.0
    printed = BOLOTIN["stroke of the slaves of 3Д12"]
    assert printed.got == pytest.approx(stroke(67), abs=1e-9)
    assert (round(printed.got, 2), printed.right, round(stroke(66.63), 1)) == (187.07, 186.7, 186.7)


def test_divided_constant_fails_where_the_others_do_not():
    """γ = 0: F = (R/l)(1 − 2r/L) + (R/L)(r/L)(1 + r/l)."""
    step = next(step for name, step in BOLOTIN.items() if name.startswith("constant F"))
    by_hand = 90 / 235 * (1 - 170 / 320) + 90 / 320 * 85 / 320 * (1 + 85 / 235)
    assert step.right == pytest.approx(by_hand, rel=1e-14)


def test_claims_of_the_steam_engines_text():
    """Brix 0.314 % and (337) 1.11 % at λ = 0.3, (334) 2.51 % at 0.1, as the digest's table has them."""
    assert STEAM["range of (333)"].got == pytest.approx(1.11, abs=0.005)
    assert STEAM["range of orthogonal projection"].got == pytest.approx(50 * (1 - 0.99**0.5) / 0.1, rel=1e-12)
    assert STEAM["Brix's construction"].got == pytest.approx(0.314, abs=0.001)
    # (1 − √(1 − λ²))/2λ is a hundredth at λ = 0.04
    by_hand = 50 * (1 - (1 - 0.04**2) ** 0.5) / 0.04
    assert by_hand == pytest.approx(1.0, abs=0.001)


@pytest.mark.parametrize("name", ERRATA)
def test_every_error_says_what_is_printed_and_why(name):
    assert text_called(name).name == name
    for step in ERRATA[name]():
        assert step.step
        assert step.printed
        assert step.why
        assert step.got is not None or step.right is not None or step.printed in TYPOGRAPHY


def test_errors_of_the_text_on_supports():
    """Balance of moments by hand: l = 131 mm, the counterweight 31 mm beyond the left support, webs of 22 and 24 mm."""
    steps = list(throw_errata())
    by_printed = {step.printed: step for step in steps}
    assert len(by_printed) == len(steps)
    twice = by_printed["(48) + M₀/l"]
    assert twice.right == pytest.approx(6100 * 162 / 131, rel=1e-13)
    assert twice.got == pytest.approx(6100 * 193 / 131, rel=1e-13)
    held = by_printed["C₃, C₅; K₁, K₂"]
    arm = (131 - 51) / 131
    assert held.right == pytest.approx((21.5 - 2.6) * arm, rel=1e-13)
    assert held.got == pytest.approx((21.5 - 2 * 2.6) * arm, rel=1e-13)
    assert by_printed["ΣC = 0"].right == pytest.approx(-4100 * (2 * 15 + 2 * 13.5 + 22) / 262, rel=1e-13)
    assert by_printed["l₁ + h_L 2"][2:4] == pytest.approx((18, 25), rel=1e-13)
    assert by_printed["R_TCP, R_TP"].right == pytest.approx(1000 * (51 - 25) / 131, rel=1e-13)
    assert by_printed["l, l₇"].right == pytest.approx(131, rel=1e-13)
    assert by_printed["C₈ + C₁₄, C₉ + C₁₅"].right == pytest.approx(-460 * 25 / 131, rel=1e-13)
    assert "hP" in by_printed["h_p, h_P, h_П"].why
