"""Closing margins: closed forms of slider-crank and crank-rocker, brute force for the articulated rod."""

from dataclasses import replace

import numpy as np
import pytest
from tests.exact import geometries
from tests.machines import ROCKER, slider

import cranktrain as ct
from cranktrain.mechanisms import articulated_rod, closing, crank_rocker, eccentric, slider_crank
from cranktrain.mechanisms.articulated_rod import ArticulatedRod
from cranktrain.mechanisms.closing import closing_all_round, closing_margin, open_ranges
from cranktrain.mechanisms.crank_rocker import CrankRocker
from cranktrain.mechanisms.eccentric import Eccentric
from cranktrain.mechanisms.slider_crank import SliderCrank


def in_designs(geometry, n_designs):
    """The same mechanisms with a design axis: shape (design, member, 1)."""
    parts = [
        in_designs(part, n_designs) if isinstance(part, tuple) else part.reshape(n_designs, -1, 1) for part in geometry
    ]
    return type(geometry)(*parts)


def farthest_knuckle(geometry, alpha):
    """Largest distance of the knuckle from the slave's line of stroke, refined by parabolas on a fine grid."""
    distance = np.abs(geometries.knuckle_distance(alpha, geometry)[0])
    top = np.argmax(distance)
    left, middle, right = distance[top - 1], distance[top], distance[(top + 1) % len(alpha)]
    return middle + (right - left) ** 2 / (16 * middle - 8 * (left + right)) if np.isfinite(left + right) else middle


def brute_force_margin(geometry):
    """Bisection for every length, both ways, on a fine grid; the master's own condition in closed form."""
    alpha = np.linspace(-np.pi, np.pi, 7200, endpoint=False)

    def opens(changed):
        master_gap = changed.master.rod_length - changed.master.crank_radius - abs(changed.master.offset)
        if master_gap[0, 0] < 0:
            return True
        return farthest_knuckle(changed, alpha) > changed.rod_length[0, 0]

    margins = []
    for length in ("crank_radius", "rod_length", "offset", "knuckle_radius", "slave_rod_length", "slave_offset"):
        for sign in (-1, 1):

            def changed(change, length=length, sign=sign):
                return scaled(geometry, length, 1 + sign * change)

            if not opens(changed(0.999)):
                continue
            low, high = 0.0, 0.999
            for _ in range(40):
                middle = (low + high) / 2
                low, high = (low, middle) if opens(changed(middle)) else (middle, high)
            margins.append((high, length))
    return min(margins)


def scaled(geometry, length, factor):
    if length in SliderCrank._fields and length != "slave_rod_length":
        return geometry._replace(master=geometry.master._replace(**{length: getattr(geometry.master, length) * factor}))
    name = length.removeprefix("slave_")
    return geometry._replace(**{name: getattr(geometry, name) * factor})


@pytest.mark.parametrize("n_designs", [1, 5])
def test_slider_crank(n_designs):
    machines = geometries.slider_cranks(100, seed=5)
    found = closing_margin(slider_crank.KIND, in_designs(machines.geometry, n_designs))
    assert found.margin.shape == (n_designs, 100 // n_designs, 1)
    np.testing.assert_allclose(found.margin.reshape(-1, 1), machines.margin, rtol=0, atol=1e-12)
    assert set(found.length.ravel().tolist()) == {slider_crank.KIND.lengths.index("rod_length")}
    central = machines.geometry.offset == 0
    away = np.abs(np.mod(found.angle.reshape(-1, 1) - machines.opening_angle + np.pi, 2 * np.pi) - np.pi)
    assert np.max(np.where(central, np.minimum(away, np.pi - away), away)) < 1e-7


@pytest.mark.parametrize("n_designs", [1, 4])
def test_crank_rocker(n_designs):
    machines = geometries.crank_rockers(100, seed=6)
    found = closing_margin(crank_rocker.KIND, in_designs(machines.geometry, n_designs))
    np.testing.assert_allclose(found.margin.reshape(-1, 1), machines.margin, rtol=0, atol=1e-12)
    longest = np.argmax(np.concatenate(machines.geometry[:4], axis=1), axis=1)
    assert found.length.ravel().tolist() == longest.tolist()


def test_closed_forms_are_what_a_search_by_the_definition_finds():
    sliders = geometries.slider_cranks(60, seed=8).geometry
    ahead = np.random.default_rng(8).uniform(-3, 3, sliders.offset.shape)
    for kind, geometry in (
        (slider_crank.KIND, sliders),
        (eccentric.KIND, Eccentric(*sliders, ahead)),
        (crank_rocker.KIND, geometries.crank_rockers(60, seed=9).geometry),
    ):
        found = closing_margin(kind, geometry)
        searched = closing_margin(replace(kind, least_gap=None), geometry)
        np.testing.assert_allclose(found.margin, searched.margin, rtol=0, atol=1e-12)
        np.testing.assert_array_equal(found.length, searched.length)
        away = np.abs(np.mod(found.angle - searched.angle + np.pi, 2 * np.pi) - np.pi)
        opens_twice = getattr(geometry, "offset", 1.0) == 0
        assert np.max(np.where(opens_twice, np.minimum(away, np.pi - away), away)) < 1e-7


def test_articulated_rod():
    machines = geometries.articulated_rods(24, seed=7)
    found = closing_margin(articulated_rod.KIND, machines.geometry)
    assert found.margin.shape == (24, 1)
    for row in range(24):
        master = SliderCrank(*(part[[row]] for part in machines.geometry.master))
        geometry = ArticulatedRod(master, *(part[[row]] for part in machines.geometry[1:]))
        margin, length = brute_force_margin(geometry)
        assert found.margin[row, 0] == pytest.approx(margin, abs=3e-9), (row, length)


def test_slave_rod_shortened_until_it_only_just_reaches():
    """Of the V12 the margin is (l − max|Q|)/l; the largest |Q| from the closed form on a fine grid."""
    geometry = ArticulatedRod(SliderCrank(0.09, 0.32, 0.0), 0.085, np.radians(67), np.radians(60), 0.235, 0.0)
    columns = in_designs(
        ArticulatedRod(SliderCrank(*np.reshape(geometry[0], (3, 1))), *np.reshape(geometry[1:], (5, 1))), 1
    )
    alpha = np.linspace(0, 2 * np.pi, 1_000_001)
    reach = np.max(geometries.knuckle_distance(alpha, geometry))
    found = closing_margin(articulated_rod.KIND, columns)
    assert found.margin[0, 0, 0] == pytest.approx(1 - reach / 0.235, rel=1e-10)
    assert articulated_rod.KIND.lengths[found.length[0, 0, 0]] == "rod_length"


def test_links_that_cannot_close_have_no_margin():
    columns = SliderCrank(*(np.array(part).reshape(2, 1) for part in ([50.0, 50.0], [40.0, 100.0], [0.0, 0.0])))
    found = closing_margin(slider_crank.KIND, columns)
    np.testing.assert_array_equal(found.margin[:, 0], [np.nan, 0.5])
    assert found.length[:, 0].tolist() == [-1, 1]
    assert np.isnan(found.angle[0, 0])


def test_open_ranges_of_a_short_rod():
    """R sin φ beyond L on both sides: from asin(L/R) to its supplement, and half a turn on."""
    ranges = open_ranges(slider_crank.KIND, SliderCrank(0.05, 0.04, 0.0))
    edge = np.arcsin(0.8)
    for found, start in zip(ranges, (edge, np.pi + edge), strict=True):
        assert (found.start, found.end) == pytest.approx((start, start + np.pi - 2 * edge), abs=1e-13)
        assert found.short == pytest.approx(0.01)


def test_open_range_across_zero():
    """A crank-rocker whose rod is longer than all the rest together cannot close where the pins are near."""
    (found,) = open_ranges(crank_rocker.KIND, CrankRocker(0.1, 0.5, 0.15, 0.4, 1.0))
    edge = np.arccos((0.1**2 + 0.4**2 - 0.35**2) / (2 * 0.1 * 0.4))
    assert (found.start, found.end) == pytest.approx((2 * np.pi - edge, 2 * np.pi + edge), abs=1e-13)
    assert found.short == pytest.approx(0.05)


def test_never_closing():
    (found,) = open_ranges(slider_crank.KIND, SliderCrank(0.05, 0.04, 0.2))
    assert found.end - found.start == 2 * np.pi


def test_closing_all_round():
    assert open_ranges(slider_crank.KIND, SliderCrank(0.05, 0.050001, 0.0)) == ()


def problem_of(**machine):
    with pytest.raises(ct.InputError) as caught:
        ct.run(ct.Machine(**machine))
    (problem,) = caught.value.problems
    return problem


def test_change_point_is_refused():
    problem = problem_of(mechanism=slider(rod_length="50 mm"))
    assert str(problem.allowed) == (
        "the links lie in one line at crank angle 90.00 deg and 270.00 deg, and nothing says which way they go on; "
        "rod_length must be more than crank_radius + |offset| = 50 mm"
    )
    problem = problem_of(mechanism=ROCKER | {"rod_length": "220 mm"})
    assert "in one line at crank angle 180.00 deg" in str(problem.allowed)


@pytest.mark.parametrize("rod", ["300 mm", "250 mm"])
def test_a_kite_that_comes_back_after_two_turns_is_refused_for_that(rod):
    """Crank and ground alike: with the pin on the pivot rod and rocker must be alike, and turn half as fast as it."""
    kite = {"crank_radius": "100 mm", "ground_length": "100 mm", "rocker_length": "300 mm", "rod_length": rod}
    problem = problem_of(mechanism={"kind": "crank_rocker"} | kite)
    allowed = str(problem.allowed)
    assert "the crank turns all round only where rod_length = rocker_length" in allowed
    assert "come back after two turns of it" in allowed
    assert "cannot pass" not in allowed
    assert "at crank angle 0.00 deg" in allowed or "(short by 50.00 mm)" in allowed


def test_crank_angles_of_a_problem_are_those_shown():
    problem = problem_of(mechanism=slider(rod_length="40 mm", offset="-5 mm"), crank_zero="20 deg")
    low, high = np.degrees(np.arcsin((0.04 - 0.005) / 0.05)), np.degrees(np.arcsin((0.04 + 0.005) / 0.05))
    assert f"{low - 20:.2f} deg to {180 - low - 20:.2f} deg" in str(problem.allowed)
    assert f"{180 + high - 20:.2f} deg to {360 - high - 20:.2f} deg" in str(problem.allowed)
    assert "short by 15.00 mm" in str(problem.allowed)


def test_astern_the_angles_are_mirrored():
    ahead = problem_of(mechanism=slider(rod_length="52 mm", offset="5 mm"))
    astern = problem_of(mechanism=slider(rod_length="52 mm", offset="5 mm"), running="astern")
    assert "250.05 deg to 289.95 deg (short by 3.00 mm)" in str(ahead.allowed)  # sin φ below −(L − e)/R
    assert "70.05 deg to 109.95 deg (short by 3.00 mm)" in str(astern.allowed)


@pytest.mark.parametrize(
    ("mechanism", "path", "given"),
    [
        (slider(rod_length="4 cm"), "mechanism.rod_length", "4 cm"),
        (
            {"kind": "slider_crank", "crank_radius": "5 cm", "rod_to_crank_ratio": 0.9},
            "mechanism.rod_to_crank_ratio",
            "0.9",
        ),
        ({"kind": "slider_crank", "stroke": "5 cm", "crank_to_rod_ratio": 1.5}, "mechanism.crank_to_rod_ratio", "1.5"),
    ],
)
def test_problem_stands_where_the_rod_is_given(mechanism, path, given):
    problem = problem_of(mechanism=mechanism)
    assert (problem.path, problem.given) == (path, given)


SIX_LINKS = {
    "kind": "chain",
    "output": "FE",
    "fixed": {"G": ["110.6 mm", "-11 mm"]},
    "crank": {"main": {"radius": "34.731541860389674 mm"}},
    "part": [
        {
            "type": "pin",
            "rod": {"name": "CBD", "from": "main.pin", "length": "43.26707755326214 mm"},
            "rocker": {"name": "CFG", "from": "G", "length": "69.62126112043648 mm"},
            "joint": "C",
            "side": "left",
        },
        {"type": "point", "name": "D", "link": "CBD", "along": "21.2078109244 mm", "across": "33.5599278276 mm"},
        {"type": "point", "name": "F", "link": "CFG", "along": "32.0614703623 mm", "across": "-61.1985467001 mm"},
        {
            "type": "pin",
            "rod": {"name": "DE", "from": "D", "length": "54.76531749200401 mm"},
            "rocker": {"name": "FE", "from": "F", "length": "36.338959808998386 mm"},
            "joint": "E",
            "side": "left",
        },
    ],
}


def by_hand(degrees):
    """Whether the dyads C and E of the six links close, by circles that meet; E's None where C has no place."""
    pin, ground = 34.731541860389674 * np.exp(1j * np.radians(degrees)), 110.6 - 11j
    apart = abs(ground - pin)
    rod, rocker = 43.26707755326214, 69.62126112043648
    if not abs(rod - rocker) < apart < rod + rocker:
        return False, None
    turn = np.arccos((rod**2 + apart**2 - rocker**2) / (2 * rod * apart))
    joint = pin + rod * np.exp(1j * (np.angle(ground - pin) + turn))
    along, lever = (joint - pin) / rod, (joint - ground) / rocker
    between = abs(ground + lever * (32.0614703623 - 61.1985467001j) - pin - along * (21.2078109244 + 33.5599278276j))
    return True, abs(54.76531749200401 - 36.338959808998386) < between < 54.76531749200401 + 36.338959808998386


def test_every_part_of_a_chain_has_its_own_angles():
    """Each is told where it cannot close itself; where one that it hangs on cannot, it is not to blame."""
    found = ct.Machine(name="six", shaft={"main": {"speed": "10 rpm"}}, mechanism=SIX_LINKS, rotation="anticlockwise")
    first, second = found.closing_problems
    assert (first.path, second.path) == ("mechanism.part[0]", "mechanism.part[3]")
    assert "78.25 deg to 270.39 deg (short" in str(first.allowed)
    assert "281.36 deg to 67.28 deg (short" in str(second.allowed)
    assert "makes C, CBD, CFG" in str(first.allowed)
    assert "makes E, DE, FE" in str(second.allowed)
    for inside, closes in ((73.0, (True, True)), (276.0, (True, True)), (180.0, (False, None)), (0.0, (True, False))):
        assert by_hand(inside) == closes
    for edge, part in ((78.25, 0), (270.39, 0), (281.36, 1), (67.28, 1)):
        assert bool(by_hand(edge - 0.02)[part]) != bool(by_hand(edge + 0.02)[part])


def test_only_the_least_change_is_followed(monkeypatch):
    """Three lengths of the shaper open it within one step of the scan; one look at the others there is enough."""
    looks = []
    least = closing._least_gap
    monkeypatch.setattr(closing, "_least_gap", lambda *given: looks.append(1) or least(*given))
    found = ct.run("shaper", quantities="closing_margin")
    # The lever, 500 mm up from 250 mm below the shaft: of 780 mm its end is a rod's 300 mm above the guide at 230 mm.
    assert float(np.ravel(found.closing_margin)[0]) == pytest.approx(0.56, rel=1e-12)
    assert len(looks) <= 6


def test_many_slider_cranks_close_by_the_closed_form():
    """L > R + |e|; those within some roundings of it are unclear, and none else."""
    random = np.random.default_rng(3)
    radius, offset, excess = random.uniform((0.01, -0.1, -0.1), (0.2, 0.1, 0.1), (5000, 3)).T
    excess[::50] *= 1e-9
    excess[::100] = 0.0
    rod = np.abs(radius + np.abs(offset) + excess)
    found = closing_all_round(slider_crank.KIND, SliderCrank(*(one[:, np.newaxis] for one in (radius, rod, offset))))
    by_form = rod - radius - np.abs(offset)
    assert np.all((found.closes == (by_form > 0))[~found.is_unclear])
    assert np.all(np.abs(by_form[found.is_unclear]) < 2e-9)
    assert np.all(found.is_unclear[::100])
    assert np.count_nonzero(found.is_unclear) <= 100


def four_bars(random):
    """Crank-rockers of which some close."""
    lengths = random.uniform((0.02, 0.1, 0.1, 0.1), (0.1, 0.5, 0.5, 0.5), (400, 4)).T
    return CrankRocker(*lengths[..., np.newaxis], side=np.ones((400, 1)))


def slaves(random):
    """Articulated rods of which some close: master, knuckle, its angle and the bank's, the slave."""
    least = (0.03, 0.05, -0.02, 0.02, 0.5, 0.5, 0.02, -0.02)
    most = (0.06, 0.25, 0.02, 0.08, 1.5, 1.5, 0.25, 0.02)
    numbers = random.uniform(least, most, (400, 8)).T[..., np.newaxis]
    return ArticulatedRod(SliderCrank(*numbers[:3]), *numbers[3:])


def row_of(geometry, row):
    """One of many mechanisms, of plain numbers."""
    parts = [row_of(part, row) if isinstance(part, tuple) else float(part[row, 0]) for part in geometry]
    return type(geometry)(*parts)


@pytest.mark.parametrize(("kind", "many"), [(crank_rocker.KIND, four_bars), (articulated_rod.KIND, slaves)])
def test_many_mechanisms_close_as_each_does(kind, many):
    """What has no range where it is open closes."""
    geometry = many(np.random.default_rng(4))
    found = closing_all_round(kind, geometry)
    closes = [not open_ranges(kind, row_of(geometry, row)) for row in range(400)]
    assert not np.any(found.is_unclear)
    assert found.closes.tolist() == closes
    assert 20 < sum(closes) < 380
