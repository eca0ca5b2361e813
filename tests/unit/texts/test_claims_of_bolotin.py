"""What the page of the text on opposed pistons and articulated rods says, in 40 digits or by `run`."""

from functools import partial

import mpmath as mp
import numpy as np
import pytest
from tests.machines import slider
from tests.texts_said import sentence

import cranktrain as ct
from cranktrain.layout.frames import in_machine_axes
from cranktrain.plans.placement import frame

said = partial(sentence, "bolotin")


def slave(alpha, r, l, zeta, bank=60, crank=90, rod=320):
    """Distance of a slave's pin from the shaft. [mm]"""
    own = alpha - mp.radians(bank)
    turn = mp.radians(zeta - bank) - mp.asin(mp.mpf(crank) / rod * mp.sin(alpha))
    across = crank * mp.sin(own) + r * mp.sin(turn)
    return crank * mp.cos(own) + r * mp.cos(turn) + mp.sqrt(mp.mpf(l) ** 2 - across**2)


def stroke(r, l, zeta):
    """Between the roots of its velocity near both dead centres. [mm]"""

    def place(near):
        return mp.findroot(lambda a: mp.diff(lambda b: slave(b, r, l, zeta), a), mp.radians(near))

    return slave(place(60), r, l, zeta) - slave(place(240), r, l, zeta)


def test_volumetric_dead_centres_of_unequal_rods():
    """Least and largest room between pistons on λ = 0.20 and 0.30 with Δ = 12°, by the root of its slope."""
    with mp.workdps(40):
        lead = mp.radians(12)

        def travel(phi, ratio):
            return 1 - mp.cos(phi) + (1 - mp.sqrt(1 - (ratio * mp.sin(phi)) ** 2)) / ratio

        def slope(alpha):
            exhaust, scavenge = mp.mpf("0.2"), mp.mpf("0.3")
            return mp.diff(lambda a: travel(a, exhaust) + travel(a - lead, scavenge), alpha)

        off = [mp.degrees(mp.findroot(slope, near) - near) for near in (lead / 2, mp.pi + lead / 2)]
    inner, outer = (f"{abs(float(one)):.2f}°" for one in off)
    assert f"{inner} and {outer} off at λ = 0.20 and 0.30, Δ = 12°" in said("which it calls usual")


def test_strokes_of_the_rods_often_quoted():
    words = said("no law: on the proportions")
    with mp.workdps(30):
        assert f"with ζ = 67° these give {float(stroke(85, 235, mp.mpf(67))):.2f} mm" in words
        equal = mp.findroot(lambda zeta: stroke(85, 235, zeta) - 180, mp.mpf("59.8"), tol=1e-12)
        assert f"the strokes are equal at ζ = {float(equal):.1f}°" in words
        assert stroke(85, 235, equal - 1) < 180 < stroke(85, 235, equal + 1)
    result = ct.run("3d12_quoted_rods", quantities=("stroke",))
    assert 1e3 * result.stroke[-1] == pytest.approx(187.07, abs=5e-3)


@pytest.mark.parametrize(("end", "sign"), [("top", 1), ("bottom", -1)])
def test_the_articulation_that_shifts_no_dead_centre(end, sign):
    """At α = γ or γ + 180° the slave stands still if ζ = γ ± asin(λ sin γ), and not at the other end."""
    said("none at the top if ζ = γ + asin(λ sin γ), none at the bottom with minus; never both")
    with mp.workdps(30):
        bank = mp.pi / 3
        zeta = mp.degrees(bank + sign * mp.asin(mp.mpf(90) / 320 * mp.sin(bank)))
        speeds = [
            mp.diff(lambda a: slave(a, mp.mpf("78.256"), mp.mpf("242.426"), zeta), at) for at in (bank, bank + mp.pi)
        ]
    still, moving = speeds if end == "top" else speeds[::-1]
    assert abs(still) < 1e-12 < 1 < abs(moving)


def test_central_pistons_move_alike_whichever_way_their_shafts_turn():
    """A shaft that turns the other way is at −φ: S, v, j over time are the same, and N = P tan β is the opposite."""
    said("are alike in both; side forces change sign")
    ratio = mp.mpf("0.25")

    def travel(time, sense):
        return 1 - mp.cos(sense * time) + (1 - mp.sqrt(1 - (ratio * mp.sin(sense * time)) ** 2)) / ratio

    with mp.workdps(40):
        for order in range(3):
            ahead, back = (mp.diff(lambda t, sense=sense: travel(t, sense), mp.mpf("0.7"), order) for sense in (1, -1))
            assert abs(ahead - back) < mp.mpf(10) ** -12 < abs(ahead)
        ahead, back = (mp.tan(mp.asin(ratio * mp.sin(sense * mp.mpf("0.7")))) for sense in (1, -1))
        assert abs(ahead + back) < mp.mpf(10) ** -35 < abs(ahead)


@pytest.mark.parametrize(("name", "master", "slaves"), [("m_50", 200, 209.8), ("40d", 300, 304.3)])
def test_fitted_rods_have_the_printed_strokes(name, master, slaves):
    assert f"{slaves} mm beside {master} mm" in said(f"{slaves} mm beside")
    said("by rods that are fitted to it: one stroke does not fix three sizes")
    result = ct.run(name, quantities=("stroke",))
    found = dict(zip(result.labels["piston"], 1e3 * result.stroke, strict=True))
    assert {round(value, 1) for value in found.values()} == {float(master), slaves}
    with mp.workdps(20):  # two rods of different sizes, one stroke
        other = mp.findroot(lambda zeta: stroke(85, 235, zeta) - mp.mpf("186.7"), mp.mpf(66))
        third = mp.findroot(lambda zeta: stroke(78, 242, zeta) - mp.mpf("186.7"), mp.mpf(67))
    assert abs(other - third) > 0.1


def test_the_divided_form_that_fails_where_banks_are_parallel():
    """Of the reconstructed constants of 3Д12's lengths at γ = 0: F sin Θ is 0, and Θ with it; cos Φ is not."""
    assert said("F/sin Θ fails at γ = 0")
    with mp.workdps(40):
        crank, master, knuckle, rod = 90, 320, mp.mpf("78.256"), mp.mpf("242.426")
        bank, psi = mp.mpf(0), mp.radians(mp.mpf("7.458"))
        rho, reach = knuckle / master, 1 + knuckle / rod
        sine = 2 * rho * crank / rod * mp.sin(bank) * (1 - reach * rod / master * mp.cos(bank))
        cosine = crank / rod * (1 - 2 * rho * mp.cos(bank)) + mp.mpf(crank) / master * rho * reach * mp.cos(2 * bank)
        turned = mp.atan2((knuckle / rod - rho * reach * mp.cos(bank)) * mp.sin(psi), 1 + reach * rho * mp.sin(bank))
        assert (sine, mp.atan2(sine, cosine)) == (0, 0)
        assert cosine > 0.1
        assert mp.cos(turned) > 0.99


def closed(ratio, alpha):
    return 1 - mp.cos(alpha) + (1 - mp.sqrt(1 - (ratio * mp.sin(alpha)) ** 2)) / ratio


def one_cylinder(ratio):
    """Two pistons of 2 kg on shafts that turn alike, 1, or against each other, -1."""
    piston = {"mechanism": slider(), "masses": {"piston": {"mass": "2 kg"}}}
    return {
        "shaft": {"main": {"speed": "1000 rpm"}, "upper": {"ratio": ratio}},
        "bank": {"A": {"exhaust": piston, "scavenge": piston | {"shaft": "upper"}, "lead": "12 deg"}},
    }


def across(machine, found, place):
    """Side force of a piston to the right, seen from the free end. [N]"""
    force = found.side_force[0, place]
    return in_machine_axes(np.zeros_like(force), force, frame(machine, machine.places[place]))[0]


def test_astern_the_scavenge_ports_open_first():
    """Of ports of 60 and 50 mm, R = 127 mm: angles from the inner dead centres by the triangle, the lead taken off."""
    words = "astern the lead is −Δ, and where it is more than the ports' heights give, the scavenge ports open first"
    assert said(words, "p. 14")
    ahead, astern = (ct.run("10d100", set={"running": way}, step_degrees=30.0) for way in ("ahead", "astern"))
    difference = float(ahead.exhaust_opens_before[0] + astern.exhaust_opens_before[0]) / 2
    assert float(ahead.exhaust_opens_before[0] - astern.exhaust_opens_before[0]) == pytest.approx(24.0, abs=1e-9)
    assert 5 < difference < 12
    assert astern.exhaust_opens_before[0] < 0
    short = ct.run("10d100", set={"running": "astern", "bank.A.lead": "5 deg"}, step_degrees=30.0)
    assert short.exhaust_opens_before[0] > 0


def test_both_senses_have_one_motion_and_side_forces_that_change_sign():
    words = "travel, velocity and acceleration of central mechanisms are alike in both; side forces change sign"
    assert said(words, "fig. 1.3")
    same, against = (ct.run(one_cylinder(ratio), step_degrees=5.0) for ratio in (1, -1))
    for name in ("piston_displacement", "piston_velocity_coefficient", "piston_acceleration_coefficient"):
        np.testing.assert_allclose(getattr(same, name), getattr(against, name), atol=1e-12)
    lower, upper = (
        [across(ct.Machine(**one_cylinder(ratio)), found, end) for ratio, found in ((1, same), (-1, against))]
        for end in range(2)
    )
    np.testing.assert_allclose(lower[0], lower[1], atol=1e-9)
    np.testing.assert_allclose(upper[0], -upper[1], atol=1e-9)
    assert np.max(np.abs(upper[0])) > 100


def test_11_is_off_as_the_steam_engines_forms():
    """λ = 1/4: displacement of the stroke, velocity and acceleration of their peaks, on whole degrees in 20 digits."""
    with mp.workdps(20):
        ratio = mp.mpf("0.25")

        def form(alpha):
            return 1 - mp.cos(alpha) + ratio / 2 * mp.sin(alpha) ** 2

        found = []
        for order in range(3):
            angles = [mp.pi * step / 180 for step in range(181)]
            exact = [mp.diff(lambda a: closed(ratio, a), angle, order) for angle in angles]
            error = max(abs(mp.diff(form, angle, order) - one) for angle, one in zip(angles, exact, strict=True))
            found.append(f"{100 * float(error / max(map(abs, exact))):.2f}")
    assert said(f"{found[0]}, {found[1]} and {found[2]} % at λ = 0.25", "(I.11)")


def test_rods_side_by_side_move_as_on_a_plain_crank():
    """Every piston of kamaz_740 by the triangle of 60 mm and its rod, from its own top."""
    assert said("every piston moves as on a plain crank", "p. 17")
    machine, found = ct.load("kamaz_740"), ct.run("kamaz_740", step_degrees=5.0)
    (spec,) = machine.bank["R"].mechanism
    radius, rod = spec.stroke.si / 2, spec.rod_length.si
    for place in range(len(found.labels["piston"])):
        own = np.radians(found.crank_angle - found.top_dead_centre[place])
        by_hand = radius * (1 - np.cos(own)) + rod - np.sqrt(rod**2 - (radius * np.sin(own)) ** 2)
        np.testing.assert_allclose(found.piston_displacement[place], by_hand, atol=1e-12)
