"""Crosshead, piston rod and covers of pistons that work at both ends: where they lie along the line of stroke."""

import matplotlib as mpl
import numpy as np
import pytest
from tests.machines import slider

import cranktrain as ct
from cranktrain.panels.throw_scene import scene_of
from cranktrain.viz.throw.mechanism import mechanism_sketch

mpl.use("Agg")
ANGLES = np.arange(0.0, 360.0, 5.0)
BOTH = {"bore": "100 mm", "chambers": ["head", "crank"]}
EXAMPLES = ("mill_engine", "traction_engine", "gas_compressor", "great_northern", "lms_class5")
SIZES = {
    "usual": (slider(), BOTH),
    "its own rod": (slider(), BOTH | {"piston_rod": "30 mm"}),
    "differential": (slider(), BOTH | {"piston_rod": "80 mm"}),
    "long stroke": (slider(), BOTH | {"bore": "20 mm"}),
    "short stroke": (slider(), BOTH | {"bore": "500 mm"}),
    "offset": (slider(offset="20 mm"), BOTH),
    "crank end alone": (slider(), BOTH | {"chambers": ["crank"]}),
}


def drawn_outputs(machine):
    """Outputs with a crosshead, and where their pins are along their lines at every angle."""
    drawing = ct.drawing(machine, ANGLES)
    outputs = [(one, one.output) for one in drawing.mechanisms if one.output is not None]
    return [
        (one, out, out.along @ (one.pins[out.pin] - out.foot[:, np.newaxis]))
        for one, out in outputs
        if out.crosshead is not None
    ]


def machines():
    for name in EXAMPLES:
        yield pytest.param(lambda name=name: ct.load(name), id=name)
    for name, (mechanism, cylinder) in SIZES.items():
        bank = {"A": {"mechanism": mechanism}}
        yield pytest.param(lambda bank=bank, cylinder=cylinder: ct.Machine(bank=bank, cylinder=cylinder), id=name)


@pytest.mark.parametrize("made", list(machines()))
def test_crosshead_runs_on_its_bars_between_crank_and_gland_and_the_piston_between_the_covers(made):
    found = drawn_outputs(made())
    assert found
    for one, out, pin in found:
        crosshead = out.crosshead
        near, far = pin - 0.5 * crosshead.shoe[0], pin + 0.5 * crosshead.shoe[0]
        assert np.all(near > crosshead.bars[0])
        assert np.all(far < crosshead.bars[1])
        assert crosshead.bars[1] < crosshead.gland < crosshead.covers[0]  # no slide bar within the cylinder
        crank = np.max(out.along @ (one.pins[one.links[0].pins[1]] - out.foot[:, np.newaxis]))
        assert crosshead.bars[0] > crank or near.min() > crank
        middle = pin + crosshead.rod_length
        assert np.all(middle - 0.5 * crosshead.piston > crosshead.covers[0])
        assert np.all(middle + 0.5 * crosshead.piston < crosshead.covers[1])
        assert crosshead.rod_diameter < min(out.bore, crosshead.shoe[1])


def test_piston_rod_of_the_file_is_drawn():
    (_one, out, _pin), *_none = drawn_outputs(ct.load("mill_engine"))
    assert out.crosshead.rod_diameter == pytest.approx(1.5 * 0.0254, rel=1e-15)
    assert out.bore == pytest.approx(9 * 0.0254, rel=1e-15)


@pytest.mark.parametrize(
    "name", ["r_1340", "3d12", "vaz_21213", "deltic", "shears", "mud_pump_12p160", "burning_cylinder"]
)
def test_trunk_pistons_and_blades_have_none(name):
    assert drawn_outputs(ct.load(name)) == []


def test_a_piston_without_a_bore_has_none():
    assert (
        drawn_outputs(ct.Machine(bank={"A": {"mechanism": slider()}}, cylinder={"chambers": ["head", "crank"]})) == []
    )


def test_no_slide_bar_and_no_gland_is_drawn_within_the_cylinder():
    scene = scene_of(ct.load("mill_engine"))
    (member,) = scene.members
    sketch = mechanism_sketch(scene, 50.0, 10.0, has_ring=False)
    near, far = member.crosshead.covers
    for line in sketch.lines:
        if line.layer != "GUIDES" or line.habit == "axis":
            continue
        along = member.stroke_line.place(line.points[:, np.isfinite(line.points[0])])
        hatch = 2.0 * sketch.scale  # ticks stand off by so much
        within = (along > near + hatch) & (along < far - hatch)
        across = np.abs(line.points[:, np.isfinite(line.points[0])].T @ member.stroke_line.across)
        assert np.all(across[within] >= 0.5 * member.bore * (1 - 1e-12))


def test_the_rod_that_moves_a_valve_gear_is_drawn_once():
    scene = scene_of(ct.load("lms_class5"))
    cylinder, valve = scene.members
    assert scene.shared_pins[cylinder.place.name] == frozenset()
    shared = scene.shared_pins[valve.place.name]
    crosshead = cylinder.turn_pins["B"]
    assert any(np.allclose(valve.turn_pins[name], crosshead, rtol=0, atol=1e-6) for name in shared)
    rods = [line for line in mechanism_sketch(scene, 50.0, 25.0).lines if line.order in (5, 6) and line.fill == "paper"]
    ends = [scene.pins(cylinder, 50.0)[pin] for pin in ("A", "B")]
    middle = 0.5 * (ends[0] + ends[1])
    assert not any(np.allclose(np.mean(line.points, axis=1), middle, atol=5.0) for line in rods)
