"""Linkages that come through change points: parallelograms, crossed ones, kites, coupling rods; and what they bear.

Joints are found anew as mirror images of points, with complex numbers and 40 digits, which know no branch.
"""

import tomllib

import mpmath
import numpy as np
import pytest

import cranktrain as ct

HEAD = """
name = "Four links"
rotation = "anticlockwise"
[shaft.main]
speed = "60 rpm"
"""

BAR = (
    HEAD
    + """
[mechanism]
kind = "crank_rocker"
crank_radius = "{crank} mm"
rod_length = "{rod} mm"
rocker_length = "{rocker} mm"
ground_length = "{ground} mm"
{more}
"""
)

CHAIN = (
    HEAD
    + """
[mechanism]
kind = "chain"
output = "{output}"
[mechanism.fixed]
D = ["300 mm", "0 mm"]
E = ["300 mm", "400 mm"]
[mechanism.crank.main]
radius = "100 mm"
"""
)
PART = """
[[mechanism.part]]
type = "pin"
rod = {{ name = "{rod[0]}", from = "{rod[1]}", length = "{rod[2]} mm" }}
rocker = {{ name = "{rocker[0]}", from = "{rocker[1]}", length = "{rocker[2]} mm" }}
joint = "{joint}"
side = "{side}"
"""
PLATE = """
[mechanism.points.corner]
link = "rod"
along = "150 mm"
across = "150 mm"
"""


def machine(text):
    return ct.Machine(**tomllib.loads(text))


def bar(crank, rod, rocker, ground, more=""):
    return machine(BAR.format(crank=crank, rod=rod, rocker=rocker, ground=ground, more=more))


def chain(*parts, output="rocker", more=""):
    return machine(CHAIN.format(output=output) + "".join(PART.format(**part) for part in parts) + more)


ONE = {"rod": ("rod", "main.pin", 300), "rocker": ("rocker", "D", 100), "joint": "C", "side": "right"}


def mirrored(point, start, end):
    """Mirror image of a point about the line through two others."""
    way = end - start
    return start + mpmath.conj((point - start) / way) * way


def coefficients(joint, degrees):
    """Place of a joint and its two derivatives by the crank angle."""
    with mpmath.workdps(40):
        return [complex(mpmath.diff(joint, mpmath.radians(degrees), n)) for n in range(3)]


def crossed(phi):
    """Joint of the crossed parallelogram of 100 and 300 mm."""
    pin = mpmath.expj(phi) / 10
    return mirrored(pin + mpmath.mpf(3) / 10, pin, mpmath.mpf(3) / 10)


def kite(phi):
    """Joint of the kite of 100 and 300 mm: the shaft mirrored about the line from pin to pivot."""
    return mirrored(mpmath.mpc(0), mpmath.expj(phi) / 10, mpmath.mpf(3) / 10)


def joint_of(result, name="C"):
    place = result.labels["point"].index(f"1.{name}")
    return [
        result.__getattr__(f"point_x{what}")[place] + 1j * result.__getattr__(f"point_y{what}")[place]
        for what in ("", "_velocity_coefficient", "_acceleration_coefficient")
    ]


@pytest.mark.parametrize("side", ["left", "right"])
@pytest.mark.parametrize("swapped", [False, True])
def test_joint_of_a_parallelogram_is_the_crank_pin_moved(side, swapped):
    """Crank pin + (300, 0) mm at every angle, whatever side says, whichever of the two links is called the rod."""
    part = ONE | {"side": side}
    if swapped:
        part |= {"rod": ("rocker", "D", 100), "rocker": ("rod", "main.pin", 300)}
    result = ct.run(chain(part, more=PLATE))
    phi = np.radians(np.arange(360.0))
    pin = 0.1 * np.exp(1j * phi)
    for found, expected in zip(joint_of(result), (pin + 0.3, 1j * pin, -pin), strict=True):
        np.testing.assert_allclose(found, expected, rtol=0, atol=1e-15)
    np.testing.assert_allclose(joint_of(result, "corner")[0], pin + 0.15 + 0.15j, rtol=0, atol=1e-15)
    assert result.closing_margin[0] == 0.0


def test_a_crank_rocker_is_the_same_parallelogram():
    result = ct.run(bar(100, 300, 100, 300))
    np.testing.assert_allclose(result.coupler_angle[0], 0.0, atol=1e-15)
    np.testing.assert_allclose(result.rocker_velocity_coefficient[0], 1.0, rtol=1e-14)
    np.testing.assert_allclose(result.rocker_acceleration_coefficient[0], 0.0, atol=1e-14)
    said = result.page()
    assert "change points       0.0°, 180.0°; passed as a parallelogram" in said
    assert "rocker              turns all round" in said


@pytest.mark.parametrize(
    ("lengths", "more", "joint"),
    [((100, 300, 100, 300), "crossed = true", crossed), ((100, 100, 300, 300), "", kite)],
)
def test_mirrored_forms_have_the_mirror_image_of_a_point(lengths, more, joint):
    """Angles of rod and rocker and both derivatives, at change points too, against 40 digits."""
    result = ct.run(bar(*lengths, more))
    for degrees in (0, 1, 37, 90, 179, 180, 181, 250, 359):
        place, first, second = coefficients(joint, degrees)
        pin = 0.1 * np.exp(1j * np.radians(degrees))
        for name, arm, v, a in (
            ("coupler", place - pin, first - 1j * pin, second + pin),
            ("rocker", place - 0.3, first, second),
        ):
            turn = (v / arm).imag
            turn_rate = (a / arm).imag - 2 * (v / arm).real * (v / arm).imag
            told = [
                getattr(result, f"{name}{what}")[0, degrees]
                for what in ("_angle", "_velocity_coefficient", "_acceleration_coefficient")
            ]
            assert np.exp(1j * told[0]) == pytest.approx(arm / abs(arm), abs=1e-14)
            assert told[1:] == pytest.approx([turn, turn_rate], abs=2e-14)


def test_a_kite_swings_its_rocker_twice_as_far_as_the_line_of_its_ends():
    """That line swings by ± arcsin r/g, where cos φ = r/g."""
    result = ct.run(bar(100, 100, 300, 300))
    assert np.degrees(result.swing[0]) == pytest.approx(4 * np.degrees(np.arcsin(1 / 3)), rel=1e-12)
    at = np.degrees(np.arccos(1 / 3))
    assert result.time_ratio[0] == pytest.approx((360 - 2 * at) / (2 * at), rel=1e-9)


def test_a_kite_on_a_short_ground_turns_its_rocker_twice_a_turn():
    """Ground and rocker 100, crank and rod 300 mm: the mean of θ′ over the turn is 2."""
    result = ct.run(bar(300, 300, 100, 100))
    assert np.mean(result.rocker_velocity_coefficient[0]) == pytest.approx(2.0, rel=1e-12)


def test_coupling_rods_hang_on_one_another():
    """Three wheels, the third up and over: rods stay parallel, joints are crank pin + (300, 0), + (300, 400) mm."""
    second = {"rod": ("rod2", "C", 400), "rocker": ("wheel", "E", 100), "joint": "F", "side": "left"}
    result = ct.run(chain(ONE, second))
    pin = 0.1 * np.exp(1j * np.radians(np.arange(360.0)))
    np.testing.assert_allclose(joint_of(result)[0], pin + 0.3, rtol=0, atol=1e-15)
    np.testing.assert_allclose(joint_of(result, "F")[0], pin + 0.3 + 0.4j, rtol=0, atol=2e-15)
    assert "0.0°, 90.0°, 180.0°, 270.0°; passed as a parallelogram: C, F" in " ".join(result.page().split())


def test_a_parallelogram_that_passes_no_change_point_keeps_its_side():
    """On a lever that swings without coming into line the branch is that of the side, and the margin is not 0."""
    lever = {"rod": ("pitman", "main.pin", 350), "rocker": ("lever", "D", 250), "joint": "B", "side": "left"}
    is_parallel = []
    for side in ("left", "right"):
        second = {"rod": ("rod", "B", 400), "rocker": ("follower", "E", 250), "joint": "F", "side": side}
        parts = "".join(PART.format(**part) for part in (lever, second))
        text = CHAIN.format(output="follower").replace('E = ["300 mm", "400 mm"]', 'E = ["700 mm", "0 mm"]')
        result = ct.run(machine(text + parts))
        assert result.closing_margin[0] > 1e-3
        apart = joint_of(result, "F")[0] - joint_of(result, "B")[0] - 0.4
        is_parallel.append(np.max(np.abs(apart)) < 1e-13)
    assert sorted(is_parallel) == [False, True]


@pytest.mark.parametrize("lengths", [(100, 200, 400, 300), (300, 400, 200, 100), (100, 300.0001, 100, 300)])
def test_other_equal_sums_and_near_ones_are_refused(lengths):
    with pytest.raises(ct.InputError, match="nothing says which way they go on"):
        ct.run(bar(*lengths))


@pytest.mark.parametrize("lengths", [(100, 360, 280, 400), (100, 100, 300, 300)])
def test_what_is_no_parallelogram_is_not_crossed(lengths):
    with pytest.raises(ct.InputError, match="parallelogram"):
        bar(*lengths, "crossed = true")


@pytest.mark.parametrize(
    ("lengths", "said"),
    [
        ((100, 299.99, 100, 300), "must be 300 mm, for a parallelogram"),
        ((300, 301, 100, 100), "must be 300 mm, for a kite"),
    ],
)
def test_a_rod_that_nearly_suits_is_told_which_does(lengths, said):
    with pytest.raises(ct.InputError, match=said):
        ct.run(bar(*lengths))


MASSES = """
[masses.rod]
mass = "20 kg"
along = "{along} mm"
across = "{across} mm"
inertia = "0.2 kg m2"
[masses.rocker]
mass = "5 kg"
along = "0 mm"
inertia = "0.05 kg m2"
"""


def loaded(along=150, across=0, more="", step=1.0, **options):
    text = BAR.format(crank=100, rod=300, rocker=100, ground=300, more="")
    text = text.replace("60 rpm", "300 rpm") + MASSES.format(along=along, across=across)
    return ct.run(machine(more + text), step_degrees=step, **options)


@pytest.mark.parametrize("step", [1.0, 0.1, 0.72])
@pytest.mark.parametrize("along", [150, 90])
def test_forces_at_change_points_are_limits(along, step):
    """The rocker turns evenly and bears only along itself: m R ω² c/l in its joint, the rest on the crank pin, always.

    At 0 and 180° this is 0/0; as close as 1e-5 rad the quotient has lost five digits.
    """
    result = loaded(along, step=step)
    force = 20 * 0.1 * (10 * np.pi) ** 2
    names = [name.partition(".")[2] for name in result.labels["joint"]]
    size = np.hypot(result.joint_force_x, result.joint_force_y)
    np.testing.assert_allclose(size[names.index("joint")], force * along / 300, rtol=1e-11)
    np.testing.assert_allclose(size[names.index("crank_pin")], force * (1 - along / 300), rtol=1e-11)
    assert result.largest_joint_force[names.index("joint")] == pytest.approx(force * along / 300, rel=1e-11)
    assert not result.flags


def test_what_links_in_line_cannot_hold_is_said():
    """The rod weighs across the line of the links: a moment is left at 0 and 180°. The torque is m g R cos φ."""
    result = loaded(more='gravity = { direction = "-90 deg" }\n')
    weight = 20 * 9.80665
    np.testing.assert_allclose(
        np.abs(result.driving_torque), weight * 0.1 * np.abs(np.cos(np.radians(np.arange(360.0)))), rtol=0, atol=1e-11
    )
    assert np.all(np.isnan(result.largest_joint_force))
    assert any("beyond all bounds" in str(flag) for flag in result.flags)
    verdicts = {check.name: str(check.verdict()) for check in result.checks}
    assert verdicts["torque"] == "forces go beyond all bounds at change points"


def test_designs_side_by_side_are_as_alone():
    designs = [loaded(along).largest_joint_force for along in (90, 150, 210)]
    together = ct.run(
        [
            machine(
                BAR.format(crank=100, rod=300, rocker=100, ground=300, more="").replace("60 rpm", "300 rpm")
                + MASSES.format(along=along, across=0)
            )
            for along in (90, 150, 210)
        ]
    )
    np.testing.assert_array_equal(together.largest_joint_force, designs)
