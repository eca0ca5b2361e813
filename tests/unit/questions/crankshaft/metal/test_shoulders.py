"""Stepped shafts: closed forms of stepped beams, integrals of 30 digits, and shafts of files."""

import mpmath
import numpy as np
import pytest
from tests.straight_shafts import straight_shaft
from tests.validation.test_crankshaft_arrangements import PLAIN, SECTIONS

import cranktrain as ct
from cranktrain.questions.crankshaft.bending.equivalent_stiffness import end_slopes
from cranktrain.questions.crankshaft.bending.frame_twist import twist_when_free
from cranktrain.questions.crankshaft.metal.sections import Section
from cranktrain.questions.crankshaft.metal.shoulders import Shoulders, with_shoulders

STEPS = np.array([[0.3, 0.5, 0.9]])
BENDING = np.array([[2.0, 0.7, 3.1]])
SHEAR = np.array([[9.0, 30.0, np.inf]])


def stepped(shaft, z=STEPS, bending=BENDING, shear=SHEAR):
    section = Section(bending, 0.8 * bending, shear, bending)
    shoulders = Shoulders(np.zeros(z.shape[1], dtype=np.intp), z, section)
    pieces, webs, first = with_shoulders(shaft.pieces, shaft.webs, shoulders)
    assert first.tolist() == [0, z.shape[1] + 1]
    return shaft._replace(pieces=pieces, webs=webs)


def test_slopes_of_a_stepped_beam():
    """By unit moments at its ends: ∫ m m̄/EI + v v̄/κGA over the beam."""
    found = end_slopes(stepped(straight_shaft([0.0, 1.2])))
    mpmath.mp.dps = 30
    bounds, stiff, shear = [0, 0.3, 0.5, 0.9, 1.2], [1, 2.0, 0.7, 3.1], [mpmath.inf, 9.0, 30.0, mpmath.inf]

    def by(one, other):
        """Of moments that are 1 at an end and 0 at the other."""
        total = mpmath.mpf(0)
        for begin, end, own, gives in zip(bounds, bounds[1:], stiff, shear, strict=False):
            total += mpmath.quad(lambda z, own=own: one(z) * other(z) / own, [begin, end])
            slopes = (one(mpmath.mpf(1.2)) - one(0)) * (other(mpmath.mpf(1.2)) - other(0)) / mpmath.mpf(1.2) ** 2
            total += slopes * (mpmath.mpf(end) - begin) / gives
        return float(total)

    def first(z):
        return 1 - z / mpmath.mpf(1.2)

    def last(z):
        return z / mpmath.mpf(1.2)

    for values, wanted in zip(found, (by(first, first), by(first, last), by(last, last)), strict=True):
        np.testing.assert_allclose(values[0, 0], wanted * np.eye(2), rtol=1e-13, atol=1e-13)


def test_the_twofold_step_of_textbooks():
    """A beam on two supports, of I and 2I by halves: 3·θ EI/ML = 15/16 at the soft end, 9/16 at the stiff one."""
    shaft = stepped(straight_shaft([0.0, 2.0]), np.array([[1.0]]), np.array([[2.0]]), np.array([[np.inf]]))
    near, far, last = (values[0, 0, 0, 0] for values in end_slopes(shaft))
    np.testing.assert_allclose((near, far, last), (2 / 3 * 15 / 16, 2 / 6 * 3 / 4, 2 / 3 * 9 / 16), rtol=1e-14)


def test_a_shoulder_to_the_same_section_is_none():
    shaft = straight_shaft([0.0, 1.2], shear=4.0)
    same = stepped(shaft, STEPS, np.ones((1, 3)), np.full((1, 3), 4.0))
    for one, other in zip(end_slopes(shaft), end_slopes(same), strict=True):
        np.testing.assert_allclose(one, other, rtol=1e-14, atol=1e-14)


def test_twist_is_the_sum_of_the_parts():
    """From the middle of the first part to that of the last, as of pins there."""
    shaft = stepped(straight_shaft([0.0, 1.2]))
    shaft = shaft._replace(pieces=shaft.pieces._replace(bounds=np.array([[0.0, 0.3, 0.5, 0.9, 1.2]])))
    twist = twist_when_free(shaft, np.array([0, 3]))
    wanted = 0.15 / 1.0 + 0.2 / 1.6 + 0.4 / 0.56 + 0.15 / 2.48
    np.testing.assert_allclose(twist, [[wanted]], rtol=1e-14)


def overhung(shoulder, **more):
    """A throw between two bearings, a third one behind, and a weight between these."""
    return ct.Machine(
        mechanism=PLAIN,
        shaft={"main": {"speed": "0.001 rpm"}},
        masses={"piston": {"mass": "1 g"}},
        crankshaft={
            **SECTIONS,
            "bearing_distance": "130 mm",
            "bearing": {"tail": {"z": "530 mm", "width": "30 mm"}},
            "pull": {"weight": {"z": "400 mm", "force": "1 kN", "direction": "180 deg"}},
            "shoulder": shoulder,
            **more,
        },
    )


def borne(machine, method="frame_rigid"):
    return ct.run(machine).dataset.largest_bearing_load.sel(bearing_method=method).values


def test_a_beam_over_three_bearings():
    """M over the middle one by flexibilities: of the throw's span from the shaft without shoulders, of the stepped span
    by integrals of 30 digits."""
    plain = {"a": {"z": "300 mm", "diameter": "70 mm"}}
    steps = {"b": {"z": "450 mm", "diameter": "40 mm", "bore": "12 mm"}, "a": {"z": "300 mm", "diameter": "50 mm"}}
    young, poisson = 206e9, mpmath.mpf("0.3")

    def flexibilities(diameter, bore):
        """θ at the middle bearing in the stepped span, by a unit moment there and by the weight."""
        own, by_weight = mpmath.mpf(0), mpmath.mpf(0)
        parts = zip((0.13, 0.3, 0.4, 0.45), (0.3, 0.4, 0.45, 0.53), diameter, bore, strict=True)
        for begin, end, outer, inner in parts:
            d, b = mpmath.mpf(outer) / 1000, mpmath.mpf(inner) / 1000
            stiff = young * mpmath.pi / 64 * (d**4 - b**4)
            m = (b / d) ** 2
            kappa = 6 * (1 + poisson) * (1 + m) ** 2 / ((7 + 6 * poisson) * (1 + m) ** 2 + (20 + 12 * poisson) * m)
            shear = kappa * young / (2 * (1 + poisson)) * mpmath.pi / 4 * (d**2 - b**2)

            def unit(z):
                return (mpmath.mpf("0.53") - z) / mpmath.mpf("0.4")

            def weight(z):
                left = mpmath.mpf("0.13") / mpmath.mpf("0.4") * (z - mpmath.mpf("0.13"))
                return left - max(z - mpmath.mpf("0.4"), 0)

            own += mpmath.quad(lambda z: unit(z) ** 2, [begin, end]) / stiff
            own += (mpmath.mpf(end) - begin) / shear / mpmath.mpf("0.4") ** 2
            by_weight += mpmath.quad(lambda z: unit(z) * weight(z), [begin, end]) / stiff
            slope = mpmath.mpf("0.13") / mpmath.mpf("0.4") - (1 if begin >= 0.4 else 0)
            by_weight += (mpmath.mpf(end) - begin) * slope * (-1 / mpmath.mpf("0.4")) / shear
        return own, by_weight

    alike = borne(overhung(plain))
    own, by_weight = flexibilities((70, 70, 70, 70), (0, 0, 0, 0))
    # The tail bears its lever's part less M/l; what the throw's span gives to M follows.
    lever = 1000 * mpmath.mpf("0.27") / mpmath.mpf("0.4")
    moment = (lever - alike[2]) * mpmath.mpf("0.4")
    of_throw = 1000 * by_weight / moment - own
    own, by_weight = flexibilities((70, 50, 50, 40), (0, 0, 0, 12))
    wanted = lever - 1000 * by_weight / (own + of_throw) / mpmath.mpf("0.4")
    assert borne(overhung(steps))[2] == pytest.approx(float(wanted), rel=1e-6)
    assert borne(overhung(steps), "split")[2] == pytest.approx(float(lever), rel=1e-9)


def test_twist_between_throws():
    """By so much softer as the journal's part twists more; textbooks' rules know no shoulder."""

    def stiffness(shoulder):
        machine = ct.Machine(
            shaft={"main": {"throws": ["0 deg", "180 deg"], "spacing": "200 mm", "speed": "750 rpm"}},
            bank={"A": {"mechanism": PLAIN}},
            masses={"piston": {"mass": "5 kg"}},
            crankshaft={**SECTIONS, "shoulder": shoulder},
            torsion={"throw_inertia": "0.1 kg·m²"},
        )
        return ct.run(machine).dataset.throw_stiffness.isel(throw_gap=0)

    # From the faces at 58 and 142 mm; from 100 mm on to the middle of the web at 156 mm.
    found = 1 / stiffness({"neck": {"z": "100 mm", "diameter": "50 mm"}}) - 1 / stiffness({})
    shear = 206e9 / 2.6
    more = 32 / (np.pi * shear) * (1 / 0.05**4 - 1 / 0.07**4) * 0.056
    # Ker Wilson's length of the web behind is less stiff within the smaller journal.
    width, thickness = 0.110, 0.028
    web = 0.2 * (0.07 - 0.05) / (206e9 * thickness * width**3 / 12)
    np.testing.assert_allclose(found.sel(throw_method="frame"), more + web, rtol=1e-9)
    assert np.isnan(found.sel(throw_method="carter"))


def test_a_bearing_behind_a_shoulder_has_its_diameter():
    steps = {"a": {"z": "300 mm", "diameter": "50 mm"}}
    of = ct.run(overhung(steps)).dataset.isel(bearing_method=0)
    pressure = of.largest_bearing_load[2] / (0.05 * 0.03)
    np.testing.assert_allclose(of.largest_bearing_pressure[2], pressure, rtol=1e-12)


def test_torque_behind_a_shoulder():
    """The same as before it: nothing turns the shaft there."""
    found = ct.run(overhung({"flange": {"z": "300 mm", "diameter": "50 mm"}})).dataset
    assert found.section.values.tolist() == ["journal 1", "pin 1", "journal 2", "journal 2 flange"]
    one, other = (found.section_torque.sel(section=name) for name in ("journal 2", "journal 2 flange"))
    np.testing.assert_allclose(one, other, rtol=0, atol=1e-12)


def test_designs_with_shoulders():
    """Of other sizes each as alone; on another side of a bearing they are refused."""
    machines = [overhung({"a": {"z": z, "diameter": d}}) for z, d in (("300 mm", "50 mm"), ("350 mm", "40 mm"))]
    together = ct.run(machines).dataset.largest_bearing_load
    for design, machine in enumerate(machines):
        np.testing.assert_array_equal(together.isel(design=design), ct.run(machine).dataset.largest_bearing_load)
    beyond = overhung({"a": {"z": "420 mm", "diameter": "50 mm"}})
    with pytest.raises(ct.InputError, match=r"must stand between the same bearings, webs, pulls, gears and shoulders"):
        ct.run([machines[0], beyond])


WRONG = {
    "in a web": ({"z": "40 mm", "diameter": "50 mm"}, "shoulder.a.z = 40 mm: must be on a journal, clear of webs"),
    "in a bearing": ({"z": "520 mm", "diameter": "50 mm"}, "shoulder.a.z = 520 mm: must stand clear of bearing tail"),
    "all bore": (
        {"z": "300 mm", "diameter": "50 mm", "bore": "50 mm"},
        "shoulder.a.diameter = 50 mm: must be more than its bore, 50 mm",
    ),
    "no diameter": ({"z": "300 mm"}, "shoulder.a.diameter: is missing"),
    "no place": ({"diameter": "50 mm"}, "shoulder.a.z: is missing"),
    "no size": ({"z": "300 mm", "diameter": "0 mm"}, "shoulder.a.diameter = 0 mm: must be"),
}


@pytest.mark.parametrize("shoulder, wanted", WRONG.values(), ids=WRONG)
def test_refused(shoulder, wanted):
    with pytest.raises(ct.InputError) as found:
        ct.run(overhung({"a": shoulder}))
    assert f"crankshaft.{wanted}" in str(found.value)


def test_two_at_one_place():
    one = {"z": "300 mm", "diameter": "50 mm"}
    with pytest.raises(ct.InputError, match=r"shoulder\.b\.z = 300 mm: must stand apart from a"):
        ct.run(overhung({"a": one, "b": one}))


def test_shoulders_inside_a_bore_need_metal():
    """The bore goes on where the shoulder says none."""
    with pytest.raises(ct.InputError, match=r"shoulder\.a\.diameter = 30 mm: must be more than its bore, 40 mm"):
        ct.run(overhung({"a": {"z": "300 mm", "diameter": "30 mm"}}, journal_bore="40 mm"))
