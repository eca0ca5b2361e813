"""Constants of (I.13) of a machine: the exact motion's harmonics and tops by 30 digits, and what `run` says."""

import mpmath as mp
import numpy as np
import pytest
from tests.reference_case import ReferenceCase

import cranktrain as ct
from cranktrain.errors import InputError

EXACT = "first two harmonics of the exact motion"
RODS = {
    "3d12": ("90", "320", "78.256", "242.426", "60", "67.458"),
    "m_50": ("100", "356", "87", "269.302", "60", "69.889"),
    "40d": ("150", "533", "130", "404.623", "45", "48.569"),
}
"""R, L, r, l, γ, ζ as the examples have them. [mm, deg]"""


def distance(alpha, sizes):
    """Slave pin from the shaft, by the digest's exact formulas. [mm]"""
    crank, master, knuckle, rod = map(mp.mpf, sizes[:4])
    bank, joint = (mp.radians(mp.mpf(one)) for one in sizes[4:])
    turn = joint - bank - mp.asin(crank / master * mp.sin(alpha))
    across = crank * mp.sin(alpha - bank) + knuckle * mp.sin(turn)
    return crank * mp.cos(alpha - bank) + knuckle * mp.cos(turn) + mp.sqrt(rod**2 - across**2)


def ends(sizes):
    """Top and bottom of the exact motion, and the crank's angles there. [mm, rad]"""
    bank = mp.radians(mp.mpf(sizes[4]))
    angles = [mp.findroot(lambda a: mp.diff(lambda b: distance(b, sizes), a), start) for start in (bank, bank + mp.pi)]
    return [distance(angle, sizes) for angle in angles], angles


def by_name(found, name):
    return {one.symbol: one for one in found if one.name == name}


@pytest.mark.parametrize("name", RODS)
def test_harmonics_and_top_of_the_exact_motion(name):
    found, sizes = ct.textbook.constants(name), RODS[name]
    with mp.workdps(30):
        n = 64
        angles = [2 * mp.pi * step / n for step in range(n)]
        values = [distance(angle, sizes) for angle in angles]
        crank, bank = mp.mpf(sizes[0]), mp.radians(mp.mpf(sizes[4]))
        mean = mp.fsum(values) / n
        first, second = (
            2 * mp.fsum(v * mp.expj(-k * (a - bank)) for a, v in zip(angles, values, strict=True)) / n for k in (1, 2)
        )
        (top, _bottom), _angles = ends(sizes)
    own = by_name(found, EXACT)
    assert own["E"].value == pytest.approx(float(abs(first) / crank), rel=1e-12)
    assert own["Φ"].value == pytest.approx(float(mp.arg(first)), rel=1e-10)
    assert own["F"].value == pytest.approx(float(4 * abs(second) / crank), rel=1e-12)
    assert own["Θ"].value == pytest.approx(float(-mp.arg(second)), rel=1e-10)
    assert own["K"].value == pytest.approx(float(mean) / 1e3, rel=1e-13)
    assert {one.verdict for symbol, one in own.items() if symbol != "H"} == {"right"}
    assert by_name(found, "exact motion")["H"].value == pytest.approx(float(top) / 1e3, rel=1e-13)
    assert {one.exact for one in found if one.symbol == "H"} == {by_name(found, "exact motion")["H"].value}
    result = ct.run(name, step_degrees=5.0)
    slaves = [place.endswith("R") for place in result.labels["piston"]]
    np.testing.assert_allclose(result.top_position[slaves], float(top) / 1e3, rtol=1e-12)


def test_top_distances_of_3d12():
    """H of its own top is 410.000 = 90 + 320 mm, as the file has it fitted; of two harmonics 410.095."""
    found = [one for one in ct.textbook.constants("3d12") if one.symbol == "H"]
    tops = {one.name: f"{1e3 * one.value:.3f}" for one in found}
    assert tops == {"reconstructed": "410.234", "derived anew": "410.058", EXACT: "410.095", "exact motion": "410.000"}


def test_constants_of_the_rods_often_quoted():
    """docs/theory/textbook-forms has them to six digits; the top is that of the reference case articulated_V2."""
    found = ct.textbook.constants("3d12_quoted_rods")
    printed = {
        EXACT: (1.038943, 1.2938, 0.257358, 20.929, 310.325),
        "derived anew": (1.038345, 1.2207, 0.248843, 20.810, 310.514),
        "reconstructed": (1.038409, 1.2162, 0.246656, 20.927, 310.749),
    }
    for name, wanted in printed.items():
        own = by_name(found, name)
        values = (
            round(own["E"].value, 6),
            round(np.degrees(own["Φ"].value), 4),
            round(own["F"].value, 6),
            round(np.degrees(own["Θ"].value), 3),
            round(1e3 * own["K"].value, 3),
        )
        assert values == pytest.approx(wanted, abs=1e-9)
    case = ReferenceCase.load("articulated_V2")
    case.compare_value("V2_recalled.H_mm", 1e3 * by_name(found, "exact motion")["H"].value)


@pytest.mark.parametrize(
    ("name", "printed", "shifts"),
    [("m_50", "209.8", (0.51, -4.70)), ("40d", "304.3", (0.56, -1.78)), ("3d12", "186.7", (0.82, -4.26))],
)
def test_printed_strokes_to_their_last_digit(name, printed, shifts):
    """By 30 digits of the sizes in the files, and by `run`; the shifts that the files speak of."""
    with mp.workdps(30):
        (top, bottom), angles = ends(RODS[name])
        bank = mp.radians(mp.mpf(RODS[name][4]))
        found = [float(mp.degrees(angle - at)) for angle, at in zip(angles, (bank, bank + mp.pi), strict=True)]
    assert f"{float(top - bottom):.1f}" == printed
    assert float(top - bottom) == pytest.approx(float(printed), abs=5e-4)
    assert found == pytest.approx(shifts, abs=0.005)
    result = ct.run(name, step_degrees=5.0)
    slave = [place.endswith("R") for place in result.labels["piston"]].index(True)
    assert 1e3 * result.stroke[slave] == pytest.approx(float(top - bottom), rel=1e-12)


@pytest.mark.parametrize(("name", "stroke"), [("M50_fit", "209.8"), ("D40_fit_g60", "304.3")])
def test_one_stroke_does_not_fix_three_sizes(name, stroke):
    """The other rods that the files of M-50 and 40D name, of the reference case."""
    given = ReferenceCase.load("two_harmonic_errors").machine[name]
    keys = ("crank_radius_mm", "master_rod_length_mm", "articulation_radius_mm", "slave_rod_length_mm")
    with mp.workdps(30):
        (top, bottom), _angles = ends([repr(given[key]) for key in (*keys, "gamma_deg", "zeta_deg")])
    assert f"{float(top - bottom):.1f}" == stroke


def test_what_has_no_slaves_is_refused():
    with pytest.raises(InputError, match="must have a piston on an articulated rod"):
        ct.textbook.constants("10d100")


def test_offset_slaves_are_out_of_range():
    crank = {"kind": "slider_crank", "crank_radius": "90 mm", "rod_length": "320 mm"}
    slave = {"kind": "articulated_rod", "master": "L", "knuckle_radius": "85 mm", "rod_length": "235 mm",
             "articulation_angle": "67 deg", "offset": "3 mm"}  # fmt: skip
    found = ct.textbook.constants({"bank": {"L": {"mechanism": crank}, "R": {"angle": "60 deg", "mechanism": slave}}})
    assert {one.verdict for one in by_name(found, "reconstructed").values()} == {"out of range"}
