"""Hammer blow of a locomotive's driving wheels: levers of the overbalance about the other rail, by hand."""

import tomllib

import numpy as np
import pytest

import cranktrain as ct

LOCOMOTIVE = """
rotation = "{rotation}"
{more}
[shaft.main]
throws = ["0 deg", "90 deg"]
spacing = "2000 mm"
speed = "240 rpm"
[bank.cyl]
angle = "90 deg"
mechanism = {{ kind = "slider_crank", stroke = "660 mm", rod_length = "2800 mm" }}
[masses.piston]
mass = "300 kg"
[masses.crank]
mass = "120 kg"
along = "330 mm"
inertia = "0 kg m2"
[balance]
{balance}
[balance.wheel.right]
z = "250 mm"
load = "85 kN"
[balance.wheel.left]
z = "1750 mm"
load = "85 kN"
"""
SOLVED = 'counterweights = "rotating"\nshare = 0.5\nplanes = ["250 mm", "1750 mm"]'
OMEGA = 8 * np.pi


def run(rotation="clockwise", balance=SOLVED, more="", **options):
    text = LOCOMOTIVE.format(rotation=rotation, balance=balance, more=more)
    return ct.run(ct.Machine(**tomllib.loads(text)), **options)


@pytest.mark.parametrize("rotation", ["clockwise", "anticlockwise"])
@pytest.mark.parametrize("planes", ['planes = ["250 mm", "1750 mm"]', ""])
def test_overbalance_by_levers(rotation, planes):
    """Half of 300 kg at 330 mm is over in the weights; throws at 0 and 2000 mm, a right angle apart.

    About the other rail the near throw has 1750/1500, the far one −250/1500: wherever the weights are, in the wheels or
    on the throws themselves. A throw that stands up has its weight below: there the wheel presses most.
    """
    result = run(rotation, SOLVED.replace('planes = ["250 mm", "1750 mm"]', planes))
    over = 0.5 * 300 * 0.33
    blow = over * np.hypot(1750 / 1500, 250 / 1500) * OMEGA**2
    np.testing.assert_allclose(result.hammer_blow, [blow, blow], rtol=1e-12)
    np.testing.assert_allclose(result.hammer_blow_share, [blow / 85e3] * 2, rtol=1e-12)
    np.testing.assert_allclose(result.lifting_speed, OMEGA * np.sqrt(85e3 / np.array([blow, blow])), rtol=1e-12)
    # Angles count in the sense of rotation: the first crank stands up at 270°, the second at 180°.
    up = 270.0
    lever = np.degrees(np.arctan2(250, 1750))
    expected = [(up + lever) % 360, (up - 90 - lever) % 360]
    np.testing.assert_allclose(result.hammer_blow_at, expected, atol=1e-9)


@pytest.mark.parametrize("planes", ['planes = ["250 mm", "1750 mm"]', ""])
@pytest.mark.parametrize(("right", "left"), [(450.0, 1950.0), (-300.0, 900.0), (0.0, 3100.0), (2300.0, 2900.0)])
def test_wheels_anywhere_along_the_axle(planes, right, left):
    """Each wheel bears what has a lever about the other rail, wherever both stand to the middle of the throws.

    The throws' planes, 0 and 2000 mm, are a right angle apart; weights in planes of their own press as on the throws.
    """
    text = LOCOMOTIVE.format(
        rotation="clockwise", more="", balance=SOLVED.replace('planes = ["250 mm", "1750 mm"]', planes)
    )
    wheels = text.rpartition("[balance.wheel.right]")
    moved = wheels[2].replace('z = "250 mm"', f'z = "{right} mm"').replace('z = "1750 mm"', f'z = "{left} mm"')
    result = ct.run(ct.Machine(**tomllib.loads(f"{wheels[0]}{wheels[1]}{moved}")))
    over, apart = 0.5 * 300 * 0.33 * OMEGA**2, left - right
    levers = np.array([[left - 0.0, left - 2000.0], [0.0 - right, 2000.0 - right]]) / apart
    np.testing.assert_allclose(result.hammer_blow, over * np.hypot(*levers.T), rtol=1e-12)


def test_weights_that_take_what_rotates_alone_leave_no_blow():
    result = run(balance='counterweights = "rotating"')
    np.testing.assert_array_equal(result.hammer_blow, [0.0, 0.0])
    assert np.all(np.isnan(result.lifting_speed))


def test_a_crank_without_weights_presses_with_all_of_itself():
    """120 kg at 330 mm on each throw."""
    result = run(balance="")
    blow = 120 * 0.33 * np.hypot(1750 / 1500, 250 / 1500) * OMEGA**2
    np.testing.assert_allclose(result.hammer_blow, [blow, blow], rtol=1e-12)


def test_both_wheels_press_with_what_shakes_up_and_down():
    """Without level pistons' share the sum over both rails is the shaking force upward, with its sign turned."""
    result = run(balance="")
    phi = np.radians(np.arange(360.0))[:, np.newaxis]
    pressing = np.sum(result.hammer_blow * np.cos(phi - np.radians(result.hammer_blow_at)), axis=-1)
    np.testing.assert_allclose(pressing, -result.shaking_force_y[0], rtol=0, atol=1e-9 * np.max(np.abs(pressing)))


def test_the_answer_says_it():
    said = " ".join(run().page().split())
    assert "hammer blow 36.85 kN of the wheel's load 43.35 % lifts its wheel at 364.5 rpm" in said


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ('[balance.wheel.left]\nz = "1750 mm"\nload = "85 kN"\n', "", "must be two"),
        ('z = "1750 mm"', 'z = "250 mm"', "another place"),
        ('load = "85 kN"', 'load = "0 kN"', "load"),
        ('load = "85 kN"', 'load = "85 kg"', "load"),
        ('spacing = "2000 mm"\n', "", "spacing"),
    ],
)
def test_wheels_that_are_no_axle_are_refused(old, new, words):
    text = LOCOMOTIVE.format(rotation="clockwise", balance='counterweights = "rotating"', more="").replace(old, new)
    with pytest.raises(ct.InputError, match=words):
        ct.run(ct.Machine(**tomllib.loads(text)))
