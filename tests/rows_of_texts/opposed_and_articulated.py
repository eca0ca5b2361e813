"""Rows of the text on opposed pistons and articulated rods: of 10Д100, and of 3Д12's slaves."""

from functools import cache

import numpy as np
import pytest
from tests.rows_of_texts.kept import CLOSE, EXACT, PHI, argument, curve_of, moved, ran, row, same

import cranktrain as ct
from cranktrain.plans.schemes import scheme


@cache
def opposed():
    return ct.textbook.opposed("10d100")


@row("D", "p. 14")
def lead(_command, _typed):
    """Half of it is where `run` has the inner volumetric dead centre, as cranks and rods are alike."""
    (found,) = (one.value for one in opposed() if one.symbol == "Δ")
    inner = float(ran("10d100", "inner_volumetric_dead_centre").inner_volumetric_dead_centre[0])
    assert np.degrees(found) / 2 == pytest.approx(inner, rel=CLOSE)


@row("D", "fig. 1.3", 0)
def two_shafts(_command, _typed):
    """Its Δ, its cranks and rods are those of the machine that was run."""
    found = scheme(ct.load("10d100"))
    places = {place.name: place for place in ct.load("10d100").places}
    lengths = {one.letter: one.value for one in found.lengths}
    for letter, name in (("в", "1.exhaust"), ("п", "1.scavenge")):
        geometry = places[name].geometry
        assert lengths[f"R_{letter}"] == pytest.approx(float(geometry.crank_radius), rel=CLOSE)
        assert lengths[f"L_{letter}"] == pytest.approx(float(geometry.rod_length), rel=CLOSE)
    (angle,) = (one.value for one in found.angles if one.letter == "Δ")
    inner = float(ran("10d100", "inner_volumetric_dead_centre").inner_volumetric_dead_centre[0])
    assert np.degrees(angle) == pytest.approx(2 * inner, rel=CLOSE)


@row("D", "fig. 1.3", 1)
def shafts_that_turn_against_each_other(command, _typed):
    """Of deltic's cylinder: its pistons are as far apart as `run` says of the volume between them."""
    machine = ct.load("deltic")
    cylinder = argument(command, "--mechanism")
    found = scheme(machine, 50.0, mechanism=cylinder)
    result = ran("deltic", "combined_displacement")
    member = result.labels["cylinder"].index(cylinder)
    travelled = result.combined_displacement[member]

    def apart(degrees):
        pins = scheme(machine, degrees, mechanism=cylinder).drawing.positions
        return float(np.hypot(*(np.ravel(pins["B"]) - np.ravel(pins["B2"]))))

    assert found.mechanism
    assert apart(130.0) - apart(50.0) == pytest.approx(travelled[130] - travelled[50], rel=CLOSE)


@row("D", "p. 15")
def dead_centres_at_half_the_lead(_command, _typed):
    found = ran("10d100", "inner_volumetric_dead_centre", "outer_volumetric_dead_centre")
    for at, wanted in (
        ("inner", found.inner_volumetric_dead_centre[0]),
        ("outer", found.outer_volumetric_dead_centre[0]),
    ):
        (half,) = (one for one in opposed() if (one.symbol, one.at) == ("Δ/2", at))
        assert np.degrees(half.exact) == pytest.approx(float(wanted), rel=CLOSE)
        assert half.value == pytest.approx(half.exact, rel=CLOSE)  # cranks and rods are alike


def check_piston(number, name, lag):
    """Two harmonics of R = 127 mm, λ = ¼, from its own inner dead centre; beside them `run`'s curve."""

    def check(_command, _typed):
        theta = PHI - np.radians(lag)
        found = next(one for one in opposed().over_turn if (one.equation, one.symbol) == (number, "S"))
        same(found.values[:-1], 0.127 * (1 - np.cos(theta) + np.sin(theta) ** 2 / 8))
        result = ran("10d100", "piston_displacement")
        same(found.exact[:-1], result.piston_displacement[result.labels["piston"].index(name)], 1e-11)

    return check


row("D", "(I.11)")(check_piston("(I.11)", "1.exhaust", 0))
row("D", "(I.12)")(check_piston("(I.12)", "1.scavenge", 12))


@row("D", "p. 17")
def rods_side_by_side(_command, _typed):
    """KamAZ: both banks move as plain slider-cranks, each from its own top; exact is `run`'s."""
    found = curve_of(moved("kamaz_740"), "(333)", "1R–4L", "S")
    result = ran("kamaz_740", "piston_displacement")
    for name in ("1R", "1L"):
        curve = result.piston_displacement[result.labels["piston"].index(name)][:360]
        same(found.exact[:-1], np.roll(curve, -int(np.argmin(curve))), 1e-11)


@row("D", "fig. 1.4")
def slave(_command, _typed):
    """Of 3Д12: its pin D is where `run` has the slave's piston."""
    machine = ct.load("3d12")
    found = scheme(machine, 40.0)
    assert {one.letter: round(np.degrees(one.value), 3) for one in found.angles}["ζ"] == 67.458
    result = ran("3d12", "piston_displacement", "top_position")
    member = result.labels["piston"].index(found.mechanism.partition(" ")[0] if " " in found.mechanism else "1R")
    reach = float(np.hypot(*np.ravel(found.drawing.positions["D"])))
    at = float(result.top_position[member]) - float(result.piston_displacement[member][40])
    assert reach == pytest.approx(at, rel=CLOSE)


@row("D", "(I.13)", 0)
def slave_by_the_text(_command, _typed):
    """Its exact curve is `run`'s from where the crank points along the slave's cylinder, at 60°."""
    found = curve_of(moved("3d12"), "(I.13)", "1R–6R", "S", "reconstructed")
    result = ran("3d12", "piston_displacement", "displacement_error")
    curve = result.piston_displacement[result.labels["piston"].index("1R")][:360]
    same(found.exact[:-1], np.roll(curve, -60), 1e-11)
    worst = np.max(np.abs(found.values - found.exact)) / np.ptp(curve)
    error = result.displacement_error[
        result.labels["motion_method"].index("reconstructed"), result.labels["piston"].index("1R")
    ]
    assert worst == pytest.approx(float(error), rel=2e-3)


@row("D", "(I.13)", 1)
def constants(_command, _typed):
    """E, Φ, F, Θ of the exact motion are the first two harmonics of `run`'s curve."""
    result = ran("3d12", "piston_displacement", "top_position")
    curve = np.roll(result.piston_displacement[result.labels["piston"].index("1R")][:360], -60)
    place = -curve / 0.09
    first, second = (2 * np.mean(place * np.exp(-1j * order * PHI)) for order in (1, 2))
    found = {
        one.symbol: one.value
        for one in ct.textbook.constants("3d12")
        if one.name == "first two harmonics of the exact motion"
    }
    assert (found["E"], found["Φ"]) == pytest.approx((abs(first), np.angle(first)), rel=CLOSE)
    assert (found["F"], found["Θ"]) == pytest.approx((4 * abs(second), -np.angle(second)), rel=CLOSE)
    (height,) = (one.value for one in ct.textbook.constants("3d12") if (one.symbol, one.name) == ("H", "exact motion"))
    assert height == pytest.approx(float(result.top_position[result.labels["piston"].index("1R")]), rel=EXACT)


def check_strokes(machine, master, own):
    """Strokes of master and slave that `run` shows, of the published ones. [mm]"""

    def check(command, typed):
        found = ran(machine, "stroke")
        by_name = dict(zip(found.labels["piston"], 1e3 * found.stroke, strict=True))
        assert by_name["1L"] == pytest.approx(master, abs=1e-9)
        assert by_name["1R"] == pytest.approx(own, abs=0.005)
        assert f"{own:.1f}" in typed(*command[1:]).stdout

    return check


row("D", "p. 19, 1", 0)(check_strokes("3d12", 180, 186.7))
row("D", "p. 19, 1", 1)(check_strokes("m_50", 200, 209.8))
row("D", "p. 19, 1", 2)(check_strokes("40d", 300, 304.3))


@row("D", "p. 19, 1", 3)
def power_by_bank(_command, _typed):
    """The slaves' bank gives more, as its pistons sweep 3.7 % more."""
    found = ran("3d12", "bank_indicated_power", "indicated_power", "stroke")
    by_bank = dict(zip(found.labels["bank"], found.bank_indicated_power, strict=True))
    assert sum(by_bank.values()) == pytest.approx(float(np.sum(found.indicated_power)), rel=1e-9)
    assert by_bank["R"] != pytest.approx(by_bank["L"], rel=1e-3)


@row("D", "p. 19, 2")
def shifted_dead_centres(_command, _typed):
    """Where the curves of `run` have their ends, to a degree of their grid."""
    found = ran("3d12", "top_shift", "bottom_shift", "piston_displacement")
    member = found.labels["piston"].index("1R")
    curve = np.roll(found.piston_displacement[member][:360], -60)
    turned = np.mod(float(found.top_shift[member]) + 180, 360) - 180
    assert abs(turned) > 0.5
    assert np.mod(np.argmin(curve) - turned + 180, 360) - 180 == pytest.approx(0, abs=1)
    assert np.argmax(curve) - 180 - float(found.bottom_shift[member]) == pytest.approx(0, abs=1)
