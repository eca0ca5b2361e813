"""True dead centres: of an offset crank in closed form, of articulated rods by 40-digit roots and published numbers."""

import copy

import mpmath
import numpy as np
import pytest
from tests.machines import RADIUS, ROD, V12, banks, of, slave, slider, throws
from tests.told import line_of, lines_of

import cranktrain as ct


def exact_slave(radius, master_rod, knuckle, rod, bank_angle, articulation_angle):
    """Shifts [deg], pin height and stroke of a slave by mpmath: roots of the derivative that mpmath itself takes."""
    mpmath.mp.dps = 40
    radius, master_rod, knuckle, rod = (mpmath.mpf(length) for length in (radius, master_rod, knuckle, rod))
    gamma, zeta = (mpmath.radians(mpmath.mpf(angle)) for angle in (bank_angle, articulation_angle))

    def position(alpha):
        beta = mpmath.asin(radius / master_rod * mpmath.sin(alpha))
        along = radius * mpmath.cos(alpha - gamma) + knuckle * mpmath.cos(zeta - gamma - beta)
        across = radius * mpmath.sin(alpha - gamma) + knuckle * mpmath.sin(zeta - gamma - beta)
        return along + mpmath.sqrt(rod**2 - across**2)

    top = mpmath.findroot(lambda alpha: mpmath.diff(position, alpha), gamma)
    bottom = mpmath.findroot(lambda alpha: mpmath.diff(position, alpha), gamma + mpmath.pi)
    return (
        float(mpmath.degrees(top - gamma)),
        float(mpmath.degrees(bottom - gamma - mpmath.pi)),
        float(position(top)),
        float(position(top) - position(bottom)),
    )


def facts_of(result, name):
    return tuple(
        of(result, name, getattr(result, fact)) for fact in ("top_shift", "bottom_shift", "top_position", "stroke")
    )


@pytest.mark.parametrize("offset", [-60, -12, 0, 0.001, 30, 129])
def test_offset_slider_crank(offset):
    """Crank and rod in line: sin φ_T = e/(L + R), sin φ_B = −e/(L − R) past 180°; the legs by Pythagoras."""
    result = ct.run(ct.Machine(mechanism=slider(offset=f"{offset} mm")))
    e, far, near = offset / 1e3, ROD + RADIUS, ROD - RADIUS
    assert result.top_shift[0] == pytest.approx(np.degrees(np.arcsin(e / far)), abs=1e-12)
    assert result.bottom_shift[0] == pytest.approx(np.degrees(np.arcsin(e / near)), abs=1e-11)
    assert result.top_position[0] == pytest.approx(np.sqrt(far**2 - e**2), rel=1e-15)
    assert result.bottom_position[0] == pytest.approx(np.sqrt((near - e) * (near + e)), rel=1e-13)
    assert result.top_dead_centre[0] == pytest.approx(np.degrees(np.arcsin(e / far)) % 360)
    assert 0 <= result.top_dead_centre[0] < 360
    assert 0 <= result.bottom_dead_centre[0] < 360


def test_quoted_rods_of_the_3d12():
    """+0.9818045317°, −4.6632317532°, 187.07 mm: the published digits, and 40-digit roots."""
    result = ct.run(ct.Machine(**V12))
    assert of(result, "1R", result.top_shift) == pytest.approx(0.9818045317, abs=1e-10)
    assert of(result, "1R", result.bottom_shift) == pytest.approx(-4.6632317532, abs=1e-10)
    assert of(result, "1R", result.stroke) == pytest.approx(0.18707, abs=5e-6)
    np.testing.assert_allclose(facts_of(result, "4R"), exact_slave(0.09, 0.32, 0.085, 0.235, 60, 67), rtol=1e-13)


def test_rods_of_the_3d12_fitted_to_stroke_and_height():
    data = copy.deepcopy(V12)
    data["bank"]["R"]["mechanism"] |= {
        "knuckle_radius": "78.256 mm",
        "rod_length": "242.426 mm",
        "articulation_angle": "67.458 deg",
    }
    result = ct.run(ct.Machine(**data))
    np.testing.assert_allclose(
        facts_of(result, "1R"), exact_slave("0.09", "0.32", "0.078256", "0.242426", 60, "67.458"), rtol=1e-12
    )
    assert facts_of(result, "1R")[:2] == pytest.approx((0.82, -4.26), abs=0.005)
    assert 12 * of(result, "1R", result.stroke) + 12 * 0.18 == pytest.approx(12 * (0.1867 + 0.18), abs=1e-5)


def test_strokes_of_a_nine_cylinder_radial():
    """R-1340 with illustrative rods: strokes from 146.05 to 147.08 mm, alike in pairs that mirror each other."""
    angles = [f"{40 * k} deg" for k in range(1, 9)]
    table = slave("M", knuckle_radius="62 mm", rod_length="203 mm", articulation_angle=angles)
    master = slider(crank_radius="2.875 in", rod_length="265 mm")
    result = ct.run(ct.Machine(bank={"M": {"mechanism": master}, "S": {"angle": angles, "mechanism": table}}))
    for k in range(1, 9):
        expected = exact_slave("0.073025", "0.265", "0.062", "0.203", 40 * k, 40 * k)
        np.testing.assert_allclose(facts_of(result, f"{k}S"), expected, rtol=1e-12, atol=1e-12)
    strokes = result.stroke * 1e3
    assert (strokes.min(), strokes.max()) == pytest.approx((146.05, 147.08), abs=0.005)
    np.testing.assert_allclose(strokes[1:], strokes[:0:-1], rtol=1e-13)


@pytest.mark.parametrize("gamma", [20, 60, 137, -45])
@pytest.mark.parametrize(("fact", "shift"), [("top", "top_shift"), ("bottom", "bottom_shift")])
def test_zero_shift_theorem(gamma, fact, shift):
    """At the angle that the result names, the dead centre is not shifted: H = R + r + l, h = r + l − R."""
    bank = {
        "L": {"mechanism": slider()},
        "R": {"angle": f"{gamma} deg", "mechanism": slave("L", articulation_angle="0 deg")},
    }
    first = ct.run(ct.Machine(bank=bank), quantities=f"articulation_angle_without_{fact}_shift")
    angle = float(getattr(first, f"articulation_angle_without_{fact}_shift")[0])
    by_hand = np.radians(gamma) + (1 if fact == "top" else -1) * np.arcsin(RADIUS / ROD * np.sin(np.radians(gamma)))
    assert angle == pytest.approx(by_hand, rel=1e-14)
    bank["R"]["mechanism"]["articulation_angle"] = f"{angle!r} rad"
    result = ct.run(ct.Machine(bank=bank))
    assert of(result, "1R", getattr(result, shift)) == pytest.approx(0, abs=1e-11)
    height = {"top": RADIUS + 0.045 + 0.135, "bottom": 0.045 + 0.135 - RADIUS}[fact]
    assert of(result, "1R", getattr(result, f"{fact}_position")) == pytest.approx(height, rel=1e-14)


def test_answer_names_like_pistons_together():
    """What has no cylinder, as a ram, has no top either, but turns back."""
    parts = {"shaft": throws(0, 180), "bank": banks(A=0)}
    aside = parts | {"bank": {"A": {"mechanism": slider(offset="20 mm")}}}
    top = f"{np.degrees(np.arcsin(0.02 / (RADIUS + ROD))):.2f}°"
    bore = {"cylinder": {"bore": "80 mm"}}
    for cylinder, words in ((bore, "true top dead centre"), ({}, "farthest from the shaft")):
        central, offset = (ct.run(ct.Machine(**own, **cylinder)) for own in (parts, aside))
        assert central.top_shift == pytest.approx(0, abs=1e-9)
        assert [line.partition(":")[0] for line in lines_of(central, "Motion")] == ["stroke", "largest pressure angle"]
        assert line_of(central, "Motion", "stroke") == "100.0 mm"
        assert line_of(offset, "Motion", words).startswith(f"{top} after the crank on ")
        assert ("dead centre" in offset.summary()) == bool(cylinder)


def whitworth(**numbers):
    """A lever that turns all round its pivot below the shaft, and a ram on a line through that pivot."""
    return ct.Machine(
        name="Whitworth's quick return",
        rotation="anticlockwise",
        shaft={"main": {"speed": "60 rpm"}},
        mechanism={
            "kind": "chain",
            "output": "ram",
            "fixed": {"D": ["0 mm", f"-{numbers['centres']} mm"]},
            "crank": {"main": {"radius": f"{numbers['radius']} mm"}},
            "part": [
                {
                    "type": "swivel",
                    "pin": "main.pin",
                    "guide": {"name": "lever", "from": "D"},
                    "slider": "block",
                },
                {"type": "point", "name": "P", "link": "lever", "along": "-120 mm"},
                {
                    "type": "slide",
                    "rod": {"name": "rod", "from": "P", "length": "600 mm"},
                    "slider": "ram",
                    "guide": {"through": "D", "direction": "0 deg", "offset": "0 mm"},
                    "side": "ahead",
                },
            ],
        },
    )


@pytest.mark.parametrize(("radius", "centres", "shown"), [(150, 100, "2.735"), (150, 30, "1.294"), (200, 170, "4.662")])
def test_time_ratio_of_a_quick_return(radius, centres, shown):
    """The ram turns back where the lever lies on its line: while the crank pin is below that, the stroke is the faster.

    The crank goes there by π − 2·arcsin(c/r), the other way by the rest; 2.7352 for 100 in 150.
    """
    result = ct.run(whitworth(radius=radius, centres=centres))
    low = np.arcsin(centres / radius)
    ratio = (np.pi + 2 * low) / (np.pi - 2 * low)
    assert result.stroke_time_ratio[0] == pytest.approx(ratio, rel=1e-12)
    assert line_of(result, "Motion", "time ratio").endswith(shown)


def test_time_ratio_of_engines_is_in_no_line():
    """It is a fact of every piston: 1 of a central crank, (π + ϑ)/(π − ϑ) of an offset one."""
    result = ct.run(ct.Machine(mechanism=slider(offset="20 mm"), cylinder={"bore": "80 mm"}))
    theta = np.arcsin(0.02 / (ROD - RADIUS)) - np.arcsin(0.02 / (ROD + RADIUS))
    assert result.stroke_time_ratio[0] == pytest.approx((np.pi + theta) / (np.pi - theta), rel=1e-12)
    assert "time ratio" not in result.summary()
    assert ct.run(ct.Machine(mechanism=slider())).stroke_time_ratio[0] == pytest.approx(1.0, abs=1e-14)
