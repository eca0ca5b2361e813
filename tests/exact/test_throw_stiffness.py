"""Twist from throw to throw against frames of beam elements in 40 digits, and rules of textbooks in 40 digits."""

from itertools import pairwise

import mpmath as mp
import numpy as np
import pytest
from flint import arb, ctx
from tests.crankshafts import drawn_crankshaft
from tests.frame_elements import DIGITS, NONE, CrankFrame

from cranktrain.questions.crankshaft.bending.frame_twist import twist_when_clamped, twist_when_free
from cranktrain.questions.crankshaft.bending.shaft_loads import ShaftLoads
from cranktrain.questions.crankshaft.metal.throw_gaps import Gaps, carter, ker_wilson, zimanenko

LIMIT = 1e-11
SEEDS = [seed for seed in range(24) if np.count_nonzero(drawn_crankshaft(seed)[0].pieces.radius) > 1][:12]


def twists(shaft, pins, *, is_clamped):
    """Twist from the middle of each pin to that of the next, of a torque from one end of the shaft to the other."""
    z = (shaft.pieces.bounds[:, pins] + shaft.pieces.bounds[:, pins + 1]) / 2
    where = shaft.pieces.radius[:, pins], shaft.pieces.angle[:, pins]
    marks = ShaftLoads(pins, pins < 0, z, *where, np.full((1, 1), 0.3), np.zeros((1, pins.size, 2, 1)))
    ctx.dps = DIGITS
    whole = CrankFrame(shaft, marks, 0, 0)
    frame, last = whole.frame, whole.last
    frame.push(whole.of_piece[0][0].begin, NONE, (arb(0), arb(0), arb(1)))
    frame.held |= {6 * last + i: arb(0) for i in ((2, 5) if is_clamped else range(6))}
    if is_clamped:
        frame.held |= {6 * node + i: arb(0) for node in whole.bearings.values() for i in (0, 1, 3, 4)}
    shift, _reaction = frame.solved()
    at_pins = [shift[6 * whole.of_piece[pin][0].end + 5] for pin in pins.tolist()]
    return np.array([[float(one - other) for one, other in pairwise(at_pins)]])


@pytest.mark.parametrize("is_clamped", [False, True])
@pytest.mark.parametrize("seed", SEEDS)
def test_twist_of_frames(seed, is_clamped):
    """Throws beyond the bearings, several in a span, webs from pin to pin."""
    shaft, _loads = drawn_crankshaft(seed)
    pins = np.flatnonzero(shaft.pieces.radius[0])
    found = (twist_when_clamped if is_clamped else twist_when_free)(shaft, pins)
    np.testing.assert_allclose(found, twists(shaft, pins, is_clamped=is_clamped), rtol=LIMIT)


def drawn_gaps(seed):
    draw = np.random.default_rng(seed)

    def section(*shape):
        diameter = draw.uniform(0.05, 0.09, shape)
        return np.stack([diameter, draw.uniform(0, 0.6, shape) * diameter], axis=-1)

    both = [draw.uniform(*limits, (2, 3, 2)) for limits in ((0.02, 0.05), (0.04, 0.08), (0.06, 0.12), (0.01, 0.03))]
    return Gaps(section(2, 3), draw.uniform(0.02, 0.05, (2, 3)), section(2, 3, 2), *both)


def exact(rule, gaps, design, gap):
    """Half the rule of each side's throw, on the journal that both share."""

    def number(values, *side):
        return mp.mpf(float(values[design, gap, *side]))

    big, length = number(gaps.journal, 0), number(gaps.journal_length)
    journal = big**4 - number(gaps.journal, 1) ** 4
    found = length / journal
    for side in range(2):
        small, pin_length = number(gaps.pin, side, 0), number(gaps.pin_length, side)
        pin = small**4 - number(gaps.pin, side, 1) ** 4
        r, b, h = (number(values, side) for values in (gaps.radius, gaps.web_width, gaps.web_thickness))
        web = h * b**3
        found += {
            "carter": (mp.mpf(4) / 5 * h / journal + mp.mpf(3) / 4 * pin_length / pin + mp.mpf(3) / 2 * r / web) / 2,
            "ker_wilson": (
                mp.mpf(2) / 5 * big / journal
                + (pin_length + mp.mpf(2) / 5 * small) / pin
                + (r - (big + small) / 5) / web
            )
            / 2,
            "zimanenko": (
                mp.mpf(3) / 5 * h * big / length / journal
                + (mp.mpf(4) / 5 * pin_length + b * big / r / 5) / pin
                + r * mp.sqrt(r / small) / web
            )
            / 2,
        }[rule]
    return found


@pytest.mark.parametrize("rule", [carter, ker_wilson, zimanenko], ids=lambda rule: rule.__name__)
@pytest.mark.parametrize("seed", range(3))
def test_rules(rule, seed):
    gaps = drawn_gaps(seed)
    found = rule(gaps)
    with mp.workdps(40):
        for design, gap in np.ndindex(found.shape):
            wanted = exact(rule.__name__, gaps, design, gap)
            assert abs(mp.mpf(float(found[design, gap])) / wanted - 1) < 5e-15
