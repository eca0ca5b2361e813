"""A machine's drawing as data: rigid links, straight guides, outputs as they are computed, of every throw and shaft."""

import json
import subprocess
import sys
from itertools import combinations

import numpy as np
import pytest
from tests.loaded_machines import LOADED
from tests.machines import RADIUS, ROCKER, ROD, slider
from tests.sentences import NOT_ITS_MECHANISM

import cranktrain as ct
from cranktrain.io.examples import example_names
from cranktrain.panels import drawing_of_machine

STEP = 15.0
ANGLES = np.arange(0.0, 360.0, STEP)
ROUNDING = 1e-12
"""Of the size of what is drawn."""

DELTIC = {"main": (0.0, 0.0), "right": (1.110, 0.0), "bottom": (0.555, -0.9612882)}
"""Centres of shafts as deltic.toml has them. [m]"""

FACING = {
    "shaft": {"upper": {}},
    "bank": {"A": {"exhaust": {"mechanism": slider()}, "scavenge": {"mechanism": slider(), "shaft": "upper"}}},
}
NOWHERE = {
    "shaft": {"upper": {}},
    "bank": {"A": {"mechanism": slider()}, "B": {"shaft": "upper", "mechanism": slider(), "angle": "90 deg"}},
}
JAMMED = {"mechanism": slider(rod_length="45 mm")}
NEVER = {"mechanism": slider(offset="300 mm")}


@pytest.fixture(scope="module", params=example_names())
def example(request):
    """An example and its drawing at 24 angles."""
    machine = ct.load(request.param)
    return machine, ct.drawing(machine, ANGLES)


def size_of(one):
    return max(float(np.ptp(pin, axis=1).max()) for pin in (np.concatenate(list(one.pins.values()), axis=1),))


def distances(one, first, second):
    return np.hypot(*(one.pins[second] - one.pins[first]))


def test_every_mechanism_is_drawn_where_it_belongs(example):
    machine, drawn = example
    assert [one.name for one in drawn.mechanisms] == [place.name for place in machine.places]
    assert drawn.left_out == ()
    for one, place in zip(drawn.mechanisms, machine.places, strict=True):
        assert (one.kind, one.cylinder, one.bank, one.shaft, one.throw - 1) == (
            place.kind.name,
            place.cylinder,
            place.bank,
            place.shaft,
            place.throw,
        )
        assert {pin.shape for pin in one.pins.values()} == {(2, ANGLES.size)}


def test_links_are_rigid_and_what_is_fixed_stands(example):
    for one in example[1].mechanisms:
        limit = ROUNDING * size_of(one)
        for link in one.links:
            for first, second in combinations(dict.fromkeys(link.pins), 2):
                assert np.ptp(distances(one, first, second)) < limit, (one.name, link.name)
        for pin in one.fixed:
            assert np.ptp(one.pins[pin], axis=1).max() == 0.0


def lengths_of_file(spec):
    """Pins and their distance, where the table of a mechanism gives it. [m]"""
    crank = getattr(spec, "crank_radius", None)
    match spec.kind:
        case "slider_crank":
            if crank is not None:
                yield "O", "A", crank.si
            elif not spec.offset.si:
                yield "O", "A", 0.5 * spec.stroke.si
            if spec.rod_length is not None:
                yield "A", "B", spec.rod_length.si
        case "articulated_rod":
            yield from (("A", "C", spec.knuckle_radius.si), ("C", "D", spec.rod_length.si))
        case "eccentric":
            yield from (("O", "A", spec.eccentricity.si), ("A", "B", spec.rod_length.si))
        case "crank_rocker":
            yield from (("O", "A", crank.si), ("A", "B", spec.rod_length.si))
            yield from (("C", "B", spec.rocker_length.si), ("O", "C", spec.ground_length.si))
        case "walschaerts":
            yield "O", "return.pin", spec.eccentricity.si
            yield "return.pin", "foot", spec.eccentric_rod_length.si
            yield "die", "radius_pin", spec.radius_rod_length.si
            yield "drop_pin", "union_pin", spec.union_link_length.si
        case _:
            return


def test_links_are_as_long_as_the_file_says(example):
    machine, drawn = example
    for one, place in zip(drawn.mechanisms, machine.places, strict=True):
        for first, second, length in lengths_of_file(place.spec):
            assert distances(one, first, second) == pytest.approx(length, rel=1e-11), (one.name, first, second)


def test_links_of_a_chain_are_as_long_as_the_file_says():
    knee = ct.drawing("toggle_press", ANGLES).mechanisms[0]
    lengths = {("O", "main.pin"): 0.05, ("main.pin", "knee"): 0.32, ("C", "knee"): 0.25, ("knee", "ram.pin"): 0.25}
    for pins, length in lengths.items():
        assert distances(knee, *pins) == pytest.approx(length, rel=1e-12)
    assert pytest.approx(np.tile([0.4, 0.25], (ANGLES.size, 1))) == knee.pins["C"].T


def test_cranks_turn_with_their_shafts(example):
    """By 15° from angle to angle, in the sense of the shaft, and from the direction that stands for 0."""
    drawn = example[1]
    senses = {shaft.name: shaft.sense for shaft in drawn.shafts}
    centres = {shaft.name: shaft.centre for shaft in drawn.shafts}
    for one in drawn.mechanisms:
        cranks = [link for link in one.links if link.is_crank]
        assert cranks[0] is one.links[0]
        for crank in cranks:
            assert one.pins[crank.pins[0]][:, 0] == pytest.approx(centres[one.shaft])
            arm = np.array([1.0, 1j]) @ (one.pins[crank.pins[1]] - one.pins[crank.pins[0]])
            assert np.angle(arm[1:] / arm[:-1]) == pytest.approx(senses[one.shaft] * np.deg2rad(STEP), abs=1e-12)
            if crank is cranks[0]:
                assert np.exp(1j * one.crank_zero) == pytest.approx(arm[0] / abs(arm[0]))
        for link in one.links:
            if not link.is_crank:
                arm = np.array([1.0, 1j]) @ (one.pins[link.pins[1]] - one.pins[link.pins[0]])
                turned = np.angle(arm[1:] / arm[:-1])
                assert np.ptp(turned) > 1e-6 or abs(turned[0]) < 1e-6, link.name


def test_pins_in_guides_lie_on_their_lines(example):
    drawn = example[1]
    centres = {shaft.name: shaft.centre for shaft in drawn.shafts}
    for one in drawn.mechanisms:
        limit = ROUNDING * size_of(one)
        for guide in one.guides:
            along = np.array([np.cos(guide.direction), np.sin(guide.direction)])
            across = np.array([-along[1], along[0]])
            assert np.max(np.abs(across @ (one.pins[guide.pin] - guide.foot[:, np.newaxis]))) < limit
            assert abs(along @ (guide.foot - centres[one.shaft])) < limit


def test_outputs_are_where_they_are_computed(example):
    """Displacement counts from the dead centre farthest from the shaft, toward it."""
    machine, drawn = example
    sliding = [one for one in drawn.mechanisms if one.output is not None]
    result = ct.run(machine, quantities=("piston_displacement", "stroke") if sliding else "rocker_angle")
    assert [one.name for one in sliding] == list(result.labels.get("piston", ()))
    for number, one in enumerate(sliding):
        output = one.output
        place = output.along @ (one.pins[output.pin] - output.foot[:, np.newaxis])
        displacement = result.piston_displacement[number, :: int(STEP)][: ANGLES.size]
        assert output.travel[1] - place == pytest.approx(displacement, abs=1e-9)
        assert np.diff(output.travel) == pytest.approx(result.stroke[number], rel=1e-11)


def test_all_angles_at_once_are_as_each_alone(example):
    machine, drawn = example
    for number in (1, 10):
        alone = ct.drawing(machine, ANGLES[number])
        assert alone.crank_angle.tolist() == [ANGLES[number]]
        for one, other in zip(drawn.mechanisms, alone.mechanisms, strict=True):
            for name, pin in other.pins.items():
                assert pin[:, 0] == pytest.approx(one.pins[name][:, number], abs=1e-12 * size_of(one))


def test_paths_go_round_within_the_bounds(example):
    drawn = example[1]
    low, high = drawn.bounds
    for one in drawn.mechanisms:
        margin = 1e-3 * size_of(one)
        for name, path in one.paths.items():
            assert path[:, 0] == pytest.approx(path[:, -1], abs=ROUNDING * size_of(one))
            assert path[:, :-1:5] == pytest.approx(one.pins[name], abs=ROUNDING * size_of(one))
        for pin in one.pins.values():
            assert np.all(low - margin < pin.T)
            assert np.all(high + margin > pin.T)


def test_json_has_all_of_it(example):
    drawn = example[1]
    data = drawn.to_dict()
    read = json.loads(json.dumps(data, allow_nan=False))
    assert read == data
    assert read["crank_angle"] == ANGLES.tolist()
    for one, own in zip(drawn.mechanisms, read["mechanisms"], strict=True):
        assert {name: np.array(pin).tolist() for name, pin in one.pins.items()} == own["pins"]
        assert [(link["name"], tuple(link["pins"])) for link in own["links"]] == [(a.name, a.pins) for a in one.links]
        assert [tuple(block["link"]) for block in own["blocks"]] == [block.link for block in one.blocks]
        assert (own["output"] is None) == (one.output is None)


class TestShafts:
    def test_three_stand_in_a_triangle(self):
        deltic = ct.drawing("deltic", ANGLES)
        assert [shaft.name for shaft in deltic.shafts] == list(DELTIC)
        assert np.stack([shaft.centre for shaft in deltic.shafts]) == pytest.approx(np.array(list(DELTIC.values())))
        assert {shaft.name: shaft.sense for shaft in deltic.shafts} == {"main": -1.0, "right": -1.0, "bottom": 1.0}
        assert not any(shaft.is_assumed for shaft in deltic.shafts)
        assert len(deltic.mechanisms) == 36

    def test_opposed_pistons_share_a_line_and_do_not_meet(self):
        """As far as the file's places of shafts, of seven digits, have them on one line."""
        mechanisms = ct.drawing("deltic", ANGLES).mechanisms
        for cylinder in {one.cylinder for one in mechanisms}:
            one, other = (own for own in mechanisms if own.cylinder == cylinder)
            assert one.output.along == pytest.approx(-other.output.along)
            apart = other.pins["B"] - one.pins["B"]
            across = np.array([-one.output.along[1], one.output.along[0]])
            assert across @ apart == pytest.approx(0.0, abs=1e-6)
            assert np.min(one.output.along @ apart) > 0.1

    def test_throws_that_share_cylinders_are_drawn_alone(self):
        throw = ct.drawing("deltic", mechanism="3B")
        assert {one.cylinder for one in throw.mechanisms} >= {"3B"}
        assert len(throw.mechanisms) == 6
        assert {one.shaft for one in throw.mechanisms} == set(DELTIC)
        crank = {(one.shaft, tuple(one.pins["A"][:, 0].round(9))) for one in throw.mechanisms}
        assert len(crank) == 3

    def test_an_assumed_place_is_marked(self):
        found = ct.drawing({**FACING, "bank": {"A": {**FACING["bank"]["A"], "lead": "0 deg"}}})
        assert {shaft.name: shaft.is_assumed for shaft in found.shafts} == {"main": False, "upper": True}
        assert found.shafts[1].centre == pytest.approx([0.0, 2 * (RADIUS + ROD) + 0.6 * 2 * RADIUS])

    def test_what_stands_nowhere_is_left_out(self):
        found = ct.drawing(NOWHERE)
        assert [one.name for one in found.mechanisms] == ["1A"]
        assert found.left_out == ("1B",)
        assert [shaft.name for shaft in found.shafts] == ["main"]
        with pytest.raises(ct.InputError, match=r"mechanism = 1B: .*place is not known; give it.*shaft\.upper"):
            ct.drawing(NOWHERE, mechanism="1B")

    def test_astern_they_turn_the_other_way(self):
        ahead, astern = (
            ct.drawing({"mechanism": slider(), "running": way}, [0.0, 30.0]) for way in ("ahead", "astern")
        )
        assert [one.shafts[0].sense for one in (ahead, astern)] == [-1.0, 1.0]
        assert astern.mechanisms[0].pins["A"] == pytest.approx(ahead.mechanisms[0].pins["A"] * [[-1.0], [1.0]])


class TestCylinders:
    def test_they_are_as_large_as_the_file_says(self):
        pistons = ct.drawing("10d100").mechanisms
        assert [one.output.bore for one in pistons] == pytest.approx([0.207] * 20)
        ports = {"exhaust": 0.06, "scavenge": 0.05}
        heights = [ports[one.name.partition(".")[2]] for one in pistons]
        assert [one.output.port for one in pistons] == pytest.approx(heights)
        assert not any(one.output.is_valve or one.output.is_far for one in pistons)

    def test_a_piston_with_side_rods_is_far(self):
        ends = {"exhaust": {"mechanism": slider(), "throws": [1]}}
        ends["scavenge"] = {"mechanism": slider(rod_length="570 mm"), "throws": [2], "side_rods": True}
        found = ct.drawing({"shaft": {"main": {"throws": ["0 deg", "180 deg"]}}, "bank": {"A": ends}})
        assert [(one.name, one.output.is_far) for one in found.mechanisms] == [
            ("1.exhaust", False),
            ("1.scavenge", True),
        ]

    def test_valves_and_slaves_are_marked(self):
        assert [one.output.is_valve for one in ct.drawing("great_northern").mechanisms] == [False, True]
        assert [one.is_slave for one in ct.drawing("3d12", mechanism="1L").mechanisms] == [False, True]
        assert [one.output.bore for one in ct.drawing({"mechanism": slider()}).mechanisms] == [None]

    def test_points_that_are_followed_have_paths(self):
        jaw = ct.drawing("jaw_crusher", ANGLES).mechanisms[0]
        assert jaw.points == ("jaw_end",)
        assert "jaw_end" in jaw.paths
        assert [link.name for link in jaw.links if "jaw_end" in link.pins] == ["rod"]


class TestLinksThatCannotClose:
    def test_they_are_nan_where_they_cannot(self):
        """The rod, 45 mm, reaches while 50 mm · |sin φ| is less."""
        angles = np.arange(0.0, 360.0, 1.0)
        found = ct.drawing(JAMMED, angles)
        phi, rod = np.deg2rad(angles), 0.045
        across = RADIUS * np.sin(phi)
        open_ = np.abs(across) > rod
        expected = RADIUS * np.cos(phi) + np.sqrt(np.where(open_, np.nan, rod**2 - across**2))
        piston = found.mechanisms[0]
        assert piston.pins["B"] == pytest.approx(np.stack([0.0 * expected, expected]), nan_ok=True, abs=1e-15)
        assert np.all(np.isfinite(piston.pins["A"]))
        assert piston.output.foot == pytest.approx([0.0, 0.0])
        least, most = piston.output.travel
        assert most == pytest.approx(RADIUS + rod, rel=1e-12)
        half = np.deg2rad(np.arange(0.0, 360.0, 0.5))
        reached = half[np.abs(RADIUS * np.sin(half)) < rod]
        expected = RADIUS * np.cos(reached) + np.sqrt(rod**2 - (RADIUS * np.sin(reached)) ** 2)
        assert least == pytest.approx(np.min(expected), rel=1e-9)
        assert found.loads == ()
        assert np.all(np.isfinite(found.bounds))
        written = json.loads(json.dumps(found.to_dict(), allow_nan=False))
        assert written["mechanisms"][0]["pins"]["B"][1][90] is None

    def test_they_close_later_than_the_angle_0(self):
        """A guide 60 mm aside: a rod of 45 mm reaches it while the crank pin is more than 15 mm on its side."""
        found = ct.drawing({"mechanism": slider(rod_length="45 mm", offset="-60 mm")}, [0.0, 330.0, 30.0])
        pin = found.mechanisms[0].pins["B"]
        closing = np.isfinite(pin[0])
        assert closing.tolist().count(True) == 1
        assert np.all(np.isfinite(found.mechanisms[0].output.foot))
        assert pin[0, closing] == pytest.approx(found.mechanisms[0].output.foot[0])

    def test_they_never_close(self):
        found = ct.drawing(NEVER, [0.0, 90.0])
        piston = found.mechanisms[0]
        assert np.all(np.isnan(piston.pins["B"]))
        assert np.all(np.isnan(piston.output.travel))
        assert np.all(np.isnan(piston.guides[0].foot))
        assert found.bounds[1] == pytest.approx([RADIUS, RADIUS])
        json.dumps(found.to_dict(), allow_nan=False)


class TestLoads:
    def test_a_force_stands_at_its_piston(self):
        load = {"spring": {"on": "piston", "force": "2 kN", "sense": "active", "direction": "180 deg"}}
        machine = {"mechanism": slider(), "shaft": {"main": {"speed": "60 rpm"}}, "load": load}
        found = ct.drawing(machine, ANGLES)
        (spring,) = found.loads
        assert (spring.name, spring.mechanism, spring.link, spring.is_torque) == ("spring", "1", "slider", False)
        assert spring.size == pytest.approx(2000.0)
        assert spring.largest == pytest.approx(2000.0)
        assert (spring.unit, spring.one) == ("kN", 1000.0)
        assert spring.place == pytest.approx(found.mechanism("1").pins["B"])
        assert spring.way == pytest.approx(np.tile([[0.0], [-1.0]], ANGLES.size), abs=1e-12)

    def test_a_torque_stands_at_its_pivot(self):
        found = ct.drawing(LOADED["table"], ANGLES)
        (drive,) = found.loads
        assert drive.is_torque
        assert drive.largest == pytest.approx(1200.0)
        assert (drive.unit, drive.one) == ("N·m", 1.0)
        assert np.abs(drive.size) == pytest.approx(1200.0)
        assert drive.place == pytest.approx(found.mechanisms[0].pins["C"])

    def test_they_move_with_their_shafts(self):
        load = {"push": {"on": "piston", "force": "1 kN"}}
        banks = {name: {"shaft": name, "mechanism": slider(), "load": load} for name in ("main", "other")}
        shafts = {"main": {"speed": "60 rpm"}, "other": {"place": ["1 m", "-200 mm"]}}
        found = ct.drawing({"shaft": shafts, "bank": banks}, ANGLES)
        near, far = found.loads
        assert far.place == pytest.approx(near.place + np.array([[1.0], [-0.2]]))


class TestAngles:
    def test_each_mechanism_is_evaluated_once_for_all(self, monkeypatch):
        counted = []
        placed = drawing_of_machine.placed

        def counting(machine, place, phi):
            counted.append(place.name)
            return placed(machine, place, phi)

        monkeypatch.setattr(drawing_of_machine, "placed", counting)
        machine = ct.load("3d12")
        for n in (1, 720):
            counted.clear()
            ct.drawing(machine, np.linspace(0.0, 360.0, n))
            assert counted == [place.name for place in machine.places]

    def test_they_count_as_the_machine_shows_them(self):
        machine = ct.Machine(mechanism=slider(), angle="40 deg", crank_zero="Y")
        assert ct.drawing(machine, 0).mechanisms[0].pins["A"][:, 0] == pytest.approx([0.0, RADIUS])

    @pytest.mark.parametrize("at", [[], [0.0, np.nan], np.inf, "top", [[0.0, 30.0]], None, [[0.0], [1.0, 2.0]]])
    def test_what_is_no_angle_is_refused(self, at):
        with pytest.raises(ct.InputError, match=r"^at = .*must be a crank angle in degrees, or a list of them"):
            ct.drawing("3d12", at)


def test_a_mechanism_that_there_is_not_is_refused():
    with pytest.raises(ct.InputError, match=f"7Q: {NOT_ITS_MECHANISM}: 1L"):
        ct.drawing("3d12", mechanism="7Q")
    with pytest.raises(ct.InputError, match=r"mechanism = 7Q: must be one of the mechanisms that are drawn: 1, 2"):
        ct.drawing("vaz_21213").mechanism("7Q")


def test_a_machine_that_cannot_be_arranged_is_refused():
    bank = {"mechanism": slider(), "throws": [1, 2]}
    with pytest.raises(ct.InputError, match=r"bank\.A\.throws"):
        ct.drawing({"bank": {"A": bank}})


def test_other_values_are_drawn():
    long = ct.drawing({"mechanism": ROCKER}, ANGLES, set={"mechanism.rod_length": "370 mm"}).mechanisms[0]
    assert distances(long, "A", "B") == pytest.approx(0.37)
    assert long.output is None


def test_nothing_that_draws_is_loaded():
    code = (
        "import sys, cranktrain as ct\n"
        "ct.drawing('3d12', [0, 30]).to_dict()\n"
        "from cranktrain.panels import throw_scene\n"
        "assert not [name for name in sys.modules if name in ('matplotlib', 'cranktrain.viz')], sys.modules\n"
    )
    subprocess.run([sys.executable, "-c", code], env={"PYTHONPATH": ":".join(sys.path)}, check=True)
