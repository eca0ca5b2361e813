"""A crank that follows a wanted motion: closed forms of a scotch yoke, slider-crank and crank-rocker in 40 digits."""

import itertools
from functools import cache

import mpmath
import numpy as np
import pytest
from flint import arb, arb_series, ctx
from tests.machines import ROCKER, slider
from tests.sentences import NOT_POSITIVE

import cranktrain as ct
from cranktrain.analysis.parts import parts_of
from cranktrain.layout.mechanisms import Mechanisms, mechanisms_of
from cranktrain.layout.speed import SpeedCurve
from cranktrain.layout.wish.declared import RockingMotions, WantedMotions
from cranktrain.layout.wish.fitting import WishWay, fitted
from cranktrain.layout.wish.following import crank_at, crank_by_angle, rocking_crank
from cranktrain.layout.wish.laws import LAWS, Law, polynomial_law
from cranktrain.layout.wish.stroke import output_of
from cranktrain.layout.wish.wanted import Piece, from_pieces, moved, position, through_positions

RADIUS, ROD, OFFSET = "0.05", "0.18", "0.012"
YOKE = {"kind": "scotch_yoke", "crank_radius": "50 mm"}
SLIDER = slider(offset="12 mm")
NO_REST = "must not stand beside"
WAY = WishWay(0.0, 1.0, "mm", "shaft.main.motion", is_table=False)


def piece(duration, to=None, law=None, key="to"):
    given = {"duration": duration, key: to, "law": law}
    return {name: value for name, value in given.items() if value is not None}


def machine(motion, mechanism=YOKE, **tables):
    return ct.Machine(mechanism=mechanism, shaft={"main": {"motion": motion}}, **tables)


def followed(motion, mechanism=YOKE):
    """The first wanted motion of a machine as it is laid out."""
    parts = parts_of([machine(motion, mechanism)], step=np.radians(1))
    return parts[WantedMotions].each[0]


def slider_at(angle):
    """x of the slider-crank at a crank angle, in as many digits as there are."""
    r, l, e = map(mpmath.mpf, (RADIUS, ROD, OFFSET))
    return r * mpmath.cos(angle) + mpmath.sqrt(l**2 - (r * mpmath.sin(angle) - e) ** 2)


@cache
def dead_centres():
    """Crank angles and positions of the slider-crank's dead centres: crank and rod in one line."""
    with mpmath.workdps(50):
        r, l, e = map(mpmath.mpf, (RADIUS, ROD, OFFSET))
        high, low = mpmath.asin(e / (r + l)), mpmath.pi + mpmath.asin(e / (l - r))
        return [(high, slider_at(high)), (low, slider_at(low))]


def crank_in_digits(position, time, start, x):
    """φ, ω and ε of a crank at a time, with x(φ) = position(t); in 60 digits, so that nothing cancels."""
    with mpmath.workdps(60):
        angle = mpmath.findroot(lambda phi: x(phi) - position(time), start)
        first, second = (mpmath.diff(x, angle, n) for n in (1, 2))
        speed = mpmath.diff(position, time) / first
        return angle, speed, (mpmath.diff(position, time, 2) - second * speed**2) / first


def slider_series(angle, turned):
    """x of the slider-crank by the share of what the crank turns from an angle on, as a power series in 40 digits."""
    r, l, e = map(arb, (RADIUS, ROD, OFFSET))
    sin, cos = arb_series([arb(mpmath.nstr(one, 45)) for one in (angle, turned)]).sin_cos()
    return r * cos + (l * l - (r * sin - e) ** 2).sqrt()


def taylor_law(start, end):
    """Law of a piece at constant speed by its power series at both its ends."""
    cap, ctx.cap = ctx.cap, 25
    try:
        with ctx.workdps(40):
            forth, back = slider_series(start, end - start), slider_series(end, start - end)
            rise = back[0] - forth[0]
            both = [[float(sign * one[n] / rise) for n in range(1, 25)] for sign, one in ((1, forth), (-1, back))]
    finally:
        ctx.cap = cap
    series = [np.array([0.0, *one]) for one in both]
    for one in series:
        one[np.abs(one) < 1e-25] = 0.0
    law = polynomial_law(series[0])
    return Law(law.shape, law.way, *series, reach=1.0)


def constant_speed(n_pieces=8):
    """Motion of the offset slider-crank at 10 rad/s, as pieces of Taylor's series."""
    omega = 10
    (high, _top), (low, _bottom) = dead_centres()
    with mpmath.workdps(40):
        angles = [high + k * (low - high) / n_pieces for k in range(n_pieces)]
        angles += [low + k * (2 * mpmath.pi + high - low) / n_pieces for k in range(n_pieces + 1)]
        pieces = []
        for start, end in itertools.pairwise(angles):
            law = taylor_law(start, end)
            begin, rise = slider_at(start), slider_at(end) - slider_at(start)
            pieces.append(Piece(*map(float, ((start - high) / omega, (end - start) / omega, begin, rise)), law))
    return from_pieces(tuple(pieces)), 2 * np.pi / omega


@pytest.mark.parametrize("law", LAWS)
def test_a_position_alone_is_that_of_the_whole_motion(law):
    """To the same bit, before and after the period too, and in a rest."""
    there, back = Piece(0.0, 0.7, 0.1, 0.3, LAWS[law]), Piece(1.2, 0.8, 0.4, -0.3, LAWS[law])
    time = np.linspace(-3, 5, 4001)
    wanted = from_pieces((there, Piece(0.7, 0.5, 0.4, 0.0, None), back))
    table = through_positions(np.array([0.0, 0.3, 1.1, 1.6]), np.array([0.1, 0.4, 0.2, 0.15]), 2.0)
    for one in (wanted, table):
        assert np.array_equal(position(one, time), moved(one, time).value)


def test_the_motion_of_constant_speed_gives_constant_speed():
    """Through the dead centres, and as near to them as angles can be told apart."""
    wanted, period = constant_speed()
    output = output_of(mechanisms_of(Mechanisms, machine(piece_motion(), SLIDER).places, 1), 0, 0)
    made = fitted(output, wanted._replace(period=period), WAY)
    near = np.array(
        [float(end[0]) + side * 10.0**-k for end in dead_centres() for k in range(1, 16) for side in (-1, 1)]
    )
    angle = np.concatenate([np.linspace(-7, 14, 5001), near, [float(end[0]) for end in dead_centres()]])
    crank = crank_by_angle(made, angle)
    np.testing.assert_allclose(crank.speed, 10.0, rtol=1e-9)
    np.testing.assert_allclose(crank.acceleration, 0.0, atol=1e-9 * 100)
    time = np.linspace(0, 3, 5001)
    by_time = crank_at(made, time)
    np.testing.assert_allclose(by_time.speed, 10.0, rtol=1e-9)
    np.testing.assert_allclose(by_time.angle, float(dead_centres()[0][0]) + 10 * time, atol=1e-9)


def piece_motion(stroke="100 mm", key="to"):
    return {
        "piece": [
            piece("0.6 s", stroke, key=key),
            piece("0.2 s"),
            piece("0.4 s", "0 mm" if key == "to" else "0 deg", key=key),
        ]
    }


def test_a_constant_crank_is_a_law():
    made = {"piece": [piece("1.1 s", "100 mm", "constant crank"), piece("1.1 s", "0 mm", "constant crank")]}
    curve = ct.run(machine(made)).get(SpeedCurve)
    drive = curve.drive(np.linspace(-7, 14, 4001))
    np.testing.assert_allclose(drive.speed, np.pi / 1.1, rtol=1e-12)
    np.testing.assert_allclose(drive.acceleration, 0.0, atol=1e-11)


def test_a_scotch_yoke_is_inverted_in_closed_form():
    """x = r cos φ: φ = arccos(1 − 2y), from one dead centre to the other by the 4-5-6-7 law."""
    made = followed(piece_motion())
    shares = np.array([1e-6, 1e-4, 0.01, 0.3, 0.5, 0.77, 0.999, 1 - 1e-6])
    crank = crank_at(made, shares * 0.6)
    with mpmath.workdps(50):

        def angle(time):
            s = time / mpmath.mpf("0.6")
            return mpmath.acos(1 - 2 * (35 * s**4 - 84 * s**5 + 70 * s**6 - 20 * s**7))

        times = [mpmath.mpf(float(share * 0.6)) for share in shares]
        expected = np.array([[float(mpmath.diff(angle, time, n)) for n in range(3)] for time in times]).T
    np.testing.assert_allclose(crank.angle, expected[0], rtol=1e-9, atol=1e-15)
    np.testing.assert_allclose(crank.speed, expected[1], rtol=1e-9)
    np.testing.assert_allclose(crank.acceleration, expected[2], rtol=1e-9, atol=1e-9 * np.max(np.abs(expected[2])))


@pytest.mark.parametrize("law", ["4-5-6-7", "5-6-7-8-9"])
def test_a_slider_crank_near_its_dead_centres(law):
    """Angle from the dead centre, speed and acceleration in 60 digits, at times down to 1e-7 of the way."""
    (high, top), (_low, bottom) = dead_centres()
    stroke = top - bottom
    text = f"{mpmath.nstr(stroke * 1000, 17)} mm"
    made = followed({"piece": [piece("0.6 s", text, law), piece("0.2 s"), piece("0.4 s", "0 mm", law)]}, SLIDER)
    series = [mpmath.mpf(c) for c in LAWS[law].start]
    span = mpmath.mpf("0.6")

    def leaving(time):
        s = time / span
        return top - stroke * sum(c * s**k for k, c in enumerate(series))

    for share in (1e-7, 1e-5, 1e-3, 0.02, 0.2, 0.5):
        time = 0.6 * share
        crank = crank_at(made, np.array([time]))
        with mpmath.workdps(60):
            exact = mpmath.mpf(time)
            away = mpmath.sqrt(2 * (top - leaving(exact)) / -mpmath.diff(slider_at, high, 2))
            angle, speed, acceleration = crank_in_digits(leaving, exact, high + min(away, mpmath.mpf(2)), slider_at)
            np.testing.assert_allclose(crank.angle[0] - float(high), float(angle - high), rtol=1e-9, atol=1e-16)
        assert crank.speed[0] == pytest.approx(float(speed), rel=1e-9)
        assert crank.acceleration[0] == pytest.approx(float(acceleration), rel=1e-8)


def test_what_comes_out_of_a_rest_like_t4_starts_with_a_finite_acceleration():
    """½x″φ² = h·35 (t/T)⁴, so that φ = √(70h/x″)(t/T)² and ε is twice its factor."""
    made = followed(piece_motion())
    start = crank_at(made, np.array([0.0]))
    assert start.speed[0] == 0
    assert start.acceleration[0] == pytest.approx(2 * np.sqrt(70 * 0.1 / 0.05) / 0.6**2, rel=1e-12)


def test_time_and_angle_are_inverse():
    made = followed(piece_motion(f"{float(dead_centres()[0][1] - dead_centres()[1][1]) * 1000!r} mm"), SLIDER)
    time = np.concatenate([np.linspace(1e-3, 0.599, 997), np.linspace(0.801, 1.199, 997)])
    crank = crank_at(made, time)
    back = crank_by_angle(made, crank.angle)
    np.testing.assert_allclose(back.time, time, rtol=1e-9)
    np.testing.assert_allclose(back.speed, crank.speed, rtol=1e-9, atol=1e-9)


def test_a_table_is_followed_to_its_spline():
    """400 points of constant speed: the spline's second derivative misses by h²/12·x⁗, and so does ω² by twice that."""
    times = np.arange(400) / 400
    positions = 50 - 50 * np.cos(2 * np.pi * times)
    motion = {
        "times": [f"{t!r} s" for t in times.tolist()],
        "positions": [f"{abs(p)!r} mm" for p in positions.tolist()],
        "period": "1 s",
    }
    curve = ct.run(machine(motion)).get(SpeedCurve)
    drive = curve.drive(np.linspace(0, 6.28, 3001))
    np.testing.assert_allclose(drive.speed, 2 * np.pi, rtol=(2 * np.pi / 400) ** 2 / 6)


def test_a_crank_rocker_swings_as_wanted():
    """At angles found from times the rocker is where it should be; dead positions by the stretched rod's triangle."""
    r, l, c, d = (mpmath.mpf(n) for n in (100, 360, 280, 400))
    with mpmath.workdps(40):
        out, back = (mpmath.acos((d**2 + c**2 - (l + s * r) ** 2) / (2 * d * c)) for s in (1, -1))
        swing = float(out - back)
        turned = [mpmath.acos((d**2 + e**2 - c**2) / (2 * d * e)) for e in (l + r, l - r)]
        travel = float(mpmath.pi + turned[1] - turned[0])
    text = f"{float(np.degrees(swing))!r} deg"
    made = followed(piece_motion(text, key="swing"), ROCKER)
    assert made.output.stroke == pytest.approx(swing, rel=1e-13)
    way = np.mod(made.output.low.angle - made.output.high.angle, 2 * np.pi)
    assert min(abs(way - travel), abs(2 * np.pi - way - travel)) < 1e-12
    time = np.linspace(0.01, 1.19, 400)
    crank = crank_at(made, time)
    np.testing.assert_allclose(made.output.motion(crank.angle).value, moved(made.wanted, time).value, atol=1e-13)
    moving = (time < 0.59) | (time > 0.81)
    differences = [crank_at(made, time[moving] + step).angle for step in (-2e-5, -1e-5, 1e-5, 2e-5)]
    slope = (differences[0] - 8 * differences[1] + 8 * differences[2] - differences[3]) / 12e-5
    np.testing.assert_allclose(crank.speed[moving], slope, rtol=1e-8, atol=1e-8)


def test_a_rest_has_an_angle_and_a_time():
    made = followed(piece_motion())
    ((angle, duration),) = made.dwells
    assert (angle, duration) == (pytest.approx(np.pi, abs=1e-12), pytest.approx(0.2))
    result = ct.run(machine(piece_motion()))
    assert result.mean_piston_speed[0] == pytest.approx(2 * 0.1 / 1.2, rel=1e-12)
    resting = crank_at(made, np.array([0.65, 0.75]))
    np.testing.assert_array_equal(resting.speed, 0)
    np.testing.assert_allclose(resting.angle, np.pi, atol=1e-12)


def test_all_is_computed_at_the_wanted_motion():
    """A scotch yoke's slider alone: the force on it is its mass times the wish's second derivative."""
    result = ct.run(machine(piece_motion(), masses={"piston": {"mass": "3 kg"}}))
    made = followed(piece_motion())
    time = crank_by_angle(made, np.radians(result.crank_angle)).time
    wish = moved(made.wanted, time)
    inside = (np.radians(result.crank_angle) > 0.01) & (np.abs(np.radians(result.crank_angle) - np.pi) > 0.01)
    np.testing.assert_allclose(result.piston_velocity[0][inside], -wish.first[inside], atol=1e-12)
    np.testing.assert_allclose(result.piston_acceleration[0][inside], -wish.second[inside], atol=1e-10)


def test_a_rocking_crank_swings_between_two_angles():
    """x = r cos φ between 30 and 60 mm from its far end: φ = arccos(1 − p/r), and ω changes its sign."""
    motion = {"mode": "rocking", "piece": [piece("0.5 s", "60 mm", "3-4-5"), piece("0.5 s", "30 mm", "3-4-5")]}
    (made,) = parts_of([machine(motion)], step=np.radians(1))[RockingMotions].each
    time = np.linspace(0, 1, 301)
    crank = rocking_crank(made, time)
    s = np.where(time < 0.5, time, 1 - time) / 0.5
    place = 0.03 + 0.03 * (10 * s**3 - 15 * s**4 + 6 * s**5)
    np.testing.assert_allclose(crank.angle, np.arccos(1 - place / 0.05), atol=1e-12)
    velocity = np.where(time < 0.5, 1, -1) * 0.03 * (30 * s**2 - 60 * s**3 + 30 * s**4) / 0.5
    np.testing.assert_allclose(crank.speed, velocity / (0.05 * np.sin(crank.angle)), atol=1e-11)
    assert np.min(crank.speed) < 0 < np.max(crank.speed)


REFUSED = {
    "no period": ({"piece": [piece("0 s", "100 mm")]}, "piece[0].duration", NOT_POSITIVE),
    "short": ({"piece": [piece("1 s", "90 mm"), piece("1 s", "0 mm")]}, "", "times 1.11111 plus 0.00 mm"),
    "beyond": ({"piece": [piece("1 s", "130 mm"), piece("1 s", "0 mm")]}, "", "must turn round at both ends"),
    "3-4-5": (
        {"piece": [piece("1 s", "100 mm", "3-4-5"), piece("1 s", "0 mm", "3-4-5")]},
        "piece[0].law",
        'the nearest law: "4-5-6-7"',
    ),
    "out of a rest": (
        {"piece": [piece("1 s", "100 mm", "harmonic"), piece("1 s"), piece("1 s", "0 mm", "harmonic")]},
        "piece[0].law",
        "infinite acceleration",
    ),
    "two speeds": (
        {"piece": [piece("1 s", "100 mm", "harmonic"), piece("2 s", "0 mm", "harmonic")]},
        "piece[0].law",
        "from 15.0 rpm to 30.0 rpm",
    ),
    "jump": (
        {"piece": [piece("1 s", "60 mm"), piece("1 s", "100 mm", "constant velocity"), piece("1 s", "0 mm")]},
        "piece[1].law",
        "must begin with the velocity",
    ),
    "times": (
        {"times": ["0 s", "1 s", "1 s", "2 s"], "positions": ["0 mm", "50 mm", "100 mm", "50 mm"], "period": "3 s"},
        "times[2]",
        "must be more than the time before",
    ),
    "period": (
        {"times": ["0 s", "1 s", "2 s", "3 s"], "positions": ["0 mm", "50 mm", "100 mm", "50 mm"], "period": "3 s"},
        "period",
        "from the first time to the last one",
    ),
    "lists": (
        {
            "times": ["0 s", "1 s", "2 s", "3 s"],
            "positions": ["0 mm", "50 mm", "100 mm", "50 mm", "0 mm"],
            "period": "4 s",
        },
        "positions",
        "as many as the times",
    ),
    "not the output": ({"of": "rod", "piece": [piece("1 s", "100 mm"), piece("1 s", "0 mm")]}, "of", "piston"),
    "a rocker's": ({"piece": [piece("1 s", "100 deg", key="swing")]}, "piece[0].swing", "a slider has lengths"),
    "nothing": ({}, "piece", "is missing"),
    "twice": (
        {"piece": [piece("1 s", to) for to in ("100 mm", "50 mm", "60 mm", "0 mm")]},
        "",
        'mode = "rocking"',
    ),
    "rocking out": (
        {"mode": "rocking", "piece": [piece("1 s", "100 mm"), piece("1 s", "50 mm")]},
        "",
        "must stay within the stroke",
    ),
    "half a stroke": (
        {"piece": [piece("1 s", "60 mm", "constant crank"), piece("1 s", "0 mm")]},
        "piece[0].law",
        "from one end of the stroke",
    ),
}


@pytest.mark.parametrize(("motion", "path", "said"), REFUSED.values(), ids=REFUSED)
def test_what_cannot_be_is_refused_at_its_place(motion, path, said):
    with pytest.raises(ct.InputError) as caught:
        ct.run(machine(motion))
    found = {problem.path: str(problem) for problem in caught.value.problems}
    where = "shaft.main.motion" + (f".{path}" if path else "")
    assert where in found, found
    assert said in found[where]


def test_a_speed_beside_it_is_refused():
    with pytest.raises(ct.InputError, match=NO_REST):
        ct.Machine(mechanism=YOKE, shaft={"main": {"speed": "60 rpm", "motion": piece_motion()}})


@pytest.mark.parametrize("digits", [4, 6, 9, 12])
@pytest.mark.parametrize("n", [13, 14])
def test_a_table_may_turn_round_next_to_its_points(digits, n):
    """A yoke that turns evenly, at n times and positions of so many digits: the turning points are moved by rounding.

    A periodic cubic spline through a cosine misses its slope by 2 % at most here; at a dead centre, where the
    distance from it is nothing but rounding, no more.
    """
    places = range(n)
    motion = {
        "times": [f"{float(f'{i / n:.{digits}g}')!r} s" for i in places],
        "positions": [f"{float(f'{50 * (1 - np.cos(2 * np.pi * i / n)):.{digits}g}')!r} mm" for i in places],
        "period": "1 s",
    }
    made = followed(motion)
    for end in made.strokes[0]:
        beside = np.concatenate([[0.0], 10.0 ** -np.arange(2, 13)])
        for crank in (crank_at(made, end.time + beside), crank_at(made, end.time - beside)):
            np.testing.assert_allclose(crank.speed, 2 * np.pi, rtol=0.02)
            assert np.all(np.isfinite(crank.angle)) and np.all(np.isfinite(crank.acceleration))
        for crank in (crank_by_angle(made, end.angle + beside), crank_by_angle(made, end.angle - beside)):
            np.testing.assert_allclose(crank.speed, 2 * np.pi, rtol=0.02)
            assert np.all(np.isfinite(crank.time))
