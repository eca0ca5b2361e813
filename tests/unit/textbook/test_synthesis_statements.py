"""What the text on the synthesis states, as records: its own numbers by hand, others by 40-digit mpmath and `run`."""

import mpmath as mp
import numpy as np
import pytest

import cranktrain as ct

PRINTED = [0, 6.3, 9.99, 10.048, 7.4, 3.7, 0, -3.7, -7.4, -10.048, -9.99, -6.3]
"""The text's table, m/s, at 0, 30, … 330°."""


def velocity(phi, radius, rod, speed):
    """Minus the derivative of r cos φ + √(l² − r² sin²φ), times ω, in 40 digits."""
    with mp.workdps(40):
        radius, rod, speed = map(mp.mpf, (radius, rod, speed))
        angle = mp.mpf(phi) * mp.pi / 180
        return float(
            -speed * mp.diff(lambda a: radius * mp.cos(a) + mp.sqrt(rod**2 - (radius * mp.sin(a)) ** 2), angle)
        )


def one(found, name):
    (statement,) = (each for each in found if each.name == name)
    return statement


def test_its_own_numbers():
    found = ct.textbook.synthesis()
    by_rule, goes_on = (each for each in found.numbered("l = r/tg [α]") if each.symbol == "l")
    assert by_rule.value == pytest.approx(0.08 * 3**0.5, rel=1e-14)
    assert goes_on.value == 0.27
    assert by_rule.exact == goes_on.exact == pytest.approx(0.16, rel=1e-14)
    angles = [np.degrees(each.value) for each in found if each.name == "its largest pressure angle"]
    assert angles == pytest.approx([float(mp.degrees(mp.asin(sine))) for sine in (1 / mp.sqrt(3), mp.mpf(8) / 27)])
    rounded = one(found, "the same, rounded")
    assert (rounded.value, rounded.verdict) == (0.05, "printed")
    assert rounded.exact == pytest.approx(0.32 / 6.3, rel=1e-14)
    assert one(found, "angular speed of the crank").value == pytest.approx(np.pi * 6.3 / 0.16, rel=1e-14)


def test_velocities_of_its_table():
    printed = ct.textbook.synthesis().numbered("table")
    assert [each.value for each in printed] == PRINTED
    assert [each.crank_angle for each in printed] == list(range(0, 360, 30))
    for each in printed:
        assert each.exact == pytest.approx(velocity(each.crank_angle, "0.08", "0.27", "125.6"), abs=1e-12)
    for each in ct.textbook.synthesis().numbered("v = rω[φ + (r/2l) sin 2φ]"):
        phi = np.radians(each.crank_angle)
        assert each.verdict == "approximate"
        assert each.value == pytest.approx(10.048 * (np.sin(phi) + 0.15 * np.sin(2 * phi)), abs=1e-12)


def test_other_requirements_are_those_of_a_machine():
    """S = 200 mm, v = 5 m/s, [α] = 20°: the exact velocity is what `run` has of that machine."""
    found = ct.textbook.synthesis(stroke="200 mm", mean_speed="5 m/s", pressure_angle="20 deg")
    rod = float(0.1 / mp.sin(mp.pi / 9))
    assert one(found, "rod by the rule").exact == pytest.approx(rod, rel=1e-14)
    assert "table" not in {each.equation for each in found}
    rpm = 60 * 5 / 0.4
    machine = {
        "mechanism": {"kind": "slider_crank", "stroke": "200 mm", "rod_length": f"{rod!r} m"},
        "shaft": {"main": {"speed": f"{rpm} rpm"}},
    }
    result = ct.run(machine, quantities=["piston_velocity"])
    (curve,) = found.over_turn
    # positive toward the shaft
    assert curve.exact[:360] == pytest.approx(np.abs(result.piston_velocity[0]) * np.sign(curve.exact[:360]), abs=1e-9)
    assert np.max(np.abs(curve.values - curve.exact)) > 1e-3


def test_the_texts_requirements_typed_are_its_own():
    typed = ct.textbook.synthesis(stroke="0.16 m", mean_speed="6.3 m/s", pressure_angle="30 deg")
    assert [each.value for each in typed] == pytest.approx([each.value for each in ct.textbook.synthesis()])


@pytest.mark.parametrize(
    ("wanted", "paths"),
    [
        ({"stroke": "0 mm"}, ["stroke"]),
        ({"stroke": "160"}, ["stroke"]),
        ({"pressure_angle": "90 deg"}, ["pressure_angle"]),
        ({"stroke": "-1 mm", "mean_speed": "fast"}, ["stroke", "mean_speed"]),
        ({"rod_length": "80 mm"}, ["rod_length"]),
        ({"rod_length": "0 mm"}, ["rod_length"]),
    ],
)
def test_what_no_slider_crank_has_is_refused_by_its_name(wanted, paths):
    with pytest.raises(ct.InputError) as refused:
        ct.textbook.synthesis(**wanted)
    assert [problem.path for problem in refused.value.problems] == paths


def test_a_rod_that_is_given_is_that_with_which_it_goes_on():
    """S = 120 mm, l = 225 mm: velocity and place at 60° in 40 digits, the largest pressure angle asin(60/225)."""
    found = ct.textbook.synthesis(
        stroke="120 mm", mean_speed="10.4 m/s", pressure_angle="15.5 deg", rod_length="225 mm"
    )
    given = one(found, "rod that is given")
    assert (given.value, given.verdict) == (0.225, "right")
    angles = [each.value for each in found if each.name == "its largest pressure angle"]
    assert angles[-1] == pytest.approx(float(mp.asin(mp.mpf(60) / 225)), rel=1e-14)
    by_formula = next(each for each in found.numbered("v = rω[φ + (r/2l) sin 2φ]") if each.crank_angle == 60)
    speed = float(mp.pi * 2600 / 30)
    assert by_formula.exact == pytest.approx(velocity(60, "0.06", "0.225", speed), rel=1e-13)
    place = next(each for each in found if each.symbol == "x" and each.crank_angle == 60)
    square = 0.225**2 - 0.06**2 * 3 / 4
    assert (place.value, place.exact) == pytest.approx((0.03 + square, 0.03 + square**0.5), rel=1e-14)


def test_the_position_that_the_text_prints():
    """At 60° of its own numbers an area and a length: 0.04 + 0.27² − 0.08² · 3/4."""
    place = next(each for each in ct.textbook.synthesis() if each.symbol == "x" and each.crank_angle == 60)
    assert place.value == pytest.approx(0.04 + 0.0729 - 0.0048, rel=1e-14)
