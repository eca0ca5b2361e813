"""How engines are laid out, by hand: which piston is where at φ, and when it fires."""

import numpy as np
import pytest
from tests.machines import (
    RADIUS,
    ROD,
    banks,
    curve,
    of,
    slave,
    slave_position,
    slider,
    slider_position,
    throws,
    turned,
)

import cranktrain as ct

PHI = np.radians(np.arange(360))


def engine(shaft, bank, **tables):
    return ct.run(ct.Machine(shaft=shaft, bank=bank, **tables))


def assert_tops(result, expected):
    """Nominal tops, where every piston moves as a plain slider-crank whose crank points along it."""
    assert set(result.labels["piston"]) == set(expected)
    for name, top in expected.items():
        own = np.radians(np.arange(result.crank_angle.size) * result.crank_angle[1] - top)
        plain = RADIUS + ROD - slider_position(own)
        np.testing.assert_allclose(curve(result, name), plain, atol=1e-15, err_msg=name)
        assert turned(of(result, name, result.top_dead_centre) - top) == pytest.approx(0.0, abs=1e-12)


def assert_fires(result, order, angles):
    """Firing angles in order, and their intervals round the cycle."""
    names = order.split("-")
    fired = [of(result, name, result.firing_angle) for name in names]
    np.testing.assert_allclose(fired, angles, atol=1e-9)
    intervals = [of(result, name, result.firing_interval) for name in names]
    cycle = sum(intervals)
    np.testing.assert_allclose(intervals, np.diff([*angles, angles[0] + cycle]), atol=1e-9)
    assert cycle in (pytest.approx(360.0), pytest.approx(720.0))


def four_stroke(order):
    return {"cycle": "four-stroke", "firing_order": order}


def test_in_line_four():
    result = engine(throws(0, 180, 180, 0), banks(A=0), cylinder=four_stroke("1-3-4-2"))
    assert_tops(result, {"1": 0, "2": 180, "3": 180, "4": 0})
    assert_fires(result, "1-3-4-2", [0, 180, 360, 540])


def test_in_line_six():
    result = engine(throws(0, 240, 120, 120, 240, 0), banks(A=0), cylinder=four_stroke("1-5-3-6-2-4"))
    assert_tops(result, {"1": 0, "2": 120, "3": 240, "4": 240, "5": 120, "6": 0})
    assert_fires(result, "1-5-3-6-2-4", [0, 120, 240, 360, 480, 600])


def test_v6_with_split_pins():
    """A 60° V6 fires evenly if the second pin of each pair stands 60° behind the first, at the same place."""
    bank = banks(L=-30, R=30)
    bank["L"]["throws"], bank["R"]["throws"] = [1, 3, 5], [2, 4, 6]
    gaps = ["0 mm", "110 mm", "0 mm", "110 mm", "0 mm"]
    shaft = throws(0, 300, 240, 180, 120, 60, spacing=gaps)
    result = engine(shaft, bank, cylinder=four_stroke("1L-1R-3L-3R-2L-2R"))
    assert_tops(result, {"1L": 0, "2L": 120, "3L": 240, "1R": 120, "2R": 240, "3R": 0})
    assert_fires(result, "1L-1R-3L-3R-2L-2R", [0, 120, 240, 360, 480, 600])
    np.testing.assert_allclose(result.axial_position, [0, 0.11, 0.22, 0, 0.11, 0.22], atol=1e-15)


def test_cross_plane_v8():
    """Two banks 90° apart on four pins, 90° apart: two pistons at every quarter turn, which fire a turn apart."""
    order = "1L-1R-4L-2L-2R-3L-3R-4R"
    result = engine(throws(0, 90, 270, 180), banks(L=-45, R=45), cylinder=four_stroke(order))
    assert_tops(result, {"1L": 0, "2L": 270, "3L": 90, "4L": 180, "1R": 90, "2R": 0, "3R": 180, "4R": 270})
    assert_fires(result, order, [0, 90, 180, 270, 360, 450, 540, 630])


def test_v4_with_throws_of_each_bank():
    bank = banks(L=-45, R=45)
    bank["L"]["throws"], bank["R"]["throws"] = [1, 3], [4, 2]
    result = engine(throws(0, 90, 180, 270), bank)
    # In bank R the first cylinder is the one on throw 4.
    assert_tops(result, {"1L": 0, "2L": 180, "1R": 180, "2R": 0})


def test_w3_and_w12():
    assert_tops(engine(throws(0), banks(L=-60, M=0, R=60)), {"1L": 0, "1M": 60, "1R": 120})
    w12 = engine(throws(0, 180, 180, 0), banks(L=-60, M=0, R=60))
    assert_tops(w12, {f"{i}{bank}": top + phase for i, phase in ((1, 0), (2, 180), (3, 180), (4, 0)) for bank, top in
                      (("L", 0), ("M", 60), ("R", 120))})  # fmt: skip


def test_first_bank_of_the_file_counts():
    assert_tops(engine(throws(0), banks(R=60, L=-60)), {"1R": 0, "1L": -120})


def test_boxer_four():
    """Opposed pistons on pins half a turn apart move outward together."""
    bank = banks(L=-90, R=90)
    bank["L"]["throws"], bank["R"]["throws"] = [1, 3], [2, 4]
    result = engine(throws(0, 180, 180, 0), bank, cylinder=four_stroke("1L-2L-1R-2R"))
    assert_tops(result, {"1L": 0, "1R": 0, "2L": 180, "2R": 180})
    assert_fires(result, "1L-2L-1R-2R", [0, 180, 360, 540])


def test_flat_twin_on_one_pin_is_a_v_of_180_degrees():
    result = engine(throws(0), banks(L=-90, R=90), cylinder=four_stroke("1L-1R"))
    assert_tops(result, {"1L": 0, "1R": 180})
    assert_fires(result, "1L-1R", [0, 180])


def test_throw_one_need_not_be_at_zero_and_carries_the_crank_angle():
    assert_tops(engine(throws(90, 120), banks(A=0)), {"1": 0, "2": -30})


def test_two_row_radial():
    """Three cylinders round each of two throws; the slaves hang on the master of their own throw."""
    star = {"angle": ["120 deg", "240 deg"], "mechanism": slave("M", articulation_angle=["118 deg", "242 deg"])}
    result = engine(throws(0, 180), {"M": {"mechanism": slider()}, "S": star})
    assert result.labels["piston"] == ("1M", "2M", "1S", "2S", "3S", "4S")
    for name, throw, gamma, zeta in (
        ("1S", 0, 120, 118),
        ("2S", 0, 240, 242),
        ("3S", 180, 120, 118),
        ("4S", 180, 240, 242),
    ):
        position = slave_position(
            PHI + np.radians(throw), bank_angle=np.radians(gamma), articulation_angle=np.radians(zeta)
        )
        np.testing.assert_allclose(np.diff(curve(result, name)), -np.diff(position), atol=1e-15, err_msg=name)
    np.testing.assert_allclose(of(result, "2M", result.top_dead_centre), 180.0)


@pytest.mark.parametrize("order", [("R", "L"), ("L", "R")])
def test_slave_bank_ahead_of_its_master(order):
    """The slave's cylinder is reached first: γ is negative, wherever it stands in the file."""
    tables = {
        "L": {"angle": "30 deg", "mechanism": slider()},
        "R": {"angle": "-30 deg", "mechanism": slave("L", articulation_angle="-62 deg")},
    }
    result = engine(throws(0), {name: tables[name] for name in order})
    first = -30 if order[0] == "R" else 30
    master = PHI + np.radians(first - 30)
    position = slave_position(master, bank_angle=np.radians(-60), articulation_angle=np.radians(-62))
    np.testing.assert_allclose(np.diff(curve(result, "1R")), -np.diff(position), atol=1e-15)
    np.testing.assert_allclose(np.diff(curve(result, "1L")), -np.diff(slider_position(master)), atol=1e-15)
    # The true top by mirroring the V in which the slave comes after.
    after = engine(
        throws(0),
        {
            "L": {"angle": "-30 deg", "mechanism": slider()},
            "R": {"angle": "30 deg", "mechanism": slave("L", articulation_angle="62 deg")},
        },
    )
    for fact in ("top_shift", "bottom_shift"):
        assert of(result, "1R", getattr(result, fact)) == pytest.approx(-of(after, "1R", getattr(after, fact)))


def test_slaves_jointed_on_the_crank_pin_are_plain_slider_cranks():
    """Knuckle radius 0: every bank is a slider-crank of its own, whatever the articulation angle."""
    table = slave("L", knuckle_radius="0 mm", rod_length="180 mm")
    result = engine(throws(0, 120), {"L": {"mechanism": slider()}, "R": {"angle": "60 deg", "mechanism": table}})
    assert_tops(result, {"1L": 0, "2L": -120, "1R": 60, "2R": -60})


def test_sliders_and_rockers_on_one_shaft():
    rocker = {"kind": "crank_rocker", "crank_radius": "10 mm", "rod_length": "40 mm", "rocker_length": "30 mm"}
    bank = {
        "P": {"angle": "0 deg", "mechanism": slider(), "throws": [1, 2]},
        "K": {
            "angle": "90 deg",
            "mechanism": rocker | {"ground_length": "45 mm", "load_radius": "50 mm"},
            "throws": [3, 4],
        },
        "Q": {"angle": "180 deg", "mechanism": slider(), "throws": [1, 2]},
    }
    result = engine(throws(0, 180, 0, 180, speed="100 rpm"), bank, cylinder={"bore": "80 mm"})
    assert result.labels["mechanism"] == ("1P", "2P", "1K", "2K", "1Q", "2Q")
    assert_tops(result, {"1P": 0, "2P": 180, "1Q": 180, "2Q": 0})
    alone = ct.run(
        ct.Machine(
            mechanism=rocker | {"ground_length": "45 mm", "load_radius": "50 mm"}, shaft=throws(0, speed="100 rpm")
        )
    )
    assert result.labels["rocker"] == ("1K", "2K")
    # The rocker's bank is reached 90° later, and the second throw stands half a turn ahead.
    for rocker_, shift in ((0, 90), (1, 270)):
        for name in ("rocker_angle", "rocker_acceleration_coefficient", "load_displacement"):
            np.testing.assert_allclose(
                getattr(result, name)[rocker_], np.roll(getattr(alone, name)[0], shift), atol=1e-12
            )
    assert result.displacement == pytest.approx(4 * np.pi / 4 * 0.08**2 * 2 * RADIUS)
