"""What the page of the text on synthesis says of its formulas, in 30 digits."""

import re
from functools import partial

import mpmath as mp
import pytest
from tests.texts_said import sentence

import cranktrain as ct
from cranktrain.plans.positions import source_angles

R, L = mp.mpf(80), mp.mpf(160)
"""By its requirements. [mm]"""


said = partial(sentence, "slider-crank-synthesis")


def test_twelve_positions_two_of_them_at_the_pressure_angle():
    said("the mechanism in twelve positions, two of them at φ = [α] and 180° + [α]")
    machine = ct.Machine(mechanism={"kind": "slider_crank", "stroke": "160 mm", "rod_length": "160 mm"})
    angles = source_angles(machine, permissible=25.0)
    assert len(angles) == 12
    assert {25.0, 205.0, 0.0, 90.0, 180.0, 270.0} <= set(angles)


def test_where_the_limit_is_reached():
    words = said("the limit is reached at 90° and 270°")
    with mp.workdps(30):
        pressure = [abs(mp.asin(R * mp.sin(mp.radians(at)) / L)) for at in range(360)]
        largest = max(pressure)
        assert [at for at, one in enumerate(pressure) if largest - one < mp.mpf(10) ** -20] == [90, 270]
        # its rod, r/tan 30°: crank and rod stand square, so that the pressure angle is 30°, where tan φ = l/r
        rod = R / mp.tan(mp.pi / 6)
        square = mp.degrees(mp.atan(rod / R))
    assert f"the text says {float(square):.0f}°" in words
    assert "draws 30° and 210° for it" in words


def test_the_lost_root_has_no_length():
    """r cos φ + l² − r² sin²φ: 1 m and 1 mm give other places of one mechanism."""
    said("the root over the bracket is lost")

    def printed(unit):
        r, l, phi = R / unit, L / unit, mp.radians(50)
        return (r * mp.cos(phi) + l**2 - (r * mp.sin(phi)) ** 2) * unit

    assert abs(printed(1) - printed(1000)) > 1000


def test_velocity_has_all_harmonics_and_the_printed_sign_is_of_minus_x():
    said("its sign is that of −dx/dt; exact, the velocity has all harmonics")
    with mp.workdps(30):

        def place(phi):
            return R * mp.cos(phi) + mp.sqrt(L**2 - (R * mp.sin(phi)) ** 2)

        slope = mp.diff(place, mp.radians(60))
        printed = R * (mp.sin(mp.radians(60)) + R / (2 * L) * mp.sin(mp.radians(120)))
        fourth = mp.quad(lambda phi: mp.diff(place, phi) * mp.sin(4 * phi), [0, mp.pi, 2 * mp.pi]) / mp.pi
    assert slope < 0 < printed
    assert printed == pytest.approx(float(-slope), rel=0.05)  # λ = 0.5
    assert abs(fourth) > 0.1


def test_side_force_with_friction_by_equilibrium_of_the_slider():
    """Along: P = S cos β + μN; across: N = S sin β. So N/P = tan β/(1 + μ tan β) or, where P drives, with minus."""
    assert re.search(r"N/P = tan β/\(1 − μ tan β\)", said("N/P ="))
    with mp.workdps(30):
        beta, friction = mp.pi / 6, mp.mpf("0.1")
        rod = 1 / (mp.cos(beta) - friction * mp.sin(beta))  # S of P = 1, the crank driving: S cos β = P + μN
        assert abs(rod * mp.sin(beta) - mp.tan(beta) / (1 - friction * mp.tan(beta))) < mp.mpf(10) ** -25


def test_its_two_errors_of_the_rod_do_not_cancel():
    """By r/sin 30°, r/tan 30° and r/0.3, and the printed 0.27 m."""
    notes = ct.textbook.errata("C").notes.values()
    (words,) = (one for (one,) in notes if "the tangent makes the rod" in one)
    with mp.workdps(30):
        right, tangent = R / mp.sin(mp.pi / 6), R / mp.tan(mp.pi / 6)
        for ratio, digits in ((tangent / right, 3), (R / mp.mpf("0.3") / tangent, 3), (R / mp.mpf("0.3") / right, 3)):
            assert f"{float(ratio):.{digits}f} times" in words
        assert f"{float(mp.mpf(270) / right):.2f} as rounded" in words
