"""The chain from motor to crank beside a scheme: symbols by kind, a table by hand, no words over words, also in DXF."""

import math
import re
from collections import Counter
from functools import cache
from io import BytesIO
from itertools import pairwise

import numpy as np
import pytest
from tests.words_on_paper import assert_words_are_readable, words_of

import cranktrain as ct
from cranktrain.errors import InputError
from cranktrain.plans.drive_scheme import drive_chain
from cranktrain.viz import dxf, plan_scheme
from cranktrain.viz.paper.page import drawing_settings

RPM = math.pi / 30

DRIVEN = {
    "tilting_table": "motor disc disc disc gear linkage crank",
    "jaw_crusher": "motor belt disc disc crank",
    "compressor_start": "motor belt disc crank",
    "high_slip_press": "motor belt disc clutch gear brake crank",
    "shears": "motor belt disc gear crank",
    "shaking_conveyor": "motor stage crank",
    "servo_press": "disc gear disc crank",
    "servo_press_rocking": "disc gear disc crank",
}

SHAFTS = {
    # rpm of the crank times the ratios behind each shaft; kg·m² of what the file has on it, GD²/4
    "tilting_table": [(37.5 * 40, (0.08 + 0.62 + 1.3 + 0.4) / 4), (37.5, 0), (37.5, 0)],
    "jaw_crusher": [(275 * 5.375, None), (275, 60 + 60)],
    "compressor_start": [(1500 * 0.96, None), (1500, 0.08)],
    "high_slip_press": [(91 * 5 * 3.3, 0), (91 * 5, 24 + 0.4), (91, 0)],
    "shears": [(40 * 11.5 * 3, 0.03), (40 * 11.5, 15), (40, 0)],
    "shaking_conveyor": [(60 * 24, None), (60, 0)],
}
"""None where the catalogue has the rotor."""

WRITTEN = {
    # P ω: 2.5 · 5500 W / (1440 π/30) = 91.18; 2 − 1/0.96 = 0.9583; 2 − 1/0.94 = 0.9362; 2 − 1/0.9 = 0.8889
    "tilting_table": [
        "1500 rpm, J = 0.6000 kg·m²",
        "J = 0.1550 kg·m², GD² = 0.6200 kg·m²",
        "i = 40, η_f = 0.94, η_b = 0.9362",
        "i = 1, η_f = 0.9, η_b = 0.8889",
        "6  linkage",
    ],
    "jaw_crusher": ["2  belt", "i = 5.375, η_f = 0.95, η_b = 0.9474", "275.0 rpm, J = 120.0 kg·m²"],
    "high_slip_press": [
        "2  belt",
        "i = 3.3, η_f = 1, η_b = 1",
        "455.0 rpm, J = 24.40 kg·m²",
        "M = 4800 N·m, M_s = 6000 N·m, J = 0.4000 kg·m²",
        "i = 5, η_f = 0.96, η_b = 0.95",
        "M = 2600 N·m, M_s = 2800 N·m",
    ],
    "shears": ["P = 5.500 kW", "n = 1440 rpm, M_b = 91.18 N·m, J = 0.03000 kg·m²", "i = 3, η_f = 0.96, η_b = 0.9583"],
    "shaking_conveyor": ["2  stage, its kind not said", "P = 1.500 kW, n = 1445 rpm"],
}

LONG = {
    "motor": {"kind": "cage", "size": "4 kW"},
    "stage": [
        {"ratio": 2, "kind": "belt"},
        {"ratio": 3, "efficiency": 0.9, "kind": "chain"},
        {"ratio": 0.5},
        {"ratio": 12.5, "drag": "1 N*m", "lead_angle": "10 deg", "friction_angle": "4 deg"},
    ],
    "part": {f"part_{n}": {"on": "motor" if n == 0 else n, "inertia": f"{n + 1} kg*m^2"} for n in range(5)},
    "clutch": {"on": 1, "torque": "40 N*m"},
    "brake": {"on": "crank", "torque": "90 N*m"},
}


def drive_of(**drive):
    return ct.load("tilting_table").with_({"drive": drive})


def words_beside(drawn):
    """As they stand, indices behind a _."""
    assert_words_are_readable(drawn)
    return [re.sub(r"\$([^$]*_[^$]*)\$", lambda found: plain(found[1]), text) for text, _box in words_of(drawn)]


def plain(tex):
    """A formula's letter and its index, without what sets them."""
    return re.sub(r"\\[a-z]+|[{}]", "", tex)


def symbols_in_svg(drawn):
    """How often an SVG has each symbol, by the names of its groups."""
    content = BytesIO()
    with drawing_settings():
        drawn.savefig(content, format="svg")
    found = re.findall(r'id="drive-([a-z]+)-(\d+)"', content.getvalue().decode())
    assert len(set(found)) == len(found)
    return Counter(symbol for symbol, _number in found)


@cache
def machine_of(name):
    """An example, or the one with a long chain."""
    return drive_of(**LONG) if name == "long" else ct.load(name)


@cache
def scheme_of(name):
    """Its scheme, drawn once for all that is asked of it."""
    return plan_scheme(machine_of(name))


@pytest.mark.parametrize("name", DRIVEN)
def test_symbols_are_those_of_the_file(name):
    symbols = symbols_in_svg(scheme_of(name))
    n_shafts = symbols.pop("shaft")
    assert symbols == Counter(DRIVEN[name].split())
    assert n_shafts == 1 + len(ct.load(name).drive.stage)


@pytest.mark.parametrize("size", ["A4", "A3"])
@pytest.mark.parametrize("name", [*DRIVEN, "long"])
def test_no_words_lie_over_others(name, size):
    drawn = scheme_of(name) if size == "A4" else plan_scheme(machine_of(name), size=size)
    words = words_beside(drawn)
    elements = [one for shaft in drive_chain(machine_of(name)) for one in shaft.elements]
    for number, one in enumerate(elements, start=1):
        assert words.count(str(number)) == 1
        assert sum(text.startswith(f"{number}  {one.words}") for text in words) == 1
    assert [text for text in words if text.startswith("Shaft ")] == [
        f"Shaft {numeral}" for numeral in ("I", "II", "III", "IV", "V")[: len(drive_chain(machine_of(name)))]
    ]


def test_rows_of_a_long_table_do_not_touch():
    drawn = scheme_of("long")
    left = [box for text, box in words_of(drawn) if re.match(r"\d+  |Shaft ", text)]
    tops = sorted((box.y0, box.y1) for box in left)
    assert len(tops) == 13 + 5
    assert all(upper[0] > lower[1] for lower, upper in pairwise(tops))
    once = ("motor", "belt", "clutch", "chain", "stage", "worm", "brake", "crank")
    assert symbols_in_svg(drawn) == {"shaft": 5, "disc": 5} | dict.fromkeys(once, 1)


@pytest.mark.parametrize("name", SHAFTS)
def test_speeds_and_inertias_of_shafts(name):
    for shaft, (rpm, inertia) in zip(drive_chain(ct.load(name)), SHAFTS[name], strict=True):
        assert shaft.speed == pytest.approx(rpm * RPM, rel=1e-12)
        if inertia is not None:
            assert shaft.inertia == pytest.approx(inertia, rel=1e-12)


@pytest.mark.parametrize("name", WRITTEN)
def test_table_has_the_numbers_of_the_file(name):
    words = words_beside(scheme_of(name))
    assert [text for text in WRITTEN[name] if text not in words] == []


def test_worm_by_its_angles_and_drag():
    # tan 10°/tan 14° = 0.7072, tan 6°/tan 10° = 0.5961
    words = words_beside(scheme_of("long"))
    assert any(text.startswith("i = 12.5, η_f = 0.7072, η_b = 0.5961") for text in words)
    assert any("M_0 = 1.000 N·m" in text for text in words)
    assert "10  worm gear" in words


def test_crank_shaft_has_the_same_mark_and_letter_in_both():
    drawn = scheme_of("jaw_crusher")
    words = words_beside(drawn)
    assert words.count("$O$") == 2
    assert "5  crank shaft O, the same as in the mechanism" in words
    circles = [one for one in drawn.axes[0].patches if hasattr(one, "radius")]
    # Rings of 0.8 and 1.6 mm of paper; at the shaft, the bearing's pin of 0.8 mm lies below.
    outer = [one.center for one in circles if one.radius == pytest.approx(1.6)]
    assert len(outer) == 2
    for centre in outer:
        assert any(one.center == pytest.approx(centre) and one.radius == pytest.approx(0.8) for one in circles)


def test_coupling_is_drawn_in_line():
    assert symbols_in_svg(plan_scheme(drive_of(stage=[{"ratio": 1, "kind": "coupling"}])))["coupling"] == 1


@pytest.mark.parametrize("name", ["servo_press", "servo_press_rocking"])
def test_crank_that_moves_by_a_curve_has_no_speed(name):
    words = words_beside(scheme_of(name))
    assert "Drive" in words
    assert "The crank moves as [shaft.main.motion] says, not at one speed." in words
    assert not any("rpm" in text for text in words if not text.startswith("Slider-crank"))
    assert {"J = 0.08000 kg·m²", "J = 4.000 kg·m²"} <= set(words)


def test_weights_of_the_rocker_at_its_pins():
    # J₁ = 50 kg·m² on r₁ = 0.5 m is 200 kg at A; at B it has the same energy, so (v_A/v_B)² of it.
    def rocker(crank):
        """Angle of the rocker by the cosine rule in the triangles OBO₁ and ABO₁; open linkage."""
        across = 0.8 - 0.25 * np.cos(crank)
        up = -0.25 * np.sin(crank)
        far = np.hypot(across, up)
        own = np.arccos((far**2 + 0.5**2 - 0.7**2) / (2 * far * 0.5))
        return np.pi + np.arctan2(up, across) - own

    at, step = np.deg2rad(50.0), 1e-5
    rate = (rocker(at + step) - rocker(at - step)) / (2 * step)
    expected = 200.0 * (0.5 * rate / 0.25) ** 2
    words = words_beside(scheme_of("tilting_table"))
    assert words[words.index("weight of what the rocker turns, at A") + 1] == "200.0 kg"
    assert words[words.index("the same at B, (17)") + 1] == f"{expected:.2f} kg"


def test_flywheel_of_evenness_turns_with_the_crank():
    machine = ct.load("shears").with_({"evenness": {"flywheel_moment": "8 kg*m^2"}})
    assert drive_chain(machine)[-1].inertia == pytest.approx(2.0)
    assert [one.symbol for one in drive_chain(machine)[-1].elements] == ["disc", "crank"]


def test_more_parts_than_a_sheet_has_room_for():
    parts = {f"part_{n}": {"inertia": "1 kg*m^2"} for n in range(60)}
    with pytest.raises(InputError, match="rows of the drive's table on this sheet"):
        plan_scheme(drive_of(part=parts))


def test_without_a_drive_there_is_none():
    machine = ct.load("pumping_unit_c57")
    drawn = plan_scheme(machine)
    assert drive_chain(machine) == ()
    assert not any(text.startswith("Drive") for text in words_beside(drawn))
    assert symbols_in_svg(drawn) == Counter()


def test_without_a_shaft_there_is_no_speed():
    mechanism = {"kind": "slider_crank", "stroke": "100 mm", "rod_length": "200 mm"}
    machine = ct.Machine(name="w", mechanism=mechanism, drive={"stage": [{"ratio": 2}]})
    assert all(math.isnan(shaft.speed) for shaft in drive_chain(machine))
    words = words_beside(plan_scheme(machine))
    assert {"Drive", "i = 2, η_f = 1, η_b = 1"} <= set(words)


def test_dxf_has_the_chain_and_its_table(tmp_path):
    ezdxf = pytest.importorskip("ezdxf")
    dxf(ct.load("high_slip_press"), [40.0], tmp_path / "press.dxf")
    document = ezdxf.readfile(tmp_path / "press.dxf")
    assert not document.audit().errors
    space = document.modelspace()
    drawn = [one for one in space if one.dxf.layer == "DRIVE"]
    # the motor, and the rings of the crank's shaft in the chain and at the mechanism
    assert sum(one.dxftype() == "CIRCLE" for one in drawn) == 1 + 2 + 2
    words = [one.dxf.text for one in space.query("TEXT")]
    assert {"M", "O", "I", "II", "III", *"1234567"} <= set(words)
    assert any(text == "4  clutch   M = 4800 N·m, M_s = 6000 N·m, J = 0.4000 kg·m²" for text in words)
    metal = [point[0] for one in space.query("LWPOLYLINE") if one.dxf.layer != "DRIVE" for point in one]
    chain = [point[0] for one in space.query("LWPOLYLINE") if one.dxf.layer == "DRIVE" for point in one]
    assert max(chain) < min(metal)


def test_dxf_without_a_drive_has_no_layer_for_it(tmp_path):
    ezdxf = pytest.importorskip("ezdxf")
    dxf(ct.load("pumping_unit_c57"), [40.0], tmp_path / "unit.dxf")
    assert "DRIVE" not in ezdxf.readfile(tmp_path / "unit.dxf").layers
