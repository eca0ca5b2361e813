"""Pulls over the crank angle: the lever rule on two bearings, corners, files, and what is wrong with them."""

import numpy as np
import pytest
from tests.sentences import NO_UNIT, NOT_POSITIVE
from tests.validation.test_crankshaft_arrangements import SECTIONS

import cranktrain as ct

AT = np.radians([0.0, 90.0, 200.0])
SIZES = np.array([1000.0, 3000.0, -500.0])
LISTED = {"force": ["1 kN", "3 kN", "-500 N"], "crank_angles": ["0 deg", "90 deg", "200 deg"]}


def shaft(pull, *, more=None, **others):
    """A crank between bearings at ±130 mm that turns too slowly to load them: all that they carry is the pull's."""
    return ct.Machine(
        mechanism={"kind": "slider_crank", "crank_radius": "50 mm", "rod_length": "220 mm"},
        shaft={"main": {"speed": "0.0001 rpm"}},
        masses={"piston": {"mass": "1 g"}},
        crankshaft={
            **SECTIONS,
            "bearing_distance": "130 mm",
            "pull": {"belt": {"z": "-260 mm", "direction": "75 deg", **pull}, **(more or {})},
        },
        **others,
    )


def borne(result):
    """Loads of both bearings toward X and Y, shape (bearing, 2, n)."""
    own = result.dataset.isel(bearing_method=0)
    return np.stack([own.main_bearing_load_x.values, own.main_bearing_load_y.values], axis=1)


def by_levers(sizes):
    """What bearings at ±130 mm carry of a force at −260 mm, 75° from Y toward X."""
    toward = np.array([np.sin(np.radians(75)), np.cos(np.radians(75))])
    share = np.array([390 / 260, -130 / 260])
    return share[:, np.newaxis, np.newaxis] * toward[:, np.newaxis] * sizes


def test_straight_lines_by_the_lever():
    """From angle to angle, and from the last to the first of the next turn."""
    result = ct.run(shaft(LISTED))
    angle = np.radians(np.arange(360.0))
    sizes = np.interp(angle, np.append(AT, 2 * np.pi), np.append(SIZES, SIZES[0]))
    np.testing.assert_allclose(borne(result), by_levers(sizes), rtol=0, atol=1e-7)


@pytest.mark.parametrize("step", [1.0, 7.5])
def test_a_peak_in_a_corner_is_the_corner(step):
    """At 90.37°, where no grid has a point; the mean size is that of straight lines."""
    corner = np.radians(90.37)
    result = ct.run(shaft({**LISTED, "crank_angles": ["0 deg", "90.37 deg", "200 deg"]}), step_degrees=step)
    facts = result.dataset.isel(bearing_method=0)
    np.testing.assert_allclose(facts.largest_bearing_load, [1.5 * 3000, 0.5 * 3000], rtol=1e-9)
    np.testing.assert_allclose(facts.largest_bearing_load_at, 90.37, rtol=1e-9)
    ends = np.array([0.0, corner, np.radians(200), np.radians(200) + np.radians(160) / 3, 2 * np.pi])
    size = np.array([1000.0, 3000.0, -500.0, 0.0, 1000.0])
    falls = corner + (np.radians(200) - corner) * 3000 / 3500
    ends, size = np.insert(ends, 2, falls), np.insert(size, 2, 0.0)
    mean = np.sum(np.diff(ends) * np.abs(size[1:] + size[:-1]) / 2) / (2 * np.pi)
    np.testing.assert_allclose(facts.mean_bearing_load, [1.5 * mean, 0.5 * mean], rtol=1e-9)


def test_a_cosine():
    """A + B cos φ in steps of a quarter of a degree: at these angles by the lever, the largest A + B."""
    angle = np.arange(0.0, 360.0, 0.25)
    sizes = 2000 + 700 * np.cos(np.radians(angle))
    lists = {
        "force": [f"{size!r} N" for size in sizes.tolist()],
        "crank_angles": [f"{at!r} deg" for at in angle.tolist()],
    }
    result = ct.run(shaft(lists), step_degrees=0.5)
    np.testing.assert_allclose(borne(result), by_levers(sizes[::2]), rtol=0, atol=1e-7)
    facts = result.dataset.isel(bearing_method=0)
    np.testing.assert_allclose(facts.largest_bearing_load, [1.5 * 2700, 0.5 * 2700], rtol=1e-9)
    np.testing.assert_allclose(facts.mean_bearing_load, [1.5 * 2000, 0.5 * 2000], rtol=1e-9)


def test_a_file_is_a_list():
    """To the last bit."""
    text = "crank angle [deg];force [N]\n0;1000\n90;3000\n200;-500\n360;1000\n"
    of_file = ct.run(shaft({"file": "pull.csv", "text": text}))
    closed = {
        "force": ["1000 N", "3000 N", "-500 N", "1000 N"],
        "crank_angles": ["0 deg", "90 deg", "200 deg", "360 deg"],
    }
    of_list = ct.run(shaft(closed))
    np.testing.assert_array_equal(borne(of_file), borne(of_list))
    assert of_file.dataset.largest_bearing_load.equals(of_list.dataset.largest_bearing_load)
    assert of_file.dataset.mean_bearing_load.equals(of_list.dataset.mean_bearing_load)


def test_a_file_beside_the_machine(tmp_path):
    (tmp_path / "pull.csv").write_text("angle [deg];force [kN]\n0;1\n90;3\n200;-0.5\n360;1\n")
    file = tmp_path / "machine.toml"
    shaft({"force": "1 kN"}).save(file)
    machine = ct.load(file)
    with pytest.raises(ct.InputError, match="force = 1 kN: must not stand beside file"):
        machine.with_({"crankshaft.pull.belt.file": "pull.csv", "crankshaft.pull.belt.force": "1 kN"})
    np.testing.assert_allclose(
        borne(ct.run(machine.with_({"crankshaft.pull.belt.file": "pull.csv"}))),
        borne(ct.run(shaft(LISTED))),
        rtol=1e-12,
    )


def test_files_of_designs():
    """Each of a length of its own, as it is alone."""
    two = "angle [deg];force [N]\n0;1000\n180;400\n360;1000\n"
    four = "angle [deg];force [N]\n0;100\n90;700\n200;-500\n300;0\n360;100\n"
    machines = [shaft({"file": "pull.csv", "text": text}) for text in (two, four)]
    together = ct.run(machines)
    for design, one in enumerate(machines):
        alone = ct.run(one).dataset
        both = together.dataset.isel(design=design)
        np.testing.assert_array_equal(both.main_bearing_load_x, alone.main_bearing_load_x)
        np.testing.assert_array_equal(both.largest_bearing_load, alone.largest_bearing_load)


def test_over_two_turns():
    """Two equal turns are one."""
    engine = {"cylinder": {"cycle": "four-stroke"}}
    angles = [0, 90, 200, 360, 450, 560]
    two = {"force": LISTED["force"] * 2, "crank_angles": [f"{angle} deg" for angle in angles]}
    once, twice = (ct.run(shaft(pull, **engine)).dataset for pull in (LISTED, two))
    np.testing.assert_allclose(twice.largest_bearing_load, once.largest_bearing_load, rtol=1e-12)
    np.testing.assert_allclose(twice.mean_bearing_load, once.mean_bearing_load, rtol=1e-12)


WRONG = {
    "no size": ({}, "crankshaft.pull.belt.force: is missing; give force, or a file"),
    "no pull": (
        {"force": "-1 kN"},
        f"crankshaft.pull.belt.force = -1 kN: {NOT_POSITIVE}; its direction says where it pulls to",
    ),
    "a list over nothing": (
        {"force": ["1 kN", "2 kN"]},
        "crankshaft.pull.belt.force = a list of 2: must be as many as the places that they are for: 1",
    ),
    "too few": (
        {"force": ["1 kN", "2 kN"], "crank_angles": ["0 deg", "90 deg", "180 deg"]},
        "crankshaft.pull.belt.force = a list of 2: must be as many as the places that they are for: 3",
    ),
    "back and forth": (
        {"force": ["1 kN", "2 kN"], "crank_angles": ["90 deg", "0 deg"]},
        "crankshaft.pull.belt.crank_angles[1] = 0 deg: must be more than 90 deg, the place before it",
    ),
    "three turns": (
        {"force": ["1 kN", "2 kN"], "crank_angles": ["0 deg", "900 deg"]},
        "crankshaft.pull.belt.crank_angles: must reach over two turns at most, 720°",
    ),
    "columns of no file": (
        {"force": "1 kN", "columns": [1, 2]},
        "crankshaft.pull.belt.file: is missing; text and columns are of a file",
    ),
    "both": (
        {"force": "1 kN", "file": "pull.csv", "text": "angle [deg];force [N]\n0;1\n360;1"},
        "crankshaft.pull.belt.force = 1 kN: must not stand beside file, which says how large the pull is",
    ),
    "torques": (
        {"file": "pull.csv", "text": "angle [deg];torque [N·m]\n0;1\n180;2\n360;1"},
        "crankshaft.pull.belt.file = pull.csv: must hold forces over the crank angle",
    ),
    "travel": (
        {"file": "pull.csv", "text": "travel [mm];force [N]\n0;1\n10;2\n0;1"},
        "crankshaft.pull.belt.file = pull.csv: must hold forces over the crank angle",
    ),
    "no unit": (
        {"file": "pull.csv", "text": "angle [deg];pull\n0;1\n180;2\n360;1"},
        f"crankshaft.pull.belt.file = pull.csv: {NO_UNIT} force or torque",
    ),
    "half a turn": (
        {"file": "pull.csv", "text": "angle [deg];force [N]\n0;1\n90;2\n180;1"},
        "crankshaft.pull.belt.file = pull.csv: reaches from 0° to 180°",
    ),
}


@pytest.mark.parametrize("pull, wanted", WRONG.values(), ids=WRONG)
def test_refused(pull, wanted):
    with pytest.raises(ct.InputError) as found:
        shaft(pull)
    assert wanted in str(found.value)


def test_a_file_that_nobody_read():
    with pytest.raises(ct.InputError, match=r"crankshaft.pull.belt.file = pull.csv"):
        ct.run(shaft({"file": "pull.csv"}))
