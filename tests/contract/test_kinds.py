"""What every kind of mechanism brings: a folder with its parts, a theory page, an example that runs, a true drawing."""

import itertools
import tomllib
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from tests.machines import scaled
from tests.virtual_work import torque_of_work

import cranktrain as ct
from cranktrain.io.description import counted_parts
from cranktrain.io.starting import starting_file
from cranktrain.linkage.forces import Body, Conditions, Drive, Friction, Gravity
from cranktrain.mechanisms import KINDS
from cranktrain.mechanisms.closing import closing_margin
from cranktrain.mechanisms.dynamics import FRAME
from cranktrain.mechanisms.kind import named_part
from cranktrain.mechanisms.output import PISTON, RAM, VALVE
from cranktrain.numerics.designs import by_design
from cranktrain.numerics.nested import leaves
from cranktrain.plans.placement import placed
from cranktrain.plans.polygons import acceleration_polygons, velocity_polygons
from cranktrain.questions.motion.outputs import InCylinders, outputs_of

ROOT = Path(__file__).parents[2]
FOLDER = ROOT / "src/cranktrain/mechanisms"
PHI = np.radians(np.arange(0, 360, 2.5))

every_kind = pytest.mark.parametrize("kind", KINDS, ids=lambda kind: kind.name)


def example(kind):
    return ct.Machine(**tomllib.loads(kind.example))


def place_of(kind, **changes):
    """A mechanism of that kind in its example."""
    machine = ct.Machine(**(tomllib.loads(kind.example) | changes))
    return next(place for place in machine.places if place.kind.name == kind.name)


def distances(drawing, pins):
    """Distance between each two of some pins."""
    return {
        (one, other): np.hypot(*(drawing.positions[one] - drawing.positions[other]))
        for one, other in itertools.combinations(pins, 2)
    }


def test_kinds_are_the_folders():
    folders = {path.name for path in FOLDER.iterdir() if (path / "__init__.py").exists()}
    assert {kind.name for kind in KINDS} == folders, (
        "a folder of mechanisms/ is a line in KINDS of its __init__.py, and its KIND has the folder's name"
    )
    assert len(KINDS) == len(folders), "a kind stands in KINDS once"
    assert all(KINDS.named(kind.name) is kind for kind in KINDS)


@every_kind
def test_folder_and_pages(kind):
    for part in ("README.md", "spec.py", "kinematics.py"):  # forces and drawing may be those of a chain
        assert (FOLDER / kind.name / part).is_file(), (
            f"write mechanisms/{kind.name}/{part}; CONTRIBUTING says what is in it"
        )
    page = kind.name.replace("_", "-")
    assert (ROOT / f"docs/theory/{page}.md").is_file(), (
        "write the theory first: symbols, numbered equations, validity, sources"
    )
    assert (ROOT / f"docs/mechanisms/{page}.md").is_file(), "write the page, which includes the folder's README"


@every_kind
def test_spec_names_its_kind(kind):
    assert kind.spec.model_fields["kind"].annotation.__args__ == (kind.name,), (
        "the spec's `kind` is a Literal of the folder's name"
    )


@every_kind
def test_example_runs(kind):
    result = ct.run(example(kind))
    assert kind.name in {place.kind.name for place in result.machines[0].places}, (
        "KIND.example is a machine file of this kind"
    )
    assert all(check.passed.all() for check in result.checks), "every check holds of KIND.example"
    assert result.summary()


@every_kind
def test_what_the_example_leaves_out_is_valid_too(kind):
    """Lines that begin with `# ` and hold a key or a table are part of the example, only commented out."""
    lines = [
        line.removeprefix("# ") if line.startswith(("# [", "# ")) and ("=" in line or "[" in line) else line
        for line in kind.example.splitlines()
    ]
    ct.run(ct.Machine(**tomllib.loads("\n".join(lines)))).find_all()


@every_kind
def test_links_that_carry_points_are_in_the_motion(kind):
    place = place_of(kind)
    kind = place.kind
    motion = kind.motion(PHI, place.geometry)
    for name in kind.links:
        link = kind.named(motion, name)
        np.testing.assert_allclose(link.cos**2 + link.sin**2, 1, atol=1e-14)
    assert (
        np.shape(getattr(motion, kind.output.part).value if kind.output.is_slider else motion.rocker.cos) == PHI.shape
    )


@every_kind
def test_gap_is_open_where_the_motion_is_nan(kind):
    """With every length in turn made much longer and shorter: closed and moving, or open and NaN."""
    place = place_of(kind)
    kind = place.kind
    for name, factor in itertools.product(kind.lengths, (0.3, 0.8, 1.3, 3.0)):
        changed = scaled(place.geometry, name, factor)
        with np.errstate(invalid="ignore", divide="ignore"):
            motion = kind.motion(PHI, changed)
            value = motion.slider.value if kind.output.is_slider else motion.rocker.angle.value
            gap = kind.gap(PHI, changed)
        clear = np.abs(gap) > 1e-12
        if "way" in place.geometry._fields and not np.any(np.isnan(value)):
            continue  # the pivot may have crossed the crank circle: another machine
        np.testing.assert_array_equal(np.isnan(value)[clear], (gap < 0)[clear], err_msg=name)


@every_kind
def test_margin_of_the_example_opens_its_links(kind):
    """The length that is named opens the links when changed by a little more than the margin, not by a little less."""
    place = place_of(kind)
    kind = place.kind
    found = closing_margin(kind, by_design([place.geometry], 1))
    if np.isnan(found.margin[0, 0, 0]):
        return  # it closes whatever its lengths are
    margin, name = found.margin[0, 0, 0], kind.lengths[found.length[0, 0, 0]]
    fine = np.radians(np.arange(0, 360, 0.05))

    def least_gap(change):
        with np.errstate(invalid="ignore"):
            return min(np.min(kind.gap(fine, scaled(place.geometry, name, 1 + sign * change))) for sign in (-1, 1))

    assert least_gap(margin * (1 + 1e-4)) < 0
    assert least_gap(margin * (1 - 1e-4)) > 0


@every_kind
@pytest.mark.parametrize("running", ["ahead", "astern"])
def test_drawn_links_have_the_lengths_of_the_geometry(kind, running):
    place = place_of(kind, running=running)
    kind = place.kind
    drawing = kind.drawing(PHI, place.geometry)
    found = [values for link in drawing.links for values in distances(drawing, link.pins).values()]
    found += distances(drawing, drawing.fixed).values()
    for values in found:
        np.testing.assert_allclose(values, values.flat[0], rtol=1e-13)
    drawn = [float(values.flat[0]) for values in found]
    for name in kind.lengths:
        if name.endswith(("length", "radius")):
            length = float(named_part(place.geometry, name))
            assert min(abs(value - length) for value in drawn) < 1e-13 * length, name


@every_kind
def test_guides_hold_their_pin_on_a_line(kind):
    """Across the guide's direction the pin stands still, at the offset; along it, it moves."""
    place = place_of(kind)
    geometry = place.geometry
    if "offset" in getattr(geometry, "_fields", ()):
        geometry = geometry._replace(offset=geometry.offset + 7e-3)
    drawing = place.kind.drawing(PHI, geometry)
    for guide in drawing.guides:
        x, y = drawing.positions[guide.pin]
        across = y * np.cos(guide.direction) - x * np.sin(guide.direction)
        np.testing.assert_allclose(across, across[0], atol=1e-15)
        if geometry is not place.geometry and guide is drawing.guides[0]:
            np.testing.assert_allclose(across, geometry.offset, atol=1e-15)
        assert np.ptp(x * np.cos(guide.direction) + y * np.sin(guide.direction)) > 1e-3


@every_kind
def test_drawing_names_pins_that_it_has(kind):
    place = place_of(kind)
    drawing = place.kind.drawing(PHI, place.geometry)
    named = {pin for link in drawing.links for pin in link.pins}
    named |= {guide.pin for guide in drawing.guides} | set(drawing.fixed) | set(drawing.paths)
    assert named <= set(drawing.pins), "drawing.pins lacks pins that links, guides, fixed and paths name"
    assert set(drawing.pins) <= named, (
        "these pins are drawn by nothing: name them in a link, a guide, fixed or paths, or leave them out"
    )
    for name in drawing.fixed:
        for part in drawing.positions[name]:
            assert np.ptp(part) == 0, name
    for name in drawing.paths:
        assert max(np.ptp(part) for part in drawing.positions[name]) > 0, name
    blocks = {pin for block in drawing.blocks for pin in (block.pin, *block.link)}
    assert blocks | set(drawing.ends) <= set(drawing.pins), "drawing.pins lacks pins that blocks and ends name"
    assert {block.pin for block in drawing.blocks}.isdisjoint(drawing.ends)
    known = set(drawing.fixed)
    for link in drawing.links:
        assert {link.pins[0]} & (known | {guide.pin for guide in drawing.guides} | set(drawing.ends)), link.name
        known |= set(link.pins)


@every_kind
def test_drawn_pins_have_the_derivatives_of_their_positions(kind):
    """Against central differences of the positions, of eighth order: coefficients of Fornberg (1988), table 1."""
    place = place_of(kind)
    step = 1e-2
    first, second = np.array([4 / 5, -1 / 5, 4 / 105, -1 / 280]), np.array([8 / 5, -1 / 5, 8 / 315, -1 / 560])

    def at(shift):
        return place.kind.drawing(PHI + shift, place.geometry).positions

    here, sides = at(0.0), [(at(k * step), at(-k * step)) for k in range(1, 5)]
    size = max(np.max(np.abs(values)) for values in here.values())
    for name, pin in place.kind.drawing(PHI, place.geometry).pins.items():
        velocity = sum(c * (ahead[name] - behind[name]) for c, (ahead, behind) in zip(first, sides, strict=True)) / step
        around = sum(c * (ahead[name] + behind[name]) for c, (ahead, behind) in zip(second, sides, strict=True))
        acceleration = (around - 205 / 72 * here[name]) / step**2
        for part, exact in ((0, velocity), (1, velocity)):
            found = np.broadcast_to(pin[part].first, PHI.shape)
            np.testing.assert_allclose(found, exact[part], rtol=0, atol=1e-9 * size, err_msg=name)
        for part in (0, 1):
            found = np.broadcast_to(pin[part].second, PHI.shape)
            np.testing.assert_allclose(found, acceleration[part], rtol=0, atol=1e-8 * size, err_msg=name)


@every_kind
def test_drawing_agrees_with_the_motion(kind):
    """The pin that slides or the rocker that swings is where the kernel has it."""
    place = place_of(kind)
    kind = place.kind
    drawing, motion = kind.drawing(PHI, place.geometry), kind.motion(PHI, place.geometry)
    positions = list(drawing.positions.values())
    if kind.output.is_slider:
        across = (value for values in distances(drawing, drawing.pins).values() for value in (values, -values))
        directions = [guide.direction for guide in drawing.guides] or [0.0]
        on_guides = (x * np.cos(one) + y * np.sin(one) for one in directions for x, y in positions)
        along = itertools.chain(on_guides, across)
        assert any(np.ptp(value - motion.slider.value) < 1e-14 for value in along)
    else:
        direction = motion.rocker.cos + 1j * motion.rocker.sin
        between = [(b[0] - a[0]) + 1j * (b[1] - a[1]) for a, b in itertools.permutations(positions, 2)]
        assert any(np.allclose(vector, np.abs(vector) * direction, atol=1e-14) for vector in between)


@every_kind
def test_drawing_of_many_mechanisms_at_once(kind):
    place = place_of(kind)
    kind = place.kind
    columns = by_design([place.geometry, place.geometry], 2)
    many, one = kind.drawing(PHI, columns), kind.drawing(PHI, place.geometry)
    for name, parts in many.positions.items():
        for part, single in zip(parts, one.positions[name], strict=True):
            np.testing.assert_allclose(np.broadcast_to(part, (2, 2, PHI.size))[1, 0], single, atol=1e-15)


@every_kind
def test_geometry_is_numbers(kind):
    assert all(isinstance(leaf, float) for leaf in leaves(place_of(kind).geometry))


@every_kind
@pytest.mark.parametrize("running", ["ahead", "astern"])
@pytest.mark.parametrize(("polygons_of", "order"), [(velocity_polygons, 1), (acceleration_polygons, 2)])
def test_lengths_of_plans_times_their_scale_are_the_pins_motion(kind, running, polygons_of, order):
    """From the pole to a point of the polygon, times μ, is the pin's own motion; every vector joins its two points."""
    table = tomllib.loads(kind.example)
    table.setdefault("shaft", {}).setdefault("main", {})["speed"] = "70 rad/s"
    machine = ct.Machine(**table, running=running)
    place = next(place for place in machine.places if place.kind.name == kind.name)
    angles = [17.0, 100.0, 201.0, 333.0]
    drawing = placed(machine, place, np.radians(angles) + machine.zero)
    for at, polygon in enumerate(polygons_of(machine, angles, mechanism=place.name)):
        points = {name: polygon.scale * np.array(point) for name, point in polygon.points.items()}
        longest = max(vector.size for vector in polygon.vectors)
        seen = set()
        for vector in polygon.vectors:
            between = points[vector.end] - points[vector.start]
            np.testing.assert_allclose(between, vector.value, rtol=0, atol=1e-12 * longest, err_msg=vector.symbol)
            if vector.part == "absolute" and not vector.pins[0].endswith("'"):
                pin = drawing.pins[vector.pins[0]]
                exact = 70.0**order * np.array([pin.x[order][at], pin.y[order][at]])
                np.testing.assert_allclose(vector.value, exact, rtol=0, atol=1e-13 * longest, err_msg=vector.symbol)
                seen.add(vector.pins[0])
        assert seen == set(drawing.pins) - set(drawing.fixed) - set(drawing.ends)


def dynamics_of(kind):
    """A mechanism of that kind with any bodies, loads of its output, and an accelerating crank under gravity."""
    place = place_of(kind)
    dynamics, random = place.kind.dynamics, np.random.default_rng(1)
    motion = place.kind.motion(PHI, place.geometry)
    bodies = [Body(*random.uniform([1, -0.1, -0.1, 0.01], [4, 0.1, 0.1, 0.1])) for _ in dynamics.moving]
    friction = tuple(Friction(0.0, 1.0) for _ in dynamics.sliding)
    conditions = Conditions(Drive(30.0, 200.0), Gravity(-4.0, -9.0), friction)
    loads = dynamics.load(motion, place.geometry, 250.0)
    return place, motion, tuple(bodies), loads, conditions


@every_kind
def test_moving_and_sliding_are_in_the_motion(kind):
    """But for cranks and blocks, which the motion has as pins."""
    place = place_of(kind)
    dynamics, motion = place.kind.dynamics, place.kind.motion(PHI, place.geometry)
    assert len(set(dynamics.moving)) == len(dynamics.moving), "name every link of DYNAMICS.moving once"
    sliding = {name for name in dynamics.sliding if name != "block" and not name.endswith(".slot")}
    assert {*place.kind.links, *sliding} <= set(dynamics.moving), (
        "what carries points or slides is named in DYNAMICS.moving"
    )
    for name in dynamics.sliding:
        assert np.shape(place.kind.named(motion, name).first) == PHI.shape


@every_kind
def test_groups_are_statically_determined(kind):
    """Three equations of a link, two unknowns of a joint: 3n = 2m; a chain's yoke and trammel have one block more."""
    place = place_of(kind)
    dynamics, motion = place.kind.dynamics, place.kind.motion(PHI, place.geometry)
    grouped = [name for group in dynamics.groups for name in group.links]
    assert len(set(grouped)) == len(grouped), "a link is of one group of DYNAMICS.groups"
    hanging = {reaction.on for reaction in dynamics.reactions if reaction.by != FRAME} & set(dynamics.moving)
    assert hanging <= set(grouped) <= set(dynamics.moving), (
        "what hangs on other links is of a group, and every group is of links in DYNAMICS.moving"
    )
    lengths = dict(zip(dynamics.moving, dynamics.links(motion, place.geometry), strict=True))
    for group in dynamics.groups:
        joints = [reaction.name for reaction in dynamics.reactions if reaction.on in group.links]
        block = len(group.links) == 1
        assert 3 * (len(group.links) + block) == 2 * (len(joints) + block), group
        for across in group.across:
            assert across.joint in joints and across.link in group.links and across.link in lengths


@every_kind
def test_contacts_are_where_links_slide(kind):
    """At the contact's pin one link moves past the other as fast as the coordinate of what slides changes."""
    place = place_of(kind)
    dynamics, motion = place.kind.dynamics, place.kind.motion(PHI, place.geometry)
    pins = place.kind.drawing(PHI, place.geometry).pins
    links = dict(zip(dynamics.moving, dynamics.links(motion, place.geometry), strict=True))
    joints = {joint.name: joint for joint in dynamics.reactions}

    def velocity(body, pin):
        if body == FRAME:
            return 0.0
        x, y = links[body].origin
        arm = (pin.x.value - x.value) + 1j * (pin.y.value - y.value)
        return x.first + 1j * y.first + 1j * links[body].angle.first * arm

    for name, contact in zip(dynamics.sliding, dynamics.contacts, strict=True):
        joint, pin = joints[contact.joint], pins[contact.pin]
        passing = np.abs(velocity(joint.on, pin) - velocity(joint.by, pin))
        np.testing.assert_allclose(passing, np.abs(place.kind.named(motion, name).first), rtol=0, atol=1e-12)


@every_kind
def test_joints_have_names_and_bodies(kind):
    place, motion, bodies, loads, conditions = dynamics_of(kind)
    dynamics = place.kind.dynamics
    joints = dynamics.forces(motion, place.geometry, bodies, loads, conditions).joints
    names = [joint.name for joint in dynamics.reactions]
    assert len(set(names)) == len(names) == len(joints), (
        "DYNAMICS.reactions names every joint that its forces give, once"
    )
    assert list(getattr(joints, "_fields", names)) == names, (
        "DYNAMICS.reactions come in the order in which its forces give the joints"
    )
    assert all(joint.on != joint.by for joint in dynamics.reactions)
    assert all(np.shape(part) == PHI.shape for wrench in joints for part in wrench)


@every_kind
def test_both_torques_agree(kind):
    place, motion, *others = dynamics_of(kind)
    dynamics = place.kind.dynamics
    forces = dynamics.forces(motion, place.geometry, *others)
    by_work = torque_of_work(dynamics, motion, place.geometry, *others, forces)
    np.testing.assert_allclose(forces.driving_torque, by_work, rtol=0, atol=1e-12 * np.max(np.abs(by_work)))


@every_kind
def test_load_works_along_the_output(kind):
    """Its torque on the crank is force by slider's derivative, or torque by link's; weights are off."""
    place, motion, bodies, loads, _ = dynamics_of(kind)
    found = place.kind.dynamics.reduced(motion, place.geometry, bodies, loads, Gravity(0.0, 0.0)).load
    output = motion.slider if place.kind.output.is_slider else motion.rocker.angle
    np.testing.assert_allclose(found, 250.0 * output.first, atol=1e-13 * 250.0 * np.max(np.abs(output.first)))


def test_a_kind_made_elsewhere_is_what_it_says():
    """A press's ram is no valve, and a new file of it has its speed; nobody has to know its name."""
    press = replace(KINDS.named("slider_crank"), name="press", output=RAM, speed="60 rpm", tables=None)
    machine = SimpleNamespace(places=[SimpleNamespace(kind=press)], main_shaft=SimpleNamespace(throws=("0 deg",)))
    assert counted_parts(machine) == ["1 ram", "1 throw"]
    text = starting_file(press, full=True)
    assert tomllib.loads(text)["shaft"]["main"]["speed"] == "60 rpm"
    pistons = SimpleNamespace(outputs=(PISTON, press.output, VALVE))
    assert outputs_of(pistons, None) == (RAM, RAM, VALVE)
    assert outputs_of(pistons, InCylinders()) == (PISTON, RAM, VALVE)
