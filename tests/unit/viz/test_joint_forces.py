"""The sheet of forces of what has no piston's forces: reactions in joints, each once, and what is drawn of them."""

from functools import cache

import numpy as np
import pytest
from mpmath import mp
from tests.example_runs import ran
from tests.unit.viz.machines_by_hand import MACHINES
from tests.weighed_machines import WEIGHED
from tests.words_on_paper import assert_words_are_readable, words_of

import cranktrain as ct
from cranktrain.panels.design import OneDesign
from cranktrain.panels.sheets.forces.at_crank import crank_panels
from cranktrain.panels.sheets.forces.joints import joint_forces, joint_panels
from cranktrain.panels.sheets.torque.panels import torque_panel
from cranktrain.viz import sheet_forces

ROCKERS = ("tilting_table", "jaw_crusher", "pumping_unit_c57", "shaper", "toggle_press")


@pytest.fixture(scope="module")
def results():
    return {name: ran(name) for name in ROCKERS}


@cache
def sheet_of(name):
    """The sheet of an example's forces, drawn once for all that is asked of it."""
    return sheet_forces(ran(name))


@cache
def ran_weighed(name):
    """The result of a machine with masses, computed once for both sizes of paper."""
    return ct.run(WEIGHED[name])


@pytest.mark.parametrize("name", ROCKERS)
def test_every_joint_that_bears_is_drawn_once(results, name):
    result = results[name]
    sizes = {
        label.removeprefix("1."): float(np.max(np.hypot(x, y)))
        for label, x, y in zip(result.labels["joint"], result.joint_force_x, result.joint_force_y, strict=True)
    }
    joints = joint_forces(OneDesign(result, 0), "1")
    named = [joint for one in joints for joint in one.names]
    assert sorted(named) == sorted(label for label, size in sizes.items() if size > 1e-9 * max(sizes.values()))
    largest = [float(np.max(one.size)) for one in joints]
    assert largest == sorted(largest, reverse=True)
    for one in joints:
        assert one.size.max() == pytest.approx(sizes[one.names[0]], rel=1e-12)


@pytest.mark.parametrize("name", ROCKERS)
def test_sheet(results, name):
    """Whatever it drives, half of its sheet is not blank."""
    shown = OneDesign(results[name], 0)
    joints = joint_forces(shown, "1")
    panels = list(joint_panels(shown, joints))
    assert str(panels[0].title) == "Reactions in the joints"
    assert all(np.all(np.isfinite(panel.values)) and np.any(panel.values) for panel in panels)
    drawn = sheet_of(name)
    assert_words_are_readable(drawn)
    words = [text for text, _box in words_of(drawn)]
    for one in joints:
        assert {f"R{one.number}  {name.replace('_', ' ')}" for name in one.names} <= set(words)


@pytest.mark.parametrize("name", ROCKERS)
def test_every_load_has_its_torque_at_the_crank(results, name):
    """By virtual work, which the file's loads do; with a drive it is the drive's static torque at the crank, too."""
    panels = {str(panel.title): panel for panel in crank_panels(OneDesign(results[name], 0))}
    static = panels["Torque that the crank needs"].curves[0]
    assert static.symbol == "M_{st}"
    by_work = -np.sum(results[name].load_torque_on_crank, axis=0)
    np.testing.assert_allclose(static.values[:-1], by_work, atol=1e-10 * np.max(np.abs(by_work)))
    if "static_torque" in results[name].catalogue:
        of_drive = results[name].static_torque[-1]
        np.testing.assert_allclose(static.values[:-1], of_drive, atol=1e-10 * np.max(np.abs(by_work)))
    words = [text for text, _box in words_of(sheet_of(name))]
    assert any("into the crank" in text and "opposite sign" in text for text in words)


def test_a_load_that_goes_with_the_speed_is_as_at_the_declared_one():
    """At rest, as the drive counts it, there is none; 100 N·m at 37.5 rpm, which is the declared speed."""
    rub = {"on": "crank", "torque": "100 N*m", "at_turning": "37.5 rpm"}
    result = ct.run(ct.load("tilting_table").with_({"load": {"rub": rub}}))
    static, *_others = next(crank_panels(OneDesign(result, 0))).curves
    np.testing.assert_allclose(static.values, 100.0, rtol=1e-10)
    assert np.all(result.static_torque == 0.0)


@pytest.fixture(scope="module", params=MACHINES)
def by_hand(request):
    machine, hand = MACHINES[request.param]()
    shown = OneDesign(ct.run(machine), 0)
    return shown, hand


@pytest.mark.parametrize("degrees", [20, 75, 130, 205, 300])
def test_curves_at_an_angle(by_hand, degrees):
    """Joints and torques by Newton's laws, static torque by virtual work, inertia by its definition, 40 digits."""
    shown, hand = by_hand
    angle = mp.radians(degrees)
    sizes, driving = hand.solved(angle)
    joints = joint_forces(shown, "1")
    most = max(float(np.max(one.size)) for one in joints)
    # Reactions that differ by less than 1e-3 of the largest share a curve, the first's.
    found = {name: (one.size[degrees], one.names[0] == name) for one in joints for name in one.names}
    for name, expected in sizes.items():
        size, is_own = found.get(name, (0.0, True))  # what bears nothing is left out
        assert size == pytest.approx(expected, abs=(1e-11 if is_own else 1e-3) * most), name
    panels = {str(panel.title): panel for panel in crank_panels(shown)}
    static, changing = (curve.values for curve in panels["Torque that the crank needs"].curves)
    inertia, slope = (curve.values for curve in panels["Reduced inertia, and its slope by the angle"].curves)
    whole = next(curve.values for curve in torque_panel(shown).curves if curve.symbol == r"T_\Sigma")
    scale = max(np.max(np.abs(static)), np.max(np.abs(changing)))
    by_angle = float(mp.diff(hand.inertia, angle))
    assert static[degrees] == pytest.approx(hand.static_torque(angle), abs=1e-11 * scale)
    assert changing[degrees] == pytest.approx(0.5 * by_angle * hand.speed**2, abs=1e-11 * scale)
    assert whole[degrees] == pytest.approx(-driving, abs=1e-11 * scale)
    assert inertia[degrees] == pytest.approx(float(hand.inertia(angle)), rel=1e-12)
    assert slope[degrees] == pytest.approx(by_angle, abs=1e-12 * np.max(inertia))


def test_a_piston_with_a_rod_keeps_its_own(results):
    words = [text for text, _box in words_of(sheet_forces(ct.run(ct.load("eccentric_press"))))]
    assert any(text.startswith("Forces at piston") for text in words)
    assert not any(text.startswith("Reactions in the joints") for text in words)
    assert not any(text.startswith("Reduced inertia") for text in words)


def said_in(drawn):
    """All words of a picture, lines of notes joined."""
    assert_words_are_readable(drawn)
    return " ".join(text for text, _box in words_of(drawn))


@pytest.mark.parametrize("name", ROCKERS)
def test_what_is_left_out_is_said_before_what_lines_mean(name):
    words = said_in(sheet_of(name))
    if name != "tilting_table":
        assert "No masses are given: forces and torque are of the loads alone." in words
    assert "Torque: reactions of rigid links." in words


def test_a_pin_of_three_links_is_somebodys():
    """Of the knee, where the pitman meets both levers; main.pin is the crank's own, and joins two."""
    words = said_in(sheet_of("toggle_press"))
    assert "knee joins 3 links: its pin is part of pitman, and upper and lower hang on that." in words
    assert words.count("its pin is part of") == 1


@pytest.mark.parametrize("size", ["A4", "A3"])
@pytest.mark.parametrize("name", [name for name in WEIGHED if name not in ("3d12", "r_1340", "deltic")])
def test_no_note_is_dropped(name, size):
    result = ran_weighed(name)
    pistons = result.labels.get("piston", ())
    for piston in pistons or (None,):
        words = said_in(sheet_forces(result, size=size, piston=piston))
        several = np.sum(np.any(result.mechanism_torque, axis=-1)) > 1
        said = "Torque: reactions of rigid links, each mechanism's thin."
        assert (said if several else "Torque: reactions of rigid links.") in words
        is_of_joints = "Reactions in the joints" in words
        assert ("with the opposite sign." in words) == is_of_joints


def levers(n):
    """A chain of so many levers, each driven by the one before, with a torque against the last."""
    rods = [("main.pin" if not i else f"B{i - 1}", f"C{i}", i) for i in range(n)]
    parts = [
        {
            "type": "pin",
            "rod": {"name": f"rod{i}", "from": start, "length": "400 mm"},
            "rocker": {"name": f"lever{i}", "from": pivot, "length": "250 mm"},
            "joint": f"B{i}",
            "side": "left",
        }
        for start, pivot, i in rods
    ]
    return ct.Machine(
        shaft={"main": {"speed": "100 rpm"}},
        mechanism={
            "kind": "chain",
            "output": f"lever{n - 1}",
            "fixed": {f"C{i}": [f"{400 * (i + 1)} mm", "-200 mm"] for i in range(n)},
            "crank": {"main": {"radius": "50 mm"}},
            "part": parts,
        },
        masses={f"rod{i}": {"mass": "2 kg", "along": "200 mm", "inertia": "0.03 kg*m^2"} for i in range(n)},
        load={"work": {"on": f"lever{n - 1}", "torque": "200 N*m"}},
    )


def test_curves_that_are_left_out_are_said():
    """A valve gear has thirteen joints that bear forces of their own."""
    words = said_in(sheet_forces(ran_weighed("walschaerts"), piston="1valve"))
    assert "Curves are of the 12 joints that bear most." in words
    assert "R13" in words


@pytest.mark.parametrize("size", ["A4", "A3"])
def test_more_joints_than_there_is_room_for(size):
    """Nine levers have 28 joints: rows end with how many are left out, and notes stand under the curves."""
    result = ct.run(levers(9))
    n_joints = len(result.labels["joint"])
    assert n_joints == 28
    drawn = sheet_forces(result, size=size)
    words = said_in(drawn)
    rows = [text for text, _box in words_of(drawn) if text[:1] == "R" and "/" in text and " in " not in text]
    rows += [text for text, _box in words_of(drawn) if text.endswith("  main bearing")]
    if size == "A4":
        assert f"and {n_joints - len(rows)} that bear less" in words
    assert "Without mass: 1.main, 1.lever0" in words
    assert "Torque: reactions of rigid links" in words
