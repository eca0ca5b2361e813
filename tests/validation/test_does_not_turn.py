"""Mechanisms that do not turn all round: how far cranks, links and points go, and what blocks them."""

import tomllib

import numpy as np
import pytest

import cranktrain as ct

SIX_LINKS = """
rotation = "anticlockwise"
[shaft.main]
speed = "10 rpm"
[mechanism]
kind = "chain"
output = "FE"
[mechanism.fixed]
G = ["110.6 mm", "-11 mm"]
[mechanism.crank.main]
radius = "34.731541860389674 mm"
[[mechanism.part]]
type = "pin"
rod = { name = "CBD", from = "main.pin", length = "43.26707755326214 mm" }
rocker = { name = "CFG", from = "G", length = "69.62126112043648 mm" }
joint = "C"
side = "left"
[[mechanism.part]]
type = "point"
name = "D"
link = "CBD"
along = "21.207810924378405 mm"
across = "33.55992782763122 mm"
[[mechanism.part]]
type = "point"
name = "F"
link = "CFG"
along = "32.061470362316893 mm"
across = "-61.198546700115966 mm"
[[mechanism.part]]
type = "pin"
rod = { name = "DE", from = "D", length = "54.76531749200401 mm" }
rocker = { name = "FE", from = "F", length = "36.338959808998386 mm" }
joint = "E"
side = "left"
"""


def machine_of(text):
    return ct.Machine(**tomllib.loads(text))


@pytest.fixture(scope="module")
def six_links():
    return ct.run(machine_of(SIX_LINKS), partial=True)


def joined(one, other, first, second, side):
    """Where two circles meet, on the left of the way from one centre to the other, or right."""
    way = other - one
    distance = np.abs(way)
    along = (first**2 - second**2 + distance**2) / (2 * distance)
    return one + way / distance * (along + side * 1j * np.sqrt(first**2 - along**2))


def by_circles(phi):
    """Points C, D, F and E of the six links by circles, as complex numbers. [mm]"""
    pin, pivot = 34.731541860389674 * np.exp(1j * phi), 110.6 - 11j
    c = joined(pin, pivot, 43.26707755326214, 69.62126112043648, 1)
    on_rod, on_rocker = (c - pin) / 43.26707755326214, (c - pivot) / 69.62126112043648
    d = pin + on_rod * (21.207810924378405 + 33.55992782763122j)
    f = pivot + on_rocker * (32.061470362316893 - 61.198546700115966j)
    return c, d, f, joined(d, f, 54.76531749200401, 36.338959808998386, 1)


def test_what_a_user_reported(six_links):
    """The whole closes from 67.28 to 78.25° and from 270.39 to 281.36°, E blocks on one side and C on the other."""
    np.testing.assert_allclose(six_links.crank_range_start, [[67.28, 270.39]], atol=0.005)
    np.testing.assert_allclose(six_links.crank_range_end, [[78.25, 281.36]], atol=0.005)
    told = [str(line.words) for _title, lines in six_links.rows() for line in lines if str(line.name) == "blocked by"]
    assert told == ["E before, C behind; C before, E behind"]


def test_edges_are_where_circles_touch(six_links):
    """At the edge that C makes crank pin, C and pivot lie in one line: by the cosine rule, to rounding."""
    crank, ground = 34.731541860389674, np.hypot(110.6, 11)
    reach = 43.26707755326214 + 69.62126112043648
    angle = np.arccos((crank**2 + ground**2 - reach**2) / (2 * crank * ground))
    ahead = np.arctan2(-11, 110.6)
    assert np.radians(six_links.crank_range_end[0, 0]) == pytest.approx(ahead + angle, abs=1e-12)
    assert np.radians(six_links.crank_range_start[0, 1]) == pytest.approx(2 * np.pi + ahead - angle, abs=1e-12)


@pytest.mark.parametrize("number", [0, 1])
def test_extents_of_points_by_circles(six_links, number):
    """Over a range, closer and closer to its edges; a coordinate goes there like the square root of what is left."""
    start, end = (np.radians(part[0, number]) for part in (six_links.crank_range_start, six_links.crank_range_end))
    phi = start + (end - start) * (1 - np.cos(np.linspace(1e-6, np.pi - 1e-6, 200001))) / 2
    names = six_links.labels["point"]
    for name, path in zip("CDFE", by_circles(phi), strict=True):
        place = names.index(f"1.{name}")
        for axis, values in (("x", path.real), ("y", path.imag)):
            for end_of, found in (("from", np.min(values)), ("to", np.max(values))):
                told = 1e3 * getattr(six_links, f"point_{axis}_{end_of}")[place, number]
                assert told == pytest.approx(found, abs=2e-5)


def test_a_rod_that_is_shorter_than_its_crank():
    """R 50, L 40 mm: sin φ up to 0.8 either way, where the rod stands across the line of stroke."""
    mechanism = {"kind": "slider_crank", "crank_radius": "50 mm", "rod_length": "40 mm"}
    result = ct.run(ct.Machine(mechanism=mechanism), partial=True)
    edge = np.degrees(np.arcsin(0.8))
    np.testing.assert_allclose(result.crank_range_start, [[180 - edge, 360 - edge]], rtol=1e-13)
    np.testing.assert_allclose(result.crank_range_end, [[180 + edge, edge]], rtol=1e-13)
    np.testing.assert_allclose(result.link_angle_from, -np.pi / 2, rtol=1e-9)
    np.testing.assert_allclose(result.link_angle_to, np.pi / 2, rtol=1e-9)


def test_without_partial_it_is_said_where_all_links_close():
    with pytest.raises(ct.InputError) as caught:
        ct.run(machine_of(SIX_LINKS))
    told = [(problem.path, str(problem.allowed), str(problem.repair)) for problem in caught.value.problems]
    assert [path for path, _allowed, _repair in told] == ["mechanism.part[0]", "mechanism.part[3]"]
    assert "78.25 deg to 270.39 deg" in told[0][1]
    assert "281.36 deg to 67.28 deg" in told[1][1]
    assert all("67.28 deg to 78.25 deg" in repair and "--partial" in repair for _path, _allowed, repair in told)


def test_ranges_are_those_of_each_design():
    lengths = ["40 mm", "45 mm"]
    machines = [
        ct.Machine(mechanism={"kind": "slider_crank", "crank_radius": "50 mm", "rod_length": length})
        for length in lengths
    ]
    both = ct.run(machines, partial=True)
    for design, machine in enumerate(machines):
        alone = ct.run(machine, partial=True)
        for name in ("crank_range_start", "crank_range_end", "link_angle_from", "link_angle_to"):
            np.testing.assert_array_equal(getattr(both, name)[design], getattr(alone, name))


def test_what_turns_all_round_has_none():
    mechanism = {"kind": "slider_crank", "crank_radius": "50 mm", "rod_length": "140 mm"}
    assert "crank_range_start" not in ct.run(ct.Machine(mechanism=mechanism), partial=True).catalogue


@pytest.mark.parametrize("offset", ["0 mm", "300 mm"])
def test_no_line_of_the_answer_is_empty(offset):
    """Of one part nothing blocks but itself; of links that close nowhere nothing goes anywhere."""
    mechanism = {"kind": "slider_crank", "crank_radius": "50 mm", "rod_length": "40 mm", "offset": offset}
    lines = [line for _title, each in ct.run(ct.Machine(mechanism=mechanism), partial=True).rows() for line in each]
    assert all(line.values.size or str(line.words).strip() for line in lines)
    assert sum(str(line.name) == "crank goes" for line in lines) == 1
