"""Balance of whole machines: closed forms of known engines, what weights do, and what a check would notice."""

from dataclasses import replace

import numpy as np
import pytest
from tests.machines import RADIUS, ROD, V12, banks, slave, slider, throws
from tests.told import line_of, lines_of, texts_of

import cranktrain as ct
from cranktrain.analysis.parts import parts_of
from cranktrain.layout.crank_angle import HIGHEST_ORDER, CrankAngle
from cranktrain.layout.frames import Frames
from cranktrain.layout.masses import Masses
from cranktrain.layout.mechanisms import Mechanisms
from cranktrain.layout.shafts import Throws
from cranktrain.questions.balance.frame_forces import frame_forces
from cranktrain.questions.forces.carriers import Carriers
from cranktrain.questions.torque.rod_harmonics import acceleration_harmonics

SPEED = 100.0
AT = {"speed": f"{SPEED!r} rad/s", "spacing": "100 mm"}
PISTON = {"piston": {"mass": "1 kg"}}
CRANK = {"crank": {"mass": "2 kg", "along": "30 mm", "across": "5 mm", "inertia": "0.01 kg*m^2"}}
UNIT = RADIUS * SPEED**2
A = np.abs(acceleration_harmonics(RADIUS / ROD, HIGHEST_ORDER))
EIGHT = {"shaft": throws(0, 90, 270, 180, **AT), "bank": banks(L=-45, R=45), "masses": PISTON}


def run(balance=None, **declared):
    result = ct.run(ct.Machine(balance=balance, **declared))
    assert [check for check in result.checks if not np.all(check.passed)] == []
    return result


def four(balance=None, **fields):
    return run(
        balance, shaft=throws(0, 180, 180, 0, **AT), bank={"A": {"mechanism": slider()}}, masses=PISTON, **fields
    )


def test_lanchester():
    found = four({"shafts": [{"order": 2}]})
    without, left = found.shaking_force_largest
    np.testing.assert_allclose(without[[1, 3, 5]], 4 * UNIT * A[[2, 4, 6]], rtol=1e-10)
    np.testing.assert_allclose(found.balance_weight_moment, RADIUS * A[2] / 2, rtol=1e-12)
    np.testing.assert_array_equal(found.balance_weight_ratio, [2, -2])
    np.testing.assert_allclose(found.balance_weight_position, 0.15)
    assert left[1] < 1e-9 * UNIT
    np.testing.assert_array_equal(np.delete(left, 1), np.delete(without, 1))
    force, left_of_force, couple = lines_of(found, "Balance")[:3]
    assert force.startswith("shaking force: order 2: ")
    assert left_of_force.startswith("left with [balance]: order 4: ")
    assert couple == "shaking couple: none"


def test_heights_of_lanchesters_shafts():
    # The forward shaft higher by R/A_2 takes the second order of roll away, 2.0005… at λ = ¼; the gas's would remain.
    height = float(RADIUS / A[2])
    flat = four({"shafts": [{"order": 2}]}).rolling_moment
    np.testing.assert_array_equal(flat[0], flat[1])
    pair = {"order": 2, "forward": ["30 mm", f"{height - 0.1!r} m"], "backward": ["-30 mm", "-0.1 m"]}
    before, after = four({"shafts": [pair]}).rolling_moment
    turn = np.exp(-2j * np.arange(360) * np.pi / 180)
    second = [abs(np.mean(curve * turn)) * 2 for curve in (before, after)]
    assert second[0] == pytest.approx(2 * UNIT * RADIUS, rel=1e-3)
    assert second[1] < 1e-3 * second[0]


@pytest.mark.parametrize("planes", [None, ["-60 mm", "360 mm"]])
@pytest.mark.parametrize("running", ["ahead", "astern"])
@pytest.mark.parametrize("rotation", ["clockwise", "anticlockwise"])
def test_counterweights_of_a_cross_plane_v8(planes, running, rotation):
    # Each throw's two pistons are as a turning mass of one: with half of both the couple has gone.
    balance = {"counterweights": "rotating", "share": 0.5} | ({"planes": planes} if planes else {})
    found = run(balance, **EIGHT, running=running, rotation=rotation)
    couple = found.shaking_couple_largest / UNIT
    assert couple[0, 0] == pytest.approx(np.sqrt(10) * 0.1, rel=1e-10)
    assert np.max(couple[1]) < 1e-10
    if planes is None:
        np.testing.assert_allclose(found.balance_weight_moment, RADIUS, rtol=1e-10)
        # opposite their throws, ahead and astern: it is the same metal
        np.testing.assert_allclose(np.degrees(found.balance_weight_angle) % 360, [180, 270, 90, 0], atol=1e-9)
    else:
        np.testing.assert_allclose(found.balance_weight_moment, np.sqrt(10) * 0.1 * RADIUS / 0.42, rtol=1e-10)
        np.testing.assert_allclose(found.balance_weight_position, [-0.06, 0.36], rtol=1e-12)


@pytest.mark.parametrize("share", [0.0, 0.3, 0.5, 1.0])
def test_one_cylinder_with_a_share_of_its_mass(share):
    # semi-axes 1 − κ and κ, whatever the crank has of its own
    found = run(
        {"counterweights": "rotating", "share": share},
        shaft=throws(0, **AT),
        mechanism=slider(),
        masses=PISTON | CRANK,
        angle="20 deg",
    )
    ellipse = found.shaking_force_largest[1, 0], found.shaking_force_smallest[1, 0]
    assert ellipse == pytest.approx((max(share, 1 - share) * UNIT, min(share, 1 - share) * UNIT), abs=1e-9 * UNIT)
    if share != 0.5:
        along = 20 if share < 0.5 else -70
        assert np.degrees(found.shaking_force_direction[1, 0]) == pytest.approx(along, abs=1e-7)
    else:
        assert np.isnan(found.shaking_force_direction[1, 0])
        assert found.shaking_force_forward[1, 0] < 1e-9 * UNIT


def test_least_force_of_one_cylinder():
    found = run({"counterweights": "least_force"}, shaft=throws(0, **AT), mechanism=slider(), masses=PISTON)
    largest = [np.max(np.hypot(x, y)) for x, y in zip(found.shaking_force_x, found.shaking_force_y, strict=True)]
    assert largest[1] < largest[0]
    for share in (0.4, 0.5, 0.6, 0.7):
        other = run(
            {"counterweights": "rotating", "share": share}, shaft=throws(0, **AT), mechanism=slider(), masses=PISTON
        )
        assert largest[1] <= np.max(np.hypot(other.shaking_force_x[1], other.shaking_force_y[1])) * (1 + 1e-4)


@pytest.mark.parametrize("running", ["ahead", "astern"])
def test_given_weight(running):
    # 1 kg at 50 mm, 30° ahead of throw 1, which at angle 0 points along the bank, 40° clockwise from Y
    weight = {"mass": "1 kg", "radius": "50 mm", "angle": "30 deg", "z": "250 mm"}
    found = run(
        {"weight": [weight]},
        shaft=throws(0, 180, **AT),
        bank={"A": {"angle": "40 deg", "mechanism": slider()}},
        masses=PISTON,
        running=running,
    )
    added = [curve[1] - curve[0] for curve in (found.shaking_force_x, found.shaking_force_y)]
    sense = 1 if running == "ahead" else -1
    at = np.radians(70 + sense * np.arange(360))
    np.testing.assert_allclose(added, UNIT * np.array([np.sin(at), np.cos(at)]), atol=1e-9 * UNIT)
    # 0.2 m from the middle of both throws
    couple = found.shaking_couple_x[1] - found.shaking_couple_x[0]
    np.testing.assert_allclose(couple, 0.2 * added[0], atol=1e-10 * UNIT)
    assert np.degrees(found.balance_weight_angle) == pytest.approx([30])


def test_given_weight_stands_opposite_its_throw():
    found = run(
        {"weight": [{"mass": "2 kg", "radius": "10 mm", "throw": 2}]},
        shaft=throws(0, 70, **AT),
        bank={"A": {"mechanism": slider()}},
        masses=PISTON,
    )
    assert np.degrees(found.balance_weight_angle) % 360 == pytest.approx([250])
    assert found.balance_weight_position == pytest.approx([0.1])
    assert found.labels["weight"] == ("given_1",)


def test_given_shaft_does_what_a_solved_one_does():
    solved = four({"shafts": [{"order": 2}]})
    weights = [
        {"mass": "1 kg", "radius": f"{moment!r} m", "angle": f"{angle!r} rad", "z": "150 mm", "ratio": ratio}
        for moment, angle, ratio in zip(
            solved.balance_weight_moment.tolist(), solved.balance_weight_angle.tolist(), (2, -2), strict=True
        )
    ]
    given = four({"weight": weights})
    np.testing.assert_allclose(given.shaking_force_y, solved.shaking_force_y, atol=1e-9 * UNIT)


def test_couple_shafts_of_a_three():
    # The first-order couple of a three, half of it turning back: counterweights take one half, a pair of shafts all.
    declared = {"shaft": throws(0, 240, 120, **AT), "bank": {"A": {"mechanism": slider()}}, "masses": PISTON}
    planes = ["-50 mm", "250 mm"]
    found = run({"shafts": [{"order": 1, "against": "couple", "planes": planes}]}, **declared)
    couple = found.shaking_couple_largest / UNIT
    assert couple[0, 0] == pytest.approx(2 * 0.0866025403784, rel=1e-9)
    assert couple[1, 0] < 1e-10
    assert couple[1, 1] == pytest.approx(couple[0, 1])
    half = run({"counterweights": "rotating", "share": 0.5}, **declared)
    assert half.shaking_couple_forward[1, 0] < 1e-10 * UNIT
    assert half.shaking_couple_backward[1, 0] == pytest.approx(0.0866025403784 * UNIT, rel=1e-9)


def test_articulated_rods_shake_in_the_third_order():
    # (none where the knuckle stands as far from the master rod as the banks from each other)
    rods = {"R": {"angle": "60 deg", "mechanism": slave("L", articulation_angle="67 deg")}}
    plain = run(shaft=throws(0, **AT), bank=banks(L=0, R=60), masses=PISTON)
    linked = run(shaft=throws(0, **AT), bank=banks(L=0) | rods, masses=PISTON)
    assert plain.shaking_force_largest[0, 2] < 1e-10 * UNIT
    assert linked.shaking_force_largest[0, 2] > 1e-3 * UNIT


@pytest.mark.parametrize("lead", [0.0, 12.0])
@pytest.mark.parametrize("ratio", [1, -1])
def test_opposed_pistons(lead, ratio):
    # Both masses on one line, one behind the other: 2 sin(nΔ/2) of each order is left along it.
    found = run(
        shaft=throws(0, speed=AT["speed"]) | {"upper": {"ratio": ratio, "place": ["0 mm", "800 mm"]}},
        bank={
            "A": {
                "exhaust": {"mechanism": slider()},
                "scavenge": {"mechanism": slider(), "shaft": "upper"},
                "lead": f"{lead!r} deg",
            }
        },
        masses=PISTON,
    )
    order = np.arange(1, HIGHEST_ORDER + 1)
    left = 2 * UNIT * A[1:] * np.abs(np.sin(order * np.radians(lead) / 2))
    np.testing.assert_allclose(found.shaking_force_largest[0], left, atol=1e-9 * UNIT)
    np.testing.assert_allclose(found.shaking_force_x, 0, atol=1e-9 * UNIT)
    if lead == 0:
        assert line_of(found, "Balance", "shaking force") == "none"
    else:
        assert np.degrees(found.shaking_force_direction[0, 0]) == pytest.approx(0, abs=1e-7)


def test_counterweights_on_both_shafts():
    found = run(
        {"counterweights": "rotating"},
        shaft=throws(0, speed=AT["speed"]) | {"upper": {"ratio": -1, "place": ["0 mm", "800 mm"]}},
        bank={
            "A": {
                "exhaust": {"mechanism": slider()},
                "scavenge": {"mechanism": slider(), "shaft": "upper"},
                "lead": "25 deg",
            }
        },
        masses=CRANK,
    )
    assert found.shaking_force_largest[0, 0] > 0.1 * UNIT
    assert np.max(found.shaking_force_largest[1]) < 1e-10 * UNIT
    assert found.labels["weight"] == ("throw_1", "throw_upper.1")
    np.testing.assert_array_equal(found.balance_weight_ratio, [1, -1])
    np.testing.assert_allclose(found.balance_weight_moment, 2 * np.hypot(0.03, 0.005), rtol=1e-10)
    # what shakes no more rolls no more: nothing else has momentum
    np.testing.assert_allclose(found.rolling_moment[1], 0, atol=1e-10 * UNIT)
    assert np.max(np.abs(found.rolling_moment[0])) > 0.01 * UNIT


def test_gas_weights_and_friction_shake_nothing():
    plain = {**V12, "masses": PISTON | CRANK}
    gas = {
        "kind": "otto",
        "start_pressure": "95 kPa",
        "compression_exponent": 1.35,
        "expansion_exponent": 1.27,
        "pressure_ratio": 3.6,
    }
    bare = run(**plain)
    loaded = run(**plain, gas=gas, gravity=True, friction={"piston": 0.1})
    for name in ("shaking_force_x", "shaking_force_y", "shaking_couple_x", "shaking_couple_y"):
        np.testing.assert_array_equal(getattr(bare, name), getattr(loaded, name))
    # and the gas rolls the frame by minus its torque
    pressed = run(**plain, gas=gas)
    np.testing.assert_allclose(
        pressed.rolling_moment[0] - bare.rolling_moment[0],
        pressed.driving_torque - bare.driving_torque,
        atol=1e-9 * np.max(np.abs(pressed.driving_torque)),
    )


def test_weights_on_the_crank_roll_the_drive_and_not_the_frame():
    # 3 kg at 200 mm: what holds them up is the drive, not the frame, whose bearing feels no moment.
    found = run(
        shaft=throws(0, speed="1 rad/s"),
        mechanism=slider(),
        masses={"crank": {"mass": "3 kg", "along": "200 mm", "inertia": "0 kg*m^2"}},
        gravity=True,
    )
    np.testing.assert_allclose(found.rolling_moment, 0, atol=1e-12)
    assert np.max(np.abs(found.driving_torque)) == pytest.approx(3 * 9.80665 * 0.2, rel=1e-12)


@pytest.mark.parametrize("step", [0.5, 7.5, 30.0])
def test_orders_do_not_hang_on_the_step(step):
    fine = run(**{**V12, "masses": PISTON | CRANK})
    coarse = ct.run(ct.Machine(**V12, masses=PISTON | CRANK), step_degrees=step)
    for name in ("shaking_force_forward", "shaking_force_backward", "shaking_force_largest"):
        np.testing.assert_allclose(getattr(coarse, name), getattr(fine, name), atol=1e-8)


def test_half_orders_of_a_four_stroke_are_nothing():
    found = run(**{**V12, "masses": PISTON})
    assert found.labels["order"][:3] == ("0.5", "1", "1.5")
    np.testing.assert_array_equal(found.shaking_force_largest[:, ::2], 0)
    assert found.shaking_force_largest[0, 5] > UNIT * 1e-3


def test_shown_angle_does_not_turn_what_is_found():
    balance = {"counterweights": "rotating", "share": 0.5, "shafts": [{"order": 1}]}
    declared = {"shaft": throws(0, 90, **AT), "bank": banks(L=-45, R=10), "masses": PISTON}
    plain = run(balance, **declared)
    moved = run(balance, **declared, crank_zero="90 deg")
    for name in ("balance_weight_moment", "balance_weight_angle", "shaking_force_largest", "shaking_force_direction"):
        np.testing.assert_allclose(getattr(moved, name), getattr(plain, name), atol=1e-8)
    np.testing.assert_allclose(moved.shaking_force_x, np.roll(plain.shaking_force_x, -90, axis=-1), atol=1e-8)


def test_designs():
    machines = [
        ct.Machine(
            **{**EIGHT, "masses": {"piston": {"mass": mass}}}, balance={"counterweights": "rotating", "share": 1}
        )
        for mass in ("1 kg", "3 kg")
    ]
    found = ct.run(machines)
    np.testing.assert_allclose(3 * found.balance_weight_moment[0], found.balance_weight_moment[1], rtol=1e-12)
    np.testing.assert_allclose(3 * found.shaking_couple_x[0], found.shaking_couple_x[1], atol=1e-9 * UNIT)


@pytest.mark.parametrize("balance", [None, {"counterweights": "rotating"}])
@pytest.mark.parametrize("name", ["shaking_force_x", "shaking_couple_largest", "rolling_moment"])
def test_each_quantity_alone_has_its_labels(name, balance):
    found = ct.run(ct.Machine(**EIGHT, balance=balance), quantities=[name])
    labels = found.labels_of(found.catalogue[name])
    assert labels["balance"] == (("without", "with") if balance else ("without",))
    assert getattr(found, name).shape[0] == len(labels["balance"])


def test_without_spacing_the_couple_is_missing():
    result = ct.run(
        ct.Machine(shaft=throws(0, 180, speed="1 rad/s"), bank={"A": {"mechanism": slider()}}, masses=PISTON)
    )
    assert ("[shaft.main] spacing",) in [
        texts_of(missing.needs) for missing in result.missing if "shaking_couple_x" in missing.results
    ]
    assert "shaking_force_x" in result.catalogue


def check_of(**changes):
    """The momentum's check, with parts of the machine put wrong."""
    machine = ct.Machine(**V12, masses=PISTON | CRANK)
    parts = parts_of([machine], step=np.pi / 180)
    needs = {kind: parts[kind] for kind in (Mechanisms, Carriers, Masses, Frames, Throws, CrankAngle)}
    needs |= {type(part): part for part in changes.values()}
    return frame_forces(*needs.values()).checks[0], parts


def test_check_of_momentum_can_fail():
    check, parts = check_of()
    assert np.all(check.passed)
    assert check.residual[0] < 1e-12
    # a slave that loads nothing
    free = replace(parts[Carriers], master=np.full_like(parts[Carriers].master, -1))
    assert not np.any(check_of(carriers=free)[0].passed)
    # a bank that stands 1e-9 from where its rods hang
    turned = replace(parts[Frames], direction=parts[Frames].direction + np.repeat([0.0, 1e-9], 6))
    assert not np.any(check_of(frames=turned)[0].passed)


BAD = [
    ({"share": 0.5}, {"balance.share"}),
    ({"counterweights": "least_force", "share": 0.5}, {"balance.share"}),
    ({"counterweights": "rotating", "share": 1.5}, {"balance.share"}),
    ({"counterweights": "all"}, {"balance.counterweights"}),
    ({"planes": ["0 mm", "1 mm"]}, {"balance.planes"}),
    ({"counterweights": "rotating", "planes": ["1 mm", "1 mm"]}, {"balance.planes[1]"}),
    ({"weight": [{"mass": "1 kg", "radius": "1 mm"}]}, {"balance.weight[0].z", "balance.weight[0].angle"}),
    (
        {"weight": [{"mass": "1 kg", "radius": "1 mm", "throw": 1, "z": "1 mm", "ratio": 2}]},
        {"balance.weight[0].ratio"},
    ),
    ({"weight": [{"mass": "1 kg", "radius": "1 mm", "throw": 9}]}, {"balance.weight[0].throw"}),
    (
        {"weight": [{"mass": "0 kg", "radius": "-1 mm", "throw": 1}]},
        {"balance.weight[0].mass", "balance.weight[0].radius"},
    ),
    (
        {"weight": [{"mass": "1 kg", "radius": "1 mm", "angle": "0 deg", "z": "0 mm", "ratio": 0}]},
        {"balance.weight[0].ratio"},
    ),
    ({"shafts": [{"order": 0}, {"order": HIGHEST_ORDER + 1}]}, {"balance.shafts[0].order", "balance.shafts[1].order"}),
    ({"shafts": [{"order": 1, "planes": ["0 mm", "1 mm"]}]}, {"balance.shafts[0].planes"}),
    ({"shafts": [{"order": 1, "against": "couple", "planes": "0 mm"}]}, {"balance.shafts[0].planes"}),
    ({"shafts": [{"order": 1, "against": "roll"}]}, {"balance.shafts[0].against"}),
    ({"shaft": []}, {"balance.shaft"}),
]


@pytest.mark.parametrize(("balance", "paths"), BAD)
def test_bad_input(balance, paths):
    with pytest.raises(ct.InputError) as error:
        ct.run(ct.Machine(balance=balance, **EIGHT))
    assert {problem.path for problem in error.value.problems} == paths


def test_couples_need_a_spacing():
    balance = {
        "counterweights": "rotating",
        "planes": ["0 mm", "100 mm"],
        "shafts": [{"order": 1, "against": "both", "planes": ["0 mm", "100 mm"]}],
    }
    machine = {"shaft": throws(0, 90, speed="1 rad/s"), "bank": banks(A=0), "masses": PISTON}
    with pytest.raises(ct.InputError) as error:
        ct.run(ct.Machine(balance=balance, **machine))
    paths = {problem.path for problem in error.value.problems}
    assert paths == {"balance.planes", "balance.shafts[0].against"}


def test_a_sector_is_its_mass_at_its_centroid():
    """Half a disc of steel: 7850 t πr²/2 at 4r/3π; and one that a smaller half leaves empty within."""

    def moments(sector):
        weights = [{"throw": 1, "sector": {"opening": "180 deg", "thickness": "20 mm", **sector}}]
        result = ct.run(ct.Machine(**{**EIGHT, "balance": {"weight": weights}}))
        return result.dataset.balance_weight_moment.values

    def half(radius):
        return 7850 * 0.02 * np.pi * radius**2 / 2 * 4 * radius / (3 * np.pi)

    np.testing.assert_allclose(moments({"outer_radius": "90 mm"}), half(0.09), rtol=1e-14)
    own = moments({"outer_radius": "90 mm", "inner_radius": "40 mm", "density": "7850 kg/m³"})
    np.testing.assert_allclose(own, half(0.09) - half(0.04), rtol=1e-14)


def test_a_weight_on_one_web_of_a_throw():
    """With `z` beside `throw` it is opposite the throw, and its couple is that of its own place."""
    one = {"mass": "1 kg", "radius": "50 mm", "throw": 2, "z": "125 mm"}
    other = {"mass": "1 kg", "radius": "50 mm", "angle": "270 deg", "z": "125 mm"}
    each = [ct.run(ct.Machine(**{**EIGHT, "balance": {"weight": [weight]}})).dataset for weight in (one, other)]
    for name in ("shaking_force_x", "shaking_couple_x", "shaking_couple_y"):
        size = np.max(np.abs(each[1][name].values))
        np.testing.assert_allclose(each[0][name].values, each[1][name].values, rtol=0, atol=1e-13 * size)


@pytest.mark.parametrize(
    ("weight", "sentences"),
    [
        (
            {"throw": 1},
            [
                f"balance.weight[0].{name}: is missing; or give the weight's shape, its sector"
                for name in ("mass", "radius")
            ],
        ),
        (
            {
                "throw": 1,
                "mass": "1 kg",
                "sector": {"outer_radius": "90 mm", "opening": "90 deg", "thickness": "9 mm"},
            },
            ["balance.weight[0].mass = 1 kg: must not stand beside sector, which says it"],
        ),
        (
            {
                "throw": 1,
                "sector": {
                    "outer_radius": "90 mm",
                    "inner_radius": "90 mm",
                    "opening": "90 deg",
                    "thickness": "9 mm",
                },
            },
            ["balance.weight[0].sector.inner_radius = 90 mm: must be less than outer_radius = 90 mm"],
        ),
    ],
)
def test_a_weight_has_one_size(weight, sentences):
    with pytest.raises(ct.InputError) as refused:
        ct.Machine(**{**EIGHT, "balance": {"weight": [weight]}})
    assert [str(problem) for problem in refused.value.problems] == sentences
