"""Wanted motions by positions with rests and by coefficients: a system of polynomials in 40 digits, closed forms."""

import mpmath
import numpy as np
import pytest
from numpy.testing import assert_allclose

import cranktrain as ct
from cranktrain.analysis.parts import parts_of
from cranktrain.layout.wish.declared import RockingMotions, WantedMotions
from cranktrain.layout.wish.following import crank_at, rocking_crank
from cranktrain.layout.wish.wanted import moved

YOKE = {"kind": "scotch_yoke", "crank_radius": "50 mm"}
TIMES = [0, 0.2, 0.4, 0.6, 0.8, 1.1, 1.4, 1.9]
PLACES = [0, 20, 50, 82, 100, 100, 40, 0]
RESTS = [(0.8, 1.1), (1.9, 0)]
FREE = [0, 1, 2, 3, 5, 6]  # spans that move


def listed(times=TIMES, places=PLACES, rests=RESTS, period="2 s", **more):
    rest = [{"begin": f"{begin} s", "until": f"{end} s"} for begin, end in rests]
    positions = [f"{place} mm" for place in places]
    return {"times": [f"{t} s" for t in times], "positions": positions, "period": period, "rest": rest, **more}


def machine(motion, **tables):
    return ct.Machine(mechanism=YOKE, shaft={"main": {"motion": motion}}, **tables)


def followed(motion, kind=WantedMotions):
    return parts_of([machine(motion)], step=np.radians(1))[kind].each[0]


def splines():
    """Powers of every span that moves, from one linear system: value, speed and acceleration go on, rests stand."""
    with mpmath.workdps(40):
        degrees = {0: 5, 1: 3, 2: 3, 3: 5, 5: 5, 6: 5}
        spans = {n: mpmath.mpf(TIMES[n + 1]) - mpmath.mpf(TIMES[n]) for n in FREE}
        first, rows, right = {}, [], []
        size = 0
        for n in FREE:
            first[n], size = size, size + degrees[n] + 1

        def term(n, order, at_end):
            row = mpmath.matrix(1, size)
            for k in range(order, degrees[n] + 1):
                power = mpmath.ff(k, order) * (spans[n] ** (k - order) if at_end else (1 if k == order else 0))
                row[first[n] + k] = power
            return row

        def meets(row, value):
            rows.append(row)
            right.append(mpmath.mpf(value))

        for n in FREE:
            meets(term(n, 0, at_end=False), PLACES[n])
            meets(term(n, 0, at_end=True), PLACES[n + 1])
        for before, after in ((0, 1), (1, 2), (2, 3), (5, 6)):
            for order in (1, 2):
                meets(term(before, order, at_end=True) - term(after, order, at_end=False), 0)
        for n, at_end in ((0, False), (3, True), (5, False), (6, True)):
            for order in (1, 2, 3):
                meets(term(n, order, at_end=at_end), 0)
        matrix = mpmath.matrix(len(rows), size)
        for i, row in enumerate(rows):
            for j in range(size):
                matrix[i, j] = row[j]
        solved = mpmath.lu_solve(matrix, mpmath.matrix(right))
        return {n: [float(solved[first[n] + k]) for k in range(degrees[n] + 1)] for n in FREE}


def test_positions_with_rests_are_the_smoothest_curve_that_stands():
    made = followed(listed(counts_from="near"))
    for n, powers in splines().items():
        within = np.linspace(0, TIMES[n + 1] - TIMES[n], 23)
        found = moved(made.wanted, TIMES[n] + within)
        curve = np.polynomial.Polynomial(powers)
        low = made.output.low.position
        assert_allclose(1e3 * (found.value - low), curve(within), rtol=0, atol=1e-11 * 100)
        assert_allclose(1e3 * found.first[:-1], curve.deriv(1)(within)[:-1], rtol=0, atol=1e-10 * 100)
        assert_allclose(1e3 * found.second[:-1], curve.deriv(2)(within)[:-1], rtol=0, atol=1e-9 * 1000)


def test_in_a_rest_speed_and_acceleration_are_nothing():
    """Exactly, from its first moment to its last, of slider and crank."""
    made = followed(listed(counts_from="near"))
    for begin, end in ((0.8, 1.1), (1.9, 2.0)):
        time = np.linspace(begin, end, 40)
        found = moved(made.wanted, time)
        for derivative in (found.first, found.second):
            np.testing.assert_array_equal(derivative, 0.0)
        crank = crank_at(made, time[1:-1])
        np.testing.assert_array_equal(crank.speed, 0.0)
        np.testing.assert_array_equal(crank.acceleration, 0.0)
    assert sorted(span for _angle, span in made.dwells) == pytest.approx([0.1, 0.3])


def test_lists_say_the_same_wherever_they_begin():
    """The same points from another one on: the file's clock is the same."""
    turned = listed(TIMES[3:] + [t + 2 for t in TIMES[:3]], PLACES[3:] + PLACES[:3], [(0.8, 1.1), (1.9, 2)])
    one, other = (followed({**motion, "counts_from": "near"}) for motion in (listed(), turned))
    time = np.linspace(0, 2, 401)
    for a, b in zip(moved(other.wanted, time - 0.6), moved(one.wanted, time), strict=True):
        assert_allclose(a, b, rtol=0, atol=1e-11 * np.max(np.abs(b)))


def test_straight_from_rest_to_rest_is_a_4567():
    rests = [(1, 1.4), (2.4, 0)]
    own = followed(listed([0, 1, 1.4, 2.4], [0, 100, 100, 0], rests, "3 s", counts_from="near"))
    pieces = [
        {"duration": f"{span} s"} | ({} if to is None else {"to": to})
        for span, to in ((1, "100 mm"), (0.4, None), (1, "0 mm"), (0.6, None))
    ]
    other = followed({"piece": pieces, "counts_from": "near"})
    time = np.linspace(0, 3, 301)
    for a, b in zip(moved(own.wanted, time), moved(other.wanted, time), strict=True):
        assert_allclose(a, b, rtol=0, atol=1e-12)


def by_coefficients(*each, **more):
    pieces = [{"duration": "1 s", "to": to, "coefficients": list(series)} for to, series in each]
    return {"piece": pieces, **more}


SEVENTH = (0, 0, 0, 0, 35, -84, 70, -20)
UNEVEN = (0, 0, 0, 0, 70, -224, 280, -160, 35)  # ∫s³(1 − s)⁴ over the whole: leaves like s⁴, comes like s⁵


def test_coefficients_are_the_law_that_has_them():
    own = followed(by_coefficients(("100 mm", SEVENTH), ("0 mm", SEVENTH)))
    other = followed({"piece": [{"duration": "1 s", "to": to} for to in ("100 mm", "0 mm")]})
    time = np.linspace(0, 2, 401)
    for a, b in zip(moved(own.wanted, time), moved(other.wanted, time), strict=True):
        assert_allclose(a, b, rtol=0, atol=2e-13 * np.max(np.abs(b)))  # 209 of all coefficients, in last digits


def test_a_polynomial_of_ones_own_moves_the_crank():
    """x = r cos φ: φ = arccos(1 − p/r), ω = ṗ/(r sin φ), with ṗ ~ s³(1 − s)⁴ in closed form."""
    made = followed(by_coefficients(("100 mm", UNEVEN), ("0 mm", UNEVEN)))
    s = np.linspace(0.02, 0.98, 97)
    with mpmath.workdps(40):  # near the end 1 − y has no figures left in double
        angles = [mpmath.acos(1 - 2 * sum(c * mpmath.mpf(at) ** k for k, c in enumerate(UNEVEN))) for at in s.tolist()]
        angle, sine = (np.array([float(f(one)) for one in angles]) for f in (mpmath.mpf, mpmath.sin))
    velocity = 0.1 * 280 * s**3 * (1 - s) ** 4
    crank = crank_at(made, s)
    assert_allclose(crank.angle, angle, atol=1e-9)
    assert_allclose(crank.speed, velocity / (0.05 * sine), rtol=1e-9)


def test_a_polynomial_may_go_beyond_its_end_and_come_back():
    """y = 4s − 3s², largest at ⅔, where it is 4/3; back by its mirror image: a crank that rocks."""
    there, back = (0, 4, -3), (0, -2, 3)
    pieces = [("50 mm", there), ("20 mm", back)]
    motion = by_coefficients(*pieces, mode="rocking")
    with pytest.raises(ct.InputError, match="velocity with which the piece before ends"):
        ct.run(machine(motion))  # there ends with −2, back begins with −2 of a way of other sign
    smooth = (0, 0, 0, 40, -75, 36)  # y′ = 60 s²(2 − 5s + 3s²), 0 at ⅔ and 1
    made = followed(by_coefficients(("50 mm", smooth), ("20 mm", SEVENTH), mode="rocking"), RockingMotions)
    s = np.linspace(0, 1, 41)[1:-1]
    place = 0.02 + 0.03 * sum(c * s**k for k, c in enumerate(smooth))
    crank = rocking_crank(made, s)
    assert_allclose(crank.angle, np.arccos(1 - place / 0.05), atol=1e-10)
    assert np.max(place) > 0.0545 and np.any(crank.speed[:30] < 0)


REFUSED = {
    "not a time": (listed(rests=[(0.7, 0.8)]), "rest[0].begin", "must be one of the times"),
    "not the next": (listed(rests=[(0.8, 1.4)]), "rest[0].until", "the time after its beginning, 1.1 s"),
    "it moves": (listed(rests=[(0.4, 0.6)]), "rest[0]", "goes from 50 mm to 82 mm"),
    "twice": (listed(rests=[*RESTS, (0.8, 1.1)]), "rest[2].begin", "is there twice"),
    "no end": ({**listed(), "rest": [{"begin": "0.8 s"}]}, "rest[0].until", "is missing"),
    "beside pieces": (
        {"piece": [{"duration": "1 s", "to": "100 mm"}], "rest": [{"begin": "0 s", "until": "1 s"}]},
        "rest",
        "a piece without `to` stands",
    ),
    "wobbling": (listed(places=[0, 60, 50, 82, 100, 100, 40, 0], counts_from="near"), "", "turns round 4 times"),
    "both": (
        {"piece": [{"duration": "1 s", "to": "100 mm", "law": "3-4-5", "coefficients": [0, 1]}]},
        "piece[0].coefficients",
        "beside a law, 3-4-5",
    ),
    "a rest's": (
        {"piece": [{"duration": "1 s", "to": "100 mm"}, {"duration": "1 s", "coefficients": [0, 1]}]},
        "piece[1].coefficients",
        "a piece that stands",
    ),
    "constant": (by_coefficients(("100 mm", (1, 0)), ("0 mm", SEVENTH)), "piece[0].coefficients[0]", "must be 0"),
    "not whole": (
        by_coefficients(("100 mm", (0, 0, 3, -1.9)), ("0 mm", SEVENTH)),
        "piece[0].coefficients",
        "they are 1.1",
    ),
    "one": (by_coefficients(("100 mm", (0,)), ("0 mm", SEVENTH)), "piece[0].coefficients", "2"),
    "like t³": (
        by_coefficients(("100 mm", (0, 0, 0, 10, -15, 6)), ("0 mm", SEVENTH)),
        "piece[0].law",
        "infinite acceleration",
    ),
    "nowhere": (
        by_coefficients(("50 mm", SEVENTH), ("50 mm", SEVENTH), mode="rocking"),
        "piece[0].coefficients",
        "goes nowhere",
    ),
    "a jump": (by_coefficients(("100 mm", (0, 1)), ("0 mm", SEVENTH)), "piece[0].law", "must begin with the velocity"),
    "a word": (by_coefficients(("100 mm", ("0", "much")), ("0 mm", SEVENTH)), "piece[0].coefficients[1]", "number"),
}


@pytest.mark.parametrize(("motion", "path", "said"), REFUSED.values(), ids=REFUSED)
def test_what_cannot_be_is_refused_at_its_place(motion, path, said):
    with pytest.raises(ct.InputError) as caught:
        ct.run(machine(motion))
    found = {problem.path: str(problem) for problem in caught.value.problems}
    where = "shaft.main.motion" + (f".{path}" if path else "")
    assert where in found, found
    assert said in found[where]
