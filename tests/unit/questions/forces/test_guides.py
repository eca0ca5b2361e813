"""Lengths of guides in the machine file: forces of the edges, the friction that they make, and who has which."""

import numpy as np
import pytest
from tests.sentences import EDGES_ONLY, NOT_POSITIVE
from tests.told import texts_of
from tests.unit.questions.forces.test_friction import CHAIN

import cranktrain as ct
from cranktrain.io.any_machine import load

SPEED = 900 * 2 * np.pi / 60
YOKE = {
    "mechanism": {"kind": "scotch_yoke", "crank_radius": "50 mm"},
    "masses": {"piston": {"mass": "4 kg"}},
}
TRUNK = {
    "mechanism": {"kind": "slider_crank", "crank_radius": "50 mm", "rod_length": "180 mm"},
    "masses": {"piston": {"mass": "2 kg"}},
}
CYLINDER = {
    "mechanism": {"kind": "oscillating_cylinder", "crank_radius": "50 mm", "ground_length": "260 mm"},
    "masses": {
        "piston": {"mass": "2 kg", "along": "-90 mm", "inertia": "4e-3 kg·m²"},
        "cylinder": {"mass": "9 kg", "along": "40 mm", "inertia": "0.05 kg·m²"},
    },
}
LEVER = {
    "mechanism": {"kind": "slotted_lever", "crank_radius": "40 mm", "ground_length": "90 mm", "offset": "10 mm"},
    "masses": {
        "block": {"mass": "1 kg", "along": "5 mm", "inertia": "1e-3 kg·m²"},
        "rocker": {"mass": "9 kg", "along": "60 mm", "inertia": "0.02 kg·m²"},
    },
}
GUIDED = {"length": "120 mm", "middle": "15 mm"}


def run(machine, **tables):
    return ct.run(ct.Machine(shaft={"main": {"speed": "900 rpm"}}, **machine, **tables), step_degrees=0.5)


def of(result, name, mechanism="1"):
    """Forces of both edges of a guide, and what they press in all."""
    at = result.labels["guide"].index(f"{mechanism}.{name}")
    return result.guide_edge_force_ahead[at], result.guide_edge_force_behind[at], result.guide_pressing[at]


def test_a_scotch_yoke_by_hand():
    """Massless but for its slider, which the crank pin pushes at t = R sin φ beside the guide.

    m s̈ = −mRω² cos φ = F − σμ(2|tF|/b): F is positive where s̈ is, and friction against s′ = −R sin φ.
    """
    result = run(YOKE, friction={"piston": 0.15}, guide={"piston": {"length": "120 mm"}})
    phi = np.radians(result.crank_angle)
    place, inertia = 0.05 * np.sin(phi), 4.0 * 0.05 * SPEED**2 * -np.cos(phi)
    rub = 0.15 * np.sign(-place) * 2 * np.abs(place) / 0.12
    force = inertia / (1 - rub * np.sign(inertia))
    moving = np.abs(place) > 1e-9
    ahead, behind, pressing = of(result, "piston")
    # Pushed along +x at +y the slider would turn to the right: the edge ahead of it presses to the left.
    np.testing.assert_allclose(ahead[moving], (force * place / 0.12)[moving], rtol=0, atol=1e-9)
    np.testing.assert_allclose(behind, -ahead, rtol=0, atol=1e-9)
    np.testing.assert_allclose(pressing, 2 * np.abs(ahead), rtol=0, atol=1e-9)
    torque = -force * 0.05 * np.sin(phi)
    np.testing.assert_allclose(result.driving_torque[moving], torque[moving], rtol=0, atol=1e-9)
    # Between two points of the grid, by the same closed form on a grid ten thousand times as fine.
    near = np.radians(result.largest_guide_edge_force_at[0] + np.linspace(-1, 1, 20001))
    travel, accelerated = 0.05 * np.sin(near), 4.0 * 0.05 * SPEED**2 * -np.cos(near)
    rubbing = 0.15 * np.sign(-travel) * 2 * np.abs(travel) / 0.12 * np.sign(accelerated)
    largest = np.max(np.abs(accelerated / (1 - rubbing) * travel / 0.12))
    assert largest > np.max(np.abs([ahead, behind])) * (1 + 1e-6)
    assert result.largest_guide_edge_force[0] == pytest.approx(largest, rel=1e-8)


def test_a_pin_off_the_middle_of_its_skirt():
    """Without friction N = −F tan β of the wall is shared as a beam on two supports shares it."""
    result = run(TRUNK, guide={"piston": {"length": "100 mm", "middle": "20 mm"}})
    phi = np.radians(result.crank_angle)
    sin = -0.05 * np.sin(phi) / 0.18
    cos = np.sqrt(1 - sin * sin)
    s = 0.05 * np.cos(phi) + 0.18 * cos
    second = -0.05 * np.cos(phi) - (
        0.05**2 * np.cos(2 * phi) + (0.05**2 * np.sin(2 * phi) / 2) ** 2 / (0.18 * cos) ** 2
    ) / (0.18 * cos)
    assert np.ptp(s) == pytest.approx(0.1)
    wall = -2.0 * second * SPEED**2 * sin / cos
    ahead, behind, pressing = of(result, "piston")
    # The pin stands 20 mm behind the middle: 70 mm from the edge ahead, 30 mm from the one behind.
    np.testing.assert_allclose(ahead, 0.3 * wall, rtol=0, atol=1e-9)
    np.testing.assert_allclose(behind, 0.7 * wall, rtol=0, atol=1e-9)
    np.testing.assert_allclose(pressing, np.abs(wall), rtol=0, atol=1e-9)


def test_a_bush_stands_still_where_its_slider_goes_by():
    """A yoke's rod in a bush about s = 200 mm bears N at a distance that changes; a leaning slot gives N."""
    yoke = YOKE | {"mechanism": YOKE["mechanism"] | {"slot_angle": "70 deg"}}
    result = run(yoke, guide={"piston": {"length": "60 mm", "at": "200 mm"}})
    at = result.labels["joint"].index("1.guide")
    normal, moment = result.joint_force_y[at], result.joint_moment[at]
    phi, slot = np.radians(result.crank_angle), np.radians(70)
    slider = 0.05 * (np.cos(phi) - np.sin(phi) / np.tan(slot))
    ahead, behind, _ = of(result, "piston")
    np.testing.assert_allclose(ahead + behind, normal, rtol=0, atol=1e-9)
    turning = ahead * (0.23 - slider) + behind * (0.17 - slider)
    np.testing.assert_allclose(turning, moment, rtol=0, atol=1e-9)
    assert np.max(np.abs(normal)) > 100


def to_pivot(radius, ground, offset):
    """Rate of a slider on a crank's pin along a guide about a pivot: ρ² = R² + g² − 2Rg cos φ − e²."""

    def rate(_result, phi):
        return (
            ground
            * radius
            * np.sin(phi)
            / np.sqrt(radius**2 + ground**2 - 2 * radius * ground * np.cos(phi) - offset**2)
        )

    return rate


def of_chain(name):
    return lambda result, _phi: result.slider_velocity_coefficient[result.labels["slider"].index(f"1.{name}")]


def of_output(result, _phi):
    return result.piston_velocity_coefficient[0]


def of_yoke(_result, phi):
    return -0.05 * np.sin(phi)


def of_trunk(_result, phi):
    return -0.05 * np.sin(phi) - 0.05**2 * np.sin(2 * phi) / 2 / np.sqrt(0.18**2 - (0.05 * np.sin(phi)) ** 2)


@pytest.mark.parametrize(
    ("machine", "name", "joint", "rate"),
    [
        (YOKE, "piston", "guide", of_yoke),
        (TRUNK, "piston", "guide", of_trunk),
        (CYLINDER, "piston", "guide", to_pivot(0.05, 0.26, 0.0)),
        (LEVER, "block", "slot", to_pivot(0.04, 0.09, 0.01)),
        *((CHAIN, name, f"guide/{name}", of_chain(name)) for name in ("ram", "die", "shoe")),
        (CHAIN, "valve", "guide/valve", of_output),
    ],
    ids=["scotch_yoke", "slider_crank", "oscillating_cylinder", "slotted_lever", "yoke", "trammel", "shoe", "valve"],
)
def test_the_shaft_gives_what_both_edges_take(machine, name, joint, rate):
    """Over a turn the driving torque does the work of friction: μ(|N₊| + |N₋|) times the way of what slides."""
    result = run(machine, friction={name: 0.08}, guide={name: GUIDED}, gravity=True)
    (check,) = (check for check in result.checks if check.name == "torque")
    assert check.residual[0] <= 1e-12
    ahead, behind, pressing = of(result, name)
    lost = 0.08 * (np.abs(ahead) + np.abs(behind)) * np.abs(rate(result, np.radians(result.crank_angle)))
    assert np.mean(result.driving_torque) == pytest.approx(np.mean(lost), rel=1e-10)
    np.testing.assert_allclose(pressing, np.abs(ahead) + np.abs(behind), rtol=1e-15)
    moment = result.joint_moment[result.labels["joint"].index(f"1.{joint}")]
    np.testing.assert_allclose(0.075 * ahead - 0.045 * behind, moment, rtol=0, atol=1e-12 * np.max(pressing))
    assert not any("length is not given" in flag for flag in texts_of(result.flags))


@pytest.mark.parametrize("running", ["ahead", "astern"])
@pytest.mark.parametrize(
    "machine", [YOKE, TRUNK, CYLINDER, LEVER, CHAIN], ids=lambda machine: machine["mechanism"]["kind"]
)
def test_a_long_guide_is_as_one_without_length(machine, running):
    names = {"scotch_yoke": ["piston"], "slotted_lever": ["block"], "chain": ["ram", "die", "shoe", "valve"]}.get(
        machine["mechanism"]["kind"], ["piston"]
    )
    friction = dict.fromkeys(names, 0.08)
    long = run(machine, friction=friction, running=running, guide={name: {"length": "1e9 m"} for name in names})
    without = run(machine, friction=friction, running=running)
    assert "guide" not in without.labels
    np.testing.assert_allclose(
        long.driving_torque, without.driving_torque, rtol=0, atol=1e-9 * np.max(np.abs(without.driving_torque))
    )


def test_what_rubs_under_a_moment_without_a_length_is_named():
    sentence = (
        "A moment acts where {} slides, and the guide's length is not given:"
        " friction is counted on the normal force alone."
    )
    assert sentence.format("1.piston") in texts_of(run(YOKE, friction={"piston": 0.1}).flags)
    assert not any("length" in flag for flag in texts_of(run(TRUNK, friction={"piston": 0.1}).flags))
    assert not any("length" in flag for flag in texts_of(run(YOKE).flags))
    beside = YOKE["masses"] | {"block": {"mass": "1 kg", "along": "9 mm", "inertia": "1e-3 kg·m²"}}
    yoke = YOKE | {"masses": beside}
    assert sentence.format("1.block") in texts_of(run(yoke, friction={"block": 0.1}, gravity=True).flags)


def test_a_bank_may_have_its_own_guides():
    banks = {
        name: {"angle": angle, "mechanism": TRUNK["mechanism"]} for name, angle in (("L", "-30 deg"), ("R", "30 deg"))
    }
    banks["R"]["guide"] = {"piston": {"length": "100 mm", "middle": "-20 mm"}}
    machine = {"bank": banks, "masses": TRUNK["masses"]}
    own = run(machine)
    assert own.labels["guide"] == ("1R.piston",)
    both = run(machine, guide={"piston": {"length": "100 mm", "middle": "20 mm"}})
    assert both.labels["guide"] == ("1L.piston", "1R.piston")
    np.testing.assert_array_equal(both.guide_edge_force_ahead[1], own.guide_edge_force_ahead[0])
    ahead, behind, _ = of(both, "piston", "1L")
    np.testing.assert_allclose(7 * ahead, 3 * behind, rtol=0, atol=1e-9)
    ahead, behind, _ = of(both, "piston", "1R")
    np.testing.assert_allclose(3 * ahead, 7 * behind, rtol=0, atol=1e-9)


def refused(text, tmp_path):
    path = tmp_path / "machine.toml"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(ct.InputError) as error:
        ct.run(load(path))
    return str(error.value)


ROCKER = """\
[mechanism]
kind = "crank_rocker"
crank_radius = "100 mm"
rod_length = "360 mm"
rocker_length = "280 mm"
ground_length = "400 mm"
[masses.rocker]
mass = "3 kg"
along = "100 mm"
"""
SCOTCH = """\
[mechanism]
kind = "scotch_yoke"
crank_radius = "50 mm"
[masses.piston]
mass = "4 kg"
"""


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (SCOTCH + '[guide.piston]\nlength = "0 mm"\n', f":7:10  guide.piston.length = 0 mm: {NOT_POSITIVE} mm"),
        (SCOTCH + '[guide.piston]\nlength = "-9 mm"\n', f":7:10  guide.piston.length = -9 mm: {NOT_POSITIVE} mm"),
        (
            SCOTCH + '[guide.block]\nlength = "9 mm"\n',
            f":6:1  guide.block: {EDGES_ONLY}, which can bear a moment: piston",
        ),
        (
            ROCKER + '[guide.rocker]\nlength = "9 mm"\n',
            f":10:1  guide.rocker: {EDGES_ONLY}, which can bear a moment: nothing does",
        ),
        (
            SCOTCH + '[guide.piston]\nlength = "90 mm"\nmiddle = "1 mm"\nat = "2 mm"\n',
            ":9:6  guide.piston.at = 2 mm: must not stand beside middle: the edges go with the slider or stand still",
        ),
    ],
)
def test_what_a_guide_cannot_be_is_said_with_its_place(text, expected, tmp_path):
    assert expected in refused(text, tmp_path)


def test_a_guide_that_wedges_is_told_and_has_no_mean():
    """As a drawer that is pulled at its corner: from t = b/2μ = 40 mm of R = 50 mm on."""
    result = run(YOKE, friction={"piston": 0.1}, guide={"piston": {"length": "8 mm"}})
    place = 50 * np.abs(np.sin(np.radians(result.crank_angle)))
    np.testing.assert_array_equal(np.isnan(result.driving_torque), place >= 40)
    assert np.all(np.isnan(result.mean_torque))
    assert any(flag.startswith("Friction wedges 1:") for flag in texts_of(result.flags))
    free = run(YOKE, friction={"piston": 0.1}, guide={"piston": {"length": "12 mm"}})
    assert not np.any(np.isnan(free.driving_torque))
    assert not any("wedges" in flag for flag in texts_of(free.flags))
