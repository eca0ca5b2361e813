"""A load leaves a mark in each picture of every kind: where it acts, in its direction, with its name."""

import numpy as np
import pytest
from tests.contract.test_loads import loaded
from tests.words_on_paper import assert_words_are_readable, words_of

import cranktrain as ct
from cranktrain.mechanisms import KINDS
from cranktrain.panels.throw_scene import scene_of
from cranktrain.plans.force_polygons import force_polygons
from cranktrain.plans.positions import position_plan
from cranktrain.plans.shown_loads import shown_loads
from cranktrain.plans.zhukovsky import zhukovsky_lever
from cranktrain.questions.loads.load_work import LoadWork
from cranktrain.viz import plan_forces, plan_positions, plan_velocities, plan_zhukovsky, sheet, sheet_loads
from cranktrain.viz.paper.load_arrows import load_words
from cranktrain.viz.plans.cad import dxf
from cranktrain.viz.plans.sketches import positions_sketch
from cranktrain.viz.throw.mechanism import mechanism_sketch

ANGLES = [33.0, 200.0]


def first_mechanism(machine):
    """The mechanism that the loads of `loaded` are on, and those."""
    names = {load.on for load in machine.load.values()}
    place = next(
        place
        for place in machine.places
        if names & {"piston" if one == "slider" else one for one in place.kind.dynamics.moving}
    )
    return place, shown_loads(machine, [place])


def one_of_each(kind):
    """The kind's machine with two loads of its many, a force and a torque where there is one."""
    machine = loaded(kind)
    place, loads = first_mechanism(machine)
    acting = loads.at(np.array(ANGLES))
    chosen = {}
    for load in acting:
        if np.all(np.abs(load.size) > 0) and (load.is_torque or np.any(load.way)):
            chosen.setdefault(load.is_torque, load.name)
    return machine.with_({"load": {name: machine.declared["load"][name] for name in chosen.values()}}), place.name


@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: kind.name)
def test_every_load_is_drawn(kind):
    """On the throw, on a plan of one position and on one of several, that many arrows, each where its load acts."""
    machine = loaded(kind)
    place, loads = first_mechanism(machine)
    for angle in ANGLES:
        acting = loads.at(np.array([angle]))
        there = [load for load in acting if load.is_torque or np.any(load.way)]
        pulling = [load for load in there if load.size[0]]
        assert len(pulling) >= 3
        plan = position_plan(machine, [angle], mechanism=place.name)
        sketch = positions_sketch(plan, loads=loads)
        heads = [line for line in sketch.lines if line.layer == "LOADS" and line.habit == "arrow"]
        assert len(heads) == len(pulling)
        said = {label.text for label in sketch.labels}
        assert {load_words(load) for load in there} <= said
        scene = scene_of(machine, (place,))
        drawn = mechanism_sketch(scene, angle, 2.0)
        on_shafts = [load for load in loads.on_shafts_at(np.array([angle])) if load.size[0]]
        heads = [line for line in drawn.lines if line.habit == "arrow" and line.layer == "LOADS"]
        assert len(heads) == len(pulling) + len(on_shafts)
        said = {label.text for label in drawn.labels}
        assert {load_words(load) for load in there} <= said
    several = positions_sketch(position_plan(machine, ANGLES, mechanism=place.name), loads=loads)
    acting = loads.at(np.array(ANGLES))
    n = sum(np.count_nonzero(load.size * (1.0 if load.is_torque else np.any(load.way, axis=0))) for load in acting)
    assert len([line for line in several.lines if line.layer == "LOADS" and line.habit == "arrow"]) == n


@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: kind.name)
def test_films_have_as_many_lines_at_every_angle(kind):
    machine = loaded(kind)
    place, loads = first_mechanism(machine)
    scene = scene_of(machine, (place,))
    frames = [mechanism_sketch(scene, angle, 2.0, is_plain=True) for angle in (0.0, 33.0, 180.0)]
    shapes = [[(line.layer, line.habit, line.order) for line in frame.lines] for frame in frames]
    assert shapes[0] == shapes[1] == shapes[2]
    seen = [line for line in frames[1].lines if line.layer == "LOADS" and np.all(np.isfinite(line.points))]
    acting = (*loads.at(np.array([33.0])), *loads.on_shafts_at(np.array([33.0])))
    assert len([line for line in seen if line.habit == "arrow"]) == sum(
        bool(load.size[0]) and (load.is_torque or bool(np.any(load.way))) for load in acting
    )


@pytest.mark.parametrize("running", ["ahead", "astern"])
@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: kind.name)
def test_polygons_and_levers_hold_every_load(kind, running):
    """Polygons close, each load in them by its name; the lever's balance is the machine's torque by the reactions."""
    machine = loaded(kind, running)
    result = ct.run(machine, quantities=("driving_torque", "load_torque_on_crank"))
    on_shafts = result.load_torque_on_crank[result[LoadWork].n_on_links :]  # a chain's crank may have a shaft's name
    whole = result.driving_torque + np.sum(on_shafts, axis=0)
    angles = (20, 105, 250)
    shown = {place.name: shown_loads(machine, [place]) for place in machine.places}
    drawn = {place.name: force_polygons(machine, angles, mechanism=place.name) for place in machine.places}
    for angle in angles:
        levers = [zhukovsky_lever(machine, angle, mechanism=place.name) for place in machine.places]
        balancing = -sum(force.moment for lever in levers for force in lever.forces)
        assert balancing == pytest.approx(whole[angle], abs=1e-10 * np.max(np.abs(whole)))
        assert max(lever.residual for lever in levers) < 1e-10
        for place in machine.places:
            loads = shown[place.name].at(np.array([float(angle)]))
            polygons = [polygon for polygon in drawn[place.name] if polygon.angle == angle]
            assert max(polygon.gap for polygon in polygons) < 1e-12
            sides = [(force.name, force.value) for polygon in polygons for force in polygon.forces]
            torques = [(torque.name, torque.value) for polygon in polygons for torque in polygon.torques]
            largest = max(force.size for polygon in polygons for force in polygon.forces)
            for load in loads:
                if load.is_torque:
                    assert (load.name, load.counted[0]) in torques
                elif np.hypot(*load.force[:, 0]) > 1e-8 * largest:
                    assert (load.name, tuple(load.force[:, 0])) in sides
            lever = next(one for one in levers if one.mechanism == place.name)
            symbols = [force.symbol for force in lever.forces if force.symbol[0] in "QM" and "Φ" not in force.symbol]
            assert len(symbols) == len(set(symbols))


@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: kind.name)
def test_pictures_with_loads_are_readable(kind):
    machine, mechanism = one_of_each(kind)
    result = ct.run(machine)
    names = [name.replace("_", " ") for name in machine.load]
    for draw in (plan_forces, plan_zhukovsky):
        assert_words_are_readable(draw(machine, [33.0], mechanism=mechanism, size="A3"))
    for figure in (
        sheet(result, piston=mechanism),
        sheet_loads(result),
        plan_positions(machine, 8, mechanism=mechanism),
        plan_velocities(machine, [33.0], mechanism=mechanism),
    ):
        assert_words_are_readable(figure)
        said = " ".join(text for text, _box in words_of(figure))
        assert all(name[:12] in said for name in names)


def test_dxf_has_a_layer_of_loads(tmp_path):
    ezdxf = pytest.importorskip("ezdxf")
    machine, mechanism = one_of_each(next(kind for kind in KINDS if kind.name == "crank_rocker"))
    dxf(machine, 6, tmp_path / "loads.dxf", mechanism=mechanism)
    drawing = ezdxf.readfile(tmp_path / "loads.dxf")
    heads = [one for one in drawing.modelspace() if one.dxf.layer == "LOADS" and one.closed]
    acting = shown_loads(machine, machine.places).at(np.arange(6) * 60.0)
    assert len(heads) == sum(np.count_nonzero(load.size) for load in acting)
