"""Tables of mechanisms: the forms in which a slider-crank's sizes can be given, and what is refused."""

import numpy as np
import pytest
from tests.machines import ROCKER, slave, slider

import cranktrain as ct


def geometry(**table):
    (place,) = ct.Machine(mechanism={"kind": "slider_crank", **table}).places
    return place.geometry


def true_stroke(found):
    """√((L + R)² − e²) − √((L − R)² − e²)."""
    far, near, e = found.rod_length + found.crank_radius, found.rod_length - found.crank_radius, found.offset
    return np.sqrt(far**2 - e**2) - np.sqrt(near**2 - e**2)


@pytest.mark.parametrize("offset", ["0 mm", "1 mm", "-30 mm", "55 mm"])
@pytest.mark.parametrize(
    "rod",
    [{"rod_length": "200 mm"}, {"crank_to_rod_ratio": 0.25}, {"rod_to_crank_ratio": 4}, {"rod_to_crank_ratio": 3.1}],
)
def test_stroke_is_the_true_one(offset, rod):
    found = geometry(stroke="100 mm", offset=offset, **rod)
    assert true_stroke(found) == pytest.approx(0.1, rel=1e-13)
    ratio = rod.get("rod_to_crank_ratio") or 1 / rod.get("crank_to_rod_ratio", np.nan)
    expected = 0.2 if "rod_length" in rod else ratio * found.crank_radius
    assert found.rod_length == pytest.approx(expected, rel=1e-14)
    assert found.rod_length > found.crank_radius + abs(found.offset)


def test_forms_agree():
    assert geometry(crank_radius="50 mm", rod_length="200 mm") == geometry(stroke="100 mm", crank_to_rod_ratio=0.25)
    assert geometry(crank_radius="5 cm", rod_to_crank_ratio=4) == geometry(stroke="0.1 m", rod_length="200 mm")


@pytest.mark.parametrize(
    ("table", "path", "said"),
    [
        ({"rod_length": "1 m"}, "mechanism.crank_radius", "give one of crank_radius, stroke"),
        ({"stroke": "1 m"}, "mechanism.rod_length", "give one of rod_length, crank_to_rod_ratio, rod_to_crank_ratio"),
        (
            {"stroke": "1 m", "crank_radius": "1 m", "rod_length": "4 m"},
            "mechanism.stroke",
            "not stand beside crank_radius",
        ),
        (
            {"stroke": "1 m", "rod_length": "4 m", "rod_to_crank_ratio": 4},
            "mechanism.rod_to_crank_ratio",
            "not stand beside rod_length",
        ),
        (
            {"stroke": "41 cm", "rod_length": "20 cm", "offset": "1 mm"},
            "mechanism.stroke",
            "2√(L(L − |e|)) = 398.9987 mm",
        ),
        (
            {"stroke": "10 cm", "crank_to_rod_ratio": 0.9, "offset": "9 cm"},
            "mechanism.stroke",
            "the stroke must be longer",
        ),
        ({"stroke": "0 mm", "rod_length": "1 m"}, "mechanism.stroke", "more than 0"),
        ({"stroke": "1 m", "crank_to_rod_ratio": -0.3}, "mechanism.crank_to_rod_ratio", "more than 0"),
    ],
)
def test_refused(table, path, said):
    with pytest.raises(ct.InputError) as caught:
        geometry(**table)
    (problem,) = caught.value.problems
    assert problem.path == path
    assert said in str(problem.allowed)


def test_longest_stroke_that_a_rod_and_offset_allow():
    """2√(L(L − |e|)) = 2√(0.2 · 0.15). Beyond it (2.9) still has a root, of another machine with a shorter stroke."""
    longest = float(2 * np.sqrt(0.2 * 0.15))
    found = geometry(stroke=f"{longest - 1e-6!r} m", rod_length="0.2 m", offset="5 cm")
    assert true_stroke(found) == pytest.approx(longest - 1e-6, rel=1e-9)
    with pytest.raises(ct.InputError, match="at most 2√"):
        geometry(stroke=f"{longest + 1e-6!r} m", rod_length="0.2 m", offset="5 cm")


def advice(**machine):
    with pytest.raises(ct.InputError) as caught:
        ct.run(ct.Machine(**machine))
    return str(caught.value.problems[-1].allowed)


def test_advice_for_a_crank_rocker():
    """The rod must lie between max(g + R − c, c − |g − R|) and c + |g − R|."""
    assert "rod_length must lie between 220 mm and 580 mm" in advice(mechanism=ROCKER | {"rod_length": "600 mm"})
    assert "no rod_length lets the crank turn" in advice(
        mechanism=ROCKER | {"crank_radius": "380 mm", "rocker_length": "90 mm"}
    )


def test_advice_for_a_slave_rod_holds():
    """A rod just longer than the length named closes all round, one just shorter does not."""
    bank = {"L": {"mechanism": slider()}, "R": {"angle": "60 deg", "mechanism": slave("L", rod_length="40 mm")}}
    least = float(advice(bank=bank).rpartition("more than ")[2].removesuffix(" mm"))
    for share, closes in ((1 + 1e-6, True), (1 - 1e-6, False)):
        bank["R"]["mechanism"]["rod_length"] = f"{least * share!r} mm"
        if closes:
            ct.run(ct.Machine(bank=bank))
        else:
            assert "rod_length must be more than" in advice(bank=bank)


def test_a_slave_says_nothing_where_its_master_cannot_close():
    bank = {"L": {"mechanism": slider(rod_length="45 mm")}, "R": {"angle": "60 deg", "mechanism": slave("L")}}
    with pytest.raises(ct.InputError) as caught:
        ct.run(ct.Machine(bank=bank))
    assert [problem.path for problem in caught.value.problems] == ["bank.L.mechanism.rod_length"]
