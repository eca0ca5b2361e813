"""Pictures: what they say, that no words overlap or leave the paper, that metal is to scale, that bytes stay."""

import re
import subprocess
import sys
import tomllib
from functools import cache
from importlib.resources import files
from io import BytesIO
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from matplotlib.text import Text
from tests.example_runs import ran
from tests.sentences import AT_MOST_TO_A_SHEET, ENDS_IN
from tests.words_on_paper import assert_words_are_readable, words_of

import cranktrain as ct
from cranktrain.errors import InputError
from cranktrain.io.description import counted_by_status
from cranktrain.io.examples import example_names
from cranktrain.io.machine_file import inputs_of, read_machine
from cranktrain.io.output import write_whole
from cranktrain.layout.frames import in_machine_axes
from cranktrain.mechanisms import KINDS
from cranktrain.panels.formulas import formula, mathematics
from cranktrain.panels.shapes import as_shown
from cranktrain.panels.sheets.motion.dead_centres import ruler_of
from cranktrain.panels.sheets.motion.panels import panels
from cranktrain.panels.throw_scene import scene_of
from cranktrain.plans.placement import frame
from cranktrain.viz import (
    SHEET_QUANTITIES,
    animation,
    dxf,
    plan_accelerations,
    plan_arc,
    plan_brix,
    plan_brix_backward,
    plan_centres,
    plan_klein,
    plan_positions,
    plan_projection,
    plan_velocities,
    save,
    save_animation,
    sheet,
)
from cranktrain.viz.paper.head import provenance_words
from cranktrain.viz.paper.page import fitting_scale, scale_words
from cranktrain.viz.throw.mechanism import mechanism_sketch

ODD = {
    "no speed, no bore": {"mechanism": {"kind": "slider_crank", "stroke": "12 in", "rod_length": "30 in"}},
    "astern and tiny": {
        "name": "Desaxial",
        "running": "astern",
        "angle": "45 deg",
        "mechanism": {"kind": "slider_crank", "crank_radius": "0.1 mm", "rod_length": "0.4 mm", "offset": "0.05 mm"},
        "cylinder": {"bore": "0.2 mm"},
    },
    "a rocker that turns": {
        "rotation": "anticlockwise",
        "mechanism": {
            "kind": "crank_rocker",
            "crank_radius": "300 mm",
            "rod_length": "250 mm",
            "rocker_length": "280 mm",
            "ground_length": "100 mm",
        },
    },
    "a star without slaves": {
        "shaft": {"main": {"speed": "3000 rpm"}},
        "bank": {
            "A": {
                "angle": ["0 deg", "72 deg", "144 deg", "216 deg", "288 deg"],
                "mechanism": {"kind": "slider_crank", "crank_radius": "30 mm", "rod_length": "120 mm"},
            }
        },
        "cylinder": {"bore": "60 mm"},
    },
}

PLANS = {
    "positions": plan_positions,
    "velocities": plan_velocities,
    "accelerations": plan_accelerations,
    "klein": plan_klein,
    "centres": plan_centres,
}

WORKS = {kind.name: ct.Machine(**tomllib.loads(kind.example)) for kind in KINDS} | {
    name: ct.load(name) for name in ("shaper", "great_northern", "jaw_crusher", "toggle_press")
}
"""A machine of every kind, and the examples whose names of pins are words."""


@cache
def sheet_of(name):
    """The sheet of an example, drawn once for all that is asked of it."""
    return sheet(ran(name))


@pytest.mark.parametrize("case", ODD)
def test_sheet_of_other_machines_is_readable(case):
    assert_words_are_readable(sheet(ct.run(ct.Machine(**ODD[case]))))


@pytest.mark.parametrize("case", [kind.name for kind in KINDS])
def test_sheet_of_every_kind_is_readable(case):
    assert_words_are_readable(sheet(ct.run(WORKS[case])))


def test_sheet_of_links_that_part_is_readable():
    short = ct.Machine(mechanism={"kind": "slider_crank", "crank_radius": "50 mm", "rod_length": "45 mm"})
    figure = sheet(ct.run(short, partial=True), at=90.0)
    assert_words_are_readable(figure)
    assert "Drawn at φ = 116°" in [text for text, _box in words_of(figure)]


def test_larger_paper():
    figure = sheet(ran("r_1340"), size="A3")
    assert_words_are_readable(figure)
    assert "200 mm, scale 1:5" in [text for text, _box in words_of(figure)]
    with pytest.raises(InputError, match="size = A7: must be one of: A4, A3"):
        sheet(ran("r_1340"), size="A7")


def test_sheet_says_what_it_shows():
    words = " | ".join(text for text, _box in words_of(sheet_of("3d12")))
    for part in (
        "3D12 marine diesel",
        "12 pistons, 6 throws, banks L, R",
        "n = 1500 rpm, clockwise",
        "φ = 0 where crank 1 is on the axis of bank L",
        "Inputs: 4 published, 2 derived, 25 assumed, 4 fitted, 6 without a status",
        "TDC 60.82°",
        "BDC 235.74°",
        "γ = 60°",
        "Throw 1 of 6",
        "scale 1:5",
        "Piston travel | $s$ | , mm",
        "Piston velocity | $v$ | , m/s",
        "Piston acceleration | $j$ | , m/s²",
        "% of own maximum",
        "(I.13) reconstructed",
        "Crank angle φ, °",
    ):
        assert part in words


def test_curves_of_a_valve_are_not_called_a_piston_s():
    eccentric = {"kind": "eccentric", "eccentricity": "60 mm", "rod_length": "1.4 m", "angle_of_advance": "30 deg"}
    alone = ct.run(ct.Machine(mechanism=eccentric))
    assert [str(panel.title) for panel in panels(alone)] == ["Valve travel", "Valve velocity", "Valve acceleration"]
    assert [str(panel.title) for panel in panels(ct.run(ct.load("lms_class5")))][:3] == [
        "Travel of piston and valve",
        "Velocity of piston and valve",
        "Acceleration of piston and valve",
    ]


def test_a_valve_has_no_dead_centres():
    """It is farthest and nearest, of an eccentric half a turn apart."""
    eccentric = {"kind": "eccentric", "eccentricity": "60 mm", "rod_length": "1.4 m", "angle_of_advance": "30 deg"}
    alone = [text for text, _box in words_of(sheet(ct.run(ct.Machine(mechanism=eccentric))))]
    assert {"Ends of valve travel", "nearest 60.00°", "farthest 240.00°"} <= set(alone)
    assert not any("TDC" in text or "ead centres" in text for text in alone)
    both = [text for text, _box in words_of(sheet_of("great_northern"))]
    assert {"Dead centres; ends of valve travel", "TDC 0.00°", "farthest 250.16°"} <= set(both)


@pytest.mark.parametrize("name", ["3d12", "r_1340", "pumping_unit_c57", "vaz_21213"])
@pytest.mark.parametrize("kind", PLANS)
@pytest.mark.parametrize("angles", [12, [30.0, 60.0]])
def test_plan_is_readable(name, kind, angles):
    machine = ct.load(name)
    if (kind == "klein" and "pumping" in name) or (kind in ("klein", "centres") and angles == 12):
        with pytest.raises(InputError):
            PLANS[kind](machine, angles)
        return
    assert_words_are_readable(PLANS[kind](machine, angles))


@pytest.mark.parametrize("case", WORKS)
@pytest.mark.parametrize("plan", ["positions", "velocities", "accelerations", "centres"])
@pytest.mark.parametrize("angles", [[60.0], 24])
def test_plan_of_every_kind_is_readable(case, plan, angles):
    if plan == "centres" and isinstance(angles, int):
        with pytest.raises(InputError, match="at most 2 for instant centres"):
            plan_centres(WORKS[case], angles)
        return
    assert_words_are_readable(PLANS[plan](WORKS[case], angles))


@pytest.mark.parametrize("name", ["3d12", "vaz_21213", "eccentric_press"])
@pytest.mark.parametrize("draw", [plan_arc, plan_projection, plan_brix, plan_brix_backward])
@pytest.mark.parametrize("angles", [24, [60.0]])
def test_construction_is_readable(name, draw, angles):
    figure = draw(ct.load(name), angles)
    assert_words_are_readable(figure)
    words = " | ".join(text for text, _box in words_of(figure))
    for part in ("m/mm", "paper, mm", "S, mm", "exact"):
        assert part in words
    if draw is not plan_arc:
        assert "Range of the source: central mechanism, λ" in words


def test_instant_centres_that_are_not_drawn_are_said():
    machine = ct.Machine(mechanism={"kind": "slider_crank", "crank_radius": "30 mm", "rod_length": "50 mm"})
    words = " | ".join(text for text, _box in words_of(plan_centres(machine, [90.0])))
    assert "are parallel: it only" in words
    words = " | ".join(text for text, _box in words_of(plan_centres(machine, [89.0])))
    assert "too far away to be drawn: $P_{13}$" in words


@pytest.mark.parametrize(("angles", "message"), [(0, "at least one"), ([], "at least one"), (25, AT_MOST_TO_A_SHEET)])
def test_plan_of_too_many_or_no_angles_is_refused(angles, message):
    with pytest.raises(InputError, match=message):
        plan_positions(ct.load("vaz_21213"), angles)


@pytest.mark.parametrize("name", example_names())
def test_pins_on_the_sheet_are_the_kernels(name):
    """Piston pins by the result's own curves, on their bank's axis; crank pins by the angle."""
    machine = ct.load(name)
    of_pins = ("piston_displacement", "top_position", "rocker_angle", "point_x", "point_y")
    result = ct.run(machine, quantities=of_pins)
    scene = scene_of(machine)
    for member in scene.members:
        for angle in (0.0, 50.0, 217.0):
            place = machine.shafts[member.place.shaft].place or ()
            centre = np.array([1e3 * part.si for part in place] or [0.0, 0.0])
            pins = {name: pin - centre for name, pin in scene.pins(member, angle).items()}
            axes = frame(machine, member.place)
            at = int(angle)
            if member.is_plain:
                for number, label in enumerate(result.labels.get("point", ())):
                    owner, _, name = label.partition(".")
                    if owner != member.place.name or name not in pins:
                        continue
                    there = in_machine_axes(1e3 * result.point_x[number, at], 1e3 * result.point_y[number, at], axes)
                    np.testing.assert_allclose(pins[name], there, rtol=0, atol=1e-9)
                continue
            if member.output is None:
                turn = result.rocker_angle[0, at]
                radius = 1e3 * member.place.geometry.rocker_length
                x = 1e3 * member.place.geometry.ground_length + radius * np.cos(turn)
                expected = in_machine_axes(x, radius * np.sin(turn), axes)
                pin = pins["B"]
            else:
                number = result.labels["piston"].index(member.place.name)
                x = 1e3 * (result.top_position[number] - result.piston_displacement[number, at])
                expected = in_machine_axes(x, 1e3 * member.place.geometry.offset, axes)
                pin = pins[member.output]
            np.testing.assert_allclose(pin, expected, rtol=0, atol=1e-9)
            crank = np.deg2rad(angle) + machine.zero + member.place.phase
            if member.place.kind.name != "articulated_rod":
                arm = 1e3 * member.place.geometry.crank_radius
                there = in_machine_axes(arm * np.cos(crank), arm * np.sin(crank), axes)
                np.testing.assert_allclose(pins["A"], there, rtol=0, atol=1e-9)


def test_links_keep_their_lengths_on_paper():
    """Between eyes as drawn there are 320 mm of master rod and 242.426 mm of slave rod, at every angle."""
    scene = scene_of(ran("3d12").machines[0])
    for angle in range(0, 360, 10):
        first, second = (scene.pins(member, float(angle)) for member in scene.members)
        assert np.hypot(*(first["B"] - first["A"])) == pytest.approx(320.0, abs=1e-9)
        assert np.hypot(*(second["D"] - second["C"])) == pytest.approx(242.426, abs=1e-9)
        np.testing.assert_allclose(second["A"], first["A"], rtol=0, atol=1e-9)
        np.testing.assert_allclose(second["B"], first["B"], rtol=0, atol=1e-9)


def test_small_crank_has_a_detail():
    """At 1:7.5 the jaw crusher's 12 mm are 1.6 mm: the ring stands in a detail."""
    words = [text for text, _box in words_of(sheet_of("jaw_crusher"))]
    assert {"A", "A (1:1.5)", "200 mm, scale 1:7.5"} <= set(words)
    assert words.count("90") == 2  # one of the curves' axis
    assert not any("A (" in text for text, _box in words_of(sheet_of("vaz_21213")))


def test_every_slider_of_a_chain_is_drawn():
    """The crosshead, which moves the locomotive's valve gear, where the piston is."""
    result = ran("lms_class5")
    scene = scene_of(result.machines[0])
    piston, valve = scene.members
    assert [guide.pin for guide in valve.turn.guides] == ["valve.pin", "crosshead.pin"]
    sketch = mechanism_sketch(scene, 50.0, 40.0)
    middles = [np.mean(line.points, axis=1) for line in sketch.lines if line.is_closed and line.points.shape == (2, 4)]
    crosshead = scene.pins(piston, 50.0)["B"]
    np.testing.assert_allclose(scene.pins(valve, 50.0)["crosshead.pin"], crosshead, rtol=0, atol=1e-9)
    assert min(np.hypot(*(middle - crosshead)) for middle in middles) < 1e-9


def test_no_dead_position_runs_through_a_figure_of_the_ring():
    """The shaper's lever at its dead positions crosses where 150 would stand."""
    scene = scene_of(ran("shaper").machines[0])
    dead = [[mark.angle for mark in ruler_of(ran("shaper")).marks]]
    sketch = mechanism_sketch(scene, 50.0, 7.5, dead)
    for label in sketch.labels:
        for angle in dead[0]:
            pins = scene.pins(scene.members[0], angle)
            for link in scene.members[0].turn.links:
                ends = [pins[pin] for pin in link.pins]
                for start, end in pairwise(ends):
                    part = np.clip(np.dot(label.position - start, end - start) / np.dot(end - start, end - start), 0, 1)
                    assert label.text == "0" or np.hypot(*(start + part * (end - start) - label.position)) > 2.0 * 7.5


def test_drawn_parts_lie_on_the_layers_of_a_drawing_office():
    sketch = mechanism_sketch(scene_of(ran("kamaz_740").machines[0]), 50.0, 5.0)
    assert {line.layer for line in sketch.lines} == {"LINKS", "GUIDES", "PATHS", "DIMENSIONS"}


def test_curves_are_the_results():
    result = ran("kamaz_740")
    travel, velocity, acceleration, error = panels(result)
    assert [(panel.symbol, as_shown(panel).unit) for panel in (travel, velocity, acceleration)] == [
        ("s", "mm"),
        ("v", "m/s"),
        ("j", "m/s²"),
    ]
    exact = {curve.name: curve.values for curve in velocity.curves if curve.role != "textbook"}
    assert list(exact) == ["1R", "1L"]
    left = result.labels["piston"].index("1L")
    np.testing.assert_allclose(exact["1L"][:360], result.piston_velocity[left, :360], rtol=1e-14, atol=1e-13)
    assert exact["1L"][360] == exact["1L"][0]
    worst = max(np.max(np.abs(curve.values)) for curve in error.curves)
    form = result.labels["motion_method"].index("two_harmonics")
    assert worst == pytest.approx(100 * result.acceleration_error[form, 0], rel=1e-3)


def test_marks_are_the_true_dead_centres():
    found = {(mark.name, mark.is_top): mark.angle for mark in ruler_of(ran("r_1340")).marks}
    assert len(found) == 18
    assert found["1S", True] == pytest.approx(40.6, abs=0.05)


def test_animation_is_small_and_always_the_same(tmp_path):
    from PIL import Image

    content = animation(ran("r_1340"))
    assert len(content) < 1_000_000
    with Image.open(BytesIO(content)) as picture:
        assert picture.format == "GIF"
        assert picture.n_frames == 36
    save_animation(ran("vaz_21213"), tmp_path / "one.gif")
    assert (tmp_path / "one.gif").read_bytes() == animation(ran("vaz_21213"))
    with pytest.raises(InputError, match="is there already"):
        save_animation(ran("vaz_21213"), tmp_path / "one.gif")


@pytest.fixture(scope="module")
def drawn_twice():
    """The same sheet, drawn again."""
    return {name: sheet(ran("vaz_21213")) for name in ("one", "two")}


@pytest.mark.parametrize("suffix", [".png", ".svg", ".pdf"])
def test_saved_pictures_are_always_the_same(drawn_twice, tmp_path, suffix):
    for name, figure in drawn_twice.items():
        save(figure, tmp_path / (name + suffix))
    one, two = ((tmp_path / (name + suffix)).read_bytes() for name in ("one", "two"))
    assert one == two
    assert one.startswith({".png": b"\x89PNG", ".svg": b"<?xml", ".pdf": b"%PDF"}[suffix])


def test_bytes_to_the_standard_output(capfdbinary):
    write_whole("-", [b"\x89PNG\r\n", b"\x00"], force=False)
    assert capfdbinary.readouterr().out == b"\x89PNG\r\n\x00"


def test_picture_is_refused_before_it_is_drawn(tmp_path):
    there = tmp_path / "there.png"
    there.write_bytes(b"old")

    def draws():
        raise AssertionError("drawn in vain")

    with pytest.raises(InputError, match="is there already"):
        save(draws, there)
    with pytest.raises(InputError, match=rf"{ENDS_IN}\.png, \.svg, \.pdf"):
        save(draws, tmp_path / "picture.bmp")
    assert there.read_bytes() == b"old"


def test_user_settings_neither_matter_nor_change(tmp_path):
    import matplotlib

    save(sheet(ran("vaz_21213")), tmp_path / "one.png")
    with matplotlib.rc_context({"font.size": 30.0, "lines.linewidth": 9.0}):
        save(sheet(ran("vaz_21213")), tmp_path / "two.png")
        assert matplotlib.rcParams["font.size"] == 30.0
    assert (tmp_path / "one.png").read_bytes() == (tmp_path / "two.png").read_bytes()


def test_dxf_has_layers_true_lengths_and_no_date(tmp_path):
    ezdxf = pytest.importorskip("ezdxf")
    machine = ct.load("pumping_unit_c57")
    for name in ("one.dxf", "two.dxf"):
        dxf(machine, [30.0, 60.0], tmp_path / name)
    assert (tmp_path / "one.dxf").read_bytes() == (tmp_path / "two.dxf").read_bytes()
    document = ezdxf.readfile(tmp_path / "one.dxf")
    assert not document.audit().errors
    used = {entity.dxf.layer for entity in document.modelspace()}
    assert {"LINKS", "PATHS", "PLAN_V", "PLAN_A", "TEXT", "DIMENSIONS"} <= used
    dimensions = sorted(dimension.get_measurement() for dimension in document.modelspace().query("DIMENSION"))
    expected = [21 * 25.4, 56.05 * 25.4, 65.63 * 25.4]
    np.testing.assert_allclose(dimensions, expected, rtol=1e-9)
    written = {
        float(part.text)
        for dimension in document.modelspace().query("DIMENSION")
        for part in dimension.get_geometry_block()
        if part.dxftype() == "MTEXT"
    }
    np.testing.assert_allclose(sorted(written), expected, atol=5e-4)


def test_dxf_of_opposed_pistons_has_both(tmp_path):
    ezdxf = pytest.importorskip("ezdxf")
    dxf(ct.load("10d100"), [40.0], tmp_path / "both.dxf")
    dxf(ct.load("10d100"), [40.0], tmp_path / "one.dxf", mechanism="1.exhaust")
    counts = {
        name: len(ezdxf.readfile(tmp_path / f"{name}.dxf").modelspace().query("DIMENSION")) for name in ("both", "one")
    }
    assert counts == {"both": 4, "one": 2}


@pytest.mark.parametrize("case", WORKS)
def test_dxf_of_every_kind(tmp_path, case):
    ezdxf = pytest.importorskip("ezdxf")
    dxf(WORKS[case], [60.0], tmp_path / "one.dxf")
    document = ezdxf.readfile(tmp_path / "one.dxf")
    assert not document.audit().errors
    assert {"LINKS", "PLAN_V", "PLAN_A"} <= {entity.dxf.layer for entity in document.modelspace()}


def test_dxf_without_its_package_says_what_to_install(tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "ezdxf", None)
    with pytest.raises(InputError, match="needs the package ezdxf"):
        dxf(ct.load("vaz_21213"), 12, tmp_path / "one.dxf")
    assert not (tmp_path / "one.dxf").exists()


@pytest.mark.parametrize(
    ("width", "height", "words"),
    [(100.0, 10.0, "1:1"), (130.0, 10.0, "1:1.5"), (10.0, 720.0, "1:7.5"), (30.0, 30.0, "2:1"), (9.0, 9.0, "10:1")],
)
def test_scales_are_a_draughtsmans(width, height, words):
    assert scale_words(fitting_scale(width, height, (100.0, 100.0))) == words


@pytest.mark.parametrize("name", example_names())
def test_sheet_and_terminal_count_the_same_numbers(name):
    file = read_machine(name)
    assert provenance_words(file.machine) == "Inputs: " + counted_by_status(one.given for one in inputs_of(file))


def test_symbols_are_set_as_mathematics():
    assert mathematics("v_B,main") == formula(r"v_{B,\mathrm{main}}")
    assert mathematics("a_long_rod'^n") == formula(r"a_{\mathrm{long\_rod}′}^{n}")
    assert mathematics("v_AA'") == formula("v_{AA′}")
    assert mathematics("a_BA^n") == formula("a_{BA}^{n}")
    assert mathematics("p") == formula("p")


def test_plotting_library_is_loaded_only_to_draw():
    code = "import sys, cranktrain as ct, cranktrain.viz as viz; ct.run(ct.load('vaz_21213')); viz.sheet; viz.save; "
    done = subprocess.run(
        [sys.executable, "-c", code + "sys.exit('matplotlib' in sys.modules)"],
        env={"PYTHONPATH": ":".join(sys.path)},
        check=False,
    )
    assert done.returncode == 0


def test_sheet_says_that_other_shafts_are_not_drawn():
    mechanism = {"kind": "slider_crank", "crank_radius": "50 mm", "rod_length": "180 mm"}
    banks = {"A": {"mechanism": mechanism}, "B": {"shaft": "upper", "angle": "180 deg", "mechanism": mechanism}}
    figure = sheet(ct.run(ct.Machine(shaft={"upper": {"ratio": -1}}, bank=banks)))
    assert any("of shaft main, no other is drawn" in text.get_text() for text in figure.findobj(Text))


SIDE_RODS = {
    "name": "One shaft",
    "shaft": {"main": {"throws": ["0 deg", "180 deg"], "speed": "1000 rpm"}},
    "bank": {
        "A": {
            "exhaust": {"mechanism": {"kind": "slider_crank", "crank_radius": "80 mm", "rod_length": "300 mm"}}
            | {"throws": [1]},
            "scavenge": {"mechanism": {"kind": "slider_crank", "crank_radius": "80 mm", "rod_length": "570 mm"}}
            | {"throws": [2], "side_rods": True},
        }
    },
    "cylinder": {"bore": "100 mm", "compression_ratio": 14, "exhaust_port": "40 mm", "scavenge_port": "30 mm"},
}
FACING = {"kind": "slider_crank", "crank_radius": "80 mm", "rod_length": "300 mm"}
NO_PLACE = {
    "running": "astern",
    "shaft": {"main": {"speed": "900 rpm"}, "upper": {"ratio": -1}},
    "bank": {
        "A": {
            "angle": "30 deg",
            "lead": "12 deg",
            "exhaust": {"mechanism": FACING, "shaft": "upper"},
            "scavenge": {"mechanism": FACING},
        }
    },
    "cylinder": {"bore": "90 mm"},
}


def ends(lines):
    """Ends of straight lines, each as a sorted pair of places along Y, rounded. [mm]"""
    return sorted(tuple(sorted(round(float(y), 6) for y in line.points[1])) for line in lines)


@pytest.mark.parametrize("case", [SIDE_RODS, NO_PLACE], ids=["side rods", "no place"])
def test_sheet_of_opposed_pistons_is_readable(case):
    assert_words_are_readable(sheet(ct.run(ct.Machine(**case))))


def test_deltic_is_a_triangle():
    """Six pistons of three shafts; what shares a cylinder lies on one line, and what shares a pin meets there."""
    result = ran("deltic")
    scene = scene_of(result.machines[0])
    assert [member.place.name for member in scene.members] == [
        f"1{bank}.{end}" for bank in "ABC" for end in ("exhaust", "scavenge")
    ]
    assert [member.place.shaft for member in scene.cranks] == ["main", "bottom", "right"]
    assert len(scene.pairs) == 3
    for one, other in scene.pairs:
        across = one.stroke_line.across @ (other.turn_pins["B"] - one.centre[:, np.newaxis])
        np.testing.assert_allclose(across, 0.0, atol=1e-4)  # places of shafts in the file have so many digits
    for one, other in (("1A.exhaust", "1C.scavenge"), ("1A.scavenge", "1B.exhaust"), ("1B.scavenge", "1C.exhaust")):
        pins = {member.place.name: member.turn_pins["A"] for member in scene.members}
        np.testing.assert_allclose(pins[one], pins[other], rtol=0, atol=1e-9)


def test_reversed_shaft_turns_the_other_way():
    scene = scene_of(ran("deltic").machines[0])
    turns = {
        member.place.shaft: scene.crank_direction(11.0, member) - scene.crank_direction(10.0, member)
        for member in scene.cranks
    }
    degree = np.deg2rad(1.0)
    assert turns == pytest.approx({"main": -degree, "right": -degree, "bottom": degree})


@pytest.mark.parametrize("angle", [0.0, 50.0, 186.0])
def test_room_between_two_pistons_is_the_results(angle):
    """What the pins part on paper since the least is what both pistons sweep together; crowns never meet."""
    result = ran("10d100")
    scene = scene_of(result.machines[0])
    ((one, other),) = scene.pairs
    apart = [
        float((scene.pins(other, at)["B"] - scene.pins(one, at)["B"])[1])
        for at in (angle, result.inner_volumetric_dead_centre[0])
    ]
    combined = 1e3 * result.combined_displacement[0, int(angle)]
    assert apart[0] - apart[1] == pytest.approx(combined, abs=1e-9)
    assert scene.above(one) + scene.above(other) < apart[1]


def test_common_cylinder_has_no_head_and_gaps_for_ports():
    """10D100: 60 and 50 mm from where the crowns stand at their outer dead centres, 381 mm from their shafts."""
    scene = scene_of(ran("10d100").machines[0])
    one, other = scene.members
    sketch = mechanism_sketch(scene, 50.0, 15.0)
    walls = ends(line for line in sketch.lines if line.layer == "GUIDES" and line.habit == "outline")
    assert len(walls) == 6
    assert walls[::2] == walls[1::2]
    first, middle, last = walls[::2]
    assert first[1] == pytest.approx(508 - 127 + scene.above(one))
    assert middle == pytest.approx((first[1] + 60.0, 1480 - 381 - scene.above(other) - 50.0))
    assert last[0] == pytest.approx(1480 - 381 - scene.above(other))


def test_far_piston_has_its_crown_toward_the_shaft():
    scene = scene_of(ct.Machine(**SIDE_RODS))
    near, far = scene.members
    assert [member.toward_chamber for member in (near, far)] == [1.0, -1.0]
    sketch = mechanism_sketch(scene, 0.0, 6.0)
    dashed = [line for line in sketch.lines if line.habit == "part"]
    assert len(dashed) == 1
    words = " | ".join(text for text, _box in words_of(sheet(ct.run(scene.machine))))
    assert "dashed: side rods" in words
    assert "Throws 1, 2 of 2, drawn at φ = 50°" in words


def test_sheet_of_opposed_pistons_says_what_it_shows():
    words = " | ".join(text for text, _box in words_of(sheet_of("10d100")))
    for part in (
        "Volumetric dead centres",
        "inner 6.00°",
        "outer 186.00°",
        "Travel of both together, cylinder 1 | $x_\\Sigma$ | , mm",
        "Volume between them | $V$ | , L",
        "Throw 1 of 10, drawn at φ = 50°; shafts main, upper",
        "thin: volumetric dead centres",
    ):
        assert part in words
    words = " | ".join(text for text, _box in words_of(sheet(ct.run(ct.Machine(**NO_PLACE)))))
    assert "distance of the shafts assumed for the drawing" in words


def test_opposed_curves_are_the_results():
    result = ran("10d100")
    found = {panel.symbol: panel for panel in panels(result)}
    assert list(found) == ["s", r"x_\Sigma", "V", "v", "j"]
    assert [(curve.name, curve.role) for curve in found["s"].curves] == [
        ("1.exhaust", "first"),
        ("1.scavenge", "second"),
    ]
    scavenge = result.labels["piston"].index("1.scavenge")
    np.testing.assert_allclose(found["v"].curves[1].values[:360], result.piston_velocity[scavenge, :360], atol=1e-13)
    np.testing.assert_allclose(found["V"].curves[0].values[:360], result.chamber_volume[0, :360], rtol=1e-14)
    assert [(mark.name, mark.is_top) for mark in ruler_of(result).marks] == [("1", True), ("1", False)]


@pytest.mark.parametrize("name", ["3d12", "deltic", "lms_class5", "pumping_unit_c57"])
def test_a_sheet_needs_only_the_quantities_that_it_shows(tmp_path, name):
    few = ct.run(ct.load(name), quantities=SHEET_QUANTITIES)
    assert "closing_margin" not in few.catalogue
    for figure, path in ((sheet(few), "few.svg"), (sheet_of(name), "all.svg")):
        save(figure, tmp_path / path)
    assert (tmp_path / "few.svg").read_bytes() == (tmp_path / "all.svg").read_bytes()


def test_rod_that_stands_for_none_is_broken():
    """A rod of 100000 in would make the sheet 1:25000."""
    words = [text for text, _box in words_of(sheet_of("great_northern"))]
    assert any("rod of 1valve broken, its slider drawn nearer to the shaft" in said for said in words)
    assert any(re.fullmatch(r"[1-4]?\d in, scale 1:25", said) for said in words)


def test_pins_with_long_names_have_letters_and_a_key():
    words = [text for text, _box in words_of(plan_velocities(ct.load("traction_engine"), [60.0], mechanism="1valve"))]
    key = next(text for text in words if text.startswith("Pins: "))
    assert "ahead joint" in key
    assert not any("_" in text and "$" not in text for text in words)
    assert not any("mathrm" in text for text in words)
    assert not any(text.startswith("Pins: ") for text, _box in words_of(plan_velocities(ct.load("shaper"), [60.0])))


@pytest.mark.parametrize("name", ["lms_class5", "traction_engine"])
@pytest.mark.parametrize("plan", ["positions", "velocities", "accelerations", "centres"])
@pytest.mark.parametrize("angles", [[60.0], [30.0, 60.0]])
def test_plan_of_a_valve_gear_is_readable(name, plan, angles):
    if plan == "centres" and len(angles) > 1:
        with pytest.raises(InputError, match="must be one for the instant centres of"):
            plan_centres(ct.load(name), angles, mechanism="1valve")
        return
    assert_words_are_readable(PLANS[plan](ct.load(name), angles, mechanism="1valve"))


NAMED = """\
name = "pump, $5 and $6 {x_^ \\u001b[31m"
[mechanism]
kind = "slider_crank"
stroke = "80 mm"
rod_length = "136 mm"
points."a$b$_{" = { link = "rod", along = "30 mm", across = "10 mm" }
points."a^^b %%d" = { link = "rod", along = "50 mm", across = "10 mm" }
[shaft.main]
speed = "1500 rpm"
"""


def test_a_dollar_in_a_name_begins_no_formula(tmp_path):
    (tmp_path / "pump.toml").write_text(NAMED, encoding="utf-8")
    machine = ct.load(tmp_path / "pump.toml")
    for drawn in (sheet(ct.run(machine)), plan_positions(machine, 4), plan_velocities(machine, [30.0])):
        title = next(one for one in drawn.findobj(Text) if "pump" in one.get_text())
        assert title.get_text() == r"pump, $5 and $6 {x_^ \x1b[31m"
        assert not title.get_parse_math()
        save(drawn, tmp_path / "pump.svg", force=True)


@pytest.mark.parametrize("name", ["a$b", "a^^b", "x_{", "two words", "%", "\\", "_", "^"])
def test_a_name_that_is_no_symbol_stays_as_it_is(name):
    assert mathematics(name) == name


def test_only_marked_formulas_are_set_as_such():
    from cranktrain.viz.paper.page import set_words

    assert set_words("5 $ of A_1") == {"s": "5 $ of A_1", "parse_math": False}
    assert set_words(f"$ of {formula('A_1')}") == {"s": r"\$ of $A_1$", "parse_math": True}
    for path in Path(str(files("cranktrain.viz"))).rglob("*.py"):
        if path.name not in ("page.py", "cad.py"):
            assert "$" not in path.read_text(encoding="utf-8"), path.name


def test_signs_of_a_dxf_that_mean_something_are_no_part_of_a_name(tmp_path):
    (tmp_path / "pump.toml").write_text(NAMED, encoding="utf-8")
    dxf(ct.load(tmp_path / "pump.toml"), 4, tmp_path / "pump.dxf")
    assert "%%" not in (tmp_path / "pump.dxf").read_text(encoding="utf-8")


@pytest.mark.parametrize(("rocker", "is_said"), [("100 mm", False), ("200 mm", True)])
def test_thin_lines_are_explained_only_where_there_are_any(rocker, is_said):
    """A parallelogram's rocker turns all round with its crank: it has no dead positions."""
    four_bar = {"crank_radius": "100 mm", "rod_length": "300 mm", "rocker_length": rocker, "ground_length": "300 mm"}
    machine = ct.Machine(mechanism={"kind": "crank_rocker"} | four_bar, shaft={"main": {"speed": "60 rpm"}})
    figure = ct.viz.sheet(ct.run(machine))
    words = " ".join(text.get_text() for axes in figure.axes for text in axes.texts)
    assert ("thin" in words) is is_said
    assert "shapes schematic" in words
